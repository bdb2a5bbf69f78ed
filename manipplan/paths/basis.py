"""Bases of a path: functions that vanish at both ends of [0, 1] and are added to the straight line from start to goal.

The bases of one piece span the same polynomials: the optimum is the same, but its coefficients and the conditioning of the
program differ. Those of several pieces are B-splines, which bend on one stretch without moving the others. End conditions
fix some of the coefficients.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.polynomial import Chebyshev, Legendre, Polynomial
from numpy.polynomial.legendre import legvander

from manipplan.paths.joint import JointPath, bernstein, split
from manipplan.paths.rounding import FIXED, gauss_rule, on_grid, product
from manipplan.support.checks import Array, ArrayLike, finite_array, one_of, whole_number
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError

Function = Legendre | Chebyshev | Polynomial
#: Maximum degree: a higher one is slower and no better.
MOST_DEGREE = 20
#: Maximum number of coefficients per joint: time and memory of a solve grow with its square.
MOST_COEFFICIENTS = 200


@dataclass(frozen=True, kw_only=True, eq=False)
class Basis(ABC):
    """q(s) = start + s (goal - start) + Σ_j x_j φ_j(s), with φ_j(0) = φ_j(1) = 0 and coefficients x (n, size).

    Attributes:
        degree: of the pieces.
        breaks: (p + 1,) where the pieces begin and end, from 0 to 1.
    """

    degree: int
    breaks: Array

    @property
    @abstractmethod
    def size(self) -> int:
        """Number of functions φ_j, and of coefficients per joint."""

    @abstractmethod
    def values(self, s: Array, order: int = 0) -> Array:
        """φ_j, or its derivative of an order with respect to s, at s (m,): (m, size)."""

    @cached_property
    def control(self) -> Array:
        """The Bernstein control points (p, degree + 1, size) of each φ_j on each piece."""
        u = (1 - np.cos(np.linspace(0.0, np.pi, self.degree + 1))) / 2
        at = self.breaks[:-1, None] + np.diff(self.breaks)[:, None] * u
        values = self.values(at.ravel()).reshape(*at.shape, self.size)
        return np.asarray(np.linalg.solve(bernstein(self.degree, u), values))

    @cached_property
    def line(self) -> Array:
        """The control points (p, degree + 1) of the function s."""
        return np.asarray(np.linspace(self.breaks[:-1], self.breaks[1:], self.degree + 1, axis=1))

    def gauss(self, points: int) -> tuple[Array, Array]:
        """This number of Gauss points on each piece, and their weights, (m,) each."""
        x, weights = gauss_rule(points)
        half = np.diff(self.breaks)[:, None] / 2
        return (self.breaks[:-1, None] + half * (x + 1)).ravel(), (half * weights).ravel()

    def path(self, start: Array, goal: Array, coefficients: Array) -> JointPath:
        """The path of coefficients (n, size)."""
        control = start + self.line[..., None] * (goal - start) + self.control @ coefficients.T
        control[1:, 0] = control[:-1, -1]
        control[0, 0], control[-1, -1] = start, goal
        return JointPath(breaks=self.breaks, control=control)

    def fit(self, path: JointPath, s: Array) -> Array:
        """Coefficients (n, size) of the least-squares fit to `path` sampled at s (m,), taken as equally spaced."""
        even = np.linspace(0.0, 1.0, len(s))
        rest = path(s) - (path.start + even[:, None] * (path.goal - path.start))
        return np.asarray(np.linalg.lstsq(self.values(even), rest, rcond=None)[0].T)

    def hull(self, parts: int) -> tuple[Array, Array]:
        """Points whose convex hulls contain the curve: (r,) and (r, size), so that each is line (goal - start) + row x.

        They are the control points of at least `parts` equal parts of the pieces together.
        """
        pieces = len(self.breaks) - 1
        cut = subdivision(self.degree, -(-parts // pieces))
        line = (self.line @ cut.T).ravel()
        return line, (cut @ self.control).reshape(len(line), self.size)


@dataclass(frozen=True, kw_only=True, eq=False)
class Series(Basis):
    """One polynomial piece, with NumPy series over [0, 1] as functions."""

    functions: tuple[Function, ...]

    @property
    def size(self) -> int:
        return len(self.functions)

    def values(self, s: Array, order: int = 0) -> Array:
        columns = [np.asarray(each.deriv(order)(s), dtype=float) for each in self.functions]
        return np.column_stack(columns or [np.empty((len(s), 0))])


@dataclass(frozen=True, kw_only=True, eq=False)
class IntegratedLegendre(Series):
    """The same with φ_j' = P_j(2s - 1) to the last digit: rounds among obstacles amplify rounding errors."""

    def values(self, s: Array, order: int = 0) -> Array:
        if order == 1:
            return np.asarray(legvander(2 * s - 1, max(self.degree - 1, 1)), dtype=float)[:, 1 : self.degree]
        return product(np.asarray(legvander(2 * s - 1, self.degree), dtype=float), self._series(order))

    def _series(self, order: int) -> Array:
        """Legendre coefficients (degree + 1, size) of the derivatives of an order."""
        if order not in self._known:
            self._known[order] = np.zeros((self.degree + 1, self.size))
            for j, function in enumerate(self.functions):
                series = function.deriv(order).coef
                self._known[order][: len(series), j] = series
        return self._known[order]

    @cached_property
    def _known(self) -> dict[int, Array]:
        return {}


