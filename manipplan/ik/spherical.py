"""Six revolute joints with three adjacent axes that intersect, at the wrist or (chain read backwards) at the shoulder.

Position and rotation decouple [pieper1968]: the other three joints place the point, the three that meet orient the tool.
"""

import math

import numpy as np

from manipplan.ik.geometry import MEETS
from manipplan.ik.subproblems import (
    Turn,
    Vector,
    add,
    back,
    cross,
    dot,
    sub,
    turn_from_to,
    turned,
    turned_about,
    turns_to_distance,
    turns_to_height,
)
from manipplan.support.checks import Array
from manipplan.support.compiling.kernels import kernel

#: Arrangement of the axes of the three joints a, b, c that place the point.
A_MEETS_B, B_MEETS_C, A_PARALLEL_B, B_PARALLEL_C, SKEW = range(5)
#: Solutions outside a limit by less than this are set to it [rad] and then verified: rounding puts them on either side.
AT_LIMIT = 1e-5
#: Maximum number of solutions: up to four for the position, and two of the wrist for each.
MOST = 8


@kernel
def row(rows: Array, k: int) -> Vector:
    """Row k of an array (k, 3)."""
    return (rows[k, 0], rows[k, 1], rows[k, 2])


@kernel
def times(rotation: Array, v: Vector) -> Vector:
    """`v` rotated by a matrix (3, 3)."""
    return (
        rotation[0, 0] * v[0] + rotation[0, 1] * v[1] + rotation[0, 2] * v[2],
        rotation[1, 0] * v[0] + rotation[1, 1] * v[1] + rotation[1, 2] * v[2],
        rotation[2, 0] * v[0] + rotation[2, 1] * v[1] + rotation[2, 2] * v[2],
    )


@kernel
def times_back(rotation: Array, v: Vector) -> Vector:
    """`v` rotated by the transpose of a matrix (3, 3)."""
    return (
        rotation[0, 0] * v[0] + rotation[1, 0] * v[1] + rotation[2, 0] * v[2],
        rotation[0, 1] * v[0] + rotation[1, 1] * v[1] + rotation[2, 1] * v[2],
        rotation[0, 2] * v[0] + rotation[1, 2] * v[1] + rotation[2, 2] * v[2],
    )


@kernel
def wrapped(angle: float) -> float:
    """The angle in [-π, π]."""
    return angle - 2 * math.pi * math.floor((angle + math.pi) / (2 * math.pi))


@kernel
def least_above(angle: float, lower: float) -> float:
    """The smallest angle that differs from this one by full turns and is at least `lower`, up to rounding."""
    return angle - 2 * math.pi * math.floor((angle - lower + AT_LIMIT) / (2 * math.pi))


@kernel
def fits(angle: float, lower: float, upper: float) -> bool:
    """Whether the angle, or one that differs by full turns, is inside the limits."""
    return least_above(angle, lower) <= upper + AT_LIMIT


@kernel
def perpendicular(h: Vector) -> Vector:
    """A unit vector perpendicular to h."""
    v = (0.0, -h[2], h[1]) if abs(h[0]) < 0.6 else (h[2], 0.0, -h[0])
    size = math.sqrt(dot(v, v))
    return (v[0] / size, v[1] / size, v[2] / size)


@kernel
def lie(axes: Array, points: Array) -> tuple[int, Vector, float]:
    """Arrangement of the first three axes (A_MEETS_B, ...), the point where two of them meet, and the deviation from it."""
    nowhere = (0.0, 0.0, 0.0)
    for first, kind in ((0, A_MEETS_B), (1, B_MEETS_C)):
        g, h = row(axes, first), row(axes, first + 1)
        across = cross(g, h)
        square = dot(across, across)
        if square > MEETS**2:
            apart = sub(row(points, first + 1), row(points, first))
            miss = abs(dot(apart, across)) / math.sqrt(square)
            if miss < MEETS:
                along = dot(cross(apart, h), across) / square
                return kind, add(row(points, first), (along * g[0], along * g[1], along * g[2])), miss
    for first, kind in ((0, A_PARALLEL_B), (1, B_PARALLEL_C)):
        across = cross(row(axes, first), row(axes, first + 1))
        miss = math.sqrt(dot(across, across))
        if miss < MEETS:
            return kind, nowhere, miss
    return SKEW, nowhere, 0.0


