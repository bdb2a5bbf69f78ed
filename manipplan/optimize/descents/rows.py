"""Joint limits and clearances of a path as functions of its unknowns z: values, Jacobian, and sums of Hessians.

Every row is value(z) >= 0 [rad or m]. The limits are linear: control points of the curve stay inside. A clearance row holds the
distance of two bodies at a place of the path, or keeps a point of one body beyond a plane that the other carries.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from manipplan.collision.proximity import ProximitySamples
from manipplan.optimize.descents import arithmetic
from manipplan.optimize.descents.clearance_search import ClearanceSearch
from manipplan.optimize.descents.length import Curves
from manipplan.paths.curves import Curve
from manipplan.paths.rounding import FINE
from manipplan.support.checks import Array
from manipplan.symbolic.batch_function import BatchFunction

#: The bottom of a dip moves with the path only where the second derivative of the distance by s is above this [m].
LEAST_BEND = 1e-3
#: Maximum number of places of a rejected path whose planes become rows, the nearest first.
MOST_REJECTED = 10
#: Tolerance by which a row may be stricter than the true distance [m].
STRICT = 1e-7


@dataclass(frozen=True, kw_only=True, eq=False)
class RowFunctions:
    """Distance (m, 1, 1), gradient (m, n, 1) and Hessian (m, n, n) in q of m clearance rows, each at its own configuration.

    `joints` is the number of joints of the tree, for `ClearanceRow.column`.
    """

    joints: int
    value: BatchFunction
    gradient: BatchFunction
    hessian: BatchFunction


@dataclass(frozen=True, kw_only=True, eq=False)
class LinearRows:
    """Rows value + jacobian p >= 0 for a step p (f n,): (r,) [rad or m] and (r, f n)."""

    value: Array
    jacobian: Array

    @classmethod
    def of(cls, value: Array, changes: Array, gradients: Array) -> "LinearRows":
        """From values (r,), change of q with z (r, f), and gradients by q (r, n)."""
        size = changes.shape[1] * gradients.shape[1]
        return cls(value=value, jacobian=(changes[:, :, None] * gradients[:, None, :]).reshape(len(value), size))

    @classmethod
    def none(cls, size: int) -> "LinearRows":
        """No rows, for steps of a size."""
        return cls(value=np.empty(0), jacobian=np.empty((0, size)))

    def with_rows(self, other: "LinearRows") -> "LinearRows":
        """These rows followed by the other ones."""
        return LinearRows(
            value=np.concatenate([self.value, other.value]), jacobian=np.concatenate([self.jacobian, other.jacobian])
        )

    def from_step(self, step: Array) -> "LinearRows":
        """The same rows for steps from another point, which lies a step (f n,) away."""
        return LinearRows(value=self.value + self.jacobian @ step, jacobian=self.jacobian)


@dataclass(frozen=True, kw_only=True, eq=False)
class LimitRows:
    """The control points (r, n) of the curve between lower and upper limits (n,).

    Attributes:
        line, directions: (r, n) and (r, f): the points at z are line + directions z.
        lower, upper: limits (n,).
    """

    line: Array
    directions: Array
    lower: Array
    upper: Array

    def points(self, z: Array) -> Array:
        """The control points (r, n) at z."""
        return arithmetic.points(self.line, self.directions, z)

    def violation(self, points: Array) -> float:
        """Largest violation of a limit by control points (r, n) [rad or m]; 0 when there is none."""
        return arithmetic.violation(points, self.lower, self.upper)

    def near(self, points: Array, radius: float) -> LinearRows:
        """The rows at control points (r, n) that a step whose entries are at most `radius` can make negative."""
        value, jacobian = arithmetic.limit_rows(points, self.directions, self.lower, self.upper, radius * self._most_changes)
        return LinearRows(value=value, jacobian=jacobian)

    @cached_property
    def _most_changes(self) -> Array:
        """Largest change (r,) of each control point by steps whose entries are at most 1."""
        return np.asarray(np.abs(self.directions).sum(axis=1))


@dataclass(frozen=True, kw_only=True, eq=False)
class MeasuredRows:
    """The distances at the nearest places of the curve at z (f, n).

    Attributes:
        curves: the curves.
        clearance_search: source of the distances.
        z: the unknowns.
        s, pairs, moves: (r,) place and pair of each row, and whether the distance has a minimum along the curve there.
        q: (r, n) configurations.
        value: (r,) distances beyond the target [m].
        gradients: (r, n) their gradients by q.
    """

    curves: Curves
    clearance_search: ClearanceSearch
    z: Array
    s: Array
    pairs: NDArray[np.intp]
    moves: NDArray[np.bool_]
    q: Array
    value: Array
    gradients: Array

    @classmethod
    def of(
        cls, curves: Curves, clearance_search: ClearanceSearch, z: Array, curve: Curve, samples: ProximitySamples
    ) -> "MeasuredRows":
        """The rows where bodies are near along `curve`, which is that of z."""
        chosen = clearance_search.places(samples)
        s, pairs, moves = samples.s[chosen], samples.pairs[chosen], samples.is_bottom[chosen]
        q = curve(s, FINE)
        found = clearance_search.model.witnesses(q, pairs)
        value = found.distances - clearance_search.target
        return cls(
            curves=curves,
            clearance_search=clearance_search,
            z=z,
            s=s,
            pairs=pairs,
            moves=moves,
            q=q,
            value=value,
            gradients=found.gradients,
        )

    @cached_property
    def linear(self) -> LinearRows:
        """The rows for steps from z."""
        return LinearRows.of(self.value, self._changes, self.gradients)

    def curvature(self, multipliers: Array) -> Array:
        """Σ_i λ_i ∇²d_i (f n, f n) of the true distances d_i with multipliers λ (r,).

        At a minimum along the path, d_i is the minimum over s, at s* [m]: ∇²(min d) = ∇²d - (∂_s ∇d) (∂_s ∇d)ᵀ / ∂²_s d.
        """
        used = np.flatnonzero(multipliers > 0)
        if not len(used):
            return np.zeros((self.z.size, self.z.size))
        (speed, slopes), (bend, bends) = (self.curves.at(self.s[used], order) for order in (1, 2))
        gradients = self.gradients[used]
        return arithmetic.curvature(
            multipliers[used],
            self._changes[used],
            slopes,
            arithmetic.points(speed, slopes, self.z),
            arithmetic.points(bend, bends, self.z),
            gradients,
            self.clearance_search.hessians(self.q[used], self.pairs[used], gradients),
            self.moves[used],
            LEAST_BEND,
        )

    def gradients_nearby(self, rows: NDArray[np.intp], step: float) -> tuple[Array, NDArray[np.intp]]:
        """Gradients of the distances of some rows, on the path and with each joint moved by a step.

        Args:
            rows: indices of the rows (r,).
            step: joint step to either side [rad or m].

        Returns:
            The gradients (k, f n) with k = r (2 n + 1), and for each the index of its row (k,).
        """
        n = self.q.shape[1]
        moves = step * np.concatenate([np.zeros((1, n)), np.eye(n), -np.eye(n)])
        owner = np.repeat(rows, len(moves))
        moved = (self.q[rows, None] + moves).reshape(-1, n)
        found = self.clearance_search.model.witnesses(moved, self.pairs[owner])
        return LinearRows.of(found.distances, self._changes[owner], found.gradients).jacobian, owner

    @cached_property
    def _changes(self) -> Array:
        """Change (r, f) of the curve with z at the places."""
        return self.curves.at(self.s)[1]


def rejected_rows(
    functions: RowFunctions,
    curves: Curves,
    clearance_search: ClearanceSearch,
    z: Array,
    rejected: Curve,
    samples: ProximitySamples,
) -> LinearRows | None:
    """Rows at z (f, n) at each sample of a rejected curve that violates the clearance; None when there are none.

    Each place gives two, with the plane on either body of the pair. Rows that are stricter at z than the true distance are left
    out: they would forbid configurations that are free.
    """
    near = np.flatnonzero(samples.distances < clearance_search.target)[:MOST_REJECTED]
    if not len(near):
        return None
    found = clearance_search.model.witnesses(rejected(samples.s[near], FINE), samples.pairs[near])
    both = np.stack([clearance_search.planes(found), clearance_search.reversed_planes(found)], axis=1)
    planes, s, pairs = both.reshape(2 * len(near), -1), np.repeat(samples.s[near], 2), np.repeat(samples.pairs[near], 2)
    line, changes = curves.at(s)
    q = arithmetic.points(line, changes, z)
    values = functions.value.by_columns(q, planes)[:, 0]
    true = clearance_search.model.pair_distances(q, pairs) - clearance_search.target
    kept = np.flatnonzero(values >= true - STRICT)
    if not len(kept):
        return None
    return LinearRows.of(values[kept], changes[kept], functions.gradient.by_columns(q[kept], planes[kept]))
