/* Distances between the bodies of an arm, and between them and obstacles.

   A shape is a convex core with a radius around it; the distance of two shapes is that of their cores minus both radii. The
   distance of two cores comes from the algorithm of Gilbert, Johnson and Keerthi (GJK): each step gives a point of the
   difference of the two (an upper bound) and a separating direction (a lower bound), so that every answer is proven. Where cores overlap, the
   expanding
   polytope algorithm gives the depth, with the same two bounds.

   Obstacles are in a tree of axis-parallel boxes. Each mesh and each point cloud has a tree of its triangles or points in the frame
   of its joint, so that it may move; two of them are compared by going down both trees. The signed distance of surfaces that
   overlap is minus the largest depth of two parts that do. A closed surface is solid: of what is wholly inside, the signed distance
   is minus that from the surface. All arrays belong to the caller. Vectors are in metres. */

#include <math.h>
#include <string.h>

enum { POINTS, BOX, CYLINDER, HALFSPACE, SURFACE, UNKNOWN };
enum { FREE, TOUCHING, UNDECIDED };
enum { GUESS = 22 };        /* see `guess` */
enum { MOST_PLANES = 16 };  /* of a fence; see there */

typedef struct {
    long n;                 /* number of joints */
    long entries;               /* length of q: joints that follow others have no entry there */
    const long *leader;     /* (n) the entry of q that moves each joint */
    const double *ratio, *offset; /* (n) its position is ratio * q[leader] + offset */
    const long *before;     /* (n) the joint before each; 0: the world */
    const long *carries;    /* (n + 1, n + 1) [i, j]: whether joint j carries joint i, or is it */
    const double *fixed;    /* (n, 12) rotation and origin of each joint in the frame of the joint before it, at q = 0 */
    const double *axes;     /* (n, 3) axis in the joint's frame */
    const long *slides;     /* (n) whether the joint is prismatic */
    long bodies;            /* number of shapes */
    const long *joint;      /* joint that carries each; 0: the world */
    const long *kind;
    const long *first;      /* POINTS: its first core point; SURFACE: its first leaf */
    const long *count;      /* and their number */
    const double *radius;
    const double *pose;     /* (bodies, 12) of the core in the joint's frame: BOX, CYLINDER, HALFSPACE */
    const double *size;     /* (bodies, 3) half sides; radius and half length; SURFACE: whether it is closed */
    const double *ball;     /* (bodies, 4) centre in the joint's frame, and radius of a ball around the shape */
    const double *local;    /* (bodies, 6) least and largest corner of a box around the shape in the joint's frame */
    const double *x, *y, *z;/* core points in the joint's frame */
    const long *self;       /* (pairs of moving bodies, 3) two bodies and the number of the pair, sorted by their joints */
    long blocks;            /* pairs of joints whose bodies are checked against each other */
    const long *block;      /* (blocks, 4) two joints, the first of their pairs in `self`, and number of pairs */
    const double *block_ball; /* (blocks, 8) for each of the joints, in its frame, a ball around these bodies */
    long movers;            /* bodies that are checked against the tree */
    const long *mover;
    const long *pair_of;    /* (movers, bodies) number of the pair; -1: not checked */
    long groups;            /* movers of one joint, one after another */
    const long *group;      /* (groups, 3) joint, first mover, number of movers */
    const double *group_ball; /* (groups, 4) centre in the joint's frame, and radius of a ball around them */
    long pairs;             /* number of pairs */
    long top;               /* root of the tree of obstacles; -1: there is none */
    const double *node_box; /* (nodes, 6) least and largest corner */
    const long *node;       /* (nodes, 2) children; a leaf has -1 and the obstacle or, below a surface, its leaf */
    const long *root;       /* (bodies) root of a surface's tree */
    const double *corners;  /* (leaves, 9) triangles; a point has three equal corners */
    const double *leaf_x, *leaf_y, *leaf_z; /* (leaves, 3) the same by axis; leaves below a node follow each other */
    const long *probes;     /* (bodies, 2) SURFACE: first probe and their number */
    const double *probe;    /* (probes, 3) a point of each connected part of a surface, in the joint's frame */
    double *frames;         /* (n + 1, 12) work: rotation and origin of each joint in the world */
    double *centres;        /* (bodies, 3) work: centre of each ball in the world */
    double *least;          /* (pairs) work: distances found at a configuration, infinite between calls */
    long *found;            /* (pairs) work: the pairs of which one was found */
    double *guess;          /* (pairs, GUESS) work: direction between each pair at the configuration before, of surfaces that move
                               1 + the number of the nearest leaf of each; zero: none is known. Of convex bodies the number of
                               corners of the last simplex follows, and for each the points of both cores in their frames */
} World;

typedef struct {
    long kind, count;
    const double *x, *y, *z;
    const double *frame;    /* of the joint: POINTS; of the core: BOX, CYLINDER */
    const double *size;
    double own[12];
} Core;

static const double EXACT = 1e-11;   /* gap between the bounds at which a distance is found [m] */
static const double EXACTEST = 1e-15; /* the same where the direction counts, too [m] */
static const double EXACT_DEPTH = 1e-10; /* the same of depths; those of polytopes are exact [m] */
static const double MEETING = 1e-10; /* cores nearer than this meet [m] */
static const double APART = 1e-6;    /* the direction between cores nearer than this is not exact [m] */
static const double FLAT = 1e-13;    /* a polytope's corner this little in front of a face is on it [m] */
static const double LEAST_AREA = 1e-18; /* smallest area of two of its faces [m²] */
static const double CLOSER = 1e-10;  /* of two surfaces, leaves that are nearer by less than this are not looked at [m] */
static const double LEAVES_APART = 5e-3;   /* of leaves whose nearest points differ by less only the nearest is listed [m] */
static const double TINY = 3e-7;     /* largest side, along each axis, of a triangle that counts as a point [m] */
static const double PARALLEL = 1e-20; /* square of the sine of the angle between edges that are parallel */
static const long FEW = 32, LEAST_PAIRS = 64; /* hulls of so few leaves of moving surfaces, and of so many pairs of them, are compared */
static const int LEVELS = 3;         /* of a tree's levels, every which one is compared by its boxes */
static const int MOST_STEPS = 300;   /* cylinders converge slowly; polytopes need about ten steps */

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void cross(const double *a, const double *b, double *out) {
    for (int i = 0; i < 3; i++) out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static void act(const double *frame, const double *p, double *out) {
    for (int i = 0; i < 3; i++)
        out[i] = frame[3 * i] * p[0] + frame[3 * i + 1] * p[1] + frame[3 * i + 2] * p[2] + frame[9 + i];
}

static void turn_back(const double *frame, const double *v, double *out) {
    for (int i = 0; i < 3; i++) out[i] = frame[i] * v[0] + frame[3 + i] * v[1] + frame[6 + i] * v[2];
}

/* A point of the world in the coordinates of a frame. */
static void place_back(const double *frame, const double *p, double *out) {
    double gap[3] = {p[0] - frame[9], p[1] - frame[10], p[2] - frame[11]};
    turn_back(frame, gap, out);
}

static void compose(const double *a, const double *b, double *out) {
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            out[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
        out[9 + i] = a[3 * i] * b[9] + a[3 * i + 1] * b[10] + a[3 * i + 2] * b[11] + a[9 + i];
    }
}

/* Frame b in the coordinates of frame a. */
static void relative(const double *a, const double *b, double *out) {
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) out[3 * i + j] = a[i] * b[j] + a[3 + i] * b[3 + j] + a[6 + i] * b[6 + j];
    place_back(a, b + 9, out + 9);
}

static void place(const World *w, const double *q) {
    double *frames = w->frames;
    static const double still[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    memcpy(frames, still, sizeof still);
    for (long j = 0; j < w->n; j++) {
        const double *a = w->axes + 3 * j;
        double moved[12], at = w->ratio[j] * q[w->leader[j]] + w->offset[j];
        if (w->slides[j]) {
            memcpy(moved, still, sizeof still);
            for (int i = 0; i < 3; i++) moved[9 + i] = at * a[i];
        } else {
            double s = sin(at), c = cos(at), k = 1 - c;
            double turn[12] = {c + k * a[0] * a[0],        k * a[0] * a[1] - s * a[2], k * a[0] * a[2] + s * a[1],
                               k * a[1] * a[0] + s * a[2], c + k * a[1] * a[1],        k * a[1] * a[2] - s * a[0],
                               k * a[2] * a[0] - s * a[1], k * a[2] * a[1] + s * a[0], c + k * a[2] * a[2],
                               0, 0, 0};
            memcpy(moved, turn, sizeof turn);
        }
        double joint[12];
        compose(frames + 12 * w->before[j], w->fixed + 12 * j, joint);
        compose(joint, moved, frames + 12 * (j + 1));
    }
    for (long b = 0; b < w->bodies; b++)
        if (w->joint[b] > 0) act(frames + 12 * w->joint[b], w->ball + 4 * b, w->centres + 3 * b);
}

static void core_of(const World *w, long body, Core *core) {
    const double *frame = w->frames + 12 * w->joint[body];
    core->kind = w->kind[body];
    core->size = w->size + 3 * body;
    if (core->kind == POINTS) {
        long k = w->first[body];
        core->count = w->count[body], core->x = w->x + k, core->y = w->y + k, core->z = w->z + k, core->frame = frame;
    } else {
        compose(frame, w->pose + 12 * body, core->own);
        core->frame = core->own;
    }
}

/* The first of the core points that are farthest along d. Products and lanes of maxima are vectorised. */
static long farthest(const Core *core, const double *d) {
    enum { LANES = 8, RUN = 64 };
    const double *x = core->x, *y = core->y, *z = core->z;
    double best = -INFINITY, along[RUN];
    long first = 0;
    if (core->count < LANES / 2) {
        for (long k = 0; k < core->count; k++) {
            double own = d[0] * x[k] + d[1] * y[k] + d[2] * z[k];
            if (own > best) best = own, first = k;
        }
        return first;
    }
    for (long k = 0; k < core->count; k += RUN) {
        long run = core->count - k < RUN ? core->count - k : RUN, i = 0;
        double most[LANES];
        for (int l = 0; l < LANES; l++) most[l] = -INFINITY;
        for (; i < run; i++) along[i] = d[0] * x[k + i] + d[1] * y[k + i] + d[2] * z[k + i];
        for (; i % LANES; i++) along[i] = -INFINITY;
        for (long j = 0; j < i; j += LANES)
            for (int l = 0; l < LANES; l++) most[l] = along[j + l] > most[l] ? along[j + l] : most[l];
        double top = most[0];
        for (int l = 1; l < LANES; l++) top = most[l] > top ? most[l] : top;
        if (!(top > best)) continue;
        best = top;
        for (i = 0; along[i] != top; i++) {}
        first = k + i;
    }
    return first;
}

/* The point of a core that is farthest along v. */
static void support(const Core *core, const double *v, double *out) {
    double d[3], p[3];
    turn_back(core->frame, v, d);
    if (core->kind == POINTS) {
        long at = farthest(core, d);
        p[0] = core->x[at], p[1] = core->y[at], p[2] = core->z[at];
    } else if (core->kind == BOX) {
        for (int i = 0; i < 3; i++) p[i] = d[i] >= 0 ? core->size[i] : -core->size[i];
    } else {
        double across = sqrt(d[0] * d[0] + d[1] * d[1]), share = across > 0 ? core->size[0] / across : 0;
        p[0] = share * d[0], p[1] = share * d[1], p[2] = d[2] >= 0 ? core->size[1] : -core->size[1];
    }
    act(core->frame, p, out);
}

/* Corners of the difference of two cores, the points of the first core that they come from, and the point of their hull that is
   nearest to the origin. */
typedef struct { double point[4][3], first[4][3]; int count; double nearest[3]; } Simplex;

static void keep(Simplex *s, const int *chosen, int count) { /* `chosen` ascends */
    for (int i = 0; i < count; i++) {
        if (chosen[i] == i) continue;
        memcpy(s->point[i], s->point[chosen[i]], sizeof s->point[i]);
        memcpy(s->first[i], s->first[chosen[i]], sizeof s->first[i]);
    }
    s->count = count;
}

static void on_line(const double *a, const double *b, double t, double *out) {
    for (int i = 0; i < 3; i++) out[i] = a[i] + t * (b[i] - a[i]);
}

/* The point of the triangle a b c that is nearest to the origin, and the corners that span it (bits). */
static int of_triangle(const double *a, const double *b, const double *c, double *out) {
    double ab[3], ac[3];
    for (int i = 0; i < 3; i++) ab[i] = b[i] - a[i], ac[i] = c[i] - a[i];
    double d1 = -dot(ab, a), d2 = -dot(ac, a), d3 = -dot(ab, b), d4 = -dot(ac, b), d5 = -dot(ab, c), d6 = -dot(ac, c);
    if (d1 <= 0 && d2 <= 0) { memcpy(out, a, 3 * sizeof *a); return 1; }
    if (d3 >= 0 && d4 <= d3) { memcpy(out, b, 3 * sizeof *b); return 2; }
    if (d6 >= 0 && d5 <= d6) { memcpy(out, c, 3 * sizeof *c); return 4; }
    double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) { on_line(a, b, d1 / (d1 - d3), out); return 3; }
    double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) { on_line(a, c, d2 / (d2 - d6), out); return 5; }
    double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) { on_line(b, c, (d4 - d3) / (d4 - d3 + d5 - d6), out); return 6; }
    double whole = va + vb + vc;
    for (int i = 0; i < 3; i++) out[i] = a[i] + ab[i] * (vb / whole) + ac[i] * (vc / whole);
    return 7;
}

