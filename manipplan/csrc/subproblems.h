/* Vectors, rotations about axes, and the geometric Paden-Kahan subproblems [murray1994, ch. 3] that closed-form inverse
   kinematics is built from.

   Where a subproblem misses a solution by less than GRAZE, two guesses next to the nearest point are returned, since an arm may
   differ from its closed form by the rounding of its description. All solutions are refined and verified by forward kinematics
   afterwards. */

#pragma once

#include <math.h>

/* Maximum amount by which a cosine may exceed 1. */
#define GRAZE 1e-3

typedef struct { double x, y, z; } Vector;

/* Cosine and sine of an angle: trigonometric functions are evaluated for the resulting angles only. */
typedef struct { double c, s; } Turn;

/* Rotations: their number, and two of them. */
typedef struct { long count; Turn turn[2]; } Turns;

/* The upper three rows of a matrix (4, 4): rotation and translation. */
typedef double Motion[3][4];

static const Turn still = {1.0, 0.0};

static inline double larger(double a, double b) { return a > b ? a : b; }
static inline double smaller(double a, double b) { return a < b ? a : b; }

/* Row k of an array (k, 3). */
static inline Vector row(const double *rows, long k) { return (Vector){rows[3 * k], rows[3 * k + 1], rows[3 * k + 2]}; }

static inline void set_row(double *rows, long k, Vector v) { rows[3 * k] = v.x, rows[3 * k + 1] = v.y, rows[3 * k + 2] = v.z; }

static inline Vector column(const double (*m)[4], long j) { return (Vector){m[0][j], m[1][j], m[2][j]}; }

static inline void set_column(Motion m, long j, Vector v) { m[0][j] = v.x, m[1][j] = v.y, m[2][j] = v.z; }

static inline double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static inline Vector cross(Vector a, Vector b) {
    return (Vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline Vector add(Vector a, Vector b) { return (Vector){a.x + b.x, a.y + b.y, a.z + b.z}; }
static inline Vector sub(Vector a, Vector b) { return (Vector){a.x - b.x, a.y - b.y, a.z - b.z}; }
static inline Vector scaled(double a, Vector v) { return (Vector){a * v.x, a * v.y, a * v.z}; }
static inline double length(Vector v) { return sqrt(dot(v, v)); }

static inline Vector unit(Vector v) {
    double size = length(v);
    return (Vector){v.x / size, v.y / size, v.z / size};
}

/* `v` rotated by the matrix of a motion, and by its transpose. */
static inline Vector times(const double (*m)[4], Vector v) {
    return (Vector){m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z, m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
                    m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
}

static inline Vector times_back(const double (*m)[4], Vector v) {
    return (Vector){m[0][0] * v.x + m[1][0] * v.y + m[2][0] * v.z, m[0][1] * v.x + m[1][1] * v.y + m[2][1] * v.z,
                    m[0][2] * v.x + m[1][2] * v.y + m[2][2] * v.z};
}

/* `v` rotated about the unit axis h (Rodrigues). */
static inline Vector turned(Vector h, Turn turn, Vector v) {
    double c = turn.c, s = turn.s, along = dot(h, v) * (1.0 - c);
    Vector w = cross(h, v);
    return (Vector){c * v.x + s * w.x + along * h.x, c * v.y + s * w.y + along * h.y, c * v.z + s * w.z + along * h.z};
}

/* The point `v` rotated about the axis h through the point p. */
static inline Vector turned_about(Vector h, Vector p, Turn turn, Vector v) { return add(p, turned(h, turn, sub(v, p))); }

/* The inverse rotation. */
static inline Turn back(Turn turn) { return (Turn){turn.c, -turn.s}; }

/* The angle of a rotation, in [-π, π]. */
static inline double angle_of(Turn turn) { return atan2(turn.s, turn.c); }

static inline Turn turn_by(double angle) { return (Turn){cos(angle), sin(angle)}; }

/* A unit vector perpendicular to h. */
static Vector perpendicular(Vector h) {
    return unit(fabs(h.x) < 0.6 ? (Vector){0.0, -h.z, h.y} : (Vector){h.z, 0.0, -h.x});
}

/* Subproblem 1: the rotation about h that brings x nearest to y; the identity where either lies on the axis. */
static Turn turn_from_to(Vector h, Vector x, Vector y) {
    double s = dot(cross(h, x), y), c = dot(x, y) - dot(h, x) * dot(h, y), size = sqrt(s * s + c * c);
    return size < 1e-14 ? still : (Turn){c / size, s / size};
}

/* Subproblem 4: rotations about h at which k · (x rotated) = d: none where the height cannot be reached; one, the identity,
   where every rotation reaches it. */
static Turns turns_to_height(Vector h, Vector x, Vector k, double d) {
    double a = dot(k, x) - dot(h, x) * dot(h, k), b = dot(k, cross(h, x));
    double rest = d - dot(h, x) * dot(h, k), size = sqrt(a * a + b * b);
    if (size < 1e-12) return (Turns){fabs(rest) < 1e-9, {still, still}};
    double ratio = rest / size, off;
    if (!(fabs(ratio) <= 1.0 + GRAZE)) return (Turns){0, {still, still}};
    if (fabs(ratio) <= 1.0) {
        off = sqrt((1.0 - ratio) * (1.0 + ratio));
    } else {
        off = sqrt(2.0 * (fabs(ratio) - 1.0));
        ratio = copysign(sqrt(1.0 - off * off), ratio);
    }
    a /= size, b /= size;
    return (Turns){2, {{a * ratio - b * off, b * ratio + a * off}, {a * ratio + b * off, b * ratio - a * off}}};
}

/* Subproblem 3: rotations about h through p that bring the point x to `distance` from the point y. */
static Turns turns_to_distance(Vector h, Vector p, Vector x, Vector y, double distance) {
    x = sub(x, p), y = sub(y, p);
    /* |x rotated - y|² = |x|² + |y|² - 2 y · (x rotated) */
    return turns_to_height(h, x, y, 0.5 * (dot(x, x) + dot(y, y) - distance * distance));
}
