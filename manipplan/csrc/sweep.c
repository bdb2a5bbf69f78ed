/* Kernels of the dynamic program: cells, and one step from the candidates of one layer to those of the next. All arrays belong to
   the caller.

   All values are maximised. Candidates are sorted by cell. A value is -INFINITY where a candidate is not reached, `top` is the
   largest value of each cell. Threads share a layer: each works on cells first ... last - 1. */

#include <math.h>
#include <stdint.h>

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

enum { AXES = 3, ADJOINING = 27 };  /* number of hashed joints, and of cells around a cell, including itself */

/* Cells of equal width over three joints; a joint with a single cell is not hashed. */
typedef struct {
    long n;
    const long *joints;   /* (3) joints that are hashed */
    const double *low;    /* (3) lower edge of the first cell */
    const double *per;    /* (3) cells per rad or m */
    const long *count;    /* (3) number of cells */
    const char *wraps;    /* (3) whether the last cell is adjacent to the first */
    const long *order;    /* (n) order in which joints are compared */
    const char *turns;    /* (n) whether the joint is continuous, in that order */
} Grid;

/* The candidates of one layer that take part, sorted by cell. */
typedef struct {
    int32_t *ids;     /* (k) their indices in the layer */
    double *rows;     /* (k, n) configurations with joints in the grid's order */
    double *m;        /* (k) manipulability, limited to the cap */
    int32_t *start;   /* (cells + 1) start of each cell */
    double *reach;    /* (n) upper bound on a step to this layer, exclusive, in the grid's order */
} Cells;

/* Values (k) of the candidates of a layer, and the largest value of each cell. */
typedef struct { double *value, *top; } Values;

/* One step: from a layer with its values to the next one. */
typedef struct {
    const Grid *grid;
    Cells from;
    Values known;
    Cells to;
    Values made;
    int32_t *source;        /* index of each predecessor in the previous layer, -1 where there is none */
    const long *rank;       /* of the previous layer's candidates for `shortest`: a higher one goes first; or null */
    const double *epsilon;  /* (n) for `closest`, in the grid's order */
} Step;

static long cell_of(const Grid *g, const double *q) {
    long cell = 0;
    for (long axis = 0; axis < AXES; axis++) {
        long size = g->count[axis];
        if (size == 1) continue;
        double x = q[g->joints[axis]], place;
        if (g->wraps[axis]) {
            x /= TAU;
            place = (x - floor(x)) * size;
        } else {
            place = (x - g->low[axis]) * g->per[axis];
        }
        /* compared as floats: a very large value would overflow an integer */
        place = place > 0.0 ? place : 0.0;
        place = place < size - 1.0 ? place : size - 1.0;
        cell = cell * size + (long)place;
    }
    return cell;
}

/* Indices of the candidates with m (count) >= threshold; with a share below 1, of about that share of them. `taken` has room for
   count + 1; returns their number. The choice is pseudo-random but reproducible, and a smaller share is a subset of a larger one. */
long manipplan_taking_part(const double *m, long count, double threshold, double share, int32_t *taken) {
    long found = 0;
    if (share >= 1.0) {
        for (long i = 0; i < count; i++) {  /* always written: a branch would be mispredicted too often */
            taken[found] = (int32_t)i;
            found += m[i] >= threshold;
        }
        return found;
    }
    uint64_t below = (uint64_t)(share * 4294967296.0);
    for (uint64_t i = 0; i < (uint64_t)count; i++) {
        uint64_t mixed = (i ^ (i >> 15)) * UINT64_C(0x9E3779B97F4A7C15);
        taken[found] = (int32_t)i;
        found += (m[i] >= threshold) & ((mixed >> 32) < below);
    }
    return found;
}

