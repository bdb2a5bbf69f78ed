"""How far a body sticks out of the shape that it stands for, measured at points on the body."""

import coal
import numpy as np

from manipplan.collision.primitives import mesh_triangles
from manipplan.collision.surfaces.shells import winding_number
from manipplan.support.checks import Array

#: Number of points on a capsule at which its excess is measured, besides its two poles.
SAMPLES = 400
#: Number of points that are tested at a time for whether they are inside.
BLOCK = 32
#: Angle about the axis from one point of a capsule to the next [rad]: the golden angle spreads them evenly.
TURN = np.pi * (3 - 5**0.5)


def capsule_excess(start: Array, end: Array, radius: float, shape: coal.CollisionGeometry) -> float:
    """The largest distance [m] by which a capsule sticks out of `shape`, measured at SAMPLES points.

    Args:
        start, end: (3,) ends of its axis in the frame of the shape [m]; equal for a sphere.
        radius: [m].
        shape: that the capsule stands for; a mesh counts as solid where its triangles enclose a point.
    """
    points = capsule_points(start, end, radius)
    distances = distances_to(points, shape)
    order = np.argsort(-distances)
    if not isinstance(shape, coal.BVHModelBase):
        return float(distances[order[0]])
    triangles = mesh_triangles(shape)
    for k in range(0, len(order), BLOCK):
        some = order[k : k + BLOCK]
        outside = np.abs(winding_number(triangles, points[some])) < 0.5
        if outside.any():
            return float(distances[some[outside.argmax()]])
    return 0.0


def capsule_points(start: Array, end: Array, radius: float) -> Array:
    """SAMPLES points spread evenly over a capsule, and its two poles (k, 3) [m]."""
    length = float(np.linalg.norm(end - start))
    axis = (end - start) / length if length > 0 else np.array([0.0, 0.0, 1.0])
    side = np.cross(axis, np.eye(3)[np.abs(axis).argmin()])
    side /= np.linalg.norm(side)
    reach = length / 2 + radius
    # as on a ball, the area between two planes normal to the axis is that of the cylinder around it
    along = np.concatenate([reach * (2 * (np.arange(SAMPLES) + 0.5) / SAMPLES - 1), [-reach, reach]])
    beyond = np.maximum(np.abs(along) - length / 2, 0.0)
    around = np.sqrt(np.maximum(radius**2 - beyond**2, 0.0))
    turn = TURN * np.arange(len(along))
    circle = np.cos(turn)[:, None] * side + np.sin(turn)[:, None] * np.cross(axis, side)
    return np.asarray((start + end) / 2 + along[:, None] * axis + around[:, None] * circle)


def distances_to(points: Array, shape: coal.CollisionGeometry) -> Array:
    """Distances (k,) of points (k, 3) from a shape [m]; 0 inside it, but inside a mesh the distance from its surface."""
    # a box, since coal's distance of a sphere from a degenerate triangle is wrong
    point, still, request = coal.Box(1e-9, 1e-9, 1e-9), coal.Transform3s(), coal.DistanceRequest()
    found = [
        coal.distance(point, coal.Transform3s(np.eye(3), each), shape, still, request, coal.DistanceResult()) for each in points
    ]
    return np.asarray(np.maximum(found, 0.0))
