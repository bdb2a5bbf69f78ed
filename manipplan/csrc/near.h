/* Steps between configurations: their size, and whether two configurations are neighbours. */

#pragma once

#include <math.h>

#define TAU 6.283185307179586

/* Displacement of a joint from a to b; the shorter way for a joint that turns without end. */
static inline double step(double a, double b, int turns) {
    double d = b - a;
    return turns ? d - TAU * floor(d / TAU + 0.5) : d;
}

/* Whether each joint's step from a to b (n) is below its limit `reach`. */
static inline int is_near(const double *a, const double *b, long n, const double *reach, const char *turns) {
    for (long j = 0; j < n; j++) {
        double d = b[j] - a[j];
        if (!(fabs(d) < reach[j]) && !(turns[j] && fabs(step(a[j], b[j], 1)) < reach[j])) return 0;
    }
    return 1;
}
