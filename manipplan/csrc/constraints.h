/* Constraints of a search: rows c(q) >= 0, and steps that lead to where they hold. All arrays belong to the caller. */

#include "batch.h"

enum { POSE = 12, PROJECTIONS = 40 };
static const double MOST_STEP = 0.5; /* longest step of a projection [rad or m] */

typedef struct {
    long n;                 /* number of joints */
    long rows;              /* number of rows */
    long of_tool;           /* those that are linear in the tool's pose; they come first */
    const double *weights;  /* (of_tool, POSE + 1) weights of position and columns of the rotation, and what is added */
    Batch tool;             /* pose, and Jacobian (n, 6) */
    Batch own;              /* the other rows, and then their gradients */
    const double *least;    /* (rows) values that configurations keep */
    const double *aim;      /* (rows) larger ones, to which a projection leads */
    double *work;           /* (POSE + 6 n + (rows + 1)(n + 1)) */
} Constraints;

/* The gradient (n) of a row, which `evaluate` has left in `work`. */
static void gradient_of(const Constraints *c, long row, double *out) {
    const double *tool = c->work, *own = tool + POSE + 6 * c->n;
    if (row >= c->of_tool) {
        const double *found = own + (c->rows - c->of_tool) + (row - c->of_tool) * c->n;
        for (long j = 0; j < c->n; j++) out[j] = found[j];
        return;
    }
    const double *w = c->weights + row * (POSE + 1);
    for (long j = 0; j < c->n; j++) {
        const double *p = tool + POSE + 6 * j, *z = p + 3;
        out[j] = w[0] * p[0] + w[1] * p[1] + w[2] * p[2];
        for (int k = 3; k < POSE; k += 3) { /* w · (z x column) */
            const double *r = tool + k, *u = w + k;
            out[j] += u[0] * (z[1] * r[2] - z[2] * r[1]) + u[1] * (z[2] * r[0] - z[0] * r[2]) + u[2] * (z[0] * r[1] - z[1] * r[0]);
        }
    }
}

/* The row at q whose value is least beyond `wanted` (rows); `value` is that. -1: q cannot be evaluated. */
static long worst_row(const Constraints *c, const double *q, const double *wanted, double *value) {
    double *tool = c->work, *own = tool + POSE + 6 * c->n;
    long worst = -1;
    if (c->of_tool && c->tool.run(c->tool.program, q, tool, 1)) return -1;
    if (c->rows > c->of_tool && c->own.run(c->own.program, q, own, 1)) return -1;
    for (long row = 0; row < c->rows; row++) {
        double v;
        if (row < c->of_tool) {
            const double *w = c->weights + row * (POSE + 1);
            v = w[POSE];
            for (int k = 0; k < POSE; k++) v += w[k] * tool[k];
        } else v = own[row - c->of_tool];
        v -= wanted[row];
        if (worst < 0 || !(v >= *value)) worst = row, *value = v;
    }
    return worst;
}

/* Whether q keeps all rows. */
static int keeps(const Constraints *c, const double *q) {
    double value = 0;
    return worst_row(c, q, c->least, &value) >= 0 && value >= 0;
}

/* Move q, where it breaks a row, to where it keeps all, inside low and high (n): by steps that lead the worst row to its aim to
   first order. Returns whether that succeeds. */
static int project(const Constraints *c, const double *low, const double *high, double *q, double *gradient) {
    double value = 0;
    if (keeps(c, q)) return 1;
    for (int k = 0; k < PROJECTIONS; k++) {
        long row = worst_row(c, q, c->aim, &value);
        if (row < 0) return 0;
        if (value >= 0) return 1;
        gradient_of(c, row, gradient);
        double square = 0, longest = 0;
        for (long j = 0; j < c->n; j++) {
            /* a joint at a limit does not move beyond it */
            if ((q[j] <= low[j] && gradient[j] < 0) || (q[j] >= high[j] && gradient[j] > 0)) gradient[j] = 0;
            square += gradient[j] * gradient[j];
        }
        if (!(square > 1e-12)) return 0;
        for (long j = 0; j < c->n; j++) longest = fmax(longest, fabs(gradient[j]) * -value / square);
        double scale = (longest > MOST_STEP ? MOST_STEP / longest : 1) * -value / square;
        for (long j = 0; j < c->n; j++) q[j] = fmin(fmax(q[j] + scale * gradient[j], low[j]), high[j]);
    }
    return keeps(c, q);
}
