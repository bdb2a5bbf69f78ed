"""The arrays that describe an arm among obstacles for `distances.c`.

Convex shapes as coal has them: a primitive with its pose, the points that span a shape, the triangles of a mesh.
"""

import hashlib
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.surfaces import find_components
from manipplan.robots.hulls import box_corners
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array


@dataclass(frozen=True, kw_only=True)
class Primitive:
    """A coal shape, its pose in the frame of the enclosed points, and its volume [m³]."""

    shape: coal.ShapeBase
    placement: pin.SE3
    volume: float


def outside(primitive: Primitive, points: Array) -> Array:
    """Distances (k,) of `points` (k, 3) outside the primitive (the largest along an axis for a box) [m]; 0 for those inside."""
    local = (points - primitive.placement.translation) @ primitive.placement.rotation
    core, radius = core_of(primitive.shape)
    if isinstance(primitive.shape, coal.Box):
        return np.asarray(np.maximum((np.abs(local) - primitive.shape.halfSide).max(axis=1), 0.0))
    low, high = core[:, 2].min(), core[:, 2].max()
    local[:, 2] -= np.clip(local[:, 2], low, high)
    return np.asarray(np.maximum(np.linalg.norm(local, axis=1) - radius, 0.0))


def core_of(shape: coal.CollisionGeometry) -> tuple[Array, float]:
    """Points (k, 3) and a radius [m] such that the shape lies in the convex hull of balls about the points.

    Exact for spheres, capsules, boxes and convex hulls; a cylinder is taken as the capsule around it.
    """
    if isinstance(shape, coal.Sphere):
        return np.zeros((1, 3)), float(shape.radius)
    if isinstance(shape, coal.Capsule | coal.Cylinder):
        return np.array([[0.0, 0.0, -shape.halfLength], [0.0, 0.0, shape.halfLength]]), float(shape.radius)
    if isinstance(shape, coal.Box):
        signs = np.array(np.meshgrid([-1, 1], [-1, 1], [-1, 1])).reshape(3, -1).T
        return np.asarray(signs * shape.halfSide), 0.0
    if isinstance(shape, coal.ConvexBase):
        return np.array(shape.points()), 0.0
    if isinstance(shape, coal.BVHModelBase):
        return np.array(shape.vertices()), 0.0
    return box_corners(shape), 0.0


def mesh_triangles(mesh: coal.BVHModelBase) -> Array:
    """Corners (t, 3, 3) of a mesh's triangles [m]."""
    corners, faces = _arrays(mesh)
    return np.asarray(corners[faces])


def mesh_key(mesh: coal.BVHModelBase) -> bytes:
    """Digest of a mesh's corners and triangles."""
    corners, faces = _arrays(mesh)
    digest = hashlib.sha256(len(corners).to_bytes(8, "big"))
    digest.update(np.ascontiguousarray(corners, dtype=float).data)
    digest.update(np.ascontiguousarray(faces, dtype=np.int32).data)
    return digest.digest()


def _arrays(mesh: coal.BVHModelBase) -> tuple[Array, NDArray[np.int64]]:
    """The corners (v, 3) of a mesh [m], and the indices (t, 3) of those of each triangle."""
    if "arrays" in vars(mesh):  # it was made by `triangle_tree`
        corners, faces = mesh.arrays
        return corners, faces
    triangles = [[t[0], t[1], t[2]] for t in map(mesh.tri_indices, range(mesh.num_tris))]
    return np.array(mesh.vertices()), np.array(triangles, dtype=np.int64)


#: As in distances.c.
POINTS, BOX, CYLINDER, HALFSPACE, SURFACE, UNKNOWN = range(6)
#: Half the size of the box around an unbounded shape [m].
ENDLESS = 1e9

Numbers = NDArray[np.int64]
#: `manipplan_tree` of distances.c.
Tree = Callable[..., Any]


def world_arrays(
    tree: Tree, robot: Robot, objects: Sequence[pin.GeometryObject], pairs: Numbers, radii: Array, closed: Collection[int]
) -> dict[str, NDArray[Any]]:
    """The arrays of `World`, and the bodies of each pair, the moving one first.

    The arguments are those of `kernel_of`, and the function that builds trees.
    """
    joint = np.array([item.parentJoint for item in objects], dtype=np.int64)
    arms = robot.tree
    arrays: dict[str, NDArray[Any]] = {
        **{name: getattr(arms, name) for name in ("leader", "ratio", "offset", "before", "carries", "fixed", "axes")},
        "slides": arms.slides.astype(np.int64),
        "joint": joint,
        **_shapes(objects, radii, closed),
    }
    pairs = np.where((joint[pairs[:, 0]] == 0)[:, None], pairs[:, ::-1], pairs)
    arrays |= _pair_tables(pairs, joint)
    arrays |= _groups(arrays["mover"], joint, arrays["ball"])
    arrays |= _blocks(arrays["self"], joint, arrays["ball"])
    still = _numbers_in(pairs[joint[pairs[:, 1]] == 0, 1], len(objects))
    around = zip(objects, arrays["ball"], arrays["radius"], strict=True)
    arrays["local"] = np.array([_box_around(item, ball, radius) for item, ball, radius in around]).reshape(-1, 6)
    arrays |= _trees(tree, objects, still, pairs, arrays)
    return {name: np.ascontiguousarray(array) for name, array in arrays.items()}


