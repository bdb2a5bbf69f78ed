/* The bottoms of dips: where pairs of bodies are nearest inside brackets along a curve. All arrays belong to the caller.

   Two steps go to the minimum of a parabola, every third halves the longer side of the bracket. */

#include <math.h>

typedef struct {
    double low, middle, high;   /* places s on the curve */
    double left, least, right;  /* the distances there [m] */
    double next, found;         /* the place of which the distance is asked, and the answer; NaN: nothing is asked, or known */
    long steps;                 /* number of steps taken */
} Bracket;

typedef struct {
    const void *curve;
    long (*curve_at)(const void *curve, const double *s, long m, double spacing, double *out);  /* manipplan_curve */
    double spacing;             /* of the grid of configurations [rad or m] */
    const void *world;
    void (*distance)(const void *world, const double *q, long m, const long *bodies, const double *reach, double *out,
                     long *leaf);                                                               /* manipplan_pairs */
    double grid;                /* spacing of the grid of distances [m] */
    double enough;              /* width at which a bracket is narrow enough */
    long most_steps;
} Dips;

enum { MOST_JOINTS = 64 };  /* the caller sees to it that there are no more */

/* The distance at s, rounded to the grid; NaN where the kernel cannot tell. */
static double distance_at(const Dips *d, double s, const long *bodies) {
    double q[MOST_JOINTS], reach = INFINITY, out;
    long leaf;
    if (d->curve_at(d->curve, &s, 1, d->spacing, q)) return NAN;
    d->distance(d->world, q, 1, bodies, &reach, &out, &leaf);
    return rint(out / d->grid) * d->grid;
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
long manipplan_bottoms(const Dips *d, const long *bodies, long m, Bracket *bracket) {
    long waiting = 0;
    for (long k = 0; k < m; k++) {
        Bracket *b = bracket + k;
        if (!isnan(b->next)) {
            narrow(b, b->next, b->found);
            b->next = NAN;
        }
        while (!is_done(d, b)) {
            double place = next_place(d, b), value = distance_at(d, place, bodies + 2 * k);
            if (isnan(value)) {
                b->next = place, waiting++;
                break;
            }
            narrow(b, place, value);
        }
    }
    return waiting;
}
