"""The fastest speed along a piece of path when jerk is limited too: unknowns and limits; `barrier.py` solves for them.

The unknown is a(l) = (dl/dt)², a quadratic spline with coefficients c; b = d²l/dt² = a'/2 is then continuous and piecewise
linear. With unit tangent t and curvature κ, acceleration t b + κ a at grid points is linear in c, and the jerk limit on
the interval between two of them,

    |Δ(t b + κ a)| <= J h,    h = 2 Δl / (√a_k + √a_k+1),

has a right side that is convex in a. Its linearisation is conservative, so a Newton step that keeps the linearised limits
leads from one motion within all limits to a faster one. At a stop a piece begins with constant jerk j, l = j t³/6, so
a = 1.5 l b at the first grid point.

Rows are linear functions of up to three neighbouring unknowns, y_i = Σ_m rows[m][i] c_i+m: a tuple of their coefficients, (k,)
each, or (k, r) for r rows per place.

Speed along a piece of path as a function of time, in steps or as a cubic spline, and the resulting trajectory.

A cubic spline with continuous second derivative has constant jerk on each piece, so its limits are checked exactly and a
file needs only positions and velocities.
"""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from manipplan.paths.rounding import gauss_rule
from manipplan.paths.trajectory import Trajectory
from manipplan.support.checks import Array
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

    def time(self, pace: SpeedTerms) -> float:
        """Duration in the units of the demands."""
        total = pace.step.sum()
        for k, size in self._stops():
            total += 3 * size / pace.root[k]
        return float(total)

    def _stops(self) -> list[tuple[int, float]]:
        """Index of the inner grid point next to each stop, and its distance from the stop."""
        return [(k, size) for k, size, fixed in zip((0, -1), self.outer, self.fixed, strict=True) if not fixed]

    def slacks(self, c: Array) -> Slacks | None:
        """The slacks of all limits; None when a limit is exceeded."""
        if not (c > 0).all():  # c > 0 means a > 0 everywhere, also between grid points
            return None
        pace = self.pace(c)
        demand = applied(self.demand_rows, c) + self.constant
        room = self.jerk * pace.step[:, None]
        change = np.diff(applied(self.qdd_rows, c), axis=0)
        found = Slacks(
            fastest=self.fastest - applied(self.a_rows, c),
            between=self.most_c - c,
            above=1.0 - demand,
            below=1.0 + demand,
            rise=room - change,
            fall=room + change,
            ends=np.array([self.most_b[0] - self.d[0] * (c[1] - c[0]), self.most_b[1] + self.d[-1] * (c[-1] - c[-2])]),
            c=c,
            pace=pace,
        )
        return found if all((part > 0).all() for part in found.every) else None

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
    """Samples of a motion along a piece of path.

    Attributes:
        curve: the piece as a function of its arc length.
        time: (k,) sample times, from 0 [s].
        length: (k,) arc length travelled [rad or m].
        speed: (k,) dl/dt.
    """

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
