/* probe.h: points that a history follows (--probe), and what the walls do to the body. */
#ifndef MPMLAB_PROBE_H
#define MPMLAB_PROBE_H

#include "common/base/spec.h"
#include "common/contract/solver.h"

/* The points followed, by id, and room for the stress of all points. */
typedef struct Probes {
    int n, room; /* points; slots of `fields` */
    int id[SPEC_PROBES];
    double *fields; /* [2 NMAT][room], or NULL */
} Probes;

/* Momentum [kg m/s] that walls had given at the last measurement. */
typedef struct Reactions {
    Vec walls;
} Reactions;

/* Refuses a probe with the wrong number of coordinates, or outside the reference body. 0 or a
 * fault. */
int probe_check(const RunSpec *spec, const Scene *scene, Fault *fault);

/* Finds the point whose reference position is nearest to each probe, the lowest id of equally near
 * ones (to 1e-9 of their distance to the probe); call before the first step. */
void probe_find(Probes *p, const RunSpec *spec, const Solver *solver, const void *self);

/* u = x - X and Cauchy stress of each probe's point. False: no memory. */
bool probe_measure(Probes *p, const Scene *scene, const Solver *solver, const void *self,
                   double out[][PROBE_COLUMNS]);
void probe_free(Probes *p);

/* Force [N] of each wall on the body over the last dt [s]: what the momentum balance leaves after
 * the body forces. 0 along axes that the wall leaves free. NAN along an axis on which several walls
 * act, because the balance knows their sum only. */
void probe_reactions(Reactions *r, const Scene *scene, const Solver *solver, const void *self,
                     double dt, double out[][3]);

#endif
