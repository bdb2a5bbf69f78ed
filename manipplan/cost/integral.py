"""The integral g = ∫ ‖θ'‖ / μ^p ds of kth2012 along a path, by adaptive quadrature, and the path's minimum manipulability.

With a floor ε it is ∫ ‖θ'‖ / (μ² + ε²)^(p/2) ds, which is finite on every path.

The metric W of joint space: the relative cost of moving each joint.

Integrals over quadrature panels, and the minimum manipulability, by `panels.c`, which calls the curve and the measure.
"""

import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from manipplan.kinematics.kinematics import Kinematics
from manipplan.paths.joint import MOST_PANELS, JointPath
from manipplan.paths.rounding import gauss_rule
from manipplan.support.checks import Array, ArrayLike, instance, number, number_array, whole_number
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError
from manipplan.support.kernels import load_kernel, struct

#: Minimum ratio of the smallest eigenvalue of W to the largest.
DEFINITE = 1e-12
#: Upper bound on the entries of W, so that their squares do not overflow.
LARGEST = 1e150
#: Minimum of the largest entry of W: speeds below 1e-9 count as none.
SMALLEST = 1e-12


def metric_matrix(argument: str, value: ArrayLike | None, n: int) -> Array | None:
    """`value`, weights (n,) > 0 or a symmetric positive definite matrix (n, n), as a read-only matrix; None stays None.

    Raises InvalidInputError for anything else.
    """
    if value is None:
        return None
    wanted = (
        f"{n} weights above zero, one per joint, or a symmetric positive definite matrix ({n}, {n}), finite, below {LARGEST:g},"
        f" with the largest entry at least {SMALLEST:g}"
    )
    matrix = number_array(argument, value)
    if matrix.shape == (n,):
        matrix = np.diag(matrix)
    if matrix.shape != (n, n) or not (np.abs(matrix) < LARGEST).all() or np.abs(matrix).max() < SMALLEST:
        raise InvalidInputError(argument, value, wanted)
    eigenvalues = np.linalg.eigvalsh((matrix + matrix.T) / 2)
    lopsided = np.abs(matrix - matrix.T).max() > 1e-9 * np.abs(matrix).max()
    if lopsided or eigenvalues[0] <= DEFINITE * eigenvalues[-1]:
        raise InvalidInputError(argument, value, wanted)
    matrix = (matrix + matrix.T) / 2
    matrix.flags.writeable = False
    return matrix


#: Maximum exponent of m.
MOST_POWER = 100.0
#: Manipulability below this share of the path's maximum counts as zero.
SINGULAR = 1e-9
#: A panel is halved while that changes its integral by more than this share of g.
ACCURACY = 1e-10
#: Maximum number of halvings.
HALVINGS = 25
#: If more than 2^NOISE times the initial number of panels still change, the integrand consists of rounding errors, and g counts
#: as infinite.
NOISE = 6
#: Gauss points per panel.
POINTS = 10
#: Number of intervals at whose ends m is sampled, and of its deepest dips that are searched.
INTERVALS, DEEPEST = 2000, 5
#: Number of successively finer grids around a dip, and of the intervals of each.
GRIDS, GRID_INTERVALS = 8, 40
#: Panels on which g is minimised: initial number, error per panel as a share of g on the path where a descent begins,
#: maximum number of halvings, and number of panels above which none is halved.
RULE_PANELS, RULE_ACCURACY, RULE_HALVINGS, MOST_RULE_PANELS = 12, 1e-9, 12, 200
#: The same for panels that follow each path of a descent: error per panel, and maximum number of halvings.
FINE_ACCURACY, FINE_HALVINGS = 1e-12, 20
#: Initial room for edges.
ROOM = 4096


@cache
def _calls() -> dict[str, Callable[..., Any]]:
    return load_kernel("panels").functions()


