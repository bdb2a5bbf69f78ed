"""How far a pose is out of reach: the nearest configurations to it inside the limits."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from manipplan.jobs.goals.pose_goal import PoseGoal
from manipplan.kinematics.kinematics import Kinematics
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.symbolic.task import Task

#: Number of starts per pose, and of steps from each.
STARTS, STEPS = 24, 60
#: Weight of an angle against a distance [m/rad].
RADIAN = 0.1
#: First damping of a step, its factors after a good and a bad step, and the largest change of a joint in one step [rad or m].
DAMPING, BETTER, WORSE, LONGEST = 1e-2, 1 / 3, 4.0, 0.5
#: Distance from a limit up to which a joint counts as being at it [rad or m].
AT_LIMIT = 1e-6
#: Distances below this count as reached [m, rad].
REACHED = 1e-9


@dataclass(frozen=True, kw_only=True, eq=False)
class Nearest:
    """The configuration found that comes nearest to a pose.

    Attributes:
        q: (n,) inside the limits.
        position, rotation: distance [m] and angle [rad] beyond the tolerance of the goal.
        stopped: names of the joints that are at a limit there.
    """

    q: Array
    position: float
    rotation: float
    stopped: tuple[str, ...]

    @property
    def reached(self) -> bool:
        """Whether the pose is reached after all."""
        return self.position <= REACHED and self.rotation <= REACHED

    def __str__(self) -> str:
        joints = f"with {' and '.join(self.stopped)} at a limit" if self.stopped else "with no joint at a limit"
        return (
            f"out of reach: the nearest configuration found leaves the tool {1e3 * self.position:.3g} mm and "
            f"{np.rad2deg(self.rotation):.2g}° away, {joints}"
        )


def nearest(robot: Robot, goals: Sequence[PoseGoal], near: Array) -> list[Nearest]:
    """The nearest configuration found to each goal, by damped steps inside the limits from `near` (n,) and random starts."""
    kinematics = robot.kinematics(Task.pose(length=1.0), threads=1)
    starts = np.vstack([near, robot.neutral, robot.random_configuration(np.random.default_rng(0), size=STARTS - 2)])
    q, owners = np.tile(starts, (len(goals), 1)), np.repeat(np.arange(len(goals)), STARTS)
    miss = _miss(kinematics, goals, owners, q)
    damping = np.full(len(q), DAMPING)
    for _ in range(STEPS):
        jacobian = kinematics.jacobian(q) * np.array([1.0] * 3 + [RADIAN] * 3)[:, None]
        step = _step(jacobian, miss, damping)
        stuck = ((q <= robot.limits.lower) & (step < 0)) | ((q >= robot.limits.upper) & (step > 0))
        step = _step(jacobian * ~stuck[:, None, :], miss, damping)
        moved = np.clip(q + step, robot.limits.lower, robot.limits.upper)
        left = _miss(kinematics, goals, owners, moved)
        good = (left**2).sum(axis=1) < (miss**2).sum(axis=1)
        q, miss = np.where(good[:, None], moved, q), np.where(good[:, None], left, miss)
        damping = np.clip(np.where(good, BETTER, WORSE) * damping, 1e-12, 1e6)
    found = []
    for k, goal in enumerate(goals):
        rows = np.flatnonzero(owners == k)
        best = q[rows[(miss[rows] ** 2).sum(axis=1).argmin()]]
        position, rotation = (float(each[0]) for each in goal.distances(kinematics.pose(best[None])))
        limited = np.minimum(best - robot.limits.lower, robot.limits.upper - best) <= AT_LIMIT
        found.append(
            Nearest(
                q=best,
                position=max(position - goal.allowed[0], 0.0),
                rotation=max(rotation - goal.allowed[1], 0.0),
                stopped=tuple(name for name, is_at in zip(robot.joint_names, limited, strict=True) if is_at),
            )
        )
    return found


def _miss(kinematics: Kinematics, goals: Sequence[PoseGoal], owners: NDArray[np.intp], q: Array) -> Array:
    """What is missing to the tolerance of each row's goal (k, 6): distances, and angles times RADIAN, in the world's axes."""
    from scipy.spatial.transform import Rotation

    poses = kinematics.pose(q)
    missing = np.empty((len(q), 6))
    for k, goal in enumerate(goals):
        rows = owners == k
        missing[rows, :3] = _beyond(goal.matrix[:3, 3] - poses[rows, :3, 3], goal.allowed[0])
        turned = poses[rows, :3, :3]
        if goal.axis is None:
            turn = Rotation.from_matrix(goal.matrix[:3, :3] @ np.swapaxes(turned, 1, 2)).as_rotvec()
        else:
            have, want = turned @ goal.axis, goal.matrix[:3, :3] @ goal.axis
            across = np.cross(have, want)
            sine = np.linalg.norm(across, axis=1)
            turn = across / np.maximum(sine, 1e-12)[:, None] * np.arctan2(sine, have @ want)[:, None]
        missing[rows, 3:] = RADIAN * _beyond(turn, goal.allowed[1])
    return missing


def _beyond(vectors: Array, most: float) -> Array:
    """Vectors (k, 3) shortened by `most`."""
    length = np.linalg.norm(vectors, axis=1, keepdims=True)
    return np.asarray(vectors * np.maximum(1 - most / np.maximum(length, 1e-300), 0.0))


def _step(jacobian: Array, miss: Array, damping: Array) -> Array:
    """Damped steps (k, n) of the joints that reduce the miss (k, 6)."""
    turned = np.swapaxes(jacobian, 1, 2)
    solved = np.linalg.solve(jacobian @ turned + damping[:, None, None] * np.eye(6), miss[:, :, None])
    return np.asarray(np.clip((turned @ solved)[:, :, 0], -LONGEST, LONGEST))
