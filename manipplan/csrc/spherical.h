/* Six revolute joints with three adjacent axes that intersect, at the wrist or (chain read backwards) at the shoulder.

   Position and rotation decouple [pieper1968]: the other three joints place the point, the three that meet orient the tool. */

#pragma once

#include "quartic.h"
#include "subproblems.h"

#define PI 3.141592653589793

/* Axes that miss a point by less than this meet in it [m]; directions that differ by less are parallel. As in geometry.py. */
#define MEETS 1e-5

/* Solutions outside a limit by less than this are set to it [rad] and then verified: rounding puts them on either side. As in
   form.py. */
#define AT_LIMIT 1e-5

enum {
    A_MEETS_B, B_MEETS_C, A_PARALLEL_B, B_PARALLEL_C, SKEW,  /* arrangement of the joints that place the point; as in bridge.py */
    MOST = 8,  /* maximum number of solutions: up to four for the position, and two of the wrist for each; as in form.py */
    PLACES = 4
};

/* Arrangement of three axes, the point where two of them meet, and the deviation from it. */
typedef struct { long kind; Vector meeting; double miss; } Arrangement;

/* An arm whose joints are all to be solved for: f axes and points (f, 3), and limits (f). A solution that is outside after any
   number of full turns is left out. */
typedef struct { long f; const double *axes, *points, *lower, *upper; } Arm;

/* The smallest angle that differs from this one by full turns and is at least `lower`, up to rounding. */
static inline double least_above(double angle, double lower) {
    return angle - 2 * PI * floor((angle - lower + AT_LIMIT) / (2 * PI));
}

/* Whether the angle, or one that differs by full turns, is inside the limits. */
static inline int fits(double angle, double lower, double upper) { return least_above(angle, lower) <= upper + AT_LIMIT; }

/* Writes the angles of three rotations to out (3); whether they fit the limits of the joints from `first` on. */
static int angles_fit(const Turn turn[3], const Arm *arm, long first, double *out) {
    for (long i = 0; i < 3; i++) {
        double value = angle_of(turn[i]);
        if (!fits(value, arm->lower[first + i], arm->upper[first + i])) return 0;
        out[i] = value;
    }
    return 1;
}

static Arrangement arrangement(const double *axes, const double *points) {
    for (long first = 0; first < 2; first++) {
        Vector g = row(axes, first), h = row(axes, first + 1), across = cross(g, h);
        double square = dot(across, across);
        if (square > MEETS * MEETS) {
            Vector apart = sub(row(points, first + 1), row(points, first));
            double miss = fabs(dot(apart, across)) / sqrt(square);
            if (miss < MEETS) {
                double along = dot(cross(apart, h), across) / square;
                return (Arrangement){first ? B_MEETS_C : A_MEETS_B, add(row(points, first), scaled(along, g)), miss};
            }
        }
    }
    for (long first = 0; first < 2; first++) {
        double miss = length(cross(row(axes, first), row(axes, first + 1)));
        if (miss < MEETS) return (Arrangement){first ? B_PARALLEL_C : A_PARALLEL_B, {0, 0, 0}, miss};
    }
    return (Arrangement){SKEW, {0, 0, 0}, 0};
}

/* Subproblem 2: rotations a, b with R_a R_b x = y, for vectors from the point where the axes meet; returns b, writes a (2). */
static Turns two_meeting(Vector ha, Vector hb, Vector x, Vector y, Turn a[2]) {
    Turns b = turns_to_height(hb, x, ha, dot(ha, y));
    for (long k = 0; k < b.count; k++) a[k] = turn_from_to(ha, turned(hb, b.turn[k], x), y);
    return b;
}

/* Rotations a, b, c with e_a e_b e_c x = y for axes in general position: a quartic in tan(qc / 2). Returns their number.

   With z = e_c x - pb, u = b · z and r² = |z|² are linear in cos qc and sin qc. The rotation about b moves z to
   u b + ρ (cos ψ e1 + sin ψ e2), with e2 perpendicular to a and b. Its height along a gives ρ cos ψ, then its distance from a
   point on a gives ρ sin ψ, each linear in u and r²; their squares add up to r² - u². */
