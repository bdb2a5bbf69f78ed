"""What readers of mesh files share: numbers of a text, counts, and polygons split into triangles."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from manipplan.support.checks import Array

#: Maximum number of corners that are tried in all searches for a next ear; a polygon that crosses itself may have none.
MOST_SEARCHES = 20_000
#: Maximum number of corners of a polygon: the time grows with its square.
MOST_CORNERS = 10_000
#: Maximum number of corners of all concave polygons of one size: each takes some 25 µs.
MOST_CONCAVE = 100_000
#: Maximum number of triangles that are read.
MOST_TRIANGLES = 500_000


def check_count(triangles: int) -> None:
    """Raise ValueError for more triangles, or polygons, than are read, before they are made."""
    if triangles > MOST_TRIANGLES:
        raise ValueError(f"it has {triangles:,} triangles, of at most {MOST_TRIANGLES:,}")


def numbers(text: str, kind: type = float) -> NDArray[Any]:
    """The numbers of a text, (k,), whole ones if `kind` is int. Raises ValueError with the first word that is none."""
    words = text.split()
    if not text.isascii() or "_" in text:  # Python reads ١ and 1_0
        raise ValueError(f"numbers are needed, not {next(word for word in words if not word.isascii() or '_' in word)[:40]!r}")
    return np.array(words, dtype=kind)


def split_polygons(vertices: Array, polygons: Sequence[Sequence[int] | NDArray[Any]]) -> Array:
    """Triangles (t, 3, 3) of polygons, each given by the indices of its corners in `vertices` (v, 3).

    Polygons with fewer than three corners are lines or points and have no triangles.
    """
    sizes = np.array([len(each) for each in polygons], dtype=np.int64)
    if sizes.max(initial=0) > MOST_CORNERS:
        raise ValueError(f"a face with {sizes.max():,} corners, of at most {MOST_CORNERS:,}")
    found = []
    for size in np.unique(sizes[sizes >= 3]):
        corners = vertices[np.array([polygons[k] for k in np.flatnonzero(sizes == size).tolist()], dtype=np.int64)]
        found.append(_triangles(corners))
    return np.concatenate([np.empty((0, 3, 3)), *found])


@np.errstate(over="ignore", invalid="ignore")
def move_triangles(triangles: Array, transform: Array) -> Array:
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
    if (~convex).sum() * corners.shape[1] > MOST_CONCAVE:
        raise ValueError(f"concave faces with more than {MOST_CONCAVE:,} corners in all")
    once = np.arange(1, corners.shape[1] - 1)
    fans = [corners[convex][:, [0, k, k + 1]] for k in once]
    ears = [_ears(polygon, n) for polygon, n in zip(corners[~convex], normal[~convex], strict=True)]
    return np.concatenate([*fans, *ears])


def _ears(corners: Array, normal: Array) -> Array:
    """Triangles (c - 2, 3, 3) of one concave polygon (c, 3), by cutting off ears in the plane of `normal` (3,).

    Only corners that turn right can lie in an ear. Of a polygon that crosses itself, any triangles are returned.
    """
    away = int(np.abs(normal).argmax())
    flat = np.delete(corners, away, axis=1) * [1.0, 1.0 if (away == 1) ^ (normal[away] > 0) else -1.0]
    count = len(corners)
    before, after = np.roll(np.arange(count), 1).tolist(), np.roll(np.arange(count), -1).tolist()
    right = np.array([not _turn(flat[before[k]], flat[k], flat[after[k]]) > 0 for k in range(count)])
    left, found, waiting, searches = dict.fromkeys(range(count)), [], list(range(count))[::-1], 0
    while len(left) > 3:
        k = waiting.pop() if waiting else -1
        if k < 0:  # the ears that were found are cut off: others may have become free
            searches += len(left)
            k = next((each for each in left if _is_ear(flat, before[each], each, after[each], right)), -1)
            if k < 0 and searches < MOST_SEARCHES:
                k = next(iter(left))
            elif k < 0:
                rest = list(left)
                found += [[rest[0], rest[j], rest[j + 1]] for j in range(1, len(rest) - 2)]
                left = dict.fromkeys([rest[0], *rest[-2:]])
                break
        elif k not in left or not _is_ear(flat, before[k], k, after[k], right):
            continue
        found.append([before[k], k, after[k]])
        del left[k]
        right[k] = False
        after[before[k]], before[after[k]] = after[k], before[k]
        for each in (before[k], after[k]):
            right[each] = not _turn(flat[before[each]], flat[each], flat[after[each]]) > 0
            waiting.append(each)
    return np.asarray(corners[[*found, list(left)]])


def _is_ear(flat: Array, first: int, k: int, last: int, right: NDArray[np.bool_]) -> bool:
    """Whether corner k of the polygon, between two others, can be cut off: it turns left, and no corner is inside."""
    if right[k]:
        return False
    a, b, c = flat[first], flat[k], flat[last]
    others = flat[right]
    sides = np.array([_turn(p, q, others) for p, q in ((a, b), (b, c), (c, a))])
    inside = others[(sides >= 0).all(axis=0)]
    return bool(all(any((other == corner).all() for corner in (a, b, c)) for other in inside))


def _turn(p: Array, q: Array, r: Array) -> Array:
    """Positive where p, q and r (..., 2) turn left."""
    return np.asarray((q[0] - p[0]) * (r[..., 1] - p[1]) - (q[1] - p[1]) * (r[..., 0] - p[0]))
