"""The balls inside the bodies of an arm."""

from dataclasses import dataclass

import coal
import numpy as np
import pinocchio as pin

from manipplan.support.checks import Array

#: Subtracted from every radius [m].
ROUNDING = 1e-6
#: Number of steps towards the centre of a hull.
STEPS = 60


@dataclass(frozen=True, kw_only=True, eq=False)
class Ball:
    """A ball inside a body: centre (3,) in the frame of the body's joint, and radius [m]."""

    centre: Array
    radius: float


def inscribed_ball(item: pin.GeometryObject, around: float = 0.0) -> Ball | None:
    """A large ball inside a convex body; None where none is known.

    Args:
        item: a coal Sphere, Capsule, Cylinder, Box or convex hull, posed in its joint's frame.
        around: distance around the shape that belongs to the body as well [m].
    """
    shape, place = item.geometry, item.placement
    middle, radius = np.zeros(3), 0.0
    if isinstance(shape, coal.Sphere | coal.Capsule):
        radius = float(shape.radius)
    elif isinstance(shape, coal.Cylinder):
        radius = float(min(shape.radius, shape.halfLength))
    elif isinstance(shape, coal.Box):
        radius = float(np.min(shape.halfSide))
    elif isinstance(shape, coal.ConvexBase):
        middle, radius = _in_hull(np.array(shape.points()))
    radius += around - ROUNDING
    if radius <= 0:
        return None
    return Ball(centre=np.asarray(place.rotation @ middle + place.translation), radius=radius)


def _in_hull(points: Array) -> tuple[Array, float]:
    """Centre and radius of a ball inside the hull of points (k, 3): step by step the centre leaves the nearest face."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        hull = ConvexHull(points, qhull_options="Qt")
    except QhullError:
        return np.zeros(3), 0.0
    faces, centre = hull.equations, points[hull.vertices].mean(axis=0)
    best, most = centre, -np.inf
    for step in range(STEPS):
        inside = -(faces[:, :3] @ centre + faces[:, 3])
        nearest = int(inside.argmin())
        if inside[nearest] > most:
            best, most = centre, float(inside[nearest])
        centre = centre - abs(most) / (2 + step) * faces[nearest, :3]
    return best, most
