"""Convex hulls of mesh corners, checked before coal builds them: it crashes when they are nearly flat or very far away."""

import coal
import numpy as np

from manipplan.support.checks import Array

#: A body is flat when it is thinner than this share of its longest side.
FLAT = 1e-6
#: Maximum distance of a mesh corner from its frame and of an obstacle from the origin, along each axis, and maximum size [m].
FARTHEST = 1e6


def has_hull(corners: Array) -> bool:
    """Whether corners (k, 3) [m] span a volume, and are near enough to their frame that rounding preserves it."""
    from scipy.spatial import ConvexHull, QhullError

    if len(corners) < 4 or not np.abs(corners).max() <= FARTHEST:
        return False
    middle = corners - corners.mean(axis=0)
    sides = np.ptp(middle @ np.linalg.svd(middle, full_matrices=False)[2].T, axis=0)
    if sides.min() <= max(FLAT * sides.max(), 1e-9):
        return False
    try:
        ConvexHull(corners, qhull_options="Qt")
    except QhullError:
        return False
    return True


def convex_hull(corners: Array) -> coal.ConvexBase:
    """The hull of corners (k, 3) [m] for which `has_hull` is true."""
    cloud = coal.BVHModelOBBRSS()
    cloud.beginModel(0, len(corners))
    cloud.addVertices(corners)
    cloud.endModel()
    cloud.buildConvexHull(True, "Qt")
    return cloud.convex
