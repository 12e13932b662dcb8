/* contact.h: two bodies meet at the grid nodes that both reach (Bardenhagen et al. 2001). Each has
 * its own Sim, on the same grid lines; there are no symmetry lines. */
#ifndef MPMLAB_CONTACT_H
#define MPMLAB_CONTACT_H

#include "sim.h"

typedef struct Contact {
    Sim *body[2];
    ContactLaw law;
    double friction; /* [-] coefficient of Coulomb friction */
    double rate;     /* [1/s] at which particle velocities lose their approach */
    int shift[DIM];  /* node i of the first grid is node i + shift of the second */
    double work;     /* [J] of friction so far, <= 0 */
    double *spent;   /* [rows of the first grid] that of this step */
} Contact;

/* The grids must hold their nodes' masses (Setup.snapshot_nodes). Both sims must outlive it. false:
 * out of memory; free it in any case. */
bool contact_make(Contact *c, Sim *a, Sim *b, ContactLaw law, double friction);
void contact_free(Contact *c);

/* Velocities and accelerations of all shared nodes, between solve_all and gather_all (a Meet of
 * step.h; `own` is a Contact). With `force` particles receive them: walls and friction are recorded
 * in impulse and work. */
void contact_meet(void *own, double dt, bool force);

#endif
