/* The law of a servo: joint velocities that make a tool's velocity, near singular postures and in them.

   Of the task's rows J = Σ_k σ_k u_k v_kᵀ, with b = Uᵀ V for the commanded velocity V, and H = ∂J/∂q:

       min  Σ_k w_k² (v_kᵀ q̇ - g_k)²   s.t.  low <= q̇ <= high,  A q̇ >= bound (soft),      w_k = max(σ_k, EPSILON)      (1)

   A lost direction keeps a weight in joint space, so there is no dead zone. Where σ_k is large, g_k = b_k / σ_k. Where it is
   small, its curvature κ_k = u_kᵀ (∂J/∂q v_k) v_k tells what the singularity is; see `singular_rates` and `escape`. No number
   depends on the signs of singular vectors. docs/concepts/servo.md derives each branch. */

#include <math.h>
#include <string.h>

enum {
    MOST = 16,      /* maximum number of joints; as in servo.py */
    ROWS = 6,       /* maximum number of rows of a task */
    TOGETHER = 48   /* maximum number of bounds and rows that hold at a time */
};

/* As in servo.py: what is commanded, in which axes, which way out of a fold, the kind of the next singularity, what limits a step,
   and how it ended. */
enum { TWIST, POSE, JOINTS, BRAKE };
enum { WORLD, TOOL, OTHER_AXES };
enum { SAME, OTHER, ANY };
enum { NO_TURN, ABOUT_TOOL, ABOUT_WORLD, EVERY_TURN };
enum { CLEAR, FOLD, POLE };
enum { NOTHING, POSITION, VELOCITY, ACCELERATION, OBSTACLE };
enum { FOLLOWING, NOT_SOLVED, STALE, BAD_COMMAND, BAD_STATE, BAD_TIME_STEP };

#define EPSILON 0.03     /* least weight of a direction in joint space, in (1) */
#define SMALL 0.12       /* singular values below this are looked at one by one [m] */
#define LOST 0.02        /* directions below this are lost [m] */
#define TURNED 3e-3      /* below this the lost direction is turned, where nothing else helps [m] */
#define SPUN 5e-3        /* slower than this it is not turned [m/rad] */
#define NULL_WEIGHT 1e-3 /* weight of the null space in (1) */
#define RATE 1.0         /* of the drive in the null space [1/s] */
#define RANGE 0.1        /* of the drive's joint limits [rad] */
#define DAMPED 1e-3      /* damping of the drive's JJᵀ [m²] */
#define ROUNDED 1e-5     /* deviation of a rotation that is rounding */
#define LENGTH 0.3       /* metres per radian where a pose is approached */
#define APPROACH 2.0     /* largest deceleration with which it is approached [m/s²] */
#define STOPPING 0.5     /* and the largest share of the joints' acceleration that it takes: the tool does not go straight */
#define LAGS 4.0         /* time steps and time constants of the smoothing with which the last part decays, so that it does not swing */
#define FASTEST 5.0      /* and the maximum speed [m/s] */
#define RETURN 20.0      /* rate at which the drive returns to a planned motion [1/s] */
#define BRANCH 0.5       /* distance in the null space from which on it does not: another branch [rad] */
#define BESIDE 0.02      /* metres per radian of joints where the nearest knot is sought */
#define STILL 0.01       /* commanded speed at which the drive has faded by half, and below which ways out fade [m/s] */
#define SHARE 0.5        /* of the joint speeds that the drive takes at most */
#define BRAKING 0.7      /* share of the acceleration with which a fold is approached, and a joint's limit: others brake as well */
#define PASSING 0.7      /* share of the least damping that a pole's passage needs */
#define NUDGE 3e-4       /* σ that a pole is taken to have at least where the command is along its lost direction [m] */
#define AT_POLE 0.5      /* and as a share of the damping: no joint slows down where all of the command is lost */
#define ARRIVAL 1e-3     /* σ at which an approach of a fold ends [m]: keeps v defined, and costs 5 µm of reach */
#define GUARDED 5e-4     /* σ of a fold that is not fallen below [m] */
#define BENT 0.05        /* curvature from which a singularity is a fold */
#define STRAIGHT 0.02    /* curvature up to which it is a pole; between the two it is both, in part */
#define AHEAD 0.1        /* joint motion to which ways out are compared [rad] */
#define VANISHED 1e-11   /* σ whose v is rounding [m] */
#define FAINT 0.01       /* share of the command that is lost below which a way out fades */
#define BACKWARD 0.01    /* share of the command by which the way out of a pole, and the guard of a fold, may move the tool backward */
#define ALONG 0.05       /* motion of the tool with the joints from which on it is kept from moving backward [m/rad] */
#define TURNING 3.0      /* speed of that turn where no joint in it has a velocity limit [rad/s] */
#define SETTLED 60       /* iterations of (1) after which what is left may be rounding of large multipliers */
#define AT_REST 1e-3     /* share of its speed below which a joint that cannot go on has reached its limit */
#define LARGEST 1e6      /* speed from which on a command is none [m/s, rad/s] */
#define STAYING 0.03     /* time for which a joint that was pushed against its limit stays there [s] */

typedef struct {
    /* the arm: `physical` joints, each of which follows one of `joints`; limits (joints); the usual and the longest time step */
    long joints, physical, pairs, moving;
    const long *leader;
    const double *ratio, *lower, *upper, *velocity, *acceleration;
    double usual, slowest, timeout, smoothing;
    long side;
    /* the rows: (world_rows + tool_rows, 6), the first in world axes, the others in the tool's; angular entries in metres */
    long world_rows, tool_rows;
    const double *selection;
    /* the rotations that they leave free, and the unit axis of these, in the tool or in the world */
    long free_turns;
    double free_axis[3];
    /* of this state: columns (physical, 6) in world axes, rotation (3, 3) stored by columns and origin (3) of the tool, the bounds
       low and high (joints), rows of obstacles (pairs, joints), their bounds and distances (pairs);
       moving obstacles (moving, 18) */
    const double *columns, *rotation, *origin, *low, *high, *matrix, *bound, *distance, *obstacles;
    /* the code that computes them from arguments (5): q, qd, qdd, dt, the obstacles; 0 where the caller does */
    int (*problem)(const double **argument, double **result, long long *iw, double *w, int mem);
    const double **argument;
    double **results, *work;
    long long *integers;
    /* the step: the state, the command in its axes (twist or joint velocities), a pose (4, 4) by rows, whether it is new */
    double q[16], qd[16], dt, command[16], pose[16], axes[9];
    long mode, frame, fresh;
    /* a planned motion of at least three knots, or 0 of them: positions (knots, joints), rotation (knots, 9) by columns and origin
       (knots, 3) of the tool */
    long knots;
    const double *planned, *rotations, *origins;
    /* what it learned: the last acceleration; command and its age; U, the joint direction in which σ grows, the last way out, and
       which of these there are; for how long each joint stays at its limit; along which small singular values' directions it
       turns round; the nearest knot, whether it is known, and the planned positions there */
    double qdd[16], held[6], filtered[6], age, guess[36], inside[16], way[16], stays[16];
    long reverses[6], guessed, has_inside, has_way, leaves, knot, placed;
    double beside[16];
    /* of the task's rows in this state: wrenches of the twist in world axes, what of these turns with the tool, derivatives by q */
    double wrench[6][6], turning[6][6], rows[6][16];
    /* the result */
    double result[16], twist[6], speed, followed, slip, seconds, metres, wall, smallest, clearance;
    long kind, joint, limit, limit_joint, status;
} Servo;

typedef struct {
    long n, m, r;                   /* joints that are free, rows, rank at most */
    long joint[MOST];               /* which joints are free */
    double J[ROWS][MOST], W[ROWS];  /* rows and command */
    double U[ROWS][ROWS];           /* U[k] is u_k */
    double s[ROWS], V[MOST][MOST];  /* V[k] is v_k; those from r on span the null space */
    double b[ROWS], g[MOST], w[MOST], size, wall;
    double low[MOST], high[MOST];
    double inside[MOST], way[MOST];
    double guard[ROWS][MOST], fall[ROWS]; /* unit directions in which singular values grow, and how fast they may move */
    long reverses[ROWS], has_inside, has_way, leaves, kind, worst, guards, far;
    double seconds;
} Work;

static inline double least(double a, double b) { return a < b ? a : b; }
static inline double most(double a, double b) { return a > b ? a : b; }
static inline double clip(double x, double low, double high) { return x < low ? low : x > high ? high : x; }
static inline double sign(double x) { return (x > 0) - (x < 0); }

/* The time step; the usual one where what is given cannot be one. */
static inline double duration(const Servo *servo) {
    return servo->dt > 0 && servo->dt <= servo->slowest * (1 + 1e-9) ? servo->dt : servo->usual;
}

/* The share of a way out that a command gets: less than 1 where it is slower than STILL. */
static inline double share_of_way(const Work *w) { return clip(w->size / STILL, 1e-9, 1); }

static double dot(long n, const double *a, const double *b) {
    double sum = 0;
    for (long i = 0; i < n; i++) sum += a[i] * b[i];
    return sum;
}

static void cross(const double *a, const double *b, double *out) {
    out[0] = a[1] * b[2] - a[2] * b[1], out[1] = a[2] * b[0] - a[0] * b[2], out[2] = a[0] * b[1] - a[1] * b[0];
}

