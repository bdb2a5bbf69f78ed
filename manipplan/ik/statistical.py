"""Solutions by Newton steps from random starts, until few are likely to be missing."""

from dataclasses import dataclass
from itertools import combinations, pairwise

import numpy as np
from numpy.typing import NDArray

from manipplan.ik.geometry import Screws
from manipplan.ik.newton import MovingArm
from manipplan.robots.limits import JointLimits
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.symbolic.task import Task

#: Number of random starts per round, and their maximum number in total.
ROUND = 64
MOST = 4096
#: Number of starts without a solution after which the pose counts as unreachable.
FRUITLESS = 512
#: Rounds continue until each solution was found this often on average and none only once.
SEEN = 8
STEPS = 80
#: Where nothing is found, starts that came this near [m, rad] get more steps: near a singularity, steps are short.
NEAR, MORE_STEPS = 1e-2, 500
TOLERANCE = 1e-12
#: Solutions that differ by less than this are the same [rad or m].
SAME = 1e-5


@dataclass(frozen=True, kw_only=True, eq=False)
class Sampled:
    """An arm with some joints held.

    Attributes:
        screws: the arm.
        held: indices of the joints that are held at `values` [rad or m].
        values: (h,) positions of the held joints.
        limits: limits of the arm.
    """

    screws: Screws
    held: tuple[int, ...]
    values: Array
    limits: JointLimits


def random_answers(setup: Sampled, target: Array, rng: np.random.Generator) -> tuple[Array, float]:
    """Configurations (k, n) that reach `target` (4, 4), and an estimate of the share that was not found.

    The estimate is the Good-Turing one [good1953]: the share of the hits whose solution was found only once.
    """
    limits, screws, held = setup.limits, setup.screws, list(setup.held)
    lower, upper = (
        np.where(np.isfinite(limit), limit, side * np.pi) for limit, side in ((limits.lower, -1), (limits.upper, 1))
    )
    if ((setup.values < limits.lower[held]) | (setup.values > limits.upper[held])).any():
        return np.zeros((0, screws.n)), 0.0
    moves = np.ones(screws.n, dtype=bool)
    moves[held] = False
    found, hits, starts = np.zeros((0, screws.n)), np.zeros(0), 0
    near = np.zeros((0, screws.n))

    arm = MovingArm(screws, moves)

    def advance(q: Array, steps: int) -> tuple[Array, Array]:
        return arm.search(q, target, limits.lower, limits.upper, steps=steps, tolerance=TOLERANCE)

    while starts < MOST:
        if len(found) or starts < FRUITLESS:
            q = rng.uniform(lower, upper, (ROUND, screws.n))
            q[:, held] = setup.values
            q, miss = advance(q, STEPS)
            starts += ROUND
            near = np.vstack([near, q[(miss > TOLERANCE) & (miss < NEAR)]])
        elif len(near):
            q, miss = advance(near[:ROUND], MORE_STEPS)
            near = near[:0]
        else:
            break
        for each in in_range(q[miss <= TOLERANCE], limits):
            same = np.flatnonzero(np.abs(found - each).max(axis=1) < SAME)
            if len(same):
                hits[same[0]] += 1
            else:
                found, hits = np.vstack([found, each]), np.append(hits, 1)
        if hits.sum() >= SEEN * max(len(found), 1) and not (hits == 1).any():
            break
    missing = float((hits == 1).sum() / hits.sum()) if len(found) else 1.0
    return found, missing


def merged(q: Array, source: NDArray[np.int64]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """The first of equal rows of q (k, n) with equal source (k,), ascending: their indices, and how often each was found."""
    kept, hits = [np.zeros(0, dtype=np.int64)], [np.zeros(0, dtype=np.int64)]
    edges = np.flatnonzero(np.diff(source, prepend=-1, append=-1))
    for begin, end in pairwise(edges.tolist()):
        some = q[begin:end]
        same = np.abs(some[:, None] - some).max(axis=2) < SAME
        first = np.flatnonzero(same.argmax(axis=1) == np.arange(len(some)))
        kept.append(begin + first)
        hits.append(same[first].sum(axis=1))
    return np.concatenate(kept), np.concatenate(hits)


def best_held(robot: Robot, count: int, task: Task) -> tuple[int, ...]:
    """The joints to hold: those without which the others move the tool best, on average over random postures."""
    if count == 0:
        return ()
    q = robot.random_configuration(np.random.default_rng(0), size=200)
    jacobians = robot.kinematics(task).jacobian(q)
    rank = robot.n - count

    def mean_volume(held: tuple[int, ...]) -> float:
        left = np.delete(jacobians, held, axis=2)
        return float(np.linalg.svd(left, compute_uv=False)[:, :rank].prod(axis=1).mean())

    return max(combinations(range(robot.n), count), key=mean_volume)


def in_range(q: Array, limits: JointLimits) -> Array:
    """q with joints without limits wrapped to [-π, π]."""
    return np.where(np.isinf(limits.lower), (q + np.pi) % (2 * np.pi) - np.pi, q)
