"""Barrier method for limited jerk: it descends from a motion within all limits to a locally fastest one.

Newton steps minimise weight · time - Σ log of the slacks. Each step linearises the jerk limits again (the successive
linearisation of Verscheure and of TOPP3, within one interior-point method). This is repeated with larger weights.
"""

import numpy as np

from manipplan.support.checks import Array
from manipplan.timing.jerk import UNLIMITED, JerkProblem, Rows, Slacks, SquaredSpeed

#: Maximum number of linear programs in the search for a motion within the limits when speeds are given at the ends.
SEARCHES = 12


def motion_inside(problem: JerkProblem, guess: Array | None) -> Array | None:
    """Free coefficients of a motion within the limits; None when none is found.

    From stop to stop the guess is slowed down, since a slower motion always exceeds limits by less. Between given speeds
    linear programs search for the motion.
    """
    points = problem.demands.at[problem.inner]
    knots = np.concatenate([[points[0]], points, [points[-1]]])
    greville = (knots[:-1] + knots[1:]) / 2
    shape = (
        np.interp(greville, problem.demands.at, guess) if guess is not None else (greville * (1 - greville) + 1e-12) ** (4 / 3)
    )
    z = np.maximum(shape[1:-1], 1e-9 * shape.max())
    start, end = problem.fixed
    if not (start or end):
        for _ in range(400):
            if problem.slacks(problem.coefficients(z)) is not None:
                return np.asarray(0.95 * z)
            z = 0.8 * z
        return None
    nearest: Array | None = np.maximum(z / z.max() * max(start, end), np.interp(greville[1:-1], [0, 1], [start, end]) * 0.999)
    for _ in range(SEARCHES):
        if nearest is None or problem.slacks(problem.coefficients(nearest)) is not None:
            return nearest
        nearest = _nearer(problem, nearest)
    return None


def _nearer(problem: JerkProblem, z: Array) -> Array | None:
    """Coefficients with the smallest relative excess over limits, jerk limits linearised at z; None when the solver fails."""
    from scipy.optimize import linprog
    from scipy.sparse import csr_array, diags_array, hstack, vstack

    c = problem.coefficients(z)
    count, pace = len(c), problem.pace(c)

    def matrix(rows: Rows) -> csr_array:
        shape = (len(rows[0]), count)
        return csr_array(diags_array(list(rows), offsets=list(range(len(rows))), shape=shape))

    parts: list[tuple[csr_array, Array, Array]] = []  # matrix · c <= right + excess · limit
    finite = problem.fastest < UNLIMITED
    parts.append((matrix(problem.a_rows)[finite], problem.fastest[finite], problem.fastest[finite]))
    limited = problem.most_c < UNLIMITED / 4
    parts.append((matrix((np.ones(count),))[limited], problem.most_c[limited], problem.most_c[limited]))
    for left, right, constant in zip(*(each.T for each in problem.demand_rows), problem.constant.T, strict=True):
        for sign in (1.0, -1.0):
            parts.append((sign * matrix((left, right)), 1.0 - sign * constant, np.ones(count - 1)))
    grows = matrix(tuple(pace.first * row for row in pace.sum_rows))
    for *change, jerk in zip(*(each.T for each in problem.change_rows), problem.jerk.T, strict=True):
        for sign in (1.0, -1.0):
            rows = sign * matrix(tuple(change)) - diags_array([jerk], offsets=[0]) @ grows
            parts.append((csr_array(rows), jerk * (pace.step - grows @ c), jerk * pace.step))
    b = matrix(problem.b_rows)
    for k, most in enumerate(problem.most_b):
        if np.isfinite(most):
            parts.append((b[:1] if k == 0 else -b[-1:], np.array([most]), np.array([most])))
    equal = np.zeros((2, count + 1))
    for row, (end, beside) in enumerate(((0, 1), (count - 1, count - 2))):
        equal[row, end], equal[row, beside] = 1.0, -problem.tied[row]
    limits = np.concatenate([part[2] for part in parts])
    every = hstack([vstack([part[0] for part in parts]), -csr_array(limits[:, None])], format="csr")
    scale = 1 / np.maximum(np.abs(every).max(axis=1).toarray().ravel(), 1e-300)
    answer = linprog(
        np.append(np.zeros(count), 1.0),
        A_ub=csr_array(diags_array([scale], offsets=[0]) @ every),
        b_ub=scale * np.concatenate([part[1] for part in parts]),
        A_eq=equal,
        b_eq=np.array(problem.fixed),
        bounds=np.column_stack([np.append(0.1 * c, -0.05), np.full(count + 1, np.inf)]),
        method="highs-ipm",
    )
    if answer.x is None or not np.isfinite(answer.x).all():
        return None
    return np.asarray(np.maximum(answer.x[1:-2], 1e-12 * c.max()), dtype=float)


#: Maximum share by which the motion is slower than the local optimum on its grid.
GAP = 1e-3
#: Factor by which the weight of time grows per round.
HEAVIER = 8.0
#: Maximum number of Newton steps per round.
STEPS = 40
#: A round ends when a step lowers the merit function by less than this.
CENTRED = 1e-2
#: A step must lower the merit function by this share of what its Newton decrement predicts.
SUFFICIENT = 1e-2


def fastest_motion(problem: JerkProblem, guess: Array | None = None) -> SquaredSpeed | None:
    """The fastest motion found; None when none within the limits is found. `guess`: a at the grid points."""
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
    """Minimise the merit function from z inside the limits."""
    value = _merit(problem, z, weight)
    for _ in range(STEPS):
        step, decrement = problem.model(_inside(problem, z), weight).newton_step()
        if not np.isfinite(decrement) or decrement < CENTRED:
            break
        size = 1.0
        while (after := _merit(problem, z + size * step, weight)) > value - SUFFICIENT * size * decrement:
            size /= 2
            if size <= 1e-9:
                return z
        z, gained, value = z + size * step, value - after, after
        if gained < CENTRED:
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
