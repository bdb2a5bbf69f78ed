"""Joint limits and clearances of a path as functions of its unknowns z: values, Jacobian, and sums of Hessians.

Every row is value(z) >= 0 [rad or m]. The limits are linear: control points of the curve stay inside. A clearance row keeps
a point of one body beyond a plane that the other carries; on the path on which it was made its value and gradient are those
of the distance between the two bodies.
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from manipplan.optimize.clearance import column_height
from manipplan.optimize.descents.step_models import Curves, Look, Surroundings
from manipplan.paths.joint import JointPath
from manipplan.paths.rounding import FINE, configurations, on_grid, product
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
    """Distance (m, 1, 1), gradient (m, n, 1) and Hessian (m, n, n) in q of m clearance rows, each at its own configuration."""

    value: BatchFunction
    gradient: BatchFunction
    hessian: BatchFunction


@dataclass(frozen=True, kw_only=True, eq=False)
class LinearRows:
    """Rows value + jacobian p >= 0 for a step p (f n,): (r,) [rad or m] and (r, f n)."""

    value: Array
    jacobian: Array

    def with_rows(self, other: "LinearRows") -> "LinearRows":
        """These rows followed by the other ones."""
        return LinearRows(
            value=np.concatenate([self.value, other.value]), jacobian=np.concatenate([self.jacobian, other.jacobian])
        )


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

    def violation(self, z: Array) -> float:
        """Largest violation of a limit by a control point [rad or m]; 0 when there is none."""
        points = self.line + self.directions @ z
        return float(max(np.max(self.lower - points, initial=0.0), np.max(points - self.upper, initial=0.0)))

    def near(self, z: Array, radius: float) -> LinearRows:
        """The rows at z that a step whose entries are at most `radius` can make negative."""
        points = self.line + self.directions @ z
        change = radius * np.abs(self.directions).sum(axis=1, keepdims=True)
        values, rows = [], []
        for distance, sign in ((points - self.lower, 1.0), (self.upper - points, -1.0)):
            point, joint = np.nonzero(distance < change)
            jacobian = np.zeros((len(point), *z.shape))
            jacobian[np.arange(len(point)), :, joint] = sign * self.directions[point]
            values.append(distance[point, joint])
            rows.append(jacobian.reshape(len(point), z.size))
        return LinearRows(value=np.concatenate(values), jacobian=np.concatenate(rows))


@dataclass(frozen=True, kw_only=True, eq=False)
class ClearanceTable:
    """Clearance rows at places of the curves.

    Attributes:
        functions: distance and gradient of the rows.
        curves: the curves they are on.
        surroundings: source of their distances; None: nothing is checked.
        places: s and pair of each row, and whether the distance has a minimum along the path there.
        columns: (r, column_height(n)) the rows as numbers, see `ClearanceRow.column`.
    """

    functions: RowFunctions
    curves: Curves
    surroundings: Surroundings | None
    places: tuple[tuple[float, int, bool], ...]
    columns: Array

    @classmethod
    def of(
        cls, functions: RowFunctions, curves: Curves, surroundings: Surroundings | None, path: JointPath, look: Look
    ) -> "ClearanceTable":
        """The rows at the nearest places of a look at `path`."""
        places = () if surroundings is None else tuple(surroundings.places(look))
        table = np.empty((0, column_height(len(curves.start))))
        if surroundings is not None and places:
            at = configurations(path, [s for s, *_ in places])
            table = surroundings.rows(surroundings.model.witnesses(at, [pair for _, pair, _ in places]))
        return cls(functions=functions, curves=curves, surroundings=surroundings, places=places, columns=table)

    @classmethod
    def of_rejected(
        cls, functions: RowFunctions, curves: Curves, surroundings: Surroundings, path: JointPath, look: Look
    ) -> "ClearanceTable":
        """Two rows at each place where a rejected `path` violates the clearance: with the plane on either body."""
        near = np.flatnonzero(look.distances < surroundings.target)[:MOST_REJECTED]
        places = [(float(look.s[k]), int(look.pairs[k]), False) for k in near]
        at = configurations(path, [s for s, *_ in places])
        found = surroundings.model.witnesses(at, [pair for _, pair, _ in places])
        both = np.stack([surroundings.rows(found), surroundings.reversed_rows(found)], axis=1)
        table = both.reshape(-1, column_height(len(curves.start)))
        twice = tuple(place for place in places for _ in range(2))
        return cls(functions=functions, curves=curves, surroundings=surroundings, places=twice, columns=table)

    def usable(self, z: Array) -> "ClearanceTable | None":
        """The rows that are not stricter at z (f, n) than the true distance of their pair; None when there are none.

        A row with a plane from another path can be stricter and would forbid configurations that are free.
        """
        assert self.surroundings is not None
        if not self.places:
            return None
        values = self.linear(z, z).value
        line, change = self._at
        q = line + product(change, z)
        true = self.surroundings.model.pair_distances(q, [pair for _, pair, _ in self.places])
        kept = np.flatnonzero(values >= true - self.surroundings.target - STRICT)
        if not len(kept):
            return None
        return replace(self, places=tuple(self.places[k] for k in kept), columns=self.columns[kept])

    @cached_property
    def _at(self) -> tuple[Array, Array]:
        """The curve at z = 0 (r, n) and its change with z (r, f), at the places of the rows."""
        s = np.array([s for s, *_ in self.places])
        return self.curves.at(s)

    def linear(self, z: Array, about: Array) -> LinearRows:
        """The rows linearised at z (f, n), as functions of a step from `about` (f, n)."""
        if not self.places:
            return LinearRows(value=np.empty(0), jacobian=np.empty((0, z.size)))
        line, values = self._at
        q = line + product(values, z)
        value = self.functions.value(q, self.columns)[:, 0, 0]
        gradient = self.functions.gradient(q, self.columns)[:, :, 0]
        jacobian = (values[:, :, None] * gradient[:, None, :]).reshape(len(q), z.size)
        return LinearRows(value=value + jacobian @ (about - z).ravel(), jacobian=jacobian)

    def curvature(self, z: Array, multipliers: Array) -> Array:
        """Σ_i λ_i ∇²d_i (f n, f n) at z (f, n) of the true distances d_i with multipliers λ (r,).

        At a minimum along the path, d_i is the minimum over s, at s* [m]: ∇²(min d) = ∇²d - (∂_s ∇d) (∂_s ∇d)ᵀ / ∂²_s d.
        """
        size, n = z.shape
        total = np.zeros((size, n, size, n))
        used = np.flatnonzero(multipliers > 0)
        if not len(used):
            return total.reshape(z.size, z.size)
        assert self.surroundings is not None
        at = np.array([self.places[k][0] for k in used])
        (q, values), (qs, slopes) = (self.curves.at(at, order) for order in (0, 1))
        q, qs = q + values @ z, qs + slopes @ z
        qss = self.curves.basis.values(at, 2) @ self.curves.coefficients(z).T
        gradients, hessians = self.surroundings.bends(on_grid(q, FINE), [self.places[k][1] for k in used])
        for i, (k, gradient, hessian) in enumerate(zip(used, gradients, hessians, strict=True)):
            total += multipliers[k] * np.einsum("a,c,bd->abcd", values[i], values[i], hessian)
            bend = qs[i] @ hessian @ qs[i] + gradient @ qss[i]
            if self.places[k][2] and bend > LEAST_BEND:
                change = np.outer(slopes[i], gradient) + np.outer(values[i], hessian @ qs[i])
                total -= multipliers[k] / bend * np.einsum("ab,cd->abcd", change, change)
        return total.reshape(z.size, z.size)

    def gradients_nearby(self, z: Array, rows: NDArray[np.intp], step: float) -> tuple[Array, NDArray[np.intp]]:
        """Gradients of the distances of some rows, on the path and with each joint moved by a step.

        Args:
            z: unknowns (f, n).
            rows: indices of the rows (r,).
            step: joint step to either side [rad or m].

        Returns:
            The gradients (k, f n) with k = r (2 n + 1), and for each the index of its row (k,).
        """
        assert self.surroundings is not None
        line, change = self._at
        q, n = on_grid(line[rows] + change[rows] @ z, FINE), line.shape[1]
        moves = step * np.concatenate([np.zeros((1, n)), np.eye(n), -np.eye(n)])
        owner = np.repeat(rows, len(moves))
        moved = (q[:, None] + moves).reshape(-1, n)
        gradients = self.surroundings.model.witnesses(moved, [self.places[k][1] for k in owner]).gradients
        return (change[owner][:, :, None] * gradients[:, None, :]).reshape(len(owner), z.size), owner
