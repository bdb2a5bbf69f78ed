"""The smooth motion under a recording's noise: least squares with as many pieces as cross-validation wants.

Cubic B-splines over the share u of a duration: velocity, acceleration and jerk of one are bounded by its control points.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from manipplan.paths.trajectory import Trajectory
from manipplan.robots.limits import JointLimits
from manipplan.support.checks import Array

#: Number of samples per piece at which a spline is fitted to a curve.
FIT_SAMPLES = 4


@dataclass(frozen=True, kw_only=True)
class SplineBasis:
    """The cubic B-splines over [0, 1] with `pieces` pieces of equal width, clamped at both ends."""

    pieces: int

    @property
    def size(self) -> int:
        """Number of control points."""
        return self.pieces + 3

    @cached_property
    def knots(self) -> Array:
        """(size + 4,) knots."""
        return np.concatenate([np.zeros(3), np.linspace(0.0, 1.0, self.pieces + 1), np.ones(3)])

    def slopes(self, order: int) -> Array:
        """(size - order, size): the control points of a derivative, from those of the curve."""
        from scipy.interpolate import BSpline

        if order == 0:
            return np.eye(self.size)
        return np.asarray(BSpline(self.knots, np.eye(self.size), 3).derivative(order).c[: self.size - order])

    def values(self, u: Array, order: int = 0) -> Array:
        """(m, size): the functions, or their derivatives, at u (m,)."""
        from scipy.interpolate import BSpline

        return np.asarray(BSpline(self.knots, np.eye(self.size), 3)(u, nu=order))

    def fit(self, shares: Array, values: Array, ends: "Ends") -> Array:
        """Control points (size, n) of the curve with these ends that is nearest to values (m, n) at parameters u (m,)."""
        from scipy.interpolate import BSpline
        from scipy.sparse.linalg import spsolve

        control = ends.control(self)
        free = np.isnan(control[:, 0])
        design = BSpline.design_matrix(shares, self.knots, 3).tocsc()
        rest = values - design[:, ~free] @ control[~free]
        inner = design[:, free]
        control[free] = spsolve((inner.T @ inner).tocsc(), inner.T @ rest).reshape(-1, values.shape[1])
        return control

    @property
    def shares(self) -> Array:
        """Evenly spaced parameters u for `fit`."""
        return np.linspace(0.0, 1.0, FIT_SAMPLES * self.pieces + 1)

    def trajectory(self, control: Array, duration: float, spacing: float, joint_names: tuple[str, ...]) -> Trajectory:
        """The curve with control points (size, n) in a duration [s], with samples at most `spacing` [s] apart; exact."""
        from scipy.interpolate import BSpline

        parts = max(int(np.ceil(duration / self.pieces / spacing - 1e-6)), 1)
        u = np.linspace(0.0, 1.0, parts * self.pieces + 1)
        curve = BSpline(self.knots, control, 3)
        return Trajectory(t=u * duration, q=curve(u), qd=curve(u, nu=1) / duration, joint_names=joint_names)


@dataclass(frozen=True, kw_only=True, eq=False)
class Ends:
    """Where a motion begins and ends: (n,) configurations, and (n,) slopes per share of the duration; None: at rest."""

    start: Array
    goal: Array
    start_slope: Array | None = None
    goal_slope: Array | None = None

    def control(self, basis: SplineBasis) -> Array:
        """Control points (size, n), nan where they are free. At rest the acceleration is zero, too."""
        control = np.full((basis.size, len(self.start)), np.nan)
        first = 1 / (3 * basis.pieces)  # from the first to the second control point, per slope
        for end, q, slope, inward in ((0, self.start, self.start_slope, 1), (-1, self.goal, self.goal_slope, -1)):
            control[end] = q
            if slope is None:
                control[end + inward] = control[end + 2 * inward] = q
            else:
                control[end + inward] = q + inward * first * slope
        return control


#: Smallest and largest number of pieces, factor from one number to the next, and smallest number of samples per piece.
FEWEST, MOST, FINER, PER_PIECE = 16, 2000, 1.3, 3
#: Widest distance between the samples at which a recording is read, as a share of its duration.
WIDEST = 0.01
#: The smallest number of pieces is taken whose score is at most this multiple of the best.
NEARLY = 1.02
#: Share of the largest speed below which the recording counts as at rest at an end.
AT_REST = 0.05


@dataclass(frozen=True, kw_only=True, eq=False)
class Smooth:
    """A smooth curve with control points (size, n), and the ends of a motion along it."""

    basis: SplineBasis
    control: Array
    ends: Ends

    def finer(self, factor: int) -> "Smooth":
        """The curve with the same ends and `factor` times as many pieces."""
        if factor == 1:
            return self
        basis = SplineBasis(pieces=factor * self.basis.pieces)
        curve = self.basis.values(basis.shares) @ self.control
        return Smooth(basis=basis, control=basis.fit(basis.shares, curve, self.ends), ends=self.ends)


def smooth(motion: Trajectory, limits: JointLimits, enough: float) -> Smooth:
    """The smooth motion under the noise, from the recorded start to the recorded goal; noise beyond a limit is cut off there.

    It is at rest at an end where the recording nearly is. The number of pieces is the smallest that leaves a mean residual of
    at most `enough` [rad or m] or else, nearly, the smallest score RSS / (1 - size / m)² of generalised cross-validation over
    m samples [craven1978].
    """
    from scipy.interpolate import make_lsq_spline

    u, q = _places(motion)
    found, scores = [], []
    count, most = float(FEWEST), min(len(u) / PER_PIECE, 1 / np.diff(u).max(), MOST)
    while count <= max(most, FEWEST):
        basis = SplineBasis(pieces=round(count))
        curve = make_lsq_spline(u, q, basis.knots)
        found.append((basis, np.asarray(curve.c)))
        residual = np.sqrt(np.mean((curve(u) - q) ** 2))
        scores.append(float(residual) / (1 - basis.size / len(u)))
        if residual <= enough:
            break
        count *= FINER
    best = next(k for k, score in enumerate(scores) if score <= NEARLY * min(scores))
    basis, control = found[best]
    slopes = basis.values(np.linspace(0.0, 1.0, 201), 1) @ control
    fast = AT_REST * np.linalg.norm(slopes, axis=1).max()
    start, goal = (slope if np.linalg.norm(slope) > fast else None for slope in slopes[[0, -1]])
    first, last = np.clip(motion.q[[0, -1]], limits.lower, limits.upper)
    start, goal = (
        None if slope is None else _inside(basis, q, slope, inward, limits)
        for q, slope, inward in ((first, start, 1), (last, goal, -1))
    )
    ends = Ends(start=first, goal=last, start_slope=start, goal_slope=goal)
    curve = basis.values(basis.shares) @ control
    return Smooth(basis=basis, control=basis.fit(basis.shares, curve, ends), ends=ends)


def _inside(basis: SplineBasis, q: Array, slope: Array, inward: int, limits: JointLimits) -> Array:
    """A slope at an end q (n,), smaller where its control point would be outside the joint limits."""
    step = inward / (3 * basis.pieces)
    return np.asarray((np.clip(q + step * slope, limits.lower, limits.upper) - q) / step)


def _places(motion: Trajectory) -> tuple[Array, Array]:
    """Shares of the duration (m,) and configurations (m, n): the samples, and some between those that are far apart."""
    u = motion.t / motion.duration
    parts = np.ceil(np.diff(u) / WIDEST - 1e-6).astype(int)
    between = [np.linspace(a, b, k, endpoint=False) for a, b, k in zip(u[:-1], u[1:], parts, strict=True)]
    shares = np.append(np.concatenate(between), 1.0)
    return shares, motion(np.minimum(shares * motion.duration, motion.duration))
