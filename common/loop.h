/* loop.h: a run under way, shared by the time loop (run.c) and the row it becomes (report.c). */
#ifndef MPMLAB_LOOP_H
#define MPMLAB_LOOP_H

#include <stdio.h>
#include "norm.h"
#include "output.h"
#include "resolve.h"
#include "snapshot.h"

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
    double work, power;         /* [J] and [W] at the last instant */
    Vec p0;
    double drift, momentum; /* largest |p - p0 - impulse|, largest sum m |v| */
    Status status;
    double failed_at; /* [s] */
    long growth_step; /* first step with too much energy, or -1 */
    int fastest;      /* point then, and its speed [m/s] */
    double speed;
    Moment last; /* what is known of the last instant */
} Loop;

/* What was asked for; and what became of it. */
void report_inputs(const RunSpec *spec, const Plan *plan, Row *row);
void report_counts(const Loop *l, Row *row);
void report_results(const Loop *l, Row *row);

#endif
