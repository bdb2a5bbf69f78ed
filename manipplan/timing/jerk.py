"""The fastest speed along a piece of path when jerk is limited too: unknowns, limits, and the barrier method for them.

The unknown is a(l) = (dl/dt)², a quadratic spline with coefficients c; b = d²l/dt² = a'/2 is then continuous and piecewise
linear. With unit tangent t and curvature κ, acceleration t b + κ a at grid points is linear in c, and the jerk limit on
the interval between two of them,

    |Δ(t b + κ a)| <= J h,    h = 2 Δl / (√a_k + √a_k+1),

has a right side that is convex in a. Its linearisation is conservative, so a Newton step that keeps the linearised limits
leads from one motion within all limits to a faster one. At a stop a piece begins with constant jerk j, l = j t³/6, so
a = 1.5 l b at the first grid point.

Rows are linear functions of up to three neighbouring unknowns, y_i = Σ_m rows[m][i] c_i+m: a tuple of their coefficients, (k,)
each, or (k, r) for r rows per place.

Newton steps minimise weight · time - Σ log of the slacks, from a motion within all limits to a locally fastest one. Each step
linearises the jerk limits again (the successive linearisation of Verscheure and of TOPP3, within one interior-point method).
This is repeated with larger weights. The compiled `barrier.c` does these steps.

Speed along a piece of path as a function of time, in steps or as a cubic spline, and the resulting trajectory. A cubic spline
with continuous second derivative has constant jerk on each piece, so its limits are checked exactly and a file needs only
positions and velocities.
"""

import ctypes
from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from manipplan.paths.rounding import gauss_rule
from manipplan.paths.trajectory import Trajectory
from manipplan.support.checks import Array
from manipplan.support.kernels import load_kernel, struct
from manipplan.timing.dynamics import ArcLength, PathDynamics

Rows = tuple[Array, ...]


def applied(rows: Rows, c: Array) -> Array:
    """The values of rows at c."""
    count = len(rows[0])
    parts = [row * (c[m : m + count] if row.ndim == 1 else c[m : m + count, None]) for m, row in enumerate(rows)]
    return np.asarray(sum(parts[1:], parts[0]))


#: Jerk limit used where it is infinite on a part of the path, in units in which accelerations are one.
UNLIMITED = 1e12


@dataclass(frozen=True, kw_only=True, eq=False)
class SquaredSpeed:
    """a = (dl/dt)² and b = d²l/dt² at all grid points (k,), and the time of each interval, in the units of the demands."""

    a: Array
    b: Array
    steps: Array


@dataclass(frozen=True, kw_only=True, eq=False)
class SpeedTerms:
    """√a at the inner grid points (k,), the time h of each interval (k - 1,), and its derivative with respect to either √a.

    h = 2 Δl / u with u = √a_k + √a_k+1: h' = -h / u. ∂u/∂c are rows of three coefficients.
    """

    root: Array
    step: Array
    first: Array
    sum_rows: Rows


