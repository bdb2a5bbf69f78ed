/* The controller in C: a step and a rollout around the step that CasADi generated (manipplan_step). */
#include "controller.h"

#include <stdlib.h>

#ifndef casadi_int
#define casadi_int long long int
#endif

int manipplan_step(const double** arg, double** res, casadi_int* iw, double* w, int mem);
int manipplan_step_work(casadi_int* sz_arg, casadi_int* sz_res, casadi_int* sz_iw, casadi_int* sz_w);
int manipplan_step_checkout(void);
void manipplan_step_release(int mem);
void manipplan_step_incref(void);
void manipplan_step_decref(void);

struct controller {
    const double** arg;
    double** res;
    casadi_int* iw;
    double* w;
    int mem;
    double memory[CONTROLLER_MEMORY + 1];
    double next_memory[CONTROLLER_MEMORY + 1];
};

controller* controller_new(void) {
    casadi_int arg, res, iw, w;
    controller* c = calloc(1, sizeof(controller));
    if (!c || manipplan_step_work(&arg, &res, &iw, &w)) {
        free(c);
        return NULL;
    }
    c->arg = calloc((size_t)arg + 1, sizeof(*c->arg));
    c->res = calloc((size_t)res + 1, sizeof(*c->res));
    c->iw = calloc((size_t)iw + 1, sizeof(*c->iw));
    c->w = calloc((size_t)w + 1, sizeof(*c->w));
    manipplan_step_incref();
    c->mem = manipplan_step_checkout();
    if (!c->arg || !c->res || !c->iw || !c->w || c->mem < 0) {
        controller_free(c);
        return NULL;
    }
    return c;
}

void controller_free(controller* c) {
    if (!c) return;
    if (c->mem >= 0) manipplan_step_release(c->mem);
    manipplan_step_decref();
    free(c->arg);
    free(c->res);
    free(c->iw);
    free(c->w);
    free(c);
}

void controller_reset(controller* c) {
    for (int i = 0; i < CONTROLLER_MEMORY; ++i) c->memory[i] = 0.0;
}

int controller_step(controller* c, const double* q, const double* qd, const double* qdd, const double* target,
                    double stiffness, double drive, const double* tolerance, const double* obstacles,
                    double* velocity, double* report) {
    c->arg[0] = q;
    c->arg[1] = qd;
    c->arg[2] = qdd;
    c->arg[3] = target;
    c->arg[4] = &stiffness;
    c->arg[5] = &drive;
    c->arg[6] = tolerance;
    c->arg[7] = obstacles;
    c->arg[8] = c->memory;
    c->res[0] = velocity;
    c->res[1] = report;
    c->res[2] = c->next_memory;
    if (manipplan_step(c->arg, c->res, c->iw, c->w, c->mem)) return -1;
    for (int i = 0; i < CONTROLLER_MEMORY; ++i) c->memory[i] = c->next_memory[i];
    return (int)report[0];
}

int controller_rollout(controller* c, int steps, const double* targets, const double* stiffness, const double* drive,
                       const double* tolerances, const double* obstacles, double* q, double* qd, double* qdd,
                       double* report) {
    for (int k = 0; k < steps; ++k) {
        const double *at = q + k * CONTROLLER_JOINTS, *moves = qd + k * CONTROLLER_JOINTS;
        double *next = q + (k + 1) * CONTROLLER_JOINTS, *velocity = qd + (k + 1) * CONTROLLER_JOINTS;
        int status = controller_step(c, at, moves, qdd, targets + 16 * k, stiffness[k], drive[k], tolerances + 2 * k,
                                     obstacles + CONTROLLER_OBSTACLES * k, velocity, report + CONTROLLER_REPORT * k);
        if (status < 0) return status;
        for (int i = 0; i < CONTROLLER_JOINTS; ++i) {
            next[i] = at[i] + CONTROLLER_DT * velocity[i];
            qdd[i] = (velocity[i] - moves[i]) / CONTROLLER_DT;
        }
    }
    return 0;
}
