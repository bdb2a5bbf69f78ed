"""The compiled arithmetic of a step, `steps.c`, on NumPy arrays.

What a descent minimises: g, or the energy, of a curve with a few unknowns, with its derivatives.
"""

import ctypes
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cache, cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from manipplan.cost.integral import PathIntegral, gauss
from manipplan.paths.basis import Basis
from manipplan.paths.joint import Curve, JointPath
from manipplan.paths.rounding import product
from manipplan.support.checks import Array
from manipplan.support.kernels import load_kernel, signatures
from manipplan.symbolic.machine_code import BatchFunction, CodedFunctions


@cache
def _calls() -> dict[str, Callable[..., Any]]:
    """They keep the GIL: to release it would take longer than most calls."""
    return load_kernel("steps").functions(quick=signatures("steps"))


#: What a compiled function takes for an array, which has to be contiguous and writable; `array.ctypes` takes much longer.
_at: Callable[[NDArray[Any]], Any] = (ctypes.c_char * 0).from_buffer  # type: ignore[assignment]  # mypy knows no buffers


def points(line: Array, values: Array, z: Array) -> Array:
    """line + values z (m, n), for line (m, n), values (m, f) and z (f, n)."""
    out, z = np.empty(line.shape), np.ascontiguousarray(z)
    _calls()["points"](*line.shape, len(z), _at(line), _at(values), _at(z), _at(out))
    return out


def gradient(weights: Array, values: Array, slopes: Array, each: Array) -> Array:
    """The gradient (f, n) of Σ_i w_i e(q_i, q'_i) by z.

    From weights (m,), the change of q and q' with z (m, f), and the derivatives of e (m, 2 n).
    """
    n, f = each.shape[1] // 2, values.shape[1]
    out = np.empty((f, n))
    _calls()["gradient"](len(weights), n, f, _at(weights), _at(values), _at(slopes), _at(each), _at(out))
    return out


def derivatives(n: int, weights: Array, values: Array, slopes: Array, each: Array) -> tuple[Array, Array]:
    """The same gradient (f, n) for n joints, and the Hessian (f n, f n), from gradients and Hessians of e (m, 2 n + 4 n²)."""
    f = values.shape[1]
    first, second, work = np.empty((f, n)), np.empty((f * n, f * n)), np.empty((f * f + 6) * n * n)
    _calls()["derivatives"](len(weights), n, f, *map(_at, (weights, values, slopes, each, work, first, second)))
    return first, second


def violation(points: Array, lower: Array, upper: Array) -> float:
    """Largest violation of limits (n,) by points (r, n); 0 when there is none."""
    return float(_calls()["violation"](*points.shape, _at(points), _at(lower), _at(upper)))


def limit_rows(points: Array, directions: Array, lower: Array, upper: Array, change: Array) -> tuple[Array, Array]:
    """Distances (k,) to the limits (n,) that are below change (r,) at points (r, n), and their derivatives by z (k, f n).

    `directions` (r, f): change of the points with z.
    """
    (r, n), f = points.shape, directions.shape[1]
    values, rows = np.empty(2 * r * n), np.empty((2 * r * n, f * n))
    count = _calls()["limits"](r, n, f, *map(_at, (points, directions, lower, upper, change, values, rows)))
    return values[:count], rows[:count]


def curvature(
    multipliers: Array,
    values: Array,
    slopes: Array,
    speeds: Array,
    bends: Array,
    gradients: Array,
    hessians: Array,
    moves: NDArray[np.bool_],
    least: float,
) -> Array:
    """Σ_i λ_i ∇²d_i (f n, f n) of distances d_i as functions of z, as `manipplan_curvature` says."""
    (r, f), n = values.shape, gradients.shape[1]
    arrays = [np.ascontiguousarray(each, dtype=float) for each in (multipliers, values, slopes, speeds, bends, gradients)]
    hessians, moves = np.ascontiguousarray(hessians), np.ascontiguousarray(moves, dtype=np.int8)
    work, total = np.empty(f * n), np.zeros((f * n, f * n))
    _calls()["curvature"](r, n, f, *map(_at, arrays), _at(hessians), _at(moves), least, _at(work), _at(total))
    return total


def rows_within(
    values: Array, jacobian: Array, radius: float, spacing: float, bits: int
) -> tuple[NDArray[np.int64], Array, Array]:
    """The rows values (r,) + jacobian (r, k) p >= 0 that a p with |p_i| <= radius can come within `spacing` of.

    Their indices (c,), negative values (c,), rounded to multiples of the spacing, and jacobian (c, k), rounded to `bits` bits.
    """
    (r, k), values, jacobian = jacobian.shape, np.ascontiguousarray(values), np.ascontiguousarray(jacobian)
    chosen, least, rows = np.empty(r, dtype=np.int64), np.empty(r), np.empty((r, k))
    count = _calls()["within"](r, k, _at(values), _at(jacobian), radius, spacing, bits, _at(chosen), _at(least), _at(rows))
    return chosen[:count], least[:count], rows[:count]