/* Singular values and vectors of J by rotations of its rows [one-sided Jacobi], from the last U on; V is completed to a basis. */
static void decompose(Work *w, Servo *servo) {
    long m = w->m, n = w->n;
    double A[ROWS][MOST], squared[ROWS];
    if (!servo->guessed) {
        memset(servo->guess, 0, sizeof servo->guess);
        for (long k = 0; k < m; k++) servo->guess[k * ROWS + k] = 1;
    }
    for (long k = 0; k < m; k++) {
        memcpy(w->U[k], servo->guess + k * ROWS, sizeof w->U[k]);
        for (long j = 0; j < n; j++) {
            double sum = 0;
            for (long l = 0; l < m; l++) sum += w->U[k][l] * w->J[l][j];
            A[k][j] = sum;
        }
    }
    for (int sweep = 0, turned = 1; sweep < 30 && turned; sweep++) {
        turned = 0;
        for (long k = 0; k < m; k++) squared[k] = dot(n, A[k], A[k]);
        for (long p = 0; p < m - 1; p++)
            for (long q = p + 1; q < m; q++) {
                double a = squared[p], b = squared[q], c = dot(n, A[p], A[q]);
                if (c * c <= 1e-22 * a * b || fabs(c) < 1e-26) continue;
                turned = 1;
                double z = (b - a) / (2 * c), t = (z > 0 ? 1 : -1) / (fabs(z) + sqrt(1 + z * z));
                double cosine = 1 / sqrt(1 + t * t), sine = cosine * t;
                squared[p] = most(a - t * c, 0), squared[q] = most(b + t * c, 0);
                for (long j = 0; j < n; j++) {
                    double x = A[p][j], y = A[q][j];
                    A[p][j] = cosine * x - sine * y, A[q][j] = sine * x + cosine * y;
                }
                for (long j = 0; j < m; j++) {
                    double x = w->U[p][j], y = w->U[q][j];
                    w->U[p][j] = cosine * x - sine * y, w->U[q][j] = sine * x + cosine * y;
                }
            }
    }
    double s[ROWS];
    long order[ROWS];
    for (long k = 0; k < m; k++) {
        s[k] = sqrt(squared[k]);
        long at = k;
        for (; at > 0 && s[order[at - 1]] < s[k]; at--) order[at] = order[at - 1];
        order[at] = k;
    }
    double U[ROWS][ROWS];
    memcpy(U, w->U, sizeof U);
    long known = 0;
    for (long k = 0; k < m; k++) {
        memcpy(w->U[k], U[order[k]], sizeof U[k]);
        w->s[k] = s[order[k]];
        if (k < w->r && w->s[k] > VANISHED) {
            for (long j = 0; j < n; j++) w->V[k][j] = A[order[k]][j] / w->s[k];
            known = k + 1;
        }
    }
    for (long k = 0; k < m; k++) memcpy(servo->guess + k * ROWS, w->U[k], sizeof w->U[k]);
    servo->guessed = 1;
    for (; known < n; known++) { /* the unit vector farthest from what is spanned */
        double residual[MOST];
        long best = 0;
        for (long j = 0; j < n; j++) {
            residual[j] = 1;
            for (long k = 0; k < known; k++) residual[j] -= w->V[k][j] * w->V[k][j];
            if (residual[j] > residual[best] + 1e-9) best = j;
        }
        double *v = w->V[known];
        memset(v, 0, sizeof w->V[known]);
        v[best] = 1;
        for (int again = 0; again < 2; again++) {
            for (long k = 0; k < known; k++) {
                double along = dot(n, w->V[k], v);
                for (long j = 0; j < n; j++) v[j] -= along * w->V[k][j];
            }
            double length = sqrt(dot(n, v, v));
            for (long j = 0; j < n; j++) v[j] /= length;
        }
    }
}

/* The wrenches and derivatives of the task's rows. */
static void read_rows(Servo *servo) {
    const double *R = servo->rotation;
    for (long k = 0; k < servo->world_rows + servo->tool_rows; k++) {
        const double *chosen = servo->selection + 6 * k;
        double *wrench = servo->wrench[k], *turning = servo->turning[k], *row = servo->rows[k];
        int turns = k >= servo->world_rows;
        for (int half = 0; half < 6; half += 3)
            for (int a = 0; a < 3; a++) {
                double turned = R[a] * chosen[half] + R[3 + a] * chosen[half + 1] + R[6 + a] * chosen[half + 2];
                wrench[half + a] = turns ? turned : chosen[half + a];
                turning[half + a] = turns ? turned : 0;
            }
        for (long j = 0; j < servo->joints; j++) row[j] = 0;
        for (long p = 0; p < servo->physical; p++)
            row[servo->leader[p]] += servo->ratio[p] * dot(6, wrench, servo->columns + 6 * p);
    }
}

/* Σ_j y_jᵀ ∂J_j/∂q_i for each free joint i: `y` (physical, 6) are wrenches on the columns, `turning` the parts of these that turn
   with the tool (0: none). ∂J_j/∂q_i is (ω_i x l_j, ω_i x ω_j) for i <= j, and (ω_j x l_i, 0) for i > j. */
static void contract(const Servo *servo, const Work *w, double y[MOST][6], double turning[MOST][6], double *out) {
    double after[3] = {0}, before[3] = {0}, turns[3] = {0}, all[MOST] = {0}, part[3];
    if (turning)
        for (long p = 0; p < servo->physical; p++)
            for (int half = 0; half < 6; half += 3) {
                cross(servo->columns + 6 * p + half, turning[p] + half, part);
                for (int a = 0; a < 3; a++) turns[a] += part[a];
            }
    double each[MOST];
    for (long p = servo->physical - 1; p >= 0; p--) {
        const double *column = servo->columns + 6 * p;
        for (int half = 0; half < 6; half += 3) {
            cross(column + half, y[p] + half, part);
            for (int a = 0; a < 3; a++) after[a] += part[a];
        }
        each[p] = 0;
        for (int a = 0; a < 3; a++) each[p] += column[3 + a] * (after[a] - turns[a]);
    }
    for (long p = 0; p < servo->physical; p++) {
        const double *column = servo->columns + 6 * p;
        each[p] += dot(3, column, before);
        cross(y[p], column + 3, part);
        for (int a = 0; a < 3; a++) before[a] += part[a];
        all[servo->leader[p]] += servo->ratio[p] * each[p];
    }
    for (long i = 0; i < w->n; i++) out[i] = all[w->joint[i]];
}

/* The wrench (6) of weights u (m) of the rows, and what of it turns with the tool. */
static void combine_rows(const Servo *servo, const Work *w, const double *u, double *wrench, double *turning) {
    memset(wrench, 0, 6 * sizeof *wrench);
    memset(turning, 0, 6 * sizeof *turning);
    for (long k = 0; k < w->m; k++)
        for (int a = 0; a < 6; a++) wrench[a] += u[k] * servo->wrench[k][a], turning[a] += u[k] * servo->turning[k][a];
}

/* ∂(uᵀ J v)/∂q (n) for weights u (m) of the rows and a joint direction v (n). */
static void slope_of(const Servo *servo, const Work *w, const double *u, const double *v, double *out) {
    double wrench[6], turning[6], y[MOST][6], turns[MOST][6], whole[MOST] = {0};
    combine_rows(servo, w, u, wrench, turning);
    for (long i = 0; i < w->n; i++) whole[w->joint[i]] = v[i];
    for (long p = 0; p < servo->physical; p++) {
        double share = servo->ratio[p] * whole[servo->leader[p]];
        for (int a = 0; a < 6; a++) y[p][a] = share * wrench[a], turns[p][a] = share * turning[a];
    }
    contract(servo, w, y, servo->tool_rows ? turns : 0, out);
}

/* The largest multiple of a joint direction within limits. */
static double along(const Work *w, const double *v, const double *limit) {
    double multiple = INFINITY;
    for (long i = 0; i < w->n; i++) multiple = least(multiple, limit[w->joint[i]] / most(fabs(v[i]), 1e-9));
    return multiple;
}

/* How far the joints can move along a direction inside their limits [rad]; a joint at its limit may move by what is rounding. */
static double room(const Servo *servo, const Work *w, const double *e) {
    double far = INFINITY;
    for (long i = 0; i < w->n; i++) {
        long j = w->joint[i];
        double left = e[i] > 0 ? servo->upper[j] - servo->q[j] : servo->q[j] - servo->lower[j];
        far = least(far, (most(left, 0) + 1e-4) / most(fabs(e[i]), 1e-6));
    }
    return far;
}

/* The largest speed from which steps of `dt` can stop within a distance, as in bounds.py. */
static double stopping(double distance, double acceleration, double dt) {
    if (isinf(distance)) return distance;
    if (isinf(acceleration)) return distance / dt;
    double change = acceleration * dt, far = most(distance, 0);
    double steps = floor((sqrt(1 + 8 * far / (dt * change)) - 1) / 2);
    return distance / (dt * (steps + 1)) + change * steps / 2;
}

