"""The rows of a descent: limits, clearances and constraints of a path as functions of its unknowns z.

Every row is value(z) >= 0 [rad or m], with its Jacobian and sums of Hessians. The limits are linear: control points of the
curve stay inside. A clearance row holds the distance of two bodies at a point of the path, or keeps a point of one body
beyond a plane that the other carries. `FixedRows` come from a free path, so that paths of low energy pass each body on
the same side; a descent on the energy computes no distance. Rows of constraints stand where these are smallest.
"""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from manipplan.collision.model import CollisionModel, Witnesses
from manipplan.collision.proximity import DistanceSearch, Place, ProximitySamples
from manipplan.constraints.constraint_set import ConstraintSet
from manipplan.optimize import steps
from manipplan.optimize.clearance import ClearanceRow, columns
from manipplan.optimize.steps import Curves
from manipplan.paths.joint import Curve
from manipplan.paths.rounding import FINE, FINE_DISTANCE, on_grid
from manipplan.support.checks import Array
from manipplan.symbolic.machine_code import BatchFunction

#: Margin beyond the required distance, so that the proof, whose bounds are not exact, succeeds [m].
MARGIN = 5e-5
#: Minimum distance in s between a place of the grid with a row and the bottom of a dip of the same pair.
PAIR_APART = 1e-2
#: Maximum number of places with rows: bottoms of dips first, then the nearest.
MOST_PLACES = 80
#: Joint step of the finite differences for second derivatives of a distance [rad or m].
JOINT_STEP = 1e-4


@dataclass(kw_only=True, eq=False)
class ClearanceSearch:
    """Distances on paths that differ little from each other.

    Attributes:
        model: the arm among its obstacles.
        clearance: required distance [m].
        margin: margin beyond the required distance [m]; larger at first, as corners are rounder at a distance.
        always: places (s, pair) around which every path is searched for a dip, such as those where a proof failed.
    """

    model: CollisionModel
    clearance: float
    margin: float = MARGIN
    always: list[Place] = field(default_factory=list)

    @cached_property
    def _search(self) -> DistanceSearch:
        return DistanceSearch(self.model)

    @property
    def target(self) -> float:
        """The distance to keep [m]: the required one plus the margin."""
        return self.clearance + self.margin

    def find_near(self, curve: Curve, band: float) -> ProximitySamples:
        """Places on a curve where a pair is near, as `DistanceSearch.find_near` says."""
        return self._search.find_near(curve, self.target, band, self.always)

    def places(self, samples: ProximitySamples) -> NDArray[np.intp]:
        """The samples (r,) that get rows, bottoms of dips first."""
        bottoms, others = np.flatnonzero(samples.is_bottom), np.flatnonzero(~samples.is_bottom)
        if len(bottoms) and len(bottoms) < MOST_PLACES:
            along = 2 * samples.pairs + samples.s  # by pair, then place
            ordered = np.sort(along[bottoms])
            after = np.searchsorted(ordered, along[others])
            gaps = [np.abs(ordered[np.clip(after - k, 0, len(ordered) - 1)] - along[others]) for k in (0, 1)]
            others = others[np.minimum(*gaps) >= PAIR_APART]
        return np.concatenate([bottoms, others])[:MOST_PLACES]

    def planes(self, found: Witnesses) -> Array:
        """Clearance rows (m, column_height(n)) of witnesses, each with the plane through the second body's point."""
        first, second = found.joints.T
        distances = found.radii[:, 0] + self.target
        return columns(self.model.robot.model.njoints - 1, first, found.points, second, found.normals, found.offsets, distances)

    def reverse_planes(self, found: Witnesses) -> Array:
        """As `planes`, with planes on the first bodies: better where a corner of the second faces a side of the first."""
        first, second = found.joints.T
        offsets, distances = (found.opposites * found.points).sum(axis=1) + found.radii[:, 0], found.radii[:, 1] + self.target
        return columns(self.model.robot.model.njoints - 1, second, found.others, first, found.opposites, offsets, distances)

    def hessians(self, q: Array, pairs: NDArray[np.intp], gradients: Array) -> Array:
        """Hessians (m, n, n) of the distances of pairs (m,) at q (m, n), where they have gradients (m, n), by differences."""
        m, n = q.shape
        moved = q[:, None] + JOINT_STEP * np.eye(n)
        found = self.model.witnesses(moved.reshape(-1, n), np.repeat(pairs, n))
        hessians = (found.gradients.reshape(m, n, n) - gradients[:, None]) / JOINT_STEP
        return np.asarray((hessians + hessians.transpose(0, 2, 1)) / 2)


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
        return steps.points(self.line, self.directions, z)

    def violation(self, points: Array) -> float:
        """Largest violation of a limit by control points (r, n) [rad or m]; 0 when there is none."""
        return steps.violation(points, self.lower, self.upper)

    def near(self, points: Array, radius: float) -> LinearRows:
        """The rows at control points (r, n) that a step whose entries are at most `radius` can make negative."""
        value, jacobian = steps.limit_rows(points, self.directions, self.lower, self.upper, radius * self._most_changes)
        return LinearRows(value=value, jacobian=jacobian)

    @cached_property
    def _most_changes(self) -> Array:
        """Largest change (r,) of each control point by steps whose entries are at most 1."""
        return np.asarray(np.abs(self.directions).sum(axis=1))


