"""Clearance rows whose places and planes stay where they are, for descents on the energy of a path.

They come from a free path, so that paths of low energy pass each body on the same side. Such a descent measures no distance.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from manipplan.optimize.clearance import ClearanceRow
from manipplan.optimize.descents.constraints import LinearRows, RowFunctions
from manipplan.optimize.descents.step_models import Curves
from manipplan.paths.rounding import product
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
        s, columns = np.array([row.s for row in rows]), np.array([row.column(len(curves.start)) for row in rows])
        return cls(functions=functions, curves=curves, s=s, columns=columns)

    @cached_property
    def _at(self) -> tuple[Array, Array]:
        """The curve at z = 0 (r, n) and its change with z (r, f), at the places of the rows."""
        return self.curves.at(self.s)

    def _configurations(self, z: Array) -> Array:
        line, values = self._at
        return line + product(values, z)

    def values(self, z: Array) -> Array:
        """The rows (r,) at z (f, n) [m]."""
        return np.asarray(self.functions.value(self._configurations(z), self.columns)[:, 0, 0])

    def violation(self, z: Array) -> float:
        """The largest violation of a row at z (f, n) [m]; 0 when there is none."""
        return max(-float(self.values(z).min()), 0.0)

    def linear(self, z: Array, about: Array) -> LinearRows:
        """The rows linearised at z (f, n), as functions of a step from `about` (f, n)."""
        gradient = self.functions.gradient(self._configurations(z), self.columns)[:, :, 0]
        jacobian = (self._at[1][:, :, None] * gradient[:, None, :]).reshape(len(self.s), z.size)
        return LinearRows(value=self.values(z) + jacobian @ (about - z).ravel(), jacobian=jacobian)

    def curvature(self, z: Array, multipliers: Array) -> Array:
        """Σ_i λ_i ∇²d_i (f n, f n) at z (f, n), with multipliers λ (r,)."""
        used = np.flatnonzero(multipliers > 0)
        size, n = z.shape
        total = np.zeros((size, n, size, n))
        if len(used):
            values = self._at[1][used]
            hessians = self.functions.hessian(self._configurations(z)[used], self.columns[used]) * multipliers[used, None, None]
            squares = (values[:, :, None] * values[:, None, :]).reshape(len(used), -1)
            total += product(squares.T, hessians.reshape(len(used), -1)).reshape(size, size, n, n).transpose(0, 2, 1, 3)
        return total.reshape(z.size, z.size)
