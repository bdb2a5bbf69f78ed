"""The compiled kernel that decides collisions and measures distances: `distances.c`, with the arrays of one collision model."""

import ctypes
import threading
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.primitives import core_of, mesh_triangles
from manipplan.robots.model_tree import axis_of, is_prismatic
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.compiling.native import NativeCode, native_code

#: As in distances.c.
POINTS, BOX, CYLINDER, HALFSPACE, SURFACE, UNKNOWN = range(6)
FREE, TOUCHING, UNDECIDED = range(3)
#: Half the size of the box around an unbounded shape [m].
ENDLESS = 1e9

Numbers = NDArray[np.int64]


#: Initial room for near pairs per configuration.
ROOM = 64


class _World(ctypes.Structure):
    """`World` of distances.c."""

    _fields_ = [
        (name, ctypes.c_long if name in ("n", "bodies", "selves", "movers", "groups", "pairs", "top") else ctypes.c_void_p)
        for name in (
            *("n", "fixed", "axes", "slides", "bodies", "joint", "kind", "first", "count", "radius", "pose", "size", "ball"),
            "local",
            *("x", "y", "z", "selves", "self", "movers", "mover", "pair_of", "groups", "group", "group_ball", "pairs", "top"),
            *("node_box", "node", "root", "corners", "frames", "centres", "least", "found", "guess"),
        )
    ]


_P, _N = ctypes.c_void_p, ctypes.c_long
#: Result and arguments of the functions of distances.c.
SIGNATURES: dict[str, tuple[Any, ...]] = {
    "check": (None, _P, _P, _N, ctypes.c_double, _P),
    "distances": (None, _P, _P, _N, _P, _P),
    "least": (ctypes.c_int, _P, _P, _N, ctypes.c_double, _N, _P, _P, _P),
    "pairs": (None, _P, _P, _N, _P, _P, _P, _P),
    "intervals": (None, _P, _P, _P, _N, *[_P] * 5),
    "witnesses": (None, _P, _P, _N, _P, _P),
    "near": (_N, _P, _P, _N, _P, _N, _P, _P),
    "tree": (_N, _P, _P, _N, _P, _N, _P, _P),
}


@dataclass(frozen=True, kw_only=True, eq=False)
class Calls:
    """The functions of distances.c, by their names without prefix.

    Attributes:
        functions: they release the GIL.
        check_one: the check of one configuration, which holds the GIL: to release it would take longer than the check.
        code: where they come from.
    """

    functions: Mapping[str, Callable[..., Any]]
    check_one: Callable[[int, int, float], int]
    code: NativeCode

    @classmethod
    def of(cls, code: NativeCode) -> "Calls":
        """Those of the compiled source."""
        one = ctypes.PYFUNCTYPE(ctypes.c_int, _P, _P, ctypes.c_double)(code.address("manipplan_check_one"))
        return cls(functions=code.functions("manipplan_", SIGNATURES), check_one=one, code=code)


@cache
def _calls() -> Calls | None:
    """The compiled kernel; None where it cannot be compiled."""
    code = native_code(Path(__file__).with_name("distances.c"), "collision checks")
    return None if code is None else Calls.of(code)


def find_kernel(
    robot: Robot, geometry: pin.GeometryModel, radii: Array | None = None, closed: Collection[int] = ()
) -> "DistanceKernel | None":
    """The kernel for the pairs of `geometry`; None where it cannot be compiled.

    Args:
        robot: the arm.
        geometry: its bodies and the obstacles.
        radii: (g,) added all around each object [m]; None: zeros.
        closed: the objects that are surfaces and solid inside.
    """
    calls = _calls()
    if calls is None:
        return None
    return DistanceKernel(calls, _arrays(calls, robot, geometry, np.zeros(geometry.ngeoms) if radii is None else radii, closed))