/* Move `nearest` to the point of the simplex that is nearest to the origin and drop the corners that do not span it.
   Returns whether the simplex contains the origin. */
static int reduce(Simplex *s) {
    static const int face[4][3] = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
    if (s->count == 1) { memcpy(s->nearest, s->point[0], sizeof s->nearest); return 0; }
    if (s->count == 2) {
        double ab[3];
        for (int i = 0; i < 3; i++) ab[i] = s->point[1][i] - s->point[0][i];
        double whole = dot(ab, ab), t = whole > 0 ? -dot(ab, s->point[0]) / whole : 0;
        if (t <= 0) { int one[] = {0}; keep(s, one, 1); memcpy(s->nearest, s->point[0], sizeof s->nearest); }
        else if (t >= 1) { int one[] = {1}; keep(s, one, 1); memcpy(s->nearest, s->point[0], sizeof s->nearest); }
        else on_line(s->point[0], s->point[1], t, s->nearest);
        return 0;
    }
    double best = INFINITY, found[3];
    int chosen[3] = {0, 1, 2}, bits = 7, inside = s->count == 4;
    for (int f = 0; f < (s->count == 3 ? 1 : 4); f++) {
        const double *a = s->point[face[f][0]], *b = s->point[face[f][1]], *c = s->point[face[f][2]];
        if (s->count == 4) {
            const double *other = s->point[6 - face[f][0] - face[f][1] - face[f][2]];
            double ab[3], ac[3], to[3];
            for (int i = 0; i < 3; i++) ab[i] = b[i] - a[i], ac[i] = c[i] - a[i], to[i] = other[i] - a[i];
            double normal[3] = {ab[1] * ac[2] - ab[2] * ac[1], ab[2] * ac[0] - ab[0] * ac[2], ab[0] * ac[1] - ab[1] * ac[0]};
            double origin = -dot(normal, a), fourth = dot(normal, to);
            if (fourth == 0) inside = 0;                   /* flat: the nearest face counts */
            else if (origin * fourth >= 0) continue;       /* the origin is on the inner side of this face */
            inside = 0;
        }
        double p[3];
        int which = of_triangle(a, b, c, p);
        double square = dot(p, p);
        if (square < best) { best = square, bits = which; memcpy(found, p, sizeof p); memcpy(chosen, face[f], sizeof chosen); }
    }
    if (s->count == 4 && inside) return 1;
    if (best == INFINITY) return 0;                        /* rounding: no face decides, nothing is gained */
    int kept[3], count = 0;
    for (int i = 0; i < 3; i++) if (bits >> i & 1) kept[count++] = chosen[i];
    keep(s, kept, count);
    memcpy(s->nearest, found, sizeof found);
    return 0;
}

/* A plane that has the first of two cores in front of it: normal · x >= level for all its points x. */
typedef struct { double normal[3], level; } Plane;

/* Bounds on the distance of two cores. Stops when the lower bound exceeds `enough`, the upper one is at most `little`, or both
   differ by at most `exact`.
   `towards` is a first guess of the direction from the second core to the first, and becomes the last one. `plane`, unless it is 0,
   becomes the one that gave the lower bound, `simplex`, unless it is 0, the one with the nearest point, or around the origin. It is
   the first guess instead of `towards` if `warm`. Returns 0 if the cores meet. */
static inline int bounds_from(const Core *one, const Core *two, double *towards, double enough, double little, double exact,
                              double *low, double *high, Plane *plane, Simplex *simplex, int warm) {
    Simplex own, last, *s = simplex ? simplex : &own;
    double v[3], a[3], b[3], minus[3];
    double size = sqrt(dot(towards, towards));
    for (int i = 0; i < 3; i++) v[i] = size > 0 ? towards[i] / size : i == 0;
    *low = -INFINITY, *high = INFINITY;
    if (warm) {
        reduce(s);
        *high = sqrt(dot(s->nearest, s->nearest));
        if (!(*high > APART)) return 0;
        memcpy(v, s->nearest, sizeof v);
    } else s->count = 0;
    for (int step = 0; step < MOST_STEPS; step++) {
        for (int i = 0; i < 3; i++) minus[i] = -v[i], towards[i] = v[i];
        support(one, minus, a);
        support(two, v, b);
        double corner[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
        double length = sqrt(dot(v, v)), under = dot(v, corner) / length;
        if (under > *low) {
            *low = under;
            if (plane) {
                for (int i = 0; i < 3; i++) plane->normal[i] = v[i] / length;
                plane->level = dot(plane->normal, a);
            }
        }
        if (*low > enough || *high - *low <= exact) return 1;
        for (int i = 0; i < s->count; i++)
            if (memcmp(s->point[i], corner, sizeof corner) == 0) return 1;
        if (simplex) last = *s;
        memcpy(s->point[s->count], corner, sizeof corner);
        memcpy(s->first[s->count++], a, sizeof a);
        int inside = reduce(s);
        double apart = sqrt(dot(s->nearest, s->nearest));
        if (inside && *low <= MEETING) return 0;
        if (simplex && (warm || step > 0) && (inside || apart >= *high)) *s = last;
        if (inside) return 1;                              /* rounding: a flat simplex may seem to contain the origin */
        if (apart >= *high && (warm || step > 0)) return 1; /* rounding: no progress */
        *high = apart;
        if (apart <= MEETING) return 0;
        if (apart <= little || *high - *low <= exact) return 1;
        memcpy(v, s->nearest, sizeof v);
        if (s->count == 4) return 1;
    }
    return 1;
}

static int bounds(const Core *one, const Core *two, double *towards, double enough, double little, double exact, double *low,
                  double *high, Plane *plane, Simplex *simplex) {
    return bounds_from(one, two, towards, enough, little, exact, low, high, plane, simplex, 0);
}

/* Keep a direction, and the simplex from which the distance came, for the next configuration. */
static void keep_guess(double *guess, const Core *one, const Core *two, const double *towards, const Simplex *s, int apart) {
    memcpy(guess, towards, 3 * sizeof *guess);
    guess[3] = apart && s->count < 4 ? s->count : 0;
    for (int k = 0; k < (int)guess[3]; k++) {
        double second[3];
        for (int i = 0; i < 3; i++) second[i] = s->first[k][i] - s->point[k][i];
        place_back(one->frame, s->first[k], guess + 4 + 6 * k), place_back(two->frame, second, guess + 7 + 6 * k);
    }
}

/* `bounds` from the simplex that `keep_guess` kept, so exact that the distance does not depend on it. Returns 0 where it does not
   give the distance. */
static int bounds_near(const double *guess, const Core *one, const Core *two, double *towards, double enough, double *low,
                       double *high, Simplex *s) {
    s->count = (int)guess[3];
    if (s->count == 0) return 0;
    for (int k = 0; k < s->count; k++) {
        double second[3];
        act(one->frame, guess + 4 + 6 * k, s->first[k]), act(two->frame, guess + 7 + 6 * k, second);
        for (int i = 0; i < 3; i++) s->point[k][i] = s->first[k][i] - second[i];
    }
    double last[3] = {0};
    int apart = bounds_from(one, two, last, enough, -INFINITY, EXACTEST, low, high, 0, s, 1);
    if (!apart || !(*high > APART) || !(*low > enough || *high - *low <= EXACT)) return 0;
    memcpy(towards, last, sizeof last);
    return 1;
}

/* The nearest points of two cores by the last simplex of `bounds`. Returns 0 if it does not tell them. */
static int nearest_of(const Simplex *s, double *a, double *b) {
    double share[3] = {1, 0, 0};
    if (s->count < 1 || s->count > 3) return 0;
    if (s->count > 1) {
        double e[3], f[3] = {0}, p[3];
        for (int i = 0; i < 3; i++) {
            e[i] = s->point[1][i] - s->point[0][i], p[i] = s->nearest[i] - s->point[0][i];
            if (s->count == 3) f[i] = s->point[2][i] - s->point[0][i];
        }
        double ee = dot(e, e), ef = dot(e, f), ff = s->count == 3 ? dot(f, f) : 1, area = ee * ff - ef * ef;
        if (!(area > 0)) return 0;
        share[1] = (ff * dot(p, e) - ef * dot(p, f)) / area;
        share[2] = (ee * dot(p, f) - ef * dot(p, e)) / area;
        share[0] = 1 - share[1] - share[2];
    }
    for (int i = 0; i < 3; i++) {
        a[i] = 0;
        for (int k = 0; k < s->count; k++) a[i] += share[k] * s->first[k][i];
        b[i] = a[i] - s->nearest[i];
    }
    return 1;
}

/* A triangle on the surface of a polytope around the origin: outward normal and distance of its plane. */
typedef struct { int corner[3]; double normal[3], distance; } Face;

enum { MOST_CORNERS = 128 };

/* Returns 0 where the corners are nearly on a line, or the origin is outside. */
static int make_face(const double (*point)[3], int i, int j, int k, Face *face) {
    double e[3], f[3], normal[3];
    for (int x = 0; x < 3; x++) e[x] = point[j][x] - point[i][x], f[x] = point[k][x] - point[i][x];
    cross(e, f, normal);
    double size = sqrt(dot(normal, normal));
    if (!(size > LEAST_AREA)) return 0;
    for (int x = 0; x < 3; x++) face->normal[x] = normal[x] / size;
    face->corner[0] = i, face->corner[1] = j, face->corner[2] = k;
    face->distance = dot(face->normal, point[i]);
    return face->distance > -FLAT;
}

/* Replace the faces that w, the last corner, is in front of or level with by faces from it to their outline. Returns their new
   number, 0 where rounding errors leave no closed outline. */
static int grow(const double (*point)[3], int last, Face *face, int faces) {
    int edge[3 * MOST_CORNERS][2], edges = 0, kept = 0;
    for (int f = 0; f < faces; f++) {
        if (dot(face[f].normal, point[last]) - face[f].distance < -FLAT) { face[kept++] = face[f]; continue; }
        for (int k = 0; k < 3; k++) {
            int from = face[f].corner[k], to = face[f].corner[(k + 1) % 3], known = 0;
            for (; known < edges && (edge[known][0] != to || edge[known][1] != from); known++) {}
            if (known < edges) edges--, edge[known][0] = edge[edges][0], edge[known][1] = edge[edges][1];
            else if (edges == 3 * MOST_CORNERS) return 0;
            else edge[edges][0] = from, edge[edges][1] = to, edges++;
        }
    }
    if (edges < 3 || kept + edges > 2 * MOST_CORNERS) return 0;
    for (int k = 0; k < edges; k++)
        if (!make_face(point, edge[k][0], edge[k][1], last, face + kept++)) return 0;
    return kept;
}

/* The smallest of the shares of a face's corners in its point nearest to the origin. */
static double shares(const double (*point)[3], const Face *face, double *share) {
    const double *o = point[face->corner[0]];
    double e[3], f[3], p[3];
    for (int i = 0; i < 3; i++) {
        e[i] = point[face->corner[1]][i] - o[i], f[i] = point[face->corner[2]][i] - o[i];
        p[i] = face->distance * face->normal[i] - o[i];
    }
    double ee = dot(e, e), ef = dot(e, f), ff = dot(f, f), area = ee * ff - ef * ef;
    share[1] = (ff * dot(p, e) - ef * dot(p, f)) / area;
    share[2] = (ee * dot(p, f) - ef * dot(p, e)) / area;
    share[0] = 1 - share[1] - share[2];
    return fmin(share[0], fmin(share[1], share[2]));
}

/* The point of the difference of two cores that is farthest along v, and the point of the first core that it comes from. */
static void difference(const Core *one, const Core *two, const double *v, double *corner, double *first) {
    double back[3] = {-v[0], -v[1], -v[2]}, other[3];
    support(one, v, first), support(two, back, other);
    for (int i = 0; i < 3; i++) corner[i] = first[i] - other[i];
}

/* A first polytope around the origin, from a simplex that contains it: the simplex itself, or where that is an edge or a triangle
   the same with corners around or beside it. Returns the number of its faces; 0 where it is flat or not convex. */
static int begin(const Core *one, const Core *two, const Simplex *s, double (*point)[3], double (*first)[3], int *count, Face *face) {
    static const int solid[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    static const int beside[6][3] = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}};
    static const int around[6][3] = {{2, 3, 1}, {3, 4, 1}, {4, 2, 1}, {3, 2, 0}, {4, 3, 0}, {2, 4, 0}};
    double e[3], f[3], across[3], v[3];
    if (s->count < 2) return 0;
    memcpy(point, s->point, sizeof s->point), memcpy(first, s->first, sizeof s->first);
    for (int i = 0; i < 3; i++) e[i] = point[1][i] - point[0][i], f[i] = s->count > 2 ? point[2][i] - point[0][i] : 0;
    *count = s->count == 4 ? 4 : 5;
    if (s->count == 2) {
        int least = 0;
        for (int i = 1; i < 3; i++) if (fabs(e[i]) < fabs(e[least])) least = i;
        f[least] = 1, cross(e, f, across), cross(e, across, v);
        double share = sqrt(0.75 * dot(across, across) / dot(v, v));
        for (int k = 0; k < 3; k++) {
            double way[3];
            for (int i = 0; i < 3; i++) way[i] = k == 0 ? across[i] : -0.5 * across[i] + (k == 1 ? share : -share) * v[i];
            difference(one, two, way, point[2 + k], first[2 + k]);
        }
    } else if (s->count == 3) {
        cross(e, f, across);
        for (int i = 0; i < 3; i++) v[i] = -across[i];
        difference(one, two, across, point[3], first[3]), difference(one, two, v, point[4], first[4]);
    }
    const int (*start)[3] = s->count == 4 ? solid : s->count == 3 ? beside : around;
    int faces = s->count == 4 ? 4 : 6, turned = 0;
    if (s->count == 4) {
        double to[3];
        for (int i = 0; i < 3; i++) to[i] = point[3][i] - point[0][i];
        cross(e, f, across), turned = dot(across, to) < 0;
    }
    for (int k = 0; k < faces; k++) {
        if (!make_face((const double (*)[3])point, start[k][0], start[k][turned ? 2 : 1], start[k][turned ? 1 : 2], face + k)) return 0;
        for (int c = 0; c < *count; c++)
            if (dot(face[k].normal, point[c]) - face[k].distance > FLAT) return 0;
    }
    return faces;
}

