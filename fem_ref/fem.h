/* fem.h: state of the explicit linear-triangle FEM (W11 Appendix A), shared by the files here.
 *
 * Nodes and elements are arrays per component. Element arrays have `slots` = elements rounded up to
 * whole chunks; the slots behind the last element repeat it with area 0, and no node listens to
 * them. What is fetched by index (positions, corner forces) lies in pairs: one load, not two. */
#ifndef MPMLAB_FEM_H
#define MPMLAB_FEM_H

#include "common/contract/solver.h"

enum { CORNERS = 3, VALENCE = 8 /* most corners in a node */, BLOCK = 256 /* nodes of a task */ };

/* A vector in the plane, also read and written as double[DIM]. */
typedef double Pair __attribute__((vector_size(DIM * sizeof(double)), may_alias));

typedef struct Fem {
    const Scene *scene;
    int threads, nodes, elements, slots;

    double *X[DIM], *x[DIM], *v[DIM]; /* [m] [m] [m/s] reference, current, velocity at t - dt/2 */
    Pair *now;                        /* [m] x once more */
    double *m, *V0;                   /* [kg] [m^2] lumped mass, share of the area */
    double *keep[DIM];                /* 1; 0 where the component is held for good */
    double *given[DIM];               /* [kg m/s] momentum from body forces and walls so far */
    int (*touching)[VALENCE];         /* corners that meet in the node; its rest: no_force */
    int *id;

    int *corner[CORNERS];   /* counter-clockwise */
    Field (*inverse)[NMAT]; /* [1/m] [chunk] inverse of the reference edges (X2 - X1, X3 - X1) */
    double *A0, *F[NMAT];   /* [m^2] [-] reference area, deformation gradient */
    Pair *force;            /* [N] internal force on the corners: [chunk][corner][CHUNK] */

    Wall barrier[MAX_WALLS]; /* walls that a node may run into */
    int barriers;
    double edge;   /* [m] length in the time step limit */
    Status status; /* of the current positions */
    void *memory;  /* all arrays */
} Fem;

/* Where the force on a corner of element e lies; and a force that is always zero. */
static inline int force_at(int e, int corner)
{
    return (e / CHUNK * CORNERS + corner) * CHUNK + e % CHUNK;
}

static inline int no_force(const Fem *f)
{
    return CORNERS * f->slots;
}

/* Plans the mesh, checks memory, allocates and fills all. NULL and a fault as in Solver.make. */
Fem *fem_new(const Setup *setup, Fault *fault);
void fem_free(Fem *f);

/* F, corner forces and status of the current positions (A3, A4). */
void fem_strain(Fem *f);

/* Nodes from t to t + dt under the present corner forces, the body force at t and the walls (A1,
 * A5, A6); the first step takes half the acceleration. */
void fem_move(Fem *f, double t, double dt, bool first);

extern const Solver solver_fem;

#endif
