/* All solutions of a closed form for many poses and values of the held joints, Newton steps, and checks of poses and solutions.
   All arrays belong to the caller. */

#include "newton.h"
#include "parallel.h"
#include "swivel.h"

#define TAU 6.283185307179586

enum { SPHERICAL, PARALLEL, SWIVEL };  /* solver of a closed form; as in form.py */

/* A closed form of an arm, and its joint limits. */
typedef struct {
    long n, helds, frees, solver, backward, moves_axes, triple;
    const double *axes, *points;   /* (n, 3) at q = 0 */
    const char *slides;            /* (n) whether each joint is prismatic */
    const long *held, *free;       /* (helds), (frees) indices of the joints; free ones in the solver's order */
    const double *meeting;         /* (2, 3) where the last free axes meet, and the shoulder of SWIVEL */
    const double *home;            /* (4, 4) inverse of the tool's pose at q = 0 */
    const double *lower, *upper;   /* (n) limits; -π and π for joints without */
    const char *endless;           /* (n) whether a joint has no limits */
    const double *turning;         /* (3) tool axis about which the tool is free to rotate; zeros for a full pose */
} Form;

/* Samples (s, width) of the held joints, then the swivel, then the rotation about `turning`; each belongs to a pose. */
typedef struct {
    const double *poses;   /* (p, 4, 4) */
    const long *owners;    /* (s) pose index of each sample */
    const double *values;
    long count, width;
} Samples;

/* Solutions out (rows, n), with the sample (rows) of each. */
typedef struct { double *out; long *source; long rows, filled; } Solutions;

enum { MOST_FREE = 7 };

/* The free joints of a closed form, read in the solver's order, with the values of one sample. */
typedef struct {
    double axes[3 * MOST_FREE], points[3 * MOST_FREE], lower[MOST_FREE], upper[MOST_FREE];
    long first, last;  /* smallest and largest index */
    Arrangement lie;
} Chain;

/* Axes, points (n, 3) and meeting points (2, 3), moved by the held joints between free ones. */
typedef struct { double *axes, *points, meeting[6]; } Moved;

/* motion <- e^(joint at value) motion */
static void shift_left(Motion motion, Vector h, Vector p, int slides, double value) {
    if (slides) {
        motion[0][3] += value * h.x, motion[1][3] += value * h.y, motion[2][3] += value * h.z;
        return;
    }
    Turn turn = turn_by(value);
    for (long j = 0; j < 3; j++) set_column(motion, j, turned(h, turn, column(motion, j)));
    set_column(motion, 3, turned_about(h, p, turn, column(motion, 3)));
}

/* out <- a b, for the upper rows of matrices (4, 4) */
static void multiply(const double (*a)[4], const double (*b)[4], Motion out) {
    for (long i = 0; i < 3; i++) {
        for (long j = 0; j < 4; j++) out[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
        out[i][3] += a[i][3];
    }
}

static void invert(Motion motion) {
    Vector p = column(motion, 3);
    for (long i = 0; i < 3; i++)
        for (long j = 0; j < i; j++) {
            double other = motion[i][j];
            motion[i][j] = motion[j][i], motion[j][i] = other;
        }
    set_column(motion, 3, scaled(-1.0, times(motion, p)));
}

static void copy(const double *from, double *to, long count) {
    for (long i = 0; i < count; i++) to[i] = from[i];
}

static void read_chain(const Form *form, const double *axes, const double *points, Chain *chain) {
    double sign = form->backward ? -1.0 : 1.0;
    for (long k = 0; k < form->frees; k++) {
        set_row(chain->axes, k, scaled(sign, row(axes, form->free[k])));
        set_row(chain->points, k, row(points, form->free[k]));
    }
    chain->lie = arrangement(chain->axes, chain->points);
}

/* e^(joint at value) applied to a point. */
static Vector moved_point(Vector h, Vector p, int slides, double value, Turn by, Vector point) {
    return slides ? add(point, scaled(value, h)) : turned_about(h, p, by, point);
}

/* Move what comes after a held joint by the joint. */
static void move_beyond(const Form *form, long joint, double value, Moved *moved) {
    Vector h = row(moved->axes, joint), p = row(moved->points, joint);
    Turn by = turn_by(value);
    int slides = form->slides[joint];
    for (long j = joint + 1; j < form->n; j++) {
        set_row(moved->points, j, moved_point(h, p, slides, value, by, row(moved->points, j)));
        if (!slides) set_row(moved->axes, j, turned(h, by, row(moved->axes, j)));
    }
    if (form->triple > joint) set_row(moved->meeting, 0, moved_point(h, p, slides, value, by, row(moved->meeting, 0)));
}

/* The motion that the free joints must make for one sample; returns 0 where a held joint is outside its limits. */
static int motion_left(const Form *form, const Chain *chain, const Samples *samples, long sample, Moved *moved, Motion motion) {
    const double *value = samples->values + sample * samples->width;
    const double (*pose)[4] = (const double (*)[4])(samples->poses + 16 * samples->owners[sample]);
    const double (*home)[4] = (const double (*)[4])form->home;
    Vector turning = row(form->turning, 0);
    if (turning.x != 0 || turning.y != 0 || turning.z != 0) {
        Motion turn = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}, tool;
        shift_left(turn, turning, (Vector){0, 0, 0}, 0, value[samples->width - 1]);
        multiply(pose, turn, tool);
        multiply(tool, home, motion);
    } else {
        multiply(pose, home, motion);
    }
    for (long k = 0; k < form->helds; k++) {
        long joint = form->held[k];
        if (!(form->endless[joint] || (form->lower[joint] <= value[k] && value[k] <= form->upper[joint]))) return 0;
        if (joint < chain->first)
            shift_left(motion, row(form->axes, joint), row(form->points, joint), form->slides[joint], -value[k]);
    }
    if (form->backward) invert(motion);
    /* with joints held after the first free one: S = A E B = A (E B E⁻¹) E */
    for (long k = 0; k < form->helds; k++) {
        long joint = form->held[k];
        if (joint < chain->first) continue;
        Vector h = row(moved->axes, joint), p = row(moved->points, joint);
        if (form->moves_axes && joint < chain->last) move_beyond(form, joint, value[k], moved);
        /* S E⁻¹; read backward: S⁻¹ becomes E S⁻¹ */
        if (!form->backward) invert(motion);
        shift_left(motion, h, p, form->slides[joint], value[k]);
        if (!form->backward) invert(motion);
    }
    return 1;
}