/* How deep two cores overlap, by the expanding polytope algorithm from a simplex of the difference of both around the origin.
   `normal` is the unit vector from the second core to the first along which they come apart soonest, a and b the points that part
   last; both may be 0. Returns 0 where it does not converge. */
static int depth_of(const Core *one, const Core *two, const Simplex *s, double *depth, double *normal, double *a, double *b) {
    double point[MOST_CORNERS][3], first[MOST_CORNERS][3];
    Face face[2 * MOST_CORNERS];
    int count = 0, faces = begin(one, two, s, point, first, &count, face);
    if (!faces) return 0;
    for (;;) {
        int best = 0;
        double corner[3], from[3];
        for (int f = 1; f < faces; f++)
            if (face[f].distance < face[best].distance) best = f;
        const Face *near = face + best;
        difference(one, two, near->normal, corner, from);
        int known = 0;
        for (int k = 0; k < count; k++) known |= memcmp(point[k], corner, sizeof corner) == 0;
        if (!known && dot(near->normal, corner) - near->distance > EXACT_DEPTH) {
            if (count == MOST_CORNERS) return 0;
            memcpy(point[count], corner, sizeof corner), memcpy(first[count], from, sizeof from);
            faces = grow((const double (*)[3])point, count++, face, faces);
            if (!faces) return 0;
            continue;
        }
        *depth = near->distance;
        if (!normal) return 1;
        double share[3], most = -INFINITY, other[3];
        for (int f = 0; f < faces; f++) {                  /* of several parts of one side, that with the nearest point */
            if (face[f].distance > *depth + FLAT || dot(face[f].normal, face[best].normal) < 1 - FLAT) continue;
            double least = shares((const double (*)[3])point, face + f, other);
            if (least > most) most = least, near = face + f, memcpy(share, other, sizeof share);
        }
        for (int i = 0; i < 3; i++) {
            normal[i] = -face[best].normal[i], a[i] = 0;
            for (int k = 0; k < 3; k++) a[i] += share[k] * first[near->corner[k]][i];
            b[i] = a[i] + *depth * normal[i];
        }
        return 1;
    }
}

/* `bounds` for two shapes: bounds on the signed distance minus both radii. Returns 0 if the cores meet. */
static int shape_bounds(const World *w, long i, const Core *one, long j, const Core *two, double *towards, double enough,
                        double little, double *low, double *high, Plane *plane, Simplex *simplex) {
    double radii = w->radius[i] + w->radius[j];
    int apart = bounds(one, two, towards, enough + radii, little + radii, EXACT, low, high, plane, simplex);
    *low -= radii, *high -= radii;
    return apart;
}

/* The least height along d of a corner below a node of a surface's tree, unless it is not below `least`, and that corner. */
static double lowest_of(const World *w, long node, const double *d, double least, double *p) {
    const double *box = w->node_box + 6 * node;
    double under = 0;
    for (int i = 0; i < 3; i++) under += d[i] * box[d[i] > 0 ? i : 3 + i];
    if (!(under < least)) return least;
    const long *child = w->node + 2 * node;
    if (child[0] >= 0) {
        for (int k = 0; k < 2; k++) least = lowest_of(w, child[k], d, least, p);
        return least;
    }
    for (int k = 0; k < 3; k++) {
        const double *corner = w->corners + 9 * child[1] + 3 * k;
        double along = dot(d, corner);
        if (along < least) least = along, memcpy(p, corner, 3 * sizeof *p);
    }
    return least;
}

/* The point of a shape, in the world, that is deepest in a half-space, and its height over the plane: exact. */
static double lowest(const World *w, long body, const Core *core, const double *frame, double *p) {
    double down[3], height = 0;
    for (int i = 0; i < 3; i++) down[i] = -frame[3 * i + 2];
    if (w->kind[body] == SURFACE) {
        const double *own = w->frames + 12 * w->joint[body];
        double d[3], corner[3] = {0}, up[3] = {-down[0], -down[1], -down[2]};
        turn_back(own, up, d);
        lowest_of(w, w->root[body], d, INFINITY, corner);
        act(own, corner, p);
    } else support(core, down, p);
    for (int i = 0; i < 3; i++) height -= down[i] * (p[i] - frame[9 + i]);
    return height;
}

/* Distance of a shape from a half-space: exact. */
static double over_plane(const World *w, long body, const Core *core, long plane) {
    double frame[12], p[3];
    compose(w->frames + 12 * w->joint[plane], w->pose + 12 * plane, frame);
    return lowest(w, body, core, frame, p) - w->radius[body] - w->radius[plane];
}

static double square_from_box(const double *p, const double *box) {
    double square = 0;
    for (int i = 0; i < 3; i++) {
        double under = box[i] - p[i], over = p[i] - box[3 + i], gap = under > over ? under : over;
        gap = gap > 0 ? gap : 0;
        square += gap * gap;
    }
    return square;
}

static double from_box(const double *p, const double *box) { return sqrt(square_from_box(p, box)); }