def _numbers_in(some: Numbers, count: int) -> Numbers:
    """The different numbers in `some`, all below `count`, sorted; np.unique imports numpy.ma."""
    return np.flatnonzero(np.bincount(some, minlength=count))


def _flat(placement: pin.SE3) -> Array:
    """Rotation by rows and origin (12,)."""
    return np.concatenate([np.asarray(placement.rotation).ravel(), np.asarray(placement.translation)])


def _shapes(objects: Sequence[pin.GeometryObject], radii: Array, closed: Collection[int]) -> dict[str, NDArray[Any]]:
    """The arrays that describe each object's shape; the trees of surfaces are built later."""
    count = len(objects)
    kind, first, number = (np.zeros(count, dtype=np.int64) for _ in range(3))
    radius, pose, size, ball = radii.astype(float).copy(), np.zeros((count, 12)), np.zeros((count, 3)), np.zeros((count, 4))
    cores: list[Array] = []
    begin = 0
    for k, item in enumerate(objects):
        shape, placement = item.geometry, item.placement
        pose[k] = _flat(placement)
        if isinstance(shape, coal.Box):
            kind[k], size[k] = BOX, shape.halfSide
            ball[k] = *placement.translation, np.linalg.norm(shape.halfSide)
        elif isinstance(shape, coal.Cylinder):
            kind[k], size[k, :2] = CYLINDER, (shape.radius, shape.halfLength)
            ball[k] = *placement.translation, np.hypot(shape.radius, shape.halfLength)
        elif isinstance(shape, coal.Halfspace):
            turn = pin.Quaternion.FromTwoVectors(np.array([0.0, 0.0, 1.0]), np.asarray(shape.n)).matrix()
            kind[k], pose[k] = HALFSPACE, _flat(placement * pin.SE3(turn, shape.d * np.asarray(shape.n)))
            ball[k, 3] = ENDLESS
        elif isinstance(shape, coal.Sphere | coal.Capsule | coal.ConvexBase):
            points, around = core_of(shape)
            points = points @ placement.rotation.T + placement.translation
            kind[k], first[k], number[k] = POINTS, begin, len(points)
            radius[k] += around
            ball[k] = _ball(points)
            cores.append(points)
            begin += len(points)
        elif isinstance(shape, coal.BVHModelBase):
            kind[k], size[k, 0] = SURFACE, k in closed
            ball[k] = _ball(np.array(shape.vertices()) @ placement.rotation.T + placement.translation)
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
    several = _numbers_in(pairs[meets_still, 0], len(joint))
    mover = several[np.argsort(joint[several], kind="stable")]
    row = np.zeros(len(joint), dtype=np.int64)
    row[mover] = np.arange(len(mover))
    pair_of = np.full((len(mover), len(joint)), -1, dtype=np.int64)
    numbers = np.flatnonzero(meets_still)
    pair_of[row[pairs[numbers, 0]], pairs[numbers, 1]] = numbers
    alone = np.flatnonzero(~meets_still)
    alone = alone[np.lexsort(joint[pairs[alone]].T)]
    return {"pair_bodies": pairs, "mover": mover, "pair_of": pair_of, "self": np.column_stack([pairs[alone], alone])}


def _groups(mover: Numbers, joint: Numbers, ball: Array) -> dict[str, NDArray[Any]]:
    """For each joint its range in `mover`, and a ball around the bodies there."""
    first, number = _runs(joint[mover][:, None])
    balls = [_ball_around(ball[mover[at : at + count]]) for at, count in zip(first, number, strict=True)]
    group = np.column_stack([joint[mover[first]], first, number])
    return {"group": group, "group_ball": np.array(balls).reshape(-1, 4)}


def _blocks(alone: Numbers, joint: Numbers, ball: Array) -> dict[str, NDArray[Any]]:
    """For each pair of joints its range in the pairs `alone` of moving bodies, and for each of the two a ball around them."""
    joints = joint[alone[:, :2]]
    first, number = _runs(joints)
    balls = [
        [*_ball_around(ball[alone[at : at + count, 0]]), *_ball_around(ball[alone[at : at + count, 1]])]
        for at, count in zip(first, number, strict=True)
    ]
    return {"block": np.column_stack([joints[first], first, number]), "block_ball": np.array(balls).reshape(-1, 8)}


def _runs(rows: Numbers) -> tuple[Numbers, Numbers]:
    """Where equal rows that follow each other begin, and how many there are."""
    first = np.flatnonzero((np.diff(rows, axis=0, prepend=-1) != 0).any(axis=1))
    return first, np.diff(np.append(first, len(rows)))


