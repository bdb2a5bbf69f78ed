"""Convex hulls of mesh corners, from flat, tiny, huge or very fine meshes alike.

Qhull computes each hull in a cube of edge 1. Coal only takes the result: its own hulls crash on corners whose sizes differ by
1e17, and it lists at most 254 neighbours of a corner, fewer than the tip of a fine cone has.
"""

from dataclasses import dataclass
from typing import Any

import coal
import numpy as np
from numpy.typing import NDArray

from manipplan.support.checks import Array

#: A body is flat when it is thinner than this share of its longest side.
FLAT = 1e-6
#: Maximum distance of a mesh corner from its frame and of an obstacle from the origin, along each axis, and maximum size [m].
FARTHEST = 1e6
#: Number of corners below which a hull is not thinned out; by how much one with fewer corners may stick out, as a share of its
#: longest side; and by how much its planes are moved out, so that rounding leaves no corner outside.
FEW, SLACK, ROUNDING = 250, 1e-4, 1e-12
#: Maximum number of neighbours of a corner in coal.
MOST_NEIGHBOURS = 254


def find_hull(corners: Array) -> "Hull | None":
    """The hull of corners (k, 3) [m]; None where they span no volume, or are so far from their frame that rounding hides it."""
    if len(corners) < 4 or not np.abs(corners).max() <= FARTHEST:
        return None
    middle = corners - corners.mean(axis=0)
    extents = np.ptp(middle @ np.linalg.svd(middle, full_matrices=False)[2].T, axis=0)
    if not extents.min() > max(FLAT * extents.max(), 1e-9):
        return None
    hull = _qhull(corners)
    return None if hull is None else _outward(corners, hull)


def box_around(shape: coal.CollisionGeometry) -> tuple[Array, Array]:
    """Lower and upper corner (3,) of the box around a shape, along the axes of its own frame [m]."""
    shape.computeLocalAABB()
    return np.array(shape.aabb_local.min_), np.array(shape.aabb_local.max_)


def box_corners(shape: coal.CollisionGeometry) -> Array:
    """Corners (8, 3) of the box around a shape, in its own frame [m]."""
    return np.array(np.meshgrid(*zip(*box_around(shape), strict=True))).reshape(3, -1).T


@dataclass(frozen=True, kw_only=True, eq=False)
class Hull:
    """A convex body: its corners (k, 3) [m], and the indices (t, 3) of those of each triangle, which faces outward."""

    corners: Array
    faces: NDArray[np.int64]

    @property
    def triangles(self) -> Array:
        """Corners (t, 3, 3) of its triangles [m]."""
        return np.asarray(self.corners[self.faces])

    @property
    def fits_coal(self) -> bool:
        """Whether no corner has more neighbours than coal takes: it has as many as triangles around it."""
        return bool(np.bincount(self.faces.ravel()).max() <= MOST_NEIGHBOURS)

    def shape(self) -> coal.Convex:
        """The body for coal; `fits_coal` has to be true."""
        mesh = coal.BVHModelOBB()  # it takes arrays, coal.Convex lists of triangles
        mesh.beginModel(len(self.faces), len(self.corners))
        mesh.addVertices(np.ascontiguousarray(self.corners))
        mesh.addTriangles(np.ascontiguousarray(self.faces))
        mesh.buildConvexRepresentation(False)
        return mesh.convex


def convex_hull(points: Array) -> Hull:
    """The hull of points (k, 3) [m], of which `find_hull` finds one."""
    return _outward(points, _qhull(points))


def _outward(points: Array, hull: Any) -> Hull:
    """The hull of points (k, 3) [m] that Qhull has found, with triangles that face outward."""
    number = np.full(len(points), -1)
    number[hull.vertices] = np.arange(len(hull.vertices))
    faces = hull.simplices.copy()
    a, b, c = (hull.points[faces[:, k]] for k in range(3))
    inward = np.einsum("ti,ti->t", np.cross(b - a, c - a), hull.equations[:, :3]) < 0
    faces[inward] = faces[inward][:, ::-1]
    return Hull(corners=points[hull.vertices], faces=number[faces])


def outer_hull(exact: Hull) -> Hull:
    """A convex body that coal takes and that contains a hull.

    It is the hull itself, unless a corner has too many neighbours, or half as many corners stick out by less than SLACK.
    """
    if exact.fits_coal and len(exact.corners) <= FEW:
        return exact
    hull, slack = _qhull(exact.corners), SLACK
    most = len(exact.corners) // 2 if exact.fits_coal else MOST_NEIGHBOURS
    while (found := _few_planes(hull, most, slack)) is None and not exact.fits_coal:
        slack *= 2
    low, size = exact.corners.min(axis=0), float(np.ptp(exact.corners, axis=0).max())
    return exact if found is None else convex_hull(low + size * found)


def _few_planes(hull: Any, most: int, slack: float) -> Array | None:
    """Corners (c, 3), at most `most`, where planes through some faces of a hull meet; None if they are more.

    From the six sides of a box on, each step adds the faces behind which corners lie by more than `slack`.
    """
    from scipy.spatial import HalfspaceIntersection

    faces = hull.equations[sort_rows(hull.equations.round(9))]
    points = hull.points[hull.vertices]
    axes = np.concatenate([np.eye(3), -np.eye(3)])
    chosen = np.column_stack([axes, -(points @ axes.T).max(axis=0)])
    while True:
        corners = HalfspaceIntersection(chosen - ROUNDING * np.array([0, 0, 0, 1]), points.mean(axis=0)).intersections
        corners = corners[np.isfinite(corners).all(axis=1)].round(12)
        corners = corners[sort_rows(corners)]
        if len(corners) > most:
            return None
        beyond = corners @ faces[:, :3].T + faces[:, 3]
        farthest = beyond.argmax(axis=1)
        far = np.unique(farthest[beyond[np.arange(len(corners)), farthest] > slack])
        if not len(far):
            return np.asarray(corners)
        if len(chosen) + len(far) > most:  # these planes have about twice as many corners
            return None
        chosen = np.concatenate([chosen, faces[far]])


def sort_rows(rows: Array) -> NDArray[np.int64]:
    """The indices of different rows (k, c), as they follow each other when sorted: as of np.unique, in a fifth of its time."""
    order = np.lexsort(rows.T[::-1])
    new = np.ones(len(rows), dtype=bool)
    new[1:] = (np.diff(rows[order], axis=0) != 0).any(axis=1)
    return order[new]


def _qhull(corners: Array) -> Any:
    """The hull by Qhull, of the corners moved and scaled into a cube of edge 1; None where they are too flat."""
    from scipy.spatial import ConvexHull, QhullError

    low, size = corners.min(axis=0), float(np.ptp(corners, axis=0).max())
    try:
        return ConvexHull((corners - low) / size, qhull_options="Qt")
    except QhullError:
        return None