/* Eigenvalues of a symmetric matrix (n, n), which is overwritten, and its eigenvectors in rows, the largest first [Jacobi]. */
static void eigen(long n, double A[MOST][MOST], double value[MOST], double vector[MOST][MOST]) {
    for (long i = 0; i < n; i++)
        for (long j = 0; j < n; j++) vector[i][j] = i == j;
    for (int sweep = 0; sweep < 30; sweep++) {
        double off = 0, whole = 0;
        for (long i = 0; i < n; i++)
            for (long j = 0; j < n; j++) *(i == j ? &whole : &off) += A[i][j] * A[i][j];
        if (off <= 1e-28 * whole || off < 1e-30) break;
        for (long p = 0; p < n - 1; p++)
            for (long q = p + 1; q < n; q++) {
                if (fabs(A[p][q]) < 1e-18) continue;
                double z = (A[q][q] - A[p][p]) / (2 * A[p][q]), t = (z > 0 ? 1 : -1) / (fabs(z) + sqrt(1 + z * z));
                double c = 1 / sqrt(1 + t * t), d = c * t;
                for (long j = 0; j < n; j++) {
                    double x = A[j][p], y = A[j][q];
                    A[j][p] = c * x - d * y, A[j][q] = d * x + c * y;
                }
                for (long j = 0; j < n; j++) {
                    double x = A[p][j], y = A[q][j];
                    A[p][j] = c * x - d * y, A[q][j] = d * x + c * y;
                    x = vector[p][j], y = vector[q][j];
                    vector[p][j] = c * x - d * y, vector[q][j] = d * x + c * y;
                }
            }
    }
    for (long i = 0; i < n; i++) value[i] = A[i][i];
    for (long i = 1; i < n; i++)
        for (long k = i; k > 0 && value[k] > value[k - 1]; k--) {
            double x = value[k];
            value[k] = value[k - 1], value[k - 1] = x;
            for (long j = 0; j < n; j++) x = vector[k][j], vector[k][j] = vector[k - 1][j], vector[k - 1][j] = x;
        }
}

/* M (n, n) with M[i][j] = uᵀ ∂J_j/∂q_i, for weights u of the rows, as in `contract`. */
static void second_order(const Servo *servo, const Work *w, const double *u, double M[MOST][MOST]) {
    double y[6], turning[6], all[MOST][MOST] = {0};
    combine_rows(servo, w, u, y, turning);
    for (long p = 0; p < servo->physical; p++) {
        const double *moved = servo->columns + 6 * p;
        double after[3], angular[3], turns[3], half[3], before[3];
        cross(moved, y, after), cross(moved + 3, y + 3, angular), cross(y, moved + 3, before);
        cross(moved, turning, turns), cross(moved + 3, turning + 3, half);
        for (int a = 0; a < 3; a++) after[a] += angular[a], turns[a] += half[a];
        for (long q = 0; q < servo->physical; q++) {
            const double *column = servo->columns + 6 * q;
            double each = (q <= p ? dot(3, column + 3, after) : dot(3, column, before)) - dot(3, column + 3, turns);
            all[servo->leader[q]][servo->leader[p]] += servo->ratio[q] * servo->ratio[p] * each;
        }
    }
    for (long i = 0; i < w->n; i++)
        for (long j = 0; j < w->n; j++) M[i][j] = all[w->joint[i]][w->joint[j]];
}

/* K = sym(Nᵀ M N) for the rows of N (d, n). */
static void restricted(const Work *w, double M[MOST][MOST], double (*N)[MOST], long d, double K[MOST][MOST]) {
    double MN[MOST][MOST];
    for (long a = 0; a < d; a++)
        for (long i = 0; i < w->n; i++) {
            MN[a][i] = 0;
            for (long j = 0; j < w->n; j++) MN[a][i] += (M[i][j] + M[j][i]) * N[a][j];
        }
    for (long a = 0; a < d; a++)
        for (long b = 0; b < d; b++) K[a][b] = dot(w->n, N[a], MN[b]) / 2;
}

/* A row (n) that q̇ keeps at least at the bound that is returned: those of folds, then those of obstacles. */
static double row_of(const Servo *servo, const Work *w, long c, double *row) {
    if (c < w->guards) {
        memcpy(row, w->guard[c], sizeof w->guard[c]);
        return w->fall[c];
    }
    c -= w->guards;
    for (long i = 0; i < w->n; i++) row[i] = servo->matrix[c * servo->joints + w->joint[i]];
    return servo->bound[c];
}

/* Squared distance of the tool, in the rows of the task, and of the joints from a knot of the planned motion. */
static double from_knot(const Servo *servo, long k) {
    const double *R = servo->rotation, *P = servo->rotations + 9 * k;
    double d[6], local[6], sum = 0, joints = 0;
    for (int a = 0; a < 3; a++) d[a] = servo->origins[3 * k + a] - servo->origin[a], d[3 + a] = 0;
    for (int c = 0; c < 3; c++) { /* half the sum of the cross products of the axes: the sine of the turn */
        double part[3];
        cross(R + 3 * c, P + 3 * c, part);
        for (int a = 0; a < 3; a++) d[3 + a] += part[a] / 2;
    }
    for (int half = 0; half < 6; half += 3)
        for (int a = 0; a < 3; a++) local[half + a] = dot(3, R + 3 * a, d + half);
    for (long r = 0; r < servo->world_rows + servo->tool_rows; r++) {
        double e = dot(6, servo->selection + 6 * r, r < servo->world_rows ? d : local);
        sum += e * e;
    }
    for (long j = 0; j < servo->joints; j++) {
        double e = servo->planned[k * servo->joints + j] - servo->q[j];
        joints += e * e;
    }
    return sum + BESIDE * BESIDE * joints;
}

/* The planned positions (joints) where the tool is: those of the knot to which the distance is least from the last one on, and between
   it and its neighbours those at the least of a parabola through the three. */
static void find_planned(Servo *servo) {
    long last = servo->knots - 1, k = servo->placed ? servo->knot : 0;
    double here = from_knot(servo, k);
    if (!servo->placed)
        for (long i = 1; i <= last; i++) {
            double far = from_knot(servo, i);
            if (far < here) here = far, k = i;
        }
    for (int turn = -1; turn <= 1; turn += 2)
        while (k + turn >= 0 && k + turn <= last) {
            double far = from_knot(servo, k + turn);
            if (!(far < here)) break;
            here = far, k += turn;
        }
    servo->knot = k, servo->placed = 1;
    long middle = k < 1 ? 1 : k > last - 1 ? last - 1 : k;
    double before = from_knot(servo, middle - 1), at = from_knot(servo, middle), after = from_knot(servo, middle + 1);
    double bent = before - 2 * at + after, t = bent > 1e-18 ? clip((before - after) / (2 * bent), -1, 1) : (double)(k - middle);
    const double *q = servo->planned + middle * servo->joints, *next = t > 0 ? q + servo->joints : q - servo->joints;
    for (long j = 0; j < servo->joints; j++) servo->beside[j] = q[j] + fabs(t) * (next[j] - q[j]);
}

/* Add to z (n) the return to the planned motion through the null space, (I - Jᵀ Y) (q_planned - q). */
static void add_return(const Servo *servo, const Work *w, double Y[ROWS][MOST], double *z) {
    double away[MOST], back[MOST], rate[ROWS];
    for (long i = 0; i < w->n; i++) away[i] = servo->beside[w->joint[i]] - servo->q[w->joint[i]];
    for (long a = 0; a < w->m; a++) rate[a] = dot(w->n, w->J[a], away);
    for (long i = 0; i < w->n; i++) {
        back[i] = away[i];
        for (long a = 0; a < w->m; a++) back[i] -= Y[a][i] * rate[a];
    }
    double gain = least(RETURN, 0.5 / duration(servo)) * clip(2 - sqrt(dot(w->n, back, back)) / BRANCH, 0, 1);
    for (long i = 0; i < w->n; i++) z[i] += gain * back[i];
}

/* The drive in the null space, z (n): ∇ log sqrt det(JJᵀ), of which Y (m, n) = (JJᵀ)⁻¹ J is the derivative by J, and away from joint
   limits, and back to a planned motion; it fades where nothing is commanded. */
static void drive_of(const Servo *servo, const Work *w, double Y[ROWS][MOST], double *z) {
    double y[MOST][6] = {0}, turns[MOST][6] = {0};
    for (long k = 0; k < w->m; k++) {
        const double *wrench = servo->wrench[k], *turning = servo->turning[k];
        double whole[MOST] = {0};
        for (long i = 0; i < w->n; i++) whole[w->joint[i]] = Y[k][i];
        for (long p = 0; p < servo->physical; p++) {
            double part = servo->ratio[p] * whole[servo->leader[p]];
            for (int a = 0; a < 6; a++) y[p][a] += part * wrench[a], turns[p][a] += part * turning[a];
        }
    }
    contract(servo, w, y, servo->tool_rows ? turns : 0, z);
    for (long i = 0; i < w->n; i++) {
        long j = w->joint[i];
        double above = servo->upper[j] - servo->q[j], below = servo->q[j] - servo->lower[j];
        z[i] = RATE * (z[i] + 0.1 * (1 / (most(below, 0) + RANGE) - 1 / (most(above, 0) + RANGE)));
    }
    if (servo->knots) add_return(servo, w, Y, z);
    double fit = least(1, SHARE * along(w, z, servo->velocity)) * w->size / (w->size + STILL);
    for (long i = 0; i < w->n; i++) z[i] *= fit;
}

/* g_k and w_k of the null space; the damping of JJᵀ ends where all singular values are large. */
static void drive_null_space(const Servo *servo, Work *w) {
    double Y[ROWS][MOST] = {0}, z[MOST], smallest = w->s[w->r - 1], damping = DAMPED * clip(1 - smallest / SMALL, 0, 1);
    for (long k = 0; k < w->r; k++) {
        double share = w->s[k] / (w->s[k] * w->s[k] + damping);
        for (long l = 0; l < w->m; l++)
            for (long i = 0; i < w->n; i++) Y[l][i] += share * w->U[k][l] * w->V[k][i];
    }
    drive_of(servo, w, Y, z);
    for (long k = w->r; k < w->n; k++) {
        w->g[k] = dot(w->n, w->V[k], z) * least(1, smallest / 0.05);
        /* beside a singularity v_k and the null space turn into each other: both get the same weight */
        w->w[k] = most(NULL_WEIGHT, EPSILON * (1 - smallest / LOST));
    }
}

