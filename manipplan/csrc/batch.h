/* A function of configurations: `run` writes its values (count, m) at q (count, n), and returns 0 where all of q and all values
   that it needs are finite. */

#pragma once
typedef struct {
    int (*run)(const void *program, const double *q, double *out, long count);
    const void *program;
} Batch;
