"""The rows of a descent: limits, clearances and constraints of a path as functions of its unknowns z.

Every row is value(z) >= 0 [rad or m]. The limits are linear: control points of the curve stay inside. Other kinds of rows come
from sources, whose `at` gives the `NonlinearRows` of one curve: their largest violation, values, linearisation and curvature.

- `ClearanceSearch`: the distance of two bodies where they are near on the curve.
- `FixedRows`: a point of one body stays beyond a plane that another one carries, at fixed places. They come from a free path,
  so that paths of low energy pass each body on the same side; a descent on the energy computes no distance.
- `ConstraintSearch`: the rows of constraints where these are smallest.
"""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from manipplan.collision.model import CollisionModel, Witnesses
from manipplan.collision.proximity import DistanceSearch, Place, ProximitySamples
from manipplan.constraints.constraint_set import ConstraintSet
from manipplan.optimize import steps
from manipplan.optimize.clearance import ClearanceRows
from manipplan.optimize.steps import Curves, Derivatives
from manipplan.paths.joint import Curve
from manipplan.paths.rounding import FINE, FINE_DISTANCE, on_grid
from manipplan.support.checks import Array


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
    def stacked(cls, parts: Sequence["LinearRows"], size: int = 0) -> "LinearRows":
        """All rows, one part after the other; no rows for steps of a size without any part."""
        if not parts:
            return cls(value=np.empty(0), jacobian=np.empty((0, size)))
        parts = [each for each in parts if each.value.size] or parts[:1]
        if len(parts) == 1:
            return parts[0]
        return cls(value=np.concatenate([e.value for e in parts]), jacobian=np.concatenate([e.jacobian for e in parts]))

    def from_step(self, step: Array) -> "LinearRows":
        """The same rows for steps from another point, which lies a step (f n,) away."""
        return LinearRows(value=self.value + self.jacobian @ step, jacobian=self.jacobian)


@dataclass(frozen=True, kw_only=True, eq=False)
class LimitRows:
    """The control points line (r, n) + directions (r, f) z of the curve between lower and upper limits (n,)."""

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


#: The bottom of a dip moves with the path only where the second derivative of a row by s is above this [rad or m].
LEAST_BEND = 1e-3


class RowSource(Protocol):
    """One kind of rows, on any curve."""

    def at(self, curves: Curves, z: Array, curve: Curve, radius: float) -> "NonlinearRows":
        """The rows on `curve`, that of z (f, n), which a step of a radius [rad or m] can make negative."""
        ...


@dataclass(frozen=True, kw_only=True, eq=False)
class NonlinearRows(ABC):
    """Rows of one kind on the curve of z.

    Attributes:
        curves, z, curve: all curves, the unknowns (f, n), and the curve that they give.
        s, is_bottom: (r,) the parameter of each row, and whether its value has a minimum along the curve there.
    """

    curves: Curves
    z: Array
    curve: Curve
    s: Array
    is_bottom: NDArray[np.bool_]

    @property
    @abstractmethod
    def violation(self) -> float:
        """The largest violation of a row [rad or m]; 0 when there is none."""

    @property
    @abstractmethod
    def value(self) -> Array:
        """The rows (r,)."""

    @property
    @abstractmethod
    def gradients(self) -> Array:
        """Gradients (r, n) of the rows by q."""

    @abstractmethod
    def hessians(self, rows: NDArray[np.intp]) -> Array:
        """Hessians (k, n, n) of some rows (k,) by q."""

    def violated_from(self, _z: Array) -> LinearRows | None:
        """Rows at other unknowns (f, n) that keep a step from violating these again; None where there are none."""
        return None

    @cached_property
    def q(self) -> Array:
        """Configurations (r, n)."""
        return self.curve(self.s, FINE)

    @cached_property
    def changes(self) -> Array:
        """Change (r, f) of the curve with z at the rows."""
        return self.curves.at(self.s)[1]

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


