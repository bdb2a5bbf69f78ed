/* Newton steps on the arm as described: they refine closed-form solutions, and find solutions where there is no closed form. */

#pragma once

#include "subproblems.h"

/* Damping of the first step of a search, as a factor of the squared error. */
#define DAMPING 1e-2

/* Minimum damping relative to the trace of J Jᵀ: less is lost in rounding and does not keep the matrix regular. */
#define LEAST 1e-14

/* An arm as a product of exponentials. */
typedef struct {
    long n;
    const double *axes, *points;  /* (links, 3) where all joints are at 0 */
    const char *slides;           /* (links) whether each joint is prismatic */
    const double *home;           /* (4, 4) the tool's pose there */
    const char *moves;            /* (n) the joints that may move */
    long links;                   /* number of joints that carry the tool */
    const long *leader;           /* (links) each is at ratio q[leader] + offset; 0: at q, and links = n */
    const double *ratio, *offset;
} Screws;

/* Where an arm is: the pose of its tool, the columns of its Jacobian (n), LOCAL_WORLD_ALIGNED, those of its joints (links), which
   are the same without a leader, and what is missing to a target: displacement and rotation vector. */
typedef struct { Motion pose; double (*jacobian)[6], (*own)[6]; double error[6]; } State;

/* With the columns at the beginning of `work`: (7 n), and with a leader (6 links) after these. */
static State state_in(const Screws *arm, double *work) {
    return (State){.jacobian = (double (*)[6])work, .own = (double (*)[6])(arm->leader ? work + 7 * arm->n : work)};
}

static void forward(const Screws *arm, const double *q, State *at) {
    Motion *pose = &at->pose;
    Vector tip = {arm->home[3], arm->home[7], arm->home[11]};
    for (long j = 0; j < 3; j++) set_column(*pose, j, (Vector){arm->home[j], arm->home[4 + j], arm->home[8 + j]});
    for (long k = arm->links - 1; k >= 0; k--) {
        Vector h = row(arm->axes, k), p = row(arm->points, k);
        double *own = at->own[k], position = arm->leader ? arm->ratio[k] * q[arm->leader[k]] + arm->offset[k] : q[k];
        /* the columns of later joints, the tip and the tool rotate with this joint */
        if (arm->slides[k]) {
            tip = add(tip, scaled(position, h));
            set_row(own, 0, h), set_row(own, 1, (Vector){0, 0, 0});
            continue;
        }
        Turn turn = turn_by(position);
        tip = turned_about(h, p, turn, tip);
        for (long j = 0; j < 3; j++) set_column(*pose, j, turned(h, turn, column(*pose, j)));
        for (long j = k + 1; j < arm->links; j++)
            for (long half = 0; half < 2; half++)
                set_row(at->own[j], half, turned(h, turn, row(at->own[j], half)));
        set_row(own, 0, cross(h, sub(tip, p))), set_row(own, 1, h);
    }
    set_column(*pose, 3, tip);
    if (!arm->leader) return;
    for (long j = 0; j < arm->n; j++)
        for (long i = 0; i < 6; i++) at->jacobian[j][i] = 0.0;
    for (long k = 0; k < arm->links; k++)
        for (long i = 0; i < 6; i++) at->jacobian[arm->leader[k]][i] += arm->ratio[k] * at->own[k][i];
}

/* The pose, the Jacobian and the error at q; returns the largest entry of the error. */
static double evaluate(const Screws *arm, const double *target, const double *q, State *at) {
    forward(arm, q, at);
    for (long i = 0; i < 3; i++) at->error[i] = target[4 * i + 3] - at->pose[i][3];
    /* R = target poseᵀ; its skew part is sin(angle) axis */
    double trace = 0.0;
    Vector skew = {0, 0, 0};
    for (long j = 0; j < 3; j++) {
        Vector a = column(at->pose, j), b = {target[j], target[4 + j], target[8 + j]};
        trace += dot(a, b);
        skew = add(skew, cross(a, b));
    }
    double sine = 0.5 * length(skew), angle = atan2(sine, 0.5 * (trace - 1.0));
    set_row(at->error, 1, scaled(0.5 * (sine > 1e-9 ? angle / sine : 1.0), skew));
    double largest = 0.0;
    for (long i = 0; i < 6; i++) largest = larger(largest, fabs(at->error[i]));
    return largest;
}

