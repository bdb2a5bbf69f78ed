"""JointPath: a curve q(s), s in [0, 1], through joint space, as pieces in Bernstein form.

Curves are evaluated by the compiled `curves.c`, otherwise by NumPy, with the same numbers.
"""

import ctypes
import itertools
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from math import comb

import numpy as np
from numpy.polynomial import chebyshev, legendre

from manipplan.paths.tolerance import distinct
from manipplan.support.checks import (
    COINCIDENT,
    Array,
    ArrayLike,
    finite_array,
    flag,
    number,
    number_array,
    one_of,
    whole_number,
)
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError
from manipplan.support.kernels import load_kernel, struct

#: Curves of a higher degree are evaluated by NumPy; as in curves.c.
MOST_DEGREE = 30


@cache
def _call() -> Callable[..., int]:
    return load_kernel("curves").functions(quick=("curve",))["curve"]


class Curve:
    """Polynomial pieces between breaks (p + 1,), which increase from 0 to 1, with control points (p, k + 1, n), k >= 0.

    Attributes:
        address: of the curve as compiled code knows it, for as long as this object lives; 0 above MOST_DEGREE.
    """

    __slots__ = ("_breaks", "_control", "_curve", "address")

    def __init__(self, breaks: Array, control: Array) -> None:
        self._breaks, self._control = np.ascontiguousarray(breaks), np.ascontiguousarray(control)
        pieces, points, n = control.shape
        self._curve, self.address = None, 0
        if points - 1 <= MOST_DEGREE:
            self._curve = struct("curves", "Curve")(
                pieces=pieces, degree=points - 1, n=n, breaks=self._breaks.ctypes.data, control=self._control.ctypes.data
            )
            self.address = ctypes.addressof(self._curve)

    def __reduce__(self) -> tuple[object, ...]:
        return Curve, (self._breaks, self._control)

    def __call__(self, s: Array, spacing: float = 0.0) -> Array:
        """The curve (..., n) at s (...), to multiples of `spacing` unless that is 0; InvalidInputError outside [0, 1]."""
        if not self.address:
            return self._by_numpy(s, spacing)
        s = np.ascontiguousarray(s, dtype=float).reshape(s.shape)  # ascontiguousarray makes a number a row
        out = np.empty((*s.shape, self._control.shape[2]))
        if _call()(self.address, s.ctypes.data, s.size, spacing, out.ctypes.data):
            raise _outside(s)
        return out

    def _by_numpy(self, s: Array, spacing: float) -> Array:
        if s.size and not (s.min() >= 0 and s.max() <= 1):  # also NaN
            raise _outside(s)
        piece = np.clip(np.searchsorted(self._breaks, s, side="right") - 1, 0, len(self._control) - 1)
        u = (s - self._breaks[piece]) / np.diff(self._breaks)[piece]
        weights = bernstein(self._control.shape[1] - 1, u)
        out = weights[..., 0, None] * self._control[piece, 0]
        for j in range(1, self._control.shape[1]):
            out += weights[..., j, None] * self._control[piece, j]
        return np.asarray(np.round(out / spacing) * spacing if spacing > 0 else out)

    @property
    def derivative(self) -> "Curve":
        """The curve of the derivative, of degree k - 1; zero for k = 0."""
        k = self._control.shape[1] - 1
        if k == 0:
            return Curve(self._breaks, np.zeros_like(self._control))
        control = self._control
        return Curve(self._breaks, (control[:, 1:] - control[:, :-1]) * (k / np.diff(self._breaks)[:, None, None]))


def bernstein(degree: int, u: ArrayLike) -> Array:
    """Values of the Bernstein polynomials of `degree` at u (...), (..., degree + 1)."""
    u = np.asarray(u, dtype=float)[..., None]
    powers, rest = (np.cumprod(np.concatenate([np.ones_like(x), *[x] * degree], axis=-1), axis=-1) for x in (u, 1 - u))
    return np.asarray(_binomials(degree) * powers * rest[..., ::-1])


