"""Demands of motion along a path on the joints, tightening of limits that a motion exceeds, and the fastest speed by toppra.

At each grid point the demands are rows that are linear in x = (dl/dt)² and u = d²l/dt². Acceleration is t u + κ x with tangent
t = dq/dl and curvature κ = d²q/dl²; torque is M t u + (M κ + C) x + g. Rows are divided by their limit, so each has to stay in
[-1, 1]. Lengths are shares of the piece's length, and the unit of time makes the largest row of acceleration one, so that tiny
and huge paths give the solver the same problem.

A path between two stops as a function of its length l: q(l), tangents, curvature, and a grid along it. The length is that of
the joint path, or that of the tool's way: then a constant speed of the tool is a constant dl/dt, however the joints turn.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np
import pinocchio as pin

from manipplan.paths.joint import JointPath
from manipplan.paths.rounding import gauss_rule
from manipplan.support.checks import Array
from manipplan.support.deadline import building
from manipplan.support.display import round_down
from manipplan.support.errors import InvalidInputError, PlanningError
from manipplan.timing.stops import Bounds, LimitsAlong, ToolSpeed

#: Share by which ‖q'‖ jumps where it does not count as continuous, and minimum number of nodes between two such jumps.
JUMP, EACH = 1e-6, 60
#: Relative error of dl/ds above which an interval between nodes is halved, and maximum number of times.
SLOPE, ROUNDS = 1e-6, 5
#: Minimum number of nodes per polynomial piece: a sharp bend may be a short piece of a long path.
PER_PIECE = 24
#: Number of samples that tell where the path turns: a thousand per piece up to the first number, at least the second per piece.
MOST_SAMPLES, EACH_SAMPLES = 200_000, 20
#: Grid points closer to a break than this share of the mean grid spacing are dropped.
BESIDE = 0.1


class ArcLength:
    """The path from s = a to s = b as q(l): a geometric path in toppra's terms.

    l is the arc length in joint space, where the tangent is a unit vector; with a `tool`, the length of the tool's way.
    """

    def __init__(self, path: JointPath, a: float, b: float, tool: ToolSpeed | None = None) -> None:
        with building():
            from scipy.interpolate import CubicSpline, PPoly

        self.path, self._tool = path, tool
        #: where polynomial pieces begin or end, between the ends
        self.breaks = path.breaks[np.searchsorted(path.breaks, a, side="right") : np.searchsorted(path.breaks, b)]
        pieces = 1 + len(self.breaks)
        nodes_along = max(1200, 12 * pieces)
        self._samples = max(4000, min(1000 * pieces, MOST_SAMPLES), EACH_SAMPLES * pieces)
        ends = np.concatenate([[a], _jumps(path, self.breaks), [b]])
        at, splines = [0.0], []
        for begin, end in pairwise(ends):
            inside = np.searchsorted(self.breaks, end) - np.searchsorted(self.breaks, begin, side="right")
            count = max(EACH, PER_PIECE * (1 + int(inside)), int(np.ceil(nodes_along * (end - begin) / (b - a))))
            # dense near the ends, where a path may start from q' = 0
            s = begin + (end - begin) * (1 - np.cos(np.linspace(0.0, np.pi, count + 1))) / 2
            ways = self._way(s[:-1], s[1:])
            for rounds in range(ROUNDS + 1):
                length = at[-1] + np.concatenate([[0.0], np.cumsum(ways)])
                rises = np.concatenate([[True], np.diff(length) > 1e-14 * length[-1]])
                rises[-1] = True
                spline = CubicSpline(length[rises], s[rises])
                between = (length[1:] + length[:-1]) / 2
                coarse = np.abs(spline(between, 1) * self.rate(spline(between)) - 1) > SLOPE
                if rounds == ROUNDS or not rises.all() or not coarse.any():
                    break
                middle = (s[1:] + s[:-1])[coarse] / 2
                halves = self._way(s[:-1][coarse], middle), self._way(middle, s[1:][coarse])
                k = np.flatnonzero(coarse)
                ways[k] = halves[1]
                ways, s = np.insert(ways, k, halves[0]), np.insert(s, k + 1, middle)
            splines.append(spline)
            at += length[rises][1:].tolist()
        self.length = at[-1]
        self._at = np.array(at)
        self._s = PPoly(np.concatenate([each.c for each in splines], axis=1), self._at)
        self.ends = (a, b)
        # derivatives are evaluated slightly inside, since q' may vanish at the ends
        margin = 1e-6 * (b - a)
        self._inside = (a + margin, b - margin)
        self._shares: dict[int, tuple[Array, Array]] = {}

    def _way(self, begin: Array, end: Array) -> Array:
        """Lengths (k,) from path parameters to others (k,) close by."""
        nodes, weights = gauss_rule(6)
        half = (end - begin) / 2
        s = (begin + end)[:, None] / 2 + half[:, None] * nodes
        return np.asarray(half * (self.rate(s.ravel()).reshape(s.shape) @ weights))

    def s(self, length: Array) -> Array:
        """Path parameter at lengths."""
        return np.asarray(np.clip(self._s(length), *self.ends))

    def rate(self, s: Array) -> Array:
        """dl/ds at path parameters (k,): ‖q'‖, or ‖J q'‖ with the tool's Jacobian J."""
        first = self.path(s, 1)
        return np.maximum(_norms(first) if self._tool is None else self._tool(self.path(s), first), 1e-300)

    def q(self, length: Array) -> Array:
        """Configurations (k, n) at lengths (k,)."""
        return self.path(self.s(length))

    def tangent(self, length: Array) -> Array:
        """dq/dl."""
        s = np.clip(self.s(length), *self._inside)
        return np.asarray(self.path(s, 1) / self.rate(s)[:, None])

    def bends(self, s: Array) -> tuple[Array, Array]:
        """Tangents t = dq/dl and curvatures d²q/dl² = (q'' - l'' t) / l'² at path parameters (k,), (k, n) each."""
        s = np.clip(s, *self._inside)
        first, second = self.path(s, 1), self.path(s, 2)
        rate = self.rate(s)
        if self._tool is None:
            grows = np.einsum("ij,ij->i", first, second) / rate
        else:
            grows = self._tool.rises(self.path(s), first, second)
        tangent = first / rate[:, None]
        return tangent, (second - grows[:, None] * tangent) / rate[:, None] ** 2

    def lengths_of(self, s: Array) -> Array:
        """Lengths at which the path parameter is s, for each s strictly between the ends."""
        s = s[(s > self.ends[0]) & (s < self.ends[1])]
        if not len(s):
            return s
        even = np.linspace(0, self.length, 4001)
        length = np.interp(s, self.s(even), even)
        for _ in range(3):
            length += (s - self.s(length)) * self.rate(s)
            length = np.clip(length, 0.0, self.length)
        return np.asarray(length)

    def grid(self, count: int, edges: Array) -> Array:
        """About `count` + 1 lengths from 0 to the end, evenly spaced, but twice as dense where the path turns at its mean rate.

        They include the ends of the polynomial pieces, where the curvature may jump, and `edges` (path parameters), where
        limits change.
        """
        return self._mark_breaks(self._even(count, max(4000, 10 * count)), edges)

    def fine(self, count: int) -> Array:
        """The same without edges, for `count` far above what is needed to tell where the path turns."""
        return self._mark_breaks(self._even(count, self._samples), np.empty(0))

    def _mark_breaks(self, points: Array, edges: Array) -> Array:
        """The points, and breaks and edges instead of those close to them."""
        marks = self.lengths_of(np.union1d(self.breaks, edges))
        if len(marks):  # a motion would pass points very close to a mark in less time than samples resolve
            beside = np.abs(points[:, None] - marks).min(axis=1) < BESIDE * self.length / (len(points) - 1)
            beside[[0, -1]] = False
            points = np.union1d(points[~beside], marks)
        points = points[np.concatenate([[True], np.diff(points) > 1e-7 * self.length])]
        points[-1] = self.length
        return np.asarray(points)

    def _even(self, count: int, samples: int) -> Array:
        if samples not in self._shares:
            self._shares[samples] = self._measure(samples)
        share, length = self._shares[samples]
        points = np.asarray(np.interp(np.linspace(share[0], share[-1], count + 1), share, length), dtype=float)
        points[0], points[-1] = 0.0, self.length
        return points

    def _measure(self, samples: int) -> tuple[Array, Array]:
        """The sum of the shares of length and turn up to each of the samples, in which a grid is even, and lengths there."""
        s = np.linspace(*self._inside, samples)
        tangent = self.path(s, 1)
        pace = np.maximum(_norms(tangent), 1e-300)
        tangent /= pace[:, None]
        turned = np.concatenate([[0.0], np.cumsum(_norms(np.diff(tangent, axis=0)))])
        length = np.interp(s, self._s(self._at), self._at)
        share = length / self.length + turned / max(turned[-1], 0.1)
        if self._tool is not None:  # the joints may move far while the tool hardly does
            share += np.cumsum(pace) / pace.sum()
        return share, length


