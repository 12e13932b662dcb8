/* run.c: one run from its spec to a row (run_spec, plan.h): the time loop around a solver. CPU and
 * wall time are those of the solver's steps, without norms and ledger.
 *
 * Velocities live half a step after positions, so the kinetic energy at t_n is the mean of those
 * before and after step n. For the last instant one more step is taken, after the final state
 * has been written; only its kinetic energy is used. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "loop.h"
#include "common/base/table.h"

static Errors errors_now(Loop *l, double t)
{
    Points p;
    Samples q;
    if (!l->plan->scene.problem->exact) return (Errors){NAN, NAN, NAN};
    l->plan->solver->view(l->self, &p, &q);
    return norm_displacement(&l->plan->scene, &p, t, l->plan->setup.threads, &l->scratch);
}

static void take_step(Loop *l, double t)
{
    stopwatch_start(&l->steps);
    l->status = l->plan->solver->step(l->self, t, l->dt, l->done == 0);
    stopwatch_stop(&l->steps);
}

static void shoot(Loop *l, long step, bool last)
{
    if (!l->shots.dir || l->code) return;
    stopwatch_read(&l->steps); /* writing takes wall time without CPU time */
    l->code = snapshot_take(&l->shots, &l->plan->scene, l->plan->solver, l->self, step,
                            step > l->done ? pace_end_of_step(l) : l->t, last, l->fault);
}

static bool grown(const Loop *l)
{
    return l->plan->stop_growth && l->growth_step >= 0;
}

static bool stopped(const Loop *l)
{
    return l->stop && *l->stop && !pace_is_over(l) && !grown(l);
}

/* Instant 0; or, of a run that resumes, the one that it has reached. */
static void begin(Loop *l, Moment *m, Side *before)
{
    if (l->save.resume) {
        l->code = checkpoint_read(l, m, before);
        return;
    }
    *before = loop_measure_side(l);
    memcpy(l->p0, before->p, sizeof l->p0);
    l->momentum = before->mv;
    *m = (Moment){.dt = l->dt,
                  .error_linf = errors_now(l, 0).linf,
                  .nprobe = l->probes.n,
                  .nwall = l->plan->scene.nwall};
    loop_measure_state(l, m);
    if (l->shots.dir && !l->code)
        l->code = snapshot_start(&l->shots, &l->plan->setup, l->plan->solver, l->self, l->fault);
}

/* Kinetic energy and momentum between two half steps, with the share w of the second. */
static void centre(Moment *m, const Side *before, const Side *after, double w)
{
    m->kinetic = (1 - w) * before->kinetic + w * after->kinetic;
    for (int d = 0; d < DIM; d++) m->momentum[d] = (1 - w) * before->p[d] + w * after->p[d];
}

/* Instants 0 .. n - 1: the kinetic energy of instant k is known after the step from k to k + 1. */
static void run_steps(Loop *l)
{
    Side before = {0};
    Moment m = {0};
    begin(l, &m, &before);
    for (; !pace_is_over(l) && !grown(l) && !l->code && !stopped(l); l->done++) {
        const double t = l->t;
        checkpoint_write(l, &m, &before, false);
        if (relay_is_due(l) && !relay_take_over(l, &before)) return;
        if (l->plan->adaptive) pace_adapt(l);
        relay_before_step(l);
        take_step(l, t);
        if (relay_rescues(l, &before)) take_step(l, t);
        if (l->status.code != OK) {
            l->failed_at = t + l->dt;
            return;
        }
        const Side after = loop_measure_side(l);
        if (l->done == 0) loop_record_start(l, &before, &after, m.strain);
        m.t = t;
        m.dt = l->dt;
        /* the first instant is not between two halves */
        centre(&m, &before, &after, l->done > 0 ? pace_share_after(l) : 0);
        loop_record_energy(l, &m, &before, &after);
        loop_record_momentum(l, &after);
        loop_record_work(l);
        const Errors e = errors_now(l, t + l->dt);
        loop_record_errors(l, e);
        m.error_linf = e.linf;
        loop_measure_state(l, &m);
        before = after;
        shoot(l, l->done + 1, false);
        l->t = pace_end_of_step(l);
    }
    if (stopped(l)) checkpoint_write(l, &m, &before, true);
    m.t = l->t; /* recorded by last_instant */
    l->last = m;
}

/* Records the instant after the last step, for which one more step is taken. */
static void last_instant(Loop *l)
{
    Moment m = l->last;
    const Side before = loop_measure_side(l);
    if (l->plan->adaptive) pace_adapt(l);
    const Status status =
        l->done > 0 ? l->plan->solver->step(l->self, m.t, l->dt, false) : (Status){EMPTY, -1, 0};
    const double w = status.code == OK ? pace_share_after(l) : 0;
    const Side after = status.code == OK ? loop_measure_side(l) : before;
    centre(&m, &before, &after, w);
    loop_record_energy(l, &m, &before, &after);
}

static int project(Loop *l, Fault *fault)
{
    Nodes nodes;
    stopwatch_start(&l->steps);
    l->status = l->plan->solver->project(l->self);
    stopwatch_stop(&l->steps);
    stopwatch_read(&l->steps);
    if (l->status.code != OK) return 0;
    l->plan->solver->nodes(l->self, &nodes);
    if (!norm_scratch_fit(&l->scratch, nodes.n))
        return fault_set(fault, FAULT_MACHINE, "out of memory");
    l->worst = norm_projection(&l->plan->scene, &nodes, &l->scratch);
    if (isnan(l->worst.linf)) l->status = (Status){EMPTY, 0, 0}; /* no node was measured */
    return 0;
}

