"""Six revolute joints, of which axes 2, 3 and 4 are parallel and the last two meet: the UR arms, Z1 and others."""

import math

from manipplan.ik.spherical import fits, perpendicular, row, times, times_back
from manipplan.ik.subproblems import (
    Vector,
    add,
    angle,
    back,
    dot,
    sub,
    turn_by,
    turn_from_to,
    turned,
    turned_about,
    turns_to_distance,
    turns_to_height,
)
from manipplan.support.checks import Array
from manipplan.support.compiling.kernels import kernel

#: Sine below which the last axis counts as parallel to the three, and the number of q6 values then tried.
IN_LINE, TRIES = 1e-7, 32


@kernel
def solve_parallel(axes: Array, points: Array, wrist: Vector, motion: Array, lower: Array, upper: Array, out: Array) -> int:
    """All joint angles with e_1 ... e_6 = motion, where axes 2, 3, 4 are parallel and 5 and 6 meet in `wrist`.

    Arguments and result as in `solve_spherical`.
    """
    h1, h2, h5, h6 = row(axes, 0), row(axes, 1), row(axes, 4), row(axes, 5)
    p1, p2, p3, p4 = row(points, 0), row(points, 1), row(points, 2), row(points, 3)
    same3, same4 = dot(h2, row(axes, 2)), dot(h2, row(axes, 3))  # 1 or -1: sense of rotation of 3 and 4
    point = add(times(motion, wrist), (motion[0, 3], motion[1, 3], motion[2, 3]))
    found = 0
    # the parallel joints keep the height of `wrist` along their axes
    bases, base1, base2 = turns_to_height(h1, sub(point, p1), h2, dot(h2, sub(wrist, p1)))
    for k in range(bases):
        first = back(base1 if k == 0 else base2)
        q1 = angle(first)
        if not fits(q1, lower[0], upper[0]):
            continue
        centre = turned_about(h1, p1, back(first), point)
        outward = turned(h1, first, h2)
        # the component of the last axis along the parallel ones depends on q5 alone
        wrists, wrist1, wrist2 = turns_to_height(h5, h6, h2, dot(outward, times(motion, h6)))
        for j in range(wrists):
            fifth = wrist1 if j == 0 else wrist2
            q5 = angle(fifth)
            if not fits(q5, lower[4], upper[4]):
                continue
            last = turned(h5, back(fifth), h2)
            sixth = angle(turn_from_to(h6, times_back(motion, outward), last))
            # where the last axis is parallel to the others q6 is free, but not every q6 lets the arm reach
            in_line = dot(last, h6) ** 2 > 1.0 - IN_LINE**2
            before, tries = found, TRIES if in_line else 1
            for attempt in range(tries):
                q6 = sixth + attempt * 2 * math.pi / tries
                if found > before or not fits(q6, lower[5], upper[5]):
                    continue
                across = perpendicular(h2)
                image = turned(h6, back(turn_by(q6)), turned(h5, back(fifth), across))
                whole = turn_from_to(h2, across, turned(h1, back(first), times(motion, image)))
                target = sub(sub(centre, turned(h2, whole, sub(wrist, p4))), p2)
                elbows, elbow1, elbow2 = turns_to_distance(h2, p3, p4, p2, math.sqrt(dot(target, target)))
                for i in range(elbows):
                    bend = elbow1 if i == 0 else elbow2
                    second = angle(turn_from_to(h2, sub(turned_about(h2, p3, bend, p4), p2), target))
                    q3, q4 = same3 * angle(bend), same4 * (angle(whole) - second - angle(bend))
                    if fits(second, lower[1], upper[1]) and fits(q3, lower[2], upper[2]) and fits(q4, lower[3], upper[3]):
                        out[found, 0], out[found, 1], out[found, 2] = q1, second, q3
                        out[found, 3], out[found, 4], out[found, 5] = q4, q5, q6
                        found += 1
    return found
