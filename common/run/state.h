/* state.h: all that the carriers of a run's strain know at one instant, as plain rows for output:
 * particles (FEM: nodes) in placement order, or elements of a mesh. */
#ifndef MPMLAB_STATE_H
#define MPMLAB_STATE_H

#include <stdint.h>
#include "common/contract/solver.h"

/* Vectors and tensors are filled up to three dimensions: positions, velocities with 0, F with 1 on
 * its diagonal, stress with the out-of-plane one of plane strain. */
typedef struct State {
    int n;
    int64_t *id;
    double (*X)[3], (*x)[3], (*u)[3], (*v)[3];        /* [m] [m] [m] [m/s], u = x - X */
    double (*F)[9], (*sigma)[9], *von_mises, *energy; /* [-] [Pa] [Pa] [J/m^DIM] stored */
    double *m;                                        /* [kg] */
    uint8_t *surface;                                 /* 1: a surface particle */
    uint8_t *body;                                    /* 0, 1; NULL: there is one */
    const char *const *own_name;                      /* fields of the method's own, or NULL */
    double *own;                                      /* [field][n + 1] */
    void *memory;                                     /* all arrays */
} State;

/* Fill *out; 0, or a fault and nothing to free. */
int state_of_points(State *out, const Scene *scene, const Solver *solver, const void *self,
                    Fault *fault);
int state_of_elements(State *out, const Scene *scene, const Solver *solver, const void *self,
                      Fault *fault);
void state_free(State *s);

#endif
