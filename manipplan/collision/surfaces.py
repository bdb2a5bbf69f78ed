"""Meshes of the world as coal shapes: the solids and surfaces that their triangles are, or the hulls of their parts.

The connected parts of a mesh: which of them enclose a solid, which are cavities in another, which are open.
"""

import logging
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import coal
import numpy as np
from numpy.typing import NDArray

from manipplan.robots.hulls import FARTHEST, Hull, find_hull
from manipplan.robots.mesh_files import first_of_rows, read_mesh, triangle_tree
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError
from manipplan.support.kernels import load_kernel

log = logging.getLogger("manipplan")

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
    if not len(faces):
        return []
    ends = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]]])
    parts = [corners[faces[part]] for part in _groups(components(ends, len(corners))[faces[:, 0]])]
    return [part[_has_area(part)] for part in parts if _has_area(part).any()]


def shells(triangles: Array) -> list[Shell]:
    """The parts of triangles (t, 3, 3) [m]: each closed one with its cavities, and all open ones together.

    A closed part that is inside out is turned, unless it is a cavity: inside another closed part and opposite to it.
    """
    corners, faces = merge_corners(triangles)
    faces = _once(faces)
    groups = _edge_connected(faces)
    parts = [_connected_part(corners, faces[group]) for group in groups if len(group) >= LEAST]
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
    from scipy.spatial import cKDTree

    near = cKDTree(points).query_pairs(MERGED, output_type="ndarray") if len(points) else np.empty((0, 2), dtype=int)
    if not len(near):
        return points, np.arange(len(points))
    merged = components(near, len(points))
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


def _edge_connected(faces: Faces) -> list[Faces]:
    """Numbers of the faces of each part that is connected by shared edges."""
    if not len(faces):
        return []
    _, edge = np.unique(_edge_keys(_edges(faces)), return_inverse=True)
    links = np.stack([np.tile(np.arange(len(faces)), 3), len(faces) + edge], axis=1)
    return _groups(components(links, len(faces) + int(edge.max()) + 1)[: len(faces)])


def _once(faces: Faces) -> Faces:
    """The faces without doubles of the same orientation, each beginning with its smallest corner."""
    turns = (np.arange(3) + faces.argmin(axis=1)[:, None]) % 3
    faces = np.take_along_axis(faces, turns, axis=1)
    return faces[np.sort(first_of_rows(faces)[0])]


def components(links: Faces, count: int) -> Faces:
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


def _connected_part(corners: Array, faces: Faces) -> _ConnectedPart:
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
    labels = components(np.concatenate(links), 2 * count)
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


#: Maximum depth of a face below the hull of its part, as a share of the largest coordinate, and in metres: below it the part is
#: convex. The coordinates of most files have 24 bits.
DENT, DEEPEST_DENT = 1e-6, 1e-5
#: Minimum share of its hull that a convex part fills.
FULL = 0.999
#: Maximum number of faces times faces of the hull for which convexity is tested; larger parts stay surfaces.
MOST_PAIRS = 400_000_000
#: Number of faces that are looked at first, and height of a corner above one of them that is not rounding, as a share of the
#: part's extent.
SOME_FACES, CLEAR = 100, 1e-2
#: Rotation that makes the y axis vertical.
FROM_Y = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])


def triangles_of_file(argument: str, file: Path, scale: float, up: str) -> Array:
    """Triangles (t, 3, 3) of a file in its own numbers; warns when its unit or vertical axis differ from `scale` and `up`."""
    mesh = read_mesh(argument, file)
    if mesh.unit != 1.0 and scale == 1.0:
        log.warning("%s is in units of %g m but is read in metres: scale=%g reads it in its unit", file, mesh.unit, mesh.unit)
    if mesh.up in ("x", "y") and mesh.up != up:
        remedy = 'up="y" stands it upright' if mesh.up == "y" else "turn it with rotation="
        log.warning("%s says that its %s axis is vertical, but z is taken: %s", file, mesh.up, remedy)
    return mesh.triangles


def placed_triangles(argument: str, triangles: Array, scale: float, up: str) -> Array:
    """Triangles (t, 3, 3) in metres with z vertical; raises InvalidInputError when one is not finite or too far away."""
    with np.errstate(over="ignore", invalid="ignore"):
        placed = scale * (triangles @ FROM_Y.T if up == "y" else triangles)
    if not (np.abs(placed) <= FARTHEST).all():
        wrong = placed[~(np.abs(placed) <= FARTHEST)][0]
        raise InvalidInputError(argument, f"a corner at {wrong:g} m", f"corners within {FARTHEST:g} m of the origin, none NaN")
    return np.asarray(placed)


