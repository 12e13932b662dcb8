/* fem.h: state of the explicit linear-triangle FEM (W11 Appendix A), shared by the files of this room.
 *
 * Nodes and elements are arrays per component. Element arrays have `slots` = elements rounded up to
 * whole chunks; the slots behind the last element repeat it with area 0, and no node listens to them.
 * Corner forces of element e: force[force_at(e, corner) + component * CHUNK]. */
#ifndef MPMLAB_FEM_H
#define MPMLAB_FEM_H

#include "../common/run.h"

enum { CORNERS = 3, BLOCK = 256 /* nodes that one task moves */ };

typedef struct Fem {
    const Scene *scene;
    int threads, nodes, elements, slots, blocks;

    double *X[DIM], *x[DIM], *v[DIM]; /* [m] [m] [m/s] reference, current, velocity at t - dt/2 */
    double *m, *V0;                   /* [kg] [m^2] lumped mass, share of the area */
    double *keep[DIM];                /* 1; 0 where the component is held for good */
    int *id, *first, *touching;       /* corners that meet in node i: touching[first[i] .. first[i+1]) */
    double *given[DIM];               /* [kg m/s] a block's momentum gain of the step from outside */

    int *corner[CORNERS];  /* counter-clockwise */
    double *inverse[NMAT]; /* [1/m] inverse of the reference edges (X2 - X1, X3 - X1), row-major */
    double *A0, *F[NMAT];  /* [m^2] [-] reference area, deformation gradient */
    double *force;         /* [N] internal force on the corners, of the current positions */

    Wall barrier[MAX_WALLS]; /* walls that a node may run into */
    int barriers;
    double edge;    /* [m] length in the time step limit */
    Vec impulse;    /* [kg m/s] since the start */
    Status status;  /* of the current positions */
    void *memory;   /* all arrays */
} Fem;

static inline int force_at(int e, int corner)
{
    return (e / CHUNK * CORNERS + corner) * DIM * CHUNK + e % CHUNK;
}

/* Plans the mesh, checks memory, allocates and fills everything. NULL and a fault as in Solver.make. */
Fem *fem_new(const Setup *setup, Fault *fault);
void fem_free(Fem *f);

/* F, corner forces and status of the current positions (A3, A4). */
void fem_strain(Fem *f);

/* Nodes from t to t + dt under the present corner forces, the body force at t and the walls (A1, A5,
 * A6); the first step takes half the acceleration. */
void fem_move(Fem *f, double t, double dt, bool first);

extern const Solver fem_2d;

#endif