@dataclass(frozen=True, kw_only=True, eq=False)
class BSplineBasis(Basis):
    """Clamped B-splines [deboor1978]; with continuity C¹ their coefficients are Bernstein points of the pieces.

    Attributes:
        continuity: number of continuous derivatives where pieces join.
    """

    continuity: int

    @property
    def size(self) -> int:
        return (len(self.breaks) - 2) * (self.degree - self.continuity) + self.degree - 1

    @property
    def knots(self) -> Array:
        """Clamped at the ends, and repeated inside as often as the continuity requires."""
        repeats = [self.degree + 1, *[self.degree - self.continuity] * (len(self.breaks) - 2), self.degree + 1]
        return np.repeat(self.breaks, repeats)

    def values(self, s: Array, order: int = 0) -> Array:
        from scipy.interpolate import BSpline

        if self.size == 0:
            return np.empty((len(s), 0))
        inner = np.eye(self.size + 2)[:, 1:-1]  # only the first and the last function do not vanish at the ends
        return np.asarray(BSpline(self.knots, inner, self.degree)(s, nu=order))


def _legendre(degree: int) -> tuple[Function, ...]:
    """Integrals of the Legendre polynomials P_1 .. P_{k-1}: the slopes are orthogonal, so the energy is well conditioned."""
    functions = []
    for j in range(1, degree):
        # ∫ P_j(ξ) dξ = (P_{j+1} - P_{j-1}) / (2j + 1); ds = dξ / 2
        series = np.zeros(j + 2)
        series[j + 1], series[j - 1] = 1.0, -1.0
        functions.append(Legendre(series / (2 * (2 * j + 1)), domain=[0, 1]))
    return tuple(functions)


def _chebyshev(degree: int) -> tuple[Function, ...]:
    """T_2 .. T_k minus T_0 or T_1, the one with the same end values."""
    series = [Chebyshev.basis(j, domain=[0, 1]) for j in range(degree + 1)]
    return tuple(series[j] - series[j % 2] for j in range(2, degree + 1))


def _monomial(degree: int) -> tuple[Function, ...]:
    """s^j - s, j = 2 .. k."""
    power = [Polynomial.basis(j, domain=[0, 1], window=[0, 1]) for j in range(degree + 1)]
    return tuple(each - power[1] for each in power[2:])


SERIES: dict[str, Callable[[int], tuple[Function, ...]]] = {
    "legendre": _legendre,
    "chebyshev": _chebyshev,
    "monomial": _monomial,
}
#: Minimum degree of each basis that can have several pieces: those of composite ones join with the same slope.
SPLINES = {"bspline": 1, "composite": 2}
BASES = (*SERIES, "bernstein", *SPLINES)
#: Maximum number of pieces.
MOST_PIECES = 32


