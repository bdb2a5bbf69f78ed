"""Clearance rows whose places and planes stay where they are, for descents on the energy of a path.

They come from a free path, so that paths of low energy pass each body on the same side. Such a descent measures no distance.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from manipplan.optimize.clearance import ClearanceRow
from manipplan.optimize.descents import arithmetic
from manipplan.optimize.descents.length import Curves
from manipplan.optimize.descents.rows import LEAST_BEND, LinearRows, RowFunctions
from manipplan.support.checks import Array


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
        return FixedRowsAt(rows=self, z=z)


@dataclass(frozen=True, kw_only=True, eq=False)
class FixedRowsAt:
    """Fixed rows at unknowns z (f, n)."""

    rows: FixedRows
    z: Array

    @cached_property
    def _q(self) -> Array:
        line, changes = self.rows.changes
        return arithmetic.points(line, changes, self.z)

    @cached_property
    def values(self) -> Array:
        """The rows (r,) [m]."""
        return self.rows.functions.value.by_columns(self._q, self.rows.columns)[:, 0]

    @property
    def violation(self) -> float:
        """The largest violation of a row [m]; 0 when there is none."""
        return max(-float(self.values.min()), 0.0)

    @cached_property
    def linear(self) -> LinearRows:
        """The rows for steps from z."""
        gradients = self.rows.functions.gradient.by_columns(self._q, self.rows.columns)
        return LinearRows.of(self.values, self.rows.changes[1], gradients)

    def curvature(self, multipliers: Array) -> Array:
        """Σ_i λ_i ∇²d_i (f n, f n), with multipliers λ (r,)."""
        used = np.flatnonzero(multipliers > 0)
        if not len(used):
            return np.zeros((self.z.size, self.z.size))
        changes, q = self.rows.changes[1][used], self._q[used]
        hessians = self.rows.functions.hessian(q, self.rows.columns[used])
        still = np.zeros_like(q)
        return arithmetic.curvature(
            multipliers[used], changes, changes, still, still, still, hessians, np.zeros(len(used), dtype=bool), LEAST_BEND
        )