#: Margin beyond the required distance, so that the proof, whose bounds are not exact, succeeds [m].
MARGIN = 5e-5
#: Minimum distance in s between a place of the grid with a row and the bottom of a dip of the same pair.
PAIR_APART = 1e-2
#: Maximum number of places with rows: bottoms of dips first, then the nearest.
MOST_PLACES = 80
#: Joint step of the finite differences for second derivatives of a distance [rad or m]. At a distance of 0.05 mm the gradient
#: turns within 1e-4.
JOINT_STEP = 1e-6
#: Largest eigenvalue of the second derivatives of a distance, times the radius of the step [m/rad]. Where corners of two bodies
#: meet, a distance bends by its inverse, but only over a step as long as itself.
MOST_TURN = 4.0
#: Rows are made for bodies within this distance of the target: metres per radian of the radius, at least and at most [m].
NEAR, LEAST_NEAR, MOST_NEAR = 1.0, 2e-3, 0.1
#: Bodies are first sought this much farther than the last row of the path before was, with which there were enough.
WIDER = 1.2
#: Maximum number of places of a rejected path whose planes become rows, the nearest first.
MOST_REJECTED = 10
#: Tolerance by which a row may be stricter than the true distance [m].
STRICT = 1e-7


@dataclass(kw_only=True, eq=False)
class ClearanceSearch:
    """Distances on paths that differ little from each other.

    Attributes:
        model: the arm among its obstacles.
        functions: those of clearance rows, by q and the numbers of a row.
        clearance: required distance [m].
        margin: margin beyond the required distance [m]; larger at first, as corners are rounder at a distance.
        always: places (s, pair) around which every path is searched for a dip, such as those where a proof failed.
    """

    model: CollisionModel
    functions: Derivatives
    clearance: float
    margin: float = MARGIN
    always: list[Place] = field(default_factory=list)
    _reached: float = field(default=np.inf, init=False)

    @cached_property
    def _search(self) -> DistanceSearch:
        return DistanceSearch(self.model)

    @property
    def target(self) -> float:
        """The distance to keep [m]: the required one plus the margin."""
        return self.clearance + self.margin

    def at(self, curves: Curves, z: Array, curve: Curve, radius: float) -> "DistanceRows":
        """The distances that are near the target: bottoms of dips first, then the nearest.

        A cloud or a mesh has a row for each point or triangle that is passed closely: of the nearest alone, the next step would
        meet another one.
        """
        band = min(max(NEAR * radius, LEAST_NEAR), MOST_NEAR)
        narrower = min(band, max(WIDER * self._reached, LEAST_NEAR))
        samples = self._search.find_near(curve, self.target, narrower, self.always)
        chosen = _nearest_places(samples)
        if len(chosen) < MOST_PLACES and narrower < band:
            samples = self._search.find_near(curve, self.target, band, self.always)
            chosen = _nearest_places(samples)
        self._reached = samples.distances[chosen].max() - self.target if len(chosen) == MOST_PLACES else np.inf
        return DistanceRows(
            curves=curves,
            z=z,
            curve=curve,
            s=samples.s[chosen],
            is_bottom=samples.is_bottom[chosen],
            search=self,
            samples=samples,
            pairs=samples.pairs[chosen],
            leaves=samples.leaves[chosen],
            radius=radius,
        )


def _nearest_places(samples: ProximitySamples) -> NDArray[np.intp]:
    """Indices of the samples with rows: the bottoms of dips first, then the nearest places that are not beside one."""
    bottoms, others = np.flatnonzero(samples.is_bottom), np.flatnonzero(~samples.is_bottom)
    if len(bottoms) and len(bottoms) < MOST_PLACES:
        along = 2 * samples.pairs + samples.s  # by pair, then place
        ordered = np.sort(along[bottoms])
        after = np.searchsorted(ordered, along[others])
        gaps = [np.abs(ordered[np.clip(after - k, 0, len(ordered) - 1)] - along[others]) for k in (0, 1)]
        others = others[np.minimum(*gaps) >= PAIR_APART]
    return np.concatenate([bottoms, others])[:MOST_PLACES]


