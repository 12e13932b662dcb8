/* loop.h: a run under way, shared by the time loop (run.c) and the row it becomes (report.c). */
#ifndef MPMLAB_LOOP_H
#define MPMLAB_LOOP_H

#include <stdio.h>
#include "common/base/stopwatch.h"
#include "ledger.h"
#include "output.h"
#include "plan.h"
#include "probe.h"
#include "snapshot.h"

/* Kinetic energy of one instant, and the part of it that the time step leaves undetermined [J]. */
typedef struct Counted {
    double kinetic, open;
} Counted;

/* Where the run's state goes and comes from, or NULL. */
typedef struct Save {
    const char *path, *resume;
    double every_s, last; /* [s] between two; stopwatch_wall of the last one */
    double began, spent;  /* [s] stopwatch_wall at the start; run time before the resumption */
    char command[SPEC_TEXT];
    unsigned long program;
} Save;

typedef struct Loop {
    const Plan *plan;
    const volatile sig_atomic_t *stop; /* RunSpec.stop */
    void *self;
    Handover handover; /* to a second method; .at = AT_NEVER: none */
    long taken_over;   /* steps done before the hand-over; -1: not yet */
    double taken_at;   /* [s] time of the hand-over */
    Counts earlier;    /* counts of the first method's solver at the hand-over */
    Vec given;         /* [kg m/s] impulse that the first method's solver has given */
    Stash undo;        /* AT_INVERTED: the particles before the step under way */
    Save save;
    Scratch scratch;
    FILE *history;
    Snapshots shots; /* dir NULL: none are asked for */
    int code;        /* 0, or what went wrong with an output */
    Fault *fault;
    double dt;                  /* [s] length of this step */
    double dt_before;           /* [s] of the step before; 0: none, or steps are constant */
    double t;                   /* [s] start of this step */
    double unit_dt;             /* [s] h/c, or what the solver has instead */
    long n, done;               /* steps planned and finished */
    Stopwatch steps;            /* the solver's steps, or its projection */
    Errors worst;               /* running maxima */
    double start, now, largest; /* K + S - W at the start and now, largest K + S */
    double base, most;          /* [J] K + S at the start and its largest, for energy growth */
    Counted counted;            /* of the instant before */
    double noise;               /* [J] round-off of stored energy */
    long instants;              /* whose energy is recorded */
    double bodies, work;        /* [J] of body forces on the steps finished; of all */
    BodyLoad *loads; /* by id after the last step, for the work of body forces; owned, or NULL */
    Vec p0;
    double drift, momentum; /* largest |p - p0 - impulse|, largest sum m |v| */
    Status status;
    double failed_at; /* [s] */
    long growth_step; /* first step with too much energy (ENGINE_GROWTH), or -1 */
    double growth_t;  /* [s] its start */
    int fastest;      /* id of the fastest point then */
    double speed;     /* [m/s] of that point */
    Moment last;      /* the last instant, recorded when its kinetic energy is known */
    Probes probes;
    Reactions reactions;
} Loop;

/* The constant step and the number of steps; with dt=adaptive the next step (the last two share
 * what is left, so that t_end is met exactly). pace.c. */
void pace_choose(Loop *l);
void pace_adapt(Loop *l);

/* Is t_end, or the last step, reached? */
bool pace_is_over(const Loop *l);

/* End [s] of the step under way; that of the last one is t_end to the last bit. */
double pace_end_of_step(const Loop *l);

/* Weight w of the half step after an instant: K = (1 - w) K_before + w K_after. */
double pace_share_after(const Loop *l);

/* Keeps the positions and body forces of all points at time l->t for loop_record_work; frees them.
 * false: out of memory. */
bool loop_open(Loop *l);
void loop_close(Loop *l);

/* Kinetic energy and momentum of the velocities now; and what depends on positions and F: stored
 * energy and, with a history, probes, volume, angular momentum. */
Side loop_measure_side(Loop *l);
void loop_measure_state(Loop *l, Moment *m);

/* Sets the energy that growth is measured from: given both sides of the first step and S. */
void loop_record_start(Loop *l, const Side *before, const Side *after, double strain);

/* Energies of the instant m->t between two sides. */
void loop_record_energy(Loop *l, Moment *m, const Side *before, const Side *after);
void loop_record_momentum(Loop *l, const Side *after);
void loop_record_work(Loop *l); /* of the step that has just been finished */
void loop_record_errors(Loop *l, Errors e);

/* Hand-over, before step `done` is taken: is it due? Then do it and measure *before again. False: a
 * fault, in l->code. relay.c. */
bool relay_is_due(const Loop *l);
bool relay_take_over(Loop *l, Side *before);

/* AT_INVERTED. Before a step: keeps the particles' state. After one that failed: if a particle was
 * inverted, restores that state and hands over; true: the step is to be taken again. */
void relay_before_step(Loop *l);
bool relay_rescues(Loop *l, Side *before);

/* A resumed run that had been handed over: makes the second method's solver, whose particles are
 * then read from the file. */
bool relay_go_on(Loop *l);

/* --checkpoint FILE --every-s N, --resume FILE: row, history and particles of a resumed run have
 * the same bits as those of an uninterrupted one; checkpoint.c. Between two steps: writes the state
 * if it is time, or `now`. *m, *before: the instant reached. A fault goes to l->code. */
void checkpoint_write(Loop *l, Moment *m, Side *before, bool now);

/* The state from the file that the run resumes from. 0 or a fault. */
int checkpoint_read(Loop *l, Moment *m, Side *before);

/* Room for the largest number of slots that particles may need; false: none. run.c. */
bool loop_fit_scratch(Loop *l);

/* Fill the row: the run's inputs, its numbers of particles and nodes, its results. */
void report_inputs(const RunSpec *spec, const Plan *plan, Row *row);
void report_counts(const Loop *l, Row *row);
void report_results(const Loop *l, Row *row);

#endif
