"""Meshes of the world as coal shapes: the solids and surfaces that their triangles are, or the hulls of their parts."""

import logging
from dataclasses import dataclass
from pathlib import Path

import coal
import numpy as np
from numpy.typing import NDArray

from manipplan.collision.surfaces.shells import Shell, find_components, merge_corners, shells
from manipplan.robots.hulls import FARTHEST, Hull, find_hull
from manipplan.robots.mesh_files import read_mesh, triangle_tree
from manipplan.support.checks import Array
from manipplan.support.errors import InvalidInputError

log = logging.getLogger("manipplan")

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
        return (Hull(corners=self.corners, faces=self.faces).shape if self.convex else self._tree)()

    def _tree(self) -> coal.CollisionGeometry:
        return triangle_tree(self.corners, self.faces)


def mesh_parts(argument: str, triangles: Array) -> list[MeshPart]:
    """The parts of triangles (t, 3, 3) [m]."""
    parts = [_part(shell) for shell in shells(triangles)]
    if not parts:
        raise InvalidInputError(
            argument, f"{len(triangles)} triangles, none with an area", "at least one triangle with an area"
        )
    return parts


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
    if not hulls:
        raise InvalidInputError(
            argument, f"{len(triangles)} triangles, none with an area", "at least one triangle with an area"
        )
    return hulls


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
    local = shell.triangles - corners.mean(axis=0)
    volume = np.einsum("ti,ti->", local[:, 0], np.cross(local[:, 1], local[:, 2])) / 6
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
    normals = np.cross(some[:, 1] - some[:, 0], some[:, 2] - some[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    heights = corners @ normals.T - np.einsum("ti,ti->t", normals, some[:, 0])
    return bool(heights.max() > CLEAR * np.ptp(corners, axis=0).max())