@kernel
def put(out: Array, k: int, first: Turn, second: Turn, third: Turn) -> None:
    """Writes three rotations to row k of an array (any, 6)."""
    out[k, 0], out[k, 1] = first
    out[k, 2], out[k, 3] = second
    out[k, 4], out[k, 5] = third


@kernel
def two_meeting(ha: Vector, hb: Vector, x: Vector, y: Vector) -> tuple[int, Turn, Turn, Turn, Turn]:
    """Subproblem 2: rotations a, b with R_a R_b x = y, for vectors from the point where the axes meet: count, a, b, a, b."""
    count, first, second = turns_to_height(hb, x, ha, dot(ha, y))
    return (
        count,
        turn_from_to(ha, turned(hb, first, x), y),
        first,
        turn_from_to(ha, turned(hb, second, x), y),
        second,
    )


@kernel
def place(kind: int, axes: Array, points: Array, meeting: Vector, x: Vector, y: Vector, out: Array) -> int:
    """Rotations a, b, c about the first three axes with e_a e_b e_c x = y, as rows of `out` (4, 6); returns their number."""
    ha, hb, hc = row(axes, 0), row(axes, 1), row(axes, 2)
    pa, pb, pc = row(points, 0), row(points, 1), row(points, 2)
    found = 0
    if kind == SKEW:
        return place_skew(ha, hb, hc, pa, pb, pc, x, y, out)
    if kind == A_MEETS_B:
        target = sub(y, meeting)
        count, first, second = turns_to_distance(hc, pc, x, meeting, math.sqrt(dot(target, target)))
        for k in range(count):
            c = first if k == 0 else second
            elbow = sub(turned_about(hc, pc, c, x), meeting)
            pairs, a1, b1, a2, b2 = two_meeting(ha, hb, elbow, target)
            for j in range(pairs):
                put(out, found, a1 if j == 0 else a2, b1 if j == 0 else b2, c)
                found += 1
    elif kind == B_MEETS_C:
        start = sub(x, meeting)
        count, first, second = turns_to_distance(ha, pa, y, meeting, math.sqrt(dot(start, start)))
        for k in range(count):
            a = back(first if k == 0 else second)
            elbow = sub(turned_about(ha, pa, back(a), y), meeting)
            pairs, b1, c1, b2, c2 = two_meeting(hb, hc, start, elbow)
            for j in range(pairs):
                put(out, found, a, b1 if j == 0 else b2, c1 if j == 0 else c2)
                found += 1
    elif kind == A_PARALLEL_B:
        # the height along a depends on c alone
        target = sub(y, pa)
        count, first, second = turns_to_height(hc, sub(x, pc), ha, dot(ha, sub(y, pc)))
        for k in range(count):
            c = first if k == 0 else second
            elbow = turned_about(hc, pc, c, x)
            pairs, b1, b2 = turns_to_distance(hb, pb, elbow, pa, math.sqrt(dot(target, target)))
            for j in range(pairs):
                b = b1 if j == 0 else b2
                put(out, found, turn_from_to(ha, sub(turned_about(hb, pb, b, elbow), pa), target), b, c)
                found += 1
    else:
        count, first, second = turns_to_height(ha, sub(y, pa), hb, dot(hb, sub(x, pa)))
        for k in range(count):
            a = back(first if k == 0 else second)
            target = sub(turned_about(ha, pa, back(a), y), pb)
            pairs, c1, c2 = turns_to_distance(hc, pc, x, pb, math.sqrt(dot(target, target)))
            for j in range(pairs):
                c = c1 if j == 0 else c2
                put(out, found, a, turn_from_to(hb, sub(turned_about(hc, pc, c, x), pb), target), c)
                found += 1
    return found


