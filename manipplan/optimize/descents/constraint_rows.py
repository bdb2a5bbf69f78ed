"""Rows of constraints in a descent: where they are smallest along a path, with derivatives by the unknowns z."""

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from manipplan.constraints.constraint_set import ConstraintSet
from manipplan.optimize.descents import arithmetic
from manipplan.optimize.descents.length import Curves
from manipplan.optimize.descents.rows import LEAST_BEND, LinearRows
from manipplan.paths.curves import Curve
from manipplan.paths.rounding import FINE, FINE_DISTANCE, on_grid
from manipplan.support.checks import Array

#: Rows keep this much more than is required, or what start and goal have: a timed motion leaves its path by some 1e-6 rad.
MARGIN = 5e-5
#: Number of intervals of a path at whose ends all rows are evaluated; every STRIDE-th of these places may get a row.
PLACES, STRIDE = 128, 2
#: Rows are made within this value of the target: per radian of the radius of the trust region, at least and at most.
BAND, LEAST_BAND, MOST_BAND = 2.0, 5e-3, 0.5
#: Maximum number of rows: smallest along the path first, then the smallest of the others.
MOST_ROWS = 80
#: Minimum distance in s of other places from the bottom of a dip of the same row.
APART = 1e-2
#: Steps of the search for the bottom of a dip, by false position on the slope.
BOTTOM_STEPS = 5


@dataclass(frozen=True, kw_only=True, eq=False)
class ConstraintSamples:
    """Places of a curve at which rows are near their targets.

    Attributes:
        s, rows, is_bottom: (k,) places, the row that is near there, and whether it has a minimum along the curve.
        violation: how far the smallest row is below its target; 0 where all are above.
    """

    s: Array
    rows: NDArray[np.intp]
    is_bottom: NDArray[np.bool_]
    violation: float


@dataclass(kw_only=True, eq=False)
class ConstraintSearch:
    """Looks for the smallest rows on paths that differ little from each other.

    Attributes:
        constraints: what is kept.
        target: (r,) values that rows keep.
        always: places s at which all rows are evaluated as well, such as those where a proof failed.
    """

    constraints: ConstraintSet
    target: Array
    always: list[float] = field(default_factory=list)

    @classmethod
    def of(cls, constraints: ConstraintSet, start: Array, goal: Array) -> "ConstraintSearch":
        """The search between start and goal (n,): no row keeps more than both have."""
        room = constraints.values(np.array([start, goal])).min(axis=0)
        return cls(constraints=constraints, target=np.minimum(room, MARGIN))

    def find_near(self, curve: Curve, radius: float) -> ConstraintSamples:
        """The places that a step of a radius [rad or m] can use up."""
        s = np.unique(np.concatenate([np.linspace(0.0, 1.0, PLACES + 1), self.always]))
        values = self._values(curve, s)
        band = min(max(BAND * radius, LEAST_BAND), MOST_BAND)
        inner = values[1:-1]
        low = (inner <= values[:-2]) & (inner < values[2:]) & (inner < band)
        places, rows = np.nonzero(low)
        bottoms = self._bottoms(curve, s[places], s[places + 1], s[places + 2], rows)
        at_bottoms = self._values(curve, bottoms)[np.arange(len(rows)), rows] if len(rows) else np.empty(0)
        violation = max(-float(values.min(initial=0.0)), -float(at_bottoms.min(initial=0.0)))
        others, of_others = np.nonzero(values[::STRIDE] < band)
        near = np.abs(s[::STRIDE][others, None] - bottoms) < APART
        alone = ~((of_others[:, None] == rows) & near).any(axis=1)
        others, of_others = others[alone], of_others[alone]
        order = np.argsort(values[::STRIDE][others, of_others], kind="stable")[: max(MOST_ROWS - len(rows), 0)]
        return ConstraintSamples(
            s=np.concatenate([bottoms, s[::STRIDE][others[order]]]),
            rows=np.concatenate([rows, of_others[order]]),
            is_bottom=np.arange(len(rows) + len(order)) < len(rows),
            violation=violation,
        )

    def _values(self, curve: Curve, s: Array) -> Array:
        """The rows beyond their targets (m, r)."""
        return on_grid(self.constraints.values(curve(s, FINE)), FINE_DISTANCE) - self.target

    def _bottoms(self, curve: Curve, low: Array, middle: Array, high: Array, rows: NDArray[np.intp]) -> Array:
        """Where each row (k,) is smallest between low and high, which enclose a minimum [k]."""
        if not len(rows):
            return middle
        each, slope = np.arange(len(rows)), curve.derivative

        def slopes(s: Array) -> Array:
            gradients = self.constraints.gradients(curve(s, FINE))[each, rows]
            return np.asarray((gradients * slope(s)).sum(axis=1))

        at_low, at_high, s = slopes(low), slopes(high), middle
        for _ in range(BOTTOM_STEPS):
            found = slopes(s)
            falls = found < 0
            low, at_low = np.where(falls, s, low), np.where(falls, found, at_low / (1 + ~falls))
            high, at_high = np.where(falls, high, s), np.where(falls, at_high / (1 + falls), found)
            steep = at_high - at_low
            guess = np.where(steep > 0, (low * at_high - high * at_low) / np.where(steep > 0, steep, 1.0), (low + high) / 2)
            s = np.clip(guess, low, high)
        return s


@dataclass(frozen=True, kw_only=True, eq=False)
class ConstraintRows:
    """The rows at samples of the curve of z (f, n).

    Attributes:
        curves: the curves.
        search: source of the rows.
        z: the unknowns.
        samples: the places.
    """

    curves: Curves
    search: ConstraintSearch
    z: Array
    samples: ConstraintSamples

    @cached_property
    def value(self) -> Array:
        """The rows (k,) beyond their targets."""
        values = on_grid(self.search.constraints.values(self._q), FINE_DISTANCE)
        return np.asarray(values[np.arange(len(self._q)), self.samples.rows] - self.search.target[self.samples.rows])

    @cached_property
    def linear(self) -> LinearRows:
        """The rows for steps from z."""
        return LinearRows.of(self.value, self._changes, self._gradients)

    def curvature(self, multipliers: Array) -> Array:
        """Σ_i λ_i ∇²c_i (f n, f n), with multipliers λ (k,): at a minimum along the path, of the minimum over s."""
        used = np.flatnonzero(multipliers > 0)
        if not len(used):
            return np.zeros((self.z.size, self.z.size))
        (speed, slopes), (bend, bends) = (self.curves.at(self.samples.s[used], order) for order in (1, 2))
        return arithmetic.curvature(
            multipliers[used],
            self._changes[used],
            slopes,
            arithmetic.points(speed, slopes, self.z),
            arithmetic.points(bend, bends, self.z),
            self._gradients[used],
            self.search.constraints.hessians(self._q[used], self.samples.rows[used]),
            self.samples.is_bottom[used],
            LEAST_BEND,
        )

    @cached_property
    def _q(self) -> Array:
        return self.curves.curve(self.z)(self.samples.s, FINE)

    @cached_property
    def _gradients(self) -> Array:
        return np.ascontiguousarray(self.search.constraints.gradients(self._q)[np.arange(len(self._q)), self.samples.rows])

    @cached_property
    def _changes(self) -> Array:
        """Change (k, f) of the curve with z at the places."""
        return self.curves.at(self.samples.s)[1]