@dataclass(frozen=True, kw_only=True, eq=False)
class NonlinearRows(ABC):
    """Rows that are not linear, at the curve of z.

    Attributes:
        curves: the curves.
        z: (f, n) the unknowns.
        s, is_bottom: (r,) the parameter of each row, and whether its value has a minimum along the curve there.
        q: (r, n) configurations.
        value: (r,) the rows.
    """

    curves: Curves
    z: Array
    s: Array
    is_bottom: NDArray[np.bool_]
    q: Array
    value: Array

    @property
    @abstractmethod
    def gradients(self) -> Array:
        """Gradients (r, n) of the rows by q."""

    @abstractmethod
    def hessians(self, rows: NDArray[np.intp]) -> Array:
        """Hessians (k, n, n) of some rows (k,) by q."""

    @cached_property
    def changes(self) -> Array:
        """Change (r, f) of the curve with z at the rows."""
        return self.curves.at(self.s)[1]

    @property
    def violation(self) -> float:
        """The largest violation of a row; 0 when there is none."""
        return max(-float(self.value.min()), 0.0)

    @cached_property
    def linear(self) -> LinearRows:
        """The rows for steps from z."""
        return LinearRows.of(self.value, self.changes, self.gradients)

    def curvature(self, multipliers: Array) -> Array:
        """Σ_i λ_i ∇²d_i (f n, f n) of the rows d_i with multipliers λ (r,).

        At a minimum along the path, d_i is the minimum over s, at s*: ∇²(min d) = ∇²d - (∂_s ∇d) (∂_s ∇d)ᵀ / ∂²_s d.
        """
        used = np.flatnonzero(multipliers > 0)
        if not len(used):
            return np.zeros((self.z.size, self.z.size))
        changes, is_bottom, gradients = self.changes[used], self.is_bottom[used], self.gradients[used]
        slopes, speeds, bends = changes, np.zeros_like(gradients), np.zeros_like(gradients)  # used at bottoms only
        if is_bottom.any():
            (speed, slopes), (bend, second_slopes) = (self.curves.at(self.s[used], order) for order in (1, 2))
            speeds, bends = steps.points(speed, slopes, self.z), steps.points(bend, second_slopes, self.z)
        hessians = self.hessians(used)
        return steps.curvature(multipliers[used], changes, slopes, speeds, bends, gradients, hessians, is_bottom, LEAST_BEND)


@dataclass(frozen=True, kw_only=True, eq=False)
class DistanceRows(NonlinearRows):
    """The distances beyond the target [m] at the nearest configurations of the curve.

    Attributes:
        clearance_search: source of the distances.
        pairs: (r,) the pair of bodies of each row.
        witnesses: their nearest points.
    """

    clearance_search: ClearanceSearch
    pairs: NDArray[np.intp]
    witnesses: Witnesses

    @classmethod
    def of(
        cls, curves: Curves, clearance_search: ClearanceSearch, z: Array, curve: Curve, samples: ProximitySamples
    ) -> "DistanceRows":
        """The rows where bodies are near along `curve`, which is that of z."""
        chosen = clearance_search.places(samples)
        s, pairs = samples.s[chosen], samples.pairs[chosen]
        q = curve(s, FINE)
        witnesses = clearance_search.model.witnesses(q, pairs)
        return cls(
            curves=curves,
            z=z,
            s=s,
            is_bottom=samples.is_bottom[chosen],
            q=q,
            value=witnesses.distances - clearance_search.target,
            clearance_search=clearance_search,
            pairs=pairs,
            witnesses=witnesses,
        )

    @property
    def gradients(self) -> Array:
        return self.witnesses.gradients

    def hessians(self, rows: NDArray[np.intp]) -> Array:
        return self.clearance_search.hessians(self.q[rows], self.pairs[rows], self.gradients[rows])

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
        return LinearRows.of(found.distances, self.changes[owner], found.gradients).jacobian, owner


