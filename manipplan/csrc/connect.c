/* RRT-Connect [kuffner2000] and random shortcuts, over the collision check of `distances.c`.

   Two trees grow from start and goal. A path may cross singularities a limited number of times: each node knows the sides of the
   singularities on which it lies, as signs of the functions of `SingularitySigns`, and how often one of them changed its sign on the way
   from its root. With constraints, the nodes are projected onto the configurations that keep them [berenson2009]. All arrays belong
   to the caller. */

#include <math.h>
#include <string.h>

#include "constraints.h"

enum { FREE, TOUCHING, UNDECIDED };
enum { SEARCHING, FOUND, FULL };
static const double LEAST_GAIN = 0.01; /* share of a way's length that a shortcut must save */
/* With constraints, shares of `range` that an edge tries in turn: the last one, and the ratio of neighbours; and the share of its
   length by which an edge has to come nearer to its target. */
static const double LAST_SHARE = 1.0 / 16, NEXT_SHARE = 1.0 / 4, NEARER = 0.25;
enum { MOST_SIDES = 8, BLOCK = 64, MOST_JOINTS = 64 };

typedef struct {
    unsigned char positive; /* bit i: function i is positive */
    unsigned char known;    /* bit i: it was not zero somewhere on the way from the root */
    long changes;           /* number of changes of a sign on that way */
} Side;

typedef struct {
    long n;                 /* number of joints */
    const double *low;      /* (n) bounds of random configurations */
    const double *high;
    double near;            /* share of them from a box around start and goal, */
    double around;          /* which is up to so much larger on each side than the box of both */
    const void *world;      /* what `check` takes */
    int (*check)(const void *, const double *, double);
    int (*decide)(const double *, double); /* FREE or TOUCHING where `check` cannot tell */
    double clearance;
    long levels;            /* a search begins with wide margins, and narrows them where it finds no path */
    const double *step;     /* (levels) largest motion of a joint between two checks */
    const double *margin;   /* (levels) demanded beyond the clearance, but no more at start and goal than */
    double spare[2];        /* what they have, */
    double growth;          /* and this more per rad or m away from them */
    const long *until;      /* (levels) number of checks after which the next level begins */
    long level;             /* that of now */
    double range;           /* longest edge */
    long sides;             /* number of functions; 0: singularities do not count */
    Batch values;           /* their values (sides) */
    const double *zero;     /* (sides) absolute values that count as zero */
    long most_changes;      /* on a path */
    double bound;           /* only paths of less cost are looked for; infinite: any */
    double rate;            /* lower bound of the cost per length */
    double (*cost_of)(const void *, const double *, const double *); /* the cost of a straight motion, */
    const void *star;       /* which takes this */
    unsigned long long random; /* state of the generator */
    long room;              /* for nodes of each tree */
    double *node[2];        /* (room, n) the tree of the start, and that of the goal; the first node is the root */
    long *parent[2];        /* (room) */
    Side *side[2];          /* (room) */
    double *cost[2];        /* (room) from the root, with a bound */
    long size[2];
    long met[2];            /* the nodes at which they met */
    long turn;              /* the tree that grows next */
    long checks;            /* number of configurations checked for collision */
    const Constraints *constraints; /* or null */
} Search;

/* A random number in [0, 1): splitmix64 [steele2014]. */
static double uniform(Search *s) {
    unsigned long long x = s->random += 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return (double)((x ^ (x >> 31)) >> 11) * 0x1p-53;
}

static int count_bits(unsigned char bits) {
    int count = 0;
    for (; bits; bits &= (unsigned char)(bits - 1)) count++;
    return count;
}

/* The number of functions whose signs differ and are known on both. */
static int differences(const Side *a, const Side *b) {
    return count_bits((unsigned char)((a->positive ^ b->positive) & a->known & b->known));
}

static double distance(const Search *s, const double *a, const double *b) {
    double sum = 0;
    for (long j = 0; j < s->n; j++) sum += (b[j] - a[j]) * (b[j] - a[j]);
    return sqrt(sum);
}

/* Go on to the level of the number of checks. What was free with a wide margin is so with a narrow one: the trees are kept. */
static void narrow(Search *s) {
    while (s->level + 1 < s->levels && s->checks >= s->until[s->level]) s->level++;
}

static int is_free(Search *s, const double *q) {
    double margin = s->margin[s->level];
    for (int end = 0; end < 2; end++)
        if (margin > s->spare[end]) margin = fmin(margin, s->spare[end] + s->growth * distance(s, q, s->node[end]));
    s->checks++;
    if (s->constraints && !keeps(s->constraints, q)) return 0;
    int verdict = s->check(s->world, q, s->clearance + margin);
    return verdict == UNDECIDED ? s->decide(q, s->clearance + margin) == FREE : verdict == FREE;
}

