"""The barrier method for limited jerk: from a motion within all limits to the fastest one it leads to.

Newton steps on weight · time - Σ log of the slacks, whose jerk limits are linearised anew at each (the successive
linearisation of Verscheure and of TOPP3, within one interior-point method); then again with a larger weight.
"""

import numpy as np

from manipplan.support.checks import Array
from manipplan.timing.inside import motion_inside
from manipplan.timing.jerk import JerkProblem, Slacks, SquaredSpeed

#: The motion is at most this share slower than the local optimum on its grid.
GAP = 1e-3
#: How many times heavier time counts from one round to the next.
HEAVIER = 8.0
#: Newton steps a round.
STEPS = 40
#: A round ends when a step gains less than this of the merit, as a step must of what its decrement promises.
ENOUGH = 1e-2


def fastest_motion(problem: JerkProblem, guess: Array | None = None) -> SquaredSpeed | None:
    """The fastest motion found; None where none is within the limits. `guess`: a at the grid points."""
    z = motion_inside(problem, guess)
    if z is None:
        return None
    weight = problem.count / problem.time(_inside(problem, z).pace) * (10.0 if guess is not None else 1.0)
    while True:
        z = _centred(problem, z, weight)
        if problem.count / weight < GAP * problem.time(_inside(problem, z).pace):
            return problem.motion(z)
        weight *= HEAVIER


def _centred(problem: JerkProblem, z: Array, weight: float) -> Array:
    """The least of the merit, from z inside the limits."""
    value = _merit(problem, z, weight)
    for _ in range(STEPS):
        step, decrement = problem.model(_inside(problem, z), weight).newton_step()
        if not np.isfinite(decrement) or decrement < ENOUGH:
            break
        size = 1.0
        while (after := _merit(problem, z + size * step, weight)) > value - ENOUGH * size * decrement:
            size /= 2
            if size <= 1e-9:
                return z
        z, gained, value = z + size * step, value - after, after
        if gained < ENOUGH:
            break
    return z


def _merit(problem: JerkProblem, z: Array, weight: float) -> float:
    """weight · time - Σ log of the slacks; inf outside the limits."""
    found = problem.slacks(problem.coefficients(z))
    if found is None:
        return np.inf
    logs = sum(float(np.log(part[np.isfinite(part)]).sum()) for part in found.every)
    return weight * problem.time(found.pace) - logs


def _inside(problem: JerkProblem, z: Array) -> Slacks:
    found = problem.slacks(problem.coefficients(z))
    assert found is not None
    return found
