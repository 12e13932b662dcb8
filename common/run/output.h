/* output.h: the files that one run writes besides its row: --history, --particles, ... */
#ifndef MPMLAB_OUTPUT_H
#define MPMLAB_OUTPUT_H

#include <stdio.h>
#include "norm.h"
#include "common/base/spec.h"
#include "common/contract/solver.h"

/* One instant of a run. */
typedef struct Moment {
    double t;                     /* [s] */
    double kinetic, strain, work; /* [J] centred in time; work of body forces */
    Vec momentum;                 /* [kg m/s] */
    double error_linf, dt;
    double volume, least_J, most_J; /* [m^DIM] sum V0 J; [-] its extremes */
    double angular[3]; /* [kg m^2/s] about the centre of mass, of v half a step before x */
    int nprobe, nwall; /* of the rows below that are used */
    double probe[SPEC_PROBES][PROBE_COLUMNS]; /* [m] [Pa]; NAN: absent in this dimension */
    double wall[MAX_WALLS][3];                /* [N] force of each wall on the body */
} Moment;

void output_history_header(FILE *out, int nprobe, int nwall);
void output_history_line(FILE *out, const Moment *m);

/* All points in placement order. 0 or a fault (1: memory, disk). */
int output_particles(const char *path, const Scene *scene, const Solver *solver, const void *self,
                     Fault *fault);

/* What carries strain, the same columns: elements of a mesh (positions and velocities are means of
 * their corners, mass their own), else particles. */
int output_samples(const char *path, const Scene *scene, const Solver *solver, const void *self,
                   Fault *fault);

/* Each point's error at time t and its weight in the norms, in placement order:
 * id,X,Y,error,weight,Z. */
int output_errors(const char *path, const Scene *scene, const Points *p, double t, Scratch *s,
                  Fault *fault);

/* Live nodes with their velocities: id,x,y,mass,vx,vy,z,vz. Of solvers that have nodes. */
int output_nodes(const char *path, const Solver *solver, const void *self, Fault *fault);

/* Polygons of cells or elements as the last step had them: cell,k,x,y,cut; in 3D the faces of each,
 * with ,z,face behind. A blank line between two. Of solvers that have patches; none after a run
 * that ended before its first grid. */
int output_patches(const char *path, const Solver *solver, const void *self, Fault *fault);

#endif
