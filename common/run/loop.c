/* loop.c: energy, momentum, work and errors of a run, instant by instant (loop.h). */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include "loop.h"
#include "common/core/step.h"

static Points points_of(const Loop *l)
{
    Points p;
    Samples q;
    l->plan->solver->view(l->self, &p, &q);
    return p;
}

Side loop_measure_side(Loop *l)
{
    const Points p = points_of(l);
    return ledger_motion(&p, l->plan->setup.threads, &l->scratch);
}

void loop_measure_state(Loop *l, Moment *m)
{
    Points p;
    Samples q;
    l->plan->solver->view(l->self, &p, &q);
    m->strain = ledger_strain(&l->plan->scene, &q, l->plan->setup.threads, &l->scratch);
    if (!l->history) return;
    if (!probe_measure(&l->probes, &l->plan->scene, l->plan->solver, l->self, m->probe))
        l->code = fault_set(l->fault, FAULT_MACHINE, "out of memory for --probe");
    const Volumes v = ledger_volumes(&q);
    m->volume = v.sum;
    m->least_J = v.least;
    m->most_J = v.most;
    ledger_angular_momentum(&p, m->angular);
}

/* The larger number. NAN means that nothing was measured so far and is less than any number. */
static double larger(double a, double b)
{
    return a >= b || isnan(b) ? a : b;
}

/* A lower bound of sum m |dv|^2/2 [J], the kinetic energy of the change of velocity in a step. */
static double of_change(const Side *before, const Side *after)
{
    return pow(sqrt(after->kinetic) - sqrt(before->kinetic), 2);
}

/* Integrators without a half first step move points as if the scene's velocity were that of
 * t = -dt/2: they start from the energy of the velocity half a step later. The mean of two kinetic
 * energies exceeds that of the mean velocity by a quarter of the change's. */
void loop_record_start(Loop *l, const Side *before, const Side *after, double strain)
{
    const double mean = 0.5 * (before->kinetic + after->kinetic) - 0.25 * of_change(before, after);
    const bool half_first = step_half_first(l->plan->setup.integrator);
    const Points p = points_of(l);
    l->base = (half_first ? before->kinetic : mean) + strain;
    l->noise = 0;
    for (int k = 0; k < p.n; k++) l->noise += 16 * DBL_EPSILON * p.m[k] * pow(l->plan->scene.c, 2);
}

/* True if K + S - W exceeds its start by more than ENGINE_GROWTH of the largest K + S so far, after
 * subtracting `open`, the part that the time step leaves undetermined: the mean of K(n-1/2) and
 * K(n+1/2) exceeds K at t_n by a quarter of the energy of_change, and under a force that rises from
 * zero the trapezoidal rule misses as much of W. `noise` is the round-off of stored energy, whose
 * terms have the size of the moduli, rho c^2.
 *
 * With usf the strain of t_n is that of the velocities of one step earlier, so the kinetic energy
 * of the instant before is added to it. Otherwise a stressed body released from rest would seem to
 * gain energy: K rises one step before S falls. */
static bool is_growth(Loop *l, const Moment *m, double open)
{
    const bool early = step_strain_first(l->plan->setup.integrator);
    const Counted now = {m->kinetic, open};
    const Counted own = early && l->done > 0 ? l->counted : now;
    l->counted = now;
    l->most = larger(l->most, own.kinetic + m->strain);
    if (l->done == 0) return false; /* the start is what growth is measured from */
    return own.kinetic + m->strain - m->work - l->base - own.open >
           ENGINE_GROWTH * l->most + l->noise;
}

/* Time over which the accelerations of this step act: from the middle of the step before, where the
 * integrator takes a half first step. */
static double loop_kick(const Loop *l)
{
    if (!step_half_first(l->plan->setup.integrator)) return l->dt;
    if (l->instants == 0) return 0.5 * l->dt;
    return l->dt_before > 0 ? 0.5 * (l->dt_before + l->dt) : l->dt;
}

/* Remembers the step, and the fastest point, which the row's reason names. */
static void note_growth(Loop *l)
{
    const Points p = points_of(l);
    l->growth_step = l->done;
    l->growth_t = l->t;
    l->fastest = ledger_fastest_point(&p, &l->speed);
}

void loop_record_energy(Loop *l, Moment *m, const Side *before, const Side *after)
{
    const double stored = m->kinetic + m->strain;
    m->work = l->work;
    l->now = stored - m->work;
    if (l->history) {
        probe_reactions(&l->reactions, &l->plan->scene, l->plan->solver, l->self, loop_kick(l),
                        m->wall);
    }
    if (l->instants++ == 0) l->start = l->now;
    l->largest = larger(l->largest, stored);
    if (is_growth(l, m, 0.5 * of_change(before, after)) && l->growth_step < 0) note_growth(l);
    if (l->history) output_history_line(l->history, m);
}

void loop_record_momentum(Loop *l, const Side *after)
{
    Vec impulse;
    double square = 0;
    l->plan->solver->impulse(l->self, impulse);
    for (int d = 0; d < DIM; d++) impulse[d] += l->given[d];
    for (int d = 0; d < DIM; d++) square += pow(after->p[d] - l->p0[d] - impulse[d], 2);
    l->drift = larger(l->drift, sqrt(square));
    l->momentum = larger(l->momentum, after->mv);
}

void loop_record_errors(Loop *l, Errors e)
{
    l->worst.linf = larger(l->worst.linf, e.linf);
    l->worst.l2 = larger(l->worst.l2, e.l2);
    l->worst.l1 = larger(l->worst.l1, e.l1);
}

/* Work of body forces from the instant that l->loads holds to time t, whose positions and forces
 * replace it there. */
static double work_until(Loop *l, double t)
{
    const Points p = points_of(l);
    return ledger_work(&l->plan->scene, &p, t, l->loads, l->plan->setup.threads, &l->scratch);
}

bool loop_open(Loop *l)
{
    const Points p = points_of(l);
    if (!l->plan->scene.problem->body) return true;
    l->loads = calloc((size_t)p.n + 1, sizeof *l->loads);
    if (l->loads) work_until(l, l->t);
    return l->loads;
}

void loop_close(Loop *l)
{
    free(l->loads);
    l->loads = NULL;
}

void loop_record_work(Loop *l)
{
    if (l->loads) l->bodies += work_until(l, pace_end_of_step(l));
    l->work = l->bodies + l->plan->solver->work(l->self);
}