@dataclass(frozen=True, kw_only=True, eq=False)
class MeshPart:
    """A part of a mesh.

    Attributes:
        corners: (v, 3) [m].
        faces: (f, 3) indices of the corners of each triangle.
        closed: whether the triangles enclose a solid.
        convex: whether that is convex, and a hull that coal takes.
    """

    corners: Array
    faces: NDArray[np.int64]
    closed: bool
    convex: bool

    @classmethod
    def of_hull(cls, hull: Hull) -> "MeshPart":
        """A hull."""
        return cls(corners=hull.corners, faces=hull.faces, closed=True, convex=hull.fits_coal)

    def shape(self) -> coal.CollisionGeometry:
        """A hull where it is convex, otherwise a tree of triangles."""
        if self.convex:
            return Hull(corners=self.corners, faces=self.faces).shape()
        return triangle_tree(self.corners, self.faces)


def mesh_parts(argument: str, triangles: Array) -> list[MeshPart]:
    """The parts of triangles (t, 3, 3) [m]."""
    return _some(argument, triangles, [_part(shell) for shell in shells(triangles)])


def hull_parts(argument: str, triangles: Array) -> list[MeshPart]:
    """Convex hulls of the connected parts of triangles (t, 3, 3) [m]; raises InvalidInputError when one has no volume."""
    hulls = []
    for part in find_components(triangles):
        corners = np.unique(part.reshape(-1, 3), axis=0)
        hull = find_hull(corners)
        if hull is None:
            wanted = "parts with a volume, which can be filled; one is flat: leave fill out, then it is a surface"
            raise InvalidInputError(argument, f"fill='hull' for {len(triangles)} triangles", wanted)
        hulls.append(MeshPart.of_hull(hull))
    return _some(argument, triangles, hulls)


def _some(argument: str, triangles: Array, parts: list[MeshPart]) -> list[MeshPart]:
    """The parts of triangles (t, 3, 3); raises InvalidInputError where there are none."""
    if not parts:
        got = f"{len(triangles)} triangles, none with an area"
        raise InvalidInputError(argument, got, "at least one triangle with an area")
    return parts


def _part(shell: Shell) -> MeshPart:
    hull = _solid(shell)
    if hull is not None:
        return MeshPart.of_hull(hull)
    corners, faces = merge_corners(shell.triangles)
    return MeshPart(corners=corners, faces=faces, closed=shell.closed, convex=False)


def _solid(shell: Shell) -> Hull | None:
    """The hull of a closed part that is convex, where coal takes it; otherwise None."""
    if not shell.closed:
        return None
    corners, _ = merge_corners(shell.triangles)
    outer = None if _is_clearly_concave(shell.triangles, corners) else find_hull(corners)
    if outer is None or not outer.fits_coal:
        return None
    from scipy.spatial import ConvexHull

    hull = ConvexHull(corners, qhull_options="Qt")
    volume = _volume(shell.triangles)
    pairs = len(shell.triangles) * len(hull.equations)
    if not FULL * hull.volume <= volume <= hull.volume / FULL or pairs > MOST_PAIRS:
        return None
    middles = shell.triangles.mean(axis=1)
    dent = min(DENT * np.abs(corners).max(), DEEPEST_DENT)
    step = max(1, 4_000_000 // len(hull.equations))
    for at in range(0, len(middles), step):  # a face whose middle is on the hull is on the hull as a whole
        heights = middles[at : at + step] @ hull.equations[:, :3].T + hull.equations[:, 3]
        if heights.max(axis=1).min() < -dent:
            return None
    return outer


def _is_clearly_concave(triangles: Array, corners: Array) -> bool:
    """Whether corners (v, 3) are above some of the faces by more than their rounding can explain."""
    some = triangles[:: max(1, len(triangles) // SOME_FACES)]
    normals = _normals(some)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    heights = corners @ normals.T - np.einsum("ti,ti->t", normals, some[:, 0])
    return bool(heights.max() > CLEAR * np.ptp(corners, axis=0).max())