static void box_core(const double *box, Core *core, double *half) {
    static const double straight[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    memcpy(core->own, straight, sizeof straight);
    for (int i = 0; i < 3; i++) core->own[9 + i] = (box[i] + box[3 + i]) / 2, half[i] = (box[3 + i] - box[i]) / 2;
    core->kind = BOX, core->frame = core->own, core->size = half;
}

/* How often the ray from p along d leaves the surface, less how often it enters: its winding number about p. */
static int leaves(const World *w, long node, const double *p, const double *d) {
    const double *box = w->node_box + 6 * node;
    double near = 0, far = INFINITY;
    for (int i = 0; i < 3; i++) {
        double t = (box[i] - p[i]) / d[i], u = (box[3 + i] - p[i]) / d[i];
        if (t > u) { double kept = t; t = u, u = kept; }
        near = t > near ? t : near, far = u < far ? u : far;
    }
    if (near > far) return 0;
    const long *child = w->node + 2 * node;
    if (child[0] >= 0) return leaves(w, child[0], p, d) + leaves(w, child[1], p, d);
    const double *c = w->corners + 9 * child[1];
    double e[3], f[3], s[3];
    for (int i = 0; i < 3; i++) e[i] = c[3 + i] - c[i], f[i] = c[6 + i] - c[i], s[i] = p[i] - c[i];
    double h[3] = {d[1] * f[2] - d[2] * f[1], d[2] * f[0] - d[0] * f[2], d[0] * f[1] - d[1] * f[0]}, det = dot(e, h);
    if (det == 0) return 0;
    double u = dot(s, h) / det;
    if (u < 0 || u > 1) return 0;
    double g[3] = {s[1] * e[2] - s[2] * e[1], s[2] * e[0] - s[0] * e[2], s[0] * e[1] - s[1] * e[0]};
    double v = dot(d, g) / det;
    if (v < 0 || u + v > 1 || dot(f, g) / det <= 0) return 0;
    return det < 0 ? 1 : -1;
}

/* Whether a point, in the frame of the surface's joint, is inside a closed surface, by the majority of three rays. */
static int within(const World *w, long surface, const double *p) {
    static const double ray[3][3] = {{0.612372, 0.353553, 0.707107}, {-0.41779, 0.83127, -0.36701}, {0.11731, -0.51449, -0.84943}};
    if (from_box(p, w->node_box + 6 * w->root[surface]) > 0) return 0;
    int votes = 0;
    for (int k = 0; k < 3; k++) votes += leaves(w, w->root[surface], p, ray[k]) != 0;
    return votes >= 2;
}

/* A search for pairs near one body: all distances below `reach`, or only whether there is one. */
typedef struct {
    const World *w;
    long body;
    const Core *core;
    const long *pairs;    /* number of the pair with each body, -1 where it is not checked; 0: there is one pair alone */
    long pair;            /* its number then */
    double reach;         /* distances above it are not looked for */
    double *out;          /* distances by pair, infinite where none was found; nan where the bounds did not converge, and for depths
                             that are not found; 0: only look for touching */
    long *count;          /* number of pairs in `found` of the world; 0: pairs are not listed */
    int verdict;
    long leaf;            /* nearest triangle or point of the last surface; -1 */
    Plane plane;          /* separates the body from it, in its frame */
    double *guess;        /* as in the world, for the same pairs; 0: none is kept */
    long own;             /* nearest triangle or point of the body itself, where that is a surface; -1 */
    int inside;           /* whether the last surface is around the body, or the body around it */
    int failed;           /* whether it overlaps the body by a depth that is not found */
    const double *frame;  /* of the body's joint, in the frame of the surface */
    const double *centre; /* of the body's ball, there */
    int moves;            /* whether the surface moves */
    double closer;        /* leaves that are nearer than the nearest so far by less than this are not looked at [m] */
    struct Leaves *leaves; /* all leaves within reach are listed here; 0: only the nearest counts */
} Search;

/* Leaves of a surface by their distances from a body, the nearest first. */
typedef struct Leaves {
    long count, room;
    long *leaf;           /* (room) */
    double *distance;     /* (room) [m] */
    double *point;        /* (room, 3) their nearest points */
} Leaves;

/* List a leaf whose nearest point is p; where there is no room, in place of the farthest. Of leaves whose nearest points are beside each
   other only the nearest is listed. */
static void list_leaf(Search *s, long leaf, double distance, const double *p) {
    Leaves *l = s->leaves;
    long at = 0, kept = 0;
    for (int removing = 0; removing < 2; removing++)
        for (long k = 0; k < l->count; k++) {
            const double *other = l->point + 3 * k;
            double gap[3] = {other[0] - p[0], other[1] - p[1], other[2] - p[2]};
            int is_beside = dot(gap, gap) < LEAVES_APART * LEAVES_APART;
            if (!removing && is_beside && l->distance[k] <= distance) return;
            if (!removing || is_beside) continue;
            l->leaf[kept] = l->leaf[k], l->distance[kept] = l->distance[k];
            memmove(l->point + 3 * kept++, other, 3 * sizeof *p);
        }
    l->count = kept;
    while (at < kept && l->distance[at] <= distance) at++;
    if (at == l->room) return;
    if (l->count < l->room) l->count++;
    for (long k = l->count - 1; k > at; k--) {
        l->leaf[k] = l->leaf[k - 1], l->distance[k] = l->distance[k - 1];
        memcpy(l->point + 3 * k, l->point + 3 * k - 3, 3 * sizeof *p);
    }
    l->leaf[at] = leaf, l->distance[at] = distance;
    memcpy(l->point + 3 * at, p, 3 * sizeof *p);
    if (l->count == l->room) s->reach = fmin(s->reach, l->distance[l->room - 1]);
}

static long pair_with(const Search *s, long obstacle) { return s->pairs ? s->pairs[obstacle] : s->pair; }

static double reach_of(const Search *s, long obstacle) {
    if (!s->out) return s->reach;
    double best = s->out[pair_with(s, obstacle)];
    return best > s->reach ? s->reach : best;               /* nan is kept: nothing is above it */
}

/* Note bounds on a distance. `apart`: whether the cores do not meet; where they do and the depth is not known, there are no bounds.
   Returns whether this is the smallest distance so far. */
static int note(Search *s, long obstacle, int apart, double low, double high) {
    if (s->out) {
        double *best = s->out + pair_with(s, obstacle);
        int exact = apart && high - low <= 1e3 * EXACT;
        if (apart && (exact ? high : low) >= fmin(*best, s->reach)) return 0;
        if (s->count && *best == INFINITY) s->w->found[(*s->count)++] = pair_with(s, obstacle);
        *best = exact ? high : NAN;
    } else if (!apart || high <= s->reach) s->verdict = TOUCHING;
    else if (low <= s->reach && s->verdict == FREE) s->verdict = UNDECIDED;
    return 1;
}

static int ended(const Search *s, long obstacle) {
    return s->out ? isnan(s->out[pair_with(s, obstacle)]) : s->verdict == TOUCHING;
}

/* Least distance of a box from what is in front of a plane. */
static double behind(const Plane *plane, const double *box) {
    double most = 0;
    for (int i = 0; i < 3; i++) most += plane->normal[i] * box[plane->normal[i] > 0 ? 3 + i : i];
    return plane->level - most;
}

/* Least distance of a triangle from what is in front of a plane. */
static double in_front(const Plane *plane, const double *c) {
    double a = dot(plane->normal, c), b = dot(plane->normal, c + 3), d = dot(plane->normal, c + 6), most = a > b ? a : b;
    return plane->level - (d > most ? d : most);
}

/* Whether a ball is farther than `reach` from the box around a body, whose joint has a frame. */
static int is_outside(const World *w, const double *centre, double radius, long body, const double *frame, double reach) {
    double p[3];
    place_back(frame, centre, p);
    return square_from_box(p, w->local + 6 * body) > (reach + radius) * (reach + radius);
}

/* The same in the world. */
static int is_beside(const World *w, const double *centre, double radius, long body, double reach) {
    return is_outside(w, centre, radius, body, w->frames + 12 * w->joint[body], reach);
}

/* The core of a triangle or point with corners c (9); `axes` (9) holds them by axis. */
static void leaf_core(const double *c, double *axes, Core *leaf) {
    static const double still[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    int point = 1;                                          /* points of clouds are tiny triangles */
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) axes[3 * i + k] = c[3 * k + i];
        point &= fabs(c[3 + i] - c[i]) < TINY && fabs(c[6 + i] - c[i]) < TINY;
    }
    leaf->kind = POINTS, leaf->count = point ? 1 : 3, leaf->frame = still;
    leaf->x = axes, leaf->y = axes + 3, leaf->z = axes + 6;
}

/* Whether a triangle is farther than `reach` from a box in a frame, by the box around it there. */
static int is_triangle_outside(const double *c, const double *box, const double *frame, double reach) {
    double around[6] = {INFINITY, INFINITY, INFINITY, -INFINITY, -INFINITY, -INFINITY}, square = 0;
    for (int k = 0; k < 3; k++) {
        double p[3];
        place_back(frame, c + 3 * k, p);
        for (int i = 0; i < 3; i++) around[i] = p[i] < around[i] ? p[i] : around[i], around[3 + i] = p[i] > around[3 + i] ? p[i] : around[3 + i];
    }
    for (int i = 0; i < 3; i++) {
        double under = box[i] - around[3 + i], over = around[i] - box[3 + i], gap = under > over ? under : over;
        gap = gap > 0 ? gap : 0;
        square += gap * gap;
    }
    return square > reach * reach;
}

/* How deep two triangles overlap in one direction, `size` (its square): the shorter way apart along it, at most `least`. */
static double overlap_along(double (*a)[3], double (*b)[3], const double *d, double size, double least) {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int k = 0; k < 3; k++) {
        double p = dot(a[k], d), q = dot(b[k], d);
        low[0] = p < low[0] ? p : low[0], high[0] = p > high[0] ? p : high[0];
        low[1] = q < low[1] ? q : low[1], high[1] = q > high[1] ? q : high[1];
    }
    double way = fmin(high[0] - low[1], high[1] - low[0]);
    return way > 0 ? fmin(way / sqrt(size), least) : 0;
}

/* How deep two triangles overlap: the shortest way apart is along a normal of one, or normal to an edge of each. */
static double depth_of_triangles(const Core *one, const Core *two) {
    double corner[2][3][3], edge[2][3][3], least = INFINITY;
    for (int side = 0; side < 2; side++) {
        const Core *core = side ? two : one;
        for (int k = 0; k < 3; k++) {
            long at = k < core->count ? k : 0;
            double p[3] = {core->x[at], core->y[at], core->z[at]};
            act(core->frame, p, corner[side][k]);
        }
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < 3; i++) edge[side][k][i] = corner[side][(k + 1) % 3][i] - corner[side][k][i];
    }
    for (int k = 0; k < 11; k++) {
        const double *e = k < 9 ? edge[0][k / 3] : edge[k - 9][0], *f = k < 9 ? edge[1][k % 3] : edge[k - 9][1];
        double d[3], size;
        cross(e, f, d), size = dot(d, d);
        if (size > PARALLEL * dot(e, e) * dot(f, f)) least = overlap_along(corner[0], corner[1], d, size, least);
    }
    return least < INFINITY ? least : 0;
}

/* Note that the body, or a leaf of it, meets a leaf of an obstacle; `simplex` is what `bounds` left. Returns whether this is the
   deepest overlap so far. */
static int note_depth(Search *s, long obstacle, const Core *one, const Core *leaf, const Simplex *simplex) {
    double depth, radii = s->w->radius[s->body] + s->w->radius[obstacle];
    if (!s->out) {
        note(s, obstacle, 0, 0, 0);
        return 1;
    }
    if (s->w->kind[s->body] == SURFACE) depth = depth_of_triangles(one, leaf);
    else if (!depth_of(one, leaf, simplex, &depth, 0, 0, 0)) {
        s->failed = 1;
        return 0;
    }
    if (-depth - radii >= s->out[pair_with(s, obstacle)]) return 0;
    note(s, obstacle, 1, -depth - radii, -depth - radii);
    return 1;
}