static void between(const Search *s, const double *a, const double *b, double share, double *out) {
    for (long j = 0; j < s->n; j++) out[j] = a[j] + share * (b[j] - a[j]);
}

static long steps_of(const Search *s, const double *a, const double *b) {
    double most = 0;
    for (long j = 0; j < s->n; j++) most = fmax(most, fabs(b[j] - a[j]));
    long count = (long)ceil(most / s->step[s->level]);
    return count > 1 ? count : 1;
}

/* Carry `side` from a to b; returns whether a path from there to `other` may still have few enough changes. */
static int carry(const Search *s, const double *a, const double *b, Side *side, const Side *other) {
    double q[BLOCK * MOST_JOINTS], value[BLOCK * MOST_SIDES];
    long count = steps_of(s, a, b);
    for (long begin = 1; begin <= count; begin += BLOCK) {
        long run = count + 1 - begin < BLOCK ? count + 1 - begin : BLOCK;
        for (long k = 0; k < run; k++) between(s, a, b, (double)(begin + k) / (double)count, q + k * s->n);
        if (s->values.run(s->values.program, q, value, run)) return 0;
        for (long k = 0; k < run; k++)
            for (long i = 0; i < s->sides; i++) {
                double v = value[k * s->sides + i];
                unsigned char bit = (unsigned char)(1u << i), positive = v >= 0 ? bit : 0;
                if (fabs(v) < s->zero[i]) continue;
                side->changes += (side->known & bit) && (side->positive & bit) != positive;
                side->positive = (unsigned char)((side->positive & ~bit) | positive), side->known |= bit;
            }
        if (side->changes + differences(side, other) > s->most_changes) return 0;
    }
    return 1;
}

/* Whether the straight motion from a, which is free, to b is free: b first, then samples that are far apart. */
static int motion_is_free(Search *s, const double *a, const double *b) {
    double q[MOST_JOINTS];
    long count = steps_of(s, a, b), stride = 1;
    if (!is_free(s, b)) return 0;
    while (2 * stride < count) stride *= 2;
    for (; stride > 0 && count > 1; stride /= 2)
        for (long k = stride; k < count; k += 2 * stride) {
            between(s, a, b, (double)k / (double)count, q);
            if (!is_free(s, q)) return 0;
        }
    return 1;
}

/* Whether a configuration is free and, where singularities count, no more sides from the start than a path may change. */
int manipplan_state(Search *s, const double *q) {
    Side side = s->side[0][0];
    if (s->sides && !carry(s, q, q, &side, s->side[1])) { s->checks++; return 0; }
    return is_free(s, q);
}

/* Whether the straight motion from a, for which `manipplan_state` holds, to b is free; where singularities count, it changes no
   more sides, from those of the start on, than a path may. */
int manipplan_motion_is_free(Search *s, const double *a, const double *b) {
    narrow(s);
    Side side = s->side[0][0];
    if (s->sides && !carry(s, a, b, &side, s->side[1])) { s->checks++; return 0; }
    return motion_is_free(s, a, b);
}

/* The node nearest to q; with a bound, of those from which q can be reached for at most `most`, or the root. */
static long nearest(const Search *s, long tree, const double *q, double most) {
    long best = 0;
    double least = INFINITY;
    for (long k = 0; k < s->size[tree]; k++) {
        const double *node = s->node[tree] + k * s->n;
        double sum = 0;
        for (long j = 0; j < s->n; j++) sum += (q[j] - node[j]) * (q[j] - node[j]);
        if (sum < least && (!k || s->bound == INFINITY || s->cost[tree][k] + s->rate * sqrt(sum) <= most)) least = sum, best = k;
    }
    return best;
}

/* Add a node of `tree` towards `target`, at most `range` from node `from`; returns it, or -1 where the motion is not possible. */
static long extend_by(Search *s, long tree, long from, const double *target, double range) {
    const double *a = s->node[tree] + from * s->n;
    long made = s->size[tree];
    double *b = s->node[tree] + made * s->n, far = distance(s, a, target);
    if (far > range) between(s, a, target, range / far, b);
    else memcpy(b, target, (size_t)s->n * sizeof *b);
    if (s->constraints) {
        double gradient[MOST_JOINTS];
        if (!project(s->constraints, s->low, s->high, b, gradient)) return -1;
        if (!(far - distance(s, b, target) >= NEARER * fmin(far, range))) return -1;
    }
    Side side = s->side[tree][from];
    if (s->bound < INFINITY) {
        s->cost[tree][made] = s->cost[tree][from] + s->cost_of(s->star, a, b);
        if (!(s->cost[tree][made] + s->rate * distance(s, b, s->node[1 - tree]) < s->bound)) return -1;
    }
    if (s->sides && !carry(s, a, b, &side, s->side[1 - tree])) return -1;
    if (!motion_is_free(s, a, b)) return -1;
    s->parent[tree][made] = from, s->side[tree][made] = side;
    s->size[tree]++;
    return made;
}

