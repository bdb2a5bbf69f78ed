"""Paths of a Panda's hand that others made (README.md beside this file): `load()` reads them, `robot()` is their arm."""

import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pinocchio as pin
from scipy.spatial.transform import Rotation

import manipplan as mp

HERE = Path(__file__).resolve().parent


@dataclass(frozen=True, kw_only=True, eq=False)
class ToolPath:
    """A path of the hand, with its name and the obstacles around it."""

    name: str
    path: mp.CartesianPath
    scene: mp.Scene


def robot() -> mp.Robot:
    """The Panda whose tool is its hand."""
    arm = mp.load_robot("panda")
    data = arm.model.createData()
    pin.framesForwardKinematics(arm.model, data, arm.neutral)
    tool, hand = (data.oMf[arm.model.getFrameId(name)] for name in (arm.tool, "panda_hand"))
    return arm.with_tool((tool.inverse() * hand).homogeneous, name="hand")


def load() -> list[ToolPath]:
    """The paths that are within reach of the arm."""
    cubes = json.loads((HERE / "tool_paths_cppflow.json").read_text())["panda__2cubes"]
    boxes = [mp.Box(**box, name=f"cube {k}") for k, box in enumerate(cubes["boxes"])]
    recorded = json.loads((HERE / "tool_path_iklink_panda.json").read_text())["poses_t_xyz_xyzw"]
    return [
        ToolPath(name="CppFlow, two cubes", path=_path(np.array(cubes["poses_xyz_xyzw"])), scene=mp.Scene(boxes)),
        ToolPath(name="IKLink", path=_path(np.array(recorded)[:, 1:]), scene=mp.Scene()),
    ]


def _path(rows: np.ndarray) -> mp.CartesianPath:
    """The smooth path through poses x y z qx qy qz qw."""
    poses = np.tile(np.eye(4), (len(rows), 1, 1))
    poses[:, :3, 3], poses[:, :3, :3] = rows[:, :3], Rotation.from_quat(rows[:, 3:]).as_matrix()
    return mp.CartesianPath.through(poses)
