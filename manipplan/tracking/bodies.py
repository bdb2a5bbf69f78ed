"""A robot's links as capsules and spheres, whose distances have closed forms."""

import logging
from dataclasses import dataclass, field
from functools import cached_property

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.build import TOUCHING, self_pairs
from manipplan.collision.covers.excess import capsule_excess
from manipplan.collision.covers.stored_fits import find_or_cut, find_or_fit
from manipplan.collision.model import CollisionModel
from manipplan.collision.primitives import core_of
from manipplan.robots.attached import number_names
from manipplan.robots.robot import Robot
from manipplan.support.checks import Array
from manipplan.support.memo import once_per_owner

log = logging.getLogger("manipplan")

#: Number of random configurations that determine which pairs of links can collide.
SAMPLES = 1000
#: Maximum share of them at which the capsules of a pair may touch; above it they are too coarse to be kept apart.
COARSE = 0.1


@dataclass(frozen=True, kw_only=True, eq=False)
class CapsuleBody:
    """A capsule that contains a part of a link.

    Attributes:
        name: of the geometry object, with a number if it has several parts.
        link: the link's name.
        joint: index of the joint that carries it, from 1; 0 is the world.
        start, end: (3,) ends of its axis in the joint's frame [m]; equal for a sphere.
        radius: [m].
        geometry: the object of the robot's description of which it contains a part.
    """

    name: str
    link: str
    joint: int
    start: Array
    end: Array
    radius: float
    geometry: pin.GeometryObject = field(repr=False)

    @cached_property
    def excess(self) -> float:
        """The farthest that it sticks out of its geometry object, measured at about 400 points [m]."""
        ends = [self.geometry.placement.actInv(point) for point in (self.start, self.end)]
        return capsule_excess(ends[0], ends[1], self.radius, self.geometry.geometry)

    def __repr__(self) -> str:
        return f"CapsuleBody({self.name!r}, radius={1e3 * self.radius:.0f} mm, excess={1e3 * self.excess:.0f} mm)"


@dataclass(frozen=True, kw_only=True, eq=False)
class CapsuleBodies:
    """All bodies of a robot, and the pairs of them that have to be kept apart.

    Attributes:
        items: the bodies.
        pairs: indices (first, second) of those that can collide.
        dropped: pairs of names that are not kept apart, with the reason.
    """

    items: tuple[CapsuleBody, ...]
    pairs: tuple[tuple[int, int], ...]
    dropped: dict[tuple[str, str], str]

    @property
    def excess(self) -> float:
        """The farthest that one of the bodies sticks out of the link, as measured [m]; 0 without bodies."""
        return max((body.excess for body in self.items), default=0.0)

    def __repr__(self) -> str:
        return f"CapsuleBodies({len(self.items)} bodies, {len(self.pairs)} pairs, excess={1e3 * self.excess:.0f} mm)"

    @classmethod
    def of(cls, robot: Robot) -> "CapsuleBodies":
        """The capsules of a robot, fitted once."""
        return _bodies(robot)

    @classmethod
    def _fitted(cls, robot: Robot) -> "CapsuleBodies":
        geometry = pin.GeometryModel()
        items: list[CapsuleBody] = []
        origins: list[int] = []
        for origin, item in enumerate(robot.geometry.geometryObjects):
            if isinstance(item.geometry, coal.Halfspace | coal.Plane):  # such as the floor of an MJCF
                log.warning("%s: a controller does not avoid %s; add a Plane to the scene", robot.name, item.name)
                continue
            fitted = _capsules(item.name, item.geometry)
            for name, (start, end, radius) in zip(number_names(item.name, len(fitted)), fitted, strict=True):
                ends = [item.placement.act(point) for point in (start, end)]
                link = robot.link_of(item)
                items.append(
                    CapsuleBody(
                        name=name, link=link, joint=item.parentJoint, start=ends[0], end=ends[1], radius=radius, geometry=item
                    )
                )
                geometry.addGeometryObject(_as_coal(items[-1], item.parentFrame))
                origins.append(origin)
        pairs, dropped = self_pairs(robot, geometry, origins)
        return cls(items=tuple(items), pairs=_that_can_meet(robot, geometry, pairs, dropped), dropped=dropped)


def _capsules(name: str, shape: coal.CollisionGeometry) -> list[tuple[Array, Array, float]]:
    """Ends and radius of capsules that contain a shape, in its own frame."""
    if isinstance(shape, coal.BVHModelBase):  # around the convex pieces that a plan is checked with
        corners = [piece.hull.corners for piece in find_or_cut(shape, name)]
    else:
        points, radius = core_of(shape)
        if len(points) <= 2:
            return [(points[0], points[-1], radius)]
        corners = [points]
    from scipy.spatial import ConvexHull

    found = []
    for primitive in find_or_fit(np.concatenate([each[ConvexHull(each).simplices] for each in corners])):
        points, radius = core_of(primitive.shape)
        ends = [primitive.placement.act(point) for point in (points[0], points[-1])]
        found.append((ends[0], ends[1], radius))
    return found


def _as_coal(body: CapsuleBody, frame: int) -> pin.GeometryObject:
    along = body.end - body.start
    length = float(np.linalg.norm(along))
    rotation = pin.Quaternion.FromTwoVectors(np.array([0.0, 0.0, 1.0]), along).matrix() if length > 0 else np.eye(3)
    place = pin.SE3(rotation, (body.start + body.end) / 2)
    shape = coal.Capsule(body.radius, length) if length > 0 else coal.Sphere(body.radius)
    return pin.GeometryObject(body.name, body.joint, frame, place, shape)


def _that_can_meet(
    robot: Robot, geometry: pin.GeometryModel, pairs: NDArray[np.int64], dropped: dict[tuple[str, str], str]
) -> tuple[tuple[int, int], ...]:
    """Of pairs (k, 2), those apart in the neutral configuration that touch in some, but not too many, of the random ones."""
    model = CollisionModel(robot, geometry, pairs, {})
    samples = [robot.neutral, *robot.random_configuration(np.random.default_rng(0), size=SAMPLES)]
    distances = model.distance_rows(np.array(samples), beyond=TOUCHING)
    kept = []
    for k, (first, second) in enumerate(pairs.tolist()):
        touching = np.count_nonzero(distances[1:, k] <= 0)
        if distances[0, k] <= 0:
            dropped[model.pair_names[k]] = "the capsules touch in the neutral configuration"
        elif touching > COARSE * SAMPLES:
            dropped[model.pair_names[k]] = f"the capsules touch in {touching} of {SAMPLES} random configurations"
        elif touching == 0:
            dropped[model.pair_names[k]] = f"the capsules touch in none of {SAMPLES} random configurations"
        else:
            kept.append((first, second))
    return tuple(kept)


@once_per_owner
def _bodies(robot: Robot) -> CapsuleBodies:
    return CapsuleBodies._fitted(robot)
