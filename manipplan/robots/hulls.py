"""Convex hulls of mesh corners, from flat, tiny, huge or very fine meshes alike.

Qhull computes each hull in a cube of edge 1. Coal only takes the result: its own hulls crash on corners whose sizes differ by
1e17, and it lists at most 254 neighbours of a corner, fewer than the tip of a fine cone has.
"""

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
FEW, SLACK, ROUNDING = 100, 1e-4, 1e-12
#: Maximum number of neighbours of a corner in coal.
MOST_NEIGHBOURS = 254


def has_hull(corners: Array) -> bool:
    """Whether corners (k, 3) [m] span a volume, and are near enough to their frame that rounding preserves it."""
    if len(corners) < 4 or not np.abs(corners).max() <= FARTHEST:
        return False
    middle = corners - corners.mean(axis=0)
    sides = np.ptp(middle @ np.linalg.svd(middle, full_matrices=False)[2].T, axis=0)
    return bool(sides.min() > max(FLAT * sides.max(), 1e-9)) and _qhull(corners) is not None


def has_few_neighbours(corners: Array) -> bool:
    """Whether coal takes the hull of corners (k, 3) [m] for which `has_hull` is true."""
    return _most_neighbours(_qhull(corners)) <= MOST_NEIGHBOURS


def convex_hull(corners: Array) -> coal.Convex:
    """The hull of corners (k, 3) [m] for which `has_hull` and `has_few_neighbours` are true."""
    hull = _qhull(corners)
    number = np.full(len(corners), -1)
    number[hull.vertices] = np.arange(len(hull.vertices))
    points, faces = coal.StdVec_Vec3s(), coal.StdVec_Triangle()
    points.extend(corners[hull.vertices])
    faces.extend(coal.Triangle(*each) for each in number[_outward(hull)].tolist())
    return coal.Convex(points, faces)


def hull_triangles(corners: Array) -> Array:
    """Triangles (t, 3, 3) of the hull of corners (k, 3) [m] for which `has_hull` is true; they face outward."""
    return np.asarray(corners[_outward(_qhull(corners))])


def outer_corners(corners: Array) -> Array:
    """Corners (c, 3) whose hull contains that of corners (k, 3) [m] with a volume, and which coal takes as one body.

    These are the corners of the hull itself, unless a corner has too many neighbours, or half as many corners do that stick out
    by less than SLACK.
    """
    hull = _qhull(corners)
    own = corners[hull.vertices]
    fits = _most_neighbours(hull) <= MOST_NEIGHBOURS
    if fits and len(own) <= FEW:
        return np.asarray(own)
    most = len(own) // 2 if fits else MOST_NEIGHBOURS
    slack = SLACK
    while (found := _few_planes(hull, most, slack)) is None and not fits:
        slack *= 2
    low, size = corners.min(axis=0), float(np.ptp(corners, axis=0).max())
    return np.asarray(own if found is None else low + size * found)


def _few_planes(hull: Any, most: int, slack: float) -> Array | None:
    """Corners (c, 3), at most `most`, where planes through some faces of a hull meet; None if they are more.

    From the six sides of a box on, each step adds the faces behind which corners lie by more than `slack`.
    """
    from scipy.spatial import HalfspaceIntersection

    faces = hull.equations[np.unique(hull.equations.round(9), axis=0, return_index=True)[1]]
    points = hull.points[hull.vertices]
    axes = np.concatenate([np.eye(3), -np.eye(3)])
    chosen = np.column_stack([axes, -(points @ axes.T).max(axis=0)])
    while True:
        corners = HalfspaceIntersection(chosen - ROUNDING * np.array([0, 0, 0, 1]), points.mean(axis=0)).intersections
        corners = np.unique(corners[np.isfinite(corners).all(axis=1)].round(12), axis=0)
        if len(corners) > most:
            return None
        beyond = corners @ faces[:, :3].T + faces[:, 3]
        far = np.unique(beyond.argmax(axis=1)[beyond.max(axis=1) > slack])
        if not len(far):
            return np.asarray(corners)
        chosen = np.concatenate([chosen, faces[far]])


def _most_neighbours(hull: Any) -> int:
    """The largest number of neighbours of a corner: as many as triangles around it."""
    return int(np.bincount(hull.simplices.ravel()).max())


def _outward(hull: Any) -> NDArray[np.int64]:
    """Indices (t, 3) of the corners of each triangle of a hull, in the order in which it faces outward."""
    triangles = hull.simplices.copy()
    a, b, c = (hull.points[triangles[:, k]] for k in range(3))
    inward = np.einsum("ti,ti->t", np.cross(b - a, c - a), hull.equations[:, :3]) < 0
    triangles[inward] = triangles[inward][:, ::-1]
    return np.asarray(triangles)


def _qhull(corners: Array) -> Any:
    """The hull by Qhull, of the corners moved and scaled into a cube of edge 1; None where they are too flat."""
    from scipy.spatial import ConvexHull, QhullError

    low, size = corners.min(axis=0), float(np.ptp(corners, axis=0).max())
    try:
        return ConvexHull((corners - low) / size, qhull_options="Qt")
    except QhullError:
        return None