/* Sort the candidates `taken` (k) of a layer by cell, in time linear in candidates and cells. cell (k): scratch space. */
void manipplan_sort_into_cells(const Grid *g, const double *q, const double *m, const int32_t *taken, long k, double cap,
                               int32_t *cell, const Cells *to) {
    long n = g->n, cells = g->count[0] * g->count[1] * g->count[2];
    for (long c = 0; c <= cells; c++) to->start[c] = 0;
    for (long i = 0; i < k; i++) to->start[cell[i] = (int32_t)cell_of(g, q + n * taken[i])]++;
    for (long c = 0, sum = 0; c <= cells; c++) {
        sum += to->start[c];
        to->start[c] = (int32_t)sum;  /* the end of the cell, which moves to its start below */
    }
    for (long i = k - 1; i >= 0; i--) {
        long place = --to->start[cell[i]];
        const double *from = q + n * taken[i];
        to->ids[place] = taken[i];
        to->m[place] = m[taken[i]] < cap ? m[taken[i]] : cap;
        for (long j = 0; j < n; j++) to->rows[n * place + j] = from[g->order[j]];
    }
}

/* The largest value of each cell, -INFINITY for an empty one. */
void manipplan_largest_of_each(const int32_t *start, long cells, const double *value, double *top) {
    for (long cell = 0; cell < cells; cell++) {
        double largest = -INFINITY;
        for (long b = start[cell]; b < start[cell + 1]; b++) largest = value[b] > largest ? value[b] : largest;
        top[cell] = largest;
    }
}

/* The place along one axis of the k-th of the cells to look at: the cell itself comes first, as its candidates are the most likely
   neighbours; -1 where there is none. */
static long place_beside(const Grid *g, long axis, long place, long k) {
    static const long by[3] = {0, -1, 1};
    long size = g->count[axis], other = place + by[k];
    if (other >= 0 && other < size) return other;
    return g->wraps[axis] ? (other + size) % size : -1;
}

/* The cells around `cell`, including itself, that hold a value above -INFINITY, in descending order of their largest value. */
static long cells_around(const Grid *g, long cell, const double *top, long near[ADJOINING]) {
    long size1 = g->count[1], size2 = g->count[2];
    long c0 = cell / (size2 * size1), c1 = cell / size2 % size1, c2 = cell % size2, found = 0;
    long some0 = g->count[0] > 1 ? 3 : 1, some1 = size1 > 1 ? 3 : 1, some2 = size2 > 1 ? 3 : 1;
    for (long k0 = 0; k0 < some0; k0++) {
        long a = place_beside(g, 0, c0, k0);
        for (long k1 = 0; a >= 0 && k1 < some1; k1++) {
            long b = place_beside(g, 1, c1, k1);
            for (long k2 = 0; b >= 0 && k2 < some2; k2++) {
                long c = place_beside(g, 2, c2, k2);
                if (c < 0) continue;
                long other = (a * size1 + b) * size2 + c, place = found;
                if (!(top[other] > -INFINITY)) continue;
                for (; place > 0 && top[near[place - 1]] < top[other]; place--) near[place] = near[place - 1];
                near[place] = other;
                found++;
            }
        }
    }
    return found;
}

/* W(b) = min(m(b), max over neighbours a of W(a)) */
void manipplan_widest(const Step *s, long first, long last) {
    const Grid *g = s->grid;
    const double *previous = s->known.value, *top = s->known.top;
    long near[ADJOINING], n = g->n;
    for (long cell = first; cell < last; cell++) {
        double highest = -INFINITY;
        long begin = s->to.start[cell], end = s->to.start[cell + 1];
        long adjoining = begin < end ? cells_around(g, cell, top, near) : 0;
        double limit = adjoining ? top[near[0]] : -INFINITY;
        for (long b = begin; b < end; b++) {
            double m = s->to.m[b], enough = m < limit ? m : limit, best = -INFINITY;
            const double *row = s->to.rows + n * b;
            long where = -1;
            for (long k = 0; k < adjoining; k++) {
                if (top[near[k]] <= best || (where >= 0 && best >= enough)) break;
                for (long a = s->from.start[near[k]]; a < s->from.start[near[k] + 1]; a++)
                    if (previous[a] > best && is_near(s->from.rows + n * a, row, n, s->to.reach, g->turns)) {
                        best = previous[a], where = a;
                        if (best >= enough) break;
                    }
            }
            double value = m < best ? m : best;
            s->made.value[b] = value, s->source[b] = (int32_t)where;
            highest = value > highest ? value : highest;
        }
        s->made.top[cell] = highest;
    }
}

