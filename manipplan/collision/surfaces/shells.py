"""The connected parts of a mesh: which of them enclose a solid, which are cavities in another, which are open."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from manipplan.robots.mesh_files import first_of_rows
from manipplan.support.checks import Array
from manipplan.support.kernels import load_kernel

#: Corners nearer to each other than this, along each axis, are one [m].
MERGED = 1e-9
#: Minimum volume of a closed part, as a share of its area times its extent: below it the part is a surface.
HOLLOW = 1e-9
#: Minimum number of triangles that enclose a volume.
LEAST = 4

Faces = NDArray[np.int64]


@dataclass(frozen=True, kw_only=True)
class Shell:
    """A part of a mesh.

    Attributes:
        triangles: (t, 3, 3) [m]; of a closed part they face outward, and inward around its cavities.
        closed: whether the triangles enclose a volume.
    """

    triangles: Array
    closed: bool


@dataclass(frozen=True, kw_only=True)
class _ConnectedPart:
    """A part connected by edges: its triangles with an area, its signed volume, and whether the file gives its orientation."""

    triangles: Array
    volume: float
    oriented: bool

    @property
    def closed(self) -> bool:
        """Whether it encloses a volume."""
        area = 0.5 * np.linalg.norm(_normals(self.triangles), axis=1).sum()
        return bool(abs(self.volume) > HOLLOW * area * np.ptp(self.triangles.reshape(-1, 3), axis=0).max())


def find_components(triangles: Array) -> list[Array]:
    """Triangles (t, 3, 3) in groups that share corners; those without an area are left out."""
    corners, faces = merge_corners(triangles)
    parts = [corners[faces[part]] for part in _find_components(faces, len(corners))]
    return [part[_has_area(part)] for part in parts if _has_area(part).any()]


def shells(triangles: Array) -> list[Shell]:
    """The parts of triangles (t, 3, 3) [m]: each closed one with its cavities, and all open ones together.

    A closed part that is inside out is turned, unless it is a cavity: inside another closed part and opposite to it.
    """
    corners, faces = merge_corners(triangles)
    faces = _once(faces)
    groups = _edge_connected(faces)
    parts = [_part(corners, faces[group]) for group in groups if len(group) >= LEAST]
    parts = [part for part in parts if len(part.triangles)]
    closed = [part for part in parts if part.closed]
    surfaces = [part.triangles for part in parts if not part.closed]
    few = [group for group in groups if len(group) < LEAST]
    loose = corners[faces[np.concatenate(few)]] if few else np.empty((0, 3, 3))
    surfaces += [loose[_has_area(loose)]] if _has_area(loose).any() else []
    found = []
    holes = _cavities(closed)
    for k, part in enumerate(closed):
        if k in holes:
            continue
        inside = [closed[hole].triangles for hole, outer in holes.items() if outer == k]
        whole = np.concatenate([part.triangles, *inside])
        found.append(Shell(triangles=whole if part.volume > 0 else whole[:, ::-1], closed=True))
    if surfaces:
        found.append(Shell(triangles=np.concatenate(surfaces), closed=False))
    return found


def merge_corners(triangles: Array) -> tuple[Array, Faces]:
    """Corners (v, 3) without doubles, and the faces (f, 3) that have three different ones."""
    points = triangles.reshape(-1, 3)
    first, index = first_of_rows(points)
    corners, merged = _merge(points[first])
    faces = merged[index].reshape(-1, 3)
    return corners, faces[(faces != np.roll(faces, 1, axis=1)).all(axis=1)]


def _merge(points: Array) -> tuple[Array, Faces]:
    """Points (k, 3) of which those within `MERGED` of each other are one, and for each of (v, 3) its place among these."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components
    from scipy.spatial import cKDTree

    near = cKDTree(points).query_pairs(MERGED, output_type="ndarray") if len(points) else np.empty((0, 2), dtype=int)
    if not len(near):
        return points, np.arange(len(points))
    links = coo_matrix((np.ones(len(near)), near.T), shape=(len(points), len(points)))
    _, merged = connected_components(links, directed=False)
    first = np.unique(merged, return_index=True)[1]
    return points[first], merged.astype(np.int64)


