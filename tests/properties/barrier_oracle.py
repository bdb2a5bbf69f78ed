"""The barrier method of timing with jerk limits in NumPy: what the compiled steps are compared with.

A sum of functions of neighbouring unknowns has a Hessian of five diagonals.
"""

from dataclasses import dataclass

import numpy as np

from manipplan.support.checks import Array
from manipplan.timing.jerk import (
    CENTRED,
    FIRST,
    GAP,
    HEAVIER,
    ROUGH,
    STEPS,
    SUFFICIENT,
    JerkProblem,
    Rows,
    SpeedTerms,
    applied,
)


@dataclass(frozen=True, kw_only=True, eq=False)
class Slacks:
    """Distances to all limits: of a, and of c between grid points; of each demand row to 1 and to -1; of the rise and the
    fall of each acceleration over an interval; of b at the first and the last point; and c itself, which is positive.
    `pace` holds the speed terms of c.
    """

    fastest: Array
    between: Array
    above: Array
    below: Array
    rise: Array
    fall: Array
    ends: Array
    c: Array
    pace: SpeedTerms

    @property
    def every(self) -> tuple[Array, ...]:
        """All slacks; inf where there is no limit."""
        return self.fastest, self.between, self.above, self.below, self.rise, self.fall, self.ends, self.c


def time_of(problem: JerkProblem, pace: SpeedTerms) -> float:
    """Duration in the units of the demands."""
    total = pace.step.sum()
    for k, size in problem._stops():
        total += 3 * size / pace.root[k]
    return float(total)


def slacks_of(problem: JerkProblem, c: Array) -> Slacks | None:
    """The slacks of all limits; None when a limit is exceeded."""
    if not (c > 0).all():  # c > 0 means a > 0 everywhere, also between grid points
        return None
    pace = problem.pace(c)
    demand = applied(problem.demand_rows, c) + problem.constant
    room = problem.jerk * pace.step[:, None]
    change = np.diff(applied(problem.qdd_rows, c), axis=0)
    found = Slacks(
        fastest=problem.fastest - applied(problem.a_rows, c),
        between=problem.most_c - c,
        above=1.0 - demand,
        below=1.0 + demand,
        rise=room - change,
        fall=room + change,
        ends=np.array([problem.most_b[0] - problem.d[0] * (c[1] - c[0]), problem.most_b[1] + problem.d[-1] * (c[-1] - c[-2])]),
        c=c,
        pace=pace,
    )
    return found if all((part > 0).all() for part in found.every) else None


class NumpyCentring:
    """As `barrier.Centring`."""

    def __init__(self, problem: JerkProblem) -> None:
        self._problem = problem

    def entered(self, z: Array, factor: float, most: int) -> Array | None:
        z = z.copy()
        for _ in range(most):
            if slacks_of(self._problem, self._problem.coefficients(z)) is not None:
                return z
            z *= factor
        return None

    def descended(self, z: Array) -> Array:
        return _by_numpy(self._problem, z.copy())


class BandedModel:
    """Gradient and banded Hessian in the unknowns c (count,), summed term by term."""

    def __init__(self, count: int) -> None:
        self.gradient = np.zeros(count)
        #: diagonals of the symmetric matrix, the main one first: [d, i] is entry (i, i + d)
        self.hessian = np.zeros((3, count))

    def add(self, rows: Rows, slope: Array, bend: Array, *, at: int = 0) -> None:
        """Add a function of each row, given its first and second derivatives; the first row begins at c[at]."""
        count = len(rows[0])
        for m, row in enumerate(rows):
            self.gradient[at + m : at + m + count] += _product(slope, row)
            for j in range(m + 1):
                self.hessian[m - j, at + j : at + j + count] += _product(bend * row, rows[j])

    def barrier(self, slope: Rows, slack: Array, *, at: int = 0) -> None:
        """Add -log of linearised slacks, whose derivatives are the rows `slope`. An infinite slack adds nothing."""
        self.add(slope, -1 / slack, 1 / slack**2, at=at)

    def tie_ends(self, first: float, last: float) -> None:
        """Eliminate the outermost unknowns, which change `first` and `last` times as much as their neighbours."""
        g, H = self.gradient, self.hessian
        g[1] += first * g[0]
        H[0, 1] += 2 * first * H[1, 0] + first**2 * H[0, 0]
        H[1, 1] += first * H[2, 0]
        g[-2] += last * g[-1]
        H[0, -2] += 2 * last * H[1, -2] + last**2 * H[0, -1]
        H[1, -3] += last * H[2, -3]
        self.gradient, self.hessian = g[1:-1], H[:, 1:-1]

    def newton_step(self) -> tuple[Array, float]:
        """The step to the minimum of the model, and the Newton decrement: twice the predicted decrease."""
        from scipy.linalg import solveh_banded

        size = len(self.gradient)
        scale = 1 / np.sqrt(self.hessian[0])
        banded = np.zeros((min(3, size), size))
        banded[0] = 1.0 + 1e-14  # scaled to a unit diagonal, and kept positive definite
        for d in range(1, len(banded)):
            banded[d, :-d] = self.hessian[d, :-d] * (scale[:-d] * scale[d:])
        step = -scale * solveh_banded(banded, scale * self.gradient, lower=True, check_finite=False)
        return step, float(-self.gradient @ step)


