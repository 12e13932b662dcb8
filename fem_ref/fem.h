/* fem.h: state of the explicit FEM with linear triangles or, in 3D, tetrahedra (W11 Appendix A),
 * shared by the files here. Volumes are areas in 2D.
 *
 * Nodes and elements are arrays per component. Element arrays have `slots` = elements rounded up to
 * whole chunks; padding slots after the last element are copies of it with zero volume, and no node
 * gathers force from them. Vectors that are fetched by index (positions, corner forces) are packed:
 * one load each. */
#ifndef MPMLAB_FEM_H
#define MPMLAB_FEM_H

#include "common/contract/solver.h"

enum {
    CORNERS = DIM + 1,
    GROUP = 8,                       /* corners of a node that are summed together */
    VALENCE = IN_THIS_DIM(2, 8, 32), /* most corners in a node: whole groups */
    FACTORIAL = IN_THIS_DIM(1, 2, 6),
    BLOCK = 256 /* nodes of a task */
};

/* A vector of DIM components; in 3D the fourth is 0. */
typedef double Packed
    __attribute__((vector_size(IN_THIS_DIM(1, 2, 4) * sizeof(double)), may_alias));

typedef struct Fem {
    const Scene *scene;
    int threads, nodes, elements, slots;

    double *X[DIM], *x[DIM], *v[DIM]; /* [m] [m] [m/s] reference, current, velocity at t - dt/2 */
    Packed *now;                      /* [m] x once more */
    double *m, *V0;                   /* [kg] [m^DIM] lumped mass, share of the volume */
    double *keep[DIM];                /* 1; 0 where the component is held for good */
    double *given[DIM];               /* [kg m/s] momentum from body forces and walls so far */
    Vec outside;                      /* [kg m/s] from body forces alone, if `reactions` */
    bool reactions;
    int (*touching)[VALENCE]; /* element corners that meet in the node; unused: no_force */
    int *id;

    int *corner[CORNERS]; /* counter-clockwise */
    Field (
        *inverse)[NMAT];  /* [1/m] [chunk] inverse of the reference edges (X2 - X1, X3 - X1, ...) */
    double *A0, *F[NMAT]; /* [m^DIM] [-] reference volume, deformation gradient */
    Packed *force;        /* [N] internal force on the corners: [chunk][corner][CHUNK] */

    bool integrate; /* body=elements: the body force is integrated over elements; else (A1) it is
                     * that at the nodes, and middle and pull are not used */
    double *middle[DIM]; /* [m] [slots] centres of the elements in the reference */
    Packed *pull;        /* [N] [slots + 1] an element's body force on each of its corners */

    struct Sides *sides; /* sides under traction, or NULL; traction.c */

    Wall barrier[MAX_WALLS]; /* walls that a node may run into */
    int barriers;
    double dt_before; /* [s] of the step before; 0: none */
    double edge;      /* [m] length in the time step limit */
    bool moved;       /* by the last step */
    Status status;    /* of the current positions */
    void *memory;     /* one block that holds all arrays */
    size_t bytes;     /* its size */
} Fem;

/* Index of the force on a corner of element e. */
static inline int force_at(int e, int corner)
{
    return (e / CHUNK * CORNERS + corner) * CHUNK + e % CHUNK;
}

/* The element of a corner force's index; `slots` for no_force. */
static inline int element_at(int force)
{
    return force / (CORNERS * CHUNK) * CHUNK + force % CHUNK;
}

/* Index of a force that is always zero. */
static inline int no_force(const Fem *f)
{
    return CORNERS * f->slots;
}

/* Plans the mesh, checks memory, allocates and fills all. NULL and a fault as in Solver.make. */
Fem *fem_new(const Setup *setup, Fault *fault);
void fem_free(Fem *f);

/* F, corner forces and status of the current positions (A3, A4). */
void fem_strain(Fem *f);

/* det F of element e. */
double fem_jacobian(const Fem *f, int e);

/* Nodes from t to t + dt under the present corner forces, the body force at t and the walls (A1,
 * A5, A6); the first step takes half the acceleration. */
void fem_move(Fem *f, double t, double dt, bool first);

/* Sides of elements that are no other element's, if the scene has traction. false: no memory. */
bool fem_find_sides(Fem *f);
void fem_free_sides(Fem *f);

/* Nodal forces [N] of the traction at time t, into fem_load; the work of a step that has just been
 * taken from t to t + dt; all work so far [J]. */
void fem_load_sides(Fem *f, double t);
const double *fem_load(const Fem *f, int axis);
void fem_record_work(Fem *f, double t, double dt);
double fem_work(const Fem *f);
void fem_stash_work(Fem *f, Stash *s);

extern const Solver solver_fem;

#endif
