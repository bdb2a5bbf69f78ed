"""Clouds of points: those of a depth image, fewer of them, and the tree over them that coal takes."""

from typing import Any

import coal
import numpy as np

from manipplan.collision.surfaces.shells import MERGED
from manipplan.robots.hulls import FARTHEST
from manipplan.robots.mesh_files import first_of_rows, triangle_tree
from manipplan.support.checks import Array, ArrayLike, number, number_array
from manipplan.support.errors import InvalidInputError
from manipplan.support.memo import once_per_owner, state_without_memo

#: Distance of the corners of a point's triangle from the point [m]. For triangles without an area coal's distance to a sphere
#: is wrong, by metres.
TINY = 1e-7
TRIANGLE = TINY / np.sqrt(6.0) * np.array([[2.0, -1.0, -1.0], [-1.0, 2.0, -1.0], [-1.0, -1.0, 2.0]])


#: Maximum number of points that are read, and of those that are left after thinning: a tree over them takes 7 s and 1.3 GB per
#: million.
MOST_POINTS, MOST_KEPT = 5_000_000, 500_000


def near_points(argument: str, points: Array) -> Array:
    """Points (k, 3); raises InvalidInputError when there is none, or one is farther away than `FARTHEST`."""
    if not len(points):
        raise InvalidInputError(argument, "no points", "at least one point")
    if len(points) > MOST_POINTS:
        raise InvalidInputError(argument, f"{len(points):,} points", f"at most {MOST_POINTS:,}")
    if not np.abs(points).max() <= FARTHEST:
        raise InvalidInputError(
            argument, f"a point at {np.abs(points).max():g} m", f"points within {FARTHEST:g} m of the origin"
        )
    return points


def thinned(argument: str, points: Array, spacing: float) -> Array:
    """Of points (k, 3), the first in each cube of edge `spacing` [m]; all of them for 0.

    Raises InvalidInputError when more than `MOST_KEPT` are left.
    """
    if spacing != 0.0:
        points = np.asarray(points[np.sort(first_of_rows(np.floor(points / max(spacing, MERGED)))[0])])
    if len(points) > MOST_KEPT:
        wanted = f"at most {MOST_KEPT:,} points after thinning; give a larger spacing"
        raise InvalidInputError(argument, f"{len(points):,} points with a spacing of {spacing:g} m", wanted)
    return points


class Points:
    """Points (k, 3) [m] and the tree over them, which is built when it is first needed."""

    def __init__(self, points: Array) -> None:
        self.points = points

    @once_per_owner
    def tree(self) -> coal.BVHModelOBBRSS:
        """A tree over the points: a triangle of size `TINY` about each."""
        corners = (self.points[:, None] + TRIANGLE).reshape(-1, 3)
        return triangle_tree(corners, np.arange(len(corners)).reshape(-1, 3))

    def __getstate__(self) -> dict[str, Any]:
        return state_without_memo(self)


def depth_points(image: ArrayLike, intrinsics: ArrayLike, farthest: float) -> Array:
    """The points (k, 3) [m], in the camera's frame, of the valid pixels of a depth image (h, w) [m].

    Invalid pixels are 0, negative, not finite or beyond `farthest`. Raises InvalidInputError when none is valid.
    """
    depth = number_array("image", image)
    if depth.ndim != 2:
        raise InvalidInputError("image", f"shape {depth.shape}", "depths of shape (h, w) [m]")
    given = number_array("intrinsics", intrinsics)
    if given.shape == (3, 3):
        given = np.array([given[0, 0], given[1, 1], given[0, 2], given[1, 2]])
    if given.shape != (4,) or not np.isfinite(given).all() or not (given[:2] > 0).all():
        raise InvalidInputError("intrinsics", intrinsics, "fx, fy above zero and cx, cy [pixels], or the matrix (3, 3) of them")
    if farthest != np.inf:
        farthest = number("farthest", farthest, above=0.0)
    with np.errstate(invalid="ignore"):
        rows, columns = np.nonzero(np.isfinite(depth) & (depth > 0) & (depth <= farthest))
    if not len(rows):
        raise InvalidInputError(
            "image", f"no valid pixel of {depth.size}", f"at least one depth above 0, at most {farthest:g} m"
        )
    fx, fy, cx, cy = given
    z = depth[rows, columns]
    return np.stack([(columns - cx) * z / fx, (rows - cy) * z / fy, z], axis=1)
