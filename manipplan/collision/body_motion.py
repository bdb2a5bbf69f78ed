"""Bounds on the motion of a body when joints move.

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
from functools import cache
from pathlib import Path

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.covers.fitting import enclose
from manipplan.collision.model import CollisionModel
from manipplan.collision.primitives import core_of
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.compiling.native import native_code
from manipplan.support.memo import once_per_owner

#: Maximum number of core points of a body; a body with more is bounded by a primitive around it. As in body_motion.c.
MOST_POINTS = 8
#: Maximum number of joints in compiled code; as in body_motion.c.
MOST_JOINTS = 64

BodyIndices = NDArray[np.intp]
_P, _N = ctypes.c_void_p, ctypes.c_long


class _ArmStruct(ctypes.Structure):
    """`Arm` of body_motion.c."""

    _fields_ = [
        (name, _N if name in ("n", "bodies") else _P)
        for name in (
            *("n", "before", "carries", "fixed", "axes", "slides", "bodies", "joint", "points", "radii", "body", "below"),
            *("moved", "lever", "row"),
        )
    ]


#: Result and arguments of `manipplan_motion`.
SIGNATURE = (None, *[_P] * 7, _N, _P, _P)


@cache
def _compiled() -> Callable[..., None] | None:
    """The compiled bounds; None where they cannot be compiled."""
    code = native_code(Path(__file__).with_name("body_motion.c"), "proofs of clearance")
    return None if code is None else code.functions("manipplan_", {"motion": SIGNATURE})["motion"]


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
        """Upper bound (1) on the motion of the two bodies of a pair towards each other, (e,) [m].

        Args:
            q: (m, n) configurations.
            change: (m, n) maximum distance of each joint from there [rad or m].
            rows, pairs: (e,) indices of the configuration and of the pair.
        """
        found = self._by_kernel(q, change, None, rows, pairs)
        return self._motion_by_numpy(q, change, rows, pairs) if found is None else found[0]

    def motion_and_bend(
        self, q: Array, change: Array, rates: tuple[Array, Array], rows: BodyIndices, pairs: BodyIndices
    ) -> tuple[Array, Array]:
        """The same, and upper bounds (3) on the acceleration of the bodies' points, (e,) each; inf without compiled code.

        `rates` are the largest speeds and accelerations (m, n) of the joints.
        """
        found = self._by_kernel(q, change, rates, rows, pairs)
        return (self._motion_by_numpy(q, change, rows, pairs), np.full(len(rows), np.inf)) if found is None else found

    def _by_kernel(
        self, q: Array, change: Array, rates: tuple[Array, Array] | None, rows: BodyIndices, pairs: BodyIndices
    ) -> tuple[Array, Array] | None:
        """Both bounds by compiled code, the second one only with `rates`; None without it."""
        tree = self._tree
        call, n, count = _compiled(), len(tree.slides), len(self.radii)
        if call is None or n > MOST_JOINTS:
            return None
        numbers = [
            np.ascontiguousarray(each, dtype=float) for each in (tree.positions(q), *map(tree.sizes, (change, *(rates or ()))))
        ]
        rows, pairs = np.ascontiguousarray(rows, dtype=np.int64), np.ascontiguousarray(pairs, dtype=np.int64)
        work = {"moved": np.empty((count, n + 1)), "lever": np.empty((count, n + 1)), "row": np.empty(count, dtype=np.int64)}
        arm = _ArmStruct(n=n, bodies=count, **{name: array.ctypes.data for name, array in (self._arrays | work).items()})
        motion, bend = np.empty(len(rows)), np.empty(0 if rates is None else len(rows))
        at = [each.ctypes.data for each in numbers] + [None] * (4 - len(numbers))
        ends = motion.ctypes.data, None if rates is None else bend.ctypes.data
        call(ctypes.addressof(arm), *at, rows.ctypes.data, pairs.ctypes.data, len(rows), *ends)
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
    place = item.placement
    if len(points) > MOST_POINTS:
        known, key = _enclosed(robot), points.tobytes()
        if key not in known:
            around = enclose(np.repeat(points[:, None], 3, axis=1), refine=False)
            known[key] = *core_of(around.shape), around.placement
        points, radius, inner = known[key]
        place = place * inner
    return points @ place.rotation.T + place.translation, radius


@once_per_owner
def _enclosed(_robot: Robot) -> dict[bytes, tuple[Array, float, pin.SE3]]:
    """What encloses the bodies that were met with this robot, by their core points: it is the same in every scene."""
    return {}