def winding_number(triangles: Array, points: Array) -> Array:
    """How often closed triangles (t, 3, 3) go around each of points (k, 3), by `winding.c`: 1 inside, 0 outside."""
    triangles, points = np.ascontiguousarray(triangles, dtype=float), np.ascontiguousarray(points, dtype=float)
    found = np.empty(len(points))
    _winding()(triangles.ctypes.data, len(triangles), points.ctypes.data, len(points), found.ctypes.data)
    return found


@cache
def _winding() -> Callable[..., Any]:
    return load_kernel("winding").functions()["winding"]


def _find_components(faces: Faces, corners: int) -> list[Faces]:
    """Numbers of the faces of each part that is connected by shared corners."""
    if not len(faces):
        return []
    ends = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]]])
    return _groups(_components(ends, corners)[faces[:, 0]])


def _edge_connected(faces: Faces) -> list[Faces]:
    """Numbers of the faces of each part that is connected by shared edges."""
    if not len(faces):
        return []
    _, edge = np.unique(_edge_keys(_edges(faces)), return_inverse=True)
    links = np.stack([np.tile(np.arange(len(faces)), 3), len(faces) + edge], axis=1)
    return _groups(_components(links, len(faces) + int(edge.max()) + 1)[: len(faces)])


def _once(faces: Faces) -> Faces:
    """The faces without doubles of the same orientation, each beginning with its smallest corner."""
    turns = (np.arange(3) + faces.argmin(axis=1)[:, None]) % 3
    faces = np.take_along_axis(faces, turns, axis=1)
    return faces[np.sort(first_of_rows(faces)[0])]


