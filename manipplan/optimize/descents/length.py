"""What a descent minimises: g, or the energy, of a curve with a few unknowns, with its derivatives."""

from dataclasses import dataclass, field, fields, replace
from functools import cached_property

import numpy as np

from manipplan.cost.density import Density
from manipplan.cost.integral import PathIntegral, gauss
from manipplan.optimize.descents import arithmetic
from manipplan.paths.basis import Basis
from manipplan.paths.curves import Curve
from manipplan.paths.joint import JointPath
from manipplan.paths.rounding import product
from manipplan.support.checks import Array
from manipplan.symbolic.batch_function import BatchFunction


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

    def path(self, z: Array) -> JointPath:
        """The curve at z as a path."""
        return self.basis.path(self.start, self.goal, self.coefficients(z))

    def curve(self, z: Array) -> Curve:
        """The curve at z, for evaluation."""
        line, shapes = self._control
        return Curve(
            self.basis.breaks, arithmetic.points(line, shapes, z).reshape(len(self.basis.control), -1, len(self.start))
        )

    def at(self, s: Array, order: int = 0) -> tuple[Array, Array]:
        """At s (m,) the curve of z = 0 (m, n), or its derivative of an order, and its change with z (m, f) for each joint."""
        while len(self._derivatives) <= order:
            self._derivatives.append((self._derivatives[-1][0].derivative, self._derivatives[-1][1].derivative))
        line, shapes = self._derivatives[order]
        return line(s), shapes(s)

    @cached_property
    def _control(self) -> tuple[Array, Array]:
        """Bernstein control points of all pieces, one after the other: at z = 0 (r, n), and their change with z (r, f)."""
        functions = self.basis.control.reshape(-1, self.basis.size)
        line = self.start + self.basis.line.reshape(-1, 1) * (self.goal - self.start)
        return np.ascontiguousarray(line + product(functions, self.kept.T)), product(functions, self.directions)

    @cached_property
    def _derivatives(self) -> list[tuple[Curve, Curve]]:
        """The curve of z = 0 and the functions by which it changes, and their derivatives that were asked for so far."""
        line, shapes = (Curve(self.basis.breaks, each.reshape(*self.basis.line.shape, -1)) for each in self._control)
        return [(line, shapes)]


@dataclass(frozen=True, kw_only=True, eq=False)
class BatchDensity:
    """A density's value, its gradient, and both derivatives at many points."""

    value: BatchFunction
    gradient: BatchFunction
    derivatives: BatchFunction

    @classmethod
    def of(cls, density: Density) -> "BatchDensity":
        """The three functions of a density with buffers of their own."""
        value, gradient, derivatives = (BatchFunction(each) for each in (density.value, density.gradient, density.derivatives))
        return cls(value=value, gradient=gradient, derivatives=derivatives)


@dataclass(frozen=True, kw_only=True, eq=False)
class LengthModel:
    """Σ_i w_i e(q_i, q'_i) / g₀ over the points of a quadrature rule, as a function of the unknowns z (f, n) of `curves`.

    Attributes:
        density: e, the integrand of g plus a small share of that of the energy, or that of the energy alone.
        curves: the paths.
        edges: (k + 1,) of the quadrature panels.
        s, weights: (m,) Gauss points of all panels and their weights.
        g0: g of the path where the descent begins, so that the value there is about 1.
        power, floor: exponent p and floor ε.
        pace: g₀ in the share of the energy, κ h² / g₀; inf: no such share, so that the value is that of g alone. Any number for
            the energy alone.
    """

    density: BatchDensity
    curves: Curves
    edges: Array
    s: Array
    weights: Array
    g0: float
    power: float
    floor: float
    pace: float

    @property
    def without_energy(self) -> "LengthModel":
        """g alone, over g₀."""
        return replace(self, pace=np.inf)

    @cached_property
    def _values(self) -> tuple[Array, Array, Array, Array]:
        """At the Gauss points: the curve at z = 0 and its slope (m, n), and their changes with z (m, f)."""
        (line, values), (slope, slopes) = (self.curves.at(self.s, order) for order in (0, 1))
        return line, slope, values, slopes

    @cached_property
    def _shares(self) -> Array:
        """The weights of the sum (m,)."""
        return self.weights / self.g0

    def _points(self, z: Array) -> tuple[Array, Array, Array]:
        """Arguments of the density at the Gauss points: q and q' (m, n), and the pace, p and ε (3,)."""
        line, slope, values, slopes = self._values
        numbers = np.array([self.pace, self.power, self.floor])
        return arithmetic.points(line, values, z), arithmetic.points(slope, slopes, z), numbers

    def value(self, z: Array) -> float:
        """The integral at z (f, n)."""
        return float(self.weights @ self.density.value.by_columns(*self._points(z))[:, 0]) / self.g0

    def gradient(self, z: Array) -> Array:
        """Its gradient (f, n)."""
        _, _, values, slopes = self._values
        return arithmetic.gradient(self._shares, values, slopes, self.density.gradient.by_columns(*self._points(z)))

    def derivatives(self, z: Array) -> tuple[Array, Array]:
        """Its gradient (f, n) and Hessian (f n, f n), z in row-major order."""
        _, _, values, slopes = self._values
        each = self.density.derivatives.by_columns(*self._points(z))
        return arithmetic.derivatives(z.shape[1], self._shares, values, slopes, each)


@dataclass(frozen=True, kw_only=True, eq=False)
class MovingLengthModel(LengthModel):
    """The same sum with panels that follow each path: the peak of the integrand at a crossing moves with the path.

    Attributes:
        integral: finds the panels.
    """

    integral: PathIntegral
    _last: dict[bytes, LengthModel] = field(default_factory=dict, init=False)

    def at(self, z: Array) -> LengthModel:
        """The sum over the panels that the path at z (f, n) needs; that of the last z is kept."""
        key = z.tobytes()
        if key not in self._last:
            edges = self.integral.fine_panels(self.curves.path(z))
            s, weights = gauss(edges[:-1], edges[1:])
            fixed = {each.name: getattr(self, each.name) for each in fields(LengthModel)}
            self._last.clear()
            self._last[key] = LengthModel(**fixed | {"edges": edges, "s": s.ravel(), "weights": weights.ravel()})
        return self._last[key]

    def value(self, z: Array) -> float:
        return self.at(z).value(z)

    def gradient(self, z: Array) -> Array:
        return self.at(z).gradient(z)

    def derivatives(self, z: Array) -> tuple[Array, Array]:
        return self.at(z).derivatives(z)