@dataclass(frozen=True, kw_only=True, eq=False)
class DistanceRows(NonlinearRows):
    """The distances beyond the target [m] at the nearest configurations of the curve.

    Attributes:
        search: source of the distances.
        samples: all that is near, of which these rows are the nearest.
        pairs: (r,) the pair of bodies of each row.
        leaves: (r,) the triangle or point of a surface that each row is about; -1: the nearest.
        radius: of the steps that the rows are for [rad or m].
    """

    search: ClearanceSearch
    samples: ProximitySamples
    pairs: NDArray[np.intp]
    leaves: NDArray[np.intp]
    radius: float

    @property
    def violation(self) -> float:
        return max(self.search.target - self.samples.least, 0.0)

    @cached_property
    def witnesses(self) -> Witnesses:
        """The nearest points of each pair."""
        return self.search.model.witnesses(self.q, self.pairs, self.leaves)

    @cached_property
    def value(self) -> Array:
        return self.witnesses.distances - self.search.target

    @property
    def gradients(self) -> Array:
        return self.witnesses.gradients

    def hessians(self, rows: NDArray[np.intp]) -> Array:
        q, (m, n) = self.q[rows], (len(rows), self.q.shape[1])
        moved = (q[:, None] + JOINT_STEP * np.eye(n)).reshape(-1, n)
        found = self.search.model.witnesses(moved, np.repeat(self.pairs[rows], n), np.repeat(self.leaves[rows], n))
        hessians = (found.gradients.reshape(m, n, n) - self.gradients[rows][:, None]) / JOINT_STEP
        values, vectors = np.linalg.eigh((hessians + hessians.transpose(0, 2, 1)) / 2)
        most = MOST_TURN / max(self.radius, JOINT_STEP)
        values = np.clip(values, -most, most)
        return np.asarray((vectors * values[:, None]) @ vectors.transpose(0, 2, 1))

    def gradients_nearby(self, rows: NDArray[np.intp], step: float) -> tuple[Array, NDArray[np.intp]]:
        """Gradients of the distances of some rows (r,), on the path and with each joint moved by a step to either side.

        They are (k, f n) with k = r (2 n + 1); also the row (k,) of each.
        """
        n = self.q.shape[1]
        moves = step * np.concatenate([np.zeros((1, n)), np.eye(n), -np.eye(n)])
        owner = np.repeat(rows, len(moves))
        moved = (self.q[rows, None] + moves).reshape(-1, n)
        found = self.search.model.witnesses(moved, self.pairs[owner], self.leaves[owner])
        return LinearRows.of(found.distances, self.changes[owner], found.gradients).jacobian, owner

    def violated_from(self, z: Array) -> LinearRows | None:
        """Rows at other unknowns z (f, n), for each sample of this curve that violates the clearance; None for none.

        Each place gives two, with the plane on either body of the pair: the one on the first body is better where a corner of
        the second faces a side of the first. Rows that are stricter at z than the true distance are left out: they would forbid
        configurations that are free.
        """
        search, samples = self.search, self.samples
        near = np.flatnonzero(samples.distances < search.target)[:MOST_REJECTED]
        if not len(near):
            return None
        found = search.model.witnesses(self.curve(samples.s[near], FINE), samples.pairs[near], samples.leaves[near])
        (first, second), n = found.joints.T, search.model.robot.model.njoints - 1
        keep, other_keep = (found.radii + search.target).T
        opposite = (found.opposites * found.points).sum(axis=1) + found.radii[:, 0]
        s, pairs = np.repeat(samples.s[near], 2), np.repeat(samples.pairs[near], 2)
        planes = [
            ClearanceRows.of(n, samples.s[near], first, found.points, second, found.normals, found.offsets, keep),
            ClearanceRows.of(n, samples.s[near], second, found.others, first, found.opposites, opposite, other_keep),
        ]
        columns = np.stack([each.columns for each in planes], axis=1).reshape(len(s), -1)
        line, changes = self.curves.at(s)
        q = steps.points(line, changes, z)
        values = search.functions.value.by_columns(q, columns)[:, 0]
        true = search.model.pair_distances(q, pairs) - search.target
        allowed = np.flatnonzero(values >= true - STRICT)
        if not len(allowed):
            return None
        gradients = search.functions.first.by_columns(q[allowed], columns[allowed])
        return LinearRows.of(values[allowed], changes[allowed], gradients)


@dataclass(frozen=True, kw_only=True, eq=False)
class FixedRows:
    """Clearance rows at fixed places of the curves, where the curve of z = 0 is `line` (r, n) and changes with z (r, f)."""

    functions: Derivatives
    rows: ClearanceRows
    line: Array
    changes: Array

    @classmethod
    def of(cls, functions: Derivatives, curves: Curves, rows: ClearanceRows) -> "FixedRows":
        """The given rows on curves."""
        line, changes = curves.at(rows.s)
        return cls(functions=functions, rows=rows, line=line, changes=changes)

    def at(self, curves: Curves, z: Array, curve: Curve, _radius: float = 0.0) -> "FixedRowsAt":
        """All rows."""
        none = np.zeros(len(self.line), dtype=bool)
        return FixedRowsAt(curves=curves, z=z, curve=curve, s=self.rows.s, is_bottom=none, source=self)