/* Solve the six equations m x = b by elimination with row exchanges; m and b are used up. Returns 0 where m is singular. */
static int solve(double m[6][6], double b[6], double x[6]) {
    for (long k = 0; k < 6; k++) {
        long best = k;
        for (long i = k + 1; i < 6; i++)
            if (fabs(m[i][k]) > fabs(m[best][k])) best = i;
        if (!(fabs(m[best][k]) > 0)) return 0;
        for (long j = 0; j < 6; j++) {
            double other = m[k][j];
            m[k][j] = m[best][j], m[best][j] = other;
        }
        double other = b[k];
        b[k] = b[best], b[best] = other;
        for (long i = k + 1; i < 6; i++) {
            double factor = m[i][k] / m[k][k];
            for (long j = k + 1; j < 6; j++) m[i][j] -= factor * m[k][j];
            b[i] -= factor * b[k];
        }
    }
    for (long k = 5; k >= 0; k--) {
        x[k] = b[k];
        for (long j = k + 1; j < 6; j++) x[k] -= m[k][j] * x[j];
        x[k] /= m[k][k];
    }
    return 1;
}

/* The damped minimum-norm step from q with the joints that are not `held`: trial = q + Jᵀ (J Jᵀ + (damping + relative trace) 1)⁻¹
   error, where the trace is that of J Jᵀ. Returns 0 where the matrix is singular. */
static int step(long n, const State *at, const char *held, double damping, double relative, const double *q, double *trial) {
    double gram[6][6] = {{0}}, error[6], x[6], trace = 0.0;
    for (long j = 0; j < n; j++) {
        if (held[j]) continue;
        const double *c = at->jacobian[j];
        for (long a = 0; a < 6; a++)
            for (long b = 0; b < 6; b++) gram[a][b] += c[a] * c[b];
    }
    for (long a = 0; a < 6; a++) trace += gram[a][a], error[a] = at->error[a];
    for (long a = 0; a < 6; a++) gram[a][a] += damping + relative * trace;
    if (!solve(gram, error, x)) return 0;
    for (long j = 0; j < n; j++) {
        double change = 0.0;
        for (long a = 0; a < 6; a++) change += at->jacobian[j][a] * x[a];
        trial[j] = held[j] ? q[j] : q[j] + change;
    }
    return 1;
}

/* Minimum-norm Newton steps from q (n), in place. They end once the pose is reached to `tolerance` [m, rad]; a step that does not
   reduce the error is rejected. work: see `state_in`; held (n): scratch space. */
static void refine(const Screws *arm, const double *target, double *q, long steps, double tolerance, double *work, char *held) {
    State at = state_in(arm, work);
    double *trial = work + 6 * arm->n, damping = LEAST, miss = evaluate(arm, target, q, &at);
    for (long j = 0; j < arm->n; j++) held[j] = !arm->moves[j];
    for (long k = 0; k < steps && !(miss <= tolerance || damping > 1e-2); k++) {
        if (!step(arm->n, &at, held, 0.0, damping, q, trial)) break;
        double nearer = evaluate(arm, target, trial, &at);
        if (nearer < miss) {
            miss = nearer, damping = larger(damping / 100, LEAST);
            for (long j = 0; j < arm->n; j++) q[j] = trial[j];
        } else {  /* near a singularity, where only short steps reduce the error */
            damping *= 10;
            evaluate(arm, target, q, &at);
        }
    }
}

static double squared(const double error[6]) {
    double sum = 0.0;
    for (long i = 0; i < 6; i++) sum += error[i] * error[i];
    return sum;
}

/* Damped Newton steps (Levenberg-Marquardt, [sugihara2011]) from q (n), in place, inside the limits. Joints stop at their limits
   and leave them when the step leads back. Steps end once the pose is reached to `tolerance`. Returns the largest entry of the
   error [m, rad]. work, held: as of `refine`. */
static double search(const Screws *arm, const double *target, const double *lower, const double *upper, double *q, long steps,
                     double tolerance, double *work, char *held) {
    State at = state_in(arm, work);
    double *trial = work + 6 * arm->n, damping = DAMPING, miss = evaluate(arm, target, q, &at), square = squared(at.error);
    for (long k = 0; k < steps && !(miss <= tolerance); k++) {
        for (long j = 0; j < arm->n; j++) {
            double gradient = 0.0;
            for (long a = 0; a < 6; a++) gradient += at.jacobian[j][a] * at.error[a];
            held[j] = !arm->moves[j] || (q[j] <= lower[j] && gradient < 0) || (q[j] >= upper[j] && gradient > 0);
        }
        if (!step(arm->n, &at, held, damping * square, LEAST, q, trial)) break;
        for (long j = 0; j < arm->n; j++)
            if (!held[j]) trial[j] = smaller(larger(trial[j], lower[j]), upper[j]);
        miss = evaluate(arm, target, trial, &at);
        double now = squared(at.error);
        if (now < square) {
            int stalled = now > 0.999 * square && damping > 1e3;
            for (long j = 0; j < arm->n; j++) q[j] = trial[j];
            square = now, damping = larger(damping / 4, 1e-6);
            if (stalled) break;
        } else {
            damping *= 8;
            miss = evaluate(arm, target, q, &at);
            if (damping > 1e6) break;
        }
    }
    return miss;
}
