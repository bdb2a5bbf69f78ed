"""Signed distances between convex primitives in closed form, as CasADi expressions for a control step.

Nothing branches: both sides of every choice are evaluated and finite, so that the expressions compile to plain C of constant
run time. The first body is a capsule or sphere; its axis is a + s u with s in [0, 1], where u = 0 makes a sphere, and what is
constant then folds away when the expression is built.
"""

from dataclasses import dataclass

import casadi as ca

#: Lengths below this give no direction, and a coordinate that changes less along an axis counts as constant [m].
_SMALL = 1e-9
#: Squared sine of the angle below which two axes count as parallel and the middle of the first is preferred; where such
#: axes touch, their distance is too large by up to 5e-8 of the first one's length.
_PARALLEL = 1e-14
#: Squared sine above which the cross product of two axes is a well-defined direction.
_CROSSED = 1e-12
_TINY = 1e-150


@dataclass(frozen=True, kw_only=True)
class Capsule:
    """All points within `radius` [m] of the segment from `start` to `end`, (3, 1) in the world; a sphere without `end`."""

    start: ca.SX
    end: ca.SX | None = None
    radius: float

    @property
    def axis(self) -> ca.SX:
        """From start to end, (3, 1); zero for a sphere."""
        return ca.SX.zeros(3) if self.end is None else self.end - self.start


@dataclass(frozen=True, kw_only=True)
class Box:
    """The box of half sizes `half` [m] along the columns of `rotation` (3, 3), about `centre` (3, 1) in the world."""

    rotation: ca.SX
    centre: ca.SX
    half: tuple[float, ...]


@dataclass(frozen=True, kw_only=True)
class Plane:
    """The half-space normalᵀ x <= offset: unit normal (3, 1) out of the body, offset [m]."""

    normal: ca.SX
    offset: ca.SX


@dataclass(frozen=True, kw_only=True)
class Nearest:
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


def nearest(first: Capsule, second: Capsule | Box | Plane) -> Nearest:
    """Signed distance and nearest points of a capsule or sphere from another body.

    The distance is exact (within 1e-9 m for a box), and its gradient under translation of the first body is the normal, except
    where the axis of a capsule enters a box: the depth there is that of the middle of the stretch inside, below the nearest
    face of the box.
    """
    match second:
        case Capsule():
            return _from_capsule(first, second)
        case Box():
            return _from_box(first, second)
        case Plane():
            return _from_plane(first, second)


def _from_capsule(first: Capsule, second: Capsule) -> Nearest:
    """The nearest points a + s u and c + t v of two segments minimise a quadratic over the unit square."""
    u, v, offset = first.axis, second.axis, first.start - second.start
    uu, vv, uv, uo, vo = ca.sumsqr(u), ca.sumsqr(v), ca.dot(u, v), ca.dot(u, offset), ca.dot(v, offset)
    area, product = uu * vv - uv * uv, uu * vv
    # the pull to s = 1/2 settles which of the solutions of parallel axes is taken, and keeps the divisor positive
    pull = _PARALLEL * product + _TINY
    s = _within((uv * vo - vv * uo + 0.5 * pull) / (area + pull))
    t = _within((uv * s + vo) / ca.fmax(vv, _TINY))
    # no other s than this one where t had to be clipped
    s = _within((uv * t - uo) / ca.fmax(uu, _TINY))
    point = first.start + s * u
    apart = point - (second.start + t * v)
    square = ca.sumsqr(apart)
    longer = ca.if_else(vv > uu, v, u)
    # axes that meet are parted across both
    across = ca.if_else(area > _CROSSED * product + _TINY, ca.cross(u, v), _perpendicular(longer))
    direction = ca.if_else(square > _SMALL**2, apart, across)
    normal = direction / ca.norm_2(direction)
    return _parted(point, normal, ca.sqrt(square), first.radius, second.radius)


def _from_plane(first: Capsule, second: Plane) -> Nearest:
    """The lower end is nearest; the middle where both are equally high."""
    slope = ca.dot(second.normal, first.axis)
    point = first.start + 0.5 * (1 - ca.sign(slope)) * first.axis
    return _parted(point, second.normal, ca.dot(second.normal, point) - second.offset, first.radius, 0.0)


def _from_box(first: Capsule, second: Box) -> Nearest:
    """The box's axes are the coordinates x = x_0 + s u; the point of the axis nearest to the box is found on them."""
    half = ca.SX(ca.DM(second.half))
    start, u = second.rotation.T @ (first.start - second.centre), second.rotation.T @ first.axis
    s = _nearest_to_box(start, u, half)
    local = start + s * u
    apart = local - ca.fmin(ca.fmax(local, -half), half)
    square = ca.sumsqr(apart)
    outside = square > _SMALL**2
    # inside, the way out is through the nearest face
    x, y, z = ca.vertsplit(ca.fabs(local) - half)
    through_x = ca.logic_and(x >= y, x >= z)
    through_y = ca.logic_and(y >= z, ca.logic_not(through_x))
    out = ca.copysign(ca.vertcat(through_x, through_y, 1 - through_x - through_y), local)
    distance = ca.sqrt(square)
    normal = second.rotation @ ca.if_else(outside, apart / ca.fmax(distance, _SMALL), out)
    distance = ca.if_else(outside, distance, ca.fmax(ca.fmax(x, y), z))
    return _parted(first.start + s * first.axis, normal, distance, first.radius, 0.0)


def _nearest_to_box(start: ca.SX, u: ca.SX, half: ca.SX) -> ca.SX:
    """The s in [0, 1] at which start + s u is nearest to the box; the middle of the stretch where several are.

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
        # coordinate i adds nothing at its own two
        others = [j for j in range(3) if j != i]
        for s in (low[i], high[i]):
            slope = derivative(s, others)
            # those on the wrong side are moved out of [0, 1]
            last = ca.fmax(last, _within(s) - (slope > 0))
            first = ca.fmin(first, _within(s) + (slope < 0))
    # both derivatives are zero where many points are nearest, and the share is then one half
    falling, rising = -derivative(last, [0, 1, 2]), derivative(first, [0, 1, 2])
    share = _within((falling + 0.5 * _TINY) / (falling + rising + _TINY))
    return last + share * (first - last)


def _parted(point: ca.SX, normal: ca.SX, distance: ca.SX, first: float, second: float) -> Nearest:
    """From a point of the axis at a distance from the other body's core, along the normal, to the surfaces by their radii."""
    return Nearest(
        distance=distance - (first + second),
        normal=normal,
        first=point - first * normal,
        second=point - (distance - second) * normal,
    )


def _within(s: ca.SX) -> ca.SX:
    return ca.fmin(ca.fmax(s, 0), 1)


def _perpendicular(v: ca.SX) -> ca.SX:
    """Some vector at right angles to v, (3, 1), not zero even where v is."""
    x, y, z = ca.vertsplit(v)
    short = ca.sumsqr(v) <= _SMALL**2
    return ca.if_else(ca.fabs(x) > ca.fabs(z), ca.vertcat(-y, x, short), ca.vertcat(0, -z, y + short))