/* The solution of (1) where all singular values are large and no bound is active: q̇ = J⁺ V + (I - J⁺ J) z, with Y = (J⁺)ᵀ. The squared
   entries of YYᵀ = (JJᵀ)⁻¹ add up to at least 1 / σ⁴. Returns 0 elsewhere. */
static int is_far(const Servo *servo, Work *w, double *x) {
    long m = w->m, n = w->n;
    double L[ROWS][ROWS], Y[ROWS][MOST], squares = 0;
    if (n < m) return 0;
    for (long a = 0; a < m; a++) { /* L Lᵀ = JJᵀ, Y = L⁻¹ J */
        for (long b = 0; b <= a; b++) {
            double sum = dot(n, w->J[a], w->J[b]) - dot(b, L[a], L[b]);
            if (a == b && !(sum > 0.5 * SMALL * SMALL)) return 0; /* σ² is at most any pivot */
            L[a][b] = a == b ? sqrt(sum) : sum / L[b][b];
        }
        memcpy(Y[a], w->J[a], sizeof Y[a]);
        for (long b = 0; b < a; b++)
            for (long i = 0; i < n; i++) Y[a][i] -= L[a][b] * Y[b][i];
        for (long i = 0; i < n; i++) Y[a][i] /= L[a][a];
    }
    for (long a = m - 1; a >= 0; a--) { /* Y = L⁻ᵀ L⁻¹ J */
        for (long b = a + 1; b < m; b++)
            for (long i = 0; i < n; i++) Y[a][i] -= L[b][a] * Y[b][i];
        for (long i = 0; i < n; i++) Y[a][i] /= L[a][a];
        for (long b = a; b < m; b++) {
            double entry = dot(n, Y[a], Y[b]);
            squares += (a == b ? 1 : 2) * entry * entry;
        }
    }
    if (sqrt(squares) * SMALL * SMALL > 1) return 0;
    for (long i = 0; i < n; i++) {
        x[i] = 0;
        for (long a = 0; a < m; a++) x[i] += Y[a][i] * w->W[a];
    }
    if (n > m) {
        double z[MOST], Jz[ROWS];
        drive_of(servo, w, Y, z);
        for (long a = 0; a < m; a++) Jz[a] = dot(n, w->J[a], z);
        for (long i = 0; i < n; i++) {
            x[i] += z[i];
            for (long a = 0; a < m; a++) x[i] -= Y[a][i] * Jz[a];
        }
    }
    for (long i = 0; i < n; i++)
        if (!(x[i] >= w->low[i] && x[i] <= w->high[i])) return 0;
    for (long c = 0; c < servo->pairs; c++) {
        double row[MOST], bound = row_of(servo, w, c, row);
        if (bound > -1e12 && dot(n, row, x) < bound) return 0;
    }
    w->s[w->r - 1] = 1 / sqrt(sqrt(squares));
    return 1;
}

/* Motion along v (n) after which a direction with σ = s and the part b of the command has turned into a direction that no free joint
   moves, which exist where joints stand at their limits, so far that b vanishes [rad]. */
static double turned_after(const Servo *servo, const Work *w, const double *v, double s, double b) {
    double angle = 10, slope[MOST];
    for (long l = w->r; l < w->m; l++) {
        slope_of(servo, w, w->U[l], v, slope);
        double rate = fabs(dot(w->n, slope, v)) / most(s, ARRIVAL), other = fabs(dot(w->m, w->U[l], w->W));
        angle = least(angle, atan2(fabs(b), other) / most(rate, 1e-9));
    }
    return angle;
}

/* The part of the command along u_k and what is lost with it: where several σ are nearly 0, their directions turn into each other. */
static double lost_with(const Work *w, long k) {
    double sum = w->b[k] * w->b[k];
    for (long l = 0; l < w->r; l++)
        if (l != k) {
            double both = clip(2 - 2 * w->s[l] / LOST, 0, 1) * clip(2 - 2 * w->s[k] / LOST, 0, 1);
            sum += both * w->b[l] * w->b[l];
        }
    return sqrt(sum);
}

/* g_k of the directions with small σ_k: one after another. */
static void singular_rates(const Servo *servo, Work *w) {
    double T = duration(servo), horizon = T / share_of_way(w);
    for (long k = 0; k < w->r; k++) {
        double s = w->s[k], b = w->b[k], *v = w->V[k], slope[MOST];
        if (s >= SMALL) {
            w->g[k] = b / s;
            continue;
        }
        slope_of(servo, w, w->U[k], v, slope);
        double kappa = dot(w->n, slope, v), kb = kappa * b, fastest = along(w, v, servo->velocity);
        double force = along(w, v, servo->acceleration), toward = sign(b) * kappa;
        /* a pole: the least damping with which its passage needs no more than the joints' speed and acceleration; none at SMALL */
        double lambda = PASSING * most(w->size, STILL) * most(1 / (2 * fastest), 1 / sqrt(force)) * clip(2 - 2 * s / SMALL, 0, 1);
        /* approaching a fold: no faster than the arm can stop at σ = ARRIVAL, in the distance σ / bend */
        double bend = -toward;
        if (w->n > w->r && s < EPSILON) { /* v_k may have turned into the null space: the sharper curvature counts */
            double M[MOST][MOST], K[MOST][MOST], value[MOST], vector[MOST][MOST], N[MOST][MOST], u[ROWS];
            long d = 0;
            memcpy(N[d++], v, sizeof N[0]);
            for (long j = w->r; j < w->n; j++) memcpy(N[d++], w->V[j], sizeof N[0]);
            for (long l = 0; l < w->m; l++) u[l] = -sign(b) * w->U[k][l];
            second_order(servo, w, u, M);
            restricted(w, M, N, d, K);
            eigen(d, K, value, vector);
            bend += clip(2 - 2 * s / EPSILON, 0, 1) * most(value[0] - bend, 0);
        }
        double share = w->size > 1e-9 ? b * b / (w->size * w->size) : 0, length = sqrt(dot(w->n, slope, slope));
        double pass = share * share * clip(1 - bend / STRAIGHT, 0, 1) * clip(length / SPUN - 1, 0, 1);
        double sd = most(s, most(NUDGE, AT_POLE * lambda) * pass);
        double damped = b * sd / (sd * sd + lambda * lambda + 1e-12), now = 0;
        /* both ways are the same at σ = 0: the arm keeps the one in which it moves, unless it has begun to turn round */
        for (long i = 0; i < w->n; i++) now += v[i] * servo->qd[w->joint[i]];
        int against = sd > s && now * damped < 0;
        w->reverses[k] = against && (servo->reverses[k] || s * fabs(damped) >= BACKWARD * (w->size + STILL));
        if (against && !w->reverses[k]) damped = -damped;
        /* no faster than the arm can stop where b vanishes */
        double angle = turned_after(servo, w, v, s, b);
        double fade = clip(bend / BENT, 0, 1), cap = least(fastest, stopping(angle, force, T)), free = cap;
        if (bend > 0) cap = least(cap, stopping(most(s - ARRIVAL, 0) / bend, BRAKING * force, T));
        double capped = b * least(1 / most(s, 1e-9), cap / most(lost_with(w, k), 1e-9));
        double approach = fade * capped + (1 - fade) * damped;
        /* leaving a fold: the root of σ g + ½ κ T g² = b, not damped */
        double leaving = clip(toward / BENT, 0, 1), leave = damped;
        if (kb > 0) {
            double out = clip(2 * b / (s + sqrt(s * s + 2 * kb * horizon) + 1e-12), -free, free);
            leave += (w->n > w->r ? clip(2 * s / LOST - 1, 0, 1) : 1) * (out - damped); /* v_k turns quickly there: `escape` leaves */
        }
        w->g[k] = leaving * leave + (1 - leaving) * approach;
        if (kb <= 0 && fade > 0) {
            w->wall += fade * most(b * b - s * s * w->g[k] * w->g[k], 0);
            double seconds = s * s / (2 * most(fabs(kb), 1e-12));
            if (fade == 1 && seconds < w->seconds) w->seconds = seconds, w->kind = FOLD, w->worst = k;
        }
        if (servo->side == SAME && s > VANISHED) { /* σ falls no faster than it can stop */
            double folded = clip(fabs(kappa) / BENT - 1, 0, 1);
            if (length > BENT && folded > 0) {
                double unit[MOST];
                for (long i = 0; i < w->n; i++) unit[i] = w->guard[w->guards][i] = slope[i] / length;
                double stop = stopping(most(s - GUARDED, 0) / length, BRAKING * along(w, unit, servo->acceleration), T);
                w->fall[w->guards++] = -stop / folded;
            }
        }
        if (k == w->r - 1 && s > 2e-3 && fabs(kappa) > BENT) {
            for (long i = 0; i < w->n; i++) w->inside[i] = sign(kappa) * v[i];
            w->has_inside = 1;
        }
    }
}

/* The way out where directions are lost: along the sharpest positive curvature of what is lost, in the span of the lost v_k and the
   null space; where there is none, the motion that turns the lost direction away from the command fastest. */