class JerkProblem:
    """The problem of the fastest a(l) on the grid of `demands` with jerk limits (k - 1, n) per interval [rad/s³].

    Its `..._rows` are linear in the spline's coefficients c, per inner grid point or per interval between two of them.
    """

    def __init__(self, demands: PathDynamics, jerk: Array, start: float, end: float) -> None:
        """`start` and `end` are a at the ends, in the units of the demands; 0: a stop."""
        self.demands = demands
        self.fixed = (start, end)
        grid = demands.at
        #: the grid points that are not stops
        self.inner = slice(int(start == 0), len(grid) - int(end == 0))
        points = grid[self.inner]
        self.h = np.diff(points)
        self.outer = (grid[1] - grid[0], grid[-1] - grid[-2])
        # a_k = w_k c_k + (1 - w_k) c_k+1 and b_k = d_k (c_k+1 - c_k)
        before, after = np.diff(points, prepend=points[0]), np.diff(points, append=points[-1])
        w, self.d = after / (before + after), 1 / (before + after)
        self.a_rows, self.b_rows = (w, 1 - w), (-self.d, self.d)
        # c_0 = r_0 c_1 + e_0 and likewise at the end: b = ± a / (1.5 l) at a stop
        ratio = [1.5 * self.outer[0] / self.h[0], 1.5 * self.outer[1] / self.h[-1]]
        self.tied = [0.0 if fixed else x / (1 + x) for fixed, x in zip(self.fixed, ratio, strict=True)]
        self.fastest = np.minimum(demands.fastest[self.inner], 1e12).copy()
        for k, fixed in ((0, start), (-1, end)):
            if fixed:  # a given speed was checked before
                self.fastest[k] = np.inf
        # c is limited between points too: with limits at points only, the spline and with it b oscillates about the limit
        self.most_c = np.concatenate([[np.inf], (self.fastest[:-1] + self.fastest[1:]) / 2, [np.inf]])
        self.constant = demands.constant[self.inner]
        self.demand_rows = self._combine(demands.u[self.inner], demands.x[self.inner])
        limited = np.isfinite(jerk).any(axis=0)
        t, kappa = demands.tangent[self.inner], demands.curvature[self.inner]
        left, right = self.qdd_rows = self._combine(t[:, limited], kappa[:, limited])
        self.change_rows = (-left[:-1], left[1:] - right[:-1], right[1:])
        scaled = np.minimum(jerk * demands.time_unit**3, UNLIMITED)
        self.jerk = scaled[self.inner.start : self.inner.stop - 1, limited]
        #: at the first and the last point: b <= (6 j² l)^(1/3) where a piece begins with constant jerk j
        self.most_b = [np.inf, np.inf]
        with np.errstate(divide="ignore"):
            for k, size in self._stops():
                self.most_b[k] = float((6 * (scaled[k] / np.abs(t[k])).min() ** 2 * size) ** (1 / 3))

    def _combine(self, u: Array, x: Array) -> Rows:
        """Rows of u b + x a, for u and x (k, r)."""
        left, right = (u * b[:, None] + x * a[:, None] for a, b in zip(self.a_rows, self.b_rows, strict=True))
        return left, right

    @property
    def count(self) -> int:
        """Number of slacks in the barrier."""
        return 2 * self.constant.size + 2 * self.jerk.size + 3 * len(self.fastest) + 3

    def coefficients(self, z: Array) -> Array:
        """All spline coefficients, from the free ones."""
        return np.concatenate([[self.tied[0] * z[0] + self.fixed[0]], z, [self.tied[1] * z[-1] + self.fixed[1]]])

    def pace(self, c: Array) -> SpeedTerms:
        """The speed terms of positive coefficients."""
        root = np.sqrt(applied(self.a_rows, c))
        u = root[:-1] + root[1:]
        step = 2 * self.h / u
        w, v = (row / (2 * root) for row in self.a_rows)
        return SpeedTerms(root=root, step=step, first=-step / u, sum_rows=(w[:-1], v[:-1] + w[1:], v[1:]))

    def _stops(self) -> list[tuple[int, float]]:
        """Index of the inner grid point next to each stop, and its distance from the stop."""
        return [(k, size) for k, size, fixed in zip((0, -1), self.outer, self.fixed, strict=True) if not fixed]

    def motion(self, z: Array) -> SquaredSpeed:
        """The motion of free coefficients at all grid points, including stops."""
        c = self.coefficients(z)
        count = len(self.demands.at)
        a, b = np.zeros(count), np.zeros(count)
        a[self.inner] = applied(self.a_rows, c)
        b[self.inner] = self.d * np.diff(c)
        # exact time of a quadratic a over each interval
        nodes, weights = gauss_rule(12)
        x = (nodes + 1) / 2
        h = np.diff(self.demands.at)
        rise = np.diff(b)[:, None]
        inside = a[:-1, None] + h[:, None] * (2 * b[:-1, None] * x + rise * x**2)
        steps = h * (weights / 2 / np.sqrt(np.maximum(inside, 1e-300))).sum(axis=1)
        if not self.fixed[0]:
            steps[0] = 3 * h[0] / np.sqrt(a[1])
        if not self.fixed[1]:
            steps[-1] = 3 * h[-1] / np.sqrt(a[-2])
        return SquaredSpeed(a=a, b=b, steps=steps)


@dataclass(frozen=True, kw_only=True, eq=False)
class Profile(ABC):
    """Samples of a motion along a piece of path: times from 0 [s], lengths l travelled [rad or m], and dl/dt, (k,) each."""

    curve: ArcLength
    time: Array
    length: Array
    speed: Array

    @abstractmethod
    def joints(self, t: Array, s: Array, length: Array, pace: Array) -> tuple[Array, Array]:
        """q and qd (k, n) at times t, where the path parameter is s and dl/dt is `pace`, (k,) each."""

    def sampled(self, names: Sequence[str], factor: float = 1.0) -> tuple[Trajectory, Array]:
        """The cubic trajectory, `factor` times slower and sampled at whole nanoseconds, and s at its samples (k,)."""
        time = self.time * factor
        t = np.round(time, 9)
        distinct = np.concatenate([[True], np.diff(t) > 0])
        distinct[-1] = True
        if len(t) > 2 and not t[-1] > t[distinct][-2]:
            distinct[np.flatnonzero(distinct)[-2]] = False
        pace = self.speed / factor
        # position of the motion at the rounded times
        length = np.clip(self.length + pace * (t - time), 0.0, self.curve.length)
        length[0], length[-1] = 0.0, self.curve.length
        t, length, pace = t[distinct], length[distinct], pace[distinct]
        if len(t) == 1 or t[-1] <= 0:
            t = np.array([0.0, 1e-9])
            length, pace = np.array([0.0, self.curve.length]), self.speed[[0, -1]] / factor
        s = self.curve.s(length)
        q, qd = self.joints(t, s, length, pace)
        return Trajectory(t=t, q=q, qd=qd, joint_names=tuple(names)), s


