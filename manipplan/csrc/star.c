/* The cost of straight motions, and random changes of a way that lower it: shortcuts, and detours around the place between.

   The cost is the length or g, the integral of |q'|_W / (m² + floor²)^(p/2) over the motion. All arrays belong to the caller. */

#include <math.h>
#include <string.h>
#include "batch.h"

enum { MOST_JOINTS = 64, MOST_POINTS = 8 };
static const double LEAST_GAIN = 1e-4; /* share of the cost of a part that a change must save */

typedef struct {
    long n;                 /* number of joints */
    const double *low;      /* (n) limits */
    const double *high;
    const double *metric;   /* (n, n) W; 0: the identity */
    Batch measure;          /* m; without a `run` the cost is the length */
    double floor, power, least; /* `least` bounds the denominator from below */
    double panel;           /* maximum length of a panel */
    long points;            /* Gauss points of each, at most MOST_POINTS */
    const double *nodes, *weights; /* (points) on [-1, 1] */
    void *search;           /* what the next two take */
    int (*clear)(void *, const double *, const double *);      /* whether a straight motion is free, but for its begin */
    int (*allowed)(void *, const double *, long);              /* whether a way (count, n) has few enough changes of sides */
    double reach;           /* maximum distance of a detour, as a share of the length of what it replaces */
    unsigned long long random; /* state of the generator */
} Star;

/* A random number in [0, 1): splitmix64 [steele2014]. */
static double uniform(Star *s) {
    unsigned long long x = s->random += 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return (double)((x ^ (x >> 31)) >> 11) * 0x1p-53;
}

static double distance(const Star *s, const double *a, const double *b) {
    double sum = 0;
    for (long j = 0; j < s->n; j++) sum += (b[j] - a[j]) * (b[j] - a[j]);
    return sqrt(sum);
}

static double speed(const Star *s, const double *a, const double *b) {
    double sum = 0;
    if (!s->metric) return distance(s, a, b);
    for (long i = 0; i < s->n; i++)
        for (long j = 0; j < s->n; j++) sum += (b[i] - a[i]) * s->metric[i * s->n + j] * (b[j] - a[j]);
    return sqrt(fmax(sum, 0));
}

/* The cost of the straight motion from a to b; infinite where m cannot be evaluated. */
double manipplan_edge_cost(const Star *s, const double *a, const double *b) {
    double whole = speed(s, a, b), mean = 0, q[MOST_POINTS * MOST_JOINTS], m[MOST_POINTS];
    if (!s->measure.run || whole == 0) return whole;
    long panels = (long)ceil(distance(s, a, b) / s->panel);
    for (long k = 0; k < panels; k++) {
        for (long i = 0; i < s->points; i++) {
            double share = ((double)k + (s->nodes[i] + 1) / 2) / (double)panels;
            for (long j = 0; j < s->n; j++) q[i * s->n + j] = a[j] + share * (b[j] - a[j]);
        }
        if (s->measure.run(s->measure.program, q, m, s->points)) return INFINITY;
        for (long i = 0; i < s->points; i++) {
            double size = fmax(sqrt(m[i] * m[i] + s->floor * s->floor), s->least);
            mean += s->weights[i] / 2 / (s->power == 1 ? size : s->power == 2 ? size * size : pow(size, s->power));
        }
    }
    return whole * mean / (double)panels;
}

/* The cost of a way (count, n). */
double manipplan_way_cost(const Star *s, const double *way, long count) {
    double sum = 0;
    for (long k = 0; k + 1 < count; k++) sum += manipplan_edge_cost(s, way + k * s->n, way + (k + 1) * s->n);
    return sum;
}

/* The point at a length from the begin of a way, and the edge on which it lies. */
static long point_at(const Star *s, const double *way, long count, double length, double *out) {
    for (long k = 0;; k++) {
        const double *a = way + k * s->n, *b = a + s->n;
        double edge = distance(s, a, b);
        if (length < edge || k + 2 == count) {
            double share = edge > 0 ? fmin(length / edge, 1) : 0;
            for (long j = 0; j < s->n; j++) out[j] = a[j] + share * (b[j] - a[j]);
            return k;
        }
        length -= edge;
    }
}

/* Lower the cost of a way (count, n) by `attempts` random changes; it has room for `room` waypoints, as has `work`. Returns the
   number of its waypoints. */
long manipplan_improve(Star *s, double *way, double *work, long count, long room, long attempts) {
    size_t row = (size_t)s->n * sizeof *way;
    for (long attempt = 0; attempt < attempts; attempt++) {
        double length = 0, ends[2][MOST_JOINTS], via[MOST_JOINTS];
        for (long k = 0; k + 1 < count; k++) length += distance(s, way + k * s->n, way + (k + 1) * s->n);
        double share = uniform(s), part = length * share * share, first = (length - part) * uniform(s);
        int detour = uniform(s) < 0.5;
        long edge[2] = {point_at(s, way, count, first, ends[0]), point_at(s, way, count, first + part, ends[1])};
        point_at(s, way, count, first + part * uniform(s), via);
        double reach = s->reach * part * uniform(s);
        for (long j = 0; j < s->n; j++) via[j] = fmin(fmax(via[j] + reach * (2 * uniform(s) - 1), s->low[j]), s->high[j]);
        if (edge[0] == edge[1] && !detour) continue;
        long made = edge[0] + 1, begin = made - 1;
        if (made + 3 + count - edge[1] - 1 > room) continue;
        memcpy(work, way, (size_t)made * row);
        memcpy(work + made++ * s->n, ends[0], row);
        if (detour) memcpy(work + made++ * s->n, via, row);
        memcpy(work + made++ * s->n, ends[1], row);
        memcpy(work + made * s->n, way + (edge[1] + 1) * s->n, (size_t)(count - edge[1] - 1) * row);
        long end = made;
        made += count - edge[1] - 1;
        double before = manipplan_way_cost(s, way + begin * s->n, edge[1] + 2 - begin);
        double after = manipplan_way_cost(s, work + begin * s->n, end + 1 - begin);
        if (!(after < (1 - LEAST_GAIN) * before) || !s->allowed(s->search, work, made)) continue;
        if (!s->clear(s->search, ends[0], ends[0])) continue;
        if (!s->clear(s->search, ends[0], detour ? via : ends[1]) || (detour && !s->clear(s->search, via, ends[1]))) continue;
        memcpy(way, work, (size_t)made * row);
        count = made;
    }
    return count;
}