/* V(b) = max over neighbours a of V(a) - ‖step‖: the negative minimum length; with ranks, a higher rank (a) goes first. */
void manipplan_shortest(const Step *s, long first, long last) {
    const Grid *g = s->grid;
    const double *previous = s->known.value, *top = s->known.top;
    const long *rank = s->rank;
    long near[ADJOINING], n = g->n;
    for (long cell = first; cell < last; cell++) {
        double highest = -INFINITY;
        long begin = s->to.start[cell], end = s->to.start[cell + 1];
        long adjoining = begin < end ? cells_around(g, cell, top, near) : 0;
        for (long b = begin; b < end; b++) {
            const double *row = s->to.rows + n * b;
            double best = -INFINITY;
            long where = -1, best_rank = -1;
            for (long k = 0; k < adjoining; k++) {
                if (!rank && top[near[k]] <= best) break;
                for (long a = s->from.start[near[k]]; a < s->from.start[near[k] + 1]; a++) {
                    const double *old = s->from.rows + n * a;
                    if (previous[a] == -INFINITY) continue;
                    if (rank ? rank[a] < best_rank || (rank[a] == best_rank && previous[a] <= best) : previous[a] <= best) continue;
                    if (!is_near(old, row, n, s->to.reach, g->turns)) continue;
                    double square = 0.0;
                    for (long j = 0; j < n; j++) {
                        double d = step(old[j], row[j], g->turns[j]);
                        square += d * d;
                    }
                    double length = previous[a] - sqrt(square);
                    if (rank && rank[a] > best_rank) best = length, where = a, best_rank = rank[a];
                    else if (length > best) best = length, where = a;
                }
            }
            s->made.value[b] = best, s->source[b] = (int32_t)where;
            highest = best > highest ? best : highest;
        }
        s->made.top[cell] = highest;
    }
}

/* V(b) = max over neighbours a of min(V(a), -max_j |step_j| / ε_j): the negative smallest factor of ε that connects. */
void manipplan_closest(const Step *s, long first, long last) {
    const Grid *g = s->grid;
    const double *previous = s->known.value, *top = s->known.top;
    long near[ADJOINING], n = g->n;
    for (long cell = first; cell < last; cell++) {
        double highest = -INFINITY;
        long begin = s->to.start[cell], end = s->to.start[cell + 1];
        long adjoining = begin < end ? cells_around(g, cell, top, near) : 0;
        double limit = adjoining ? top[near[0]] : -INFINITY;
        for (long b = begin; b < end; b++) {
            const double *row = s->to.rows + n * b;
            double best = -INFINITY;
            long where = -1;
            for (long k = 0; k < adjoining; k++) {
                if (top[near[k]] <= best || best == limit) break;
                for (long a = s->from.start[near[k]]; a < s->from.start[near[k] + 1]; a++) {
                    const double *old = s->from.rows + n * a;
                    if (previous[a] <= best || !is_near(old, row, n, s->to.reach, g->turns)) continue;
                    double ratio = 0.0;
                    for (long j = 0; j < n; j++) {
                        double share = fabs(step(old[j], row[j], g->turns[j])) / s->epsilon[j];
                        ratio = share > ratio ? share : ratio;
                    }
                    double value = previous[a] < -ratio ? previous[a] : -ratio;
                    if (value > best) best = value, where = a;
                }
            }
            s->made.value[b] = best, s->source[b] = (int32_t)where;
            highest = best > highest ? best : highest;
        }
        s->made.top[cell] = highest;
    }
}
