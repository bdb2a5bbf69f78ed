"""The geometric Paden-Kahan subproblems [murray1994, ch. 3] that closed-form inverse kinematics is built from, for numba.

Vectors are tuples of three floats: numba keeps them in registers. Where a subproblem misses a solution by less than `GRAZE`,
two guesses next to the nearest point are returned, since an arm may differ from its closed form by the rounding of its
description. All solutions are refined and verified by forward kinematics afterwards.
"""

import math

from manipplan.support.compiling.kernels import kernel

#: Maximum amount by which a cosine may exceed 1.
GRAZE = 1e-3

Vector = tuple[float, float, float]
#: Cosine and sine of an angle: trigonometric functions are evaluated for the resulting angles only.
Turn = tuple[float, float]


@kernel
def dot(a: Vector, b: Vector) -> float:
    """Scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@kernel
def cross(a: Vector, b: Vector) -> Vector:
    """Vector product."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


@kernel
def add(a: Vector, b: Vector) -> Vector:
    """The sum a + b."""
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


@kernel
def sub(a: Vector, b: Vector) -> Vector:
    """The difference a - b."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


@kernel
def turned(h: Vector, turn: Turn, v: Vector) -> Vector:
    """`v` rotated about the unit axis h (Rodrigues)."""
    c, s = turn
    along = dot(h, v) * (1.0 - c)
    w = cross(h, v)
    return (c * v[0] + s * w[0] + along * h[0], c * v[1] + s * w[1] + along * h[1], c * v[2] + s * w[2] + along * h[2])


@kernel
def turned_about(h: Vector, p: Vector, turn: Turn, v: Vector) -> Vector:
    """The point `v` rotated about the axis h through the point p."""
    return add(p, turned(h, turn, sub(v, p)))


@kernel
def back(turn: Turn) -> Turn:
    """The inverse rotation."""
    return (turn[0], -turn[1])


@kernel
def angle(turn: Turn) -> float:
    """The angle of a rotation, in [-π, π]."""
    return math.atan2(turn[1], turn[0])


@kernel
def turn_by(value: float) -> Turn:
    """The rotation by an angle."""
    return (math.cos(value), math.sin(value))


@kernel
def turn_from_to(h: Vector, x: Vector, y: Vector) -> Turn:
    """Subproblem 1: the rotation about h that brings x nearest to y; the identity where either lies on the axis."""
    across = cross(h, x)
    s, c = dot(across, y), dot(x, y) - dot(h, x) * dot(h, y)
    size = math.sqrt(s * s + c * c)
    if size < 1e-14:
        return (1.0, 0.0)
    return (c / size, s / size)


@kernel
def turns_to_height(h: Vector, x: Vector, k: Vector, d: float) -> tuple[int, Turn, Turn]:
    """Subproblem 4: rotations about h at which k · (x rotated) = d: their number, and two of them.

    None where the height cannot be reached; one, the identity, where every rotation reaches it.
    """
    across = cross(h, x)
    a = dot(k, x) - dot(h, x) * dot(h, k)
    b = dot(k, across)
    rest = d - dot(h, x) * dot(h, k)
    size = math.sqrt(a * a + b * b)
    still = (1.0, 0.0)
    if size < 1e-12:
        return (1 if abs(rest) < 1e-9 else 0), still, still
    ratio = rest / size
    if abs(ratio) > 1.0 + GRAZE:
        return 0, still, still
    if abs(ratio) <= 1.0:
        off = math.sqrt((1.0 - ratio) * (1.0 + ratio))
    else:
        off = math.sqrt(2.0 * (abs(ratio) - 1.0))
        ratio = math.copysign(math.sqrt(1.0 - off * off), ratio)
    a, b = a / size, b / size
    return 2, (a * ratio - b * off, b * ratio + a * off), (a * ratio + b * off, b * ratio - a * off)


@kernel
def turns_to_distance(h: Vector, p: Vector, x: Vector, y: Vector, distance: float) -> tuple[int, Turn, Turn]:
    """Subproblem 3: rotations about h through p that bring the point x to `distance` from the point y."""
    x, y = sub(x, p), sub(y, p)
    # |x rotated - y|² = |x|² + |y|² - 2 y · (x rotated)
    return turns_to_height(h, x, y, 0.5 * (dot(x, x) + dot(y, y) - distance * distance))
