/* Bounds on the motion of bodies when joints move, see path_clearance.py. All arrays belong to the caller. */

#include <math.h>
#include <string.h>

enum { CORE_POINTS = 8, MOST_JOINTS = 64 };  /* as in path_clearance.py */

typedef struct {
    long n;                 /* number of joints */
    const long *before;     /* (n) the joint before each; 0: the world */
    const long *carries;    /* (n + 1, n + 1) [i, j]: whether joint j carries joint i, or is it */
    const double *fixed;    /* (n, 12) rotation and origin of each joint in the frame of the joint before it, at q = 0 */
    const double *axes;     /* (n, 3) axis in the joint's frame */
    const long *slides;     /* (n) whether the joint is prismatic */
    long bodies;            /* number of bodies */
    const long *joint;      /* (bodies) the joint that carries each; 0: the world */
    const double *points;   /* (bodies, CORE_POINTS, 3) in the joint's frame */
    const double *radii;    /* (bodies) around the points */
    const long *body;       /* (pairs) the body of each pair whose joint has the higher number */
    const long *below;      /* (pairs) the joint of the other body */
    double *moved;          /* (bodies, n + 1) work: the motion by all joints from each to the body */
    double *lever;          /* (bodies, n + 1) work: the largest speed of a point of the body by each joint; no entry 0 */
    long *row;              /* (bodies) work: where `moved` was computed */
} Arm;

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* Rotation a times b, both (3, 3) by rows. */
static void turn(const double *a, const double *b, double *out) {
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) out[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
}

static void act(const double *frame, const double *p, double *out) {
    for (int i = 0; i < 3; i++) out[i] = dot(frame + 3 * i, p) + frame[9 + i];
}

/* Rotation and origin of each joint (n + 1, 12) and its axis (n + 1, 3), in the world. */
static void place(const Arm *arm, const double *q, double (*frame)[12], double (*axis)[3]) {
    static const double still[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    memcpy(frame[0], still, sizeof still);
    for (long j = 0; j < arm->n; j++) {
        const double *a = arm->axes + 3 * j, *fixed = arm->fixed + 12 * j;
        double *own = frame[j + 1], before[9];
        turn(frame[arm->before[j]], fixed, before);
        act(frame[arm->before[j]], fixed + 9, own + 9);
        for (int i = 0; i < 3; i++) axis[j + 1][i] = dot(before + 3 * i, a);
        if (arm->slides[j]) {
            memcpy(own, before, sizeof before);
            for (int i = 0; i < 3; i++) own[9 + i] += q[j] * axis[j + 1][i];
            continue;
        }
        double s = sin(q[j]), c = cos(q[j]), k = 1 - c;
        double about[9] = {c + k * a[0] * a[0],        k * a[0] * a[1] - s * a[2], k * a[0] * a[2] + s * a[1],
                           k * a[1] * a[0] + s * a[2], c + k * a[1] * a[1],        k * a[1] * a[2] - s * a[0],
                           k * a[2] * a[0] - s * a[1], k * a[2] * a[1] + s * a[0], c + k * a[2] * a[2]};
        turn(before, about, own);
    }
}

/* The largest distance of the points (CORE_POINTS, 3) from an axis. */
static double reach(const double (*point)[3], const double *origin, const double *axis) {
    double most = 0;
    for (int k = 0; k < CORE_POINTS; k++) {
        double lever[3] = {point[k][0] - origin[0], point[k][1] - origin[1], point[k][2] - origin[2]}, along = dot(lever, axis);
        most = fmax(most, dot(lever, lever) - along * along);
    }
    return sqrt(most);
}

/* The largest speed of a point of a body by joint j, after the joints nearer to the body have moved it by `moved`; kept in `lever`. */
static double lever_of(const Arm *arm, long body, long j, double (*frame)[12], double (*axis)[3], double (*point)[3], double moved,
                       double *lever) {
    lever[j] = 1;
    if (!arm->slides[j - 1])
        lever[j] = reach((const double (*)[3])point, frame[j] + 9, axis[j]) + arm->radii[body] + moved;
    return lever[j];
}

/* The joints between the two bodies of a pair, from the second, whose joint has the lower number, to the first; returns their
   number. Those that carry only the second, the last one first, come before those that carry only the first; of the latter are
   `own`. */
static long between(const Arm *arm, long pair, long *way, long *own) {
    long n = arm->n, first = arm->joint[arm->body[pair]], second = arm->below[pair], count = 0;
    for (long j = second; !arm->carries[first * (n + 1) + j]; j = arm->before[j - 1]) way[count++] = j;
    *own = count;
    for (long j = 1; j <= first; j++)
        if (arm->carries[first * (n + 1) + j] && !arm->carries[second * (n + 1) + j]) way[count++] = j;
    *own = count - *own;
    return count;
}

/* Upper bound on the acceleration of a point of the first body of a pair in the frame of the other's joint, with the joints between
   the two, for joints with at most these speeds and accelerations (n): (3) in path_clearance.py. */
static double acceleration(const Arm *arm, const long *way, long count, const double *lever, const double *speed,
                           const double *change) {
    double sum = 0, turning = 0;
    for (long k = 0; k < count; k++) {
        long j = way[k];
        double v = speed[j - 1], own = arm->slides[j - 1] ? 0 : v;
        sum += lever[j] * (v * (own + 2 * turning) + change[j - 1]);
        turning += own;
    }
    return sum;
}

/* Upper bounds (e) on the motion of the two bodies of pairs (e) towards each other, for joints that move at most change (m, n)
   from q (m, n); rows (e) say from which. Rows that follow each other and are equal share their work. With speeds and
   accelerations (m, n) of the joints also upper bounds (e) on the accelerations of the bodies' points; both may be 0. */
void manipplan_motion_bounds(const Arm *arm, const double *q, const double *change, const double *speeds, const double *accelerations,
                      const long *rows, const long *pairs, long e, double *out, double *bends) {
    double frame[MOST_JOINTS + 1][12], axis[MOST_JOINTS + 1][3], point[CORE_POINTS][3];
    long n = arm->n, here = -1, way[MOST_JOINTS], own;
    for (long k = 0; k < e; k++) {
        long body = arm->body[pairs[k]], joint = arm->joint[body];
        double *moved = arm->moved + body * (n + 1), *lever = arm->lever + body * (n + 1);
        if (rows[k] != here) {
            here = rows[k];
            place(arm, q + here * n, frame, axis);
            for (long b = 0; b < arm->bodies; b++) arm->row[b] = -1;
        }
        long count = between(arm, pairs[k], way, &own), others = count - own, known = arm->row[body] == here;
        if (!known || others)
            for (int p = 0; p < CORE_POINTS; p++) act(frame[joint], arm->points + 3 * (CORE_POINTS * body + p), point[p]);
        if (!known) {
            moved[joint] = 0;
            for (long j = joint; j > 0; j = arm->before[j - 1])
                moved[arm->before[j - 1]] = moved[j] + change[here * n + j - 1] * lever_of(arm, body, j, frame, axis, point, moved[j], lever);
            arm->row[body] = here;
        }
        out[k] = moved[own ? arm->before[way[others] - 1] : joint];
        for (long i = others - 1; i >= 0; i--)
            out[k] += change[here * n + way[i] - 1] * lever_of(arm, body, way[i], frame, axis, point, out[k], lever);
        if (bends) bends[k] = acceleration(arm, way, count, lever, speeds + here * n, accelerations + here * n);
    }
}