@kernel
def place_skew(ha: Vector, hb: Vector, hc: Vector, pa: Vector, pb: Vector, pc: Vector, x: Vector, y: Vector, out: Array) -> int:
    """The same for axes in general position: a quartic in tan(qc / 2).

    With z = e_c x - pb, u = b · z and r² = |z|² are linear in cos qc and sin qc. The rotation about b moves z to
    u b + ρ (cos ψ e1 + sin ψ e2), with e2 perpendicular to a and b. Its height along a gives ρ cos ψ, then its distance from a
    point on a gives ρ sin ψ, each linear in u and r²; their squares add up to r² - u².
    """
    sine = math.sqrt(max(1.0 - dot(ha, hb) ** 2, 0.0))
    e2 = cross(hb, ha)
    e2 = (e2[0] / sine, e2[1] / sine, e2[2] / sine)
    e1 = cross(e2, hb)
    origin, target = sub(pa, pb), sub(y, pa)
    # coefficients of 1, cos qc, sin qc
    arm = sub(x, pc)
    along = dot(hc, arm)
    fixed = add((along * hc[0], along * hc[1], along * hc[2]), sub(pc, pb))
    cosine = sub(arm, (along * hc[0], along * hc[1], along * hc[2]))
    across = cross(hc, arm)
    u = (dot(hb, fixed), dot(hb, cosine), dot(hb, across))
    square = (dot(fixed, fixed) + dot(cosine, cosine), 2 * dot(fixed, cosine), 2 * dot(fixed, across))
    height = dot(ha, add(target, origin))  # a · (y - pb)
    tilt, forward = dot(ha, hb), dot(ha, e1)
    x1 = ((height - tilt * u[0]) / forward, -tilt * u[1] / forward, -tilt * u[2] / forward)
    # r² - 2 origin · z + |origin|² = |y - pa|²
    rest = dot(origin, origin) - dot(target, target)
    side = 2 * dot(origin, e2)
    b, f = dot(origin, hb), dot(origin, e1)
    n0 = square[0] + rest - 2 * (b * u[0] + f * x1[0])
    n1 = square[1] - 2 * (b * u[1] + f * x1[1])
    n2 = square[2] - 2 * (b * u[2] + f * x1[2])
    s2 = side * side
    # side² (x1² + u² - r²) + n² = 0 as a form in (1, c, s)
    k00 = s2 * (x1[0] * x1[0] + u[0] * u[0] - square[0]) + n0 * n0
    k01 = s2 * (2 * x1[0] * x1[1] + 2 * u[0] * u[1] - square[1]) + 2 * n0 * n1
    k02 = s2 * (2 * x1[0] * x1[2] + 2 * u[0] * u[2] - square[2]) + 2 * n0 * n2
    k11 = s2 * (x1[1] * x1[1] + u[1] * u[1]) + n1 * n1
    k12 = s2 * (2 * x1[1] * x1[2] + 2 * u[1] * u[2]) + 2 * n1 * n2
    k22 = s2 * (x1[2] * x1[2] + u[2] * u[2]) + n2 * n2
    # c = (1 - t²) / (1 + t²), s = 2 t / (1 + t²): a quartic in t, or in 1/t where t⁴ has the smaller coefficient
    k0, k4 = k00 + k01 + k11, k00 - k01 + k11
    k1, k3 = 2 * (k02 + k12), 2 * (k02 - k12)
    upward = abs(k4) >= abs(k0)
    lead = k4 if upward else k0
    companion = np.zeros((4, 4), dtype=np.complex128)
    companion[1, 0] = companion[2, 1] = companion[3, 2] = 1.0
    companion[0, 3], companion[3, 3] = -(k0 if upward else k4) / lead, -(k3 if upward else k1) / lead
    companion[1, 3], companion[2, 3] = -(k1 if upward else k3) / lead, -(2 * (k00 - k11) + 4 * k22) / lead
    roots = np.linalg.eigvals(companion)
    found = 0
    for k in range(4):
        t = roots[k]
        if abs(t.imag) > 1e-6 * (1.0 + abs(t.real)):
            continue
        top, bottom = (t.real, 1.0) if upward else (1.0, t.real)  # tan(qc / 2)
        size = top * top + bottom * bottom
        turn_c = ((bottom * bottom - top * top) / size, 2 * top * bottom / size)
        elbow = sub(turned_about(hc, pc, turn_c, x), pb)
        first = x1[0] + x1[1] * turn_c[0] + x1[2] * turn_c[1]
        second = (n0 + n1 * turn_c[0] + n2 * turn_c[1]) / side
        height_b = dot(hb, elbow)
        image = (
            height_b * hb[0] + first * e1[0] + second * e2[0],
            height_b * hb[1] + first * e1[1] + second * e2[1],
            height_b * hb[2] + first * e1[2] + second * e2[2],
        )
        put(out, found, turn_from_to(ha, sub(image, origin), target), turn_from_to(hb, elbow, image), turn_c)
        found += 1
    return found


