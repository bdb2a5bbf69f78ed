"""The clearance of a whole curve, proven and not sampled, by conservative bisection with bounds on how far bodies move.

The distance of a pair of bodies at the middle of an interval of the curve, minus the largest motion of the two towards each
other on it, is a lower bound of their distance on the interval. A second one comes from the plane between the two at the
middle: no point of either passes it by more than its velocity there and the largest acceleration on the interval allow. It
decides where the two slide along each other. Beside a cloud or a mesh a few such planes do, if each of its points and triangles
that the body can reach is behind one of them. Motion, speed and acceleration of each joint come from the control points of the
interval and of its derivatives, whose hulls contain them. Where both bounds are too low the interval is halved, for the pairs
still open.

Bounds on the motion of a body when joints move.

Between a configuration q and another that differs by δ_j in joint j, a point of a body moves, relative to the other body of its
pair, at most Σ_j D_j over the joints j between the two. When the joints move one after another, the joint nearest to the body
first, joint j moves the point by at most

    D_j = δ_j (ρ_j + Σ_{i > j} D_i)   for a revolute joint,   D_j = δ_j   for a prismatic one,

with ρ_j the largest distance of the body's points from axis j at q: the joints that moved before have moved the point by
at most the sum. The distance of the pair decreases by at most Σ_j D_j. (1)

On a curve q(u) with |q_j'| <= v_j and |q_j''| <= a_j the same distance λ_j from axis j, ρ_j + Σ_{i > j} D_i or 1 for a
prismatic joint, bounds a point's acceleration: its part by joints i < j is |z_i x (z_j x r_j)| <= λ_j, so that (2)

    |p''| <= Σ_j λ_j (v_j² + 2 v_j Σ_{i < j} v_i + a_j),   (3)

without v_j² for a prismatic joint j, and without v_i for a prismatic joint i.

"Between" goes through the last joint that carries both: from there on, joints that carry only the other body count with those
that carry the first, as one chain from the other body to the first.
"""

import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.covers import enclose
from manipplan.collision.model import CollisionModel
from manipplan.collision.world import core_of
from manipplan.paths.joint import JointPath, split
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array, instance, number
from manipplan.support.display import one_line
from manipplan.support.errors import InvalidInputError
from manipplan.support.kernels import load_kernel, struct
from manipplan.support.memo import once_per_owner

#: Maximum number of core points of a body; a body with more is bounded by a primitive around it. As in body_motion.c.
MOST_POINTS = 8
#: Maximum number of joints in compiled code; as in body_motion.c.
MOST_JOINTS = 64

BodyIndices = NDArray[np.intp]


@cache
def _compiled() -> Callable[..., None]:
    return load_kernel("body_motion").functions()["motion_bounds"]


@once_per_owner
def body_motion(model: CollisionModel) -> "BodyMotion":
    """Bounds on the motion of the bodies of a collision model."""
    return BodyMotion(model)


