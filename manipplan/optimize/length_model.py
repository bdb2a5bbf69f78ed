"""g of a path as a function of its unknowns, with exact gradient and Hessian, by Gauss points on panels of uneven width."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from manipplan.checks import Array
from manipplan.optimize.basis import Basis
from manipplan.optimize.batch import BatchFunction
from manipplan.optimize.density import Density
from manipplan.optimize.rounding import product

#: Maximum number of products of two basis functions that are kept at a time while a Hessian is summed.
MOST_PRODUCTS = 4_000_000


@dataclass(frozen=True, kw_only=True, eq=False)
class Curves:
    """The curves start + s (goal - start) + Σ_j (kept + zᵀ directionsᵀ)_j φ_j(s) for unknowns z (f, n).

    Attributes:
        basis: the functions φ_j.
        directions: (size, f) coefficients of functions whose slopes are orthonormal: ‖z‖ is the root mean square of the
            slope's change over s [rad or m].
        kept: (n, size) coefficients at z = 0.
        start, goal: (n,) ends.
    """

    basis: Basis
    directions: Array
    kept: Array
    start: Array
    goal: Array

    def coefficients(self, z: Array) -> Array:
        """Coefficients (n, size) of the curve at z."""
        return np.asarray(self.kept + product(self.directions, z).T)

    def values(self, s: Array, order: int = 0) -> Array:
        """Change of the curve, or of its derivative of an order, with z at s (m,): (m, f), the same for every joint."""
        return product(self.basis.values(s, order), self.directions)

    def line(self, s: Array, order: int = 0) -> Array:
        """The curve at z = 0, or its derivative of order 1, at s (m,): (m, n)."""
        straight = self.start + s[:, None] * (self.goal - self.start) if order == 0 else self.goal - self.start
        return np.asarray(straight + product(self.basis.values(s, order), self.kept.T))


@dataclass(frozen=True, kw_only=True, eq=False)
class BatchDensity:
    """A density's value, gradient and Hessian at many points."""

    value: BatchFunction
    gradient: BatchFunction
    hessian: BatchFunction

    @classmethod
    def of(cls, density: Density) -> "BatchDensity":
        """The three functions of a density with buffers of their own."""
        return cls(
            value=BatchFunction(density.value), gradient=BatchFunction(density.gradient), hessian=BatchFunction(density.hessian)
        )


@dataclass(frozen=True, kw_only=True, eq=False)
class LengthModel:
    """Σ_i w_i e(q_i, q'_i) / g₀ over the points of a quadrature rule, as a function of the unknowns z (f, n) of `curves`.

    Attributes:
        density: e, the integrand of g plus a small share of that of the energy.
        curves: the paths.
        edges: (k + 1,) of the quadrature panels.
        s, weights: (m,) Gauss points of all panels and their weights.
        g0: g of the path where the descent begins, so that the value there is about 1.
        power: exponent p.
        pace: g₀ in the share of the energy, κ h² / g₀; inf: none, so that the value is that of g alone.
    """

    density: BatchDensity
    curves: Curves
    edges: Array
    s: Array
    weights: Array
    g0: float
    power: float
    pace: float

    @property
    def without_energy(self) -> "LengthModel":
        """g alone, over g₀."""
        return replace(self, pace=np.inf)

    @cached_property
    def _values(self) -> tuple[Array, Array, Array, Array]:
        """At the Gauss points: the curve at z = 0 and its slope (m, n), and their changes with z (m, f)."""
        curves = self.curves
        return (curves.line(self.s), curves.line(self.s, 1), curves.values(self.s), curves.values(self.s, 1))

    def _points(self, z: Array) -> tuple[Array, Array, Array]:
        """Arguments of the density at the Gauss points: q and q' (m, n), and the pace and p (m, 2)."""
        line, slope, values, slopes = self._values
        numbers = np.tile([self.pace, self.power], (len(self.s), 1))
        return line + product(values, z), slope + product(slopes, z), numbers

    def value(self, z: Array) -> float:
        """The integral at z (f, n)."""
        return float(self.weights @ self.density.value(*self._points(z))[:, 0, 0]) / self.g0

    def gradient(self, z: Array) -> Array:
        """Its gradient (f, n)."""
        _, _, values, slopes = self._values
        weighed = self.density.gradient(*self._points(z))[:, :, 0] * (self.weights[:, None] / self.g0)
        n = weighed.shape[1] // 2
        return product(values.T, weighed[:, :n]) + product(slopes.T, weighed[:, n:])

    def hessian(self, z: Array) -> Array:
        """Its Hessian (f n, f n), z in row-major order."""
        size, n = z.shape
        _, _, values, slopes = self._values
        both = np.stack([values, slopes], axis=1)
        weighed = self.density.hessian(*self._points(z)) * (self.weights / self.g0)[:, None, None]
        blocks = weighed.reshape(len(self.s), 2, n, 2, n).transpose(0, 1, 3, 2, 4)
        total, count = np.zeros((size * size, n * n)), max(1, MOST_PRODUCTS // (4 * size * size))
        for begin in range(0, len(self.s), count):
            part = both[begin : begin + count]
            products = np.einsum("ipj,iqk->jkipq", part, part).reshape(size * size, -1)
            total += product(products, blocks[begin : begin + count].reshape(-1, n * n))
        return np.asarray(total.reshape(size, size, n, n).transpose(0, 2, 1, 3).reshape(size * n, size * n))