def _jumps(path: JointPath, breaks: Array) -> Array:
    """The inner breaks at which ‖q'‖ jumps, as where two paths were joined: the parameter has a kink there over the length."""
    at = np.searchsorted(path.breaks, breaks)
    before, after = path.control[at - 1], path.control[at]
    last = _norms(before[:, -1] - before[:, -2]) / (breaks - path.breaks[at - 1])
    first = _norms(after[:, 1] - after[:, 0]) / (path.breaks[at + 1] - breaks)
    return np.asarray(breaks[np.abs(last - first) > JUMP * np.maximum(last, first)])


def _norms(vectors: Array) -> Array:
    """Euclidean norms of vectors (..., n), (...)."""
    return np.asarray(np.sqrt(np.einsum("...i,...i->...", vectors, vectors)))


#: Distance in s by which segments are extended, so that grid points at their ends are inside.
AT_EDGE = 1e-7
#: Effort limit used in place of an infinite one; it makes the torque rows practically zero.
NO_EFFORT = 1e12


@dataclass(frozen=True, kw_only=True, eq=False)
class PathDynamics:
    """Demand rows at k grid points of a piece of path.

    Attributes:
        curve: the piece as a function of its arc length.
        length: (k,) grid points [rad or m].
        time_unit: unit of time [s]; the unit of length is the length of the piece.
        tangent, curvature: (k, n) in these units.
        bounds: limits at the grid points.
        fastest: (k,) largest x within the limits of velocity and tool speed.
        u, x, constant: (k, r) rows: |u row · u + x row · x + constant| <= 1; n of acceleration, then n of torque with a
            torque model.
    """

    curve: ArcLength
    length: Array
    time_unit: float
    tangent: Array
    curvature: Array
    bounds: Bounds
    fastest: Array
    u: Array
    x: Array
    constant: Array

    @property
    def at(self) -> Array:
        """Grid points as shares of the length (k,)."""
        return self.length / self.curve.length

    @property
    def speed_unit(self) -> float:
        """Unit of dl/dt [rad/s]."""
        return self.curve.length / self.time_unit

    def eased(self, velocity: Array, rows: Array) -> "PathDynamics":
        """A copy with tighter limits: velocity and rows are divided by factors (k,) >= 1 per grid point."""
        # the constant part (gravity) is not scaled, only the room that it leaves
        room = 1 / rows[:, None]
        left = np.maximum(room - np.abs(self.constant), 1e-3 * (1 - np.abs(self.constant)))
        share = np.where(self.constant == 0, rows[:, None], (1 - np.abs(self.constant)) / left)
        return replace(self, fastest=self.fastest / velocity**2, u=self.u * share, x=self.x * share)


