/* block.h: nodal forces inside the stretched block of problems/block.c, which moves over the grid
 * (H-1 and its likes in space): after one step of usl from a uniform velocity V nodes have v_i = V
 * + a_i dt, so that f_i = m_i (v_i - V)/dt. */
#ifndef MPMLAB_BLOCK_H
#define MPMLAB_BLOCK_H

#include "grades.h"

typedef struct Block {
    int dim, cells;
    double stretch;   /* along its first axis */
    double degrees;   /* by which it is turned about z */
    double offset[3]; /* of its middle from that of the scene [cells] */
    double speed;     /* V, along x [m/s] */
} Block;

/* Frobenius norm of its Cauchy stress [Pa]. */
double block_stress(const Block *b);

/* The force of node i of a file of nodes, over |sigma| and the area of a cell's face; components
 * beyond `dim` are 0. False of a node that is not four cells and more inside. */
bool block_force(const Block *b, const Table *nodes, int i, double f[3]);

#endif
