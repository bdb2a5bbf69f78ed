"""Data of a motion for the pictures: its joint path and initial path, shares of length, skeleton and tool path.

MovedPart: a part that a program takes up or puts down, with where it is over time.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import pinocchio as pin

from manipplan.collision.scene import Scene
from manipplan.kinematics.kinematics import Kinematics
from manipplan.paths.joint import JointPath
from manipplan.paths.trajectory import Trajectory
from manipplan.robots.attached import Solid
from manipplan.robots.model_tree import frame_index, frame_pose
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, ArrayLike
from manipplan.support.errors import InvalidInputError
from manipplan.support.status import RECORDED
from manipplan.symbolic.task import Task
from manipplan.tracking.track import Tracking

if TYPE_CHECKING:
    from manipplan.plans.result import Plan
    from manipplan.programs.program import Program

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


def name_paths(plan: "Plan") -> dict[str, JointPath]:
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


@dataclass(frozen=True, kw_only=True, eq=False)
class MovedPart:
    """A part that a program takes up or puts down.

    Attributes:
        name: of the part.
        times: when it is taken up or put down, from 0 on [s].
        held: for each of these times, whether the hand carries it from then on.
        solids: for each, the part posed in the frame of the hand or in the world; None while it is nowhere.
        frames: for each, the tool frame of the hand; "" while no hand carries it.
    """

    name: str
    times: tuple[float, ...]
    held: tuple[bool, ...]
    solids: tuple[Solid | None, ...]
    frames: tuple[str, ...]

    def at(self, t: float, robot: Robot, q: Array) -> Solid | None:
        """The part at time t [s], posed in the world, with the arm at q (n,); None where it is nowhere."""
        solid, frame = self.solids[self._since(t)], self.frames[self._since(t)]
        return solid.at(frame_pose(robot.model, frame, q)) if solid is not None and frame else solid

    def is_held(self, t: float) -> bool:
        """Whether the hand carries it at time t [s]."""
        return self.held[self._since(t)]

    def _since(self, t: float) -> int:
        return int(np.searchsorted(self.times, t, side="right")) - 1

    @property
    def solid(self) -> Solid:
        """The part, wherever it is first."""
        return next(each for each in self.solids if each is not None)


def find_moved_parts(program: "Program") -> tuple[MovedPart, ...]:
    """The parts that a program takes up or puts down, or carries at the start."""
    states = _states(program)
    names = dict.fromkeys(name for _, robot, _ in states for name in robot.carried)
    return tuple(_follow_part(name, states) for name in names)


def bare(robot: Robot) -> Robot:
    """The arm without what it carries."""
    for name in robot.carried:
        robot = robot.detach(name)
    return robot


def fixed(scene: Scene, moved: Sequence[MovedPart]) -> Scene:
    """The obstacles that stay where they are."""
    names = {each.name for each in moved}
    return Scene([each for each in scene.named if each.name not in names])


def _states(program: "Program") -> list[tuple[float, Robot, Scene]]:
    """Arm and scene, and since when they are so: parts change hands at the marks between two motions."""
    changes = [mark.begin for mark in program.marks if mark.name in ("Attach", "Detach")]
    states = [(0.0, program.robot, program.scene)]
    ends = [begin + part.trajectory.duration for part, begin in zip(program.parts, program.begins, strict=True)]
    later = [(begin, part.robot, part.scene) for part, begin in zip(program.parts, program.begins, strict=True)]
    for before, (begin, robot, scene) in zip(
        [0.0, *ends], [*later, (np.inf, program.final_robot, program.final_scene)], strict=True
    ):
        at = [each for each in changes if before - 1e-9 <= each <= begin + 1e-9]
        if at:
            states.append((min(at), robot, scene))
    return states


def _follow_part(name: str, states: Sequence[tuple[float, Robot, Scene]]) -> MovedPart:
    times, held, solids, frames = [], [], [], []
    for since, robot, scene in states:
        times.append(since)
        held.append(name in robot.carried)
        frames.append(robot.carried[name].frame if name in robot.carried else "")
        standing = next((each for each in scene.named if each.name == name), None)
        solids.append(robot.carried[name].solid if name in robot.carried else standing)
    return MovedPart(name=name, times=tuple(times), held=tuple(held), solids=tuple(solids), frames=tuple(frames))
