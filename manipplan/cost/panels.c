/* Integrals ∫ ‖q'‖ / (m² + ε²)^(p/2) ds over parts of a path, by Gauss points. Sums are taken in NumPy's order. */

#include <math.h>
#include <stdlib.h>

typedef struct {
    const void *path, *slope;   /* the path's curve and its derivative */
    long (*evaluate)(const void *curve, const double *s, long m, double spacing, double *out); /* returns 0 */
    int (*measure)(const double *q, double *out, long m); /* m >= 0 of configurations; returns 0 where these are finite */
    long n;                     /* number of joints */
    long points;                /* Gauss points on [-1, 1] and their weights */
    const double *nodes, *weights;
    double floor, power;        /* ε, and p: 1 or 2 */
} Integral;

enum { TOGETHER = 32 };         /* panels that are evaluated at a time */

/* The sum of a row, in pairs. */
static double sum(const double *a, long count) {
    if (count < 8) {
        double all = 0;
        for (long i = 0; i < count; i++) all += a[i];
        return all;
    }
    if (count > 128) {
        long half = count / 2;
        half -= half % 8;
        return sum(a, half) + sum(a + half, count - half);
    }
    double part[8];
    long i = 8;
    for (int j = 0; j < 8; j++) part[j] = a[j];
    for (; i < count - count % 8; i += 8)
        for (int j = 0; j < 8; j++) part[j] += a[i + j];
    double all = ((part[0] + part[1]) + (part[2] + part[3])) + ((part[4] + part[5]) + (part[6] + part[7]));
    for (; i < count; i++) all += a[i];
    return all;
}

/* The integral over each panel (count) from `begin` to `end`. Returns 1 where that fails. */
int manipplan_panels(const Integral *f, const double *begin, const double *end, long count, double *out) {
    long n = f->n, each = f->points, most = each * (count < TOGETHER ? count : TOGETHER);
    double *s = malloc((size_t)(most * (2 * n + 2) + n) * sizeof *s);
    if (!s) return 1;
    double *m = s + most, *q = m + most, *v = q + most * n, *square = v + most * n;
    int failed = 0;
    for (long first = 0; first < count && !failed; first += TOGETHER) {
        long panels = count - first < TOGETHER ? count - first : TOGETHER, all = panels * each;
        for (long k = 0; k < panels; k++) {
            double half = (end[first + k] - begin[first + k]) / 2;
            for (long i = 0; i < each; i++) {
                double at = begin[first + k] + half * (1 + f->nodes[i]);
                s[k * each + i] = at < 0 ? 0 : at > 1 ? 1 : at;
            }
        }
        failed = f->evaluate(f->path, s, all, 0, q) || f->evaluate(f->slope, s, all, 0, v) || f->measure(q, m, all);
        for (long k = 0; k < panels && !failed; k++) {
            double half = (end[first + k] - begin[first + k]) / 2;
            for (long i = 0; i < each; i++) {
                long at = k * each + i;
                for (long j = 0; j < n; j++) square[j] = v[at * n + j] * v[at * n + j];
                double under = hypot(m[at], f->floor);
                if (f->power == 2) under *= under;
                s[at] = half * f->weights[i] * (sqrt(sum(square, n)) / under);
            }
            out[first + k] = sum(s + k * each, each);
        }
    }
    free(s);
    return failed;
}

/* Halve panels until that changes each by at most `accuracy` of the whole, at most `halvings` times. `edges` begins with the edges
   of the first `count` panels; the new ones follow, in no order. Returns the number of all edges, of which only the first `room`
   are written; -1 where that fails. */
long manipplan_fine_panels(const Integral *f, double *edges, long count, long room, long halvings, double accuracy) {
    long all = count + 1;
    double *begin = malloc((size_t)(9 * count) * sizeof *begin);
    if (!begin) return -1;
    double *end = begin + count, *whole = end + count;
    for (long k = 0; k < count; k++) begin[k] = edges[k], end[k] = edges[k + 1];
    if (manipplan_panels(f, begin, end, count, whole)) { free(begin); return -1; }
    double settled = 0;
    for (long level = 0; level < halvings; level++) {
        double *from = begin + 3 * count, *to = from + 2 * count, *part = to + 2 * count;
        for (long k = 0; k < count; k++) {
            double middle = (begin[k] + end[k]) / 2;
            from[2 * k] = begin[k], to[2 * k] = from[2 * k + 1] = middle, to[2 * k + 1] = end[k];
        }
        if (manipplan_panels(f, from, to, 2 * count, part)) { free(begin); return -1; }
        double *halves = begin, *closed = end;              /* no longer needed: the ends are in `from` and `to` */
        for (long k = 0; k < count; k++) halves[k] = part[2 * k] + part[2 * k + 1];
        double allowed = accuracy * (settled + sum(halves, count));
        long rough = 0, done = 0;
        for (long k = 0; k < count; k++)
            if (fabs(whole[k] - halves[k]) > allowed) whole[rough++] = (double)k;  /* their numbers: at most k are there */
            else closed[done++] = halves[k];
        settled += sum(closed, done);
        if (!rough) break;
        double *next = malloc((size_t)(18 * rough) * sizeof *next);
        if (!next) { free(begin); return -1; }
        for (long i = 0; i < rough; i++) {
            long k = (long)whole[i];
            if (all < room) edges[all] = to[2 * k];
            all++;
            for (int side = 0; side < 2; side++) {
                next[2 * i + side] = from[2 * k + side], next[2 * rough + 2 * i + side] = to[2 * k + side];
                next[4 * rough + 2 * i + side] = part[2 * k + side];
            }
        }
        free(begin);
        begin = next, count = 2 * rough, end = begin + count, whole = end + count;
    }
    free(begin);
    return all;
}
