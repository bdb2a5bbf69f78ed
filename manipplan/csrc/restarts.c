/* The search of guilamo2006 by restarts, which can be interrupted between calls. All arrays belong to the caller. */

#include "near.h"

enum { UNFINISHED, FOUND, EXHAUSTED, TOO_MANY };  /* return status of a call; as in guilamo.py */
enum { NEXT, UP, DOWN };  /* take the next start, extend the path to the last layer, extend it to the first one */

/* Candidates of all layers, each layer in descending order of manipulability. */
typedef struct {
    long n, layers, count;
    const double *q, *m;    /* (count, n), (count) */
    const long *offset;     /* (layers + 1) start of each layer */
    const long *starts;     /* (starting) candidates in the order in which they start a path */
    const long *layer_of;   /* (count) */
    const double *reach;    /* (n) */
    const char *turns;      /* (n) */
    long starting, memoised, most_branches;
} Problem;

typedef struct {
    long phase, level, starts, branches, comparisons;
    long *path, *pointer;   /* (layers) */
    long *seen;             /* (count) the last start for which a candidate was in the path */
} State;

/* Continue the search for about `budget` comparisons of configurations. */
long manipplan_restarts(const Problem *p, long budget, State *s) {
    long stop = s->comparisons + budget;
    while (s->comparisons < stop) {
        if (s->phase == NEXT) {
            if (s->starts == p->starting) return EXHAUSTED;
            long start = p->starts[s->starts++], level = p->layer_of[start];
            s->path[level] = start;
            s->level = level, s->phase = UP;
            if (level < p->layers - 1) s->pointer[level + 1] = p->offset[level + 1];
        }
        long start = p->starts[s->starts - 1], first = p->layer_of[start];
        double least = p->m[start];
        if (s->phase == UP && s->level == p->layers - 1) {
            s->phase = DOWN, s->level = first;
            if (first > 0) s->pointer[first - 1] = p->offset[first - 1];
        }
        if (s->phase == DOWN && s->level == 0) return FOUND;
        long ahead = s->phase == UP ? 1 : -1, following = s->level + ahead;
        long i = s->pointer[following], end = p->offset[following + 1], found = 0;
        const double *here = p->q + p->n * s->path[s->level];
        for (; i < end && p->m[i] >= least; i++) {
            if (p->memoised && s->seen[i] == s->starts) continue;
            s->comparisons++;
            if (is_near(here, p->q + p->n * i, p->n, p->reach, p->turns)) {
                found = 1;
                break;
            }
        }
        if (found) {
            if (s->branches >= p->most_branches) {
                s->pointer[following] = i;
                return TOO_MANY;
            }
            s->pointer[following] = i + 1;
            s->path[following] = i;
            s->seen[i] = s->starts;
            s->branches++;
            s->level = following;
            long beyond = following + ahead;
            if (beyond >= 0 && beyond < p->layers) s->pointer[beyond] = p->offset[beyond];
        } else if (s->level == first) {  /* this half has no path: the start fails */
            s->phase = NEXT;
        } else {
            s->level -= ahead;
        }
    }
    return UNFINISHED;
}