@cache
def _binomials(degree: int) -> Array:
    """The binomial coefficients of `degree`, (degree + 1,)."""
    return np.array([comb(degree, i) for i in range(degree + 1)], dtype=float)


def _outside(s: Array) -> InvalidInputError:
    return InvalidInputError("s", s, "numbers from 0 to 1")


#: Breaks of two paths nearer than this are one.
BREAK_TOLERANCE = 1e-12
#: Tolerance on the full turns between start and end of a closed path [rad or m].
TURNED = 1e-9
#: Bases available for the coefficients of a polynomial path.
SERIES = ("monomial", "bernstein", "legendre", "chebyshev")
#: Highest order of a derivative, and maximum numbers of panels, of Gauss points in each, and of samples.
MOST_ORDER, MOST_PANELS, MOST_POINTS, MOST_SAMPLES = 100, 10**6, 100, 5 * 10**6


@one_line
@dataclass(frozen=True, kw_only=True, eq=False)
class JointPath:
    """Polynomial pieces between `breaks`, each the Bernstein polynomial of its control points.

    A piece lies in the convex hull of its control points, so limits that hold for these hold on the whole curve.

    Attributes:
        breaks: (p + 1,) where pieces begin and end: 0 = s_0 < s_1 < ... < s_p = 1.
        control: (p, k + 1, n) control points [rad or m] of degree k; neighbours share their end points.
    """

    breaks: Array
    control: Array

    def __post_init__(self) -> None:
        breaks = finite_array("breaks", self.breaks, (None,))
        control = finite_array("control", self.control, (None, None, None))
        if len(breaks) != len(control) + 1 or breaks[0] != 0 or breaks[-1] != 1 or not (np.diff(breaks) > 0).all():
            raise InvalidInputError("breaks", breaks, f"{len(control) + 1} increasing numbers from 0 to 1")
        if control.shape[1] < 2:
            raise InvalidInputError("control", control.shape, "at least two control points per piece")
        if not (np.abs(control[:-1, -1] - control[1:, 0]) <= 1e-9).all():
            raise InvalidInputError("control", "pieces that do not join", "pieces whose ends meet")
        object.__setattr__(self, "breaks", breaks)
        object.__setattr__(self, "control", control)

    @classmethod
    def line(cls, start: ArrayLike, goal: ArrayLike) -> "JointPath":
        """The straight path from start (n,) to goal (n,): (6.9) in kth2012."""
        first = finite_array("start", start, (None,))
        return cls.through(np.stack([first, finite_array("goal", goal, (len(first),))]))

    @classmethod
    def through(cls, waypoints: ArrayLike) -> "JointPath":
        """Straight pieces through waypoints (k, n), k >= 2; s is proportional to arc length.

        Of waypoints nearer than 1e-6 rad or m to the one before it takes one.
        """
        points = finite_array("waypoints", waypoints, (None, None))
        if len(points) < 2:
            raise InvalidInputError("waypoints", points, "at least two points")
        points = points[distinct(len(points), lambda i, j: np.linalg.norm(points[i] - points[j], axis=1))]
        if len(points) < 2:
            wanted = f"at least two points that differ: all are within {COINCIDENT:g} rad or m of the first one"
            raise InvalidInputError("waypoints", np.asarray(waypoints), wanted)
        steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
        breaks = np.concatenate([[0.0], np.cumsum(steps)]) / steps.sum()
        breaks[-1] = 1.0
        return cls(breaks=breaks, control=np.stack([points[:-1], points[1:]], axis=1))

    @classmethod
    def spline(cls, s: ArrayLike, q: ArrayLike, *, closed: bool = False) -> "JointPath":
        """The cubic spline through q (k, n) at increasing s (k,) from 0 to 1, twice continuously differentiable.

        Of rows nearer than 1e-6 to the one before it, in s and in q, it takes one. With `closed` it is smooth where the end
        joins the start, too; the last configuration must equal the first up to full turns.
        """
        from scipy.interpolate import CubicSpline

        closed = flag("closed", closed)
        breaks, points = finite_array("s", s, (None,)), finite_array("q", q, (None, None))
        increasing = len(breaks) == len(points) and len(breaks) >= 2 and (np.diff(breaks) > 0).all()
        if not increasing or breaks[0] != 0 or breaks[-1] != 1:
            raise InvalidInputError("s", breaks, f"{len(points)} increasing numbers from 0 to 1, one per row of q")
        own = distinct(
            len(breaks), lambda i, j: np.maximum(np.linalg.norm(points[i] - points[j], axis=1), np.abs(breaks[i] - breaks[j]))
        )
        breaks, points = breaks[own], points[own]
        drift = points[-1] - points[0] if closed else np.zeros(points.shape[1])
        if np.abs(drift - 2 * np.pi * np.round(drift / (2 * np.pi))).max(initial=0.0) > TURNED:
            raise InvalidInputError("q", points[-1].tolist(), "a last row equal to the first up to full turns")
        even = points - breaks[:, None] * drift
        if closed:
            even[-1] = even[0]
        curve = CubicSpline(breaks, even, bc_type="periodic" if closed else "not-a-knot")
        slopes, widths = curve(breaks, 1) + drift, np.diff(breaks)[:, None]
        control = [points[:-1], points[:-1] + widths * slopes[:-1] / 3, points[1:] - widths * slopes[1:] / 3, points[1:]]
        return cls(breaks=breaks, control=np.stack(control, axis=1))

    @classmethod
    def joined(cls, parts: Sequence["JointPath"]) -> "JointPath":
        """One path after another, each beginning where the previous one ends; each has a share of s like that of its length.

        Raises InvalidInputError for no path, a path without length, or one that begins elsewhere.
        """
        if not isinstance(parts, list | tuple) or not all(isinstance(part, JointPath) for part in parts):
            raise InvalidInputError("parts", parts, "a list of JointPath")
        if not parts or any(part.length < COINCIDENT for part in parts):
            raise InvalidInputError("parts", parts, f"at least one path, each with a length of at least {COINCIDENT:g}")
        ends = np.cumsum([0.0, *(part.length for part in parts)])
        ends /= ends[-1]
        degree = max(part.degree for part in parts)
        breaks = [a + (b - a) * part.breaks[1:] for a, b, part in zip(ends[:-1], ends[1:], parts, strict=True)]
        control = np.concatenate([raised(part.control, degree) for part in parts])
        return cls(breaks=np.concatenate([[0.0], *breaks[:-1], breaks[-1][:-1], [1.0]]), control=control)

    def backwards(self) -> "JointPath":
        """The same path from its goal to its start."""
        return JointPath(breaks=1 - self.breaks[::-1], control=self.control[::-1, ::-1])

    @property
    def n(self) -> int:
        """Number of joints."""
        return int(self.control.shape[2])

    @property
    def degree(self) -> int:
        """Polynomial degree of the pieces."""
        return int(self.control.shape[1] - 1)

    @property
    def start(self) -> Array:
        """q(0), (n,)."""
        return np.asarray(self.control[0, 0])

    @property
    def goal(self) -> Array:
        """q(1), (n,)."""
        return np.asarray(self.control[-1, -1])

    def __call__(self, s: ArrayLike, order: int = 0) -> Array:
        """q(s), or its derivative of the given order with respect to s; s (...) in [0, 1] gives (..., n)."""
        return self.curve(order)(s if type(s) is np.ndarray and s.dtype == np.float64 else number_array("s", s))

    def curve(self, order: int = 0) -> Curve:
        """The curve q(s), or its derivative of the given order with respect to s, for repeated evaluation."""
        if type(order) is not int or order not in self._curves:
            order = whole_number("order", order, least=0, most=MOST_ORDER)
        if order not in self._curves:
            self._curves[order] = self.curve(order - 1).derivative if order else Curve(self.breaks, self.control)
        return self._curves[order]

    @cached_property
    def _curves(self) -> dict[int, Curve]:
        return {}

    def coefficients(self, basis: str = "monomial") -> Array:
        """The coefficients (n, k + 1) of a path of one piece, c in q_i(s) = Σ_j c_ij f_j(s).

        Args:
            basis: "monomial": f_j = s^j, the a_ij of (6.14) and Table 6.3 in kth2012; "bernstein": the control points;
                "legendre" and "chebyshev": P_j(2s - 1) and T_j(2s - 1), as in NumPy's classes with domain=[0, 1].

        Raises:
            UnknownNameError: no such basis.
            InvalidInputError: the path has several pieces.
        """
        one_of("basis", basis, SERIES)
        if len(self.control) > 1:
            raise InvalidInputError("coefficients", f"a path of {len(self.control)} pieces", "a path of one piece")
        if basis == "bernstein":
            return np.array(self.control[0].T)
        if basis == "monomial":
            return np.array([_power_basis(joint) for joint in self.control[0].T])
        vandermonde = legendre.legvander if basis == "legendre" else chebyshev.chebvander
        x = -np.cos(np.linspace(0.0, np.pi, self.degree + 1))
        return np.asarray(np.linalg.solve(vandermonde(x, self.degree), self((x + 1) / 2)).T)

    @property
    def length(self) -> float:
        """Arc length in joint space, ∫ ‖q'‖ ds: (6.5) in kth2012."""
        s, weights = self.quadrature()
        return float(weights @ np.linalg.norm(self(s, 1), axis=1))

    def panel_edges(self, panels: int) -> Array:
        """Edges (k + 1,) of panels over [0, 1]: every piece is divided evenly, into about its share of `panels`."""
        panels, widths = whole_number("panels", panels, least=1, most=MOST_PANELS), np.diff(self.breaks)
        counts = np.maximum(1, np.ceil(panels * widths).astype(int))
        step = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
        return np.append(np.repeat(self.breaks[:-1], counts) + step * np.repeat(widths / counts, counts), 1.0)

    def quadrature(self, *, panels: int = 40, points: int = 10) -> tuple[Array, Array]:
        """Gauss points and weights over [0, 1], (m,) each; every piece is divided into about its share of `panels`."""
        nodes, weights = _gauss_points(whole_number("points", points, least=1, most=MOST_POINTS))
        edges = self.panel_edges(panels)
        half = np.diff(edges)[:, None] / 2
        middle = (edges[:-1] + edges[1:])[:, None] / 2
        return (middle + half * nodes).ravel(), (half * weights).ravel()

    def bounds(self) -> tuple[Array, Array]:
        """Smallest and largest value of each joint on the whole curve, (n,) and (n,), from the roots of q'."""
        low, high = self.control[:, [0, -1]].min(axis=(0, 1)), self.control[:, [0, -1]].max(axis=(0, 1))
        k = self.degree
        for piece in self.control:
            inside = (piece.min(axis=0) >= low) & (piece.max(axis=0) <= high)
            for joint in np.flatnonzero(~inside):
                roots = np.roots(_power_basis(np.diff(piece[:, joint]))[::-1])
                real = roots.real[(np.abs(roots.imag) < 1e-7) & (roots.real > 0) & (roots.real < 1)]
                values = bernstein(k, real) @ piece[:, joint]
                low[joint] = values.min(initial=low[joint])
                high[joint] = values.max(initial=high[joint])
        return low, high

    def fine_samples(self, step: float = 1e-3) -> Array:
        """Parameters s (m,) from 0 to 1; between neighbours no joint moves by more than `step` [rad or m]."""
        step, s = number("step", step, least=1e-9), np.linspace(0.0, 1.0, 2001)
        speed = np.abs(self(s, 1)).max(axis=1)
        gained = np.concatenate([[0.0], np.cumsum((speed[1:] + speed[:-1]) / 2 * np.diff(s))])
        gained += 1e-9 * gained[-1] * s  # strictly increasing even where the path stands still
        count = int(np.ceil(1.05 * gained[-1] / step)) + 2
        if count > MOST_SAMPLES:
            raise InvalidInputError(
                "step", step, f"a step of which the path needs at most {MOST_SAMPLES:,}; it needs {count:,}"
            )
        samples = np.interp(np.linspace(0.0, gained[-1], count), gained, s)
        while True:
            moved = np.abs(np.diff(self(samples), axis=0)).max(axis=1)
            wide = np.flatnonzero(moved > step)
            if not len(wide):
                return samples
            samples = np.insert(samples, wide + 1, (samples[wide] + samples[wide + 1]) / 2)


