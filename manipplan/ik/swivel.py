"""Seven revolute joints with a spherical shoulder and a spherical wrist: all solutions for each swivel angle of the elbow.

The elbow joint sets the distance from shoulder to wrist. What remains is a rotation of the whole arm about the line
between the two, the swivel: the angle of the elbow's axis, measured from the first joint's axis.
"""

import math

import numpy as np

from manipplan.ik.spherical import angles_fit, fits, orient, perpendicular, row, times, times_back
from manipplan.ik.subproblems import Vector, add, angle, back, cross, dot, sub, turn_by, turned, turned_about, turns_to_distance
from manipplan.support.checks import Array
from manipplan.support.compiling.kernels import kernel

#: Sine below which two directions count as parallel.
IN_LINE = 1e-9


@kernel
def beside(axis: Vector, v: Vector) -> Vector:
    """The unit vector along v's part perpendicular to the unit vector `axis`; any perpendicular one where that is zero."""
    along = dot(axis, v)
    part = (v[0] - along * axis[0], v[1] - along * axis[1], v[2] - along * axis[2])
    size = math.sqrt(dot(part, part))
    if size < IN_LINE:
        return perpendicular(axis)
    return (part[0] / size, part[1] / size, part[2] / size)


@kernel
def unit(v: Vector) -> Vector:
    """The direction of v."""
    size = math.sqrt(dot(v, v))
    return (v[0] / size, v[1] / size, v[2] / size)


@kernel
def solve_swivel(
    axes: Array,
    points: Array,
    shoulder: Vector,
    wrist: Vector,
    motion: Array,
    swivel: float,
    lower: Array,
    upper: Array,
    out: Array,
    work: Array,
) -> int:
    """All joint angles with e_1 ... e_7 = motion at the given swivel [rad].

    Axes 1, 2, 3 meet in `shoulder` and 5, 6, 7 in `wrist`; the other arguments and the result are those of
    `solve_spherical`, with seven joints.
    """
    target = sub(add(times(motion, wrist), (motion[0, 3], motion[1, 3], motion[2, 3])), shoulder)
    reach = math.sqrt(dot(target, target))
    if reach < IN_LINE:
        return 0
    to = unit(target)
    h4, p4 = row(axes, 3), row(points, 3)
    zero = beside(to, row(axes, 0))
    toward = turned(to, turn_by(swivel), zero)
    third = cross(to, toward)
    turns, shoulders, wrists, rest = work[0:3, 0:3], work[3:5], work[5:7], work[7:10, 0:3]
    found = 0
    count, first, second = turns_to_distance(h4, p4, wrist, shoulder, reach)
    for k in range(count):
        fourth = first if k == 0 else second
        q4 = angle(fourth)
        if not fits(q4, lower[3], upper[3]):
            continue
        at = unit(sub(turned_about(h4, p4, fourth, wrist), shoulder))
        side = beside(at, h4)
        up = cross(at, side)
        for i in range(3):  # the rotation of (at, side, up) to (to, toward, third)
            for j in range(3):
                turns[i, j] = to[i] * at[j] + toward[i] * side[j] + third[i] * up[j]
        for column in range(3):  # the rotation left to the wrist
            v = times_back(turns, (motion[0, column], motion[1, column], motion[2, column]))
            v = turned(h4, back(fourth), v)
            rest[0, column], rest[1, column], rest[2, column] = v[0], v[1], v[2]
        bends = orient(row(axes, 4), row(axes, 5), row(axes, 6), rest, wrists)
        for a in range(orient(row(axes, 0), row(axes, 1), row(axes, 2), turns, shoulders)):
            if not angles_fit(shoulders, a, lower, upper, 0, out, found):
                continue
            q1, q2, q3 = out[found, 0], out[found, 1], out[found, 2]
            for b in range(bends):
                if angles_fit(wrists, b, lower, upper, 4, out, found):
                    out[found, 0], out[found, 1], out[found, 2], out[found, 3] = q1, q2, q3, q4
                    found += 1
    return found


@kernel
def swivel_of(axes: Array, points: Array, shoulder: Vector, wrist: Vector, q: Array) -> float:
    """The swivel [rad] of joint angles q (7,)."""
    h4, at = row(axes, 3), turned_about(row(axes, 3), row(points, 3), turn_by(q[3]), wrist)
    arm, side = sub(at, shoulder), h4
    for k in (2, 1, 0):
        turn = turn_by(q[k])
        arm, side = turned(row(axes, k), turn, arm), turned(row(axes, k), turn, side)
    to = unit(arm)
    zero, now = beside(to, row(axes, 0)), beside(to, side)
    return math.atan2(dot(to, cross(zero, now)), dot(zero, now))


@kernel
def swivels_of(axes: Array, points: Array, shoulder: Array, wrist: Array, q: Array) -> Array:
    """The swivel [rad] of each row of q (k, 7)."""
    swivels = np.empty(len(q))
    a, b = (shoulder[0], shoulder[1], shoulder[2]), (wrist[0], wrist[1], wrist[2])
    for k in range(len(q)):
        swivels[k] = swivel_of(axes, points, a, b, q[k])
    return swivels