class DistanceKernel:
    """Checks of one collision model by compiled code. Threads take turns, since it holds working memory; `copy` has its own."""

    def __init__(self, calls: Calls, arrays: Mapping[str, NDArray[Any]]) -> None:
        self._calls, self._call = calls, calls.functions
        self._n, self._bodies = len(arrays["axes"]), arrays["pair_bodies"]
        self._arrays = dict(arrays) | {
            "frames": np.empty((self._n + 1, 12)),
            "centres": arrays["ball"][:, :3].copy(),
            "least": np.full(len(self._bodies), np.inf),
            "found": np.empty(len(self._bodies), dtype=np.int64),
            "guess": np.zeros((len(self._bodies), 3)),
        }
        numbers = {
            "n": self._n,
            "bodies": len(arrays["joint"]),
            "selves": len(arrays["self"]),
            "movers": len(arrays["mover"]),
            "groups": len(arrays["group"]),
            "pairs": len(self._bodies),
            "top": int(arrays["top"][0]),
        }
        places = {name: array.ctypes.data for name, array in self._arrays.items() if name not in ("pair_bodies", "top")}
        self._world = _World(**numbers, **places)
        self._at = ctypes.addressof(self._world)
        self._lock = threading.Lock()
        self._q = np.zeros(self._n)
        self._q_at, self._check_one = self._q.ctypes.data, calls.check_one

    @property
    def world(self) -> int:
        """The address of `World` of distances.c, for compiled code that uses it while no other thread does."""
        return self._at

    @property
    def n(self) -> int:
        """Number of joints."""
        return self._n

    @property
    def pairs(self) -> int:
        """Number of pairs."""
        return len(self._bodies)

    def address(self, name: str) -> int:
        """The address of the function `manipplan_` and a name."""
        return self._calls.code.address(f"manipplan_{name}")

    def bodies(self, pairs: Numbers) -> Numbers:
        """The two bodies (m, 2) of pairs (m,), as `manipplan_pairs` takes them."""
        return np.ascontiguousarray(self._bodies[pairs])

    def copy(self) -> "DistanceKernel":
        """The same with its own working memory, for another thread."""
        return DistanceKernel(self._calls, self._arrays)

    def check(self, q: Array, clearance: float) -> int:
        """FREE, TOUCHING or UNDECIDED at q (n,): whether any pair is as near as `clearance` [m]."""
        with self._lock:
            self._q[:] = q
            return int(self._check_one(self._at, self._q_at, clearance))

    def check_rows(self, q: Array, clearance: float) -> NDArray[np.int8]:
        """The same for every row of q (m, n)."""
        q = np.ascontiguousarray(q, dtype=float)
        verdicts = np.empty(len(q), dtype=np.int8)
        with self._lock:
            self._call["check"](self._at, q.ctypes.data, len(q), clearance, verdicts.ctypes.data)
        return verdicts

    def distances(self, q: Array, reach: Array) -> Array:
        """Distances (m, k) of all pairs at q (m, n), cut off at `reach` (m,) >= 0 [m]; nan where this kernel cannot tell."""
        q, reach = np.ascontiguousarray(q, dtype=float), np.ascontiguousarray(reach, dtype=float)
        found = np.empty((len(q), len(self._bodies)))
        with self._lock:
            self._call["distances"](self._at, q.ctypes.data, len(q), reach.ctypes.data, found.ctypes.data)
        return found

    def near(self, q: Array, reach: Array) -> tuple[Numbers, Array]:
        """row * pairs + pair and distance of all that is nearer than `reach` (m,) >= 0 [m] at q (m, n), in this order.

        The distance is nan where this kernel cannot tell.
        """
        q, reach, room = np.ascontiguousarray(q, dtype=float), np.ascontiguousarray(reach, dtype=float), ROOM * len(q)
        while True:
            where, found = np.empty(room, dtype=np.int64), np.empty(room)
            places = (q.ctypes.data, len(q), reach.ctypes.data, room, where.ctypes.data, found.ctypes.data)
            with self._lock:
                count = int(self._call["near"](self._at, *places))
            if count <= room:
                order = np.argsort(where[:count], kind="stable")
                return where[:count][order], found[:count][order]
            room = count

    def least(self, q: Array, reach: float, coarse: int) -> tuple[float, int, int] | None:
        """The smallest distance [m] at all q (m, n), its row and its pair; None where this kernel cannot tell.

        The pair is -1 where all distances are above `reach` [m]. Every `coarse`-th row is measured first.
        """
        q, least, row, pair = np.ascontiguousarray(q, dtype=float), ctypes.c_double(), _N(), _N()
        places = [ctypes.addressof(each) for each in (least, row, pair)]
        with self._lock:
            known = self._call["least"](self._at, q.ctypes.data, len(q), reach, coarse, *places)
        return (least.value, row.value, pair.value) if known else None

    def pair_distances(self, q: Array, pairs: Numbers, reach: Array) -> Array:
        """Distance (m,) of one pair at each configuration: of pairs (m,) at q (m, n), cut off at `reach` (m,) >= 0 [m].

        nan where this kernel cannot tell.
        """
        return self._pairs(np.ascontiguousarray(q, dtype=float), self.bodies(pairs), reach)[0]

    def interval_bounds(self, q: Array, slopes: Array, pairs: Numbers, reach: Array, bends: Array) -> tuple[Array, Array]:
        """The same, with lower bounds (m,) of the distances while the joints move, as `manipplan_intervals` says."""
        arrays = [np.ascontiguousarray(each, dtype=float) for each in (q, slopes, reach, bends)]
        places, bodies = [each.ctypes.data for each in arrays], self.bodies(pairs)
        found, bound = np.empty(len(q)), np.empty(len(q))
        with self._lock:
            self._call["intervals"](
                self._at, *places[:2], len(q), bodies.ctypes.data, *places[2:], found.ctypes.data, bound.ctypes.data
            )
        return found, bound

    def witnesses(self, q: Array, pairs: Numbers) -> Array:
        """For pairs (m,) at q (m, n), (m, 13 + n): as `manipplan_witnesses` says; nan where this kernel cannot tell."""
        q, bodies = np.ascontiguousarray(q, dtype=float), self.bodies(pairs)
        found = np.empty((len(q), 13 + self._n))
        with self._lock:
            self._call["witnesses"](self._at, q.ctypes.data, len(q), bodies.ctypes.data, found.ctypes.data)
        return found

    def nearest_triangle(self, q: Array, pair: int) -> Array | None:
        """Corners (3, 3) of the triangle of a pair's second body nearest to the first at q (n,); None if it has none."""
        one = np.ascontiguousarray(q, dtype=float)[None]
        leaf = int(self._pairs(one, self._bodies[pair : pair + 1], np.full(1, np.inf))[1][0])
        return self._arrays["corners"][leaf].reshape(3, 3) if leaf >= 0 else None

    def _pairs(self, q: Array, bodies: Numbers, reach: Array) -> tuple[Array, Numbers]:
        found, leaf, reach = np.empty(len(q)), np.empty(len(q), dtype=np.int64), np.ascontiguousarray(reach, dtype=float)
        places = (q.ctypes.data, len(q), bodies.ctypes.data, reach.ctypes.data, found.ctypes.data, leaf.ctypes.data)
        with self._lock:
            self._call["pairs"](self._at, *places)
        return found, leaf


