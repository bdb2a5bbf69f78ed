"""What both formats of MoveIt share: poses, planes and triangles."""

import logging

import numpy as np
import pinocchio as pin

from manipplan.collision.shapes import Plane
from manipplan.robots.hulls import FARTHEST
from manipplan.support.checks import Array, finite_array, unit_quaternion
from manipplan.support.errors import InvalidInputError

log = logging.getLogger("manipplan")


def pose_of(argument: str, position: Array, quaternion: Array) -> pin.SE3:
    """The pose of a position (3,) [m] and a quaternion x, y, z, w; zeros mean no rotation, as in MoveIt."""
    finite_array("position", position, (3,), most=FARTHEST)
    if not np.any(quaternion):
        log.warning("%s is 0 0 0 0, which is no rotation: taken as none, as in MoveIt", argument)
        return pin.SE3(np.eye(3), position)
    return pin.SE3(pin.Quaternion(unit_quaternion(argument, quaternion, "x, y, z, w")).matrix(), position)


def half_space(argument: str, coefficients: Array) -> Plane:
    """The half-space a x + b y + c z + d <= 0 of `coefficients` (4,)."""
    size = float(np.linalg.norm(finite_array(argument, coefficients, (4,), most=FARTHEST)[:3]))
    if not size > 0:
        raise InvalidInputError(argument, coefficients.tolist(), "a plane with a normal other than zero")
    normal = coefficients[:3] / size
    distance = float(coefficients[3]) / size
    if not abs(distance) <= FARTHEST:
        raise InvalidInputError(argument, coefficients.tolist(), f"a plane within {FARTHEST:g} m")
    turn = pin.Quaternion.FromTwoVectors(np.array([0.0, 0.0, 1.0]), normal).matrix()
    return Plane(position=-distance * normal, rotation=turn)


def triangles_of(argument: str, vertices: Array, corners: Array) -> Array:
    """Triangles (t, 3, 3) of vertices (v, 3) and the numbers of their corners (t, 3), from 0."""
    if not np.isin(corners, np.arange(len(vertices))).all():
        raise InvalidInputError(argument, f"vertex {corners.max():g}", f"vertices 0 to {len(vertices) - 1}")
    return np.asarray(vertices[corners.astype(int)])