/* Write one solution of the free joints: the smallest value of each joint inside its limits, then every further full turn. */
static void put_solution(const Form *form, const Chain *chain, const double *value, long sample, double *found, Solutions *to) {
    long before = to->filled, n = form->n;
    double *q = to->out + n * to->filled++;
    for (long k = 0; k < form->frees; k++) {
        double low = chain->lower[k], high = chain->upper[k];
        if (form->endless[form->free[k]]) found[k] -= 2 * PI * floor((found[k] + PI) / (2 * PI));
        else found[k] = smaller(larger(least_above(found[k], low), low), high);
        q[form->free[k]] = found[k];
    }
    for (long k = 0; k < form->helds; k++) q[form->held[k]] = value[k];
    for (long k = 0; k < form->frees; k++) {
        long rows = to->filled;
        if (form->endless[form->free[k]]) continue;
        for (double extra = found[k] + 2 * PI; extra <= chain->upper[k] + AT_LIMIT; extra += 2 * PI)
            for (long r = before; r < rows; r++) {
                double *other = to->out + n * to->filled++;
                copy(to->out + n * r, other, n);
                other[form->free[k]] = smaller(extra, chain->upper[k]);
            }
    }
    for (long r = before; r < to->filled; r++) to->source[r] = sample;
}

/* Solve samples from `begin` on until fewer than `most` rows are left for the solutions, and return the next sample.
   work: (6 n), scratch space. */
long manipplan_solutions(const Form *form, const Samples *samples, long begin, long most, double *work, Solutions *to) {
    Chain chain = {.first = form->n, .last = -1};
    Moved moved = {.axes = work, .points = work + 3 * form->n};
    Arm arm = {form->frees, chain.axes, chain.points, chain.lower, chain.upper};
    double found[(MOST + 1) * MOST_FREE];
    for (long k = 0; k < form->frees; k++) {
        long joint = form->free[k];
        chain.lower[k] = form->lower[joint], chain.upper[k] = form->upper[joint];
        if (joint < chain.first) chain.first = joint;
        if (joint > chain.last) chain.last = joint;
    }
    read_chain(form, form->axes, form->points, &chain);
    for (long sample = begin; sample < samples->count; sample++) {
        const double *value = samples->values + sample * samples->width;
        Motion motion;
        if (to->filled + most > to->rows) return sample;
        if (sample == begin || form->moves_axes) {
            copy(form->axes, moved.axes, 3 * form->n);
            copy(form->points, moved.points, 3 * form->n);
            copy(form->meeting, moved.meeting, 6);
        }
        if (!motion_left(form, &chain, samples, sample, &moved, motion)) continue;
        if (form->moves_axes) read_chain(form, moved.axes, moved.points, &chain);
        Vector wrist = row(moved.meeting, 0), shoulder = row(moved.meeting, 1);
        long count = 0;
        if (form->solver == SPHERICAL) count = solve_spherical(&arm, chain.lie, wrist, motion, found);
        else if (form->solver == PARALLEL) count = solve_parallel(&arm, wrist, motion, found);
        else count = solve_swivel(&arm, shoulder, wrist, motion, value[form->helds], found);
        for (long k = 0; k < count; k++) put_solution(form, &chain, value, sample, found + form->frees * k, to);
    }
    return samples->count;
}

/* Arrangement of the first three of axes and points; writes their meeting point (3) and the deviation (1) to `out`. */
long manipplan_arrangement(const double *axes, const double *points, double *out) {
    Arrangement lie = arrangement(axes, points);
    set_row(out, 0, lie.meeting);
    out[3] = lie.miss;
    return lie.kind;
}