def _arrays(
    calls: Calls, robot: Robot, geometry: pin.GeometryModel, radii: Array, closed: Collection[int]
) -> dict[str, NDArray[Any]]:
    """The arrays of `World`, and the bodies of each pair, the moving one first."""
    model, objects = robot.model, list(geometry.geometryObjects)
    joint = np.array([item.parentJoint for item in objects], dtype=np.int64)
    arrays: dict[str, NDArray[Any]] = {
        "fixed": np.array([_flat(place) for place in model.jointPlacements[1:]]).reshape(-1, 12),
        "axes": np.array([axis_of(joint) for joint in model.joints[1:]]),
        "slides": np.array([is_prismatic(joint) for joint in model.joints[1:]], dtype=np.int64),
        "joint": joint,
        **_shapes(objects, radii, closed),
    }
    pairs = np.array([(p.first, p.second) for p in geometry.collisionPairs], dtype=np.int64).reshape(-1, 2)
    swapped = joint[pairs[:, 0]] == 0
    pairs[swapped] = pairs[swapped, ::-1]
    arrays |= _pair_tables(pairs, joint)
    arrays |= _groups(arrays["mover"], joint, arrays["ball"])
    still = np.array(sorted(set(pairs[joint[pairs[:, 1]] == 0, 1].tolist())), dtype=np.int64)
    around = zip(objects, arrays["ball"], arrays["radius"], strict=True)
    arrays["local"] = np.array([_box_around(item, ball, radius) for item, ball, radius in around]).reshape(-1, 6)
    arrays |= _trees(calls, objects, still, arrays["local"], arrays["radius"])
    return {name: np.ascontiguousarray(array) for name, array in arrays.items()}