def convex_part(matrix: Array, share: float) -> Array | None:
    """The symmetric part of a matrix, if its eigenvalues are all above a share of its largest absolute one; None otherwise."""
    k, matrix = len(matrix), np.ascontiguousarray(matrix)
    out, work = np.empty((k, k)), np.empty((k, k))
    return out if _calls()["is_convex"](k, _at(matrix), share, _at(work), _at(out)) else None


@dataclass(frozen=True, kw_only=True, eq=False)
class Curves:
    """The curves start + s (goal - start) + Σ_j (base + zᵀ directionsᵀ)_j φ_j(s) for unknowns z (f, n).

    Attributes:
        basis: the functions φ_j.
        directions: (size, f) coefficients of functions whose slopes are orthonormal: ‖z‖ is the root mean square of the
            slope's change over s [rad or m].
        base: (n, size) coefficients at z = 0.
        start, goal: (n,) ends.
    """

    basis: Basis
    directions: Array
    base: Array
    start: Array
    goal: Array

    def coefficients(self, z: Array) -> Array:
        """Coefficients (n, size) of the curve at z."""
        return np.asarray(self.base + product(self.directions, z).T)

    def path(self, z: Array) -> JointPath:
        """The curve at z as a path."""
        return self.basis.path(self.start, self.goal, self.coefficients(z))

    def curve(self, z: Array) -> Curve:
        """The curve at z, for evaluation."""
        line, shapes = self._control
        return Curve(self.basis.breaks, points(line, shapes, z).reshape(len(self.basis.control), -1, len(self.start)))

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
        return np.ascontiguousarray(line + product(functions, self.base.T)), product(functions, self.directions)

    @cached_property
    def _derivatives(self) -> list[tuple[Curve, Curve]]:
        """The curve of z = 0 and the functions by which it changes, and their derivatives that were asked for so far."""
        line, shapes = (Curve(self.basis.breaks, each.reshape(*self.basis.line.shape, -1)) for each in self._control)
        return [(line, shapes)]


@dataclass(frozen=True, kw_only=True, eq=False)
class Derivatives:
    """A function with its first and second derivatives, at many points at once."""

    value: BatchFunction
    first: BatchFunction
    second: BatchFunction

    @classmethod
    def of(cls, coded: CodedFunctions) -> "Derivatives":
        """The three functions with buffers of their own."""
        value, first, second = coded.batches()
        return cls(value=value, first=first, second=second)


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
        integral: finds panels that follow each path, since the peak of the integrand at a crossing moves with the path; None:
            the panels stay.
    """

    density: Derivatives
    curves: Curves
    edges: Array
    s: Array
    weights: Array
    g0: float
    power: float
    floor: float
    pace: float
    integral: PathIntegral | None = None
    _last: dict[bytes, "LengthModel"] = field(default_factory=dict, init=False)
    _last_derivatives: dict[bytes, tuple[Array, Array]] = field(default_factory=dict, init=False)

    @property
    def without_energy(self) -> "LengthModel":
        """g alone, over g₀."""
        return replace(self, pace=np.inf)

    def value(self, z: Array) -> float:
        """The integral at z (f, n)."""
        here = self._at(z)
        return float(here.weights @ here.density.value.by_columns(*here._points(z))[:, 0]) / here.g0

    def gradient(self, z: Array) -> Array:
        """Its gradient (f, n)."""
        here = self._at(z)
        _, _, values, slopes = here._values
        return gradient(here._shares, values, slopes, here.density.first.by_columns(*here._points(z)))

    def derivatives(self, z: Array) -> tuple[Array, Array]:
        """Its gradient (f, n) and Hessian (f n, f n), z in row-major order; those of the last z are stored."""
        key = z.tobytes()
        if key not in self._last_derivatives:
            here = self._at(z)
            _, _, values, slopes = here._values
            found = derivatives(z.shape[1], here._shares, values, slopes, here.density.second.by_columns(*here._points(z)))
            self._last_derivatives.clear()
            self._last_derivatives[key] = found
        return self._last_derivatives[key]

    def _at(self, z: Array) -> "LengthModel":
        """The sum over the panels that the path at z (f, n) needs; that of the last z is stored."""
        if self.integral is None:
            return self
        key = z.tobytes()
        if key not in self._last:
            edges = self.integral.fine_panels(self.curves.path(z))
            s, weights = gauss(edges[:-1], edges[1:])
            self._last.clear()
            self._last[key] = replace(self, edges=edges, s=s.ravel(), weights=weights.ravel(), integral=None)
        return self._last[key]

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
        return points(line, values, z), points(slope, slopes, z), numbers