/* The hull of `count` leaves of a surface, in the frame of its joint. */
static void hull_core(const World *w, long first, long count, Core *core) {
    static const double still[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    core->kind = POINTS, core->count = 3 * count, core->frame = still;
    core->x = w->leaf_x + 3 * first, core->y = w->leaf_y + 3 * first, core->z = w->leaf_z + 3 * first;
}

/* Compare the body with a triangle or point of a surface; `direction`: a first guess from it to the body. */
static void one_leaf(Search *s, long obstacle, long at, double reach, const double *direction) {
    const World *w = s->w;
    const double *c = w->corners + 9 * at;
    double axes[9], towards[3], low, high, little = s->out ? -INFINITY : reach;
    Core leaf;
    leaf_core(c, axes, &leaf);
    Plane plane = s->plane;
    Simplex simplex;
    memcpy(towards, direction, sizeof towards);
    int apart = shape_bounds(w, s->body, s->core, obstacle, &leaf, towards, reach, little, &low, &high, &plane, &simplex);
    if (s->leaves) {
        double a[3], b[3];
        if (apart && low <= reach) s->plane = plane;
        if (apart && low <= reach && nearest_of(&simplex, a, b)) list_leaf(s, at, high, b);
        return;
    }
    if (!apart) {
        if (note_depth(s, obstacle, s->core, &leaf, &simplex)) s->leaf = at;
    } else if (low <= reach) {
        if (note(s, obstacle, apart, low, high)) s->leaf = at;
        s->plane = plane;
    }
}

/* Look at the triangles or points below a node of a surface, `count` from leaf `begin` on. `before`: a plane with the body in front
   of it. */
static void surface(Search *s, long obstacle, long node, long begin, long count, const Plane *before) {
    const World *w = s->w;
    const double *box = w->node_box + 6 * node, *centre = s->centre, extra = w->radius[obstacle];
    double reach = reach_of(s, obstacle) - s->closer, minus_radii = -extra - w->radius[s->body];
    double around = from_box(centre, box) - w->ball[4 * s->body + 3] - extra;
    if (ended(s, obstacle) || around > reach) return;
    if (behind(before, box) + minus_radii > reach || behind(&s->plane, box) + minus_radii > reach) return;
    const long *child = w->node + 2 * node;
    if (child[0] < 0) {
        const double *c = w->corners + 9 * child[1];
        if (in_front(&s->plane, c) + minus_radii > reach || in_front(before, c) + minus_radii > reach) return;
        if (is_triangle_outside(c, w->local + 6 * s->body, s->frame, reach + extra)) return;
        if (!s->moves) one_leaf(s, obstacle, child[1], reach, s->plane.normal);
        else one_leaf(s, obstacle, child[1], reach, before->normal);
        return;
    }
    Plane plane = *before;
    double half[3], low, high;
    Core all;
    box_core(box, &all, half);
    if (is_outside(w, all.own + 9, sqrt(dot(half, half)), s->body, s->frame, reach + extra)) return;
    int worthwhile = half[0] + half[1] + half[2] < 2 * w->ball[4 * s->body + 3], level = 0;   /* small beside the body */
    if (s->moves && count <= FEW) {
        worthwhile &= count > FEW / 2 || (count > 2 && count <= 4);                  /* not at every level */
        hull_core(w, begin, count, &all);
    } else if (!s->moves) {
        for (long left = count; left > 1; left /= 2) level++;
        worthwhile &= level % LEVELS == 0;
    }
    if (worthwhile) {
        double towards[3];
        for (int i = 0; i < 3; i++) towards[i] = s->moves ? before->normal[i] : centre[i] - all.own[9 + i];
        double enough = reach - minus_radii;
        int apart = bounds(s->core, &all, towards, enough, enough, EXACT, &low, &high, &plane, 0);
        if (apart && low + minus_radii > reach) return;
    }
    double first = behind(&plane, w->node_box + 6 * child[0]), second = behind(&plane, w->node_box + 6 * child[1]);
    int order = second < first;
    for (int k = 0; k < 2; k++) {
        int at = k ^ order;
        surface(s, obstacle, child[at], begin + (at ? count / 2 : 0), at ? count - count / 2 : count / 2, &plane);
    }
}

/* The plane behind the ball around a body, at a centre, that faces the middle of a box. */
static Plane facing(const World *w, long body, const double *centre, const double *box) {
    const double *ball = w->ball + 4 * body;
    double size = 0;
    Plane plane;
    for (int i = 0; i < 3; i++) plane.normal[i] = centre[i] - (box[i] + box[3 + i]) / 2, size += plane.normal[i] * plane.normal[i];
    size = sqrt(size);
    for (int i = 0; i < 3; i++) plane.normal[i] = size > 0 ? plane.normal[i] / size : i == 0;
    plane.level = dot(plane.normal, centre) - (ball[3] - w->radius[body]);
    return plane;
}

/* Two surfaces of which the trees are gone down. */
typedef struct {
    Search *s;
    long obstacle;
    double frame[12];       /* of the body's joint, in the frame of the obstacle's */
    double share[9];        /* absolute values of its rotation */
    double radii;
    double towards[3];      /* direction between the last leaves that were near */
} Two;

/* A lower bound of the signed distance of the parts of two surfaces in boxes a and b, by the six directions of the boxes' sides. */
static double between_boxes(const Two *two, const double *a, const double *b) {
    double centre[3], half[3], other[3], gap[3], turned[3], most = -INFINITY, in_one = 0, in_two = 0;
    for (int i = 0; i < 3; i++) centre[i] = (a[i] + a[3 + i]) / 2, half[i] = (a[3 + i] - a[i]) / 2;
    act(two->frame, centre, gap);
    for (int i = 0; i < 3; i++) gap[i] -= (b[i] + b[3 + i]) / 2, other[i] = (b[3 + i] - b[i]) / 2;
    turn_back(two->frame, gap, turned);
    for (int i = 0; i < 3; i++) {
        double own = fabs(gap[i]) - other[i] - dot(two->share + 3 * i, half), theirs = fabs(turned[i]) - half[i];
        for (int j = 0; j < 3; j++) theirs -= two->share[3 * j + i] * other[j];
        most = own > most ? own : most, most = theirs > most ? theirs : most;
        own = own > 0 ? own : 0, theirs = theirs > 0 ? theirs : 0;
        in_two += own * own, in_one += theirs * theirs;
    }
    return most > 0 ? sqrt(in_one > in_two ? in_one : in_two) : most;
}

/* Compare leaves of two surfaces. */
static void two_leaves(Two *two, long a, long b) {
    Search *s = two->s;
    Core one, other;
    double axes[9], others[9], towards[3], low, high, reach = reach_of(s, two->obstacle);
    leaf_core(s->w->corners + 9 * a, axes, &one), leaf_core(s->w->corners + 9 * b, others, &other);
    one.frame = two->frame;
    memcpy(towards, two->towards, sizeof towards);
    Simplex simplex;
    double enough = s->out ? reach - CLOSER : reach;
    int apart = shape_bounds(s->w, s->body, &one, two->obstacle, &other, towards, enough, s->out ? -INFINITY : reach, &low, &high, 0,
                             &simplex);
    if (apart && low > enough) return;
    if (!apart) {
        if (!note_depth(s, two->obstacle, &one, &other, &simplex)) return;
    } else if (!note(s, two->obstacle, apart, low, high)) return;
    s->own = a, s->leaf = b;
    memcpy(two->towards, towards, sizeof towards);
}

/* A node of a surface's tree, and the leaves below it. */
typedef struct { long node, first, count; } Part;

static Part whole(const World *w, long body) {
    Part part = {w->root[body], w->first[body], w->count[body]};
    return part;
}

static Part child_of(const World *w, Part part, int which) {
    long half = part.count / 2;
    Part child = {w->node[2 * part.node + which], part.first + (which ? half : 0), which ? part.count - half : half};
    return child;
}

static double extent(const double *box) { return box[3] - box[0] + box[4] - box[1] + box[5] - box[2]; }

/* Look at two parts of surfaces, whose signed distance is at least `under` plus both radii. */
static void two_nodes(Two *two, Part a, Part b, double under) {
    const World *w = two->s->w;
    double reach = reach_of(two->s, two->obstacle);
    if ((!two->s->out && ended(two->s, two->obstacle)) || !(under <= (two->s->out ? reach - CLOSER : reach))) return;
    const long *one = w->node + 2 * a.node, *other = w->node + 2 * b.node;
    if (one[0] < 0 && other[0] < 0) {
        two_leaves(two, one[1], other[1]);
        return;
    }
    if (under > -0.1 * extent(w->node_box + 6 * b.node) && a.count <= FEW && b.count <= FEW && a.count * b.count >= LEAST_PAIRS) {
        Core own, theirs;
        double towards[3], low, high, limit = (two->s->out ? reach - CLOSER : reach) + two->radii;
        hull_core(w, a.first, a.count, &own), hull_core(w, b.first, b.count, &theirs);
        own.frame = two->frame;
        memcpy(towards, two->towards, sizeof towards);
        if (bounds(&own, &theirs, towards, limit, limit, EXACT, &low, &high, 0, 0) && low > limit) return;
    }
    int first = one[0] >= 0 && (other[0] < 0 || extent(w->node_box + 6 * a.node) >= extent(w->node_box + 6 * b.node));
    Part half[2] = {child_of(w, first ? a : b, 0), child_of(w, first ? a : b, 1)};
    double least[2];
    for (int k = 0; k < 2; k++)
        least[k] = between_boxes(two, w->node_box + 6 * (first ? half[k] : a).node, w->node_box + 6 * (first ? b : half[k]).node) - two->radii;
    for (int k = 0; k < 2; k++) {
        int at = k ^ (least[1] < least[0]);
        two_nodes(two, first ? half[at] : a, first ? b : half[at], least[at]);
    }
}

/* Whether a part of the surface of a body is inside a closed one; `frame`: of the body's joint in the frame of the other's. */
static int is_around(const World *w, long solid, long body, const double *frame) {
    const long *probes = w->probes + 2 * body;
    for (long k = probes[0]; k < probes[0] + probes[1]; k++) {
        double p[3];
        act(frame, w->probe + 3 * k, p);
        if (within(w, solid, p)) return 1;
    }
    return 0;
}

/* Compare a body that is a surface with another one. */
static void visit_surfaces(Search *s, long obstacle, Two *two) {
    const World *w = s->w;
    long one = s->body;
    two->s = s, two->obstacle = obstacle, two->radii = w->radius[one] + w->radius[obstacle];
    relative(w->frames + 12 * w->joint[obstacle], w->frames + 12 * w->joint[one], two->frame);
    for (int i = 0; i < 9; i++) two->share[i] = fabs(two->frame[i]);
    double *guess = s->guess ? s->guess + GUESS * pair_with(s, obstacle) : 0;
    place_back(w->frames + 12 * w->joint[obstacle], w->centres + 3 * one, two->towards);
    for (int i = 0; i < 3; i++) two->towards[i] -= w->ball[4 * obstacle + i];
    if (guess && guess[0] > 0) two_leaves(two, (long)guess[0] - 1, (long)guess[1] - 1);
    two_nodes(two, whole(w, one), whole(w, obstacle), -INFINITY);
    if (guess) guess[0] = s->own + 1, guess[1] = s->leaf + 1;
}

/* Compare a convex body with a surface. */
static void visit_surface(Search *s, long obstacle, Core *core, double *frame, double *centre) {
    const World *w = s->w;
    const double *there = w->frames + 12 * w->joint[obstacle];
    s->frame = w->frames + 12 * w->joint[s->body], s->centre = w->centres + 3 * s->body;
    if (w->joint[obstacle] > 0) {                           /* in the frame of the surface */
        relative(there, s->frame, frame), place_back(there, s->centre, centre);
        s->frame = frame, s->centre = centre, *core = *s->core, core->frame = frame;
        if (core->kind != POINTS) compose(frame, w->pose + 12 * s->body, core->own), core->frame = core->own;
        s->core = core, s->moves = 1;
    }
    s->closer = s->out ? CLOSER : 0;
    Plane plane = s->plane = facing(w, s->body, s->centre, w->node_box + 6 * w->root[obstacle]);
    double *guess = s->guess ? s->guess + GUESS * pair_with(s, obstacle) : 0;
    if (guess && guess[0] > 0) one_leaf(s, obstacle, (long)guess[0] - 1, reach_of(s, obstacle), plane.normal);
    surface(s, obstacle, w->root[obstacle], w->first[obstacle], w->count[obstacle], &plane);
    if (guess && s->leaf >= 0) guess[0] = s->leaf + 1;
}

/* Compare the body, convex or a surface, with a surface that may be closed, as the body may. */
static void visit_solid(Search *s, long obstacle) {
    const World *w = s->w;
    int both = w->kind[s->body] == SURFACE;
    const Core *kept = s->core;
    Core core;
    Two two;
    double frame[12], centre[3], radii = w->radius[s->body] + w->radius[obstacle], *best = s->out ? s->out + pair_with(s, obstacle) : 0;
    s->leaf = s->own = -1, s->inside = s->failed = s->moves = 0, s->closer = 0;
    if (both) visit_surfaces(s, obstacle, &two);
    else visit_surface(s, obstacle, &core, frame, centre);
    int closed = w->size[3 * obstacle] > 0, apart = !best || *best > -radii || s->leaf < 0;
    if (!ended(s, obstacle) && apart) {
        double v[3] = {1, 0, 0}, p[3], back[12];
        if (s->failed) note(s, obstacle, 0, 0, 0);
        else if (both) {
            s->inside = closed && is_around(w, obstacle, s->body, two.frame);
            if (!s->inside && w->size[3 * s->body] > 0) {
                relative(w->frames + 12 * w->joint[s->body], w->frames + 12 * w->joint[obstacle], back);
                s->inside = is_around(w, s->body, obstacle, back);
            }
        } else if (closed) {
            support(s->core, v, p);
            s->inside = within(w, obstacle, p);
        }
    }
    if (s->inside && !best) note(s, obstacle, 0, 0, 0);
    else if (s->inside) {
        double far = INFINITY;
        if (s->leaf >= 0 && *best < s->reach) far = *best;
        else {                                              /* farther inside than distances are looked for */
            Search deep = *s;
            deep.pairs = 0, deep.pair = 0, deep.reach = INFINITY, deep.out = &far, deep.count = 0, deep.guess = 0;
            if (both) visit_surfaces(&deep, obstacle, &two);
            else {
                deep.plane = facing(w, s->body, s->centre, w->node_box + 6 * w->root[obstacle]);
                Plane plane = deep.plane;
                surface(&deep, obstacle, w->root[obstacle], w->first[obstacle], w->count[obstacle], &plane);
            }
            s->leaf = deep.leaf, s->own = deep.own, s->plane = deep.plane;
        }
        note(s, obstacle, !isnan(far), -fabs(far), -fabs(far));
    }
    if (both) memcpy(s->plane.normal, two.towards, sizeof two.towards);
    s->core = kept;
}

/* Whether two balls are farther apart than `reach`. */
static int are_balls_far(const double *a, double radius, const double *b, double other, double reach) {
    double gap[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]}, reaches = reach + radius + other;
    return dot(gap, gap) > reaches * reaches;
}

