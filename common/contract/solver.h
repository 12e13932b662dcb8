/* solver.h: what advances points in time (particle core, FEM): its set-up, and its functions. */
#ifndef MPMLAB_SOLVER_H
#define MPMLAB_SOLVER_H

#include "common/base/fault.h"
#include "common/base/info.h"
#include "common/base/stash.h"
#include "method.h"
#include "points.h"
#include "problem.h"

typedef enum {
    OK,
    LEFT_GRID,
    INVERTED,
    NOT_A_NUMBER,
    SINGULAR,
    EMPTY,
    ENERGY_GROWTH,
    INTERRUPTED
} StatusCode;

/* How a step ended; `point` is the id of the first culprit (particle, or element of FEM), or -1. */
typedef struct Status {
    StatusCode code;
    int point;
    double value; /* what was wrong: J, a position, ... */
} Status;

/* Everything a solver is built from. Not owned by the solver, but outlives it. */
typedef struct Setup {
    const Scene *scene;
    const Method *method;     /* NULL for FEM */
    const double *method_par; /* values in the order of the method's params */
    const Method *method_b;   /* of the second body, with its parameters; NULL: the same */
    const double *method_b_par;
    Integrator integrator;
    int cells; /* per unit length; h = 1/cells */
    double ppc;
    int count;           /* particles asked for by number (1D), or 0 */
    bool fitted;         /* body-fitted layout */
    bool refresh;        /* L from the accelerated grid velocity before a re-projection */
    Frame frame;         /* of stencils */
    Domain domain;       /* of particle boxes, where the frame is the current one */
    StrainUpdate strain; /* of F */
    int subcycles;       /* of STRAIN_SUBCYCLED, >= 1 */
    bool snapshot_nodes; /* nodes() will be called */
    bool reactions;      /* outside() will be called */
    int threads;
} Setup;

/* What the row reports of a solver. */
typedef struct Counts {
    double ppc;     /* really used */
    int particles;  /* with mass; FEM: nodes */
    int surface;    /* surface particles */
    int elements;   /* FEM; -1 otherwise */
    long nodes;     /* most live grid nodes at any step; -1: no step got that far, or FEM */
    bool moved;     /* the last step has moved the points, whatever its end */
    long fallbacks; /* nodes that fell back from their method's own rule; -1: has none */
    double particle_bytes, node_bytes; /* memory of a particle, of a live node; 0: not said */
} Counts;

/* Something that advances points in time. `self` is what make returned. One per kind: the particle
 * core (step.c), the FEM reference. */
typedef struct Solver {
    Info info; /* of a solver that is chosen by name like a method (FEM); else empty */

    /* 0, or a fault if this scene cannot be run, whatever the number of cells (FEM: no mesh for
     * its body); NULL: every scene can. */
    int (*takes)(const Scene *scene, Fault *fault);

    /* Builds everything; NULL and a fault (2: bad ppc; 1: memory, said before it is allocated). */
    void *(*make)(const Setup *setup, Fault *fault);

    /* Largest stable-looking step [s] for CFL 1, where it is not h/c (FEM's small triangles); or
     * NULL. */
    double (*unit_dt)(const void *self);

    /* One step from t to t + dt [s]; `first` takes the half first step where the integrator has it.
     */
    Status (*step)(void *self, double t, double dt, bool first);

    /* Project velocities to the grid only (projection scenes); NULL if it makes no sense. */
    Status (*project)(void *self);

    void (*view)(const void *self, Points *points, Samples *samples);
    void (*nodes)(const void *self, Nodes *nodes); /* NULL if none */
    void (*counts)(const void *self, Counts *counts);

    /* Momentum [kg m/s] that body forces and boundary conditions have given since the start. */
    void (*impulse)(const void *self, Vec out);

    /* Work [J] of tractions, the mean of both ends of every step, and of friction between bodies
     * since the start. */
    double (*work)(const void *self);

    /* The part of the impulse that body forces and tractions have given; measured if
     * setup->reactions asks for it. */
    void (*outside)(const void *self, Vec out);

    /* Calls `visit` for every polygon of the mesh, or of the grid's cells as the last step had
     * them; NULL: there are none. `elements`: the polygons are elements, which carry strain and
     * come in a fixed order. */
    void (*patches)(const void *self, PatchVisit *visit, void *own);
    bool elements;

    /* F and Cauchy stress of every point slot, components row-major (FEM: mean of elements). */
    void (*point_stress)(const void *self, Fields F, Fields sigma);

    /* A solver by another method that goes on with the points of `self`, which is not freed; NULL:
     * a mesh, whose points are no particles. NULL and a fault as make. */
    void *(*take_over)(const Setup *setup, void *self, Fault *fault);

    /* Writes or reads everything that steps change, so that the steps that follow have the same
     * bits. */
    void (*stash)(void *self, Stash *s);

    void (*free)(void *self);
} Solver;

#endif
