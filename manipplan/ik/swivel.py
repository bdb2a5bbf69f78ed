"""Seven revolute joints with a spherical shoulder and a spherical wrist: for each swivel of the elbow all answers.

The elbow joint sets the distance from shoulder to wrist. What is left is a turn of the whole arm about the line between
the two, the swivel: it is measured at the elbow's axis, from the first joint's axis.
"""

import math

import numpy as np

from manipplan.checks import Array
from manipplan.ik.spherical import fits, perpendicular, row, times, turn
from manipplan.ik.subproblems import Vector, add, cross, distance_angles, dot, sub, turned, turned_about
from manipplan.kernels import kernel

#: Below this sine two directions count as one.
IN_LINE = 1e-9


@kernel
def beside(axis: Vector, v: Vector) -> Vector:
    """The unit vector of v's part at right angles to the unit vector `axis`; any such where there is none."""
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
    """All angles with e_1 ... e_7 = motion at the given swivel [rad].

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
    toward = turned(to, math.cos(swivel), math.sin(swivel), zero)
    third = cross(to, toward)
    turns, shoulders, wrists = work[0:3], work[3:5], work[5:7]
    found = 0
    count, first, second = distance_angles(h4, p4, wrist, shoulder, reach)
    for k in range(abs(count)):
        q4 = first if k == 0 else second
        if not fits(q4, lower[3], upper[3]):
            continue
        c4, s4 = math.cos(q4), math.sin(q4)
        at = unit(sub(turned_about(h4, p4, c4, s4, wrist), shoulder))
        side = beside(at, h4)
        up = cross(at, side)
        for i in range(3):  # the turn that takes (at, side, up) to (to, toward, third)
            for j in range(3):
                turns[i, j] = to[i] * at[j] + toward[i] * side[j] + third[i] * up[j]
        for a in range(turn(row(axes, 0), row(axes, 1), row(axes, 2), turns, shoulders)):
            q1, q2, q3 = shoulders[a, 0], shoulders[a, 1], shoulders[a, 2]
            if not (fits(q1, lower[0], upper[0]) and fits(q2, lower[1], upper[1]) and fits(q3, lower[2], upper[2])):
                continue
            rest = work[7:10]
            for column in range(3):
                v = (motion[0, column], motion[1, column], motion[2, column])
                v = (
                    turns[0, 0] * v[0] + turns[1, 0] * v[1] + turns[2, 0] * v[2],
                    turns[0, 1] * v[0] + turns[1, 1] * v[1] + turns[2, 1] * v[2],
                    turns[0, 2] * v[0] + turns[1, 2] * v[1] + turns[2, 2] * v[2],
                )
                v = turned(h4, c4, -s4, v)
                rest[0, column], rest[1, column], rest[2, column] = v[0], v[1], v[2]
            for b in range(turn(row(axes, 4), row(axes, 5), row(axes, 6), rest, wrists)):
                good = True
                for i in range(3):
                    good = good and fits(wrists[b, i], lower[4 + i], upper[4 + i])
                if good:
                    out[found, 0], out[found, 1], out[found, 2], out[found, 3] = q1, q2, q3, q4
                    out[found, 4], out[found, 5], out[found, 6] = wrists[b, 0], wrists[b, 1], wrists[b, 2]
                    found += 1
    return found


@kernel
def swivel_of(axes: Array, points: Array, shoulder: Vector, wrist: Vector, q: Array) -> float:
    """The swivel [rad] of angles q (7,)."""
    h4, at = row(axes, 3), turned_about(row(axes, 3), row(points, 3), math.cos(q[3]), math.sin(q[3]), wrist)
    arm, side = sub(at, shoulder), h4
    for k in (2, 1, 0):
        c, s = math.cos(q[k]), math.sin(q[k])
        arm, side = turned(row(axes, k), c, s, arm), turned(row(axes, k), c, s, side)
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
