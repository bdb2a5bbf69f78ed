"""A robot's links as capsules and spheres, whose distances have closed forms.

Signed distances between convex primitives in closed form, as CasADi expressions for a control step.

The expressions have no branches: both sides of every choice are finite, and they compile to plain C. A capsule's axis is
a + s u with s in [0, 1]; u = 0 makes a sphere, whose constant terms are folded when the expression is built.
"""

import logging
from dataclasses import dataclass, field
from functools import cached_property

import casadi as ca
import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from manipplan.collision.build import TOUCHING, self_pairs
from manipplan.collision.covers import capsule_excess
from manipplan.collision.model import CollisionModel
from manipplan.collision.stored_fits import find_or_cut, find_or_fit
from manipplan.collision.world import core_of
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
    def _fit(cls, robot: Robot) -> "CapsuleBodies":
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
    placement = pin.SE3(rotation, (body.start + body.end) / 2)
    shape = coal.Capsule(body.radius, length) if length > 0 else coal.Sphere(body.radius)
    return pin.GeometryObject(body.name, body.joint, frame, placement, shape)


def _that_can_meet(
    robot: Robot, geometry: pin.GeometryModel, pairs: NDArray[np.int64], dropped: dict[tuple[str, str], str]
) -> tuple[tuple[int, int], ...]:
    """Of pairs (k, 2), those apart in the neutral configuration that touch in some, but not too many, of the random ones."""
    model = CollisionModel(robot, geometry, pairs, {})
    samples = [robot.neutral, *robot.random_configuration(np.random.default_rng(0), size=SAMPLES)]
    distances = model.distance_rows(np.array(samples), beyond=TOUCHING)
    checked = []
    for k, (first, second) in enumerate(pairs.tolist()):
        touching = np.count_nonzero(distances[1:, k] <= 0)
        if distances[0, k] <= 0:
            dropped[model.pair_names[k]] = "the capsules touch in the neutral configuration"
        elif touching > COARSE * SAMPLES:
            dropped[model.pair_names[k]] = f"the capsules touch in {touching} of {SAMPLES} random configurations"
        elif touching == 0:
            dropped[model.pair_names[k]] = f"the capsules touch in none of {SAMPLES} random configurations"
        else:
            checked.append((first, second))
    return tuple(checked)


@once_per_owner
def _bodies(robot: Robot) -> CapsuleBodies:
    return CapsuleBodies._fit(robot)


#: Lengths below this define no direction, and a coordinate that changes less along an axis counts as constant [m].
_SMALL = 1e-9
#: Squared sine of the angle below which two axes count as parallel and the middle of the first is preferred; where such
#: axes touch, their distance is too large by up to 5e-8 of the first one's length.
_PARALLEL = 1e-14
#: Squared sine above which the cross product of two axes is a well-defined direction.
_CROSSED = 1e-12
_TINY, _HUGE = 1e-150, 1e150


@dataclass(frozen=True, kw_only=True)
class SymbolicCapsule:
    """All points within `radius` [m] of the segment from `start` to `end`, (3, 1) in the world; a sphere without `end`."""

    start: ca.SX
    end: ca.SX | None = None
    radius: float

    @property
    def axis(self) -> ca.SX:
        """From start to end, (3, 1); zero for a sphere."""
        return ca.SX.zeros(3) if self.end is None else self.end - self.start


@dataclass(frozen=True, kw_only=True)
class SymbolicBox:
    """The box of half sizes `half` [m] along the columns of `rotation` (3, 3), about `centre` (3, 1) in the world."""

    rotation: ca.SX
    centre: ca.SX
    half: tuple[float, ...]


@dataclass(frozen=True, kw_only=True)
class SymbolicPlane:
    """The half-space normalᵀ x <= offset: unit normal (3, 1) out of the body, offset [m]."""

    normal: ca.SX
    offset: ca.SX


@dataclass(frozen=True, kw_only=True)
class NearestPoints:
    """The nearest points of two bodies, with first - second = distance · normal.

    Attributes:
        distance: signed [m], negative where the two overlap.
        normal: (3, 1) unit vector from the second body to the first.
        first: (3, 1) nearest point on the surface of the first body, in the world [m].
        second: (3, 1) the same on the second body.
    """

    distance: ca.SX
    normal: ca.SX
    first: ca.SX
    second: ca.SX


def nearest(first: SymbolicCapsule, second: SymbolicCapsule | SymbolicBox | SymbolicPlane) -> NearestPoints:
    """Signed distance and nearest points of a capsule or sphere and another body.

    If they overlap, the distance is minus the length of the shortest translation that separates them. Its gradient under
    translation of the first body is the normal. It is exact to 1e-9 m for a box, otherwise to rounding.
    """
    match second:
        case SymbolicCapsule():
            return _from_capsule(first, second)
        case SymbolicBox():
            return _from_box(first, second)
        case SymbolicPlane():
            return _from_plane(first, second)


def _from_capsule(first: SymbolicCapsule, second: SymbolicCapsule) -> NearestPoints:
    """The nearest points a + s u and c + t v of two segments minimise a quadratic over the unit square."""
    u, v, offset = first.axis, second.axis, first.start - second.start
    uu, vv, uv, uo, vo = ca.sumsqr(u), ca.sumsqr(v), ca.dot(u, v), ca.dot(u, offset), ca.dot(v, offset)
    area, product = uu * vv - uv * uv, uu * vv
    # the pull to s = 1/2 selects one of the solutions of parallel axes, and keeps the divisor positive
    pull = _PARALLEL * product + _TINY
    s = _within((uv * vo - vv * uo + 0.5 * pull) / (area + pull))
    t = _within((uv * s + vo) / ca.fmax(vv, _TINY))
    # the same s, unless t was clipped
    s = _within((uv * t - uo) / ca.fmax(uu, _TINY))
    point = first.start + s * u
    apart = point - (second.start + t * v)
    square = ca.sumsqr(apart)
    # intersecting axes are separated perpendicular to both
    across = ca.if_else(area > _CROSSED * product + _TINY, ca.cross(u, v), _perpendicular(ca.if_else(vv > uu, v, u)))
    direction = ca.if_else(square > _SMALL**2, apart, across)
    normal = direction / ca.norm_2(direction)
    return _part_points(point, normal, ca.sqrt(square), first.radius, second.radius)