static void escape(const Servo *servo, Work *w) {
    double T = duration(servo), faint = share_of_way(w), lost = 0, u[ROWS] = {0};
    long first = w->r;
    while (first > 0 && w->s[first - 1] < LOST) first--;
    for (long k = first; k < w->r; k++) lost += w->b[k] * w->b[k];
    lost = sqrt(lost);
    if (first == w->r || w->size < 1e-9 || lost <= 1e-3 * w->size) return;
    long n = w->n, d = n - first;
    double M[MOST][MOST], K[MOST][MOST], value[MOST], vector[MOST][MOST], (*N)[MOST] = w->V + first;
    for (long k = first; k < w->r; k++)
        for (long l = 0; l < w->m; l++) u[l] += w->b[k] / lost * w->U[k][l];
    second_order(servo, w, u, M);
    restricted(w, M, N, d, K);
    double copy[MOST][MOST], ahead[MOST], now[MOST], memory[MOST], turning[MOST], before[MOST] = {0}, weight = 1e-2;
    memcpy(copy, K, sizeof copy);
    eigen(d, copy, value, vector);
    /* the way that was taken in the last step, the side from which the arm came, or the last way */
    const double *past = servo->leaves ? w->way : w->has_inside ? w->inside : w->has_way ? w->way : 0;
    for (long a = 0; a < d; a++) {
        ahead[a] = a < w->r - first ? w->s[first + a] * w->b[first + a] / lost : 0; /* Nᵀ Jᵀ u */
        now[a] = 0, memory[a] = 0;
        for (long i = 0; i < n; i++) {
            now[a] += N[a][i] * servo->qd[w->joint[i]];
            if (past) memory[a] += N[a][i] * past[i];
        }
        if (servo->side == OTHER && w->has_inside && !servo->leaves) memory[a] = -memory[a];
        for (long i = 0; i < n; i++) before[i] += N[a][i] * memory[a];
    }
    for (long i = 0; i < n; i++) { /* how fast each joint turns the lost direction away from the command [1/rad] */
        turning[i] = 0;
        for (long k = 0; k < first; k++) turning[i] += dot(n, M[i], w->V[k]) * w->b[k] / w->s[k] / lost;
    }
    weight *= least(room(servo, w, before) / AHEAD, 1); /* a way that the limits end counts the less, the nearer its end */
    double best[MOST] = {0}, score = -INFINITY, way[MOST], length = sqrt(dot(d, ahead, ahead));
    for (int candidate = 0; candidate < (length > 1e-12 ? 3 : 2); candidate++) {
        double e[MOST], bent = 0, now_along = 0;
        for (long a = 0; a < d; a++) e[a] = candidate == 2 ? ahead[a] / length : candidate ? -vector[0][a] : vector[0][a];
        for (long a = 0; a < d; a++) bent += e[a] * dot(d, K[a], e);
        for (long i = 0; i < n; i++) {
            way[i] = 0;
            for (long a = 0; a < d; a++) way[i] += N[a][i] * e[a];
        }
        now_along = dot(d, e, now);
        double left = room(servo, w, way), far = least(left, AHEAD);
        double value_of = far * dot(d, ahead, e) + 0.5 * far * far * bent + weight * dot(d, e, memory)
                        + 1e-4 * least(left, 1) + 1e-3 * tanh(dot(n, way, turning)) + 1e-6 * tanh(now_along / 0.05);
        if (value_of > score) score = value_of, memcpy(best, e, sizeof best);
    }
    double bent = 0, rise = dot(d, ahead, best);
    for (long a = 0; a < d; a++) bent += best[a] * dot(d, K[a], best);
    for (long i = 0; i < n; i++) {
        way[i] = 0;
        for (long a = 0; a < d; a++) way[i] += N[a][i] * best[a];
    }
    if (bent > STRAIGHT && rise * AHEAD + 0.5 * bent * AHEAD * AHEAD > 0) {
        double horizon = T / faint, speed = (-rise + sqrt(rise * rise + 2 * bent * lost * horizon)) / (bent * horizon);
        double angle = turned_after(servo, w, way, w->s[w->r - 1], lost);
        speed = least(speed, stopping(angle, BRAKING * along(w, way, servo->acceleration), T));
        speed = least(speed, along(w, way, servo->velocity));
        double blend = clip((bent - STRAIGHT) / (BENT - STRAIGHT), 0, 1) * least(lost / (FAINT * w->size), 1);
        blend *= clip(2 - 2 * w->s[w->r - 1] / LOST, 0, 1);
        for (long a = 0; a < d; a++) {
            w->g[first + a] = (1 - blend) * w->g[first + a] + blend * best[a] * speed;
            w->w[first + a] = most(w->w[first + a], blend * EPSILON);
        }
        for (long c = 0; c < w->guards; c++) /* the way may lead through the fold, as from a start in it */
            w->fall[c] += least(dot(n, w->guard[c], way), 0) * blend * speed;
        memcpy(w->way, way, sizeof way);
        w->has_way = w->leaves = 1;
        return;
    }
    /* the same for what has vanished, each direction the more the smaller its σ; where K vanishes there too, it is turned */
    double gone = 0, sharpest = 0, part[MOST], Z[MOST][MOST];
    memset(u, 0, sizeof u);
    for (long a = 0; a < d; a++) {
        part[a] = a < w->r - first ? clip(2 - 2 * w->s[first + a] / TURNED, 0, 1) : 1;
        for (long i = 0; i < n; i++) Z[a][i] = part[a] * N[a][i];
        if (a < w->r - first) gone += part[a] * part[a] * w->b[first + a] * w->b[first + a];
    }
    gone = sqrt(gone);
    if (gone <= 0.7 * w->size) return;
    for (long a = 0; a < w->r - first; a++)
        for (long l = 0; l < w->m; l++) u[l] += part[a] * w->b[first + a] / gone * w->U[first + a][l];
    second_order(servo, w, u, M);
    restricted(w, M, Z, d, K);
    memcpy(copy, K, sizeof copy);
    eigen(d, copy, value, vector);
    for (long a = 0; a < d; a++) sharpest = most(sharpest, fabs(value[a]));
    if (sharpest >= BENT) return;
    /* R = Zᵀ M (I - N Nᵀ): how fast motions in Z turn the direction. With r = |R|, the unit vector e with the largest
       eᵀ (R Rᵀ + r K) e: of those that turn it fast one that moves the tool forward */
    double R[MOST][MOST], RR[MOST][MOST];
    for (long a = 0; a < d; a++) {
        for (long j = 0; j < n; j++) {
            R[a][j] = 0;
            for (long i = 0; i < n; i++) R[a][j] += Z[a][i] * M[i][j];
        }
        for (long c = 0; c < d; c++) {
            double along_it = dot(n, R[a], N[c]);
            for (long j = 0; j < n; j++) R[a][j] -= along_it * N[c][j];
        }
    }
    for (long a = 0; a < d; a++)
        for (long c = 0; c < d; c++) copy[a][c] = RR[a][c] = dot(n, R[a], R[c]);
    eigen(d, copy, value, vector);
    double largest = sqrt(most(value[0], 0)), squared = 0;
    for (long a = 0; a < d; a++)
        for (long c = 0; c < d; c++) copy[a][c] = RR[a][c] + largest * K[a][c];
    eigen(d, copy, value, vector);
    for (long a = 0; a < d; a++) squared += vector[0][a] * dot(d, RR[a], vector[0]);
    double spin = sqrt(most(squared, 0));
    if (spin <= SPUN) return;
    double toward = 0, back = 0;
    for (long i = 0; i < n; i++) {
        way[i] = 0;
        for (long a = 0; a < d; a++) way[i] += Z[a][i] * vector[0][a];
        toward += way[i] * (w->has_way ? w->way[i] : servo->qd[w->joint[i]]);
    }
    double turn = toward >= 0 ? 1 : -1, fastest = 0.75 * along(w, way, servo->velocity);
    if (isinf(fastest)) fastest = TURNING;
    for (long a = 0; a < w->r - first; a++) back -= turn * part[a] * vector[0][a] * w->s[first + a] * w->b[first + a];
    if (back > 0) fastest = least(fastest, BACKWARD * w->size * w->size / back);
    double share = faint * (gone / w->size - 0.7) / 0.3 * least(spin / SPUN - 1, 1) * clip((BENT - sharpest) / (BENT - STRAIGHT), 0, 1);
    for (long a = 0; a < d; a++) {
        w->g[first + a] += share * part[a] * (turn * vector[0][a] * fastest - w->g[first + a]);
        w->w[first + a] = most(w->w[first + a], share * EPSILON);
    }
    for (long i = 0; i < n; i++) w->way[i] = turn * way[i];
    w->has_way = 1;
}

/* Solve (1): in y = w Vᵀ q̇ it is the point nearest to w g that meets all bounds and rows, found by a dual active set
   [goldfarb1983]. Rows give way where they contradict each other. `force` (n + 1): the multiplier of each joint's bound, negative for
   a lower one, and the largest of the rows of obstacles. Returns 0 where it does not end. */
