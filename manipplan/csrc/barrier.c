/* The barrier method for limited jerk: Newton steps from a motion within all limits to the fastest one nearby.

   `jerk.py` explains the unknowns c, their rows and the limits. All arrays of a Motion belong to the
   caller. Eight grid points are treated at a time, with +, -, *, / and roots alone and without contraction: the same numbers on
   every processor. Rows of one kind are stored by joint. Arrays are filled up to `stride`, a multiple of eight above the number
   of grid points, with eight more numbers at the end; places there add nothing to a sum. */

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef double Eight __attribute__((vector_size(64), aligned(8), may_alias));
typedef int64_t Bits __attribute__((vector_size(64), aligned(8), may_alias));   /* eight numbers bit by bit; a truth is -1 */

/* Eight numbers of an array, from place i. */
#define AT(array, i) (*(Eight *)((array) + (i)))
#define OF(array, i) (*(const Eight *)((array) + (i)))
#define CHOICE(truth, x, y) ((Eight)(((truth) & (Bits)(x)) | (~(truth) & (Bits)(y))))

typedef struct {
    long points, rows, limited, stride; /* k inner grid points, r demand rows at each, m joints with a jerk limit */
    const double *h;                /* (k - 1) distances between grid points */
    const double *w, *d;            /* (k): a = w c + (1 - w) c', b = d (c' - c) with neighbours c and c' */
    const double *fastest, *most_c; /* (k) the largest a, and (k + 1) the largest c; inf: no limit, also beyond the end */
    const double *left, *right, *constant;  /* (r, k): demand = left c + right c' + constant, in [-1, 1] */
    const double *before, *after;   /* (m, k): acceleration = before c + after c' */
    const double *jerk;             /* (m, k - 1): its largest change per time on an interval */
    double fixed[2], tied[2];       /* the outermost c are tied times their neighbour, plus fixed; fixed 0: a stop */
    double outer[2];                /* distance of a stop from the inner grid point beside it */
    double most_b[2];               /* largest b after the beginning and before the end; inf: no limit */
} Motion;

typedef struct {
    double count;                   /* number of slacks */
    double begin;                   /* first weight of time, as a multiple of count / time */
    double heavier, gap;            /* factor between weights; share of the time by which the last motion may be too slow */
    double rough, centred;          /* a round ends when a step gains less than `rough`; the last, less than `centred` */
    double sufficient;              /* share of the predicted gain that a step must reach */
    long steps;                     /* maximum number of Newton steps per round */
} Descent;

/* What is known at one z: c (k + 1), roots of a (k), time of each interval and its derivative by u = √a + √a' (k - 1), slacks.
   Slacks without a limit, and beyond the end, are inf. */
typedef struct {
    double *c, *root, *step, *first, *fast, *between, *above, *below, *rise, *fall;
    double ends[2], time, logs;     /* slacks of b at the ends, duration, and the sum of the logarithms of all slacks */
} State;

/* Gradient (k + 1) and Hessian of five diagonals as in BandedModel, and the factors L and 1 / D of the scaled one. */
typedef struct {
    double *g, *h0, *h1, *h2, *scale, *l1, *l2, *inverse;
} Model;

/* 1 / 35, 1 / 33, ..., 1 */
static const double ODD[] = {1.0 / 35, 1.0 / 33, 1.0 / 31, 1.0 / 29, 1.0 / 27, 1.0 / 25, 1.0 / 23, 1.0 / 21, 1.0 / 19,
                             1.0 / 17, 1.0 / 15, 1.0 / 13, 1.0 / 11, 1.0 / 9,  1.0 / 7,  1.0 / 5,  1.0 / 3,  1.0};
static const Bits LANES = {0, 1, 2, 3, 4, 5, 6, 7};

/* A product of slacks as mantissa in [1, 2) and power of two, and where it cannot be one: a factor is not positive, or it is too
   far from 1 for a power of two. */
