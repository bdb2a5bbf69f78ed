"""Start-goal problems that others made (README.md beside this file): `load("panda")` reads them, `robot("panda")` is their arm.

The data hold a gripper that grasps an object, which our arms do not have or hold otherwise:

- Panda: the fingers stand at 65 mm in the data, beyond their limit of 40 mm. `robot` holds them there, as the data have them.
- UR5: the data have a Robotiq gripper. `robot` is the bare arm, so its hand is smaller than in the data. The base stands on a
  pedestal in the data; `load` moves the obstacles into the frame of the base instead.
"""

import gzip
import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

import manipplan as mp

HERE = Path(__file__).resolve().parent
#: Joints that `robot` holds, and where [m].
LOCKED = {"panda": {"panda_finger_joint1": 0.065, "panda_finger_joint2": 0.065}, "ur5": {}}
#: The base of the arm in the frame of the data: position [m] and turn about z [rad].
BASE = {"panda": ((0.0, 0.0, 0.0), 0.0), "ur5": ((0.0, 0.0, 0.9144), 1.57)}


@dataclass(frozen=True, kw_only=True, eq=False)
class Problem:
    """One problem: the set it belongs to, its number there, start and goal (n,) [rad], and the obstacles."""

    set: str
    number: int
    start: NDArray[np.float64]
    goal: NDArray[np.float64]
    scene: mp.Scene


def robot(arm: str) -> mp.Robot:
    """The arm of the problems, "panda" or "ur5"."""
    return mp.load_robot(arm, locked=LOCKED[arm])


def load(arm: str) -> list[Problem]:
    """All problems for an arm, "panda" or "ur5", set by set in the order of their numbers."""
    position, turn = BASE[arm]
    base = Rotation.from_rotvec([0.0, 0.0, turn])
    with gzip.open(HERE / f"motionbenchmaker_{arm}_odd.json.gz", "rt") as file:
        sets = json.load(file)
    return [
        Problem(
            set=name,
            number=int(number),
            start=np.array(entry["start"]),
            goal=np.array(entry["goal"]),
            scene=mp.Scene([_obstacle(each, np.array(position), base) for each in entry["obstacles"]]),
        )
        for name, problems in sets.items()
        for number, entry in problems.items()
    ]


def _obstacle(entry: dict, position: NDArray[np.float64], base: Rotation) -> mp.Obstacle:
    """The obstacle of an entry in the frame of the arm's base."""
    pose = {
        "name": entry["name"],
        "position": base.inv().apply(np.array(entry["position"]) - position),
        "rotation": (base.inv() * Rotation.from_quat(entry["quaternion_xyzw"])).as_matrix(),
    }
    if entry["type"] == "box":
        return mp.Box(size=entry["size"], **pose)
    if entry["type"] == "cylinder":
        return mp.Cylinder(radius=entry["radius"], length=entry["length"], **pose)
    raise ValueError(f"obstacle {entry['name']}: type {entry['type']!r}, allowed: box or cylinder")
