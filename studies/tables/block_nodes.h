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
    double box;            /* [m] the block was put down in the middle of it, */
    const double *shift;   /* [dim] and moved by so many cells; NULL: places are from that middle */
    double stretch, angle; /* along x; then turned by so many degrees */
    double drift;          /* V along x, in c */
    double inner;          /* [m] nodes so near the middle of the undeformed block count */
} BlockNodes;

/* The force on the node of a row, and its place from the middle of the block. False if it does not
 * count. Components beyond the dimension are 0. */
bool block_node_force(const BlockNodes *block, const Table *nodes, int row, double place[3],
                      double force[3]);

/* The largest component of the forces on all nodes that count; NAN if none does. */
double block_nodes_largest(const BlockNodes *block, const Table *nodes);

#endif
