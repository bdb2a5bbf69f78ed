"""The clearance of a whole curve, proven and not sampled, by conservative bisection with the bounds of `body_motion`.

The distance of a pair of bodies at the middle of an interval of the curve, minus the largest motion of the two towards each
other on it, is a lower bound of their distance on the interval. A second one comes from the plane between the two at the
middle: no point of either passes it by more than its velocity there and the largest acceleration on the interval allow. It
decides where the two slide along each other. Motion, speed and acceleration of each joint come from the control points of the
interval and of its derivatives, whose hulls contain them. Where both bounds are too low the interval is halved, for the pairs
still open.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from manipplan.collision.body_motion import BodyIndices, body_motion
from manipplan.collision.model import CollisionModel
from manipplan.paths.joint import JointPath, split
from manipplan.support.checks import Array, instance, number
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError

#: Margin subtracted from every distance [m]; coal's distances are accurate to 2e-6 m.
SLACK = 1e-5
#: Intervals in which no joint moves more than this from the middle are not cut again [rad or m].
NARROW = 1e-6
#: Maximum number of distances computed; then the best bound so far is returned.
MOST_CHECKS = 100_000
#: Minimum number of intervals at whose middles all pairs are measured first, and maximum number of pieces in one of them.
FIRST, RUN = 32, 16


@one_line
@dataclass(frozen=True, kw_only=True)
class PathClearance:
    """Bounds on the smallest distance of two bodies on a whole curve; all distances [m].

    Attributes:
        lower: proven lower bound of the distance of every checked pair on the whole curve. Below zero the path touches or may
            touch; the depth of an overlap is not proven.
        upper: smallest distance computed on the curve; the true minimum lies between `lower` and `upper`.
        clearance: the required clearance.
        at, pair: s in [0, 1] and the names of the two bodies where the required clearance is violated; otherwise where a
            violation is not excluded; otherwise where the bound is smallest. nan and () when nothing is checked.
        pair_id: index of the pair in the collision model's `pair_names`; -1 when nothing is checked.
        checks: number of distances computed; of the first intervals, only those that were not cut off.
    """

    lower: float
    upper: float
    clearance: float
    at: float
    pair: tuple[str, ...]
    pair_id: int
    checks: int

    @property
    def proven(self) -> bool:
        """Whether every pair is farther apart than `clearance` on the whole curve."""
        return self.lower > self.clearance

    @property
    def refuted(self) -> bool:
        """Whether a distance of at most `clearance` was found."""
        return self.upper <= self.clearance


def path_clearance(
    model: CollisionModel, path: JointPath, *, clearance: float = 0.0, tolerance: float | None = 1e-3
) -> PathClearance:
    """Prove a lower bound of the distance of every pair on a whole path.

    Args:
        model: the robot among its obstacles.
        path: of the robot's joints.
        clearance: required clearance [m].
        tolerance: maximum `upper` - `lower` [m], at least 1e-4; smaller where that proves that the path keeps `clearance`.
            None: the search ends as soon as that is proven or refuted.

    Raises:
        InvalidInputError: the path is not of this robot's joints, or a number is invalid.
    """
    n = model.robot.n
    if instance("path", path, JointPath).n != n:
        raise InvalidInputError("path", f"a path of {path.n} joints", f"a path of the {n} joints of {model.robot.name}")
    clearance = number("clearance", clearance, least=0.0)
    if tolerance is not None:
        tolerance = number("tolerance", tolerance, least=1e-4)
    if not model.pair_names:
        return PathClearance(lower=np.inf, upper=np.inf, clearance=clearance, at=np.nan, pair=(), pair_id=-1, checks=0)
    return _Bisection(model, clearance, tolerance).run(path)


class _Bisection:
    """Bisection, level by level: an interval keeps the pairs that its parent could not close."""

    def __init__(self, model: CollisionModel, clearance: float, tolerance: float | None) -> None:
        self.model = model
        self.motion = body_motion(model)
        self.clearance = clearance
        self.tolerance = tolerance
        self.checks = 0
        self.lower, self.upper = np.inf, np.inf
        self.lowest, self.nearest = (0.0, 0), (0.0, 0)

    def run(self, path: JointPath) -> PathClearance:
        control, breaks = path.control, path.breaks
        while len(control) < 2 * FIRST:
            control, breaks = _halved(control, breaks)
        edges = np.stack([breaks[:-1], breaks[1:]], axis=1)
        rows, pairs, known = self._begin(control, breaks)
        while len(rows) and not self.decided:
            halves = split(control)
            middles = edges.mean(axis=1)
            cut, bounds = self._look(_Intervals.of(control, *halves), middles, rows, pairs, known)
            kept, position = np.unique(rows[cut], return_inverse=True)
            control = np.concatenate([half[kept] for half in halves])
            low, high = edges[kept].T
            edges = np.concatenate([np.stack([low, middles[kept]], axis=1), np.stack([middles[kept], high], axis=1)])
            rows = np.concatenate([position, position + len(kept)])
            pairs, known = np.tile(pairs[cut], 2), np.tile(bounds[cut], 2)
        at, pair_id = self.nearest if self.upper <= self.clearance else self.lowest
        return PathClearance(
            lower=self.lower,
            upper=self.upper,
            clearance=self.clearance,
            at=at,
            pair=tuple(self.model.pair_names[pair_id]),
            pair_id=pair_id,
            checks=self.checks,
        )

    @property
    def decided(self) -> bool:
        """Whether the search can stop."""
        return self.tolerance is None and self.upper <= self.clearance

    @property
    def _target(self) -> float:
        """The bound above which a pair is closed: the clearance or, with a tolerance, `upper` minus the tolerance."""
        if self.tolerance is None:
            return self.clearance
        tight = self.upper - self.tolerance
        return max(tight, self.clearance) if self.upper > self.clearance else tight

    def _begin(self, control: Array, breaks: Array) -> tuple[BodyIndices, BodyIndices, Array]:
        """Pieces and pairs that are still open, with their bounds, after all pairs were measured at each run of pieces."""
        first = np.arange(0, len(control), min(len(control) // FIRST, RUN))
        lengths = np.diff(np.append(first, len(control)))
        middle = first + lengths // 2
        q, middles = control[middle, 0], breaks[middle]
        low, high = np.minimum.reduceat(control.min(axis=1), first), np.maximum.reduceat(control.max(axis=1), first)
        change = np.maximum(q - low, high - q)
        self.upper, row, pair = self.model.least_distance(q)
        self.nearest = float(middles[row]), pair
        rows, pairs, bounds = self._look_at_all(q, change, middles)
        times = lengths[rows]
        inside = np.arange(times.sum()) - np.repeat(np.cumsum(times) - times, times)
        return np.repeat(first[rows], times) + inside, np.repeat(pairs, times), np.repeat(bounds, times)

    def _look_at_all(self, q: Array, change: Array, middles: Array) -> tuple[BodyIndices, BodyIndices, Array]:
        """Measure all pairs at the middles q (m, n) of intervals; returns row, pair and bound of those to cut."""
        most = self.motion.largest(q, change)
        beyond = np.maximum(self._target + most + 2 * SLACK, self.upper)
        near = self.model.near_pairs(q, beyond)
        self.checks += len(q) + len(near.rows)
        far = np.flatnonzero(np.bincount(near.rows, minlength=len(q)) < near.shape[1])  # where pairs were cut off
        if len(far):
            row = int(far[(beyond - most)[far].argmin()])
            pair = int(np.isin(np.arange(near.shape[1]), near.pairs[near.rows == row]).argmin())  # the first of those
            self._close((beyond - SLACK - most)[[row]], middles, np.array([row]), np.array([pair]))
        motion = self.motion.motion(q, change, near.rows, near.pairs)
        known = np.full(len(motion), -np.inf)
        cut, bounds = self._judge(near.distances, motion, change, middles, near.rows, near.pairs, known)
        return near.rows[cut], near.pairs[cut], bounds[cut]

    def _look(
        self, on: "_Intervals", middles: Array, rows: BodyIndices, pairs: BodyIndices, known: Array
    ) -> tuple[NDArray[np.bool_], Array]:
        """Measure pairs at the middles of intervals; returns which to cut, and all bounds. The others are closed.

        `known` holds the bounds from the parent interval.
        """
        motion, bend = self.motion.motion_and_bend(on.q, on.change, (on.speed, on.acceleration), rows, pairs)
        beyond = np.maximum(self._target + motion + 2 * SLACK, self.upper)  # what is farther is closed
        self.checks += len(rows)
        found = self.model.interval_bounds(on.q[rows], on.slope[rows], pairs, beyond=beyond, bends=bend)
        distances, bounds = found[0], np.maximum(known, found[1] - SLACK)
        return self._judge(distances, motion, on.change, middles, rows, pairs, bounds)

    def _judge(
        self,
        distances: Array,
        motion: Array,
        change: Array,
        middles: Array,
        rows: BodyIndices,
        pairs: BodyIndices,
        known: Array,
    ) -> tuple[NDArray[np.bool_], Array]:
        """Which pairs to cut, and all bounds, from distances (e,) at the middles and motions (e,) towards each other [m]."""
        if not len(rows):
            return np.zeros(0, dtype=bool), known
        bounds = np.maximum(known, distances - SLACK - motion)
        bounds[np.isnan(bounds)] = -np.inf  # what cannot be measured is not proven
        least = int(np.where(np.isnan(distances), np.inf, distances).argmin())
        if distances[least] < self.upper:
            self.upper, self.nearest = float(distances[least]), (float(middles[rows[least]]), int(pairs[least]))
        cut = (bounds <= self._target) & (change.max(axis=1) > NARROW)[rows]
        if self.decided or self.checks + 2 * int(cut.sum()) > MOST_CHECKS:
            cut[:] = False
        self._close(bounds[~cut], middles, rows[~cut], pairs[~cut])
        return cut, bounds

    def _close(self, bounds: Array, middles: Array, rows: BodyIndices, pairs: BodyIndices) -> None:
        if len(bounds) and bounds.min() < self.lower:
            least = int(bounds.argmin())
            self.lower, self.lowest = float(bounds[least]), (float(middles[rows[least]]), int(pairs[least]))


@dataclass(frozen=True, kw_only=True, eq=False)
class _Intervals:
    """Motion of the joints on intervals of a curve, (m, n) each, where u - 1/2 runs from -1/2 to 1/2.

    Attributes:
        q: the configuration in the middle.
        change: largest distance from there.
        slope: q' / 2 in the middle: the change on half an interval at that speed.
        speed, acceleration: largest |q'| / √8 and |q''| / 8, so that a point's acceleration bounds its motion beyond the slope.
    """

    q: Array
    change: Array
    slope: Array
    speed: Array
    acceleration: Array

    @classmethod
    def of(cls, control: Array, left: Array, right: Array) -> "_Intervals":
        """From control points (m, k + 1, n) and those of both halves."""
        k, q = control.shape[1] - 1, left[:, -1]
        velocity = k / 2 * np.diff(control, axis=1)
        acceleration = (k - 1) * np.diff(velocity, axis=1) / 4 if k > 1 else np.zeros_like(velocity)
        return cls(
            q=q,
            change=np.abs(control - q[:, None]).max(axis=1),
            slope=k * (right[:, 1] - q),
            speed=np.abs(velocity).max(axis=1) / np.sqrt(2),
            acceleration=np.abs(acceleration).max(axis=1),
        )


def _halved(control: Array, breaks: Array) -> tuple[Array, Array]:
    """Control points and breaks of the same curve in twice as many pieces."""
    left, right = split(control)
    middles = (breaks[:-1] + breaks[1:]) / 2
    return np.stack([left, right], axis=1).reshape(-1, *control.shape[1:]), np.append(
        np.stack([breaks[:-1], middles], axis=1).ravel(), breaks[-1]
    )