@dataclass(frozen=True, kw_only=True, eq=False)
class Panels:
    """The integral of one path on panels: `Integral` of panels.c, and the owners of what it refers to."""

    integral: ctypes.Structure
    owners: tuple[object, ...]

    @classmethod
    def of(cls, path: JointPath, kinematics: Kinematics, power: float = 1.0, floor: float = 0.0) -> "Panels | None":
        """The integral of a path with Euclidean speed; None where panels.c does not serve it."""
        curves, measure = load_kernel("curves"), kinematics.batch_code("manipulability")
        curve, slope = path.curve(), path.curve(1)
        compiled = curve.address and slope.address and power in (1, 2)
        if measure is None or not compiled:
            return None
        nodes, weights = gauss_rule(POINTS)
        integral = struct("panels", "Integral")(
            path=curve.address,
            slope=slope.address,
            evaluate=curves.address("curve"),
            measure=measure,
            n=path.n,
            points=POINTS,
            nodes=nodes.ctypes.data,
            weights=weights.ctypes.data,
            floor=floor,
            power=power,
        )
        return cls(integral=integral, owners=(curve, slope, curves, kinematics, nodes, weights))

    def integrals(self, begin: Array, end: Array) -> Array | None:
        """The integral over each panel from `begin` to `end` (k,); None where the measure cannot be evaluated."""
        begin, end, out = np.ascontiguousarray(begin), np.ascontiguousarray(end), np.empty(len(begin))
        arguments = (begin.ctypes.data, end.ctypes.data, len(begin), out.ctypes.data)
        return None if _calls()["panels"](ctypes.addressof(self.integral), *arguments) else out

    def fine_panels(self, edges: Array) -> Array | None:
        """As `PathIntegral.fine_panels`, from the first edges (k + 1,); None as above."""
        room = max(ROOM, len(edges))
        while True:
            found = np.empty(room)
            found[: len(edges)] = edges
            arguments = (ctypes.addressof(self.integral), found.ctypes.data, len(edges) - 1)
            count = _calls()["fine_panels"](*arguments, room, FINE_HALVINGS, FINE_ACCURACY)
            if count <= room:
                return np.sort(found[:count]) if count >= 0 else None
            room = count

    def whole(self, edges: Array, most: int) -> float | None:
        """The whole integral from panels between edges (k + 1,); inf where more than `most` still change, and None as above."""
        edges, out = np.ascontiguousarray(edges), np.empty(1)
        arguments = (ctypes.addressof(self.integral), edges.ctypes.data, len(edges) - 1)
        failed = _calls()["integral"](*arguments, most, HALVINGS, ACCURACY, out.ctypes.data)
        return None if failed else float(out[0])

    def minimum(self) -> tuple[float, float, float] | None:
        """As `_minimum_manipulability`; None where the measure cannot be evaluated."""
        out = np.empty(3)
        arguments = (ctypes.addressof(self.integral), INTERVALS, DEEPEST, GRIDS, GRID_INTERVALS, out.ctypes.data)
        if _calls()["minimum"](*arguments):
            return None
        least, at, largest = out.tolist()
        return least, at, largest


@one_line
@dataclass(frozen=True, kw_only=True)
class PathCost:
    """g and the minimum manipulability of one path.

    Attributes:
        g: ∫ ‖q'‖_W / (m² + floor²)^(p/2) ds, (6.6) in kth2012 for floor 0; then inf when the path meets a singularity.
        length: ∫ ‖q'‖ ds [rad], (6.5), without W.
        min_manipulability: the minimum of m, found on successively finer grids around its dips.
        at: the parameter s where m has its minimum.
    """

    g: float
    length: float
    min_manipulability: float
    at: float