/* Whether a body and another one, which are bounded, are farther apart than `reach` by balls and boxes around them. */
static int are_far(const World *w, long one, long two, double reach) {
    const double *a = w->centres + 3 * one, *b = w->centres + 3 * two;
    return are_balls_far(a, w->ball[4 * one + 3], b, w->ball[4 * two + 3], reach) || is_beside(w, b, w->ball[4 * two + 3], one, reach) ||
           is_beside(w, a, w->ball[4 * one + 3], two, reach);
}

/* Compare the body with another one; `box`: one around that in the world, or 0. */
static void visit(Search *s, long obstacle, const double *box) {
    const World *w = s->w;
    if (pair_with(s, obstacle) < 0 || ended(s, obstacle)) return;
    long kind = w->kind[obstacle], own = w->kind[s->body];
    double low = -INFINITY, high = INFINITY;
    if (kind == UNKNOWN || own == UNKNOWN || own == HALFSPACE) {
        note(s, obstacle, 1, low, high);
    } else if (kind == HALFSPACE) {
        low = over_plane(w, s->body, s->core, obstacle);
        if (low <= reach_of(s, obstacle)) note(s, obstacle, 1, low, low);
    } else if (own == SURFACE) {
        if (are_far(w, s->body, obstacle, reach_of(s, obstacle))) return;
        if (kind == SURFACE) visit_solid(s, obstacle);
        else {                                              /* the other way round */
            Core core;
            Search turned = *s;
            core_of(w, obstacle, &core);
            turned.body = obstacle, turned.core = &core, turned.pairs = 0, turned.pair = pair_with(s, obstacle);
            visit_solid(&turned, s->body);
            s->verdict = turned.verdict, s->own = turned.leaf, s->leaf = -1;
        }
    } else if (kind == SURFACE) {
        if (w->joint[obstacle] > 0 && are_far(w, s->body, obstacle, reach_of(s, obstacle))) return;
        visit_solid(s, obstacle);
    } else {
        double towards[3], reach = reach_of(s, obstacle);
        const double *a = w->centres + 3 * s->body, *b = w->centres + 3 * obstacle;
        for (int i = 0; i < 3; i++) towards[i] = a[i] - b[i];
        if (are_far(w, s->body, obstacle, reach)) return;
        double *guess = s->guess ? s->guess + GUESS * pair_with(s, obstacle) : 0;
        if (guess && dot(guess, guess) > 0)
            memcpy(towards, guess, sizeof towards);
        else if (box && square_from_box(a, box) > 0)        /* from the nearest point of the box: a better first direction */
            for (int i = 0; i < 3; i++) towards[i] = a[i] < box[i] ? a[i] - box[i] : a[i] > box[3 + i] ? a[i] - box[3 + i] : 0;
        Core other;
        core_of(w, obstacle, &other);
        Simplex simplex;
        double little = s->out ? -INFINITY : reach, depth, radii = w->radius[s->body] + w->radius[obstacle];
        int known = guess && dot(guess, guess) > 0 && s->out, apart = 1;
        if (known && bounds_near(guess, s->core, &other, towards, reach + radii, &low, &high, &simplex)) low -= radii, high -= radii;
        else apart = shape_bounds(w, s->body, s->core, obstacle, &other, towards, reach, little, &low, &high, 0, &simplex);
        if (guess) keep_guess(guess, s->core, &other, towards, &simplex, apart);
        if (!apart && s->out && depth_of(s->core, &other, &simplex, &depth, 0, 0, 0))
            apart = 1, low = high = -depth - w->radius[s->body] - w->radius[obstacle];
        if (!apart || low <= reach) note(s, obstacle, apart, low, high);
    }
}

static void descend(Search *s, long node) {
    const World *w = s->w;
    const double *box = w->node_box + 6 * node, reaches = s->reach + w->ball[4 * s->body + 3];
    if (square_from_box(w->centres + 3 * s->body, box) > reaches * reaches || (!s->out && s->verdict == TOUCHING)) return;
    const long *child = w->node + 2 * node;
    if (child[0] < 0) visit(s, child[1], box);
    else descend(s, child[0]), descend(s, child[1]);
}

/* Whether any obstacle's box is nearer to a ball than its radius. */
static int is_near(const World *w, const double *centre, double square, long node) {
    if (square_from_box(centre, w->node_box + 6 * node) > square) return 0;
    const long *child = w->node + 2 * node;
    return child[0] < 0 || is_near(w, centre, square, child[0]) || is_near(w, centre, square, child[1]);
}

/* With `count`, all distances below `reach`, in `least` and `found` of the world; otherwise only whether any is. `guess`: as in the
   world; 0: none is kept. */
static int examine(const World *w, const double *q, double reach, long *count, double *guess) {
    int finite = 1;
    for (long j = 0; j < w->entries; j++) finite &= isfinite(q[j]) != 0;
    if (!finite) {
        for (long k = 0; count && k < w->pairs; k++) w->least[k] = NAN, w->found[(*count)++] = k;
        return UNDECIDED;
    }
    double *out = count ? w->least : 0;
    Core core;
    Search s = {w, -1, &core, 0, -1, reach, out, count, FREE, -1, {{0}, 0}, guess};
    place(w, q);
    for (long g = 0; g < w->groups && w->top >= 0; g++) {
        const long *group = w->group + 3 * g;
        const double *ball = w->group_ball + 4 * g;
        double centre[3], reaches = reach + ball[3];
        act(w->frames + 12 * group[0], ball, centre);
        if (!is_near(w, centre, reaches * reaches, w->top)) continue;
        for (long m = group[1]; m < group[1] + group[2]; m++) {
            s.body = w->mover[m], s.pairs = w->pair_of + m * w->bodies;
            core_of(w, s.body, &core);
            descend(&s, w->top);
            if (!out && s.verdict == TOUCHING) return TOUCHING;
        }
    }
    s.pairs = 0;
    for (long b = 0; b < w->blocks; b++) {
        const long *block = w->block + 4 * b;
        const double *ball = w->block_ball + 8 * b;
        double one[3], two[3];
        act(w->frames + 12 * block[0], ball, one), act(w->frames + 12 * block[1], ball + 4, two);
        if (are_balls_far(one, ball[3], two, ball[7], reach)) continue;
        for (const long *self = w->self + 3 * block[2], *end = self + 3 * block[3]; self < end; self += 3) {
            const double *first = w->centres + 3 * self[0], *second = w->centres + 3 * self[1];
            if (are_balls_far(first, w->ball[4 * self[0] + 3], second, w->ball[4 * self[1] + 3], reach)) continue;
            s.body = self[0], s.pair = self[2];
            core_of(w, s.body, &core);
            visit(&s, self[1], 0);
            if (!out && s.verdict == TOUCHING) return TOUCHING;
        }
    }
    return s.verdict;
}

/* Whether any pair is nearer than `clearance` at q (entries): FREE, TOUCHING or UNDECIDED. */
int manipplan_check_one(const World *w, const double *q, double clearance) { return examine(w, q, clearance, 0, 0); }

/* Whether any pair is nearer than `clearance` at each of m configurations q (m, entries): FREE, TOUCHING or UNDECIDED. */
void manipplan_check(const World *w, const double *q, long m, double clearance, signed char *verdicts) {
    for (long k = 0; k < m; k++) verdicts[k] = (signed char)examine(w, q + k * w->entries, clearance, 0, 0);
}

/* Room for the directions between pairs at m configurations along a path; 0 where one configuration does not need them. */
static double *fresh_guess(const World *w, long m) {
    if (m < 2) return 0;
    for (long k = 0; k < w->pairs; k++) memset(w->guess + GUESS * k, 0, 3 * sizeof *w->guess);
    return w->guess;
}

/* Distances (m, pairs) at q (m, entries), cut off at reach (m); nan where only coal can tell: where the bounds did not converge. */
void manipplan_distances(const World *w, const double *q, long m, const double *reach, double *out) {
    double *guess = fresh_guess(w, m);
    for (long k = 0; k < m; k++, out += w->pairs) {
        long count = 0;
        examine(w, q + k * w->entries, reach[k], &count, guess);
        for (long i = 0; i < w->pairs; i++) out[i] = reach[k];
        for (long i = 0; i < count; i++) out[w->found[i]] = w->least[w->found[i]], w->least[w->found[i]] = INFINITY;
    }
}

/* As `manipplan_distances`, but only for pairs nearer than reach (m): row * pairs + pair, and distance. Returns their number; only
   the first `room` are written. */