def find_violated_rows(
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
    both = np.stack([clearance_search.planes(found), clearance_search.reverse_planes(found)], axis=1)
    planes, s, pairs = both.reshape(2 * len(near), -1), np.repeat(samples.s[near], 2), np.repeat(samples.pairs[near], 2)
    line, changes = curves.at(s)
    q = steps.points(line, changes, z)
    values = functions.value.by_columns(q, planes)[:, 0]
    true = clearance_search.model.pair_distances(q, pairs) - clearance_search.target
    allowed = np.flatnonzero(values >= true - STRICT)
    if not len(allowed):
        return None
    return LinearRows.of(values[allowed], changes[allowed], functions.gradient.by_columns(q[allowed], planes[allowed]))


@dataclass(frozen=True, kw_only=True, eq=False)
class FixedRows:
    """Clearance rows at fixed places of the curves.

    Attributes:
        functions: distance, gradient and Hessian of the rows.
        curves: the curves they are on.
        s: (r,) their places.
        columns: (r, column_height(n)) the rows as numbers, see `ClearanceRow.column`.
    """

    functions: RowFunctions
    curves: Curves
    s: Array
    columns: Array

    @classmethod
    def of(cls, functions: RowFunctions, curves: Curves, rows: Sequence[ClearanceRow]) -> "FixedRows":
        """The given rows on curves."""
        s, columns = np.array([row.s for row in rows]), np.array([row.column(functions.joints) for row in rows])
        return cls(functions=functions, curves=curves, s=s, columns=columns)

    @cached_property
    def changes(self) -> tuple[Array, Array]:
        """The curve at z = 0 (r, n) and its change with z (r, f), at the places of the rows."""
        return self.curves.at(self.s)

    def at(self, z: Array) -> "FixedRowsAt":
        """The rows at z (f, n)."""
        line, changes = self.changes
        q = steps.points(line, changes, z)
        return FixedRowsAt(
            curves=self.curves,
            z=z,
            s=self.s,
            is_bottom=np.zeros(len(self.s), dtype=bool),
            q=q,
            value=self.functions.value.by_columns(q, self.columns)[:, 0],
            rows=self,
        )


@dataclass(frozen=True, kw_only=True, eq=False)
class FixedRowsAt(NonlinearRows):
    """Fixed rows at unknowns z (f, n)."""

    rows: FixedRows

    @cached_property
    def gradients(self) -> Array:
        return self.rows.functions.gradient.by_columns(self.q, self.rows.columns)

    @cached_property
    def changes(self) -> Array:
        return self.rows.changes[1]

    def hessians(self, rows: NDArray[np.intp]) -> Array:
        return self.rows.functions.hessian(self.q[rows], self.rows.columns[rows])


#: Rows keep this much more than is required, or what start and goal have: a timed motion leaves its path by some 1e-6 rad.
CONSTRAINT_MARGIN = 5e-5
#: Number of intervals of a path at whose ends all rows are evaluated; every STRIDE-th of these places may get a row.
ROW_INTERVALS, STRIDE = 128, 2
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
        return cls(constraints=constraints, target=np.minimum(room, CONSTRAINT_MARGIN))

    def find_near(self, curve: Curve, radius: float) -> ConstraintSamples:
        """The places that a step of a radius [rad or m] can use up."""
        s = np.unique(np.concatenate([np.linspace(0.0, 1.0, ROW_INTERVALS + 1), self.always]))
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
class ConstraintRows(NonlinearRows):
    """The rows of constraints beyond their targets at samples of the curve.

    Attributes:
        search: source of the rows.
        indices: (r,) the row of the constraints that each of these is.
    """

    search: ConstraintSearch
    indices: NDArray[np.intp]

    @classmethod
    def of(cls, curves: Curves, search: ConstraintSearch, z: Array, samples: ConstraintSamples) -> "ConstraintRows":
        """The rows at samples of the curve of z (f, n)."""
        q = curves.curve(z)(samples.s, FINE)
        values = on_grid(search.constraints.values(q), FINE_DISTANCE)[np.arange(len(q)), samples.rows]
        value = np.asarray(values - search.target[samples.rows])
        return cls(
            curves=curves, z=z, s=samples.s, is_bottom=samples.is_bottom, q=q, value=value, search=search, indices=samples.rows
        )

    @cached_property
    def gradients(self) -> Array:
        return np.ascontiguousarray(self.search.constraints.gradients(self.q)[np.arange(len(self.q)), self.indices])

    def hessians(self, rows: NDArray[np.intp]) -> Array:
        return self.search.constraints.hessians(self.q[rows], self.indices[rows])