/* Roots of x⁴ + a[3] x³ + a[2] x² + a[1] x + a[0] as real and imaginary parts (4, 2); returns their number. */
long manipplan_quartic(const double *a, double *out) {
    Complex roots[DEGREE];
    long count = quartic_roots(a, roots);
    for (long k = 0; k < count; k++) out[2 * k] = roots[k].re, out[2 * k + 1] = roots[k].im;
    return count;
}

/* The swivel [rad] of each row of q (count, 7), for a shoulder (3) and a wrist (3). */
void manipplan_swivels(const double *axes, const double *points, const double *shoulder, const double *wrist, const double *q,
                       long count, double *out) {
    for (long k = 0; k < count; k++) out[k] = swivel_of(axes, points, row(shoulder, 0), row(wrist, 0), q + 7 * k);
}

/* `refine` for each row of q (count, n), to the pose targets[owners[k]]. work, held: scratch space as there. */
void manipplan_refine(const Screws *arm, const double *targets, const long *owners, double *q, long count, long steps,
                      double tolerance, double *work, char *held) {
    for (long k = 0; k < count; k++) refine(arm, targets + 16 * owners[k], q + arm->n * k, steps, tolerance, work, held);
}

/* `search` for each row of q (count, n), to one pose; writes the errors to miss (count). */
void manipplan_search(const Screws *arm, const double *target, const double *lower, const double *upper, double *q, long count,
                      long steps, double tolerance, double *miss, double *work, char *held) {
    for (long k = 0; k < count; k++)
        miss[k] = search(arm, target, lower, upper, q + arm->n * k, steps, tolerance, work, held);
}

/* Whether every matrix of poses (count, 4, 4) is a rotation, up to `accuracy`, and a translation. */
long manipplan_are_poses(const double *poses, long count, double accuracy) {
    for (const double *m = poses; m < poses + 16 * count; m += 16) {
        for (long i = 0; i < 16; i++)
            if (!isfinite(m[i])) return 0;
        for (long i = 0; i < 4; i++)
            if (fabs(m[12 + i] - (i == 3)) > accuracy) return 0;
        for (long i = 0; i < 3; i++)
            for (long j = 0; j <= i; j++)
                if (!(fabs(m[i] * m[j] + m[4 + i] * m[4 + j] + m[8 + i] * m[8 + j] - (i == j)) < accuracy)) return 0;
        Vector a = {m[0], m[1], m[2]}, b = {m[4], m[5], m[6]}, c = {m[8], m[9], m[10]};
        if (dot(cross(a, b), c) <= 0) return 0;
    }
    return 1;
}

/* The largest entry of reached[k] - targets[owners[k]], for poses (count, 4, 4) and (p, 4, 4). */
void manipplan_residuals(const double *reached, const double *targets, const long *owners, long count, double *out) {
    for (long k = 0; k < count; k++) {
        const double *a = reached + 16 * k, *b = targets + 16 * owners[k];
        out[k] = 0.0;
        for (long i = 0; i < 12; i++) out[k] = larger(out[k], fabs(a[i] - b[i]));
    }
}

/* Whether each row of q (count, n) is the first of those of one source that differ by less than `same`; equal sources are
   adjacent. */
void manipplan_first_ones(const double *q, const long *source, long count, long n, double same, char *keep) {
    for (long k = 0; k < count; k++) {
        keep[k] = 1;
        for (long other = k - 1; other >= 0 && source[other] == source[k] && keep[k]; other--) {
            long j = 0;
            while (j < n && fabs(q[n * k + j] - q[n * other + j]) < same) j++;
            keep[k] = j < n || !keep[other];
        }
    }
}

/* Whether each of rows first ... last - 1 of q (., n) has one of rows others ... end - 1 within `spacing` (n); joints that turn are
   compared up to full turns. */
static int all_have_near(const double *q, long first, long last, long others, long end, long n, const char *turns,
                         const double *spacing) {
    for (long k = first; k < last; k++) {
        long other = others;
        for (; other < end; other++) {
            long j = 0;
            for (; j < n; j++) {
                double d = fabs(q[n * k + j] - q[n * other + j]);
                if (d >= spacing[j] && !(turns[j] && fabs(d - TAU * floor(d / TAU + 0.5)) < spacing[j])) break;
            }
            if (j == n) break;
        }
        if (other == end) return 0;
    }
    return 1;
}

/* Whether samples k and k + 1 of one owner are apart (count - 1): whether a solution of one has none of the other within `spacing`.
   Sample k has rows start[k] ... start[k + 1] - 1 of q (., n). */
void manipplan_apart(const double *q, const long *start, const long *owners, long count, long n, const char *turns,
                     const double *spacing, char *apart) {
    for (long k = 0; k + 1 < count; k++) {
        long a = start[k], b = start[k + 1], c = start[k + 2];
        apart[k] = owners[k] == owners[k + 1] &&
                   !(all_have_near(q, a, b, b, c, n, turns, spacing) && all_have_near(q, b, c, a, b, n, turns, spacing));
    }
}