def split(control: Array, u: float = 0.5) -> tuple[Array, Array]:
    """Control points (..., k + 1, n) of the two parts of each curve, split at u by de Casteljau's algorithm."""
    left, right = [control[..., 0, :]], [control[..., -1, :]]
    while control.shape[-2] > 1:
        control = (1 - u) * control[..., :-1, :] + u * control[..., 1:, :]
        left.append(control[..., 0, :])
        right.append(control[..., -1, :])
    return np.stack(left, axis=-2), np.stack(right[::-1], axis=-2)


def raised(control: Array, degree: int) -> Array:
    """Control points (p, degree + 1, n) of the same pieces (p, k + 1, n) as polynomials of a degree of at least k."""
    while (k := control.shape[1] - 1) < degree:
        share = (np.arange(1, k + 1) / (k + 1))[:, None]
        inner = share * control[:, :-1] + (1 - share) * control[:, 1:]
        control = np.concatenate([control[:, :1], inner, control[:, -1:]], axis=1)
    return control


def cut(path: JointPath, begin: float, end: float) -> JointPath:
    """The part of a path between two parameters, over [0, 1]."""
    if begin <= 0.0 and end >= 1.0:
        return path
    first = int(np.clip(np.searchsorted(path.breaks, begin, side="right") - 1, 0, len(path.control) - 1))
    last = int(np.clip(np.searchsorted(path.breaks, end, side="left") - 1, first, len(path.control) - 1))
    control = path.control[first : last + 1].copy()
    breaks = np.concatenate([[begin], path.breaks[first + 1 : last + 1], [end]])
    low, high = path.breaks[last], path.breaks[last + 1]
    control[-1] = split(control[-1], (end - low) / (high - low))[0]
    low, high = path.breaks[first], (end if first == last else path.breaks[first + 1])
    control[0] = split(control[0], (begin - low) / (high - low))[1]
    breaks = (breaks - begin) / (end - begin)
    breaks[-1] = 1.0
    return JointPath(breaks=breaks, control=control)