static int nearest_point(const Servo *servo, const Work *w, double *x, double *force) {
    long n = w->n, count = 2 * n + w->guards + servo->pairs, active[TOGETHER], size = 0;
    double y0[MOST], y[MOST], row[TOGETHER][MOST], rhs[TOGETHER], soft[TOGETHER], lambda[TOGETHER];
    for (long k = 0; k < n; k++) y0[k] = y[k] = w->w[k] * w->g[k];
    for (long i = 0; i <= n; i++) force[i] = 0;
    for (int iteration = 0; iteration < 200; iteration++) {
        for (long i = 0; i < n; i++) {
            x[i] = 0;
            for (long k = 0; k < n; k++) x[i] += w->V[k][i] * (y[k] / w->w[k]);
        }
        /* the constraint that is violated most, each scaled to its own speed */
        long worst = -1;
        double excess = iteration < SETTLED ? 1e-10 : 1e-7;
        for (long c = 0; c < count; c++) {
            double over, row_c[MOST], bound;
            if (c < n) over = x[c] - w->high[c];
            else if (c < 2 * n) over = w->low[c - n] - x[c - n];
            else {
                bound = row_of(servo, w, c - 2 * n, row_c);
                if (!(bound > -1e12)) continue;
                over = bound - dot(n, row_c, x);
                for (long a = 0; a < size; a++)
                    if (active[a] == c) over = 0;
            }
            if (over > excess) excess = over, worst = c;
        }
        for (long a = 0; a < size; a++)
            if (active[a] == worst) worst = -1;
        if (worst < 0) {
            for (long a = 0; a < size; a++)
                if (active[a] < 2 * n) force[active[a] % n] = active[a] < n ? lambda[a] : -lambda[a];
                else if (active[a] >= 2 * n + w->guards) force[n] = most(force[n], lambda[a]);
            return 1;
        }
        if (size == TOGETHER) return 0;
        /* its normal in y */
        double *normal = row[size], length = 0, row_c[MOST], limit;
        limit = worst < n ? w->high[worst] : worst < 2 * n ? -w->low[worst - n] : -row_of(servo, w, worst - 2 * n, row_c);
        for (long k = 0; k < n; k++) {
            double sum = worst < n ? w->V[k][worst] : worst < 2 * n ? -w->V[k][worst - n] : -dot(n, w->V[k], row_c);
            normal[k] = sum / w->w[k];
            length += normal[k] * normal[k];
        }
        length = sqrt(length);
        if (length < 1e-12) { /* a row that no joint moves */
            if (worst >= 2 * n) return 1;
            return 0;
        }
        for (long k = 0; k < n; k++) normal[k] /= length;
        rhs[size] = limit / length;
        soft[size] = worst < 2 * n ? 0 : 1e-6;
        active[size] = worst, lambda[size] = 0, size++;
        for (;;) { /* multipliers of the active ones */
            double G[TOGETHER][TOGETHER], target[TOGETHER];
            for (long a = 0; a < size; a++) {
                for (long c = 0; c <= a; c++) G[a][c] = dot(n, row[a], row[c]);
                G[a][a] += soft[a];
                target[a] = dot(n, row[a], y0) - rhs[a];
            }
            for (long a = 0; a < size; a++) {
                for (long c = 0; c <= a; c++) {
                    double sum = G[a][c];
                    for (long k = 0; k < c; k++) sum -= G[a][k] * G[c][k];
                    if (c < a) G[a][c] = sum / G[c][c];
                    else G[a][a] = sqrt(most(sum, 1e-14));
                }
            }
            for (long a = 0; a < size; a++) {
                for (long k = 0; k < a; k++) target[a] -= G[a][k] * target[k];
                target[a] /= G[a][a];
            }
            for (long a = size - 1; a >= 0; a--) {
                for (long k = a + 1; k < size; k++) target[a] -= G[k][a] * target[k];
                target[a] /= G[a][a];
            }
            double step = 1;
            long leaves = -1;
            for (long a = 0; a < size; a++)
                if (target[a] < 0) {
                    double part = lambda[a] > 0 ? lambda[a] / (lambda[a] - target[a]) : 0;
                    if (leaves < 0 || part < step) step = part, leaves = a;
                }
            for (long a = 0; a < size; a++) lambda[a] += step * (target[a] - lambda[a]);
            if (leaves < 0) break;
            size--;
            for (long a = leaves; a < size; a++) {
                active[a] = active[a + 1], lambda[a] = lambda[a + 1], rhs[a] = rhs[a + 1], soft[a] = soft[a + 1];
                memcpy(row[a], row[a + 1], sizeof row[a]);
            }
            if (!size) break;
        }
        for (long k = 0; k < n; k++) {
            y[k] = y0[k];
            for (long a = 0; a < size; a++) y[k] -= lambda[a] * row[a][k];
        }
    }
    return 0;
}

/* Where x (n) moves the tool backward, as where one joint brakes at its limit and others cannot as fast: move it within the bounds by the
   least multiple of f = Jᵀ V / |V| that ends this. Rows of folds and obstacles come first. It fades where |f| falls to LOST. */
static void keep_forward(const Servo *servo, const Work *w, double *x) {
    double f[MOST], moved[MOST], row[MOST], begin = 0, end = 0, alone = INFINITY;
    if (!(w->size > 1e-9)) return;
    for (long i = 0; i < w->n; i++) {
        f[i] = 0;
        for (long k = 0; k < w->m; k++) f[i] += w->W[k] / w->size * w->J[k][i];
    }
    double rate = dot(w->n, f, x), wanted = rate * clip((ALONG - sqrt(dot(w->n, f, f))) / (ALONG - LOST), 0, 1);
    if (!(rate < wanted)) return;
    for (long i = 0; i < w->n; i++) /* the multiple at which all joints are at their bounds, or a joint without bounds is enough */
        if (fabs(f[i]) > 1e-9) {
            double far = ((f[i] > 0 ? w->high[i] : w->low[i]) - x[i]) / f[i];
            if (isinf(far)) alone = least(alone, (wanted - rate) / (f[i] * f[i]));
            else end = most(end, far);
        }
    if (!isinf(alone)) end = alone;
    for (int halving = 0; halving < 50; halving++) {
        double t = halving ? (begin + end) / 2 : end;
        for (long i = 0; i < w->n; i++) moved[i] = clip(x[i] + t * f[i], w->low[i], w->high[i]);
        if (dot(w->n, f, moved) >= wanted) end = t;
        else begin = t;
    }
    for (long c = 0; c < w->guards + servo->pairs; c++) {
        double bound = row_of(servo, w, c, row);
        if (bound > -1e12 && dot(w->n, row, moved) < least(bound, dot(w->n, row, x)) - 1e-9) return;
    }
    memcpy(x, moved, (size_t)w->n * sizeof *x);
}

/* The share of the command that x (n) follows. */
static double followed_by(const Work *w, const double *x) {
    double sum = 0;
    for (long k = 0; k < w->m; k++) sum += w->W[k] * dot(w->n, w->J[k], x);
    return w->size > 1e-9 ? sum / (w->size * w->size) : 1;
}

/* Where the rows of folds move the tool backward, as where they appear too late to stop in time, they give way until it does not. */
static void relieve(const Servo *servo, Work *w, double *x, double *force) {
    double without[MOST], other[MOST + 1], with = followed_by(w, x);
    long guards = w->guards;
    if (with >= -BACKWARD) return;
    w->guards = 0;
    double more = nearest_point(servo, w, without, other) ? followed_by(w, without) - with : 0;
    w->guards = guards;
    if (!(more > 0)) return;
    double t = least((-BACKWARD - with) / more, 1);
    for (long i = 0; i < w->n; i++) x[i] += t * (without[i] - x[i]);
    for (long i = 0; i <= w->n; i++) force[i] += t * (other[i] - force[i]);
}

/* The velocities from which a joint can brake before its limits with a share of its acceleration. */
static void braking_bounds(const Servo *servo, long j, double *low, double *high) {
    double T = duration(servo), force = BRAKING * servo->acceleration[j], speed = servo->velocity[j];
    *low = clip(-stopping(servo->q[j] - servo->lower[j], force, T), -speed, speed);
    *high = clip(stopping(servo->upper[j] - servo->q[j], force, T), -speed, speed);
}

/* Of the joints in w->joint: solve (1); the others move by `fixed` (joints). Writes q̇ (joints). */
static int solve(Servo *servo, Work *w, const double *fixed, double *velocity, double *force) {
    long n = w->n, m = servo->world_rows + servo->tool_rows, joints = servo->joints;
    double x[MOST], part[MOST + 1];
    w->m = m, w->r = n < m ? n : m;
    for (long k = 0; k < m; k++) {
        const double *row = servo->rows[k];
        w->W[k] = dot(6, servo->wrench[k], servo->twist) - dot(joints, row, fixed);
        for (long i = 0; i < n; i++) w->J[k][i] = row[w->joint[i]];
    }
    for (long i = 0; i < n; i++) {
        long j = w->joint[i];
        braking_bounds(servo, j, &w->low[i], &w->high[i]);
        w->low[i] = clip(w->low[i], servo->low[j], servo->high[j]), w->high[i] = clip(w->high[i], servo->low[j], servo->high[j]);
    }
    w->size = sqrt(dot(m, w->W, w->W));
    w->wall = 0, w->guards = 0, w->leaves = 0, w->kind = CLEAR, w->worst = w->r - 1, w->seconds = INFINITY;
    w->has_inside = servo->side != ANY && servo->has_inside, w->has_way = servo->side != ANY && servo->has_way;
    for (long i = 0; i < n; i++) w->inside[i] = servo->inside[w->joint[i]], w->way[i] = servo->way[w->joint[i]];
    memset(w->reverses, 0, sizeof w->reverses);
    memcpy(velocity, fixed, (size_t)joints * sizeof *velocity);
    memset(force, 0, (size_t)(joints + 1) * sizeof *force);
    if (is_far(servo, w, x)) {
        for (long i = 0; i < n; i++) velocity[w->joint[i]] = x[i];
        w->far = 1;
        return 1;
    }
    w->far = 0;
    decompose(w, servo);
    for (long k = 0; k < w->r; k++) {
        w->b[k] = dot(m, w->U[k], w->W);
        w->w[k] = most(w->s[k], EPSILON);
    }
    if (n > w->r) drive_null_space(servo, w);
    singular_rates(servo, w);
    escape(servo, w);
    int solved = nearest_point(servo, w, x, part);
    if (solved && w->guards) relieve(servo, w, x, part);
    for (long i = 0; i < n; i++) x[i] = clip(x[i], w->low[i], w->high[i]), force[w->joint[i]] = part[i];
    keep_forward(servo, w, x);
    for (long i = 0; i < n; i++) velocity[w->joint[i]] = x[i];
    force[joints] = part[n];
    return solved;
}

