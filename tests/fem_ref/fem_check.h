/* fem_check.h: what the tests of the FEM share. */
#ifndef MPMLAB_FEM_CHECK_H
#define MPMLAB_FEM_CHECK_H

#include "fem_ref/fem.h"
#include "tests/check.h"

static inline Fem *make(const Scene *s, int cells, int threads)
{
    Fault fault = {0};
    Setup setup = {.scene = s, .cells = cells, .integrator = CD, .threads = threads};
    check_context(DIM, s->problem ? s->problem->info.name : NULL, "fem", "cd", NULL);
    Fem *f = solver_fem.make(&setup, &fault);
    CU_ASSERT_PTR_NOT_NULL_FATAL(f);
    return f;
}

static inline double kinetic(const Fem *f)
{
    double sum = 0;
    for (int d = 0; d < DIM; d++)
        for (int i = 0; i < f->nodes; i++) sum += 0.5 * f->m[i] * f->v[d][i] * f->v[d][i];
    return sum;
}

#endif
