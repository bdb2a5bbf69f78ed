/* Where pairs of bodies are near along a curve: at the places of a grid, and at the bottoms of dips between them. All arrays
   belong to the caller.

   A bottom is searched for inside a bracket: two steps go to the minimum of a parabola, every third halves the longer side. */

#include <math.h>
#include <stdlib.h>

enum { ASKING = -1, MORE_ROOM = -2 };   /* what `manipplan_near_pairs` returns when it is not done */
enum { GUESS = 22 };                    /* as in distances.c */

typedef struct {
    double low, middle, high;   /* places s on the curve */
    double left, least, right;  /* the distances there [m] */
    double next, found;         /* the place of which the distance is asked, and the answer; NaN: nothing is asked, or known */
    long steps;                 /* number of steps taken */
    long pair, leaf;            /* `leaf`: of the second body, whose distance counts alone; -1: that of the whole body */
} Bracket;

typedef struct {
    long n;                     /* number of joints */
    const void *curve;
    long (*curve_at)(const void *curve, const double *s, long m, double spacing, double *out);  /* manipplan_curve */
    double spacing;             /* of the grid of configurations [rad or m] */
    const void *world;
    double (*distance)(const void *world, const double *q, const long *bodies, double *guess);  /* manipplan_pair */
    double (*distance_of_leaf)(const void *world, const double *q, const long *bodies, long leaf);  /* manipplan_leaf */
    double grid;                /* spacing of the grid of distances [m] */
    double enough;              /* width at which a bracket is narrow enough */
    long most_steps;
} Dips;

/* The distance at s, rounded to the grid; NaN where the kernel cannot tell. `guess` (GUESS): from a place nearby, or zeros. */
static double distance_at(const Dips *d, double s, const long *bodies, long leaf, double *guess) {
    double q[d->n];
    if (d->curve_at(d->curve, &s, 1, d->spacing, q)) return NAN;
    double found = leaf < 0 ? d->distance(d->world, q, bodies, guess) : d->distance_of_leaf(d->world, q, bodies, leaf);
    return rint(found / d->grid) * d->grid;
}

static int is_done(const Dips *d, const Bracket *b) {
    return b->steps >= d->most_steps || !(b->high - b->low >= d->enough);
}

/* The place inside the bracket where the next distance is measured. */
static double next_place(const Dips *d, const Bracket *b) {
    double left = b->middle - b->low, right = b->high - b->middle, longer = left > right ? -left / 2 : right / 2;
    double falls = (b->left - b->least) / left, rises = (b->right - b->least) / right;
    double parabola = (right * falls - left * rises) / (2 * (falls + rises));
    int usable = isfinite(parabola) && parabola > -left && parabola < right && b->steps % 3 < 2;
    double change = usable ? parabola : longer, gap = fmax(0.02 * (left + right), d->enough / 4);
    if (fabs(change) < gap) change = copysign(gap, longer);
    return fmin(fmax(b->middle + change, b->low), b->high);
}

/* The nearer of the middle and the new place becomes the middle, the other an end of the bracket. */
static void narrow(Bracket *b, double place, double value) {
    int better = value < b->least, after = place > b->middle;
    double end = better ? b->middle : place, end_value = better ? b->least : value;
    if (better == after) b->low = end, b->left = end_value;
    else b->high = end, b->right = end_value;
    if (better) b->middle = place, b->least = value;
    b->steps++;
}

/* Narrow m brackets, of the pairs bodies (m, 2). Returns how many wait for a distance that the kernel cannot tell. */
static long find_bottoms(const Dips *d, const long *bodies, long m, Bracket *bracket) {
    long waiting = 0;
    for (long k = 0; k < m; k++) {
        Bracket *b = bracket + k;
        double guess[GUESS] = {0};
        if (!isnan(b->next)) {
            narrow(b, b->next, b->found);
            b->next = NAN;
        }
        while (!is_done(d, b)) {
            double place = next_place(d, b), value = distance_at(d, place, bodies + 2 * k, b->leaf, guess);
            if (isnan(value)) {
                b->next = place, waiting++;
                break;
            }
            narrow(b, place, value);
        }
    }
    return waiting;
}

