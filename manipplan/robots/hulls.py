"""Convex hulls of mesh corners, judged before coal sees them: it crashes where they are as good as flat, or very far away."""

import coal
import numpy as np

from manipplan.support.checks import Array

#: A body is flat when it is thinner than this share of its longest side.
FLAT = 1e-6
#: How far from its frame a corner of a mesh may be [m].
FARTHEST = 1e6


def has_hull(corners: Array) -> bool:
    """Whether corners (k, 3) [m] span a volume, and are near enough for rounding to leave it."""
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
