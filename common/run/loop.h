/* loop.h: a run under way, shared by the time loop (run.c) and the row it becomes (report.c). */
#ifndef MPMLAB_LOOP_H
#define MPMLAB_LOOP_H

#include <stdio.h>
#include "ledger.h"
#include "output.h"
#include "plan.h"
#include "snapshot.h"

/* Energy and momentum at a half step: before or after a time step. */
typedef struct Side {
    double kinetic, mv; /* [J] [kg m/s] sum m |v| */
    Vec p;              /* [kg m/s] */
} Side;

/* Kinetic energy of one instant, and the part of it that the time step leaves undetermined [J]. */
typedef struct Counted {
    double kinetic, open;
} Counted;

typedef struct Loop {
    const Plan *plan;
    void *self;
    Scratch scratch;
    FILE *history;
    Snapshots shots; /* dir NULL: none are asked for */
    int code;        /* 0, or what went wrong with an output */
    Fault *fault;
    double dt;
    long n, done;               /* steps planned and finished */
    double cpu, wall;           /* [s] inside the solver's step */
    Errors worst;               /* running maxima */
    double start, now, largest; /* K + S - W at the start and now, largest K + S */
    double base, most;          /* [J] K + S at the start and its largest, for energy growth */
    Counted counted;            /* of the instant before */
    double noise;               /* [J] round-off of stored energy */
    long instants;              /* whose energy is recorded */
    double work;                /* [J] of body forces on the steps finished */
    double friction;            /* [J] work of friction that `work` has */
    double *from[DIM];          /* [m] positions by id after the last finished step; owned */
    Vec p0;
    double drift, momentum; /* largest |p - p0 - impulse|, largest sum m |v| */
    Status status;
    double failed_at; /* [s] */
    long growth_step; /* first step with too much energy, or -1 */
    int fastest;      /* point then, and its speed [m/s] */
    double speed;
    Moment last; /* what is known of the last instant */
} Loop;

/* Stores the positions of all points for loop_record_work; frees them. false: out of memory. */
bool loop_open(Loop *l);
void loop_close(Loop *l);

Side loop_measure_side(const Loop *l);
void loop_measure_state(Loop *l,
                        Moment *m); /* what depends on positions and F: energy, volume, ... */

/* Sets the energy that growth is measured from: given both sides of the first step and S. */
void loop_record_start(Loop *l, const Side *before, const Side *after, double strain);

/* Energies of the instant m->t between two sides. */
void loop_record_energy(Loop *l, Moment *m, const Side *before, const Side *after);
void loop_record_momentum(Loop *l, const Side *after);
void loop_record_work(Loop *l, double t); /* of the step from t that has just been finished */
void loop_record_errors(Loop *l, Errors e);

/* True if any point has moved since the last finished step. (A failed step may have moved some.) */
bool loop_has_moved(const Loop *l);

/* Fill the row: the run's inputs, its numbers of particles and nodes, its results. */
void report_inputs(const RunSpec *spec, const Plan *plan, Row *row);
void report_counts(const Loop *l, Row *row);
void report_results(const Loop *l, Row *row);

#endif