def _flat(place: pin.SE3) -> Array:
    """Rotation by rows and origin (12,)."""
    return np.concatenate([np.asarray(place.rotation).ravel(), np.asarray(place.translation)])


def _shapes(objects: Sequence[pin.GeometryObject], radii: Array, closed: Collection[int]) -> dict[str, NDArray[Any]]:
    """The arrays that describe each object's shape; the trees of surfaces are built later."""
    count = len(objects)
    kind, first, number = (np.zeros(count, dtype=np.int64) for _ in range(3))
    radius, pose, size, ball = radii.astype(float).copy(), np.zeros((count, 12)), np.zeros((count, 3)), np.zeros((count, 4))
    cores: list[Array] = []
    begin = 0
    for k, item in enumerate(objects):
        shape, place = item.geometry, item.placement
        pose[k] = _flat(place)
        if isinstance(shape, coal.Box):
            kind[k], size[k] = BOX, shape.halfSide
            ball[k] = *place.translation, np.linalg.norm(shape.halfSide)
        elif isinstance(shape, coal.Cylinder):
            kind[k], size[k, :2] = CYLINDER, (shape.radius, shape.halfLength)
            ball[k] = *place.translation, np.hypot(shape.radius, shape.halfLength)
        elif isinstance(shape, coal.Halfspace):
            turn = pin.Quaternion.FromTwoVectors(np.array([0.0, 0.0, 1.0]), np.asarray(shape.n)).matrix()
            kind[k], pose[k] = HALFSPACE, _flat(place * pin.SE3(turn, shape.d * np.asarray(shape.n)))
            ball[k, 3] = ENDLESS
        elif isinstance(shape, coal.Sphere | coal.Capsule | coal.ConvexBase):
            points, around = core_of(shape)
            points = points @ place.rotation.T + place.translation
            kind[k], first[k], number[k] = POINTS, begin, len(points)
            radius[k] += around
            ball[k] = _ball(points)
            cores.append(points)
            begin += len(points)
        elif isinstance(shape, coal.BVHModelBase) and item.parentJoint == 0:
            kind[k], size[k, 0] = SURFACE, k in closed
            ball[k] = _ball(np.array(shape.vertices()) @ place.rotation.T + place.translation)
        elif isinstance(shape, coal.BVHModelBase):  # a moving mesh is left to coal where it is near
            kind[k], ball[k] = UNKNOWN, _ball(np.array(shape.vertices()) @ place.rotation.T + place.translation)
        else:
            kind[k], ball[k, 3] = UNKNOWN, ENDLESS
        ball[k, 3] += radius[k]
    points = np.concatenate([*cores, np.zeros((1, 3))])
    named = {"kind": kind, "first": first, "count": number, "radius": radius, "pose": pose, "size": size, "ball": ball}
    return named | {axis: points[:, i].copy() for i, axis in enumerate("xyz")}


def _ball(points: Array) -> Array:
    """Centre and radius (4,) of a ball around points (k, 3), seldom much larger than the least one."""
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    for step in range(2, 12):  # towards the farthest point [badoiu2003]
        far = points[np.argmax(((points - centre) ** 2).sum(axis=1))]
        centre = centre + (far - centre) / step / 2
    return np.array([*centre, np.sqrt(((points - centre) ** 2).sum(axis=1).max())])


def _pair_tables(pairs: Numbers, joint: Numbers) -> dict[str, Numbers]:
    """Pairs of two moving bodies as a list (`self`), those of a moving and a static one as a table (`mover`, `pair_of`)."""
    meets_still = joint[pairs[:, 1]] == 0
    several = set(pairs[meets_still, 0].tolist())  # np.unique imports numpy.ma
    mover = np.array(sorted(several, key=lambda body: (joint[body], body)), dtype=np.int64)
    row = {int(body): k for k, body in enumerate(mover)}
    pair_of = np.full((len(mover), len(joint)), -1, dtype=np.int64)
    numbers = np.flatnonzero(meets_still)
    pair_of[[row[body] for body in pairs[numbers, 0].tolist()], pairs[numbers, 1]] = numbers
    alone = np.flatnonzero(~meets_still)
    return {"pair_bodies": pairs, "mover": mover, "pair_of": pair_of, "self": np.column_stack([pairs[alone], alone])}