def side_by_side(parts: Sequence[tuple[JointPath, Sequence[int]]], still: Array) -> JointPath:
    """Paths over the same s as one of all joints: each moves the joints of its indices, the others stay at `still` (n,)."""
    breaks = np.unique(np.concatenate([path.breaks for path, _ in parts]))
    breaks = breaks[np.append(True, np.diff(breaks) > BREAK_TOLERANCE)]
    breaks[-1] = 1.0
    degree = max(path.degree for path, _ in parts)
    control = np.tile(still, (len(breaks) - 1, degree + 1, 1))
    for path, joints in parts:
        for k, (begin, end) in enumerate(itertools.pairwise(breaks)):
            control[k][:, list(joints)] = raised(_piece(path, begin, end)[None], degree)[0]
    control[1:, 0] = control[:-1, -1]
    return JointPath(breaks=breaks, control=control)


def _piece(path: JointPath, begin: float, end: float) -> Array:
    """Control points (k + 1, n) of a part of a path that lies in one of its pieces."""
    k = int(np.clip(np.searchsorted(path.breaks, (begin + end) / 2) - 1, 0, len(path.control) - 1))
    low, high = path.breaks[k], path.breaks[k + 1]
    left = split(path.control[k], min((end - low) / (high - low), 1.0))[0]
    return split(left, max((begin - low) / (end - low), 0.0))[1]