def _ball_around(balls: Array) -> Array:
    """Centre and radius (4,) of a ball around balls (k, 4)."""
    low, high = (balls[:, :3] - balls[:, 3:]).min(axis=0), (balls[:, :3] + balls[:, 3:]).max(axis=0)
    centre = (low + high) / 2
    return np.array([*centre, (np.linalg.norm(balls[:, :3] - centre, axis=1) + balls[:, 3]).max()])


def _trees(
    tree: Tree, objects: Sequence[pin.GeometryObject], still: Numbers, pairs: Numbers, arrays: Mapping[str, NDArray[Any]]
) -> dict[str, NDArray[Any]]:
    """One tree per surface that is checked, then the tree over all static bodies `still`: its root is `top`, -1 without any."""
    local, radius, closed = arrays["local"], arrays["radius"], arrays["size"][:, 0]
    root, probes = np.full(len(objects), -1, dtype=np.int64), np.zeros((len(objects), 2), dtype=np.int64)
    surface = arrays["kind"] == SURFACE
    checked = _numbers_in(pairs.ravel(), len(objects))
    triangles = {k: placed_triangles(objects[k]) for k in checked[surface[checked]].tolist()}
    facing = set(pairs[surface[pairs].all(axis=1) & (closed[pairs] > 0).any(axis=1)].ravel().tolist())
    nodes = 2 * (sum(map(len, triangles.values())) + len(still))
    node_box, node = np.empty((nodes, 6)), np.empty((nodes, 2), dtype=np.int64)
    probe = [np.zeros((0, 3))]
    first, count, ordered = arrays["first"].copy(), arrays["count"].copy(), [np.zeros((0, 3, 3))]
    free = begin = held = 0
    boxes = local[still]
    for k, corners in triangles.items():
        box = np.concatenate([corners.min(axis=1), corners.max(axis=1)], axis=1)
        root[k], first[k], count[k] = free, begin, len(corners)
        order = np.arange(len(corners))
        free = _grow(tree, box, begin + order, free, node_box, node, order)
        _number_leaves(node[root[k] : free], begin, order)
        ordered.append(corners[order])
        begin += len(corners)
        boxes[still == k] = node_box[root[k]] + np.repeat([-radius[k], radius[k]], 3)
        if k in facing:  # a solid is connected, so that one point decides whether it is inside another
            parts = [corners] if closed[k] > 0 else find_components(corners)
            probe.append(np.array([part[0, 0] for part in parts]))
            probes[k] = held, len(parts)
            held += len(parts)
    top = free if len(still) else -1
    if len(still):
        _grow(tree, boxes, still, free, node_box, node, np.arange(len(still)))
    leaves = np.concatenate([*ordered, np.zeros((1, 3, 3))])
    return {
        "first": first,
        "count": count,
        "node_box": node_box,
        "node": node,
        "root": root,
        "corners": leaves.reshape(-1, 9),
        **{f"leaf_{axis}": leaves[:, :, i].copy() for i, axis in enumerate("xyz")},
        "top": np.array([top]),
        "probes": probes,
        "probe": np.concatenate([*probe, np.zeros((1, 3))]),
    }


def placed_triangles(item: pin.GeometryObject) -> Array:
    """Corners (t, 3, 3) of the triangles of a mesh in the frame of its joint [m]."""
    return np.asarray(mesh_triangles(item.geometry) @ item.placement.rotation.T + item.placement.translation)


def _grow(tree: Tree, box: Array, names: Numbers, root: int, node_box: Array, node: Numbers, order: Numbers) -> int:
    """Build a tree over boxes (k, 6) from node `root` on, and sort `order` (k,), the numbers 0 to k - 1, as its leaves follow.

    Returns the next free node.
    """
    box, names = np.ascontiguousarray(box), np.ascontiguousarray(names, dtype=np.int64)
    given = (box.ctypes.data, order.ctypes.data, len(box), names.ctypes.data, root, node_box.ctypes.data, node.ctypes.data)
    return int(tree(*given))


def _number_leaves(node: Numbers, begin: int, order: Numbers) -> None:
    """Give the leaves of a tree (k, 2), which `order` sorts, the numbers from `begin` on as they follow each other."""
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    leaf = node[:, 0] < 0
    node[leaf, 1] = begin + rank[node[leaf, 1] - begin]


def _box_around(item: pin.GeometryObject, ball: Array, radius: float) -> Array:
    """Least and largest corner (6,) of an axis-parallel box around an object, in its joint's frame."""
    shape, placement = item.geometry, item.placement
    if isinstance(shape, coal.Box):
        half = np.abs(placement.rotation) @ shape.halfSide + radius
        return np.concatenate([placement.translation - half, placement.translation + half])
    if ball[3] < ENDLESS and isinstance(shape, coal.ConvexBase | coal.BVHModelBase):
        points = core_of(shape)[0] @ placement.rotation.T + placement.translation
        return np.concatenate([points.min(axis=0) - radius, points.max(axis=0) + radius])
    if ball[3] < ENDLESS:
        return np.concatenate([ball[:3] - ball[3], ball[:3] + ball[3]])
    return np.repeat([-ENDLESS, ENDLESS], 3)
