"""Models for one step of a descent: a quadratic model of g, and linear rows for the distances around the path."""

from collections.abc import Sequence
from dataclasses import dataclass, field, fields, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from manipplan.collision.bottoms import DipSearch
from manipplan.collision.model import CollisionModel
from manipplan.collision.near_pairs import NearPairs
from manipplan.collision.witnesses import Witnesses
from manipplan.cost.density import Density
from manipplan.cost.integral import PathIntegral, gauss
from manipplan.optimize.clearance import Place, columns, distance_profile
from manipplan.paths.basis import Basis
from manipplan.paths.joint import JointPath
from manipplan.paths.rounding import configurations, product
from manipplan.support.checks import Array
from manipplan.symbolic.batch_function import BatchFunction

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

    def at(self, s: Array, order: int = 0) -> tuple[Array, Array]:
        """At s (m,) the curve of z = 0 (m, n), or its derivative of order 1, and its change with z (m, f) for each joint."""
        values = self.basis.values(s, order)
        straight = self.start + s[:, None] * (self.goal - self.start) if order == 0 else self.goal - self.start
        return straight + product(values, self.kept.T), product(values, self.directions)


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

    def _points(self, z: Array) -> tuple[Array, Array, Array]:
        """Arguments of the density at the Gauss points: q and q' (m, n), and the pace, p and ε (m, 3)."""
        line, slope, values, slopes = self._values
        numbers = np.tile([self.pace, self.power, self.floor], (len(self.s), 1))
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
            curves = self.curves
            edges = self.integral.fine_panels(curves.basis.path(curves.start, curves.goal, curves.coefficients(z)))
            s, weights = gauss(edges[:-1], edges[1:])
            fixed = {each.name: getattr(self, each.name) for each in fields(LengthModel)}
            self._last.clear()
            self._last[key] = LengthModel(**fixed | {"edges": edges, "s": s.ravel(), "weights": weights.ravel()})
        return self._last[key]

    def value(self, z: Array) -> float:
        return self.at(z).value(z)

    def gradient(self, z: Array) -> Array:
        return self.at(z).gradient(z)

    def hessian(self, z: Array) -> Array:
        return self.at(z).hessian(z)


#: Number of intervals of the grid along the path. A band of rows around the path is only kept at every SPACING-th place.
INTERVALS, SPACING = 160, 4
#: Margin kept beyond the required distance, so that the proof, whose bounds are not exact, succeeds [m].
MARGIN = 5e-5
#: Distance above the target at which distances are cut off [m]; at every SPACING-th place a wider band of rows raises it.
FARTHEST = 0.03
#: Distance above the target below which dips are located [m].
DEEP = 1e-3
#: Distance above the target below which every place of the grid gets a row [m].
CLOSE = 2e-3
#: Minimum distance in s between a place of the grid with a row and the bottom of a dip of the same pair.
APART = 1e-2
#: Maximum number of places with rows: bottoms of dips first, then the nearest.
MOST_PLACES = 80
#: Joint step of the finite differences for second derivatives of a distance [rad or m].
JOINT_STEP = 1e-4


@dataclass(frozen=True, kw_only=True)
class Look:
    """Distances measured on one path, the smallest first; (k,) each.

    Attributes:
        distances: signed distances [m].
        s: places on the path.
        pairs: indices of the pairs.
        is_bottom: whether the distance has a minimum along the path there.
    """

    distances: Array
    s: Array
    pairs: NDArray[np.intp]
    is_bottom: NDArray[np.bool_]

    @classmethod
    def of(cls, *found: "Look") -> "Look":
        """All that was found, in order."""
        distances, s, pairs, is_bottom = (
            np.concatenate([np.empty(0, dtype=kind), *(getattr(each, name) for each in found)])
            for name, kind in (("distances", float), ("s", float), ("pairs", np.intp), ("is_bottom", bool))
        )
        order = np.lexsort((is_bottom, pairs, s, distances))
        return cls(distances=distances[order], s=s[order], pairs=pairs[order], is_bottom=is_bottom[order])

    @property
    def least(self) -> float:
        """The smallest distance [m]; inf where nothing is near."""
        return float(self.distances.min(initial=np.inf))


