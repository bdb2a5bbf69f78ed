"""Values of the joints that move several tools, such as a torso, with which every tool can reach its pose."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from manipplan.jobs.goals.pose_goal import PoseGoal
from manipplan.jobs.goals.reach import BETTER, DAMPING, LENGTHS, WORSE, Missing, damped_step
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.symbolic.task import Task

#: Number of random starts, of steps from each, and of different values that are kept.
STARTS, STEPS, KEPT = 96, 60, 12
#: Size of the miss that counts as none [m], and largest difference of a shared joint below which two values are one [rad or m].
REACHED, SAME = 1e-6, 0.05


def shared_joints(robot: Robot) -> list[int]:
    """Indices of the joints that move several tools."""
    moved = np.zeros(robot.n, dtype=int)
    for tool in robot.tools:
        moved[list(robot.joints_of(tool))] += 1
    found: list[int] = np.flatnonzero(moved > 1).tolist()
    return found


def torsos(robot: Robot, goals: Mapping[str, PoseGoal], start: Array, held: NDArray[np.bool_]) -> Array:
    """Configurations (k, n) like `start` (n,) but for the shared joints: first that of the start, then others.

    The others are found by damped steps of all joints that are not held towards all poses, and are ordered by their distance
    from the start.
    """
    shared = np.isin(np.arange(robot.n), shared_joints(robot)) & ~held
    if not shared.any():
        return start[None]
    kept, found = [start], _reaching(robot, goals, start, held)
    for q in found[np.argsort(np.linalg.norm((found - start)[:, shared], axis=1), kind="stable")]:
        if len(kept) <= KEPT and all(np.abs((q - other)[shared]).max() > SAME for other in kept):
            kept.append(np.where(shared, q, start))
    return np.array(kept)


def _reaching(robot: Robot, goals: Mapping[str, PoseGoal], start: Array, held: NDArray[np.bool_]) -> Array:
    """Configurations (k, n) inside the limits that reach all poses, in collision or not."""
    random = robot.random_configuration(np.random.default_rng(0), size=STARTS)
    q = np.where(held, start, np.vstack([start, robot.neutral, random]))
    damping, rows = np.full(len(q), DAMPING), np.arange(len(q))
    miss, slope = _missing(robot, goals, q)
    for _ in range(STEPS):
        step = damped_step(slope[rows] * ~held, miss[rows], damping[rows])
        moved = np.clip(q[rows] + step, robot.limits.lower, robot.limits.upper)
        left, slopes = _missing(robot, goals, moved)
        good = (left**2).sum(axis=1) < (miss[rows] ** 2).sum(axis=1)
        q[rows[good]], miss[rows[good]], slope[rows[good]] = moved[good], left[good], slopes[good]
        damping[rows] = np.clip(np.where(good, BETTER, WORSE) * damping[rows], 1e-12, 1e6)
        rows = np.flatnonzero(np.linalg.norm(miss, axis=1) > REACHED / 10)
        if not len(rows):
            break
    return np.asarray(q[np.linalg.norm(miss, axis=1) <= REACHED])


def _missing(robot: Robot, goals: Mapping[str, PoseGoal], q: Array) -> tuple[Array, Array]:
    """What q (k, n) miss of all goals (k, 6 t), and the change of what counts of it with each joint (k, 6 t, n)."""
    misses, slopes = [], []
    for tool, goal in goals.items():
        joints = list(robot.joints_of(tool))
        kinematics = robot.arm(tool).kinematics(Task.pose(length=1.0), threads=1)
        own = np.ascontiguousarray(q[:, joints])
        miss, counting = Missing.of(kinematics, [goal])(np.zeros(len(q), dtype=np.intp), own)
        slope = np.zeros((len(q), 6, robot.n))
        slope[:, :, joints] = counting @ (kinematics.jacobian(own) * LENGTHS[:, None])
        misses.append(miss)
        slopes.append(slope)
    return np.concatenate(misses, axis=1), np.concatenate(slopes, axis=1)