@dataclass(frozen=True, kw_only=True, eq=False)
class SteppedProfile(Profile):
    """A motion whose dl/dt changes at a constant rate on each grid interval: acceleration jumps between them."""

    @classmethod
    def of(cls, curve: ArcLength, points: Array, speed: Array) -> "SteppedProfile":
        """From dl/dt at grid points (k,), with two samples per interval."""
        duration = 2 * np.diff(points) / (speed[:-1] + speed[1:])
        rate = np.diff(speed) / duration
        half = duration / 2
        between = points[:-1] + speed[:-1] * half + rate * half**2 / 2
        length = np.insert(points, np.arange(1, len(points)), between)
        pace = np.insert(speed, np.arange(1, len(speed)), speed[:-1] + rate * half)
        times = np.concatenate([[0.0], np.cumsum(np.repeat(half, 2))])
        return cls(curve=curve, time=times, length=np.clip(length, 0.0, curve.length), speed=pace)

    def joints(self, _t: Array, s: Array, length: Array, pace: Array) -> tuple[Array, Array]:
        return self.curve.path(s), self.curve.tangent(length) * pace[:, None]


@dataclass(frozen=True, kw_only=True, eq=False)
class SmoothProfile(Profile):
    """A motion whose acceleration is continuous, and zero where it begins or ends at rest."""

    @classmethod
    def of(cls, demands: PathDynamics, motion: SquaredSpeed) -> "SmoothProfile":
        """From a solution in the units of the demands."""
        time = np.concatenate([[0.0], np.cumsum(motion.steps)]) * demands.time_unit
        speed = np.sqrt(np.maximum(motion.a, 0.0)) * demands.speed_unit
        return cls(curve=demands.curve, time=time, length=demands.length, speed=speed)

    def joints(self, t: Array, s: Array, length: Array, pace: Array) -> tuple[Array, Array]:
        q = np.array(self.curve.path(s))
        ends = self.curve.tangent(length[[0, -1]]) * pace[[0, -1], None]
        qd = smooth_velocities(t, q, ends, (pace[0] == 0, pace[-1] == 0))
        return q, qd


def smooth_velocities(t: Array, q: Array, ends: Array, stops: tuple[bool, bool]) -> Array:
    """Velocities (k, n) of the cubic spline with continuous acceleration through q (k, n), which is modified in place.

    At an end that is a stop, velocity and acceleration are zero; for this the sample next to it is moved, by much less than
    its distance from the end. At other ends the velocity is that in `ends` (2, n).

    The unknowns are the accelerations M at the samples: h M_k-1 / 6 + (h + h') M_k / 3 + h' M_k+1 / 6 is the change of the
    mean velocity from one piece to the next.
    """
    from scipy.linalg import solve_banded

    h = np.diff(t)
    mean = np.diff(q, axis=0) / h[:, None]
    count = len(t)
    band = np.zeros((3, count))  # band[1 + i - j, j] is entry (i, j)
    right = np.zeros_like(q)
    band[1, 1:-1] = (h[:-1] + h[1:]) / 3
    band[2, :-2] = h[:-1] / 6
    band[0, 2:] = h[1:] / 6
    right[1:-1] = np.diff(mean, axis=0)
    band[1, [0, -1]] = 1.0
    for k, stop in enumerate(stops):
        end, beside, first, second = (0, 1, 0, 1) if k == 0 else (-1, -2, -1, -2)
        sign = 1.0 if k == 0 else -1.0
        if not stop:
            band[1, end] = h[first] / 3
            band[(0 if k == 0 else 2), beside] = h[first] / 6
            right[end] = sign * (mean[first] - ends[k])
            continue
        # the sample next to the stop is at q_end + h² M / 6, which makes velocity and acceleration at the stop zero
        far = q[2 if k == 0 else -3]
        step = (far - q[end]) / h[second] * sign
        band[1, beside] += h[first] ** 2 / (6 * h[second]) + h[first] / 6
        right[beside] = sign * step
        row = 2 if k == 0 else count - 3
        band[(2 if k == 0 else 0), beside] -= h[first] ** 2 / (6 * h[second])
        right[row] += sign * (mean[second] - step)
    M = solve_banded((1, 1), band, right, overwrite_ab=True, overwrite_b=True, check_finite=False)
    for k, stop in enumerate(stops):
        if stop:
            end, beside, first = (0, 1, 0) if k == 0 else (-1, -2, -1)
            M[end] = 0.0
            q[beside] = q[end] + h[first] ** 2 * M[beside] / 6
    mean = np.diff(q, axis=0) / h[:, None]
    qd = np.vstack([mean - h[:, None] * (2 * M[:-1] + M[1:]) / 6, [mean[-1] + h[-1] * (M[-2] + 2 * M[-1]) / 6]])
    for k, stop in enumerate(stops):
        qd[-k] = 0.0 if stop else ends[k]
    return qd


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
    centring = centring or Centring(problem)
    if not (start or end):
        entered = centring.entered(z, 0.8, 400)
        return None if entered is None else 0.95 * entered
    nearest: Array | None = np.maximum(z / z.max() * max(start, end), np.interp(greville[1:-1], [0, 1], [start, end]) * 0.999)
    for _ in range(SEARCHES):
        if nearest is None or centring.entered(nearest, 1.0, 1) is not None:
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