/* Number of steps that moved the particles: a failed step counts if it did. */
static long steps_moved(const Loop *l)
{
    Counts c;
    l->plan->solver->counts(l->self, &c);
    return l->done + (l->status.code != OK && c.moved);
}

static int write_errors_now(const char *path, Loop *l, Fault *fault)
{
    Points p;
    Samples q;
    const double t = steps_moved(l) > l->done ? pace_end_of_step(l) : l->t;
    l->plan->solver->view(l->self, &p, &q);
    return output_errors(path, &l->plan->scene, &p, t, &l->scratch, fault);
}

/* Writes the files of the end of the run; nodes have the velocities of the last projection. */
static int write_files(const RunSpec *spec, Loop *l, Fault *fault)
{
    const Solver *solver = l->plan->solver;
    int code = 0;
    if (spec->particles)
        code = output_particles(spec->particles, &l->plan->scene, solver, l->self, fault);
    if (!code && spec->samples)
        code = output_samples(spec->samples, &l->plan->scene, solver, l->self, fault);
    if (!code && spec->errors) code = write_errors_now(spec->errors, l, fault);
    if (!code && spec->nodes) code = output_nodes(spec->nodes, solver, l->self, fault);
    if (!code && spec->patches) code = output_patches(spec->patches, solver, l->self, fault);
    return code;
}

/* Allocates room for the largest number of slots that particles may need. */
bool loop_fit_scratch(Loop *l)
{
    Points p;
    Samples q;
    l->plan->solver->view(l->self, &p, &q);
    const int n = p.n > q.n ? p.n : q.n;
    return norm_scratch_fit(&l->scratch, n + CHUNK + n / 2 + 64 * CHUNK);
}

static int run_plan(const RunSpec *spec, Loop *l, Row *row, Fault *fault)
{
    int code = 0;
    if (l->plan->scene.problem->projection) {
        code = project(l, fault);
        if (!code) shoot(l, 0, true);
    } else {
        pace_choose(l);
        if (!loop_fit_scratch(l) || !loop_open(l))
            return fault_set(fault, FAULT_MACHINE, "out of memory");
        probe_find(&l->probes, spec, l->plan->solver, l->self);
        if (spec->errors && isnan(errors_now(l, 0).linf)) return plan_no_exact_motion(spec, fault);
        run_steps(l);
        stopwatch_read(&l->steps);
        shoot(l, steps_moved(l), true);
    }
    if (!code) code = l->code;
    if (!code) code = write_files(spec, l, fault);
    if (code) return code;
    report_counts(l, row);
    if (!l->plan->scene.problem->projection && l->status.code == OK) last_instant(l);
    if (l->status.code == OK && stopped(l)) l->status.code = INTERRUPTED;
    report_results(l, row);
    return 0;
}

/* The key of a saved state is the run's command, without the number of threads. */
static void set_save(Loop *l, RunSpec spec)
{
    l->save.path = spec.checkpoint;
    l->save.resume = spec.resume;
    l->save.every_s = spec.save_s > 0 ? spec.save_s : 60;
    l->save.last = l->save.began;
    l->save.program = spec.program;
    spec.threads = 0;
    spec_command(&spec, l->save.command);
}

int run_spec(const RunSpec *spec, Row *row, Fault *fault)
{
    RunSpec own = *spec;
    Plan plan;
    Loop l = {.plan = &plan,
              .stop = spec->stop,
              .taken_over = -1,
              .growth_step = -1,
              .worst = norm_no_errors,
              .drift = NAN};
    l.save.began = stopwatch_wall();
    int code = plan_make(&own, &plan, fault);
    if (code) return code;
    *row = row_empty();
    set_save(&l, own);
    l.shots = (Snapshots){.dir = own.vtk, .every = own.every, .every_s = own.every_s};
    l.fault = fault;
    report_inputs(&own, &plan, row);
    if (handover_plan(&own, &plan, &l.handover, fault)) return FAULT_USAGE;
    if ((code = spec_files_check(spec, fault))) return code;
    if (spec->vtk && snapshot_check(spec->vtk, fault)) return FAULT_MACHINE;
    if (spec->history && !(l.history = file_begin(spec->history, fault))) return FAULT_MACHINE;
    if (l.history && !own.resume) output_history_header(l.history, own.nprobe, plan.scene.nwall);
    l.self = plan.solver->make(&plan.setup, fault);
    code = l.self ? run_plan(&own, &l, row, fault) : fault->code;
    if (l.self) plan.solver->free(l.self);
    if (l.undo.f) fclose(l.undo.f);
    norm_scratch_free(&l.scratch);
    loop_close(&l);
    probe_free(&l.probes);
    snapshot_free(&l.shots);
    if (l.history && code) file_abandon(l.history, spec->history);
    if (l.history && !code) code = file_commit(l.history, spec->history, fault);
    row->wall_run_s = l.save.spent + stopwatch_wall() - l.save.began;
    return code;
}
