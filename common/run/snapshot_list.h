/* snapshot_list.h: names and lists of the snapshots of a run: shared by snapshot.c, which writes
 * their contents, and snapshot_list.c. */
#ifndef MPMLAB_SNAPSHOT_LIST_H
#define MPMLAB_SNAPSHOT_LIST_H

#include <limits.h>
#include "snapshot.h"

/* Path of one snapshot. */
void snapshot_path(const Snapshots *s, int kind, long step, char path[PATH_MAX]);

/* Room for one more in the list; false: no memory. */
bool snapshot_room(Snapshots *s, int kind);

/* Writes the collection (.pvd). Unless this is the last time, only when it has grown by a tenth: a
 * run that is stopped leaves a good one, and a long run does not spend its time on lists. 0 or a
 * fault. */
int snapshot_list(Snapshots *s, int kind, bool last, Fault *fault);

#endif