def path_dynamics(
    curve: ArcLength, length: Array, limits: LimitsAlong, torque_model: pin.Model | None, tool: ToolSpeed | None
) -> PathDynamics:
    """The demand rows at the grid points `length` (k,) of a piece."""
    s = curve.s(length)
    tangent, curvature = curve.bends(s)
    bounds = limits.at(s, around=AT_EDGE)
    time_unit = float(np.sqrt(curve.length * (np.abs(tangent) / bounds.acceleration).max()))
    q = curve.path(s) if torque_model is not None or tool is not None else np.empty(0)
    with np.errstate(divide="ignore"):
        speed = (bounds.velocity / np.abs(tangent)).min(axis=1)
        if tool is not None:
            speed = np.minimum(speed, bounds.tool_speed / tool(q, tangent))
    u, x = tangent / bounds.acceleration, curvature / bounds.acceleration
    constant = np.zeros_like(u)
    if torque_model is not None:
        data, still = torque_model.createData(), np.zeros(torque_model.nv)
        rows = np.array(
            [
                [pin.rnea(torque_model, data, *state).copy() for state in ((a, still, still), (a, still, b), (a, b, c))]
                for a, b, c in zip(q, tangent, curvature, strict=True)
            ]
        )
        effort = np.minimum(bounds.effort, NO_EFFORT)
        gravity = rows[:, 0] / effort
        u, x = np.hstack([u, rows[:, 1] / effort - gravity]), np.hstack([x, rows[:, 2] / effort - gravity])
        constant = np.hstack([constant, gravity])
    size = curve.length
    return PathDynamics(
        curve=curve,
        length=length,
        time_unit=time_unit,
        tangent=tangent * size,
        curvature=curvature * size**2,
        bounds=bounds,
        fastest=(speed * time_unit / size) ** 2,
        u=u * size / time_unit**2,
        x=x * size**2 / time_unit**2,
        constant=constant,
    )


