/* bounce.h: energies of a body that flies into a corner of two walls, from the history of a run:
 * W11 fig. 8 and the ball in 3D. Kinetic energy is least when the body is at rest against the
 * floor, before t = 1.6; the energy after the rebound is taken at t = 2.3, before it meets the
 * right wall. */
#ifndef MPMLAB_BOUNCE_H
#define MPMLAB_BOUNCE_H

#include "studies/study.h"

/* NAN where the history does not get so far. */
typedef struct Bounce {
    double start;  /* E0 [J] */
    Measure least; /* kinetic energy over E0, before t = 1.6 */
    double at;     /* and when */
    Measure over;  /* largest total energy over E0 before 2.3, less 1 */
    double back;   /* total energy over E0 at t = 2.3 */
    Measure jump;  /* largest change of the total energy in one step of the whole run, over E0 */
} Bounce;

/* Instants that a history must have: before t = 1.6, before 2.3, in all. */
typedef struct BounceNeeds {
    int fall, back, whole;
} BounceNeeds;

Bounce bounce_read(const Table *history, BounceNeeds needs);

#endif
