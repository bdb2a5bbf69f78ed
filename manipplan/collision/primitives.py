"""Convex shapes as coal has them: a primitive with its pose, the points that span a shape, the triangles of a mesh."""

import hashlib
from dataclasses import dataclass

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.robots.hulls import box_corners
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