/* The same, with edges as long as possible. */
static long extend(Search *s, long tree, long from, const double *target) {
    long made = extend_by(s, tree, from, target, s->range);
    if (s->constraints)
        for (double share = NEXT_SHARE; made < 0 && share >= LAST_SHARE; share *= NEXT_SHARE)
            made = extend_by(s, tree, from, target, share * s->range);
    return made;
}

/* Whether either tree may run out of room before the next try to join them ends. */
static int is_full(const Search *s) {
    double square = 0;
    for (long j = 0; j < s->n; j++) square += (s->high[j] - s->low[j]) * (s->high[j] - s->low[j]);
    long longest = (long)(sqrt(square) / (s->range * (s->constraints ? LAST_SHARE * NEARER : 1))) + 3;
    return s->size[0] + longest > s->room || s->size[1] + longest > s->room;
}

/* A random configuration of the ellipsoid of all paths shorter than `length` [gammell2014]; one of its limits where it is outside. */
static void sample_inside(Search *s, double length, double *q) {
    double x[MOST_JOINTS], axis[MOST_JOINTS], square = 2, far = distance(s, s->node[0], s->node[1]), along = 0;
    for (int k = 0; square > 1 && k < 1000; k++) {
        square = 0;
        for (long j = 0; j < s->n; j++) x[j] = 2 * uniform(s) - 1, square += x[j] * x[j];
    }
    double across = sqrt(fmax(length * length - far * far, 0)) / 2, size = square > 1 ? 1 / sqrt(square) : 1;
    for (long j = 0; j < s->n; j++) {                       /* a reflection turns the first axis towards the goal */
        x[j] *= size * (j ? across : length / 2);
        axis[j] = (s->node[1][j] - s->node[0][j]) / far - (j == 0);
        along += axis[j] * x[j];
    }
    double axes = 0;
    for (long j = 0; j < s->n; j++) axes += axis[j] * axis[j];
    for (long j = 0; j < s->n; j++) {
        q[j] = (s->node[0][j] + s->node[1][j]) / 2 + x[j] - (axes > 0 ? 2 * along / axes * axis[j] : 0);
        q[j] = fmin(fmax(q[j], s->low[j]), s->high[j]);
    }
}

/* A random configuration, most often from a box of random size around start and goal. */
static void sample(Search *s, double *q) {
    if (s->bound < INFINITY && s->rate > 0 && uniform(s) < s->near) {
        sample_inside(s, s->bound / s->rate, q);
        return;
    }
    double around = uniform(s) < s->near ? s->around * uniform(s) : INFINITY;
    for (long j = 0; j < s->n; j++) {
        double a = s->node[0][j], b = s->node[1][j];
        double low = fmax(s->low[j], fmin(a, b) - around), high = fmin(s->high[j], fmax(a, b) + around);
        q[j] = low + uniform(s) * (high - low);
    }
}

/* Grow until the trees meet (FOUND), the arrays are full (FULL), or `checks` further configurations were checked (SEARCHING). */
int manipplan_connect(Search *s, long checks) {
    long end = s->checks + checks;
    while (s->checks < end) {
        narrow(s);
        if (is_full(s)) return FULL;
        long tree = s->turn, other = 1 - tree, at;
        double target[MOST_JOINTS], gradient[MOST_JOINTS];
        sample(s, target);
        if (s->constraints) project(s->constraints, s->low, s->high, target, gradient);
        double most = s->bound < INFINITY ? uniform(s) * s->bound : 0;
        s->checks++; /* so that it ends even where no motion is checked */
        long made = extend(s, tree, nearest(s, tree, target, most), target);
        if (made < 0) continue;
        memcpy(target, s->node[tree] + made * s->n, (size_t)s->n * sizeof *target);
        double left = s->bound < INFINITY ? s->bound - s->cost[tree][made] : 0;
        for (at = nearest(s, other, target, left); at >= 0; ) {
            const double *here = s->node[other] + at * s->n;
            if (memcmp(here, target, (size_t)s->n * sizeof *here) == 0) {
                const Side *one = s->side[tree] + made, *two = s->side[other] + at;
                if (s->bound < INFINITY && !(s->cost[other][at] < left)) break;
                if (s->sides && one->changes + two->changes + differences(one, two) > s->most_changes) break;
                s->met[tree] = made, s->met[other] = at;
                return FOUND;
            }
            at = extend(s, other, at, target);
        }
        s->turn = s->size[0] <= s->size[1] ? 0 : 1;
    }
    return SEARCHING;
}

