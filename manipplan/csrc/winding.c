/* How often triangles go around points: the sum of their signed solid angles over 4 pi. */

#include <math.h>

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* Of triangles (t, 9) around points (k, 3): found (k). Each solid angle by the formula of van Oosterom and Strackee. */
void manipplan_winding(const double *triangles, long t, const double *points, long k, double *found) {
    for (long i = 0; i < k; i++) {
        double whole = 0;
        for (long j = 0; j < t; j++) {
            double side[3][3], length[3];
            for (int c = 0; c < 3; c++) {
                for (int x = 0; x < 3; x++) side[c][x] = triangles[9 * j + 3 * c + x] - points[3 * i + x];
                length[c] = sqrt(dot(side[c], side[c]));
            }
            const double *a = side[0], *b = side[1], *c = side[2];
            double across[3] = {b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]};
            double under = length[0] * length[1] * length[2] + dot(a, b) * length[2] + dot(b, c) * length[0] + dot(c, a) * length[1];
            whole += atan2(dot(a, across), under);
        }
        found[i] = whole / 6.283185307179586;
    }
}
