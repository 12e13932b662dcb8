/* each.h: loops over rows of nodes and over blocks of particles, shared by threads. `own`: what
 * else the work needs, for example a pointer to dt or to a struct, or NULL. Rows only read it;
 * blocks may also return a result in it. */
#ifndef MPMLAB_EACH_H
#define MPMLAB_EACH_H

#include "sim.h"

typedef void RowWork(Sim *sim, int row, const void *own);
typedef void ChunkWork(Sim *sim, int first, int last, void *own);

/* Calls work for each row whose live span (sim.h) is not empty, rows of ghost nodes included. A row
 * must not write what another row reads or writes, unless that is guarded. */
void each_row(Sim *sim, RowWork *work, const void *own);

/* Calls work once for each block, with its chunks first ... last - 1: all even blocks, then all odd
 * ones. Blocks of equal parity share no node, so work may add to nodes. The order of summation at a
 * node does not depend on the number of threads. Whatever else blocks write must be guarded. */
void each_block(Sim *sim, ChunkWork *work, void *own);

#endif