typedef struct {
    long stage, entries;        /* how far the scan is: 0 at first; number of near pairs found */
    long pairs;                 /* number of pairs */
    const long *bodies;         /* (pairs, 2) */
    long (*near)(const void *world, const double *q, long m, const double *reach, long room, long *where,
                 double *out);  /* manipplan_near */
    long places, spacing;       /* number of places of the grid; every `spacing`-th has a wider band */
    const double *s;            /* (places) from 0 to 1 */
    double target;              /* distance to keep [m] */
    double close;               /* every place nearer than the target plus this is returned [m] */
    double deep;                /* dips that may be below the target plus this are searched for their bottoms [m] */
    double farthest;            /* distances are cut off at the target plus this [m] */
    long known;                 /* number of places around which there is always a search */
    const double *known_s;
    const long *known_pair;
    double *q, *reach;          /* work: (places, n), (places) */
    long room;
    long *where;                /* work: (room) */
    double *distance;           /* work: (room) */
    Bracket *bracket;           /* work: (room + known) */
    long (*leaves)(const void *world, const double *q, const long *bodies, double reach, long room, long *leaf,
                   double *distance);  /* manipplan_leaves */
    long most_leaves;           /* maximum number of leaves of a surface whose dips are located where it is near */
    double farther;             /* these leaves are at most this much farther than the nearest, or than the target [m] */
    long most_dips;             /* maximum number of brackets apart from those around known places: the lowest */
    long dips;                  /* number of brackets */
    long *bracket_bodies;       /* work: (room + known, 2) */
} Scan;

typedef struct {
    double distance, s;         /* signed distance [m], place on the curve */
    long pair, leaf, is_bottom; /* `leaf`: of the pair's second body; -1: the nearest, or it is no surface */
} Found;

/* By distance, place, pair, and bottoms last. */
static int order(const void *one, const void *two) {
    const Found *a = one, *b = two;
    if (a->distance != b->distance) return a->distance < b->distance ? -1 : 1;
    if (a->s != b->s) return a->s < b->s ? -1 : 1;
    if (a->pair != b->pair) return a->pair < b->pair ? -1 : 1;
    if (a->leaf != b->leaf) return a->leaf < b->leaf ? -1 : 1;
    return (int)(a->is_bottom - b->is_bottom);
}

/* Order the near pairs of one place, from `begin` to `end`, by their numbers. They are few. */
static void order_pairs(const Scan *l, long begin, long end) {
    for (long k = begin + 1; k < end; k++) {
        long where = l->where[k], i = k;
        double distance = l->distance[k];
        for (; i > begin && l->where[i - 1] > where; i--) l->where[i] = l->where[i - 1], l->distance[i] = l->distance[i - 1];
        l->where[i] = where, l->distance[i] = distance;
    }
}

/* Measure the near pairs of every place. Returns whether the kernel could tell all distances; the others are NaN. */
static int measure(const Dips *d, Scan *l, double band) {
    for (long i = 0; i < l->places; i++) {
        double wide = l->target + (i % l->spacing == 0 && band > l->farthest ? band : l->farthest);
        l->reach[i] = wide > 0 ? wide : 0;
    }
    d->curve_at(d->curve, l->s, l->places, d->spacing, l->q);
    l->entries = l->near(d->world, l->q, l->places, l->reach, l->room, l->where, l->distance);
    int known = 1;
    for (long k = 0; k < l->entries && l->entries <= l->room; k++) known &= !isnan(l->distance[k]);
    return known;
}