@kernel
def orient(h4: Vector, h5: Vector, h6: Vector, rotation: Array, out: Array) -> int:
    """Rotations with R4 R5 R6 = rotation (3, 3), for any three axes, as rows of `out` (2, 6); returns their number."""
    toward = times(rotation, h6)
    across = perpendicular(h6)
    across_turned = times(rotation, across)
    count, first, second = turns_to_height(h5, h6, h4, dot(h4, toward))
    for k in range(count):
        fifth = first if k == 0 else second
        fourth = turn_from_to(h4, turned(h5, fifth, h6), toward)
        # R6 = R5ᵀ R4ᵀ R, also where axes 4 and 6 are in line and q4 is free
        image = turned(h5, back(fifth), turned(h4, back(fourth), across_turned))
        put(out, k, fourth, fifth, turn_from_to(h6, across, image))
    return count


@kernel
def angles_fit(turns: Array, k: int, lower: Array, upper: Array, begin: int, out: Array, found: int) -> bool:
    """Writes the angles of the rotations in row k to row `found` of `out`, from column `begin` on; returns whether they fit."""
    for i in range(3):
        value = math.atan2(turns[k, 2 * i + 1], turns[k, 2 * i])
        if not fits(value, lower[begin + i], upper[begin + i]):
            return False
        out[found, begin + i] = value
    return True


@kernel
def solve_spherical(
    kind: int,
    meeting: Vector,
    axes: Array,
    points: Array,
    wrist: Vector,
    motion: Array,
    lower: Array,
    upper: Array,
    out: Array,
    work: Array,
) -> int:
    """All joint angles with e_1 ... e_6 = motion, where axes 4, 5, 6 meet in `wrist`.

    Args:
        kind, meeting: what `lie` returns for axes 1, 2, 3.
        axes, points: (6, 3).
        wrist: where axes 4, 5, 6 meet at q = 0.
        motion: (4, 4).
        lower, upper: (6,); a solution that is outside after any number of full turns is left out.
        out: (MOST + 1, 6), filled with the solutions; the last row is scratch space.
        work: (16, 6), scratch space.

    Returns the number of filled rows of `out`.
    """
    target = add(times(motion, wrist), (motion[0, 3], motion[1, 3], motion[2, 3]))
    places, wrists, rotation = work[0:4], work[4:6], work[6:9, 0:3]
    found = 0
    for k in range(place(kind, axes, points, meeting, wrist, target, places)):
        if not angles_fit(places, k, lower, upper, 0, out, found):
            continue
        a, b, c = (places[k, 0], -places[k, 1]), (places[k, 2], -places[k, 3]), (places[k, 4], -places[k, 5])
        for column in range(3):
            v = turned(row(axes, 0), a, (motion[0, column], motion[1, column], motion[2, column]))
            v = turned(row(axes, 2), c, turned(row(axes, 1), b, v))
            rotation[0, column], rotation[1, column], rotation[2, column] = v[0], v[1], v[2]
        qa, qb, qc = out[found, 0], out[found, 1], out[found, 2]
        for j in range(orient(row(axes, 3), row(axes, 4), row(axes, 5), rotation, wrists)):
            if angles_fit(wrists, j, lower, upper, 3, out, found):
                out[found, 0], out[found, 1], out[found, 2] = qa, qb, qc
                found += 1
    return found