static long place_skew(const double *axes, const double *points, Vector x, Vector y, Turn out[PLACES][3]) {
    Vector ha = row(axes, 0), hb = row(axes, 1), hc = row(axes, 2);
    Vector pa = row(points, 0), pb = row(points, 1), pc = row(points, 2);
    double tilt = dot(ha, hb), sine = sqrt(larger(1.0 - tilt * tilt, 0.0));
    Vector e2 = cross(hb, ha);
    e2 = (Vector){e2.x / sine, e2.y / sine, e2.z / sine};
    Vector e1 = cross(e2, hb), origin = sub(pa, pb), target = sub(y, pa);
    /* coefficients of 1, cos qc, sin qc */
    Vector arm = sub(x, pc), along = scaled(dot(hc, arm), hc), across = cross(hc, arm);
    Vector fixed = add(along, sub(pc, pb)), cosine = sub(arm, along);
    double u[3] = {dot(hb, fixed), dot(hb, cosine), dot(hb, across)};
    double square[3] = {dot(fixed, fixed) + dot(cosine, cosine), 2 * dot(fixed, cosine), 2 * dot(fixed, across)};
    double height = dot(ha, add(target, origin));  /* a · (y - pb) */
    double forward = dot(ha, e1);
    double x1[3] = {(height - tilt * u[0]) / forward, -tilt * u[1] / forward, -tilt * u[2] / forward};
    /* r² - 2 origin · z + |origin|² = |y - pa|² */
    double rest = dot(origin, origin) - dot(target, target), side = 2 * dot(origin, e2);
    double b = dot(origin, hb), f = dot(origin, e1);
    double n0 = square[0] + rest - 2 * (b * u[0] + f * x1[0]);
    double n1 = square[1] - 2 * (b * u[1] + f * x1[1]), n2 = square[2] - 2 * (b * u[2] + f * x1[2]);
    double s2 = side * side;
    /* side² (x1² + u² - r²) + n² = 0 as a form in (1, c, s) */
    double k00 = s2 * (x1[0] * x1[0] + u[0] * u[0] - square[0]) + n0 * n0;
    double k01 = s2 * (2 * x1[0] * x1[1] + 2 * u[0] * u[1] - square[1]) + 2 * n0 * n1;
    double k02 = s2 * (2 * x1[0] * x1[2] + 2 * u[0] * u[2] - square[2]) + 2 * n0 * n2;
    double k11 = s2 * (x1[1] * x1[1] + u[1] * u[1]) + n1 * n1;
    double k12 = s2 * (2 * x1[1] * x1[2] + 2 * u[1] * u[2]) + 2 * n1 * n2;
    double k22 = s2 * (x1[2] * x1[2] + u[2] * u[2]) + n2 * n2;
    /* c = (1 - t²) / (1 + t²), s = 2 t / (1 + t²): a quartic in t, or in 1/t where t⁴ has the smaller coefficient */
    double k0 = k00 + k01 + k11, k4 = k00 - k01 + k11, k1 = 2 * (k02 + k12), k3 = 2 * (k02 - k12);
    double k2 = 2 * (k00 - k11) + 4 * k22;
    int upward = fabs(k4) >= fabs(k0);
    double lead = upward ? k4 : k0;
    double coefficients[DEGREE] = {(upward ? k0 : k4) / lead, (upward ? k1 : k3) / lead, k2 / lead, (upward ? k3 : k1) / lead};
    Complex roots[DEGREE];
    long found = 0;
    for (int k = 0, count = quartic_roots(coefficients, roots); k < count; k++) {
        double t = roots[k].re;
        if (fabs(roots[k].im) > 1e-6 * (1.0 + fabs(t))) continue;
        double top = upward ? t : 1.0, bottom = upward ? 1.0 : t;  /* tan(qc / 2) */
        double size = top * top + bottom * bottom;
        Turn c = {(bottom * bottom - top * top) / size, 2 * top * bottom / size};
        Vector elbow = sub(turned_about(hc, pc, c, x), pb);
        double first = x1[0] + x1[1] * c.c + x1[2] * c.s, second = (n0 + n1 * c.c + n2 * c.s) / side;
        Vector image = add(add(scaled(dot(hb, elbow), hb), scaled(first, e1)), scaled(second, e2));
        out[found][0] = turn_from_to(ha, sub(image, origin), target);
        out[found][1] = turn_from_to(hb, elbow, image);
        out[found++][2] = c;
    }
    return found;
}

