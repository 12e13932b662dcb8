/* norm.h: every error norm and the ledger of energy and momentum, the same for every solver. */
#ifndef MPMLAB_NORM_H
#define MPMLAB_NORM_H

#include "common/contract/points.h"
#include "common/contract/problem.h"

/* max e, sqrt(sum w e^2 / sum w), sum w e / sum w over points with mass, w = V0, divided by the
 * scene's scale (CONTRACT: error_*). NAN where nothing was measured: a maximum over no points is
 * not 0. */
typedef struct Errors {
    double linf, l2, l1;
} Errors;

extern const Errors no_errors; /* all NAN */

/* Room for n points' worth of vectors, for the functions below. Owned by the run. */
typedef struct Scratch {
    int room;
    double *v[DIM], *w;
} Scratch;

bool norm_scratch_fit(Scratch *s, int n); /* false: out of memory */
void norm_scratch_free(Scratch *s);

/* e = |x - X - u_exact(X, t)|, W11 eq 38; leaves each point's e over the scale in s->w. */
Errors norm_displacement(const Scene *scene, const Points *p, double t, Scratch *s);

/* e = |v_i - v(x_i)| / |v(x_i)| over nodes with mass inside the body, equal weights, W07 eq 3.1. */
Errors norm_projection(const Scene *scene, const Nodes *n, Scratch *s);

/* Volume now, sum V0 J [m^DIM], and the extremes of J. */
typedef struct Volumes {
    double sum, least, most;
} Volumes;

Volumes ledger_volumes(const Samples *q);
double ledger_kinetic(const Points *p);                                 /* [J] */
double ledger_strain(const Scene *scene, const Samples *q, Scratch *s); /* [J] */

/* [kg m^2/s] Angular momentum about the centre of mass: in 2D only the component along z, in 1D
 * none; the others are NAN. */
void ledger_angular_momentum(const Points *p, double out[3]);
double ledger_momentum(const Points *p, Vec out); /* [kg m/s]; returns sum of m |v| */

/* [J] Work of the body forces of time t on the way of each point from from[DIM][id]: sum of
 * m b(X, t) . (x - from). Velocities do not enter: FLIP particles do not move with their own. */
double body_work(const Scene *scene, const Points *p, ConstFields from, double t, Scratch *s);

/* Id of the fastest point with mass (the lowest of equals; -1: none), and its speed [m/s]. */
int ledger_fastest_point(const Points *p, double *speed);

#endif
