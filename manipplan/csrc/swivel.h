/* Seven revolute joints with a spherical shoulder and a spherical wrist: all solutions for each swivel angle of the elbow.

   The elbow joint sets the distance from shoulder to wrist. What remains is a rotation of the whole arm about the line between
   the two, the swivel: the angle of the elbow's axis, measured from the first joint's axis. */

#pragma once

#include "spherical.h"

/* Sine below which two directions count as parallel. */
#define IN_LINE 1e-9

/* The unit vector along v's part perpendicular to the unit vector `axis`; any perpendicular one where that is zero. */
static Vector beside(Vector axis, Vector v) {
    Vector part = sub(v, scaled(dot(axis, v), axis));
    return length(part) < IN_LINE ? perpendicular(axis) : unit(part);
}

/* All joint angles with e_1 ... e_7 = motion at the given swivel [rad]. Axes 1, 2, 3 meet in `shoulder` and 5, 6, 7 in `wrist`;
   result as of `solve_spherical`, with seven joints. */
static long solve_swivel(const Arm *arm, Vector shoulder, Vector wrist, const double (*motion)[4], double swivel, double *out) {
    const double *axes = arm->axes;
    Vector target = sub(add(times(motion, wrist), column(motion, 3)), shoulder);
    double reach = length(target);
    if (reach < IN_LINE) return 0;
    Vector to = unit(target), h4 = row(axes, 3), p4 = row(arm->points, 3);
    Vector toward = turned(to, turn_by(swivel), beside(to, row(axes, 0))), third = cross(to, toward);
    Turn shoulders[2][3], wrists[2][3];
    long found = 0;
    Turns elbows = turns_to_distance(h4, p4, wrist, shoulder, reach);
    for (long k = 0; k < elbows.count; k++) {
        Turn fourth = elbows.turn[k];
        double q4 = angle_of(fourth);
        if (!fits(q4, arm->lower[3], arm->upper[3])) continue;
        Vector at = unit(sub(turned_about(h4, p4, fourth, wrist), shoulder)), side = beside(at, h4), up = cross(at, side);
        /* the rotation of (at, side, up) to (to, toward, third) */
        double from[3][3] = {{at.x, at.y, at.z}, {side.x, side.y, side.z}, {up.x, up.y, up.z}};
        double onto[3][3] = {{to.x, to.y, to.z}, {toward.x, toward.y, toward.z}, {third.x, third.y, third.z}};
        Motion turns = {{0}}, rest;
        for (long i = 0; i < 3; i++)
            for (long j = 0; j < 3; j++)
                turns[i][j] = onto[0][i] * from[0][j] + onto[1][i] * from[1][j] + onto[2][i] * from[2][j];
        for (long j = 0; j < 3; j++)  /* the rotation left to the wrist */
            set_column(rest, j, turned(h4, back(fourth), times_back(turns, column(motion, j))));
        long bends = orient(row(axes, 4), row(axes, 5), row(axes, 6), rest, wrists);
        for (long a = 0, some = orient(row(axes, 0), row(axes, 1), row(axes, 2), turns, shoulders); a < some; a++) {
            double *first = out + 7 * found;
            if (!angles_fit(shoulders[a], arm, 0, first)) continue;
            double q1 = first[0], q2 = first[1], q3 = first[2];
            for (long b = 0; b < bends; b++) {
                double *q = out + 7 * found;
                if (angles_fit(wrists[b], arm, 4, q + 4)) q[0] = q1, q[1] = q2, q[2] = q3, q[3] = q4, found++;
            }
        }
    }
    return found;
}

/* The swivel [rad] of joint angles q (7). */
static double swivel_of(const double *axes, const double *points, Vector shoulder, Vector wrist, const double *q) {
    Vector side = row(axes, 3), arm = sub(turned_about(side, row(points, 3), turn_by(q[3]), wrist), shoulder);
    for (long k = 2; k >= 0; k--) {
        Turn turn = turn_by(q[k]);
        arm = turned(row(axes, k), turn, arm), side = turned(row(axes, k), turn, side);
    }
    Vector to = unit(arm), zero = beside(to, row(axes, 0)), now = beside(to, side);
    return atan2(dot(to, cross(zero, now)), dot(zero, now));
}
