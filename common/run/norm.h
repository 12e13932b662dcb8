/* norm.h: every error norm, the same for every solver. */
#ifndef MPMLAB_NORM_H
#define MPMLAB_NORM_H

#include "common/contract/points.h"
#include "common/contract/problem.h"

/* max e, sqrt(sum w e^2 / sum w), sum w e / sum w over points with mass. NAN where nothing was
 * measured: a maximum over no points is not 0. */
typedef struct Errors {
    double linf, l2, l1;
} Errors;

extern const Errors norm_no_errors; /* all NAN */

/* Room for n points' worth of vectors, for the functions below. Owned by the run. */
typedef struct Scratch {
    int room;
    double *v[DIM], *w;
} Scratch;

bool norm_scratch_fit(Scratch *s, int n); /* false: out of memory */
void norm_scratch_free(Scratch *s);

/* e = |x - X - u_exact(X, t)| / scale, W11 eq 38, scale = scene->error_scale, weights V0; leaves
 * each point's e in s->w. */
Errors norm_displacement(const Scene *scene, const Points *p, double t, int threads, Scratch *s);

/* e = |v_i - v(x_i)| / |v(x_i)| over nodes with mass inside the body, equal weights, W07 eq 3.1. */
Errors norm_projection(const Scene *scene, const Nodes *n, Scratch *s);

#endif