def _components(links: Faces, count: int) -> Faces:
    """The component of each of `count` nodes that links (k, 2) connect."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    graph = coo_array((np.ones(len(links)), (links[:, 0], links[:, 1])), shape=(count, count))
    return np.asarray(connected_components(graph, directed=False)[1])


def _groups(labels: Faces) -> list[Faces]:
    """Indices of equal labels, in the order in which the labels first appear."""
    _, first, label, sizes = np.unique(labels, return_index=True, return_inverse=True, return_counts=True)
    parts = np.split(np.argsort(label, kind="stable"), np.cumsum(sizes)[:-1])
    return [parts[k] for k in np.argsort(first)]


def _part(corners: Array, faces: Faces) -> _ConnectedPart:
    """A part connected by edges, oriented if it is closed."""
    faces = _one_sided(faces)
    flat = ~_has_area(corners[faces])
    if flat.all():
        return _ConnectedPart(triangles=np.empty((0, 3, 3)), volume=0.0, oriented=False)
    tries = [faces, faces[~flat]] if flat.any() else [faces]  # a triangle without an area can join its neighbours, or be loose
    found = next((each for each in tries if _is_cycle(each)), None)
    oriented = found is not None
    if found is None:
        once = [each[first_of_rows(np.sort(each, axis=1))[0]] for each in tries]
        found = next((turned for turned in map(_orient, once) if turned is not None), None)
    if found is None:
        return _ConnectedPart(triangles=corners[faces[~flat]], volume=0.0, oriented=False)
    triangles = corners[found]
    volume = _volume(triangles)
    triangles = triangles[_has_area(triangles)]
    if not oriented and volume < 0:
        triangles, volume = triangles[:, ::-1], -volume
    return _ConnectedPart(triangles=triangles, volume=volume, oriented=oriented)


def _one_sided(faces: Faces) -> Faces:
    """The faces once each, if every one of them is there with both orientations, as some programs write them."""
    first, index = first_of_rows(np.sort(faces, axis=1))
    return faces[np.sort(first)] if (np.bincount(index) == 2).all() else faces


def _is_cycle(faces: Faces) -> bool:
    """Whether every edge is passed as often in one direction as in the other: the faces are closed and oriented."""
    edges = _edges(faces)
    forward = edges[:, 0] < edges[:, 1]
    if 2 * np.count_nonzero(forward) != len(edges):
        return False
    one, other = (np.sort(_edge_keys(each)) for each in (edges[forward], edges[~forward]))
    return bool((one == other).all())


def _orient(faces: Faces) -> Faces | None:
    """The faces with one orientation, if each edge has exactly two of them and they can be oriented; otherwise None.

    Each face stands twice in a graph, as it is and turned; neighbours are linked so that their common edge is passed in both
    directions. Faces that can be oriented are then two components, one for each side.
    """
    edges = _edges(faces)
    keys = _edge_keys(edges)
    order = np.argsort(keys, kind="stable")
    if len(keys) % 2 or (np.diff(keys[order].reshape(-1, 2), axis=1) != 0).any():
        return None
    pairs = order.reshape(-1, 2)
    if (np.diff(keys[pairs[:, 0]]) == 0).any():
        return None
    first, second = (pairs % len(faces)).T
    is_turned = edges[pairs[:, 0], 0] == edges[pairs[:, 1], 0]  # both pass the edge in one direction: one has to be turned
    count = len(faces)
    links = [
        np.stack([first, second + count * is_turned], axis=1),
        np.stack([first + count, second + count * ~is_turned], axis=1),
    ]
    labels = _components(np.concatenate(links), 2 * count)
    if (labels[:count] == labels[count:]).any():
        return None
    patch = np.minimum(labels[:count], labels[count:])
    turn = labels[:count] != patch
    return np.where(turn[:, None], faces[:, ::-1], faces)


def _edges(faces: Faces) -> Faces:
    """Directed edges (3 f, 2), edge k of face i in row k f + i."""
    return np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])


def _edge_keys(edges: Faces) -> Faces:
    """One number per edge, the same for both directions."""
    return np.asarray(edges.min(axis=1) << 32 | edges.max(axis=1))


def _cavities(parts: Sequence[_ConnectedPart]) -> dict[int, int]:
    """Of each part that is a cavity, the part around it."""
    if len(parts) < 2 or all(part.volume > 0 for part in parts):
        return {}
    low = np.array([part.triangles.min(axis=(0, 1)) for part in parts])
    high = np.array([part.triangles.max(axis=(0, 1)) for part in parts])
    size = np.abs([part.volume for part in parts])
    around: dict[int, int] = {}
    for k in np.argsort(-size).tolist():
        outer = np.flatnonzero((low < low[k]).all(axis=1) & (high > high[k]).all(axis=1) & (size > size[k]))
        corner = parts[k].triangles[:1, 0]
        holders = [j for j in outer.tolist() if abs(winding_number(parts[j].triangles, corner)[0]) > 0.5]
        nearest = min(holders, key=lambda j: float(size[j]), default=None)
        if nearest is None or nearest in around or not parts[k].oriented:
            continue
        if (parts[k].volume > 0) != (parts[nearest].volume > 0):
            around[k] = nearest
    return around


def _normals(triangles: Array) -> Array:
    """Normals (t, 3), twice as long as the areas."""
    return np.asarray(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]))


def _has_area(triangles: Array) -> NDArray[np.bool_]:
    """Whether the height of each triangle exceeds `MERGED`."""
    sides = np.linalg.norm(triangles - np.roll(triangles, 1, axis=1), axis=2).max(axis=1)
    return np.asarray(np.linalg.norm(_normals(triangles), axis=1) > MERGED * sides)


def _volume(triangles: Array) -> float:
    """The signed volume of closed triangles; positive when they face outward."""
    local = triangles - triangles.reshape(-1, 3).mean(axis=0)
    return float(np.einsum("ti,ti->", local[:, 0], np.cross(local[:, 1], local[:, 2])) / 6)