typedef struct {
    Eight mantissa;
    Bits power, wrong;
} Product;

static inline void multiply(Product *all, const Eight *x, const Eight *y) {
    Eight value = all->mantissa * (*x * *y);
    all->wrong |= ~((*x > 0) & (*y > 0) & (value > 0x1p-1000) & (value < 0x1p1000));
    Bits bits = (Bits)value;
    all->power += (bits >> 52) - 1023;
    all->mantissa = (Eight)((bits & 0xfffffffffffff) | 0x3ff0000000000000);
}

static int any(const Bits *truth) {
    int64_t all = 0;
    for (int i = 0; i < 8; i++) all |= (*truth)[i];
    return all != 0;
}

static double sum(const Eight *x) {
    return (((*x)[0] + (*x)[1]) + ((*x)[2] + (*x)[3])) + (((*x)[4] + (*x)[5]) + ((*x)[6] + (*x)[7]));
}

/* Slacks, time and logarithms at z (k - 1). Returns 0 where a limit is exceeded. */
static int evaluate(const Motion *p, const double *z, State *at) {
    long k = p->points, stride = p->stride;
    double *c = at->c;
    memcpy(c + 1, z, (size_t)(k - 1) * sizeof *c);
    c[0] = p->tied[0] * z[0] + p->fixed[0], c[k] = p->tied[1] * z[k - 2] + p->fixed[1];
    for (long i = 0; i <= k; i++)
        if (!(c[i] > 0)) return 0;
    for (long i = k + 1; i < stride + 8; i++) c[i] = 1;
    for (long i = 0; i < stride; i++) at->root[i] = sqrt(p->w[i] * c[i] + (1 - p->w[i]) * c[i + 1]);
    at->ends[0] = p->most_b[0] - p->d[0] * (c[1] - c[0]), at->ends[1] = p->most_b[1] + p->d[k - 1] * (c[k] - c[k - 1]);
    if (!(at->ends[0] > 0) || !(at->ends[1] > 0)) return 0;
    const Eight one = {1, 1, 1, 1, 1, 1, 1, 1}, infinite = one * INFINITY;
    Eight time = one * 0, logs = one * 0, ends = one;
    for (int side = 0; side < 2; side++)
        if (at->ends[side] < INFINITY) ends[side] = at->ends[side];
    Bits powers = LANES * 0;
    for (long i = 0; i < stride; i += 8) {
        Product all = {one, LANES * 0, LANES * 0};
        Bits interval = LANES + i < k - 1;
        Eight here = OF(c, i), next = OF(c, i + 1), beyond = OF(c, i + 2);
        Eight fast = OF(p->fastest, i) - (OF(p->w, i) * here + (1 - OF(p->w, i)) * next), between = OF(p->most_c, i) - here;
        AT(at->fast, i) = fast, AT(at->between, i) = between;
        fast = CHOICE(fast == infinite, one, fast), between = CHOICE(between == infinite, one, between);
        multiply(&all, &fast, &between), multiply(&all, &here, i ? &one : &ends);
        for (long j = 0; j < p->rows; j++) {
            long row = j * stride + i;
            Eight demand = OF(p->left, row) * here + OF(p->right, row) * next + OF(p->constant, row);
            Eight above = 1 - demand, below = 1 + demand;
            AT(at->above, row) = above, AT(at->below, row) = below;
            multiply(&all, &above, &below);
        }
        if (any(&all.wrong)) return 0;
        Eight u = OF(at->root, i) + OF(at->root, i + 1), step = 2 * OF(p->h, i) / u;
        AT(at->step, i) = step, AT(at->first, i) = CHOICE(interval, -step / u, one * 0);
        time += CHOICE(interval, step, one * 0);
        for (long j = 0; j < p->limited; j++) {
            long row = j * stride + i;
            Eight last = OF(p->before, row + 1) * next + OF(p->after, row + 1) * beyond;
            Eight change = last - (OF(p->before, row) * here + OF(p->after, row) * next), most = OF(p->jerk, row) * step;
            Eight rise = CHOICE(interval, most - change, one), fall = CHOICE(interval, most + change, one);
            AT(at->rise, row) = CHOICE(interval, rise, infinite), AT(at->fall, row) = CHOICE(interval, fall, infinite);
            multiply(&all, &rise, &fall);
        }
        if (any(&all.wrong)) return 0;
        /* log x = 2 artanh((x - 1) / (x + 1)) */
        Eight s = (all.mantissa - 1) / (all.mantissa + 1), square = s * s, series = one * 0;
        for (int power = 0; power < 18; power++) series = series * square + ODD[power];
        logs += s * series, powers += all.power;
    }
    int64_t power = 0;
    for (int i = 0; i < 8; i++) power += powers[i];
    at->logs = 0.693147180559945309417 * (double)power + 2 * sum(&logs), at->time = sum(&time);
    for (int side = 0; side < 2; side++)
        if (p->fixed[side] == 0) at->time += 3 * p->outer[side] / at->root[side ? k - 1 : 0];
    return 1;
}