/* Keep the pairs that are nearer than the reach of their place, ordered, with rounded distances. */
static void tidy(const Dips *d, Scan *l) {
    long kept = 0;
    for (long k = 0; k < l->entries; k++) {
        if (l->distance[k] >= l->reach[l->where[k] / l->pairs]) continue;
        l->where[kept] = l->where[k], l->distance[kept++] = rint(l->distance[k] / d->grid) * d->grid;
    }
    l->entries = kept;
    for (long begin = 0, end; begin < kept; begin = end) {
        long row = l->where[begin] / l->pairs;
        for (end = begin; end < kept && l->where[end] / l->pairs == row; end++) {}
        order_pairs(l, begin, end);
    }
}

/* The distance of the entry `wanted` (row times pairs plus pair), at most `most`; `most` as well if there is none from `start` on
   and before `end`. `start` moves to it. */
static double beside(const Scan *l, long *start, long end, long wanted, double most) {
    while (*start < end && l->where[*start] < wanted) ++*start;
    return *start < end && l->where[*start] == wanted ? fmin(l->distance[*start], most) : most;
}

/* Measure the distances of a bracket that are NaN. Returns whether the kernel could tell them. */
static int complete(const Dips *d, Bracket *b, const long *bodies) {
    double guess[GUESS] = {0};
    if (isnan(b->least)) b->least = distance_at(d, b->middle, bodies, b->leaf, guess);
    if (isnan(b->left)) b->left = distance_at(d, b->low, bodies, b->leaf, guess);
    if (isnan(b->right)) b->right = distance_at(d, b->high, bodies, b->leaf, guess);
    return !isnan(b->least) && !isnan(b->left) && !isnan(b->right);
}

static int lower(const void *one, const void *two) {
    const Bracket *a = one, *b = two;
    if (a->least != b->least) return a->least < b->least ? -1 : 1;
    if (a->middle != b->middle) return a->middle < b->middle ? -1 : 1;
    return a->pair < b->pair ? -1 : 1;
}

/* Brackets around the dips that may be near the target, and around the known places. */
static void place_brackets(Scan *l) {
    double most = l->target + l->farthest, step = 1.0 / (double)(l->places - 1);
    long found = 0, before = 0, after = 0;
    for (long k = 0; k < l->entries; k++) {
        long row = l->where[k] / l->pairs, last = l->places - 1;
        double here = fmin(l->distance[k], most), left = INFINITY, right = INFINITY, higher = -INFINITY;
        if (row > 0) higher = left = beside(l, &before, k, l->where[k] - l->pairs, most);
        if (row < last) right = beside(l, &after, l->entries, l->where[k] + l->pairs, most), higher = fmax(higher, right);
        /* a dip between places is rarely further below its middle than the higher side is above it */
        if (!(left >= here && right > here && here - (higher - here) < l->target + l->deep)) continue;
        /* what is cut off is measured; at an end of the curve the bracket ends at the dip itself */
        Bracket new = {.low = l->s[row > 0 ? row - 1 : 0], .middle = l->s[row], .high = l->s[row < last ? row + 1 : last],
                       .left = row == 0 ? here : left < most ? left : NAN, .least = here,
                       .right = row == last ? here : right < most ? right : NAN, .next = NAN, .pair = l->where[k] % l->pairs, .leaf = -1};
        l->bracket[found++] = new;
    }
    if (found > l->most_dips) {
        qsort(l->bracket, (size_t)found, sizeof *l->bracket, lower);
        found = l->most_dips;
    }
    for (long k = 0; k < l->known; k++) {
        double at = l->known_s[k];
        Bracket new = {.low = fmax(at - step, 0.0), .middle = at, .high = fmin(at + step, 1.0), .left = NAN, .least = NAN,
                       .right = NAN, .next = NAN, .pair = l->known_pair[k], .leaf = -1};
        l->bracket[found++] = new;
    }
    for (long k = 0; k < found; k++)
        for (int i = 0; i < 2; i++) l->bracket_bodies[2 * k + i] = l->bodies[2 * l->bracket[k].pair + i];
    l->dips = found;
}

