/* each.h: loops over rows of nodes and over blocks of particles, shared by threads. `own` is what a
 * pass needs besides, NULL if nothing: a time step, a struct of its own. */
#ifndef MPMLAB_EACH_H
#define MPMLAB_EACH_H

#include "sim.h"

typedef void RowWork(Sim *sim, int row, const void *own);
typedef void ChunkWork(Sim *sim, int first, int last, void *own);

/* Calls work for each row that particles may reach. No row may write what another one reads or
 * writes. */
void each_row(Sim *sim, RowWork *work, const void *own);

/* Calls work with the chunks first ... last - 1 of each block: even blocks, then odd ones. Blocks
 * of equal parity share no node, so that work may add to nodes, and every node's sum is formed in
 * the same order for any number of threads. */
void each_block(Sim *sim, ChunkWork *work, void *own);

#endif