long manipplan_near(const World *w, const double *q, long m, const double *reach, long room, long *where, double *out) {
    double *guess = fresh_guess(w, m);
    long all = 0;
    for (long k = 0; k < m; k++) {
        long count = 0;
        examine(w, q + k * w->entries, reach[k], &count, guess);
        for (long i = 0; i < count; i++, all++) {
            long pair = w->found[i];
            if (all < room) where[all] = k * w->pairs + pair, out[all] = w->least[pair];
            w->least[pair] = INFINITY;
        }
    }
    return all;
}

/* The smallest distance of all pairs at m configurations q (m, entries), the first row and pair that have it, unless a distance is not
   below `reach`: then -1. Every `coarse`-th configuration comes first, since the smallest so far cuts off the others. Returns 0
   where only coal can tell a distance. */
int manipplan_least(const World *w, const double *q, long m, double reach, long coarse, double *least, long *row, long *nearest) {
    *least = reach, *row = 0, *nearest = -1;
    for (int fine = 0; fine < 2; fine++)
        for (long k = 0; k < m; k++) {
            if ((k % coarse != 0) != fine) continue;
            long count = 0;
            int known = 1;
            double before = *least;
            /* a little further, so that an equal distance of an earlier row is not cut off */
            examine(w, q + k * w->entries, before + 1e-9, &count, 0);
            for (long i = 0; i < count; i++) {
                long pair = w->found[i];
                double distance = w->least[pair];
                w->least[pair] = INFINITY;
                if (isnan(distance)) known = 0;
                int earlier = *nearest >= 0 && (k < *row || (k == *row && pair < *nearest));
                if (distance < *least || (distance == *least && earlier)) *least = distance, *row = k, *nearest = pair;
            }
            if (!known) return 0;
        }
    return 1;
}

/* The distance of two bodies at q (entries), where the arm is placed, cut off at reach. `leaf`: the triangle or point of the second body
   that is nearest; -1 if that is no surface, or not within reach. */
static double pair_distance(const World *w, const double *q, long one, long two, double reach, double *guess, long *leaf) {
    double out = reach;
    *leaf = -1;
    for (long j = 0; j < w->entries; j++)
        if (!isfinite(q[j])) return NAN;
    Core core;
    core_of(w, one, &core);
    Search s = {w, one, &core, 0, 0, reach, &out, 0, FREE, -1, {{0}, 0}, guess};
    visit(&s, two, 0);
    *leaf = s.leaf;
    return out;
}

/* The distance of one pair at each of m configurations, cut off at reach (m): bodies (m, 2), the second of which may stand still;
   out (m). leaf (m): the triangle or point of the second body that is nearest; -1 if that is no surface, or not within reach. */
void manipplan_pairs(const World *w, const double *q, long m, const long *bodies, const double *reach, double *out, long *leaf) {
    double guess[GUESS] = {0};
    for (long k = 0; k < m; k++) {
        long one = bodies[2 * k], two = bodies[2 * k + 1];
        if (k > 0 && (one != bodies[2 * k - 2] || two != bodies[2 * k - 1])) memset(guess, 0, sizeof guess);
        if (k == 0 || memcmp(q + k * w->entries, q + (k - 1) * w->entries, (size_t)w->entries * sizeof *q)) place(w, q + k * w->entries);
        out[k] = pair_distance(w, q + k * w->entries, one, two, reach[k], guess, leaf + k);
    }
}

/* The distance of one pair at q (entries), as `manipplan_pairs` says; `guess` (GUESS): as in the world, zeros at first. */
double manipplan_pair(const World *w, const double *q, const long *bodies, double *guess) {
    long leaf;
    place(w, q);
    return pair_distance(w, q, bodies[0], bodies[1], INFINITY, guess, &leaf);
}

/* The leaves of the second body, a surface, that are nearer than `reach` to the first one, which is convex, at q (entries): their
   distances, the nearest first, and none that the body meets. Returns their number, at most `room`; 0 for other bodies. */
long manipplan_leaves(const World *w, const double *q, const long *bodies, double reach, long room, long *leaf, double *distance) {
    long one = bodies[0], two = bodies[1];
    double point[3 * room], none = INFINITY, frame[12], centre[3];
    Leaves all = {0, room, leaf, distance, point};
    if (w->kind[one] > CYLINDER || w->kind[two] != SURFACE) return 0;
    place(w, q);
    Core core, moved;
    core_of(w, one, &core);
    Search s = {w, one, &core, 0, 0, reach, &none, 0, FREE, -1, {{0}, 0}, 0};
    s.leaves = &all;
    visit_surface(&s, two, &moved, frame, centre);
    return all.count;
}

/* The distance of the first of two bodies from a leaf of the second at q (entries), NAN where they meet. */
double manipplan_leaf(const World *w, const double *q, const long *bodies, long leaf) {
    place(w, q);
    Core core, other;
    double axes[9], towards[3], low, high, from[3];
    const double *there = w->frames + 12 * w->joint[bodies[1]];
    core_of(w, bodies[0], &core);
    leaf_core(w->corners + 9 * leaf, axes, &other), other.frame = there;
    act(there, w->corners + 9 * leaf, from);
    for (int i = 0; i < 3; i++) towards[i] = w->centres[3 * bodies[0] + i] - from[i];
    int apart = shape_bounds(w, bodies[0], &core, bodies[1], &other, towards, INFINITY, -INFINITY, &low, &high, 0, 0);
    return apart && high - low <= 1e3 * EXACT ? high : NAN;
}

/* The twist (angular velocity, velocity of the world's origin) of the frame of joint `last` in that of joint `first`, for joint
   speeds (entries) of q, in the world: joints that carry only `first` count negative. */
static void twist_of(const World *w, long first, long last, const double *speed, double *turning, double *moving) {
    for (int i = 0; i < 3; i++) turning[i] = moving[i] = 0;
    const long *with_first = w->carries + first * (w->n + 1), *with_last = w->carries + last * (w->n + 1);
    for (long j = 1; j <= w->n; j++) {
        if (with_first[j] == with_last[j]) continue;
        const double *frame = w->frames + 12 * j, fast = w->ratio[j - 1] * speed[w->leader[j - 1]];
        double own = with_last[j] ? fast : -fast;
        double axis[3], arc[3];
        for (int i = 0; i < 3; i++) axis[i] = own * dot(frame + 3 * i, w->axes + 3 * (j - 1));
        cross(frame + 9, axis, arc);
        for (int i = 0; i < 3; i++) {
            if (w->slides[j - 1]) moving[i] += axis[i];
            else turning[i] += axis[i], moving[i] += arc[i];
        }
    }
}

/* How far the first of two cores at least stays in front of the second one, along a normal that points from the second to the
   first, while each of its points p moves by t p' with |t| <= 1: linear in p, so that two support points decide. */
static double stays_apart(const Core *one, double behind, const double *normal, const double *turning, const double *moving) {
    double tilt[3], least = INFINITY;
    cross(normal, turning, tilt);
    for (int side = -1; side <= 1; side += 2) {
        double back[3], p[3];
        for (int i = 0; i < 3; i++) back[i] = -normal[i] - side * tilt[i];
        support(one, back, p);
        least = fmin(least, side * dot(normal, moving) - dot(back, p));
    }
    return least - behind;
}

/* Planes between a moving body and the leaves of a surface. */
typedef struct {
    const World *w;
    long body, obstacle;
    const Core *core;
    const double *frame;        /* of the body's joint, in the frame of the surface */
    const double *turning, *moving; /* twist of the body relative to the surface, in the world */
    double reach, needed, bend; /* leaves beyond `reach` do not count; the others have to stay `needed` away, while points of the body
                                   move by `bend` beyond the twist [m] */
    int planes;
    double normal[MOST_PLANES][3], front[MOST_PLANES]; /* in the frame of the surface: what is behind the front stays away */
} Fence;

static int is_behind(const Fence *f, const double *box) {
    for (int k = f->planes - 1; k >= 0; k--) {
        const double *d = f->normal[k];
        if (d[0] * box[d[0] > 0 ? 3 : 0] + d[1] * box[d[1] > 0 ? 4 : 1] + d[2] * box[d[2] > 0 ? 5 : 2] <= f->front[k]) return 1;
    }
    return 0;
}

/* Put the plane at the nearest points of the body and a leaf into the fence. Returns whether that leaf stays behind it. */
static int fence_off(Fence *f, const double *corners, const double *direction) {
    const World *w = f->w;
    const double *there = w->frames + 12 * w->joint[f->obstacle];
    double axes[9], towards[3], low, high, radii = w->radius[f->body] + w->radius[f->obstacle], most = -INFINITY, origin;
    Core leaf;
    Plane plane;
    leaf_core(corners, axes, &leaf), leaf.frame = there;
    memcpy(towards, direction, sizeof towards);
    if (!bounds(f->core, &leaf, towards, f->reach + radii, -INFINITY, EXACT, &low, &high, &plane, 0)) return 0;
    if (low > f->reach + radii) return 1;
    if (!(low > APART)) return 0;
    int at = f->planes++;
    double *normal = f->normal[at];
    turn_back(there, plane.normal, normal), origin = dot(plane.normal, there + 9);
    f->front[at] = stays_apart(f->core, origin, plane.normal, f->turning, f->moving) - radii - f->bend - f->needed;
    for (int k = 0; k < 3; k++) most = fmax(most, dot(normal, corners + 3 * k));
    return most <= f->front[at];
}

/* Whether all leaves below a node stay away from the body. */
static int is_fenced(Fence *f, long node) {
    const World *w = f->w;
    const double *box = w->node_box + 6 * node;
    double middle[3], half[3], direction[3], extra = w->radius[f->obstacle];
    if (is_behind(f, box)) return 1;
    for (int i = 0; i < 3; i++) middle[i] = (box[i] + box[3 + i]) / 2, half[i] = (box[3 + i] - box[i]) / 2;
    if (is_outside(w, middle, sqrt(dot(half, half)), f->body, f->frame, f->reach + extra)) return 1;
    const long *child = w->node + 2 * node;
    if (child[0] >= 0) return is_fenced(f, child[0]) && is_fenced(f, child[1]);
    if (f->planes == MOST_PLANES) return 0;
    const double *c = w->corners + 9 * child[1], *there = w->frames + 12 * w->joint[f->obstacle];
    act(there, middle, direction);
    for (int i = 0; i < 3; i++) direction[i] = w->centres[3 * f->body + i] - direction[i];
    return is_triangle_outside(c, w->local + 6 * f->body, f->frame, f->reach + extra) || fence_off(f, c, direction);
}

/* As `manipplan_pairs`, with lower bounds (m) of the distances while the joints move by t slopes (m, entries) with |t| <= 1 and, beyond
   that, no point of a body of a pair moves relative to the other by more than bends (m), and altogether by more than motions (m).
   -INFINITY where there is none: between surfaces, where cores meet, and for what is beyond reach. To a surface the bound is reach - motion,
   which what is beyond reach keeps, or there is none. */
