"""Tool paths that others made (see README.md): `load()` reads them, `robot()` and `fetch_like()` are their arms."""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pinocchio as pin
from scipy.spatial.transform import Rotation

import manipplan as mp

HERE = Path(__file__).resolve().parent


@dataclass(frozen=True, kw_only=True, eq=False)
class ToolPath:
    """A path of a tool, with its name, the arm, the frame of its description that is the tool, and the obstacles around it."""

    name: str
    robot: mp.Robot
    frame: str
    path: mp.CartesianPath
    scene: mp.Scene


def robot() -> mp.Robot:
    """The Panda whose tool is its hand."""
    arm = mp.load_robot("panda")
    data = arm.model.createData()
    pin.framesForwardKinematics(arm.model, data, arm.neutral)
    tool, hand = (data.oMf[arm.model.getFrameId(name)] for name in (arm.tool, "panda_hand"))
    return arm.with_tool((tool.inverse() * hand).homogeneous, name="hand")


def fetch_like(*, torso: bool = False) -> mp.Robot:
    """The arm of Fetch's geometry: seven joints, eight with the torso."""
    joints = json.loads((HERE / "fetch_like_paths.json").read_text())["fetch_arm__circle"]["joints"]
    return mp.load_robot(HERE / "fetch_like.urdf", tool="gripper", joints=None if torso else joints)


def load() -> list[ToolPath]:
    """The paths that are within reach of the arms."""
    hand, paths = robot(), list[ToolPath]()
    for name, problem in json.loads((HERE / "tool_paths_cppflow.json").read_text()).items():
        if name != "panda__square":  # beyond the limits of our Panda's fifth joint
            paths.append(_tool_path(f"CppFlow, {name}", hand, "panda_hand", problem))
    recorded = json.loads((HERE / "tool_path_iklink_panda.json").read_text())["poses_t_xyz_xyzw"]
    path = _path(np.array(recorded)[:, 1:])
    paths.append(ToolPath(name="IKLink", robot=hand, frame="panda_hand", path=path, scene=mp.Scene()))
    for torso, more in ((False, ""), (True, ", with the torso")):
        arm = fetch_like(torso=torso)
        for name, problem in json.loads((HERE / "fetch_like_paths.json").read_text()).items():
            paths.append(_tool_path(f"like {name}{more}", arm, "gripper", problem))
    return paths


def _tool_path(name: str, robot: mp.Robot, frame: str, problem: dict[str, Any]) -> ToolPath:
    boxes = [mp.Box(**box, name=f"box {k}") for k, box in enumerate(problem["boxes"])]
    path = _path(np.array(problem["poses_xyz_xyzw"]))
    return ToolPath(name=name, robot=robot, frame=frame, path=path, scene=mp.Scene(boxes))


def _path(rows: np.ndarray) -> mp.CartesianPath:
    """The smooth path through poses x y z qx qy qz qw."""
    poses = np.tile(np.eye(4), (len(rows), 1, 1))
    poses[:, :3, 3], poses[:, :3, :3] = rows[:, :3], Rotation.from_quat(rows[:, 3:]).as_matrix()
    return mp.CartesianPath.through(poses)
