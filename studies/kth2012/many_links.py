"""Arms with more than three links: their optimal postures, and one path per arm."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

import manipplan as mp
from manipplan.planar import (
    PlanarArm,
    manipulability,
    squared_manipulability,
    squared_manipulability_gradient,
    stationary_postures,
)
from studies.kth2012 import config

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True, eq=False)
class ManyLinks:
    """An arm of n unit links: its best posture q (n,) with μ, whether it is proven to be the best, and an optimal path."""

    arm: PlanarArm
    q: Array
    manipulability: float
    proven: bool
    path: mp.results.PathResult


def many_links(n: int) -> ManyLinks:
    """Posture and path of n unit links; the ends of the path continue the pattern of (6.12)."""
    arm = PlanarArm(np.ones(n))
    q = best_posture(arm)
    bends = np.array([config.SECOND.start[1:], config.SECOND.goal[1:]])
    start, goal = (np.concatenate([[0.0 if k == 0 else config.SECOND.goal[0]], np.resize(bends[k], n - 1)]) for k in (0, 1))
    path = mp.optimize_path(
        arm.robot(),
        start,
        goal,
        shape=mp.PathShape(degree=config.BEST_DEGREE),
        objective=mp.PathObjective(power=config.TABLE_POWER, floor=0.0),
    )
    return ManyLinks(arm=arm, q=q, manipulability=float(manipulability(arm, q)), proven=n <= config.PROVEN_LINKS, path=path)


def best_posture(arm: PlanarArm) -> Array:
    """The posture (n,) with the largest μ that bends to the left, of all stationary ones or of those found by random starts."""
    q = stationary_postures(arm).best.q[0] if arm.n <= config.PROVEN_LINKS else _best_of_starts(arm)
    return q * float(np.sign(q[np.abs(q).argmax()]))


def _best_of_starts(arm: PlanarArm) -> Array:
    """The posture (n,) with the largest μ from random starts."""

    def cost(bent: Array) -> tuple[float, Array]:
        q = np.concatenate([[0.0], bent])
        return -float(squared_manipulability(arm, q)), -squared_manipulability_gradient(arm, q)[1:]

    rng = np.random.default_rng(0)
    found = [
        minimize(cost, rng.uniform(-np.pi, np.pi, arm.n - 1), jac=True, method="BFGS", options={"gtol": 1e-9})
        for _ in range(config.POSTURE_STARTS)
    ]
    best = min(found, key=lambda each: each.fun)
    return np.concatenate([[0.0], np.pi - np.mod(np.pi - best.x, 2 * np.pi)])
