/* mesh.h: a structured mesh of a scene's body, of triangles (mesh.c) or tetrahedra (mesh_space.c),
 * planned first, so that its size is known before any memory is allocated, then filled into arrays
 * of the caller. */
#ifndef MPMLAB_MESH_H
#define MPMLAB_MESH_H

#include <math.h>
#include "common/base/fault.h"
#include "common/contract/problem.h"

typedef struct Mesh {
    const Scene *scene;
    int ni, nj;  /* cells across (x, radius) and along (y, angle); disk: rings, 6 sectors */
    int nk;      /* 3D: along z; round bodies: layers of ni x ni cells on each face of a cube */
    bool closed; /* the last column of cells meets the first */
    int nodes, elements;
} Mesh;

/* Cells of about 1/cells along a length; as a double: it may be beyond int. */
static inline double mesh_cells_along(double length, double cells)
{
    return fmax(ceil(length * cells - 1e-9), 1);
}

static inline bool mesh_is_full_turn(const Body *b)
{
    return b->angle_hi - b->angle_lo > 2 * M_PI * (1 - 1e-12);
}

/* 0, or a fault: no mesh is known for the scene's body. */
int mesh_takes(const Scene *scene, Fault *fault);

/* Mesh of edge about 1/cells of a body that it takes. 0, or a fault (1): more elements than can be
 * counted. */
int mesh_plan(Mesh *mesh, const Scene *scene, int cells, Fault *fault);

/* Node positions X [m] [DIM][nodes] and corners [DIM + 1][elements], so that volumes are positive.
 * Neighbours in space have near numbers. */
void mesh_fill(const Mesh *mesh, Fields X, int *const corner[]);

#endif