void manipplan_intervals(const World *w, const double *q, const double *slopes, long m, const long *bodies, const double *reach,
                         const double *bends, const double *motions, double *out, double *bound) {
    double guess[GUESS] = {0};
    for (long k = 0; k < m; k++, slopes += w->entries) {
        long one = bodies[2 * k], two = bodies[2 * k + 1], leaf, same = k > 0 && one == bodies[2 * k - 2] && two == bodies[2 * k - 1];
        if (!same) memset(guess, 0, sizeof guess);
        if (k == 0 || memcmp(q + k * w->entries, q + (k - 1) * w->entries, (size_t)w->entries * sizeof *q)) place(w, q + k * w->entries);
        bound[k] = -INFINITY;
        int carried = w->kind[two] == HALFSPACE && w->joint[one] < w->joint[two];
        if (w->kind[two] == SURFACE && w->kind[one] <= CYLINDER && w->joint[one] >= w->joint[two] && isfinite(bends[k])) {
            out[k] = pair_distance(w, q + k * w->entries, one, two, reach[k], guess, &leaf);
            if (leaf < 0 || !(out[k] > 0 && out[k] < reach[k])) continue;
            Core core;
            double frame[12], turning[3], moving[3], direction[3];
            const double *there = w->frames + 12 * w->joint[two];
            core_of(w, one, &core), relative(there, w->frames + 12 * w->joint[one], frame);
            twist_of(w, w->joint[two], w->joint[one], slopes, turning, moving);
            Fence f = {w, one, two, &core, frame, turning, moving, reach[k], reach[k] - motions[k], bends[k], 0, {{0}}, {0}};
            act(there, w->corners + 9 * leaf, direction);
            for (int i = 0; i < 3; i++) direction[i] = w->centres[3 * one + i] - direction[i];
            if (fence_off(&f, w->corners + 9 * leaf, direction) && is_fenced(&f, w->root[two])) bound[k] = f.needed;
            continue;
        }
        if (w->kind[one] > CYLINDER || w->kind[two] > HALFSPACE || carried || !isfinite(bends[k])) {
            double fresh[GUESS] = {0};
            int is_surface = w->kind[one] == SURFACE || w->kind[two] == SURFACE;
            out[k] = pair_distance(w, q + k * w->entries, one, two, reach[k], is_surface ? guess : fresh, &leaf);
            continue;
        }
        Core first, second;
        Plane plane;
        double low, high, radii = w->radius[one] + w->radius[two], back[3], p[3];
        core_of(w, one, &first);
        if (w->kind[two] == HALFSPACE) {
            double frame[12];
            compose(w->frames + 12 * w->joint[two], w->pose + 12 * two, frame);
            for (int i = 0; i < 3; i++) plane.normal[i] = frame[3 * i + 2], p[i] = frame[9 + i];
            low = high = over_plane(w, one, &first, two);
        } else {
            core_of(w, two, &second);
            if (!(dot(guess, guess) > 0))
                for (int i = 0; i < 3; i++) guess[i] = w->centres[3 * one + i] - w->centres[3 * two + i];
            if (!shape_bounds(w, one, &first, two, &second, guess, reach[k], -INFINITY, &low, &high, &plane, 0)) {
                double fresh[GUESS] = {0};
                out[k] = pair_distance(w, q + k * w->entries, one, two, reach[k], fresh, &leaf);
                continue;
            }
            support(&second, plane.normal, p);
        }
        out[k] = low > reach[k] ? reach[k] : high - low <= 1e3 * EXACT ? high : NAN;
        if (isnan(out[k]) || out[k] >= reach[k]) continue;
        double turning[3], moving[3];
        if (w->joint[one] >= w->joint[two]) {
            twist_of(w, w->joint[two], w->joint[one], slopes, turning, moving);
            bound[k] = stays_apart(&first, dot(plane.normal, p), plane.normal, turning, moving) - radii - bends[k];
        } else {
            for (int i = 0; i < 3; i++) back[i] = -plane.normal[i];
            support(&first, back, p);
            twist_of(w, w->joint[one], w->joint[two], slopes, turning, moving);
            bound[k] = stays_apart(&second, dot(back, p), back, turning, moving) - radii - bends[k];
        }
    }
}

/* The nearest points of the cores of two bodies in the world, their signed distance, and the unit vector from the second to the
   first; of a body inside a solid it leads out. `leaf`: of the second body, which counts alone; -1: the nearest. `guess` (GUESS): as in
   the world, for this pair. Returns 0 where the cores nearly touch, or this code cannot tell. */
static int nearest_points(const World *w, long one, long two, long leaf, double *guess, double *a, double *b, double *distance, double *normal) {
    int kind = (int)w->kind[two], own = (int)w->kind[one];
    if (kind == UNKNOWN || own == UNKNOWN || own == HALFSPACE) return 0;
    if (own == SURFACE && kind <= CYLINDER) {
        int known = nearest_points(w, two, one, -1, guess, b, a, distance, normal);
        for (int i = 0; known && i < 3; i++) normal[i] = -normal[i];
        return known;
    }
    Core core, other;
    core_of(w, one, &core);
    double towards[3], axes[9], own_axes[9], low, high;
    int inside = 0;
    if (kind == HALFSPACE) {
        double frame[12];
        compose(w->frames + 12 * w->joint[two], w->pose + 12 * two, frame);
        for (int i = 0; i < 3; i++) normal[i] = frame[3 * i + 2];
        *distance = lowest(w, one, &core, frame, a);
        for (int i = 0; i < 3; i++) b[i] = a[i] - *distance * normal[i];
        return 1;
    }
    if (leaf >= 0) {
        const double *there = w->frames + 12 * w->joint[two];
        double from[3];
        leaf_core(w->corners + 9 * leaf, axes, &other), other.frame = there;
        act(there, w->corners + 9 * leaf, from);
        for (int i = 0; i < 3; i++) towards[i] = w->centres[3 * one + i] - from[i];
    } else if (kind == SURFACE) {
        double least = INFINITY;
        const double *there = w->frames + 12 * w->joint[two];
        Search s = {w, one, &core, 0, 0, INFINITY, &least, 0, FREE, -1, {{0}, 0}, guess};
        visit_solid(&s, two);
        if (isnan(least) || s.leaf < 0) return 0;
        inside = s.inside;
        leaf_core(w->corners + 9 * s.leaf, axes, &other), other.frame = there;
        if (own == SURFACE) leaf_core(w->corners + 9 * s.own, own_axes, &core), core.frame = w->frames + 12 * w->joint[one];
        for (int i = 0; i < 3; i++) towards[i] = dot(there + 3 * i, s.plane.normal);
    } else {
        core_of(w, two, &other);
        for (int i = 0; i < 3; i++) towards[i] = w->centres[3 * one + i] - w->centres[3 * two + i];
    }
    Simplex s;
    if (!bounds(&core, &other, towards, INFINITY, -INFINITY, EXACTEST, &low, &high, 0, &s)) {
        if (inside || !depth_of(&core, &other, &s, distance, normal, a, b)) return 0;
        *distance = -*distance;
        return 1;
    }
    if (high - low > 1e3 * EXACT || high < APART || !nearest_of(&s, a, b)) return 0;
    *distance = sqrt(dot(s.nearest, s.nearest));
    for (int i = 0; i < 3; i++) normal[i] = s.nearest[i] / *distance;
    double radii = w->radius[one] + w->radius[two];
    if (inside && *distance > radii) {                      /* out[0] will be minus the distance from the surface */
        *distance = 2 * radii - *distance;
        for (int i = 0; i < 3; i++) normal[i] = -normal[i];
    }
    return 1;
}

/* The nearest points of the cores of pairs bodies (m, 2) at q (m, entries). leaf (m): of the second body, a surface, which counts alone;
   -1: the nearest. out (m, 13 + entries): signed distance of the bodies; unit vector
   from the second to the first in the frame of the second's joint, and its opposite in that of the first's; the two points in the
   frames of their joints; gradient of the distance by q. nan where only coal can tell. */
void manipplan_witnesses(const World *w, const double *q, long m, const long *bodies, const long *leaf, double *out) {
    double guess[GUESS] = {0};
    for (long k = 0; k < m; k++, q += w->entries, out += 13 + w->entries) {
        if (k > 0 && memcmp(bodies + 2 * k, bodies + 2 * k - 2, 2 * sizeof *bodies)) memset(guess, 0, sizeof guess);
        long one = bodies[2 * k], two = bodies[2 * k + 1], first = w->joint[one], second = w->joint[two];
        double a[3], b[3], distance, normal[3], back[3];
        int finite = 1;
        for (long j = 0; j < w->entries; j++) finite &= isfinite(q[j]) != 0;
        if (finite) place(w, q);
        if (!finite || !nearest_points(w, one, two, leaf[k], guess, a, b, &distance, normal)) {
            for (long i = 0; i < 13 + w->entries; i++) out[i] = NAN;
            continue;
        }
        const double *here = w->frames + 12 * first, *there = w->frames + 12 * second;
        for (int i = 0; i < 3; i++) back[i] = -normal[i];
        out[0] = distance - w->radius[one] - w->radius[two];
        turn_back(there, normal, out + 1), turn_back(here, back, out + 4);
        place_back(here, a, out + 7), place_back(there, b, out + 10);
        memset(out + 13, 0, (size_t)w->entries * sizeof *out);
        for (long j = 1; j <= w->n; j++) {
            const double *frame = w->frames + 12 * j, *own = w->axes + 3 * (j - 1);
            double slope = 0, axis[3];
            for (int i = 0; i < 3; i++) axis[i] = dot(frame + 3 * i, own);
            for (int side = 0; side < 2; side++) {
                const double *p = side ? b : a;
                if (!w->carries[(side ? second : first) * (w->n + 1) + j]) continue;
                double lever[3] = {p[0] - frame[9], p[1] - frame[10], p[2] - frame[11]};
                double moved[3];
                cross(axis, lever, moved);
                slope += (side ? -1 : 1) * dot(normal, w->slides[j - 1] ? axis : moved);
            }
            out[13 + w->leader[j - 1]] += w->ratio[j - 1] * slope;
        }
    }
}

static double middle(const double *box, int axis) { return box[axis] + box[3 + axis]; }

/* Order items so that the one at `at` has no item with a larger middle before it and none with a smaller one after it. */
static void halve(const double *box, long *item, long count, long at, int axis) {
    long low = 0, high = count - 1;
    while (low < high) {
        double pivot = middle(box + 6 * item[(low + high) / 2], axis);
        long i = low, j = high;
        while (i <= j) {
            while (middle(box + 6 * item[i], axis) < pivot) i++;
            while (middle(box + 6 * item[j], axis) > pivot) j--;
            if (i <= j) { long kept = item[i]; item[i++] = item[j], item[j--] = kept; }
        }
        if (at <= j) high = j;
        else if (at >= i) low = i;
        else return;
    }
}

/* A tree over `count` boxes, from node `root` on: 2 count - 1 nodes. `item` (count) holds the numbers of the boxes and is
   reordered; `name` (boxes): the number that a leaf stores. Returns the number of the next free node. */
long manipplan_tree(const double *box, long *item, long count, const long *name, long root, double *node_box, long *node) {
    double *all = node_box + 6 * root;
    memcpy(all, box + 6 * item[0], 6 * sizeof *all);
    for (long k = 1; k < count; k++)
        for (int i = 0; i < 3; i++) {
            const double *each = box + 6 * item[k];
            if (each[i] < all[i]) all[i] = each[i];
            if (each[3 + i] > all[3 + i]) all[3 + i] = each[3 + i];
        }
    if (count == 1) {
        node[2 * root] = -1, node[2 * root + 1] = name[item[0]];
        return root + 1;
    }
    int axis = 0;
    for (int i = 1; i < 3; i++)
        if (all[3 + i] - all[i] > all[3 + axis] - all[axis]) axis = i;
    halve(box, item, count, count / 2, axis);
    node[2 * root] = root + 1;
    long next = manipplan_tree(box, item, count / 2, name, root + 1, node_box, node);
    node[2 * root + 1] = next;
    return manipplan_tree(box, item + count / 2, count - count / 2, name, next, node_box, node);
}