@cache
def _gauss_points(count: int) -> tuple[Array, Array]:
    """Gauss points on [-1, 1] and their weights, (count,) each; read-only."""
    nodes, weights = legendre.leggauss(count)
    nodes.flags.writeable = weights.flags.writeable = False
    return nodes, weights


def _power_basis(control: Array) -> Array:
    """Coefficients, lowest power first, of a Bernstein polynomial (k + 1,)."""
    k = len(control) - 1
    return np.array([comb(k, j) * sum((-1) ** (j - i) * comb(j, i) * control[i] for i in range(j + 1)) for j in range(k + 1)])


#: Maximum reach of a rounded corner, as a share of the shorter of its two edges, and minimum reach [rad].
WIDEST = 0.45
LEAST = 1e-4


def rounded(waypoints: Array, is_free: Callable[[JointPath], bool]) -> JointPath:
    """A path of straight pieces and rounded corners, twice continuously differentiable in its arc length.

    Every corner starts as wide as its edges allow and is halved until `is_free` accepts it with its two edges. A corner
    that cannot even be rounded over `LEAST` stays sharp; the arm will stop there. `is_free` accepts the straight pieces between
    the waypoints (k, n).
    """
    if len(waypoints) == 2:
        return JointPath.through(waypoints)
    edges = np.linalg.norm(np.diff(waypoints, axis=0), axis=1)
    reach = WIDEST * np.minimum(edges[:-1], edges[1:])
    for i in range(len(reach)):
        while reach[i] > LEAST and not is_free(_path(waypoints[i : i + 3], reach[i : i + 1])):
            reach[i] /= 2
    reach[reach <= LEAST] = 0.0
    return _path(waypoints, reach)