def find_basis(name: str, degree: int, pieces: int = 1) -> Basis:
    """The basis with a name from BASES; its pieces have equal width.

    Raises:
        UnknownNameError: no such basis.
        InvalidInputError: the basis cannot have this number of `pieces`, or the degree is too low to join them.
    """
    one_of("basis", name, BASES)
    pieces = whole_number("pieces", pieces, least=1, most=MOST_PIECES)
    if pieces > 1 and name not in SPLINES:
        raise InvalidInputError("pieces", pieces, f"1 with basis {name!r}; {' and '.join(SPLINES)} can have more")
    breaks = np.linspace(0.0, 1.0, pieces + 1)
    if name in SERIES:
        kind = IntegratedLegendre if name == "legendre" else Series
        return kind(degree=degree, breaks=breaks, functions=SERIES[name](degree))
    if degree < SPLINES.get(name, 1):
        raise InvalidInputError(
            "degree", degree, f"at least {SPLINES[name]} with basis {name!r}, whose pieces join with the same slope"
        )
    return BSplineBasis(degree=degree, breaks=breaks, continuity=1 if name == "composite" else degree - 1)


def subdivision(degree: int, pieces: int) -> Array:
    """The matrix (pieces (degree + 1), degree + 1) from control points of a curve to those of its parts of equal width."""
    rows = []
    rest = np.eye(degree + 1)
    for k in range(pieces - 1, 0, -1):
        left, rest = split(rest, 1 / (k + 1))
        rows.append(left)
    return np.concatenate([*rows, rest])


#: The derivatives that can be fixed: s and order of each.
DERIVATIVES = {
    "start_slope": (0.0, 1),
    "goal_slope": (1.0, 1),
    "start_second_derivative": (0.0, 2),
    "goal_second_derivative": (1.0, 2),
}
#: Tolerance on end derivatives, as a share of the derivative or, if larger, of the distance from start to goal.
TOLERANCE = 1e-6
#: Tolerance to which slopes of integrated Legendre polynomials are orthogonal.
ORTHOGONAL = 1e-10


@dataclass(frozen=True, kw_only=True, eq=False)
class EndConditions:
    """Derivatives q' (slope) and q'' (bend) with respect to s, (n,) each [rad or m]; None: free.

    Each fixes one coefficient per joint: a single piece needs a degree of at least the number of conditions plus one.
    """

    start_slope: Array | None = None
    goal_slope: Array | None = None
    start_second_derivative: Array | None = None
    goal_second_derivative: Array | None = None

    @property
    def pattern(self) -> tuple[tuple[float, int], ...]:
        """The fixed derivatives: s and order of each."""
        return tuple((s, order) for s, order, _ in self._given())

    def check_degree(self, basis_of: Callable[[int], Basis], degree: int) -> None:
        """Raise InvalidInputError for a degree too low for the conditions; `basis_of` gives the basis of a degree."""
        if self.possible(basis_of(degree)):
            return
        count = len(self.pattern)
        least = next(k for k in range(degree + 1, degree + 2 + count) if self.possible(basis_of(k)))
        wanted = f"at least {least}: start and goal need one, and each of the {count} end conditions one more"
        if len(basis_of(degree).breaks) > 2:
            wanted = f"at least {least} for these {count} end conditions and this number of pieces"
        raise InvalidInputError("degree", degree, wanted)

    def possible(self, basis: Basis) -> bool:
        """Whether a path in the basis can have these derivatives."""
        rows = end_rows(self.pattern, basis)
        return not len(rows) or (basis.size > 0 and int(np.linalg.matrix_rank(rows)) == len(rows))

    def met(self, basis: Basis, coefficients: Array, start: Array, goal: Array) -> Array:
        """The coefficients (n, size) of the path that meets the conditions and whose slopes are nearest to those given."""
        line = {1: goal - start, 2: np.zeros_like(start)}
        wanted = [value - line[order] for _, order, value in self._given()]
        if not wanted:
            return coefficients
        rows, across = end_rows(self.pattern, basis), orthonormal(basis)
        missing = np.column_stack(wanted) - coefficients @ rows.T
        return np.asarray(coefficients + (across @ np.linalg.lstsq(rows @ across, missing.T, rcond=None)[0]).T)

    def met_by(self, path: JointPath) -> bool:
        """Whether a path has these derivatives at its ends."""
        way = float(np.abs(path.goal - path.start).max())
        return all(
            np.abs(path(s, order) - value).max() <= TOLERANCE * max(way, float(np.abs(value).max()))
            for s, order, value in self._given()
        )

    def _given(self) -> list[tuple[float, int, Array]]:
        """s, order and value of each fixed derivative."""
        found = [(*at, getattr(self, name)) for name, at in DERIVATIVES.items()]
        return [(s, order, value) for s, order, value in found if value is not None]