/* The number of nodes from start to goal where the trees met; `out` (number, n) or null. */
long manipplan_way(const Search *s, double *out) {
    long count[2];
    for (long tree = 0; tree < 2; tree++) {
        count[tree] = 0;
        for (long at = s->met[tree]; at >= 0; at = s->parent[tree][at]) count[tree]++;
    }
    long all = count[0] + count[1] - 1, k = count[0] - 1;
    if (!out) return all;
    for (long at = s->met[0]; at >= 0; at = s->parent[0][at], k--)
        memcpy(out + k * s->n, s->node[0] + at * s->n, (size_t)s->n * sizeof *out);
    k = count[0];
    for (long at = s->parent[1][s->met[1]]; at >= 0; at = s->parent[1][at], k++)
        memcpy(out + k * s->n, s->node[1] + at * s->n, (size_t)s->n * sizeof *out);
    return all;
}

/* Whether a way through waypoints (count, n) has few enough changes. */
static int way_is_allowed(const Search *s, const double *way, long count) {
    Side side = s->side[0][0];
    if (!s->sides) return 1;
    for (long k = 0; k + 1 < count; k++)
        if (!carry(s, way + k * s->n, way + (k + 1) * s->n, &side, s->side[1])) return 0;
    return 1;
}

/* Whether no sign changes on the straight motion from a to b: where it replaces a part of a way, that does not change more sides. */
static int keeps_sides(const Search *s, const double *a, const double *b) {
    Side side = {0, 0, 0}, any = {0, 0, 0};
    return !s->sides || (carry(s, a, a, &side, &any) && carry(s, a, b, &side, &any) && side.changes == 0);
}

/* The same for other code, and whether a motion is free, but for its begin. */
int manipplan_allowed(const Search *s, const double *way, long count) { return way_is_allowed(s, way, count); }
int manipplan_clear(Search *s, const double *a, const double *b) { return motion_is_free(s, a, b); }

/* Leave out waypoints of a way (count, n) that a straight motion can skip, those that skip most first. `work` has as much room.
   Returns the number of its waypoints. */
long manipplan_skip(Search *s, double *way, double *work, long count) {
    size_t row = (size_t)s->n * sizeof *way;
    for (long k = 0; k + 2 < count; k++)
        for (long far = count - 1; far > k + 1; far--) {
            memcpy(work, way, (size_t)(k + 1) * row);
            memcpy(work + (k + 1) * s->n, way + far * s->n, (size_t)(count - far) * row);
            if (!keeps_sides(s, way + k * s->n, way + far * s->n) && !way_is_allowed(s, work, count - far + k + 1)) continue;
            if (!motion_is_free(s, way + k * s->n, way + far * s->n)) continue;
            count -= far - k - 1;
            memcpy(way, work, (size_t)count * row);
            break;
        }
    return count;
}

/* Replace parts of a way (count, n) by straight motions, `attempts` times, between random places on it. It has room for two more
   waypoints, as has `work`. Returns the number of its waypoints. */
long manipplan_shorten(Search *s, double *way, double *work, long count, long attempts) {
    size_t row = (size_t)s->n * sizeof *way;
    for (long attempt = 0; attempt < attempts && count > 2; attempt++) {
        double length = 0;
        for (long k = 0; k + 1 < count; k++) length += distance(s, way + k * s->n, way + (k + 1) * s->n);
        double place[2] = {length * uniform(s), length * uniform(s)}, ends[2][MOST_JOINTS];
        if (place[0] > place[1]) { double kept = place[0]; place[0] = place[1], place[1] = kept; }
        long edge[2] = {-1, -1};
        double gone = 0;
        for (long k = 0; k + 1 < count && edge[1] < 0; k++) {
            const double *a = way + k * s->n, *b = a + s->n;
            double edge_length = distance(s, a, b);
            for (int i = 0; i < 2; i++)
                if (edge[i] < 0 && (place[i] < gone + edge_length || k + 2 == count)) {
                    double share = edge_length > 0 ? (place[i] - gone) / edge_length : 0;
                    edge[i] = k, between(s, a, b, fmin(fmax(share, 0), 1), ends[i]);
                }
            gone += edge_length;
        }
        if (edge[0] == edge[1] || place[1] - place[0] - distance(s, ends[0], ends[1]) < LEAST_GAIN * length) continue;
        long made = edge[0] + 1;
        memcpy(work, way, (size_t)made * row);
        memcpy(work + made++ * s->n, ends[0], row), memcpy(work + made++ * s->n, ends[1], row);
        memcpy(work + made * s->n, way + (edge[1] + 1) * s->n, (size_t)(count - edge[1] - 1) * row);
        made += count - edge[1] - 1;
        if (!keeps_sides(s, ends[0], ends[1]) && !way_is_allowed(s, work, made)) continue;
        if (!is_free(s, ends[0]) || !motion_is_free(s, ends[0], ends[1])) continue;
        memcpy(way, work, (size_t)made * row);
        count = made;
    }
    return count;
}
