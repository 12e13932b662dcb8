/* mesh.h: a structured triangle mesh of a scene's body, planned first (its size is known before any
 * memory is asked for), then filled into arrays of the caller's. */
#ifndef MPMLAB_MESH_H
#define MPMLAB_MESH_H

#include "common/base/fault.h"
#include "common/contract/problem.h"

typedef struct Mesh {
    const Scene *scene;
    int ni, nj;  /* quads across (x, radius) and along (y, angle); disk: rings, 6 sectors */
    bool closed; /* the last column of quads meets the first */
    int nodes, elements;
} Mesh;

/* Mesh of edge about 1/cells. 0, or a fault: 2 for a body without a mesh, 1 for one beyond
 * counting. */
int mesh_plan(Mesh *mesh, const Scene *scene, int cells, Fault *fault);

/* Node positions X [m] [DIM][nodes] and, counter-clockwise, corners [3][elements]. Neighbours in
 * space have near numbers. */
void mesh_fill(const Mesh *mesh, Fields X, int *const corner[3]);

#endif