def end_rows(pattern: tuple[tuple[float, int], ...], basis: Basis) -> Array:
    """φ_j' or φ_j'' at the ends, (c, size)."""
    rows = [basis.values(np.array([s]), order)[0] for s, order in pattern]
    return np.array(rows).reshape(len(pattern), basis.size)


def free_directions(pattern: tuple[tuple[float, int], ...], basis: Basis) -> Array:
    """Directions (size, f) of a joint's coefficients that keep the conditions, and whose slopes are orthogonal.

    With these, the trust region of a descent and the norm of its gradient mean the same in every basis.
    """
    across = orthonormal(basis)
    if pattern:
        return np.asarray(across @ np.linalg.svd(end_rows(pattern, basis) @ across)[2][len(pattern) :].T)
    are_orthogonal = np.allclose(across, np.diag(np.diag(across)), rtol=0, atol=ORTHOGONAL)  # Legendre
    return np.eye(basis.size) if are_orthogonal else on_grid(across, FIXED)


def orthonormal(basis: Basis) -> Array:
    """The matrix (size, size) of coefficients whose functions ψ have ∫ ψ_i' ψ_j' ds = 1 for i = j, else 0."""
    s, weights = basis.gauss(basis.degree)
    return np.asarray(np.linalg.inv(np.linalg.qr(np.sqrt(weights)[:, None] * basis.values(s, 1)).R))


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class PathShape:
    """The curves among which the optimiser searches: polynomials, or splines of several pieces.

    Attributes:
        degree: of the polynomial, or of each of its pieces, 1 to 20; 1 in one piece is the straight line.
        basis: basis functions of the path. "legendre", "bernstein", "chebyshev" and "monomial" span the same polynomials and
            have the same optimum; "monomial" only up to about degree 14. "bspline" joins `pieces` with degree - 1 continuous
            derivatives, "composite" with one; both suit paths around many corners.
        pieces: number of pieces, of equal width in s, 1 to 32; more than 1 only with "bspline" and "composite". With
            "composite", pieces times (degree - 1) is at most 200.
        start_slope, goal_slope: q'(0) and q'(1), (n,), with respect to s [rad or m]; None: free.
        start_second_derivative, goal_second_derivative: q''(0) and q''(1), (n,) [rad or m]; None: free. Each of the four
            derivatives needs one more degree.
    """

    degree: int = 6
    basis: str = "legendre"
    pieces: int = 1
    start_slope: ArrayLike | None = None
    goal_slope: ArrayLike | None = None
    start_second_derivative: ArrayLike | None = None
    goal_second_derivative: ArrayLike | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "degree", whole_number("degree", self.degree, least=1, most=MOST_DEGREE))
        for name in DERIVATIVES:
            if getattr(self, name) is not None:
                object.__setattr__(self, name, finite_array(name, getattr(self, name), (None,)))
        size = self.functions().size
        object.__setattr__(self, "pieces", int(self.pieces))
        if size > MOST_COEFFICIENTS:
            has = f"with degree {self.degree} the basis {self.basis!r} has {size} coefficients per joint"
            raise InvalidInputError("pieces", self.pieces, f"fewer: {has}, of at most {MOST_COEFFICIENTS}")

    @property
    def has_slopes(self) -> bool:
        """Whether a derivative at an end is given."""
        return any(getattr(self, name) is not None for name in DERIVATIVES)

    def functions(self) -> Basis:
        """The basis functions."""
        return find_basis(self.basis, self.degree, self.pieces)

    def ends(self, n: int) -> EndConditions:
        """The fixed derivatives of n joints; raises InvalidInputError where the degree is too low for them."""
        n = whole_number("n", n, least=1)
        given = {name: getattr(self, name) for name in DERIVATIVES if getattr(self, name) is not None}
        ends = EndConditions(**{name: finite_array(name, value, (n,)) for name, value in given.items()})
        ends.check_degree(lambda k: find_basis(self.basis, k, self.pieces), self.degree)
        return ends
