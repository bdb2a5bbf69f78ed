"""Solutions by Newton steps from random starts, until few are likely to be missing."""

from dataclasses import dataclass
from itertools import combinations, pairwise

import numpy as np
from numpy.typing import NDArray

from manipplan.ik.bridge import in_turn, within_reach
from manipplan.ik.geometry import Screws
from manipplan.ik.newton import MovingArm, Starts
from manipplan.robots.robot import Robot
from manipplan.support.checks import COINCIDENT, Array
from manipplan.support.deadline import NEVER, Deadline
from manipplan.symbolic.task import Task

#: Number of random starts per round, and their maximum number in total.
ROUND = 64
MOST = 4096
#: Number of starts without a solution after which the pose counts as unreachable.
FRUITLESS = 512
#: Rounds continue until each solution was found SEEN times on average and none less than OFTEN times.
SEEN, OFTEN = 16, 3
#: Number of steps of each start, and of further ones where these came so near [m, rad].
FIRST, PROMISING, STEPS = 20, 0.2, 60
#: Where nothing is found, starts that came this near [m, rad] get more steps: near a singularity, steps are short.
NEAR, MORE_STEPS = 1e-2, 500
#: Error at which a pose is reached [m, rad]. Beyond FAR [m] from the world's origin, where rounding is larger, it grows with
#: the distance.
TOLERANCE, FAR = 1e-12, 1e3
#: The same where nothing reaches a pose any nearer: a limit or the reach of the arm may end just before a rounded pose.
REACHED = COINCIDENT / 3
#: Solutions that differ by less than this are the same [rad or m].
ALIKE = 1e-5


@dataclass(frozen=True, kw_only=True, eq=False)
class ArmWithHeldJoints:
    """An arm with some joints held.

    Attributes:
        robot, screws: the arm.
        held: indices of the joints that are held at `values` [rad or m].
        values: (h,) positions of the held joints.
    """

    robot: Robot
    screws: Screws
    held: tuple[int, ...]
    values: Array


def random_answers(
    setup: ArmWithHeldJoints, target: Array, places: Starts, rng: np.random.Generator, deadline: Deadline = NEVER
) -> tuple[Array, float]:
    """Configurations (k, n) that reach `target` (4, 4), and an estimate of the share that was not found until the deadline.

    The steps begin at random configurations of `places`. The estimate is the Good-Turing one [good1953]: the share of the hits
    whose solution was found only once.
    """
    limits, screws, held = setup.robot.limits, setup.screws, list(setup.held)
    if ((setup.values < limits.lower[held]) | (setup.values > limits.upper[held])).any():
        return np.zeros((0, screws.n)), 0.0
    tolerance = TOLERANCE * max(1.0, float(np.abs(target[:3, 3]).max()) / FAR)
    moves = np.ones(screws.n, dtype=bool)
    moves[held] = False
    found, hits, starts = np.zeros((0, screws.n)), np.zeros(0), 0
    near = np.zeros((0, screws.n))

    arm = MovingArm(screws, moves)

    def advance(q: Array, steps: int) -> tuple[Array, Array]:
        return arm.search(q, target, limits.lower, limits.upper, steps=steps, tolerance=tolerance)

    while starts < MOST:
        within = tolerance
        if len(found) or starts < FRUITLESS:
            q = places.random(rng, ROUND)
            q[:, held] = setup.values
            q, miss = advance(q, FIRST)
            further = (miss > tolerance) & (miss < PROMISING)
            q[further], miss[further] = advance(q[further], STEPS)
            starts += ROUND
            near = np.vstack([near, q[(miss > tolerance) & (miss < NEAR)]])
        elif len(near):
            q, miss = advance(near[:ROUND], MORE_STEPS)
            near, within = near[:0], max(tolerance, REACHED)
        else:
            break
        for each in in_turn(setup.robot, q[miss <= within]):
            same = np.flatnonzero(np.abs(found - each).max(axis=1) < ALIKE)
            if len(same):
                hits[same[0]] += 1
            else:
                found, hits = np.vstack([found, each]), np.append(hits, 1)
        if (hits.sum() >= SEEN * max(len(found), 1) and not (hits < OFTEN).any()) or deadline.passed:
            break
    missing = float((hits == 1).sum() / hits.sum()) if len(found) else 1.0
    return found, missing


def merged(q: Array, source: NDArray[np.int64]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """The first of equal rows of q (k, n) with equal source (k,), ascending: their indices, and how often each was found."""
    firsts, hits = [np.zeros(0, dtype=np.int64)], [np.zeros(0, dtype=np.int64)]
    edges = np.flatnonzero(np.diff(source, prepend=-1, append=-1))
    for begin, end in pairwise(edges.tolist()):
        some = q[begin:end]
        same = np.abs(some[:, None] - some).max(axis=2) < ALIKE
        first = np.flatnonzero(same.argmax(axis=1) == np.arange(len(some)))
        firsts.append(begin + first)
        hits.append(same[first].sum(axis=1))
    return np.concatenate(firsts), np.concatenate(hits)


def best_held(robot: Robot, count: int, task: Task) -> tuple[int, ...]:
    """The joints to hold: those without which the others move the tool best, on average over random postures."""
    if count == 0:
        return ()
    q = np.random.default_rng(0).uniform(*within_reach(robot), (200, robot.n))
    jacobians = robot.kinematics(task).jacobian(q)
    rank = robot.n - count

    def mean_volume(held: tuple[int, ...]) -> float:
        left = np.delete(jacobians, held, axis=2)
        return float(np.linalg.svd(left, compute_uv=False)[:, :rank].prod(axis=1).mean())

    return max(combinations(range(robot.n), count), key=mean_volume)
