"""How far a pose is out of reach: the nearest configurations to it inside the limits."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from manipplan.ik.descend import descend
from manipplan.ik.nearest import Nearest, descend_to_best, stopped_at
from manipplan.ik.starts import random_near
from manipplan.jobs.goals.pose_goal import PoseGoal
from manipplan.kinematics.kinematics import Kinematics
from manipplan.robots.arms import tool_reach
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.symbolic.task import Task

#: Smallest and largest number of starts per pose, and of all; the same for poses that none of these reaches.
STARTS, ALL_STARTS = (8, 24), 600
MORE_STARTS, ALL_MORE = (24, 384), 1200
#: Weight of an angle against a distance [m/rad].
RADIAN = 1.0
#: Weights of the six rows of a Jacobian [m or m/rad].
LENGTHS = np.array([1.0] * 3 + [RADIAN] * 3)
#: Size of the miss that counts as none [m].
REACHED = 1e-9
#: Configurations are the same when no joint differs by more than this [rad or m].
SAME = 1e-3


@dataclass(frozen=True, kw_only=True, eq=False)
class NearestToGoal(Nearest):
    """The configuration found that comes nearest to a goal: `position` and `rotation` are beyond its tolerance.

    Attributes:
        reaching: (k, n) different configurations found that reach the goal; (0, n) where none does.
    """

    reaching: Array

    @property
    def missed(self) -> str:
        """How far it is away, and what stops it."""
        joints = f"with {' and '.join(self.stopped)} at a limit" if self.stopped else "with no joint at a limit"
        return f"the nearest configuration found leaves the tool {self.away}, {joints}"

    def __str__(self) -> str:
        return f"out of reach: {self.missed}"


def nearest(
    robot: Robot, goals: Sequence[PoseGoal], near: Array, held: NDArray[np.bool_], *, thorough: bool = True
) -> list[NearestToGoal]:
    """The nearest configuration found to each goal, by damped steps inside the limits from `near` (n,) and random starts.

    The held joints (n,) keep their values of `near`. If `thorough`, more starts follow for goals that are not reached.
    """
    if not goals:
        return []
    kinematics = robot.kinematics(Task.pose(length=1.0), threads=1)
    count = int(np.clip(ALL_STARTS // len(goals), *STARTS))
    starts = [[near, robot.neutral, *random_near(robot, goal.matrix, np.random.default_rng(0), count - 2)] for goal in goals]
    q, owners = np.where(held, near, np.concatenate(starts)), np.repeat(np.arange(len(goals)), count)
    missing = PoseResidual.of(kinematics, goals)
    q, miss = descend(robot.limits, lambda rows, q: missing.slopes(owners[rows], q), q, held)
    size = np.linalg.norm(miss, axis=1)
    reached = [_different(q[(owners == k) & (size <= REACHED)]) for k in range(len(goals))]
    far = [k for k, each in enumerate(reached) if not len(each)]
    found = []
    for k, goal in enumerate(goals):
        best = q[owners == k][size[owners == k].argmin()]
        if k in far and thorough:
            more = random_near(robot, goal.matrix, np.random.default_rng(1), int(np.clip(ALL_MORE // len(far), *MORE_STARTS)))
            begins = np.where(held, near, np.vstack([q[owners == k], more]))
            best, left = descend_to_best(robot.limits, _to_goal(missing, k), begins, held)
            reached[k] = best[None][: int(np.linalg.norm(left) <= REACHED)]
        position, rotation = (float(each[0]) for each in goal.distances(kinematics.pose(best[None])))
        found.append(
            NearestToGoal(
                q=best,
                position=max(position - goal.allowed[0], 0.0),
                rotation=max(rotation - goal.allowed[1], 0.0),
                reaching=reached[k],
                stopped=stopped_at(robot, best),
            )
        )
    return found


def _to_goal(missing: "PoseResidual", goal: int) -> Callable[[NDArray[np.intp], Array], tuple[Array, Array]]:
    """What configurations miss of one goal, for `descend`."""
    return lambda rows, q: missing.slopes(np.full(len(rows), goal), q)


def beyond_links(robot: Robot, tool: str, goal: PoseGoal) -> str:
    """Why no configuration brings a tool to its goal: its place is beyond the length of all links; "" where it is not."""
    place, length = tool_reach(robot, tool)
    length += goal.allowed[0]
    away = float(np.linalg.norm(goal.matrix[:3, 3] - place))
    if away <= length:
        return ""
    first = robot.joint_names[robot.joints_of(tool)[0]]
    return f"out of reach: {away:.3g} m from {first}, and the links up to the tool are {length:.3g} m long"


@dataclass(frozen=True, kw_only=True, eq=False)
class PoseResidual:
    """What is missing to the tolerances of g goals.

    Attributes:
        kinematics: of the arm.
        targets: (g, 4, 4) poses.
        axes: (g, 3) free axes; zero where none is free.
        allowed: (g, 2) tolerances [m, rad].
    """

    kinematics: Kinematics
    targets: Array
    axes: Array
    allowed: Array

    @classmethod
    def of(cls, kinematics: Kinematics, goals: Sequence[PoseGoal]) -> "PoseResidual":
        return cls(
            kinematics=kinematics,
            targets=np.array([each.matrix for each in goals]),
            axes=np.array([np.zeros(3) if each.axis is None else each.axis for each in goals]),
            allowed=np.array([each.allowed for each in goals]),
        )

    def __call__(self, owners: NDArray[np.intp], q: Array) -> tuple[Array, Array]:
        """What q (k, n) miss of their goals (k,), and the part of a motion of the tool that counts.

        Distances, and angles times RADIAN, in the world's axes (k, 6); and projections (k, 6, 6) of such motions: no rotation
        about a free axis, and nothing inside a tolerance.
        """
        from scipy.spatial.transform import Rotation

        poses, targets, axes = self.kinematics.pose(q), self.targets[owners], self.axes[owners]
        turns = Rotation.from_matrix(targets[:, :3, :3] @ np.swapaxes(poses[:, :3, :3], 1, 2)).as_rotvec()
        have, want = (np.einsum("kij,kj->ki", each[:, :3, :3], axes) for each in (poses, targets))
        across = np.cross(have, want)
        sine = np.linalg.norm(across, axis=1)
        leans = across / np.maximum(sine, 1e-12)[:, None] * np.arctan2(sine, (have * want).sum(axis=1))[:, None]
        free = (np.abs(axes).max(axis=1) > 0)[:, None]
        counting = np.zeros((len(q), 6, 6))
        position, counting[:, :3, :3] = _beyond(targets[:, :3, 3] - poses[:, :3, 3], self.allowed[owners, 0])
        rotation, counting[:, 3:, 3:] = _beyond(np.where(free, leans, turns), self.allowed[owners, 1])
        counting[:, 3:, 3:] -= counting[:, 3:, 3:] @ (have[:, :, None] * have[:, None])  # have is zero where no axis is free
        return np.hstack([position, RADIAN * rotation]), counting

    def slopes(self, owners: NDArray[np.intp], q: Array) -> tuple[Array, Array]:
        """What q (k, n) miss of their goals (k,), (k, 6), and its change with the joints (k, 6, n)."""
        miss, counting = self(owners, q)
        return miss, counting @ (self.kinematics.jacobian(q) * LENGTHS[:, None])


def _different(q: Array) -> Array:
    """Configurations (k, n) without those that are nearly the same as one before."""
    kept: list[Array] = []
    for each in q:
        if all(np.abs(each - other).max() > SAME for other in kept):
            kept.append(each)
    return np.array(kept).reshape(-1, q.shape[1])


def _beyond(vectors: Array, most: Array) -> tuple[Array, Array]:
    """Vectors (k, 3) shortened by lengths (k,), and projections (k, 3, 3) on the motions that change their length."""
    length = np.linalg.norm(vectors, axis=1)
    unit = vectors / np.maximum(length, 1e-300)[:, None]
    along = unit[:, :, None] * unit[:, None] * (length > most)[:, None, None]
    shortened = vectors * np.maximum(1 - most / np.maximum(length, 1e-300), 0.0)[:, None]
    return np.asarray(shortened), np.where((most > 0)[:, None, None], along, np.eye(3))