def _product(left: Array, right: Array) -> Array:
    """left · right, summed over the rows per place."""
    return left * right if left.ndim == 1 else np.asarray(np.einsum("kr,kr->k", left, right))


def model_of(problem: JerkProblem, slacks: Slacks, weight: float) -> BandedModel:
    """Quadratic model of weight · time - Σ log of the slacks in the free coefficients, with linearised jerk limits."""
    c, pace = slacks.c, slacks.pace
    second = 2 * pace.step / (pace.root[:-1] + pace.root[1:]) ** 2
    model = BandedModel(len(c))
    # time: steps as functions of u, ∂²√a/∂a² = -1 / 4 a^(3/2) at both points, and 3 l / √a at stops; then the slacks
    model.add(pace.sum_rows, weight * pace.first, weight * second)
    slope, bend = 1 / slacks.fastest, 1 / slacks.fastest**2
    bend[:-1] -= weight * pace.first / (4 * pace.root[:-1] ** 3)
    bend[1:] -= weight * pace.first / (4 * pace.root[1:] ** 3)
    for k, size in problem._stops():
        slope[k] -= weight * 1.5 * size / pace.root[k] ** 3
        bend[k] += weight * 2.25 * size / pace.root[k] ** 5
    model.add(problem.a_rows, slope, bend)
    model.barrier((np.ones(len(c)),), c)
    model.barrier((-np.ones(len(c)),), slacks.between)
    above, below = 1 / slacks.above, 1 / slacks.below
    model.add(problem.demand_rows, above - below, above**2 + below**2)
    gains = [problem.jerk * (pace.first * row)[:, None] for row in pace.sum_rows]
    both = tuple(np.hstack([gain - row, gain + row]) for gain, row in zip(gains, problem.change_rows, strict=True))
    model.barrier(both, np.hstack([slacks.rise, slacks.fall]))
    model.barrier(tuple(-row[:1] for row in problem.b_rows), slacks.ends[:1])
    model.barrier(tuple(row[-1:] for row in problem.b_rows), slacks.ends[1:], at=len(c) - 2)
    model.tie_ends(*problem.tied)
    return model


def _by_numpy(problem: JerkProblem, z: Array) -> Array:
    """The same without compiled code."""
    time = time_of(problem, _inside(problem, z).pace)
    weight = FIRST * problem.count / time
    while True:
        last = problem.count / weight < GAP * time
        z = _centre(problem, z, weight, CENTRED if last else ROUGH)
        time = time_of(problem, _inside(problem, z).pace)
        if last and problem.count / weight < GAP * time:
            return z
        weight *= HEAVIER


def _centre(problem: JerkProblem, z: Array, weight: float, enough: float) -> Array:
    """Minimise the merit function from z inside the limits, until a step gains less than `enough`."""
    value = _merit(problem, z, weight)
    for _ in range(STEPS):
        step, decrement = model_of(problem, _inside(problem, z), weight).newton_step()
        if not np.isfinite(decrement) or decrement < enough:
            break
        size = 1.0
        while (after := _merit(problem, z + size * step, weight)) > value - SUFFICIENT * size * decrement:
            size /= 2
            if size <= 1e-9:
                return z
        z, gained, value = z + size * step, value - after, after
        if gained < enough:
            break
    return z


def _merit(problem: JerkProblem, z: Array, weight: float) -> float:
    """weight · time - Σ log of the slacks; inf outside the limits."""
    found = slacks_of(problem, problem.coefficients(z))
    if found is None:
        return np.inf
    logs = sum(float(np.log(part[np.isfinite(part)]).sum()) for part in found.every)
    return weight * time_of(problem, found.pace) - logs


def _inside(problem: JerkProblem, z: Array) -> Slacks:
    found = slacks_of(problem, problem.coefficients(z))
    if found is None:
        raise ValueError("z is not inside the limits")
    return found
