/* Six revolute joints, of which axes 2, 3 and 4 are parallel and the last two meet: the UR arms, Z1 and others. */

#pragma once

#include "spherical.h"

/* Sine below which the last axis counts as parallel to the three, and the number of q6 values then tried. */
#define LAST_IN_LINE 1e-7
enum { TRIES = 32 };

/* All joint angles with e_1 ... e_6 = motion, where axes 2, 3, 4 are parallel and 5 and 6 meet in `wrist`.
   Result as of `solve_spherical`. */
static long solve_parallel(const Arm *arm, Vector wrist, const double (*motion)[4], double *out) {
    const double *axes = arm->axes, *points = arm->points, *lower = arm->lower, *upper = arm->upper;
    Vector h1 = row(axes, 0), h2 = row(axes, 1), h5 = row(axes, 4), h6 = row(axes, 5);
    Vector p1 = row(points, 0), p2 = row(points, 1), p3 = row(points, 2), p4 = row(points, 3);
    double same3 = dot(h2, row(axes, 2)), same4 = dot(h2, row(axes, 3));  /* 1 or -1: sense of rotation of 3 and 4 */
    Vector point = add(times(motion, wrist), column(motion, 3)), across = perpendicular(h2);
    long found = 0;
    /* the parallel joints keep the height of `wrist` along their axes */
    Turns bases = turns_to_height(h1, sub(point, p1), h2, dot(h2, sub(wrist, p1)));
    for (long k = 0; k < bases.count; k++) {
        Turn first = back(bases.turn[k]);
        double q1 = angle_of(first);
        if (!fits(q1, lower[0], upper[0])) continue;
        Vector centre = turned_about(h1, p1, back(first), point), outward = turned(h1, first, h2);
        /* the component of the last axis along the parallel ones depends on q5 alone */
        Turns wrists = turns_to_height(h5, h6, h2, dot(outward, times(motion, h6)));
        for (long j = 0; j < wrists.count; j++) {
            Turn fifth = wrists.turn[j];
            double q5 = angle_of(fifth);
            if (!fits(q5, lower[4], upper[4])) continue;
            Vector last = turned(h5, back(fifth), h2);
            double sixth = angle_of(turn_from_to(h6, times_back(motion, outward), last)), along = dot(last, h6);
            /* where the last axis is parallel to the others q6 is free, but not every q6 lets the arm reach */
            long before = found, tries = along * along > 1.0 - LAST_IN_LINE * LAST_IN_LINE ? TRIES : 1;
            for (long attempt = 0; attempt < tries && found == before; attempt++) {
                double q6 = sixth + attempt * 2 * PI / tries;
                if (!fits(q6, lower[5], upper[5])) continue;
                Vector image = turned(h6, back(turn_by(q6)), turned(h5, back(fifth), across));
                Turn whole = turn_from_to(h2, across, turned(h1, back(first), times(motion, image)));
                Vector target = sub(sub(centre, turned(h2, whole, sub(wrist, p4))), p2);
                Turns elbows = turns_to_distance(h2, p3, p4, p2, length(target));
                for (long i = 0; i < elbows.count; i++) {
                    Turn bend = elbows.turn[i];
                    double second = angle_of(turn_from_to(h2, sub(turned_about(h2, p3, bend, p4), p2), target));
                    double q3 = same3 * angle_of(bend), q4 = same4 * (angle_of(whole) - second - angle_of(bend));
                    if (fits(second, lower[1], upper[1]) && fits(q3, lower[2], upper[2]) && fits(q4, lower[3], upper[3])) {
                        double *q = out + 6 * found++;
                        q[0] = q1, q[1] = second, q[2] = q3, q[3] = q4, q[4] = q5, q[5] = q6;
                    }
                }
            }
        }
    }
    return found;
}