/* At a place near which a surface is, add the bottoms of all its leaves there that are not known yet, those in out from `first` on: at the
   next configurations one of them may be the nearest, and between two places of the grid another one may pass. A place that is a
   bottom itself, the last one, gets its leaf. Returns the number of all. */
static long bottoms_beside(const Dips *d, const Scan *l, const Found *at, const long *bodies, Found *out, long first, long all) {
    long leaf[l->most_leaves];
    double q[d->n], distance[l->most_leaves], wide = 2.0 / (double)(l->places - 1), reach = fmax(at->distance, l->target) + l->farther;
    d->curve_at(d->curve, &at->s, 1, d->spacing, q);
    long count = l->leaves(d->world, q, bodies, reach, l->most_leaves, leaf, distance);
    if (count == 0 || !(fabs(distance[0] - at->distance) < 2 * d->grid)) return all;    /* inside a solid distances differ */
    if (at->is_bottom) out[all - 1].leaf = leaf[0];
    for (long k = 0; k < count; k++) {
        Bracket b = {.low = fmax(at->s - wide, 0.0), .middle = at->s, .high = fmin(at->s + wide, 1.0), .left = NAN, .least = NAN,
                     .right = NAN, .next = NAN, .pair = at->pair, .leaf = leaf[k]};
        int known = 0;
        for (long i = first; i < all; i++) known |= out[i].pair == b.pair && out[i].leaf == b.leaf && fabs(out[i].s - b.middle) < wide;
        if (known || !complete(d, &b, bodies) || b.left < b.least || b.right < b.least || find_bottoms(d, bodies, 1, &b)) continue;
        Found other = {b.least, b.middle, b.pair, b.leaf, 1};
        out[all++] = other;
    }
    return all;
}

/* Where pairs are near along the curve of `dips`: places of the grid nearer than the target plus `close`, every `spacing`-th nearer than
   the target plus `band`, and the bottoms of dips, of several leaves of a surface, ordered. out: (room + (2 room +
   known) (1 + most_leaves)).
   Returns their number; MORE_ROOM where there is
   no room; ASKING where the kernel cannot tell a distance. Then the caller puts it in place of NaN in `distance` (stage 1), or in
   `left`, `least` and `right` of a bracket or, where `next` is a place, into `found` (stage 2), and calls again. */
long manipplan_near_pairs(const Dips *d, Scan *l, double band, Found *out) {
    long all = 0, asking = 0, bottoms;
    if (l->stage == 0) {
        int known = measure(d, l, band);
        if (l->entries > l->room) return MORE_ROOM;
        l->stage = 1;
        if (!known) return ASKING;
    }
    if (l->stage == 1) {
        tidy(d, l), place_brackets(l);
        l->stage = 2;
        for (long k = 0; k < l->dips; k++) asking += !complete(d, l->bracket + k, l->bracket_bodies + 2 * k);
        if (asking) return ASKING;
    }
    if (find_bottoms(d, l->bracket_bodies, l->dips, l->bracket)) return ASKING;
    for (long k = 0; k < l->entries; k++) {
        long row = l->where[k] / l->pairs;
        int is_close = l->distance[k] < l->target + l->close;
        if (!is_close && !(row % l->spacing == 0 && l->distance[k] < l->target + band)) continue;
        Found near = {l->distance[k], l->s[row], l->where[k] % l->pairs, -1, 0};
        out[all++] = near;
    }
    bottoms = all;
    for (long k = 0; k < l->dips; k++) {
        Found bottom = {l->bracket[k].least, l->bracket[k].middle, l->bracket[k].pair, -1, 1};
        out[all++] = bottom;
        if (bottom.distance < l->target + l->deep) all = bottoms_beside(d, l, &bottom, l->bracket_bodies + 2 * k, out, bottoms, all);
    }
    for (long k = 0; k < bottoms; k++)
        if (out[k].distance < l->target + l->deep) all = bottoms_beside(d, l, out + k, l->bodies + 2 * out[k].pair, out, bottoms, all);
    qsort(out, (size_t)all, sizeof *out, order);
    return all;
}
