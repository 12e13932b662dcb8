/* block_nodes.h: forces on the nodes inside a uniformly stressed block (problems/block.c).
 *
 * One step of usl from the uniform velocity V leaves v_i = V + a_i dt on the nodes, so that
 * f_i = m_i (v_i - V)/dt. Forces are given in units of |sigma| times the area of a cell's face,
 * |sigma| being the Frobenius norm of the Cauchy stress. */
#ifndef MPMLAB_BLOCK_NODES_H
#define MPMLAB_BLOCK_NODES_H

#include "studies/study.h"

/* The block of a run with these settings. */
typedef struct BlockNodes {
    int dim, cells;
    double box;            /* [m] side of the box; the block starts in its middle */
    const double *shift;   /* [dim] [cells] displacement of the block from there; NULL: none */
    double stretch, angle; /* stretch along x, then rotation [degrees] */
    double drift;          /* V along x, in c */
    double inner;          /* [m] a node counts if its place in the undeformed block is nearer than
                            * this to the middle along every axis */
} BlockNodes;

/* The force on the node of a row, and its place from the middle of the block. False if it does not
 * count. Components beyond the dimension are 0. */
bool block_node_force(const BlockNodes *block, const Table *nodes, int row, double place[3],
                      double force[3]);

/* The largest component of the forces on all nodes that count; NAN if none does. */
double block_nodes_largest(const BlockNodes *block, const Table *nodes);

#endif
