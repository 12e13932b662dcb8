/* ledger.h: energy, momentum, work and volume of all points at one instant, the same for every
 * solver. */
#ifndef MPMLAB_LEDGER_H
#define MPMLAB_LEDGER_H

#include "norm.h"

/* Energy and momentum at a half step: before or after a time step. */
typedef struct Side {
    double kinetic, mv; /* [J] [kg m/s] sum m |v| */
    Vec p;              /* [kg m/s] */
} Side;

/* Volume now, sum V0 J [m^DIM], and the extremes of J. */
typedef struct Volumes {
    double sum, least, most;
} Volumes;

Volumes ledger_volumes(const Samples *q);

/* Kinetic energy and momentum; stored energy [J]. The scratch has room for the points, and at least
 * for a chunk. */
Side ledger_motion(const Points *p, int threads, Scratch *s);
double ledger_strain(const Scene *scene, const Samples *q, int threads, Scratch *s);

/* [kg m^2/s] Angular momentum about the centre of mass: in 2D only the component along z, in 1D
 * none; the others are NAN. */
void ledger_angular_momentum(const Points *p, double out[3]);

/* Position and body force of a point at one instant. */
typedef struct BodyLoad {
    Vec x, b; /* [m], [m/s^2] */
} BodyLoad;

/* [J] Work of the body forces on each point's displacement since an instant before, at which it was
 * at before[id]: the sum of m (b + b_before)/2 . (x - x_before), b = b(X, t). FLIP particles do not
 * move with their own velocities, so these do not enter. before[] is replaced by the values of t.
 */
double ledger_work(const Scene *scene, const Points *p, double t, BodyLoad before[], int threads,
                   Scratch *s);

/* Id of the fastest point with mass (the lowest of equals; -1: none), and its speed [m/s]. */
int ledger_fastest_point(const Points *p, double *speed);

#endif
