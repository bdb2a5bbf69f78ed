"""Polygons of mesh files, split into triangles; concave ones without covering what is outside them."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from manipplan.support.checks import Array


def split_polygons(vertices: Array, polygons: Sequence[Sequence[int] | NDArray[Any]]) -> Array:
    """Triangles (t, 3, 3) of polygons, each given by the indices of its corners in `vertices` (v, 3).

    Polygons with fewer than three corners are lines or points and have no triangles.
    """
    sizes = np.array([len(each) for each in polygons], dtype=np.int64)
    found = []
    for size in np.unique(sizes[sizes >= 3]):
        corners = vertices[np.array([polygons[k] for k in np.flatnonzero(sizes == size).tolist()], dtype=np.int64)]
        found.append(_triangles(corners))
    return np.concatenate([np.empty((0, 3, 3)), *found])


@np.errstate(over="ignore", invalid="ignore")
def moved_triangles(triangles: Array, transform: Array) -> Array:
    """Triangles (t, 3, 3) moved by a transform (4, 4); one that mirrors them keeps their outward sides.

    Corners that become inf or NaN are refused with the mesh.
    """
    moved = triangles @ transform[:3, :3].T + transform[:3, 3]
    return np.asarray(moved[:, ::-1] if np.linalg.det(transform[:3, :3]) < 0 else moved)


@np.errstate(over="ignore", invalid="ignore")
def _triangles(corners: Array) -> Array:
    """Triangles (t, 3, 3) of polygons (k, c, 3) with c corners each. Corners that are too large are refused with the mesh."""
    if corners.shape[1] == 3:
        return corners
    along = np.roll(corners, -1, axis=1) - corners
    normal = np.cross(corners, np.roll(corners, -1, axis=1)).sum(axis=1)
    turns = np.einsum("kci,ki->kc", np.cross(np.roll(along, 1, axis=1), along), normal)
    convex = (turns >= -1e-9 * np.abs(turns).max(axis=1, keepdims=True)).all(axis=1)
    once = np.arange(1, corners.shape[1] - 1)
    fans = [corners[convex][:, [0, k, k + 1]] for k in once]
    ears = [_ears(polygon, n) for polygon, n in zip(corners[~convex], normal[~convex], strict=True)]
    return np.concatenate([*fans, *ears])


def _ears(corners: Array, normal: Array) -> Array:
    """Triangles (c - 2, 3, 3) of one concave polygon (c, 3), by cutting off ears in the plane of `normal` (3,)."""
    away = int(np.abs(normal).argmax())
    flat = np.delete(corners, away, axis=1) * [1.0, 1.0 if (away == 1) ^ (normal[away] > 0) else -1.0]
    left, found = list(range(len(corners))), []
    while len(left) > 3:
        k = next((k for k in range(len(left)) if _is_ear(flat, left, k)), 0)
        found.append([left[k - 1], left[k], left[(k + 1) % len(left)]])
        del left[k]
    return np.asarray(corners[[*found, left]])


def _is_ear(flat: Array, left: Sequence[int], k: int) -> bool:
    """Whether corner k of the polygon can be cut off: it is convex, and no other corner is inside."""
    a, b, c = (flat[left[j % len(left)]] for j in (k - 1, k, k + 1))
    others = flat[[j for j in left if not any((flat[j] == corner).all() for corner in (a, b, c))]].reshape(-1, 2)
    sides = np.array([_turn(p, q, others) for p, q in ((a, b), (b, c), (c, a))])
    return bool(_turn(a, b, c) > 0 and not (sides >= 0).all(axis=0).any())


def _turn(p: Array, q: Array, r: Array) -> Array:
    """Positive where p, q and r (..., 2) turn left."""
    return np.asarray((q[0] - p[0]) * (r[..., 1] - p[1]) - (q[1] - p[1]) * (r[..., 0] - p[0]))