/* Gradient and Hessian of weight · time - Σ log of the slacks in all c, with linearised jerk limits. */
static void differentiate(const Motion *p, const State *at, double weight, Model *model) {
    long k = p->points, stride = p->stride;
    double *g = model->g, *h0 = model->h0, *h1 = model->h1, *h2 = model->h2;
    for (double *const *each = (double *const[]){g, h0, h1, h2, NULL}; *each; each++)
        memset(*each, 0, (size_t)(stride + 8) * sizeof **each);
    for (long i = 0; i < stride; i += 8) {
        /* rows of one place: c itself, and its limit */
        Eight low = 1 / OF(at->c, i), high = 1 / OF(at->between, i);
        Eight g0 = high - low, h00 = low * low + high * high;
        /* of two neighbours: a, with ∂²√a/∂a² = -1 / (4 a^(3/2)) at both ends of a step; then demands */
        Eight root = OF(at->root, i), x = OF(p->w, i), y = 1 - x, slope = 1 / OF(at->fast, i);
        Eight bend = slope * slope - weight * (OF(at->first, i - 1) + OF(at->first, i)) / (4 * root * root * root);
        Eight g1 = slope * y, h11 = bend * y * y, h01 = bend * x * y;
        g0 += slope * x, h00 += bend * x * x;
        for (long j = 0; j < p->rows; j++) {
            long row = j * stride + i;
            Eight up = 1 / OF(at->above, row), down = 1 / OF(at->below, row), left = OF(p->left, row), right = OF(p->right, row);
            slope = up - down, bend = up * up + down * down;
            g0 += slope * left, g1 += slope * right;
            h00 += bend * left * left, h01 += bend * left * right, h11 += bend * right * right;
        }
        /* of three: the steps, with the derivatives x, y, z of u; then the jerk limits */
        Eight next = OF(at->root, i + 1), first = OF(at->first, i), far = OF(p->w, i + 1);
        x = x / (2 * root), y = y / (2 * root) + far / (2 * next);
        Eight z = (1 - far) / (2 * next);
        slope = weight * first, bend = -2 * slope / (root + next);
        g0 += slope * x, g1 += slope * y, h00 += bend * x * x, h01 += bend * x * y, h11 += bend * y * y;
        Eight g2 = slope * z, h02 = bend * x * z, h12 = bend * y * z, h22 = bend * z * z;
        x *= first, y *= first, z *= first;
        for (long j = 0; j < p->limited; j++) {
            long row = j * stride + i;
            Eight most = OF(p->jerk, row), up = 1 / OF(at->rise, row), down = 1 / OF(at->fall, row);
            Eight x_change = -OF(p->before, row), y_change = OF(p->before, row + 1) - OF(p->after, row);
            Eight z_change = OF(p->after, row + 1);
            Eight x_up = (most * x - x_change) * up, x_down = (most * x + x_change) * down;
            Eight y_up = (most * y - y_change) * up, y_down = (most * y + y_change) * down;
            Eight z_up = (most * z - z_change) * up, z_down = (most * z + z_change) * down;
            g0 -= x_up + x_down, g1 -= y_up + y_down, g2 -= z_up + z_down;
            h00 += x_up * x_up + x_down * x_down, h01 += x_up * y_up + x_down * y_down;
            h11 += y_up * y_up + y_down * y_down, h12 += y_up * z_up + y_down * z_down;
            h22 += z_up * z_up + z_down * z_down, h02 += x_up * z_up + x_down * z_down;
        }
        AT(g, i) += g0, AT(h0, i) += h00, AT(h1, i) += h01, AT(h2, i) += h02;
        AT(g, i + 1) += g1, AT(h0, i + 1) += h11, AT(h1, i + 1) += h12;
        AT(g, i + 2) += g2, AT(h0, i + 2) += h22;
    }
    for (int side = 0; side < 2; side++) {
        /* 3 l / √a at stops */
        long i = side ? k - 1 : 0;
        if (p->fixed[side] == 0) {
            double cube = at->root[i] * at->root[i] * at->root[i], x = p->w[i], y = 1 - x;
            double slope = -weight * 1.5 * p->outer[side] / cube;
            double bend = weight * 2.25 * p->outer[side] / (cube * at->root[i] * at->root[i]);
            g[i] += slope * x, g[i + 1] += slope * y;
            h0[i] += bend * x * x, h1[i] += bend * x * y, h0[i + 1] += bend * y * y;
        }
        /* b: slopes of the slacks are d and -d after the beginning, -d and d before the end */
        double each = p->d[i] / at->ends[side], square = each * each;
        g[i] += side ? each : -each, g[i + 1] += side ? -each : each;
        h0[i] += square, h0[i + 1] += square, h1[i] -= square;
    }
    /* the outermost unknowns change `tied` times as much as their neighbours */
    double one = p->tied[0], two = p->tied[1];
    g[1] += one * g[0], h0[1] += 2 * one * h1[0] + one * one * h0[0], h1[1] += one * h2[0];
    g[k - 1] += two * g[k], h0[k - 1] += 2 * two * h1[k - 1] + two * two * h0[k], h1[k - 2] += two * h2[k - 2];
}