@dataclass(frozen=True, kw_only=True, eq=False)
class FixedRowsAt(NonlinearRows):
    """Fixed rows at unknowns z (f, n)."""

    source: FixedRows

    @cached_property
    def q(self) -> Array:
        return steps.points(self.source.line, self.source.changes, self.z)

    @property
    def changes(self) -> Array:
        return self.source.changes

    @cached_property
    def value(self) -> Array:
        return self.source.functions.value.by_columns(self.q, self.source.rows.columns)[:, 0]

    @property
    def violation(self) -> float:
        return max(-float(self.value.min()), 0.0)

    @cached_property
    def gradients(self) -> Array:
        return self.source.functions.first.by_columns(self.q, self.source.rows.columns)

    def hessians(self, rows: NDArray[np.intp]) -> Array:
        return self.source.functions.second(self.q[rows], self.source.rows.columns[rows])


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


@dataclass(kw_only=True, eq=False)
class ConstraintSearch:
    """Looks for the smallest rows on paths that differ little from each other; rows keep the values `target` (r,).

    All rows are evaluated at the places s of `always` as well, such as those where a proof failed.
    """

    constraints: ConstraintSet
    target: Array
    always: list[float] = field(default_factory=list)

    @classmethod
    def of(cls, constraints: ConstraintSet, start: Array, goal: Array) -> "ConstraintSearch":
        """The search between start and goal (n,): no row keeps more than both have."""
        room = constraints.values(np.array([start, goal])).min(axis=0)
        return cls(constraints=constraints, target=np.minimum(room, CONSTRAINT_MARGIN))

    def at(self, curves: Curves, z: Array, curve: Curve, radius: float) -> "ConstraintRows":
        """The smallest rows along the curve first, then the smallest of the others."""
        s = np.unique(np.concatenate([np.linspace(0.0, 1.0, ROW_INTERVALS + 1), self.always]))
        values = self._values(curve, s)
        band = min(max(BAND * radius, LEAST_BAND), MOST_BAND)
        inner = values[1:-1]
        low = (inner <= values[:-2]) & (inner < values[2:]) & (inner < band)
        places, rows = np.nonzero(low)
        bottoms = self._bottoms(curve, s[places], s[places + 1], s[places + 2], rows)
        at_bottoms = self._values(curve, bottoms)[np.arange(len(rows)), rows] if len(rows) else np.empty(0)
        others, of_others = np.nonzero(values[::STRIDE] < band)
        near = np.abs(s[::STRIDE][others, None] - bottoms) < APART
        alone = ~((of_others[:, None] == rows) & near).any(axis=1)
        others, of_others = others[alone], of_others[alone]
        order = np.argsort(values[::STRIDE][others, of_others], kind="stable")[: max(MOST_ROWS - len(rows), 0)]
        return ConstraintRows(
            curves=curves,
            z=z,
            curve=curve,
            s=np.concatenate([bottoms, s[::STRIDE][others[order]]]),
            is_bottom=np.arange(len(rows) + len(order)) < len(rows),
            search=self,
            least=min(float(values.min(initial=0.0)), float(at_bottoms.min(initial=0.0))),
            indices=np.concatenate([rows, of_others[order]]),
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
    """The rows of constraints beyond their targets, of which they are the rows `indices` (r,).

    `least` is the smallest value on the curve of a row beyond its target; at most 0.
    """

    search: ConstraintSearch
    least: float
    indices: NDArray[np.intp]

    @property
    def violation(self) -> float:
        return -self.least

    @cached_property
    def value(self) -> Array:
        values = on_grid(self.search.constraints.values(self.q), FINE_DISTANCE)[np.arange(len(self.q)), self.indices]
        return np.asarray(values - self.search.target[self.indices])

    @cached_property
    def gradients(self) -> Array:
        return np.ascontiguousarray(self.search.constraints.gradients(self.q)[np.arange(len(self.q)), self.indices])

    def hessians(self, rows: NDArray[np.intp]) -> Array:
        return self.search.constraints.hessians(self.q[rows], self.indices[rows])
