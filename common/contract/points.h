/* points.h: what norms, ledger and output read of any solver: points that carry mass and motion,
 * and samples that carry strain. For particles both are the particles; for FEM nodes and elements.
 * Nothing here is owned; views stay good until the solver's next step. */
#ifndef MPMLAB_POINTS_H
#define MPMLAB_POINTS_H

#include <stdbool.h>
#include "dim.h"

/* Slots with mass 0 and id -1 are padding; with mass 0 and id >= 0 surface particles. */
typedef struct Points {
    int n;                                  /* slots */
    const int *id;                          /* [n] placement order */
    const double *X[DIM], *x[DIM], *v[DIM]; /* [m] [m] [m/s] reference, current, velocity */
    const double *m, *V0;                   /* [kg] [m^DIM] mass, reference volume */
    int second; /* ids from here on belong to the second body; 0: there is one body */
    const char *const *own_name; /* fields of the method's own, ended by NULL; or NULL */
    double *const *own;          /* [field][n] */
} Points;

typedef struct Samples {
    int n;
    const double *F[NMAT];  /* [-] deformation gradient */
    const double *V0;       /* [m^DIM] reference volume; 0 in padding */
    const double *strength; /* [Pa] largest tension, 0: broken; NULL: nothing breaks */
} Samples;

/* Live grid nodes, for projections and --nodes. */
typedef struct Nodes {
    int n;
    const double *x[DIM], *v[DIM], *m; /* position, velocity after the last projection, mass */
} Nodes;

/* A polygon of a solver's mesh, or of a cell of the grid that holds material: whole or cut off. In
 * 3D a face of one, seen from outside; the faces of an element or cell follow each other. */
enum { PATCH_SIDES = 8 };
typedef struct Patch {
    int sides;
    int face;                        /* of its element or cell: 0, 1, ...; in 2D always 0 */
    double corner[PATCH_SIDES][DIM]; /* [m] around it */
    bool cut;                        /* by the surface */
    Vec X, x, v; /* elements only: means of their corners, in the reference, too */
    Mat F;       /* elements only */
    double V0;   /* elements only: [m^DIM] reference volume */
} Patch;

typedef void PatchVisit(void *own, const Patch *patch);

#endif
