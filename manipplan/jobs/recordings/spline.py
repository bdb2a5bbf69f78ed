"""Cubic B-splines over the share u of a duration: velocity, acceleration and jerk of one are bounded by its control points."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from manipplan.paths.trajectory import Trajectory
from manipplan.support.checks import Array

#: Number of places per piece at which a spline is fitted to a curve.
PLACES = 4


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

    def fit(self, places: Array, values: Array, ends: "Ends") -> Array:
        """Control points (size, n) of the curve with these ends that is nearest to values (m, n) at places (m,)."""
        from scipy.interpolate import BSpline
        from scipy.sparse.linalg import spsolve

        control = ends.control(self)
        free = np.isnan(control[:, 0])
        design = BSpline.design_matrix(places, self.knots, 3).tocsc()
        rest = values - design[:, ~free] @ control[~free]
        inner = design[:, free]
        control[free] = spsolve((inner.T @ inner).tocsc(), inner.T @ rest).reshape(-1, values.shape[1])
        return control

    @property
    def places(self) -> Array:
        """Evenly spaced places for `fit`."""
        return np.linspace(0.0, 1.0, PLACES * self.pieces + 1)

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