Use = Mapping[str, Array]


class LimitTightening:
    """Factors by which limits are tightened over rounds of solving: at grid points (k,), and for jerk between them.

    Factors are at least 1. That of velocity at an end with a given speed stays 1.
    """

    def __init__(self, count: int, given: tuple[bool, bool]) -> None:
        self.rounds = 0
        self.jerk = np.ones(count - 1)
        self._velocity, self._rows = np.ones(count), np.ones(count)
        self._given = given

    def of(self, demands: PathDynamics) -> PathDynamics:
        """The demands with limits tightened by these factors."""
        return demands.eased(self._velocity, self._rows) if self.rounds else demands

    def tighten(self, use: Use) -> None:
        """Tighten limits where a motion exceeds them; `use` holds demand over limit on each of its pieces."""
        margin = 1 + 1e-7 * 4.0 ** min(self.rounds, 7)  # neighbouring intervals affect each other
        for factors, kinds in ((self._velocity, ("velocity", "tool speed")), (self._rows, ("acceleration", "torque"))):
            for kind in kinds:
                if kind in use:
                    excess = self._excess(use[kind], margin)
                    factors[:-1] *= excess
                    factors[1:] *= excess
        self.jerk *= self._excess(use["jerk"], margin)
        for end, given in zip((0, -1), self._given, strict=True):
            if given:
                self._velocity[end] = 1.0
        self.rounds += 1

    def _excess(self, use: Array, margin: float) -> Array:
        """Divisors of the limits on each grid interval, which holds one or two cubic pieces."""
        intervals = len(self.jerk)
        pieces, over = divmod(len(use), intervals)
        # samples at the same nanosecond were dropped, so pieces cannot be matched to intervals
        most = use.reshape(-1, pieces).max(axis=1) if pieces and not over else np.full(intervals, use.max())
        return np.where(most > 1, most * margin, 1.0)


def slowdown(use: Use) -> float:
    """Factor by which a motion has to be slowed down; 1 when every limit holds."""
    factor = max(float(use["velocity"].max()), float(np.sqrt(use["acceleration"].max())), float(np.cbrt(use["jerk"].max())))
    if "tool speed" in use:
        factor = max(factor, float(use["tool speed"].max()))
    if "torque" in use and (excess := float(use["torque"].max()) - 1) > 0:
        # slowing down does not reduce the torque of gravity, so torque gets a small step per round
        factor = max(factor, 1 + 2 * excess)
    return max(factor, 1.0)


#: Relative tolerance by which a given speed may exceed the limits, for rounding in the caller's arithmetic.
DIGITS = 1e-9


def fastest_speeds(
    demands: PathDynamics, names: Sequence[str], given: Callable[[float], float], start: float = 0.0, end: float = 0.0
) -> Array:
    """Speed dl/dt [rad/s] at each grid point (k,), from `start` to `end` [rad/s].

    Raises InvalidInputError when limits do not allow these speeds, PlanningError when no speed is within the limits;
    `given` converts a path parameter into that of the given path, for the message.
    """
    unit = demands.speed_unit
    _check_end("start_speed", start, demands, names, given, 0)
    _check_end("end_speed", end, demands, names, given, -1)
    algorithm = _algorithm(demands)
    first = min((start / unit) ** 2, demands.fastest[0])
    last = min((end / unit) ** 2, demands.fastest[-1])
    _, speed, _ = algorithm.compute_parameterization(np.sqrt(first), np.sqrt(last))
    if speed is None or not np.isfinite(speed).all():
        raise _failure(demands, names, given, start, end)
    speed = np.asarray(np.maximum(speed, 0.0), dtype=float)
    if (speed[1:-1] <= 0).any():
        k = int(np.flatnonzero(speed[1:-1] <= 0)[0]) + 1
        raise PlanningError(
            f"the motion comes to rest inside the path, {_place(demands, k, given)}; {_binding(demands, names, k)}"
        )
    return speed * unit


