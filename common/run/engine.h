/* engine.h: one compiled dimension of the testbed, seen from outside: what it knows and how to run
 * it. Each dimension exports exactly one constant Engine; everything else in it is hidden at link
 * time. */
#ifndef MPMLAB_ENGINE_H
#define MPMLAB_ENGINE_H

#include <stdio.h>
#include "common/base/fault.h"
#include "common/base/info.h"
#include "common/base/row.h"
#include "common/base/spec.h"

struct Solver; /* solver.h: whatever advances points in time: the particle core, FEM */

typedef struct Engine {
    int dim;
    const Info *const *problems;    /* NULL-terminated, in registry order */
    const Info *const *methods;     /* NULL-terminated, in registry order */
    const Info *const *integrators; /* NULL-terminated, the same in every dimension */
    const Param *const *settings;   /* of every run, whatever its problem and method */

    /* Checks spec and fills every default, so that `spec` reproduces the run by itself. 0 or a
     * fault (code 2: unknown name or parameter, value out of range, refused pair). */
    int (*resolve)(RunSpec *spec, Fault *fault);

    /* Runs a resolved spec. 0 and a filled row (also when the run blew up: see row->status), or a
     * fault (code 1: memory or disk). Writes the spec's output files whole or not at all. */
    int (*run)(const RunSpec *spec, Row *row, Fault *fault);

    /* What a problem, method or integrator is, as text: formula, error scale, integrators,
     * parameters and the run settings that act on it, wave speeds. 0, or -1 if unknown. */
    int (*describe)(const char *name, FILE *out);

    /* Does the problem, by default, have an exact solution, so that rows give errors? */
    int (*has_exact)(const char *problem);

    /* 1D weights S [-] and gradients G [1/m] that a particle at x with half width l (cell size 1,
     * node at 0) gives that node, for drawing and for tests. Returns 0; 1 if the method's weights
     * are not products of 1D weights, -1 if it has no grid or is unknown: then S and G stay unset.
     */
    int (*weight)(const char *method, double x, double l, double *S, double *G);
} Engine;

/* A run has the status energy_growth if kinetic + strain energy - work rises by more than this part
 * of the largest energy so far. */
#define ENGINE_GROWTH 0.05

extern const Engine engine_1d, engine_2d, engine_3d;
extern const Engine *const engines[]; /* main's list, NULL-terminated */

/* The engine for a run: knows the problem, and the dimension asked for with --set dim=N if it has
 * several (default: 2 if it has several, else the only one). NULL and a fault (unknown problem,
 * with the nearest name). */
const Engine *engine_for(const RunSpec *spec, Fault *fault);

#endif