def _from_plane(first: SymbolicCapsule, second: SymbolicPlane) -> NearestPoints:
    """The lower end is nearest; the middle if both are equally high."""
    slope = ca.dot(second.normal, first.axis)
    point = first.start + 0.5 * (1 - ca.sign(slope)) * first.axis
    return _part_points(point, second.normal, ca.dot(second.normal, point) - second.offset, first.radius, 0.0)


def _from_box(first: SymbolicCapsule, second: SymbolicBox) -> NearestPoints:
    """In the box's frame; an axis that enters the box is first moved out, and touches the box where it is nearest."""
    half = ca.SX(ca.DM(second.half))
    start, u = second.rotation.T @ (first.start - second.centre), second.rotation.T @ first.axis
    depth, out = _way_out(start, u, half)
    moved = start + ca.fmax(depth, 0) * out
    s = _nearest_to_box(moved, u, half)
    point = moved + s * u
    apart = point - ca.fmin(ca.fmax(point, -half), half)
    square = ca.sumsqr(apart)
    outside, length = square > _SMALL**2, ca.sqrt(square)
    normal = second.rotation @ ca.if_else(outside, apart / ca.fmax(length, _SMALL), out)
    return _part_points(first.start + s * first.axis, normal, ca.if_else(outside, length, -depth), first.radius, 0.0)


def _way_out(start: ca.SX, u: ca.SX, half: ca.SX) -> tuple[ca.SX, ca.SX]:
    """Shortest move (length, unit vector) that separates the segment from start to start + u from the box; negative if apart.

    It is along the normal of a face of the box, or perpendicular to the segment and an edge: those are the faces of the
    Minkowski sum of the box and the reversed segment.
    """
    middle = start + 0.5 * u
    best, out = ca.SX(_HUGE), ca.SX.zeros(3)
    edges = ca.horzsplit(ca.SX.eye(3))
    # directions, and how far the segment reaches along them from its middle
    ways = [(edge, 0.5 * ca.fabs(ca.dot(edge, u))) for edge in edges]
    if not u.is_zero():
        ways += [(ca.cross(u, edge), ca.SX(0)) for edge in edges]
    for across, reach in ways:
        length = ca.norm_2(across)
        normal = across / ca.fmax(length, _SMALL)
        height = ca.dot(normal, middle)
        # a segment along an edge leaves by a face
        depth = ca.if_else(length > _SMALL, ca.dot(half, ca.fabs(normal)) + reach - ca.fabs(height), _HUGE)
        out = ca.if_else(depth < best, normal * ca.copysign(1, height), out)
        best = ca.fmin(best, depth)
    return best, out


def _nearest_to_box(start: ca.SX, u: ca.SX, half: ca.SX) -> ca.SX:
    """The s in [0, 1] at which start + s u is nearest to the box; the middle of the interval if several are.

    With each coordinate within the box for s in [low, high], half the derivative of the squared distance is
    Σ u_i² (s - clip(s, low_i, high_i)), which rises with s and is linear between any two neighbours of low and high.
    """
    size = ca.fabs(u)
    divisor = ca.fmax(size, _SMALL)
    weight = ca.if_else(size > _SMALL, u**2, 0)
    middle, reach = -start / ca.copysign(divisor, u), half / divisor
    low, high = middle - reach, middle + reach

    def derivative(s: ca.SX, coordinates: list[int]) -> ca.SX:
        clipped = ca.fmin(ca.fmax(s, low[coordinates]), high[coordinates])
        return ca.dot(weight[coordinates], s - clipped)

    last, first = ca.SX(0), ca.SX(1)
    for i in range(3):
        for s in (low[i], high[i]):
            # coordinate i adds nothing here
            slope = derivative(s, [j for j in range(3) if j != i])
            # those on the wrong side are moved out of [0, 1]
            last = ca.fmax(last, _within(s) - (slope > 0))
            first = ca.fmin(first, _within(s) + (slope < 0))
    # both derivatives are zero where many points are nearest, and the share is then one half
    falling, rising = -derivative(last, [0, 1, 2]), derivative(first, [0, 1, 2])
    share = _within((falling + 0.5 * _TINY) / (falling + rising + _TINY))
    return last + share * (first - last)


def _part_points(point: ca.SX, normal: ca.SX, distance: ca.SX, first: float, second: float) -> NearestPoints:
    """From a point of the axis, its distance from the other body's core, the normal and both radii to the surfaces."""
    return NearestPoints(
        distance=distance - (first + second),
        normal=normal,
        first=point - first * normal,
        second=point - (distance - second) * normal,
    )


def _within(s: ca.SX) -> ca.SX:
    return ca.fmin(ca.fmax(s, 0), 1)


def _perpendicular(v: ca.SX) -> ca.SX:
    """A vector perpendicular to v, (3, 1), nonzero even if v is zero."""
    x, y, z = ca.vertsplit(v)
    short = ca.sumsqr(v) <= _SMALL**2
    return ca.if_else(ca.fabs(x) > ca.fabs(z), ca.vertcat(-y, x, short), ca.vertcat(0, -z, y + short))
