/* bodies.h: the sims of a scene with one body or two, seen as one. */
#ifndef MPMLAB_BODIES_H
#define MPMLAB_BODIES_H

#include "contact.h"
#include "step.h"

/* Particles of two bodies, one after the other, in n slots. */
typedef struct Joined {
    bool fresh; /* those of now */
    int n;
    double *field[FIELDS];
    int *id;
} Joined;

typedef struct Bodies {
    int n;
    Sim *sim[MAX_BODIES];
    Setup setup[MAX_BODIES]; /* of two bodies, with the scene of each */
    Scene scene[MAX_BODIES];
    Contact contact;
    Joined *both; /* NULL with one body */
} Bodies;

/* Makes one Sim (particles and grid) per body of the scene of `setup`. Returns false and fills the
 * fault on failure; call bodies_free in either case. */
bool bodies_make(Bodies *b, const Setup *setup, Fault *fault);
void bodies_free(Bodies *b);

/* One step of all (sim_step). */
Status bodies_step(Bodies *b, double t, double dt, bool first);

/* Particles of all, those of the second behind those of the first, whose ids go on. */
void bodies_view(const Bodies *b, Points *points, Samples *samples);
void bodies_counts(const Bodies *b, Counts *counts);

/* Everything that steps change. */
void bodies_stash(Bodies *b, Stash *s);

#endif