def _path(waypoints: Array, reach: Array) -> JointPath:
    """Straight pieces and corners as quartic Bernstein pieces.

    A corner of reach b turns from direction u to v over the parameter length 2b: q' = u + (v - u)(3x² - 2x³), x in
    [0, 1], so q'' vanishes at both ends; since the mean of 3x² - 2x³ is 1/2 it ends at distance b after the corner.
    """
    directions = np.diff(waypoints, axis=0)
    edges = np.linalg.norm(directions, axis=1)
    directions = directions / edges[:, None]
    pieces, lengths = [], []
    position = waypoints[0]
    done = 0.0
    for i, edge in enumerate(edges):
        ahead = reach[i] if i < len(reach) else 0.0
        straight = edge - done - ahead
        if straight > 1e-12:
            end = waypoints[i + 1] - ahead * directions[i]
            pieces.append(position + np.linspace(0.0, 1.0, 5)[:, None] * (end - position))
            lengths.append(straight)
            position = end
        if ahead > 0:
            u, v = directions[i], directions[i + 1]
            # Bernstein coefficients of the integral of u + (v - u)(3x² - 2x³) from 0, times 2b
            steps = 2 * ahead * np.array([u, u, v, v]) / 4
            pieces.append(position + np.vstack([np.zeros_like(u), np.cumsum(steps, axis=0)]))
            lengths.append(2 * ahead)
            position = pieces[-1][-1]
        done = ahead
    breaks = np.concatenate([[0.0], np.cumsum(lengths)]) / np.sum(lengths)
    breaks[-1] = 1.0
    return JointPath(breaks=breaks, control=np.array(pieces))