def _algorithm(demands: PathDynamics) -> Any:
    """toppra's algorithm with our rows."""
    with building():
        import toppra
        from toppra.constraint import LinearConstraint
        from toppra.constraint.linear_constraint import canlinear_colloc_to_interpolate
        from toppra.interpolator import AbstractGeometricPath

    count = demands.tangent.shape[1]
    rows = demands.u.shape[1]

    class Geometric(AbstractGeometricPath):  # type: ignore[misc]  # toppra has no stubs
        dof = count
        path_interval = np.array([0.0, 1.0])
        waypoints = None

        def __call__(self, _places: Any, _order: int = 0) -> Array:
            raise NotImplementedError

    class Speed(LinearConstraint):  # type: ignore[misc]
        dof = count

        def compute_constraint_params(self, *_: Any) -> tuple[Any, ...]:
            bound = np.column_stack([np.zeros(len(demands.fastest)), np.minimum(demands.fastest, 1e12)])
            return None, None, None, None, None, None, bound

    class Rows(LinearConstraint):  # type: ignore[misc]
        dof = count

        def __init__(self) -> None:
            super().__init__()
            self.identical = True

        def compute_constraint_params(self, _path: Any, points: Array, *_: Any) -> tuple[Any, ...]:
            both = np.vstack([np.eye(rows), -np.eye(rows)])
            return tuple(
                canlinear_colloc_to_interpolate(
                    demands.u, demands.x, demands.constant, both, np.ones(2 * rows), None, None, points, identical=True
                )
            )

    return toppra.algorithm.TOPPRA([Speed(), Rows()], Geometric(), gridpoints=demands.at, solver_wrapper="seidel")


def _place(demands: PathDynamics, k: int, given: Callable[[float], float]) -> str:
    return f"at s = {given(float(demands.curve.s(demands.length[k]))):.4f}"


def _binding(demands: PathDynamics, names: Sequence[str], k: int) -> str:
    """The joint and kind of the tightest limit at grid point k, as a sentence."""
    n = len(names)
    row = int(np.argmax(np.abs(demands.constant[k]) + 1e-9 * np.abs(demands.x[k])))
    kind = "acceleration" if row < n else "effort"
    return f"the {kind} limit of {names[row % n]} allows no motion"


def _check_end(
    name: str, speed: float, demands: PathDynamics, names: Sequence[str], given: Callable[[float], float], k: int
) -> None:
    most = float(np.sqrt(demands.fastest[k]) * demands.speed_unit)
    if speed <= most * (1 + DIGITS):
        return
    ratio = np.abs(demands.tangent[k]) / demands.bounds.velocity[k]
    joint = int(np.argmax(ratio))
    by_joint = most * ratio[joint] / demands.curve.length > 1 - 1e-6
    whose = f"the velocity limit of {names[joint]}" if by_joint else "the tool speed limit of a segment"
    allowed = f"0 to {round_down(most, 6):.6g}: {whose} allows no higher speed {_place(demands, k, given)}"
    raise InvalidInputError(name, speed, allowed)


def _failure(
    demands: PathDynamics, names: Sequence[str], given: Callable[[float], float], start: float, end: float
) -> Exception:
    """The error to raise, with the reason why there is no motion."""
    if end > 0 and (most := _most(demands, end, lambda speed: (start, speed))) is not None:
        return InvalidInputError(
            "end_speed", end, f"0 to {most:.6g}: a higher one cannot be reached from start_speed = {start:g} within the limits"
        )
    if start > 0 and (most := _most(demands, start, lambda speed: (speed, 0.0))) is not None:
        return InvalidInputError(
            "start_speed", start, f"0 to {most:.6g}: from a higher one the arm cannot slow down in time for the path ahead"
        )
    ahead = _algorithm(demands).compute_controllable_sets(0.0, 0.0)
    empty = np.flatnonzero(~np.isfinite(ahead).all(axis=1))
    k = int(empty[-1]) if len(empty) else 0
    return PlanningError(f"no motion is within the limits: {_binding(demands, names, k)} {_place(demands, k, given)}")


def _most(demands: PathDynamics, given: float, ends: Callable[[float], tuple[float, float]]) -> float | None:
    """The largest speed below the given one that allows a motion, rounded down; None when even 0 does not."""
    algorithm = _algorithm(demands)

    def works(speed: float) -> bool:
        _, found, _ = algorithm.compute_parameterization(*(each / demands.speed_unit for each in ends(speed)))
        return found is not None and bool(np.isfinite(found).all())

    if not works(0.0):
        return None
    low, high = 0.0, given
    for _ in range(16):
        middle = (low + high) / 2
        low, high = (middle, high) if works(middle) else (low, middle)
    return round_down(low, 4)