/* The step (k - 1) to the minimum of the model, by L D L'. Returns twice the predicted decrease; NaN: not positive definite. */
static double newton_step(long count, const Model *model, double *step) {
    const double *g = model->g + 1, *h0 = model->h0 + 1, *h1 = model->h1 + 1, *h2 = model->h2 + 1;
    double *scale = model->scale, *l1 = model->l1, *l2 = model->l2, *inverse = model->inverse;
    for (long i = 0; i < count; i++) scale[i] = 1 / sqrt(h0[i]);
    for (long i = 0; i < count - 1; i++) l1[i + 1] = h1[i] * (scale[i] * scale[i + 1]);
    for (long i = 0; i < count - 2; i++) l2[i + 2] = h2[i] * (scale[i] * scale[i + 2]);
    for (long i = 0; i < count; i++) {
        /* a unit diagonal, kept positive definite */
        double pivot = 1 + 1e-14, value = scale[i] * g[i];
        if (i > 1) {
            double far = l2[i];
            l2[i] = far * inverse[i - 2], pivot -= far * l2[i], value -= l2[i] * step[i - 2];
            l1[i] -= far * l1[i - 1];
        }
        if (i > 0) {
            double near = l1[i];
            l1[i] = near * inverse[i - 1], pivot -= near * l1[i], value -= l1[i] * step[i - 1];
        }
        if (!(pivot > 0)) return NAN;
        inverse[i] = 1 / pivot, step[i] = value;
    }
    double decrement = 0;
    for (long i = count - 1; i >= 0; i--) {
        double value = step[i] * inverse[i];
        if (i + 1 < count) value -= l1[i + 1] * step[i + 1];
        if (i + 2 < count) value -= l2[i + 2] * step[i + 2];
        step[i] = value;
    }
    for (long i = 0; i < count; i++) step[i] *= -scale[i], decrement -= g[i] * step[i];
    return decrement;
}