/* The multipliers (joints) of the bounds in (1), without those of the accelerations; where there are none, `force`. */
static void push_in_the_end(const Servo *servo, const Work *w, const double *force, double *pushed) {
    double x[MOST], part[MOST + 1];
    Work slow = *w;
    memcpy(pushed, force, (size_t)servo->joints * sizeof *pushed);
    for (long i = 0; i < w->n; i++) braking_bounds(servo, w->joint[i], &slow.low[i], &slow.high[i]);
    if (w->far || !nearest_point(servo, &slow, x, part)) return;
    for (long i = 0; i < w->n; i++) pushed[w->joint[i]] = part[i];
}

/* Whether a joint stands at the limit to which a force pushes it; for no force at any of its limits. */
static int stands(const Servo *servo, long j, double force) {
    double rest = AT_REST * least(servo->velocity[j], 1), near = 4 * rest * servo->slowest;
    int above = servo->high[j] <= rest && servo->upper[j] - servo->q[j] <= near;
    int below = servo->low[j] >= -rest && servo->q[j] - servo->lower[j] <= near;
    return (force >= 0 && above) || (force <= 0 && below);
}

static int is_pushed(const Servo *servo, long j, double force) { return force != 0 && stands(servo, j, force); }

/* The share of a command (m) that is followed along it, and the part across it. */
static void compare(Servo *servo, long m, const double *command, const double *rate) {
    double size = sqrt(dot(m, command, command)), along_it = size > 0 ? dot(m, rate, command) / size : 0, across = 0;
    for (long k = 0; k < m && size > 0; k++) {
        double part = rate[k] - along_it * command[k] / size;
        across += part * part;
    }
    servo->speed = size;
    servo->followed = size > 0 ? along_it / size : 1;
    servo->slip = size > 0 ? sqrt(across) / size : 0;
}

/* What limits the step of the joints in w->joint: the bound or row that pushes most. */
static void find_limit(Servo *servo, const Work *w, const double *force) {
    double largest = force[servo->joints];
    servo->limit = largest > 0 ? OBSTACLE : NOTHING, servo->limit_joint = -1;
    for (long i = 0; i < w->n; i++) {
        long j = w->joint[i];
        if (fabs(force[j]) <= largest) continue;
        largest = fabs(force[j]);
        double bound = force[j] > 0 ? w->high[i] : -w->low[i], before = force[j] > 0 ? servo->qd[j] : -servo->qd[j];
        double gain = servo->acceleration[j] * duration(servo), speed = servo->velocity[j];
        servo->limit_joint = j;
        servo->limit = bound >= speed * (1 - 1e-9) ? VELOCITY : bound >= before + gain - 1e-9 * gain ? ACCELERATION : POSITION;
    }
}

/* Joint velocities for the twist, and the next singularity in its direction. */
static int follow_twist(Servo *servo, double *velocity) {
    Work whole, free, *w = &whole;
    long joints = servo->joints;
    double force[MOST + 1], pushed[MOST + 1], fixed[MOST] = {0}, rate[ROWS], command[ROWS], guess[36];
    whole.n = free.n = 0;
    for (long j = 0; j < joints; j++) { /* joints that do not carry the tool brake */
        int carries = 0;
        for (long p = 0; p < servo->physical; p++)
            for (int a = 0; a < 6; a++) carries |= servo->leader[p] == j && servo->columns[6 * p + a] != 0;
        if (carries) whole.joint[whole.n++] = j;
        else fixed[j] = clip(0, servo->low[j], servo->high[j]);
    }
    if (servo->knots) find_planned(servo);
    int solved = solve(servo, w, fixed, velocity, force);
    memcpy(command, w->W, sizeof command);
    /* a joint that stands at its limit and is pushed on takes its column out of J: again for the others, until none of these is */
    memcpy(guess, servo->guess, sizeof guess);
    for (int turn = 0, known = 0; solved; turn++) {
        long left = 0;
        for (long i = 0; i < w->n; i++) {
            long j = w->joint[i];
            if (is_pushed(servo, j, force[j])) servo->stays[j] = STAYING;
            else if (!turn && !stands(servo, j, 0)) servo->stays[j] = 0;
            else if (!turn && servo->stays[j] > 0) { /* braking joints may hide for a moment that the law pushes it */
                if (!known) known = 1, push_in_the_end(servo, w, force, pushed);
                if (!is_pushed(servo, j, pushed[j])) servo->stays[j] -= duration(servo);
            }
            if (servo->stays[j] > 0) fixed[j] = clip(0, servo->low[j], servo->high[j]);
            else free.joint[left++] = j;
        }
        if (left == w->n || !left) break;
        free.n = left, w = &free;
        solved = solve(servo, w, fixed, velocity, pushed);
        memcpy(servo->guess, guess, sizeof guess);
        for (long i = 0; i < left; i++) force[free.joint[i]] = pushed[free.joint[i]];
        force[joints] = pushed[joints];
    }
    for (long i = 0; i < w->n; i++) servo->inside[w->joint[i]] = w->inside[i], servo->way[w->joint[i]] = w->way[i];
    servo->has_inside = w->has_inside, servo->has_way = w->has_way, servo->leaves = w->leaves;
    memcpy(servo->reverses, w->reverses, sizeof servo->reverses);
    if (!solved) return 0;
    for (long k = 0; k < w->m; k++) rate[k] = dot(joints, servo->rows[k], velocity);
    compare(servo, w->m, command, rate);
    find_limit(servo, &whole, force);
    servo->smallest = w->s[w->r - 1], servo->kind = w->kind, servo->seconds = w->seconds;
    servo->wall = w->size > 0 ? sqrt(least(w->wall, w->size * w->size)) / w->size : 0;
    if (w->kind == CLEAR && servo->smallest < SMALL && w->size > 0) {
        double slope[MOST], approach = 0;
        slope_of(servo, w, w->U[w->r - 1], w->V[w->r - 1], slope);
        for (long i = 0; i < w->n; i++) approach -= slope[i] * velocity[w->joint[i]];
        servo->kind = POLE;
        if (approach > 1e-9) servo->seconds = servo->smallest / approach;
    }
    servo->metres = isinf(servo->seconds) ? INFINITY : servo->seconds * sqrt(dot(3, servo->twist, servo->twist));
    if (servo->kind != CLEAR) {
        double largest = 0;
        for (long i = 0; i < w->n; i++)
            if (fabs(w->V[w->worst][i]) > largest + 1e-9) largest = fabs(w->V[w->worst][i]), servo->joint = w->joint[i];
    }
    return 1;
}

/* Joint velocities nearest to the commanded ones. */
static int follow_joints(Servo *servo, double *velocity) {
    Work w = {.n = servo->joints};
    double force[MOST + 1];
    for (long j = 0; j < w.n; j++) {
        w.joint[j] = j, w.V[j][j] = 1, w.w[j] = 1, w.g[j] = servo->command[j];
        w.low[j] = servo->low[j], w.high[j] = servo->high[j];
    }
    if (!nearest_point(servo, &w, velocity, force)) return 0;
    for (long j = 0; j < w.n; j++) velocity[j] = clip(velocity[j], w.low[j], w.high[j]);
    compare(servo, w.n, servo->command, velocity);
    find_limit(servo, &w, force);
    return 1;
}

static int all_below(long n, const double *values, double most) {
    for (long i = 0; i < n; i++)
        if (!(fabs(values[i]) < most)) return 0;
    return 1;
}

static int all_finite(long n, const double *values) { return all_below(n, values, 1e12); }

/* Whether three rows (or columns) of three numbers, `apart` from each other, are a rotation but for rounding. */
static int is_rotation(const double *m, int apart) {
    double across[3];
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++)
            if (fabs(dot(3, m + apart * a, m + apart * b) - (a == b)) > ROUNDED) return 0;
    cross(m, m + apart, across);
    return dot(3, across, m + 2 * apart) > 0.5;
}

/* Whether all moving obstacles (18 numbers each: rotation, position, linear and angular velocity) can be ones. */
static int obstacles_are_sound(const Servo *servo) {
    if (!all_finite(18 * servo->moving, servo->obstacles)) return 0;
    for (long k = 0; k < servo->moving; k++)
        if (!is_rotation(servo->obstacles + 18 * k, 3)) return 0;
    return 1;
}

/* The rotation vector that turns unit vector a into b, the shortest one. */
static void turn_between(const double *a, const double *b, double *vector) {
    double across[3], sine, angle;
    cross(a, b, across);
    sine = sqrt(dot(3, across, across)), angle = atan2(sine, dot(3, a, b));
    if (sine < 1e-9) { /* about any axis across */
        double unit[3] = {0};
        unit[fabs(a[0]) < 0.6 ? 0 : 1] = 1;
        cross(a, unit, across);
        sine = sqrt(dot(3, across, across));
    }
    for (int i = 0; i < 3; i++) vector[i] = across[i] * angle / sine;
}

