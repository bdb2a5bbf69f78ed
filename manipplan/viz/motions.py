"""Data of a motion for the pictures: its joint path and initial path, shares of length, skeleton and tool path."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import pinocchio as pin
from numpy.typing import ArrayLike

from manipplan.kinematics.kinematics import Kinematics
from manipplan.paths.joint import JointPath
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.model_tree import frame_index
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError
from manipplan.support.status import RECORDED
from manipplan.symbolic.task import Task
from manipplan.tracking.track import Tracking

if TYPE_CHECKING:
    from manipplan.jobs.result import Plan

Motion = JointPath | Trajectory | Tracking


def joint_path(argument: str, motion: Motion, robot: Robot) -> JointPath:
    """The joint path of a motion of this robot; raises InvalidInputError that names `argument`."""
    if isinstance(motion, Tracking):
        motion = motion.trajectory()
    if isinstance(motion, Trajectory):
        motion = motion.path()
    if not isinstance(motion, JointPath) or motion.n != robot.n:
        raise InvalidInputError(argument, motion, f"a JointPath, Trajectory or Tracking of {robot.n} joints")
    return motion


def named_paths(plan: "Plan") -> dict[str, JointPath]:
    """A plan's path and its initial path, under the names that fit the plan's job; one entry if they are the same."""
    if plan.refinement is not None:
        ours, first = "refined", "best of the samples"
    elif plan.result.status in RECORDED:
        ours, first = "improved", "recorded"
    else:
        ours, first = "optimised", "seed"
    seed = plan.result.seed
    return {first: plan.path} if seed is plan.path else {ours: plan.path, first: seed}


def length_shares(path: JointPath, s: Array) -> Array:
    """The share (k,) of the path's length at increasing s (k,) from 0 to 1; s itself for a path of zero length."""
    speed = np.linalg.norm(path(s, 1), axis=1)
    gained = np.concatenate([[0.0], np.cumsum(np.diff(s) * (speed[1:] + speed[:-1]) / 2)])
    return np.asarray(gained / gained[-1]) if gained[-1] > 0 else s


def beside(trajectory: Trajectory, seed: JointPath) -> Callable[[ArrayLike], Array]:
    """`seed` at times [s] of a trajectory, at the same share of its length as the trajectory.

    The seed has no timing of its own.
    """
    s = np.linspace(0.0, 1.0, 2001)
    ours, theirs = length_shares(trajectory.path(), s), length_shares(seed, s)
    return lambda t: seed(np.interp(np.interp(np.asarray(t) / trajectory.duration, s, ours), theirs, s))


@dataclass(frozen=True, kw_only=True, eq=False)
class DrawnTool:
    """A tool with a way and ellipsoids: the kinematics of its arm, and the indices of the arm's joints."""

    kinematics: Kinematics
    joints: tuple[int, ...]

    def pose(self, q: Array) -> Array:
        """Its pose (..., 4, 4) at configurations (..., n) of the robot."""
        return self.kinematics.pose(q[..., self.joints])

    def jacobian(self, q: Array) -> Array:
        """The Jacobian (..., m, k) of its arm at configurations (..., n) of the robot."""
        return self.kinematics.jacobian(q[..., self.joints])


def drawn_tools(robot: Robot, task: Task | None = None) -> tuple[DrawnTool, ...]:
    """All tools of a robot, by default with the task whose ellipsoids are drawn: position; for a planar arm, in its plane."""
    task = task if task is not None else Task.planar() if robot.planar else Task.position()
    return tuple(DrawnTool(kinematics=robot.arm(tool).kinematics(task), joints=robot.joints_of(tool)) for tool in robot.tools)


def skeleton(robot: Robot, q: Array) -> Array:
    """Origins of base, joints and tool at q (n,), (k, 3) [m]; of several arms along each, and back between them."""
    data = robot.model.createData()
    pin.framesForwardKinematics(robot.model, data, q)
    line: list[Array] = []
    for tool in robot.tools:
        frame = frame_index(robot.model, tool)
        joints = [data.oMi[i].translation for i in robot.model.supports[robot.model.frames[frame].parentJoint]]
        line += [*line[::-1], *joints, data.oMf[frame].translation]
    return np.array(line)


def tool_ways(robot: Robot, path: JointPath, count: int = 160) -> list[Array]:
    """Positions (count, 3) of each tool along a path [m]."""
    q = path(np.linspace(0.0, 1.0, count))
    return [tool.pose(q)[:, :3, 3] for tool in drawn_tools(robot)]