/* Minimise weight · time - Σ log of the slacks from z inside the limits, whose state is `at`. Returns the number of steps. */
static long centre(const Motion *p, const Descent *how, double weight, double centred, double *z, State *at, Model *model,
                   double *step, double *next) {
    long count = p->points - 1, steps = 0;
    double value = weight * at->time - at->logs;
    for (; steps < how->steps; steps++) {
        differentiate(p, at, weight, model);
        double decrement = newton_step(count, model, step), size = 1, after;
        if (!isfinite(decrement) || decrement < centred) break;
        for (;; size /= 2) {
            if (size <= 1e-9) {
                evaluate(p, z, at);
                return steps;
            }
            for (long i = 0; i < count; i++) next[i] = z[i] + size * step[i];
            if (!evaluate(p, next, at)) continue;
            after = weight * at->time - at->logs;
            if (after <= value - how->sufficient * size * decrement) break;
        }
        memcpy(z, next, (size_t)count * sizeof *z);
        double gained = value - after;
        value = after;
        if (gained < centred) {
            steps++;
            break;
        }
    }
    return steps;
}

/* Room for a state, a model and two steps. NULL where there is none. */
static double *room(const Motion *p, State *at, Model *model, double **step, double **next) {
    double **places[] = {&at->c, &at->root, &at->step, &at->first, &at->fast, &at->between, &model->g, &model->h0, &model->h1,
                         &model->h2, &model->scale, &model->l1, &model->l2, &model->inverse, step, next};
    double **rows[] = {&at->above, &at->below, &at->rise, &at->fall};
    long each = p->stride + 16, count = sizeof places / sizeof *places;
    double *all = calloc((size_t)(count * each + 2 * (p->rows + p->limited) * p->stride), sizeof *all), *from = all;
    if (!all) return NULL;
    for (long i = 0; i < count; i++, from += each) *places[i] = from + 8;   /* a place before the first one is read */
    for (int i = 0; i < 4; i++) *rows[i] = from, from += (i < 2 ? p->rows : p->limited) * p->stride;
    return all;
}

/* Move z (k - 1), which is inside the limits, to the fastest motion nearby. Returns the number of Newton steps; -1 where z is not
   inside, -2 without memory. */
long manipplan_descend(const Motion *p, const Descent *how, double *z) {
    State at;
    Model model;
    double *step, *next, *all = room(p, &at, &model, &step, &next);
    if (!all) return -2;
    long steps = -1;
    if (evaluate(p, z, &at)) {
        steps = 0;
        for (double weight = how->begin * how->count / at.time;; weight *= how->heavier) {
            int last = how->count / weight < how->gap * at.time;
            steps += centre(p, how, weight, last ? how->centred : how->rough, z, &at, &model, step, next);
            if (last && how->count / weight < how->gap * at.time) break;
        }
    }
    free(all);
    return steps;
}

/* Multiply z (k - 1) by `factor` until it is inside the limits, at most `most` times. Returns how often; -1 where it never is, -2
   without memory. */
long manipplan_enter(const Motion *p, double *z, double factor, long most) {
    State at;
    Model model;
    double *step, *next, *all = room(p, &at, &model, &step, &next);
    if (!all) return -2;
    long times = 0;
    while (times < most && !evaluate(p, z, &at)) {
        for (long i = 0; i < p->points - 1; i++) z[i] *= factor;
        times++;
    }
    free(all);
    return times < most ? times : -1;
}