class BodyMotion:
    """Bounds on the motion of the bodies of a collision model."""

    def __init__(self, model: CollisionModel) -> None:
        tree, objects = model.robot.tree, model.objects
        carrier = np.array([item.parentJoint for item in objects])
        pairs, carriers = model.pairs, carrier[model.pairs]
        #: (b,) the joint that carries each body; 0: the world
        self.joint = carrier
        #: (p,) the body of each pair whose joint has the higher number, and the joint of the other body
        self.body: BodyIndices = pairs[np.arange(len(pairs)), carriers.argmax(axis=1)]
        self.below: BodyIndices = carriers.min(axis=1)
        kinds = {kind: pair for pair, kind in enumerate(zip(self.body.tolist(), self.below.tolist(), strict=True))}
        self._kinds: BodyIndices = np.array(list(kinds.values()))  # a pair for each body and joint below it
        self.points = np.empty((len(objects), MOST_POINTS, 3))
        self.radii = np.zeros(len(objects))
        for k in sorted(set(self.body.tolist())):
            points, self.radii[k] = _few_points(model.robot, objects[k])
            self.points[k] = np.concatenate([points, np.repeat(points[:1], MOST_POINTS - len(points), axis=0)])
        self._tree = tree
        self._arrays = {
            **{name: getattr(tree, name) for name in ("before", "carries", "fixed", "axes")},
            "slides": tree.slides.astype(np.int64),
            "joint": self.joint.astype(np.int64),
            "points": self.points,
            "radii": self.radii,
            "body": self.body.astype(np.int64),
            "below": self.below.astype(np.int64),
        }

    def motion(self, q: Array, change: Array, rows: BodyIndices, pairs: BodyIndices) -> Array:
        """Upper bound (1) on the motion of the two bodies of pairs (e,) towards each other, (e,) [m].

        Each joint stays within `change` (m, n) [rad or m] of its configuration, the one of `rows` (e,) of q (m, n).
        """
        found = self._by_kernel(q, change, None, rows, pairs)
        return self._motion_by_numpy(q, change, rows, pairs) if found is None else found[0]

    def motion_and_bend(
        self, q: Array, change: Array, rates: tuple[Array, Array], rows: BodyIndices, pairs: BodyIndices
    ) -> tuple[Array, Array]:
        """The same, and upper bounds (3) on the acceleration of the bodies' points, (e,) each; inf above MOST_JOINTS joints.

        `rates` are the largest speeds and accelerations (m, n) of the joints.
        """
        found = self._by_kernel(q, change, rates, rows, pairs)
        return (self._motion_by_numpy(q, change, rows, pairs), np.full(len(rows), np.inf)) if found is None else found

    def _by_kernel(
        self, q: Array, change: Array, rates: tuple[Array, Array] | None, rows: BodyIndices, pairs: BodyIndices
    ) -> tuple[Array, Array] | None:
        """Both bounds by compiled code, the second one only with `rates`; None with more than MOST_JOINTS joints."""
        tree = self._tree
        n, count = len(tree.slides), len(self.radii)
        if n > MOST_JOINTS:
            return None
        numbers = [
            np.ascontiguousarray(each, dtype=float) for each in (tree.positions(q), *map(tree.sizes, (change, *(rates or ()))))
        ]
        rows, pairs = np.ascontiguousarray(rows, dtype=np.int64), np.ascontiguousarray(pairs, dtype=np.int64)
        work = {"moved": np.empty((count, n + 1)), "lever": np.empty((count, n + 1)), "row": np.empty(count, dtype=np.int64)}
        arm = struct("body_motion", "Arm")(
            n=n, bodies=count, **{name: array.ctypes.data for name, array in (self._arrays | work).items()}
        )
        motion, bend = np.empty(len(rows)), np.empty(0 if rates is None else len(rows))
        at = [each.ctypes.data for each in numbers] + [None] * (4 - len(numbers))
        ends = motion.ctypes.data, None if rates is None else bend.ctypes.data
        _compiled()(ctypes.addressof(arm), *at, rows.ctypes.data, pairs.ctypes.data, len(rows), *ends)
        return motion, bend

    def _motion_by_numpy(self, q: Array, change: Array, rows: BodyIndices, pairs: BodyIndices) -> Array:
        """As `motion`."""
        q, change = self._tree.positions(q), self._tree.sizes(change)
        rotations, origins, axes = self._frames(q)
        moved, n = np.zeros(len(rows)), q.shape[1]
        kinds = self.joint[self.body[pairs]] * (n + 1) + self.below[pairs]
        for kind in np.unique(kinds):
            joint, other = divmod(int(kind), n + 1)
            here = np.flatnonzero(kinds == kind)
            row, body = rows[here], self.body[pairs[here]]
            points = np.einsum("uij,ukj->uki", rotations[row, joint], self.points[body]) + origins[row, joint][:, None]
            for j in self._between(joint, other):
                step = change[row, j - 1]
                if not self._tree.slides[j - 1]:
                    lever = points - origins[row, j][:, None]
                    along = np.einsum("uki,ui->uk", lever, axes[row, j])
                    square = np.einsum("uki,uki->uk", lever, lever) - along**2
                    step = step * (np.sqrt(np.maximum(square.max(axis=1), 0.0)) + self.radii[body] + moved[here])
                moved[here] += step
        return moved

    def _between(self, joint: int, other: int) -> list[int]:
        """The joints between two, from `joint` down to the last one that carries both, and from there up to `other`."""
        carries = self._tree.carries
        only, others = (np.flatnonzero(carries[a] > carries[b]) for a, b in ((joint, other), (other, joint)))
        return [*only[::-1].tolist(), *others.tolist()]

    def joints_between(self) -> list[frozenset[int]]:
        """The joints, as indices of q, on which the place of one body of each pair in the frame of the other depends."""
        kinds = list(zip(self.joint[self.body].tolist(), self.below.tolist(), strict=True))
        found = {kind: frozenset(self._tree.leader[[j - 1 for j in self._between(*kind)]].tolist()) for kind in set(kinds)}
        return [found[kind] for kind in kinds]

    def largest(self, q: Array, change: Array) -> Array:
        """The largest bound of any pair at each of the configurations q (m, n), (m,) [m]."""
        rows = np.repeat(np.arange(len(q)), len(self._kinds))
        return np.asarray(self.motion(q, change, rows, np.tile(self._kinds, len(q))).reshape(len(q), -1).max(axis=1))

    def _frames(self, q: Array) -> tuple[Array, Array, Array]:
        """Rotations (m, n + 1, 3, 3), origins and axes (m, n + 1, 3) of the world and joint frames at positions q (m, n)."""
        tree, (m, n) = self._tree, q.shape
        rotations, origins, axes = np.empty((m, n + 1, 3, 3)), np.zeros((m, n + 1, 3)), np.zeros((m, n + 1, 3))
        rotations[:, 0] = np.eye(3)
        for j, (axis, fixed) in enumerate(zip(tree.axes, tree.fixed, strict=True), start=1):
            parent = tree.before[j - 1]
            before = rotations[:, parent]
            frame = before @ fixed[:9].reshape(3, 3)
            origins[:, j] = origins[:, parent] + before @ fixed[9:]
            axes[:, j] = frame @ axis
            if tree.slides[j - 1]:
                rotations[:, j] = frame
                origins[:, j] += q[:, j - 1 : j] * axes[:, j]
            else:
                cross = pin.skew(axis)  # Rodrigues: R = I + sin q [a]x + (1 - cos q) [a]x²
                sine, cosine = np.sin(q[:, j - 1]), np.cos(q[:, j - 1])
                turn = np.eye(3) + sine[:, None, None] * cross + (1 - cosine)[:, None, None] * (cross @ cross)
                rotations[:, j] = frame @ turn
        return rotations, origins, axes


