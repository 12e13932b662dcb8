/* snapshot.h: the states of a run over time for ParaView: in one folder particles_000012.vtp (FEM:
 * its nodes), nodes_... (live grid nodes), cells_... (polygons of the mesh, or of the grid's full
 * and cut cells), 12 the step, and particles.pvd, nodes.pvd, cells.pvd, which list them. The grid
 * is that of the step just taken, at the start that of a projection; a scene that only projects has
 * one snapshot, 0. */
#ifndef MPMLAB_SNAPSHOT_H
#define MPMLAB_SNAPSHOT_H

#include "common/contract/solver.h"

enum { SHOT_PARTICLES, SHOT_NODES, SHOT_CELLS, SHOT_KINDS };

/* What has been taken so far. */
typedef struct Snapshots {
    const char *dir; /* exists; not owned */
    int every;       /* steps between two; 0: first and last only, */
    double every_s;  /*   or the first at or after every multiple of this time [s] */
    long slot;       /* number of the multiple that the last snapshot belongs to */
    int n[SHOT_KINDS], room[SHOT_KINDS];
    long *step[SHOT_KINDS];
    double *t[SHOT_KINDS];
    int listed[SHOT_KINDS]; /* how many the collection on disk has */
} Snapshots;

/* Writes the state after `step` steps at time t [s]; `last`: none will follow. Steps that are not
 * due, or were taken already, are left out. 0 or a fault. */
int snapshot_take(Snapshots *s, const Scene *scene, const Solver *solver, const void *self,
                  long step, double t, bool last, Fault *fault);

/* The same at step 0, with the grid of a projection by another solver like it, so that the run
 * itself does not change. */
int snapshot_start(Snapshots *s, const Setup *setup, const Solver *solver, const void *self,
                   Fault *fault);
void snapshot_free(Snapshots *s);

/* What has been taken, out or in (stash.h). */
void snapshot_stash(Snapshots *s, Stash *stash);

/* After what had been taken was read in: deletes later snapshots that the lists in the folder name
 * (of the instant at which the run was stopped), and writes the lists anew. 0, or a fault before
 * anything is changed: the folder lacks a snapshot. */
int snapshot_go_on(Snapshots *s, Fault *fault);

/* Can snapshots be written into this folder? 0 or a fault with code 1. */
int snapshot_check(const char *dir, Fault *fault);

#endif