@dataclass(kw_only=True, eq=False)
class Surroundings:
    """Distances on paths that differ little from each other.

    Attributes:
        model: the arm among its obstacles.
        clearance: required distance [m].
        margin: margin kept beyond the required distance [m]; larger at first, as corners are rounder at a distance.
        always: places (s, pair) around which every path is searched for a dip, such as those where a proof failed.
    """

    model: CollisionModel
    clearance: float
    margin: float = MARGIN
    always: list[Place] = field(default_factory=list)

    @cached_property
    def _search(self) -> DipSearch:
        return DipSearch(model=self.model)

    @property
    def target(self) -> float:
        """The distance to keep [m]: the required one plus the margin."""
        return self.clearance + self.margin

    def look(self, path: JointPath, band: float) -> Look:
        """Places where a pair is near.

        These are the places of the grid nearer than the target plus CLOSE, every SPACING-th place nearer than the target plus
        `band` [m], and the bottoms of dips.
        """
        s = np.linspace(0.0, 1.0, INTERVALS + 1)
        q = configurations(path, s)
        reach = np.full(len(s), self.target + FARTHEST)
        reach[::SPACING] = self.target + max(band, FARTHEST)
        profile = distance_profile(self.model, q, reach)
        wanted = profile.distances < self.target + CLOSE
        wanted |= (profile.rows % SPACING == 0) & (profile.distances < self.target + band)
        near = Look(
            distances=profile.distances[wanted],
            s=s[profile.rows[wanted]],
            pairs=profile.pairs[wanted],
            is_bottom=np.zeros(int(wanted.sum()), dtype=bool),
        )
        found = [near, self._dips(path, s, profile)]
        if self.always:
            at, known = np.array([x for x, _ in self.always]), np.array([pair for _, pair in self.always])
            bracket = np.maximum(at - 1 / INTERVALS, 0.0), np.minimum(at + 1 / INTERVALS, 1.0)
            found.append(self._bottoms(path, bracket, at, self._search.distances(path, at, known), known))
        return Look.of(*found)

    def places(self, look: Look) -> list[tuple[float, int, bool]]:
        """The places of a look that get rows, bottoms of dips first: s, pair, and whether it is such a bottom."""
        bottoms, others = np.flatnonzero(look.is_bottom), np.flatnonzero(~look.is_bottom)
        beside = np.abs(look.s[others, None] - look.s[bottoms]) < APART
        alone = others[~((look.pairs[others, None] == look.pairs[bottoms]) & beside).any(axis=1)]
        chosen = np.concatenate([bottoms, alone])[:MOST_PLACES]
        return list(zip(look.s[chosen].tolist(), look.pairs[chosen].tolist(), look.is_bottom[chosen].tolist(), strict=True))

    def rows(self, found: Witnesses) -> Array:
        """The clearance rows (m, column_height(n)) of witnesses, each with the plane through the second body's point."""
        first, second = found.joints.T
        distances = found.radii[:, 0] + self.target
        return columns(self.model.robot.n, first, found.points, second, found.normals, found.offsets, distances)

    def reversed_rows(self, found: Witnesses) -> Array:
        """As `rows`, with planes on the first bodies: better where a corner of the second faces a side of the first."""
        first, second = found.joints.T
        offsets, distances = (found.opposites * found.points).sum(axis=1) + found.radii[:, 0], found.radii[:, 1] + self.target
        return columns(self.model.robot.n, second, found.others, first, found.opposites, offsets, distances)

    def bends(self, q: Array, pairs: Sequence[int]) -> tuple[Array, Array]:
        """Gradients (m, n) and Hessians (m, n, n) of the distances of pairs (m,) at q (m, n).

        The Hessians are differences of gradients.
        """
        m, n = q.shape
        moved = np.concatenate([q[:, None], q[:, None] + JOINT_STEP * np.eye(n)], axis=1)
        found = self.model.witnesses(moved.reshape(-1, n), np.repeat(pairs, n + 1))
        gradients = found.gradients.reshape(m, n + 1, n)
        hessians = (gradients[:, 1:] - gradients[:, :1]) / JOINT_STEP
        return gradients[:, 0], (hessians + hessians.transpose(0, 2, 1)) / 2

    def _dips(self, path: JointPath, s: Array, profile: NearPairs) -> Look:
        """The bottom of every dip of a profile that may be near the target."""
        most = self.target + FARTHEST
        before, after = (np.where(np.isfinite(side), np.minimum(side, most), side) for side in profile.beside(most))
        here, sides = np.minimum(profile.distances, most), np.stack([before, after])
        # a dip between places is rarely further below its middle than the higher side is above it
        rise = np.where(np.isfinite(sides), sides, -np.inf).max(axis=0) - here
        dip = (before >= here) & (after > here) & (here - rise < self.target + DEEP)
        k, pairs = profile.rows[dip], profile.pairs[dip]
        bracket = s[np.maximum(k - 1, 0)], s[np.minimum(k + 1, INTERVALS)]
        # what is cut off is measured; at an end of the path the bracket ends at the dip itself
        left, right = (
            np.where(at == s[k], here[dip], np.where(side < most, side, np.nan))
            for at, side in zip(bracket, sides[:, dip], strict=True)
        )
        return self._bottoms(path, bracket, s[k], here[dip], pairs, (left, right))

    def _bottoms(
        self,
        path: JointPath,
        bracket: tuple[Array, Array],
        middle: Array,
        least: Array,
        pairs: NDArray[np.intp],
        sides: tuple[Array, Array] | None = None,
    ) -> Look:
        """Where pairs (k,) are nearest inside brackets (k,) in s, around places with known distances [m].

        `sides` are the distances at the ends of the brackets; nan where they are not known.
        """
        at, distances = self._search.bottoms(path, bracket, middle, least, pairs, sides=sides)
        return Look(distances=distances, s=at, pairs=pairs, is_bottom=np.ones(len(pairs), dtype=bool))
