/* wls_check.h: a run of the particle core under the tests' own hand. */
#ifndef MPMLAB_WLS_CHECK_H
#define MPMLAB_WLS_CHECK_H

#include <stdio.h>
#include <string.h>
#include "common/run/plan.h"
#include "common/core/step.h"
#include "tests/check.h"

typedef struct Trial {
    RunSpec spec;
    Plan plan;
    Sim *sim;
} Trial;

/* `set`: "name=value,name=value" or NULL. */
static inline void trial_open(Trial *t, const char *problem, const char *method, int cells,
                              const char *set, int threads)
{
    Fault fault = {0};
    char text[256] = "";
    *t = (Trial){.spec = {.cells = cells, .threads = threads}};
    snprintf(t->spec.problem, sizeof t->spec.problem, "%s", problem);
    snprintf(t->spec.method, sizeof t->spec.method, "%s", method);
    check_context(DIM, problem, method, NULL, set);
    if (set) snprintf(text, sizeof text, "%s", set);
    for (char *s = strtok(text, ","); s; s = strtok(NULL, ","))
        CU_ASSERT_FATAL(spec_set(&t->spec, s, &fault) == 0);
    CU_ASSERT_FATAL(plan_make(&t->spec, &t->plan, &fault) == 0);
    t->sim = sim_new(&t->plan.setup, &fault);
    CU_ASSERT_FATAL(t->sim != NULL);
    sim_sort(t->sim);
}

static inline void trial_close(Trial *t)
{
    sim_free(t->sim);
}

/* Radial displacement of the scene's exact solution at (R, 0), t = 0. */
static inline double trial_displacement(const Trial *t, double R)
{
    const Vec X = {R, 0};
    Vec u;
    const double *in[] = {&X[0], &X[1]};
    double *out[] = {&u[0], &u[1]};
    t->plan.scene.problem->exact(&t->plan.scene, 1, in, 0, out);
    return u[0];
}

#endif
