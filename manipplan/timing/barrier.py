"""Barrier method for limited jerk: it descends from a motion within all limits to a locally fastest one.

Newton steps minimise weight · time - Σ log of the slacks. Each step linearises the jerk limits again (the successive
linearisation of Verscheure and of TOPP3, within one interior-point method). This is repeated with larger weights. The compiled
`barrier.c` does these steps.
"""

import ctypes
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np

from manipplan.support.checks import Array
from manipplan.support.kernels import load_kernel, struct
from manipplan.timing.jerk import UNLIMITED, JerkProblem, Rows, SquaredSpeed

#: Maximum number of linear programs in the search for a motion within the limits when speeds are given at the ends.
SEARCHES = 12
#: Maximum share by which the motion is slower than the local optimum on its grid.
GAP = 1e-3
#: First weight of time as a multiple of the number of slacks over the time, and the factor by which it grows per round.
FIRST, HEAVIER = 10.0, 512**0.5
#: Maximum number of Newton steps per round.
STEPS = 40
#: A round ends when a step lowers the merit function by less than this: all rounds but the last, and the last one.
ROUGH, CENTRED = 1.0, 1e-2
#: A step must lower the merit function by this share of what its Newton decrement predicts.
SUFFICIENT = 1e-2

#: What stands beyond the last grid point.
BEYOND = {"h": 1.0, "d": 0.0, "w": 0.5, "fastest": np.inf, "most_c": np.inf}

#: The compiled steps.


def fastest_motion(problem: JerkProblem, guess: Array | None = None) -> SquaredSpeed | None:
    """The fastest motion found; None when none within the limits is found. `guess`: a at the grid points."""
    centring = Centring(problem)
    z = motion_inside(problem, guess, centring)
    return None if z is None else problem.motion(centring.descended(z))


def motion_inside(problem: JerkProblem, guess: Array | None, centring: "Centring | None" = None) -> Array | None:
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
        entered = (centring or Centring(problem)).entered(z, 0.8, 400)
        return None if entered is None else 0.95 * entered
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


@cache
def _calls() -> dict[str, Callable[..., Any]]:
    return load_kernel("barrier").functions()


class Centring:
    """Newton's method on the merit function of one problem."""

    def __init__(self, problem: JerkProblem) -> None:
        self._problem = problem
        self._functions = _calls()
        stride = 8 * (len(problem.fastest) // 8 + 1)
        rows = {"left": problem.demand_rows[0], "right": problem.demand_rows[1], "constant": problem.constant}
        rows |= {"before": problem.qdd_rows[0], "after": problem.qdd_rows[1], "jerk": problem.jerk}
        lines = {name: getattr(problem, name) for name in ("h", "d", "fastest", "most_c")} | {"w": problem.a_rows[0]}
        self._arrays = {name: _fill(each.T, stride, 0.0) for name, each in rows.items()}
        self._arrays |= {name: _fill(each[None], stride, BEYOND[name]) for name, each in lines.items()}
        self._motion = struct("barrier", "Motion")(
            points=len(problem.fastest),
            rows=problem.constant.shape[1],
            limited=problem.jerk.shape[1],
            stride=stride,
            **{name: each.ctypes.data for name, each in self._arrays.items()},
            **{name: (ctypes.c_double * 2)(*getattr(problem, name)) for name in ("fixed", "tied", "outer", "most_b")},
        )

    def entered(self, z: Array, factor: float, most: int) -> Array | None:
        """Free coefficients z multiplied by `factor` until they are inside the limits; None when `most` times are too few."""
        z = z.copy()
        times = self._functions["enter"](ctypes.addressof(self._motion), z.ctypes.data, factor, most)
        return z if _done(times) else None

    def descended(self, z: Array) -> Array:
        """The fastest motion near z, which is inside the limits; both are free coefficients."""
        z, count = z.copy(), self._problem.count
        rounds = {"begin": FIRST, "heavier": HEAVIER, "gap": GAP, "rough": ROUGH, "centred": CENTRED, "sufficient": SUFFICIENT}
        how = struct("barrier", "Descent")(count=count, steps=STEPS, **rounds)
        if not _done(self._functions["descend"](ctypes.addressof(self._motion), ctypes.addressof(how), z.ctypes.data)):
            raise ValueError("z is not inside the limits")
        return z


def _fill(rows: Array, stride: int, beyond: float) -> Array:
    """Rows (r, k) one after the other, each filled up to `stride`, and eight more numbers."""
    out = np.full(rows.shape[0] * stride + 8, beyond)
    out[: rows.shape[0] * stride].reshape(-1, stride)[:, : rows.shape[1]] = rows
    return out


def _done(answer: int) -> bool:
    """Whether compiled code found what was asked; MemoryError where it had no memory."""
    if answer < -1:
        raise MemoryError("timing with jerk limits")
    return answer >= 0
