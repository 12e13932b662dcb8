/* cloud.h: the errors of two runs compared at the same points, though one has nodes and the other
 * particles. */
#ifndef MPMLAB_CLOUD_H
#define MPMLAB_CLOUD_H

#include "common/base/table.h"

/* Of the mesh [0] and of the particles [1]. */
typedef struct CloudErrors {
    int nodes, pairs;      /* all nodes; those that have a particle */
    double all[2];         /* the largest error at all points of each */
    double linf[2], l1[2]; /* the largest and the mean one over the pairs, with equal weights */
} CloudErrors;

/* From two files of errors. A node is paired with the particle whose reference position is nearest
 * if it has particles on all sides within h. */
CloudErrors cloud_compare(const Table *mesh, const Table *particles, double h);

#endif
