"""The geometric subproblems of Paden and Kahan that closed-form inverse kinematics is made of, for numba.

Vectors are tuples of three floats: numba keeps them in registers. Where a subproblem has no answer by less than `GRAZE`, two
guesses beside the nearest point are given, since an arm may differ from its closed form by what its description rounds. All
answers are refined and judged by forward kinematics afterwards.
"""

import math

from manipplan.kernels import kernel

#: How far a cosine may be above 1.
GRAZE = 1e-3

Vector = tuple[float, float, float]


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
def turned(h: Vector, c: float, s: float, v: Vector) -> Vector:
    """`v` turned about the unit axis h by the angle of cosine c and sine s (Rodrigues)."""
    along = dot(h, v) * (1.0 - c)
    w = cross(h, v)
    return (c * v[0] + s * w[0] + along * h[0], c * v[1] + s * w[1] + along * h[1], c * v[2] + s * w[2] + along * h[2])


@kernel
def turned_about(h: Vector, p: Vector, c: float, s: float, v: Vector) -> Vector:
    """The point `v` turned about the axis h through the point p."""
    return add(p, turned(h, c, s, sub(v, p)))


@kernel
def angle_from_to(h: Vector, x: Vector, y: Vector) -> float:
    """Subproblem 1: the angle about h that turns x nearest to y; 0 where either lies on the axis."""
    across = cross(h, x)
    s, c = dot(across, y), dot(x, y) - dot(h, x) * dot(h, y)
    if abs(s) + abs(c) < 1e-14:
        return 0.0
    return math.atan2(s, c)


@kernel
def height_angles(h: Vector, x: Vector, k: Vector, d: float) -> tuple[int, float, float]:
    """Subproblem 4: angles about h at which k · (x turned) = d: how many, and two of them.

    None where the height cannot be reached; -1 where every angle reaches it, for which 0 is given.
    """
    across = cross(h, x)
    a = dot(k, x) - dot(h, x) * dot(h, k)
    b = dot(k, across)
    rest = d - dot(h, x) * dot(h, k)
    size = math.sqrt(a * a + b * b)
    if size < 1e-12:
        return (-1, 0.0, 0.0) if abs(rest) < 1e-9 else (0, 0.0, 0.0)
    ratio = rest / size
    if abs(ratio) > 1.0 + GRAZE:
        return 0, 0.0, 0.0
    middle = math.atan2(b, a)
    if abs(ratio) <= 1.0:
        off = math.acos(ratio)
    else:
        beyond = math.sqrt(2.0 * (abs(ratio) - 1.0))
        off = beyond if ratio > 0 else math.pi - beyond
    return 2, middle + off, middle - off


@kernel
def distance_angles(h: Vector, p: Vector, x: Vector, y: Vector, distance: float) -> tuple[int, float, float]:
    """Subproblem 3: angles about h through p at which the point x comes to `distance` from the point y."""
    x, y = sub(x, p), sub(y, p)
    # |x turned - y|² = |x|² + |y|² - 2 y · (x turned)
    return height_angles(h, x, y, 0.5 * (dot(x, x) + dot(y, y) - distance * distance))
