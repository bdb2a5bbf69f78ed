"""Straight ways of the tool: the path, and how densely it is searched."""

import numpy as np

from manipplan.paths.cartesian import CartesianPath
from manipplan.support.checks import Array

#: Maximum step of a joint between neighbouring positions of a straight way [rad or m].
STRAIGHT_EPSILON = 0.4
#: Distance between positions on a straight way [m], and their smallest number.
STRIDE, FEWEST = 0.015, 6


def moved_by(way: Array) -> Array:
    """The pose (4, 4) in the tool frame that is a way (3,) off [m]."""
    pose = np.eye(4)
    pose[:3, 3] = way
    return pose


def straight_on(pose: Array, way: Array) -> CartesianPath:
    """The straight path from a pose (4, 4) by a way (3,) in the tool frame [m]."""
    return CartesianPath.line(pose, pose @ moved_by(way))


def positions_on(path: CartesianPath) -> int:
    """Number of positions on a straight path."""
    return max(FEWEST, int(np.ceil(path.length / STRIDE)))