def _groups(mover: Numbers, joint: Numbers, ball: Array) -> dict[str, NDArray[Any]]:
    """For each joint its range in `mover`, and a ball around the bodies there."""
    first = np.flatnonzero(np.diff(joint[mover], prepend=-1))
    number = np.diff(np.append(first, len(mover)))
    balls = []
    for at, count in zip(first, number, strict=True):
        own = ball[mover[at : at + count]]
        low, high = (own[:, :3] - own[:, 3:]).min(axis=0), (own[:, :3] + own[:, 3:]).max(axis=0)
        centre = (low + high) / 2
        balls.append([*centre, (np.linalg.norm(own[:, :3] - centre, axis=1) + own[:, 3]).max()])
    group = np.column_stack([joint[mover[first]], first, number])
    return {"group": group, "group_ball": np.array(balls).reshape(-1, 4)}


def _trees(
    calls: Calls, objects: Sequence[pin.GeometryObject], still: Numbers, local: Array, radius: Array
) -> dict[str, NDArray[Any]]:
    """One tree per static surface, then the tree over all static bodies; `top` is the root of the last, -1 without any."""
    root = np.full(len(objects), -1, dtype=np.int64)
    triangles = {
        int(k): mesh_triangles(objects[k].geometry) @ objects[k].placement.rotation.T + objects[k].placement.translation
        for k in still
        if isinstance(objects[k].geometry, coal.BVHModelBase)
    }
    nodes = 2 * (sum(map(len, triangles.values())) + len(still))
    node_box, node = np.empty((nodes, 6)), np.empty((nodes, 2), dtype=np.int64)
    boxes = local[still]
    free = begin = 0
    for row, k in enumerate(still.tolist()):
        if k in triangles:
            corners = triangles[k]
            box = np.concatenate([corners.min(axis=1), corners.max(axis=1)], axis=1)
            root[k] = free
            free = _grow(calls, box, np.arange(begin, begin + len(corners)), free, node_box, node)
            begin += len(corners)
            boxes[row] = node_box[root[k]] + np.repeat([-radius[k], radius[k]], 3)
    top = free if len(still) else -1
    if len(still):
        _grow(calls, boxes, still, free, node_box, node)
    corners = np.concatenate([each.reshape(-1, 9) for each in triangles.values()] + [np.zeros((1, 9))])
    return {"node_box": node_box, "node": node, "root": root, "corners": corners, "top": np.array([top])}


def _grow(calls: Calls, box: Array, names: Numbers, root: int, node_box: Array, node: Numbers) -> int:
    """Build a tree over boxes (k, 6) from node `root` on; returns the next free node."""
    box, items, names = np.ascontiguousarray(box), np.arange(len(box)), np.ascontiguousarray(names, dtype=np.int64)
    given = (box.ctypes.data, items.ctypes.data, len(box), names.ctypes.data, root, node_box.ctypes.data, node.ctypes.data)
    return int(calls.functions["tree"](*given))


def _box_around(item: pin.GeometryObject, ball: Array, radius: float) -> Array:
    """Least and largest corner (6,) of an axis-parallel box around an object, in its joint's frame."""
    shape, place = item.geometry, item.placement
    if isinstance(shape, coal.Box):
        half = np.abs(place.rotation) @ shape.halfSide + radius
        return np.concatenate([place.translation - half, place.translation + half])
    if ball[3] < ENDLESS and isinstance(shape, coal.ConvexBase):
        points = core_of(shape)[0] @ place.rotation.T + place.translation
        return np.concatenate([points.min(axis=0) - radius, points.max(axis=0) + radius])
    if ball[3] < ENDLESS:
        return np.concatenate([ball[:3] - ball[3], ball[:3] + ball[3]])
    return np.repeat([-ENDLESS, ENDLESS], 3)