@dataclass(frozen=True, kw_only=True, eq=False)
class PathIntegral:
    """The integral g = ∫ ‖q'‖_W / (m² + floor²)^(p/2) ds of one arm.

    Attributes:
        kinematics: provides the measure m.
        power: p > 0.
        floor: ε >= 0, in the unit of m.
        metric: W (n, n), symmetric and positive definite; None: the identity.
    """

    kinematics: Kinematics
    power: float
    floor: float = 0.0
    metric: Array | None = None

    def cost(self, path: JointPath, panels: int = 40) -> PathCost:
        """g and the minimum manipulability of a path, as in `path_cost`."""
        least, at, largest = _minimum_manipulability(path, self.kinematics)
        # a singularity, which Gauss points can miss, makes the integral diverge for p >= 1
        singular = self.power >= 1 and self.floor == 0 and least <= SINGULAR * largest
        g = np.inf if singular else self._whole(path, path.panel_edges(panels))
        return PathCost(g=g, length=path.length, min_manipulability=least, at=at)

    def panel_edges(self, path: JointPath, edges: Array | None = None) -> Array:
        """Edges (k + 1,) of quadrature panels for the descent from a path, narrow where m has a dip.

        A panel is halved, together with its two neighbours, until its two halves change its integral by at most
        RULE_ACCURACY of g. Halving starts from `edges`, such as those of other paths; default: RULE_PANELS of equal width,
        split at the breaks of the path. With more than MOST_RULE_PANELS panels it stops.
        """
        edges = _first_edges(path) if edges is None else edges
        return self._refined(path, edges, RULE_ACCURACY, RULE_HALVINGS, most=MOST_RULE_PANELS, widens=True)[1]

    def fine_panels(self, path: JointPath) -> Array:
        """Edges (k + 1,) of panels for this path alone, halved until that changes each by at most FINE_ACCURACY of g.

        Where it is compiled, this can be done for every path of a descent.
        """
        edges, panels = _first_edges(path), self._panels(path)
        found = None if panels is None else panels.fine_panels(edges)
        return self._refined(path, edges, FINE_ACCURACY, FINE_HALVINGS)[1] if found is None else found

    def on_panels(self, path: JointPath, edges: Array) -> float:
        """g of a path from the Gauss points of the panels between edges (k + 1,)."""
        return float(self._integrals(path, edges[:-1], edges[1:]).sum())

    def _whole(self, path: JointPath, edges: Array) -> float:
        """g to ACCURACY by halving panels: a dip of m can be a thousand times narrower than an initial panel.

        Infinite if m consists of rounding errors, as on a path that is singular everywhere. A dip needs only a few narrow
        panels; rounding errors need them everywhere.
        """
        panels, most = self._panels(path), (len(edges) - 1) * 2**NOISE
        found = None if panels is None else panels.whole(edges, most)
        if found is not None:
            return found
        return self._refined(path, edges, ACCURACY, HALVINGS, most=most)[0]

    def _refined(
        self, path: JointPath, edges: Array, accuracy: float, halvings: int, *, most: float = np.inf, widens: bool = False
    ) -> tuple[float, Array]:
        """g of a path, and the edges (k + 1,) of panels, halved until that changes each by at most the share `accuracy` of g.

        Args:
            path, edges: the path, and the first panels.
            accuracy, halvings: that share, and the maximum number of halvings of a panel.
            most: number of panels above which none is halved; without `widens` of those that still change, which makes g
                infinite.
            widens: both neighbours of a panel are halved as well, since a dip of m moves with the path; so every panel counts
                again after each halving.
        """
        begin, end, done, settled = edges[:-1], edges[1:], [edges], 0.0
        whole = self._integrals(path, begin, end)
        for _ in range(halvings):
            middle = (begin + end) / 2
            first, last = np.stack([begin, middle], axis=1), np.stack([middle, end], axis=1)
            parts = self._integrals(path, first.ravel(), last.ravel()).reshape(-1, 2)
            both = parts.sum(axis=1)
            with np.errstate(invalid="ignore"):  # they are infinite where m vanishes at a Gauss point
                rough = ~(np.abs(whole - both) <= accuracy * (settled + both[np.isfinite(both)].sum()))
            if widens:
                if not rough.any() or len(whole) >= most:
                    break
                rough[1:] |= rough[:-1].copy()
                rough[:-1] |= rough[1:].copy()
                columns = np.stack([np.ones_like(rough), rough], axis=1)
                old = zip((first, last, parts), (begin, end, whole), strict=True)
                begin, end, whole = (np.where(rough[:, None], halves, each[:, None])[columns] for halves, each in old)
            else:
                settled += float(both[~rough].sum())
                begin, end, whole = first[rough].ravel(), last[rough].ravel(), parts[rough].ravel()
                if not len(whole):
                    break
                if len(whole) > most:
                    return np.inf, edges
            done.append(middle[rough])
        return settled + float(whole.sum()), np.sort(np.concatenate(done))

    def _integrals(self, path: JointPath, begin: Array, end: Array) -> Array:
        """The integral over each panel from `begin` to `end` (k,)."""
        panels = self._panels(path)
        found = None if panels is None else panels.integrals(begin, end)
        if found is not None:
            return found
        s, weights = gauss(begin, end)
        return np.asarray((weights * self._density(path, s.ravel()).reshape(s.shape)).sum(axis=1))

    def _panels(self, path: JointPath) -> Panels | None:
        """The integral of a path by compiled code; None where there is none."""
        return Panels.of(path, self.kinematics, self.power, self.floor) if self.metric is None else None

    def _density(self, path: JointPath, s: Array) -> Array:
        """h = ‖q'‖_W / (m² + ε²)^(p/2) at s (m,), whose integral is g; inf at a singular configuration without a floor."""
        m = self.kinematics.manipulability(path(s))
        with np.errstate(divide="ignore"):
            return np.asarray(speeds(path(s, 1), self.metric) / np.hypot(m, self.floor) ** self.power)

    def constant_speed(self, path: JointPath, count: int) -> Array:
        """Parameters s (count,) that divide a path into parts of equal g, or of equal length where m is mostly zero."""
        s = np.linspace(0.0, 1.0, 1001)
        density = self._density(path, s)
        median = np.median(density)
        # capped, so that the parameters do not all cluster near a singularity
        density = np.minimum(density, 1e3 * median) if np.isfinite(median) else speeds(path(s, 1), self.metric)
        gained = np.concatenate([[0.0], np.cumsum((density[1:] + density[:-1]) / 2)])
        return np.interp(np.linspace(0.0, gained[-1], count), gained, s)


