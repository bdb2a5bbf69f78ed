/* Integrals ∫ ‖q'‖ / (m² + ε²)^(p/2) ds over parts of a path, by Gauss points, and the minimum of m on it. Sums are taken in
   NumPy's order. */

#include <math.h>
#include <stdlib.h>
#include "batch.h"

typedef struct {
    const void *path, *slope;   /* the path's curve and its derivative */
    long (*evaluate)(const void *curve, const double *s, long m, double spacing, double *out); /* returns 0 */
    Batch measure;              /* m >= 0 */
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
        failed = f->evaluate(f->path, s, all, 0, q) || f->evaluate(f->slope, s, all, 0, v) || f->measure.run(f->measure.program, q, m, all);
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

/* The integral over `count` panels between edges (count + 1), each halved until that changes it by at most `accuracy` of the whole,
   at most `halvings` times; infinite where more than `most` panels still change. Returns 1 where that fails. */
int manipplan_integral(const Integral *f, const double *edges, long count, long most, long halvings, double accuracy, double *out) {
    double *begin = malloc((size_t)(3 * count) * sizeof *begin), settled = 0;
    if (!begin) return 1;
    double *end = begin + count, *whole = end + count;
    for (long k = 0; k < count; k++) begin[k] = edges[k], end[k] = edges[k + 1];
    int failed = manipplan_panels(f, begin, end, count, whole);
    for (long level = 0; level < halvings && count && !failed; level++) {
        double *from = malloc((size_t)(8 * count) * sizeof *from);
        if (!from) { failed = 1; break; }
        double *to = from + 2 * count, *part = to + 2 * count, *both = part + 2 * count, *kept = both + count;
        for (long k = 0; k < count; k++) {
            double middle = (begin[k] + end[k]) / 2;
            from[2 * k] = begin[k], to[2 * k] = from[2 * k + 1] = middle, to[2 * k + 1] = end[k];
        }
        failed = manipplan_panels(f, from, to, 2 * count, part);
        long known = 0, closed = 0, open = 0;
        for (long k = 0; k < count; k++) {
            both[k] = part[2 * k] + part[2 * k + 1];
            if (isfinite(both[k]) && isfinite(whole[k])) kept[known++] = whole[k];  /* not so where m vanishes at a point */
        }
        double allowed = accuracy * (settled + sum(kept, known));
        for (long k = 0; k < count; k++) {
            int finite = isfinite(both[k]) && isfinite(whole[k]);
            if (finite && fabs(both[k] - whole[k]) <= allowed) kept[closed++] = both[k];
            else both[open++] = (double)k;                   /* its number: at most k of these are there */
        }
        settled += sum(kept, closed);
        double *next = malloc((size_t)(6 * open + 1) * sizeof *next);
        if (!next) { free(from); failed = 1; break; }
        for (int side = 0; side < 2; side++)                 /* all left halves first, in NumPy's order */
            for (long i = 0; i < open; i++) {
                long k = 2 * (long)both[i] + side, at = side * open + i;
                next[at] = from[k], next[2 * open + at] = to[k], next[4 * open + at] = part[k];
            }
        free(begin), free(from);
        begin = next, count = 2 * open, end = begin + count, whole = end + count;
        if (count > most) { settled = INFINITY, count = 0; }
    }
    if (!failed) *out = settled + sum(whole, count);
    free(begin);
    return failed;
}

/* m at `count` places s of the path. Returns 1 where that fails. `q`: (count, n). */
static int measured(const Integral *f, const double *s, long count, double *q, double *m) {
    return f->evaluate(f->path, s, count, 0, q) || f->measure.run(f->measure.program, q, m, count);
}

/* Evenly spaced places from `low` to `high`, as NumPy's linspace gives them. */
static void spread(double low, double high, long intervals, double *s) {
    double step = (high - low) / (double)intervals;
    for (long i = 0; i < intervals; i++) s[i] = low + (double)i * step;
    s[intervals] = high;
}

/* The minimum of m on the path, its place, and the maximum on the first grid: out (3). On that grid of `intervals` the
   `deepest` dips are found, and each is searched on `grids` successively finer grids of `fine` intervals. Returns 1 where that
   fails. */
int manipplan_minimum(const Integral *f, long intervals, long deepest, long grids, long fine, double *out) {
    long most = intervals > fine ? intervals + 1 : fine + 1;
    double *s = malloc((size_t)(most * (f->n + 2)) * sizeof *s), *low = malloc((size_t)(3 * deepest) * sizeof *low);
    int failed = !s || !low;
    if (!failed) {
        double *m = s + most, *q = m + most, *high = low + deepest, *bottom = high + deepest;
        long dips = 0;
        spread(0, 1, intervals, s);
        failed = measured(f, s, intervals + 1, q, m);
        out[0] = INFINITY, out[1] = 0, out[2] = -INFINITY;
        for (long i = 0; i <= intervals && !failed; i++) {
            if (m[i] > out[2]) out[2] = m[i];
            if ((i > 0 && m[i] > m[i - 1]) || (i < intervals && m[i] > m[i + 1])) continue;
            if (dips == deepest && bottom[dips - 1] <= m[i]) continue;
            long k = dips < deepest ? dips++ : dips - 1;    /* when there are enough, the shallowest is dropped */
            for (; k > 0 && bottom[k - 1] > m[i]; k--) bottom[k] = bottom[k - 1], low[k] = low[k - 1], high[k] = high[k - 1];
            bottom[k] = m[i], low[k] = s[i > 0 ? i - 1 : 0], high[k] = s[i < intervals ? i + 1 : intervals];
        }
        for (long k = 0; k < dips && !failed; k++)
            for (long grid = 0; grid < grids && !failed; grid++) {
                long at = 0;
                spread(low[k], high[k], fine, s);
                failed = measured(f, s, fine + 1, q, m);
                for (long i = 1; i <= fine; i++) if (m[i] < m[at]) at = i;
                if (!failed && m[at] < out[0]) out[0] = m[at], out[1] = s[at];
                low[k] = s[at > 0 ? at - 1 : 0], high[k] = s[at < fine ? at + 1 : fine];
            }
    }
    free(s), free(low);
    return failed;
}