/* The rotation vector in world axes that brings the tool to a pose (4, 4), but for the rotations that are free. */
static void turn_toward(const Servo *servo, const double *P, double *vector) {
    const double *R = servo->rotation, *axis = servo->free_axis;
    double turn[9], across[3], sine, here[3], there[3], local[3];
    vector[0] = vector[1] = vector[2] = 0;
    if (servo->free_turns == EVERY_TURN) return;
    if (servo->free_turns != NO_TURN) {
        for (int a = 0; a < 3; a++) local[a] = P[a] * axis[0] + P[4 + a] * axis[1] + P[8 + a] * axis[2]; /* Pᵀ axis */
        if (servo->free_turns == ABOUT_TOOL) memcpy(local, axis, sizeof local);
        for (int a = 0; a < 3; a++) here[a] = R[a] * local[0] + R[3 + a] * local[1] + R[6 + a] * local[2];
        for (int a = 0; a < 3; a++) there[a] = servo->free_turns == ABOUT_TOOL ? dot(3, P + 4 * a, axis) : axis[a];
        turn_between(here, there, vector);
        return;
    }
    for (int a = 0; a < 3; a++) /* P Rᵀ */
        for (int b = 0; b < 3; b++) turn[3 * a + b] = P[4 * a] * R[b] + P[4 * a + 1] * R[3 + b] + P[4 * a + 2] * R[6 + b];
    across[0] = (turn[7] - turn[5]) / 2, across[1] = (turn[2] - turn[6]) / 2, across[2] = (turn[3] - turn[1]) / 2;
    sine = sqrt(dot(3, across, across));
    double cosine = (turn[0] + turn[4] + turn[8] - 1) / 2, angle = atan2(sine, cosine);
    if (sine > 1e-9)
        for (int a = 0; a < 3; a++) vector[a] = across[a] * angle / sine;
    else if (cosine < 0) /* a half turn: about the axis with the largest entry of (P Rᵀ + 1) / 2 */
        for (int a = 0, top = turn[0] >= turn[4] ? (turn[0] >= turn[8] ? 0 : 2) : turn[4] >= turn[8] ? 1 : 2; a < 3; a++)
            vector[a] = angle * ((turn[3 * a + top] + (a == top)) / 2) / sqrt((turn[4 * top] + 1) / 2);
}

/* The deceleration with which the tool stops along a twist (6) whose size is 1: at most APPROACH, and that of the joints' least
   motion y = Jᵀ (JJᵀ)⁻¹ b, which slows down in proportion, with the share STOPPING of their acceleration. */
static double deceleration_along(const Servo *servo, const double *twist) {
    long m = servo->world_rows + servo->tool_rows;
    const double (*J)[16] = servo->rows;
    double L[ROWS][ROWS], u[ROWS], slowest = APPROACH;
    for (long a = 0; a < m; a++) { /* L Lᵀ = JJᵀ + DAMPED, L u = b */
        u[a] = dot(6, servo->wrench[a], twist);
        for (long b = 0; b <= a; b++) {
            double sum = dot(servo->joints, J[a], J[b]) + (a == b ? DAMPED : 0) - dot(b, L[a], L[b]);
            L[a][b] = a == b ? sqrt(sum) : sum / L[b][b];
        }
        u[a] = (u[a] - dot(a, L[a], u)) / L[a][a];
    }
    for (long a = m - 1; a >= 0; a--) {
        for (long b = a + 1; b < m; b++) u[a] -= L[b][a] * u[b];
        u[a] /= L[a][a];
    }
    for (long j = 0; j < servo->joints; j++) {
        double y = 0;
        for (long a = 0; a < m; a++) y += J[a][j] * u[a];
        slowest = least(slowest, STOPPING * servo->acceleration[j] / most(fabs(y), 1e-9));
    }
    return slowest;
}

/* The twist (6) in world axes that brings the tool to a pose, no faster than it can stop there, also where the command is smoothed.
   It comes to rest from states that are a step or two old, too. Returns 0 for no pose. */
static int toward_pose(const Servo *servo, double *twist) {
    const double *P = servo->pose;
    if (!all_finite(16, P) || !is_rotation(P, 4)) return 0;
    for (int a = 0; a < 4; a++)
        if (fabs(P[12 + a] - (a == 3)) > ROUNDED) return 0;
    for (int a = 0; a < 3; a++) twist[a] = P[4 * a + 3] - servo->origin[a];
    turn_toward(servo, P, twist + 3);
    double size = sqrt(dot(3, twist, twist) + LENGTH * LENGTH * dot(3, twist + 3, twist + 3));
    if (!(size > 1e-12)) size = 1; /* there is nothing left */
    for (int a = 0; a < 6; a++) twist[a] /= size;
    double speed = least(FASTEST, stopping(size, deceleration_along(servo, twist), LAGS * (duration(servo) + servo->smoothing)));
    for (int a = 0; a < 6; a++) twist[a] *= speed;
    return 1;
}

/* The commanded twist in world axes; returns how the command is. */
static long read_command(Servo *servo) {
    double T = duration(servo), share = servo->smoothing > 0 ? 1 - exp(-T / servo->smoothing) : 1;
    servo->age = servo->fresh ? 0 : servo->age + T;
    if (servo->mode == TWIST && servo->frame == OTHER_AXES && !is_rotation(servo->axes, 3)) return BAD_COMMAND;
    if (servo->fresh && servo->mode == POSE) {
        if (!toward_pose(servo, servo->held)) return BAD_COMMAND;
    } else if (servo->fresh) {
        const double *axes = servo->frame == TOOL ? servo->rotation : servo->axes; /* both stored by columns */
        if (!all_below(6, servo->command, LARGEST)) return BAD_COMMAND;
        for (int half = 0; half < 6; half += 3)
            for (int a = 0; a < 3; a++) {
                servo->held[half + a] = servo->command[half + a];
                if (servo->frame != WORLD) servo->held[half + a] = axes[a] * servo->command[half] + axes[3 + a] * servo->command[half + 1] + axes[6 + a] * servo->command[half + 2];
            }
    } else if (servo->age > servo->timeout) return STALE;
    for (int a = 0; a < 6; a++) servo->twist[a] = servo->filtered[a] += share * (servo->held[a] - servo->filtered[a]);
    return FOLLOWING;
}

static void forget(Servo *servo) {
    memset(servo->filtered, 0, sizeof servo->filtered);
    memset(servo->held, 0, sizeof servo->held);
    memset(servo->stays, 0, sizeof servo->stays);
    memset(servo->inside, 0, sizeof servo->inside);
    memset(servo->way, 0, sizeof servo->way);
    memset(servo->reverses, 0, sizeof servo->reverses);
    servo->guessed = servo->has_inside = servo->has_way = servo->leaves = servo->placed = 0;
    servo->age = INFINITY; /* there is no command until a new one comes */
}

/* One step: joint velocities (joints) in `result`, and what a teleoperator wants to know about them. It keeps all limits. */
void manipplan_servo(Servo *servo) {
    long joints = servo->joints;
    double velocity[MOST] = {0}, T;
    servo->speed = servo->wall = servo->slip = 0, servo->followed = 1, servo->seconds = servo->metres = INFINITY, servo->smallest = NAN;
    servo->kind = CLEAR, servo->limit = NOTHING, servo->joint = servo->limit_joint = -1, servo->status = FOLLOWING;
    if (servo->problem) servo->problem(servo->argument, servo->results, servo->integers, servo->work, 0);
    T = duration(servo);
    servo->clearance = INFINITY;
    for (long k = 0; k < servo->pairs; k++) servo->clearance = least(servo->clearance, servo->distance[k]);
    if (!all_finite(joints, servo->q) || !all_finite(joints, servo->qd) || !all_finite(6 * servo->physical, servo->columns)) {
        memset(servo->result, 0, sizeof servo->result);
        memset(servo->qdd, 0, sizeof servo->qdd);
        forget(servo);
        servo->status = BAD_STATE;
        return;
    }
    int sound = obstacles_are_sound(servo);
    if (!(servo->dt > 0 && servo->dt <= servo->slowest * (1 + 1e-9))) servo->status = BAD_TIME_STEP;
    else if (servo->mode == BRAKE) forget(servo);
    else if (servo->mode == JOINTS) {
        forget(servo); /* a jog ends a stream of twists, and may lead to the other side of a singularity */
        if (!sound || !all_below(joints, servo->command, LARGEST)) servo->status = BAD_COMMAND;
        else if (!follow_joints(servo, velocity)) servo->status = NOT_SOLVED;
    } else {
        read_rows(servo);
        servo->status = sound ? read_command(servo) : BAD_COMMAND;
        if (servo->status == FOLLOWING && !follow_twist(servo, velocity)) servo->status = NOT_SOLVED;
    }
    for (long j = 0; j < joints; j++)
        if (isnan(velocity[j]) || isinf(velocity[j])) servo->status = NOT_SOLVED;
    if (servo->status != FOLLOWING) { /* braking: the velocity nearest to zero within the bounds */
        if (servo->status != NOT_SOLVED) forget(servo);
        memset(velocity, 0, sizeof velocity);
        servo->followed = 0;
    }
    for (long j = 0; j < joints; j++) {
        servo->result[j] = clip(velocity[j], servo->low[j], servo->high[j]);
        servo->qdd[j] = T > 0 ? (servo->result[j] - servo->qd[j]) / T : 0;
    }
}
