"""Values of the joints that move several tools, such as a torso, with which every tool can reach its goal."""

from collections.abc import Mapping
from itertools import product

import numpy as np
from numpy.typing import NDArray

from manipplan.ik.descend import descend
from manipplan.jobs.goals.own_arm import OfTool, own_arms
from manipplan.jobs.goals.pose_goal import PoseGoal
from manipplan.jobs.goals.reach import PoseResidual
from manipplan.robots.arms import shared_joints
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.symbolic.task import Task

#: Number of values of all shared joints together, and at least of each.
GRID, FEWEST = 25, 3
#: The same for two joints and more.
GRID_OF_SEVERAL = 121
#: Number of random starts of damped steps, of values of the grid beside them, and of starts at each of these.
RANDOM, NEAREST, STARTS = 96, 16, 6
#: Size of the miss that counts as none [m], and difference of shared joints, as a share of their range, of equal values.
REACHED, SAME = 1e-9, 0.005


def torso_grid(robot: Robot, start: Array, held: NDArray[np.bool_]) -> Array:
    """Configurations (k, n) like start (n,) but for the shared joints, which are first as there, then on a grid."""
    free = [i for i in shared_joints(robot) if not held[i]]
    if not free:
        return start[None]
    count = GRID if len(free) == 1 else max(FEWEST, round(GRID_OF_SEVERAL ** (1 / len(free))))
    lower, width = _ranges(robot, free)
    values = np.array(list(product(np.linspace(0.0, 1.0, count), repeat=len(free))))
    places = np.tile(start, (1 + len(values), 1))
    places[1:, free] = np.clip(lower + values * width, robot.limits.lower[free], robot.limits.upper[free])
    return places


def meeting(
    robot: Robot,
    goals: Mapping[str, PoseGoal],
    places: Array,
    found: Mapping[str, OfTool],
    start: Array,
    held: NDArray[np.bool_],
) -> Array:
    """Configurations (k, n) that reach all goals, by damped steps; no two have the same values of shared joints.

    The steps begin at random, and where the places (p, n) with which each tool has solutions are nearest to each other. They
    are sorted by the distance of their shared joints from start (n,).
    """
    shared = shared_joints(robot)
    random = robot.random_configuration(np.random.default_rng(0), size=RANDOM)
    begins = np.vstack([start, robot.neutral, random, *_between(robot, places, found)])
    q = _reaching(robot, goals, np.where(held, start, begins), held)
    _, width = _ranges(robot, shared)
    kept: list[Array] = []
    for each in q[np.argsort(np.linalg.norm((q - start)[:, shared] / width, axis=1), kind="stable")]:
        if all((np.abs((each - other)[shared]) > SAME * width).any() for other in kept):
            kept.append(each)
    return np.array(kept).reshape(-1, robot.n)


def _between(robot: Robot, places: Array, found: Mapping[str, OfTool]) -> list[Array]:
    """Starts (n,) at the places that are nearest to those with which the tools have solutions, each tool at such a solution."""
    shared = shared_joints(robot)
    _, width = _ranges(robot, shared)
    values = places[:, shared] / width
    solved = {tool: each for tool, each in found.items() if len(each.q)}
    apart, nearest = np.zeros(len(places)), {}
    for tool, each in solved.items():
        own = np.unique(each.place)
        distances = np.linalg.norm(values[:, None] - values[own], axis=2)
        nearest[tool] = own[distances.argmin(axis=1)]
        apart += distances.min(axis=1)
    starts, rng = [], np.random.default_rng(1)
    for k in np.argsort(apart, kind="stable")[: NEAREST if solved else 0]:
        for _ in range(STARTS):
            q = places[k].copy()
            for tool, each in solved.items():
                joints, rows = list(own_arms(robot)[tool].joints), each.at(nearest[tool][k]).q
                q[joints] = rows[rng.integers(len(rows))][joints]
            starts.append(q)
    return starts


def _reaching(robot: Robot, goals: Mapping[str, PoseGoal], q: Array, held: NDArray[np.bool_]) -> Array:
    """Those of the configurations q (k, n) that reach all goals after damped steps, in collision or not."""
    parts = []
    for tool, goal in goals.items():
        kinematics = robot.arm(tool).kinematics(Task.pose(length=1.0), threads=1)
        parts.append((list(robot.joints_of(tool)), PoseResidual.of(kinematics, [goal])))

    def missing(rows: NDArray[np.intp], q: Array) -> tuple[Array, Array]:
        miss, slopes = np.empty((len(rows), 6 * len(parts))), np.zeros((len(rows), 6 * len(parts), robot.n))
        for k, (joints, of_tool) in enumerate(parts):
            own = slice(6 * k, 6 * k + 6)
            miss[:, own], slopes[:, own, joints] = of_tool.slopes(np.zeros_like(rows), np.ascontiguousarray(q[:, joints]))
        return miss, slopes

    q, miss = descend(robot.limits, missing, q, held)
    return np.asarray(q[np.linalg.norm(miss, axis=1) <= REACHED])


def _ranges(robot: Robot, joints: list[int]) -> tuple[Array, Array]:
    """The smallest value of some joints and the width of their ranges (k,): a full turn of those without limits."""
    lower, upper = robot.limits.lower[joints], robot.limits.upper[joints]
    limited = np.isfinite(lower) & np.isfinite(upper)
    return np.where(limited, lower, -np.pi), np.where(limited, np.maximum(upper - lower, 1e-9), 2 * np.pi)