def _first_edges(path: JointPath) -> Array:
    """Edges of RULE_PANELS panels of equal width, split at the breaks of a path."""
    return np.unique(np.concatenate([np.linspace(0.0, 1.0, RULE_PANELS + 1), path.breaks]))


def gauss(begin: Array, end: Array) -> tuple[Array, Array]:
    """Gauss points and weights (k, POINTS) of the panels from `begin` to `end` (k,)."""
    nodes, weights = gauss_rule(POINTS)
    half = (end - begin)[:, None] / 2
    return np.clip(begin[:, None] + half * (1 + nodes), 0.0, 1.0), half * weights


def speeds(v: Array, metric: Array | None) -> Array:
    """‖v‖_W = sqrt(vᵀ W v) of rows v (m, n), (m,); Euclidean for None."""
    if metric is None:
        return np.asarray(np.linalg.norm(v, axis=1))
    return np.asarray(np.sqrt(np.einsum("mi,ij,mj->m", v, metric, v)))


def path_cost(
    path: JointPath,
    kinematics: Kinematics,
    power: float,
    *,
    floor: float = 0.0,
    metric: ArrayLike | None = None,
    panels: int = 40,
) -> PathCost:
    """Compute g and the minimum manipulability of a path.

    g is integrated on panels of ten Gauss points, which are halved as long as that changes g.

    Args:
        path: the path.
        kinematics: provides the measure.
        power: exponent of the measure.
        floor: ε in (m² + ε²)^(power / 2), in the unit of the measure. `result.floor` is that of a result's g.
        metric: W in ‖q'‖_W, weights (n,) or a matrix (n, n); None: the identity.
        panels: initial number of panels.

    Raises:
        InvalidInputError: an argument is of another kind or out of its range, or `metric` is not a metric.
    """
    n = instance("kinematics", kinematics, Kinematics).robot.n
    if instance("path", path, JointPath).n != n:
        raise InvalidInputError("path", f"a path of {path.n} joints", f"a path of the robot's {n} joints")
    power, panels = (
        number("power", power, above=0.0, most=MOST_POWER),
        whole_number("panels", panels, least=1, most=MOST_PANELS),
    )
    matrix = metric_matrix("metric", metric, path.n)
    integral = PathIntegral(kinematics=kinematics, power=power, floor=number("floor", floor, least=0.0), metric=matrix)
    return integral.cost(path, panels)


def _minimum_manipulability(path: JointPath, kinematics: Kinematics) -> tuple[float, float, float]:
    """The minimum manipulability, its s, and the maximum. The deepest dips are searched on successively finer grids.

    Where a path crosses a singularity, m has a sharp kink, which no fixed grid would hit.
    """
    panels = Panels.of(path, kinematics)
    if panels is not None and (found := panels.minimum()) is not None:
        return found
    s = np.linspace(0.0, 1.0, INTERVALS + 1)
    values = kinematics.manipulability(path(s))
    padded = np.concatenate([[np.inf], values, [np.inf]])
    dips = np.flatnonzero((values <= padded[:-2]) & (values <= padded[2:]))
    least, at = np.inf, 0.0
    deepest = dips[np.argsort(values[dips])[:DEEPEST]]
    low, high = s[np.maximum(deepest - 1, 0)], s[np.minimum(deepest + 1, INTERVALS)]
    for _ in range(GRIDS):
        grid = np.linspace(low, high, GRID_INTERVALS + 1)  # one column per dip
        inside = kinematics.manipulability(path(grid))
        lowest, dip = inside.argmin(axis=0), np.arange(len(deepest))
        column = int(inside[lowest, dip].argmin())
        if inside[lowest[column], column] < least:
            least, at = float(inside[lowest[column], column]), float(grid[lowest[column], column])
        low, high = grid[np.maximum(lowest - 1, 0), dip], grid[np.minimum(lowest + 1, GRID_INTERVALS), dip]
    return least, at, float(values.max())
