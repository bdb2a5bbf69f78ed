/* Curves of polynomial pieces in Bernstein form. All arrays belong to the caller.

   Powers are products, and sums begin with the first control point: the same numbers on every processor. */

#include <math.h>

enum { MOST_DEGREE = 30 };  /* up to here the binomial coefficients below are exact */

typedef struct {
    long pieces, degree, n;
    const double *breaks;   /* (pieces + 1) where pieces begin and end, increasing */
    const double *control;  /* (pieces, degree + 1, n) */
} Curve;

/* The piece that holds s: the last one that begins at or before it. */
static long piece_at(const Curve *c, double s) {
    long low = 0, high = c->pieces;
    while (high - low > 1) {
        long half = (low + high) / 2;
        if (c->breaks[half] <= s) low = half;
        else high = half;
    }
    return low;
}

/* The curve (m, n) at s (m), rounded to multiples of `spacing` unless that is 0. Returns the number of s outside [0, 1] and of
   NaN; with any of them, nothing is computed. */
long manipplan_curve(const Curve *c, const double *s, long m, double spacing, double *out) {
    long wrong = 0, k = c->degree, n = c->n;
    for (long i = 0; i < m; i++) wrong += !(s[i] >= 0 && s[i] <= 1);
    if (wrong) return wrong;
    double binomial[MOST_DEGREE + 1] = {1}, powers[MOST_DEGREE + 1] = {1}, rest[MOST_DEGREE + 1] = {1};
    for (long j = 1; j <= k; j++) binomial[j] = binomial[j - 1] * (double)(k - j + 1) / (double)j;
    for (long i = 0; i < m; i++, out += n) {
        long piece = piece_at(c, s[i]);
        double u = (s[i] - c->breaks[piece]) / (c->breaks[piece + 1] - c->breaks[piece]);
        for (long j = 1; j <= k; j++) powers[j] = powers[j - 1] * u, rest[j] = rest[j - 1] * (1 - u);
        const double *point = c->control + piece * (k + 1) * n;
        for (long d = 0; d < n; d++) out[d] = rest[k] * point[d];
        for (long j = 1; j <= k; j++) {
            double weight = binomial[j] * powers[j] * rest[k - j];
            point += n;
            for (long d = 0; d < n; d++) out[d] += weight * point[d];
        }
        if (spacing > 0)
            for (long d = 0; d < n; d++) out[d] = rint(out[d] / spacing) * spacing;
    }
    return 0;
}