/* Rotations a, b, c about the first three axes with e_a e_b e_c x = y; returns their number. */
static long place(Arrangement lie, const double *axes, const double *points, Vector x, Vector y, Turn out[PLACES][3]) {
    Vector ha = row(axes, 0), hb = row(axes, 1), hc = row(axes, 2);
    Vector pa = row(points, 0), pb = row(points, 1), pc = row(points, 2), meeting = lie.meeting;
    long found = 0;
    if (lie.kind == SKEW) return place_skew(axes, points, x, y, out);
    if (lie.kind == A_MEETS_B) {
        Vector target = sub(y, meeting);
        Turns thirds = turns_to_distance(hc, pc, x, meeting, length(target));
        for (long k = 0; k < thirds.count; k++) {
            Turn c = thirds.turn[k], a[2];
            Turns b = two_meeting(ha, hb, sub(turned_about(hc, pc, c, x), meeting), target, a);
            for (long j = 0; j < b.count; j++, found++) out[found][0] = a[j], out[found][1] = b.turn[j], out[found][2] = c;
        }
    } else if (lie.kind == B_MEETS_C) {
        Vector start = sub(x, meeting);
        Turns firsts = turns_to_distance(ha, pa, y, meeting, length(start));
        for (long k = 0; k < firsts.count; k++) {
            Turn a = back(firsts.turn[k]), b[2];
            Turns c = two_meeting(hb, hc, start, sub(turned_about(ha, pa, back(a), y), meeting), b);
            for (long j = 0; j < c.count; j++, found++) out[found][0] = a, out[found][1] = b[j], out[found][2] = c.turn[j];
        }
    } else if (lie.kind == A_PARALLEL_B) {
        /* the height along a depends on c alone */
        Vector target = sub(y, pa);
        Turns thirds = turns_to_height(hc, sub(x, pc), ha, dot(ha, sub(y, pc)));
        for (long k = 0; k < thirds.count; k++) {
            Turn c = thirds.turn[k];
            Vector elbow = turned_about(hc, pc, c, x);
            Turns b = turns_to_distance(hb, pb, elbow, pa, length(target));
            for (long j = 0; j < b.count; j++, found++) {
                out[found][0] = turn_from_to(ha, sub(turned_about(hb, pb, b.turn[j], elbow), pa), target);
                out[found][1] = b.turn[j], out[found][2] = c;
            }
        }
    } else {
        Turns firsts = turns_to_height(ha, sub(y, pa), hb, dot(hb, sub(x, pa)));
        for (long k = 0; k < firsts.count; k++) {
            Turn a = back(firsts.turn[k]);
            Vector target = sub(turned_about(ha, pa, back(a), y), pb);
            Turns c = turns_to_distance(hc, pc, x, pb, length(target));
            for (long j = 0; j < c.count; j++, found++) {
                out[found][0] = a, out[found][2] = c.turn[j];
                out[found][1] = turn_from_to(hb, sub(turned_about(hc, pc, c.turn[j], x), pb), target);
            }
        }
    }
    return found;
}

/* Rotations with R4 R5 R6 = rotation, for any three axes; returns their number. */
static long orient(Vector h4, Vector h5, Vector h6, const double (*rotation)[4], Turn out[2][3]) {
    Vector toward = times(rotation, h6), across = perpendicular(h6), across_turned = times(rotation, across);
    Turns fifths = turns_to_height(h5, h6, h4, dot(h4, toward));
    for (long k = 0; k < fifths.count; k++) {
        Turn fifth = fifths.turn[k], fourth = turn_from_to(h4, turned(h5, fifth, h6), toward);
        /* R6 = R5ᵀ R4ᵀ R, also where axes 4 and 6 are in line and q4 is free */
        Vector image = turned(h5, back(fifth), turned(h4, back(fourth), across_turned));
        out[k][0] = fourth, out[k][1] = fifth, out[k][2] = turn_from_to(h6, across, image);
    }
    return fifths.count;
}

/* All joint angles with e_1 ... e_6 = motion, where axes 4, 5, 6 meet in `wrist` at q = 0 and the first three lie as told.
   Fills out (MOST + 1, 6), whose last row is scratch space; returns the number of solutions. */
static long solve_spherical(const Arm *arm, Arrangement lie, Vector wrist, const double (*motion)[4], double *out) {
    Vector h1 = row(arm->axes, 0), h2 = row(arm->axes, 1), h3 = row(arm->axes, 2);
    Vector h4 = row(arm->axes, 3), h5 = row(arm->axes, 4), h6 = row(arm->axes, 5);
    Vector target = add(times(motion, wrist), column(motion, 3));
    Turn places[PLACES][3], wrists[2][3];
    Motion rotation;
    long found = 0;
    for (long k = 0, count = place(lie, arm->axes, arm->points, wrist, target, places); k < count; k++) {
        double *first = out + 6 * found;
        if (!angles_fit(places[k], arm, 0, first)) continue;
        double qa = first[0], qb = first[1], qc = first[2];
        for (long j = 0; j < 3; j++) {
            Vector v = turned(h2, back(places[k][1]), turned(h1, back(places[k][0]), column(motion, j)));
            set_column(rotation, j, turned(h3, back(places[k][2]), v));
        }
        for (long j = 0, some = orient(h4, h5, h6, rotation, wrists); j < some; j++) {
            double *q = out + 6 * found;
            if (angles_fit(wrists[j], arm, 3, q + 3)) q[0] = qa, q[1] = qb, q[2] = qc, found++;
        }
    }
    return found;
}
