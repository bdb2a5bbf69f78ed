"""What the pictures read off a motion: its joint path, places by share of length, skeleton and way of the tool."""

import numpy as np
import pinocchio as pin

from manipplan.checks import Array
from manipplan.errors import InvalidInputError
from manipplan.paths.joint import JointPath
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.description import frame_index
from manipplan.robots.robot import Robot
from manipplan.tracking.track import Tracking

Motion = JointPath | Trajectory | Tracking


def joint_path(argument: str, motion: Motion, robot: Robot) -> JointPath:
    """The curve of a motion of this robot in joint space; raises InvalidInputError that names `argument`."""
    if isinstance(motion, Tracking):
        motion = motion.trajectory()
    if isinstance(motion, Trajectory):
        motion = motion.path()
    if not isinstance(motion, JointPath) or motion.n != robot.n:
        raise InvalidInputError(argument, motion, f"a JointPath, Trajectory or Tracking of {robot.n} joints")
    return motion


def length_shares(path: JointPath, s: Array) -> Array:
    """The share (k,) of the path's length at rising s (k,) from 0 to 1; s itself where it has none."""
    speed = np.linalg.norm(path(s, 1), axis=1)
    gained = np.concatenate([[0.0], np.cumsum(np.diff(s) * (speed[1:] + speed[:-1]) / 2)])
    return np.asarray(gained / gained[-1]) if gained[-1] > 0 else s


def skeleton(robot: Robot, q: Array) -> Array:
    """Origins of base, joints and tool at q (n,), (n + 2, 3) [m]."""
    data = robot.model.createData()
    pin.framesForwardKinematics(robot.model, data, q)
    origins = [data.oMi[i].translation for i in range(robot.model.njoints)]
    return np.array([*origins, data.oMf[frame_index(robot.model, robot.tool)].translation])


def tool_way(robot: Robot, path: JointPath, count: int = 160) -> Array:
    """Positions (count, 3) of the tool along a path [m]."""
    return robot.kinematics().pose(path(np.linspace(0.0, 1.0, count)))[:, :3, 3]
