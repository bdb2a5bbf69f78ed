/* Evaluates a symbolic function at many configurations: its instructions, one after the other, on blocks of vectors. */

#include <stdlib.h>
#include <string.h>
#include "vectors.h"

typedef struct {
    long code;      /* an operation, or one of the next four */
    long result;    /* slot of the result; of an output its index */
    long second;    /* slot of the cosine, beside the sine in `result` */
    long a, b;      /* slots of the arguments */
    double value;   /* of a constant */
} Instruction;

enum { CONSTANT = -1, SINE_COSINE = -2, FAR_SINE_COSINE = -3, OUTPUT = -4 };

typedef struct {
    long n, outputs;        /* numbers of inputs, which are in the first slots, and of outputs */
    long count, slots;      /* of instructions, and of vectors at a time */
    const Instruction *instructions;
    const long *turning;    /* (n) whether full turns of an input do not count */
    long evaluations;       /* so far */
} Program;

#define X(name, value) name##_,
enum { OPERATIONS(X) };
#undef X

enum { BLOCK = 4, ALIGNMENT = 64 };

/* Evaluates at `many` vectors of configurations. */
static void evaluate(const Program *p, const double *q, double *out, vec *slot, int many, int *bad) {
    const long n = p->n, outputs = p->outputs;
    for (long i = 0; i < n; ++i)
        for (int v = 0; v < many; ++v)
            for (int l = 0; l < W; ++l) slot[i * many + v][l] = q[(v * W + l) * n + i];
    if (__builtin_expect(some_far(q, many * n), 0))
        for (long i = 0; i < n; ++i)
            for (int v = 0; v < many; ++v)
                for (int l = 0; l < W; ++l) slot[i * many + v][l] = tamed(slot[i * many + v][l], p->turning[i], bad);
    for (const Instruction *each = p->instructions, *end = each + p->count; each < end; ++each) {
        vec *r = slot + each->result * many, *c = slot + each->second * many;
        const vec *a = slot + each->a * many, *b = slot + each->b * many;
        switch (each->code) {
        case CONSTANT:
            for (int v = 0; v < many; ++v) r[v] = zero + each->value;
            break;
        case SINE_COSINE:
            for (int v = 0; v < many; ++v) sine_cosine(a[v], r + v, c + v);
            break;
        case FAR_SINE_COSINE:
            for (int v = 0; v < many; ++v) far_sine_cosine(a[v], r + v, c + v);
            break;
        case OUTPUT:
            for (int v = 0; v < many; ++v)
                for (int l = 0; l < W; ++l) out[(v * W + l) * outputs + each->result] = a[v][l];
            break;
#define X(name, value) case name##_: for (int v = 0; v < many; ++v) r[v] = op_##name(a[v], b[v]); break;
        OPERATIONS(X)
#undef X
        }
    }
}

/* out (count, outputs) of q (count, n); returns 1 where an entry of q is not finite, or memory is missing. */
int manipplan_batch(Program *p, const double *q, double *out, long count) {
    const long n = p->n, outputs = p->outputs, many = count > W ? BLOCK : 1;
    const size_t size = (size_t)(p->slots * many) * sizeof(vec), rest = (size_t)(W * (n + outputs)) * sizeof(double);
    char *memory = malloc(size + rest + ALIGNMENT);
    if (!memory) return 1;
    vec *slot = (vec *)(((size_t)memory + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT);
    double *last = (double *)((char *)slot + size), *results = last + W * n;
    int bad = 0;
    long k = 0;
    for (; k + BLOCK * W <= count; k += BLOCK * W) evaluate(p, q + k * n, out + k * outputs, slot, BLOCK, &bad);
    for (; k < count; k += W) {
        const long some = count - k < W ? count - k : W;
        memset(last, 0, (size_t)(W * n) * sizeof(double));
        memcpy(last, q + k * n, (size_t)(some * n) * sizeof(double));
        evaluate(p, last, results, slot, 1, &bad);
        memcpy(out + k * outputs, results, (size_t)(some * outputs) * sizeof(double));
    }
    free(memory);
    p->evaluations += count;
    return bad;
}