def _few_points(robot: Robot, item: pin.GeometryObject) -> tuple[Array, float]:
    """At most MOST_POINTS points (k, 3) in the joint's frame and a radius [m]: the hull of these balls contains the body."""
    points, radius = core_of(item.geometry)
    placement = item.placement
    if len(points) > MOST_POINTS:
        known, key = _enclosures(robot), points.tobytes()
        if key not in known:
            around = enclose(np.repeat(points[:, None], 3, axis=1), refine=False)
            known[key] = *core_of(around.shape), around.placement
        points, radius, inner = known[key]
        placement = placement * inner
    return points @ placement.rotation.T + placement.translation, radius


@once_per_owner
def _enclosures(_robot: Robot) -> dict[bytes, tuple[Array, float, pin.SE3]]:
    """What encloses the bodies that were met with this robot, by their core points: it is the same in every scene."""
    return {}


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
    """Prove a lower bound of the distance of every pair on a whole path, as `Scene.path_clearance`.

    The gap of the bounds is smaller than `tolerance` [m] where that proves that the path keeps `clearance` [m]; with None the
    search ends as soon as that is proven or refuted.
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
            control, breaks = _halve(control, breaks)
        edges = np.stack([breaks[:-1], breaks[1:]], axis=1)
        rows, pairs, known = self._begin(control, breaks)
        while len(rows) and not self.decided:
            halves = split(control)
            middles = edges.mean(axis=1)
            cut, bounds = self._measure_middles(_Intervals.of(control, *halves), middles, rows, pairs, known)
            remaining, position = np.unique(rows[cut], return_inverse=True)
            control = np.concatenate([half[remaining] for half in halves])
            low, high = edges[remaining].T
            edges = np.concatenate([np.stack([low, middles[remaining]], axis=1), np.stack([middles[remaining], high], axis=1)])
            rows = np.concatenate([position, position + len(remaining)])
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
        rows, pairs, bounds = self._measure_all(q, change, middles)
        times = lengths[rows]
        inside = np.arange(times.sum()) - np.repeat(np.cumsum(times) - times, times)
        return np.repeat(first[rows], times) + inside, np.repeat(pairs, times), np.repeat(bounds, times)

    def _measure_all(self, q: Array, change: Array, middles: Array) -> tuple[BodyIndices, BodyIndices, Array]:
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

    def _measure_middles(
        self, on: "_Intervals", middles: Array, rows: BodyIndices, pairs: BodyIndices, known: Array
    ) -> tuple[NDArray[np.bool_], Array]:
        """Measure pairs at the middles of intervals; returns which to cut, and all bounds. The others are closed.

        `known` holds the bounds from the parent interval.
        """
        motion, bend = self.motion.motion_and_bend(on.q, on.change, (on.speed, on.acceleration), rows, pairs)
        beyond = np.maximum(self._target + motion + 2 * SLACK, self.upper)  # what is farther is closed
        self.checks += len(rows)
        found = self.model.interval_bounds(on.q[rows], on.slope[rows], pairs, beyond=beyond, bends=bend, motions=motion)
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


def _halve(control: Array, breaks: Array) -> tuple[Array, Array]:
    """Control points and breaks of the same curve in twice as many pieces."""
    left, right = split(control)
    middles = (breaks[:-1] + breaks[1:]) / 2
    return np.stack([left, right], axis=1).reshape(-1, *control.shape[1:]), np.append(
        np.stack([breaks[:-1], middles], axis=1).ravel(), breaks[-1]
    )
