/* report.c: a finished run as a row of the table (row.h has the columns). */
#include <math.h>
#include <string.h>
#include "loop.h"

static const char *const status_names[] = {"ok",       "left_grid", "inverted",      "nan",
                                           "singular", "empty",     "energy_growth", "interrupted"};

static void say_status(const Loop *l, Row *row)
{
    const bool grew = l->status.code == OK && l->growth_step >= 0;
    strcpy(row->status, status_names[grew ? ENERGY_GROWTH : l->status.code]);
    if (grew)
        snprintf(row->reason, sizeof row->reason,
                 "step %ld t=%.6g energy 5 %% above its start; fastest %s %d v=%.6g",
                 l->growth_step, l->growth_t, l->plan->setup.method ? "particle" : "node",
                 l->fastest, l->speed);
    else if (l->status.code == EMPTY)
        strcpy(row->reason, l->status.point < 0
                                ? "no particle lies inside the body"
                                : "no node with mass lies where errors are measured");
    else if (l->status.code == INTERRUPTED)
        snprintf(row->reason, sizeof row->reason, "step %ld t=%.6g of %.6g", l->done, l->t,
                 l->plan->t_end);
    else if (l->status.code == SINGULAR)
        snprintf(row->reason, sizeof row->reason,
                 "step %ld t=%.6g particle %d and all others: no node under them has mass",
                 l->done + 1, l->failed_at, l->status.point);
    else if (l->status.code != OK)
        snprintf(row->reason, sizeof row->reason, "step %ld t=%.6g %s %d %s=%.6g", l->done + 1,
                 l->failed_at, l->plan->setup.method ? "particle" : "element", l->status.point,
                 l->status.code == INVERTED ? "J" : "x", l->status.value);
}

/* When the second method took over; behind what the reason is already. */
static void say_handover(const Loop *l, Row *row)
{
    const size_t n = strlen(row->reason);
    const char *then = l->handover.plan.method->name, *after = n ? "; " : "";
    if (l->taken_over >= 0)
        snprintf(row->reason + n, sizeof row->reason - n, "%s%s from step %ld t=%.6g on", after,
                 then, l->taken_over + 1, l->taken_at);
    else
        snprintf(row->reason + n, sizeof row->reason - n, "%snever handed over to %s", after, then);
}

static double known(double count)
{
    return count >= 0 ? count : NAN;
}

void report_inputs(const RunSpec *spec, const Plan *plan, Row *row)
{
    strcpy(row->problem, spec->problem);
    strcpy(row->method, spec->method);
    strcpy(row->integrator, spec->integrator);
    strcpy(row->layout, plan->setup.fitted ? "radial" : "cartesian");
    memcpy(row->params, plan->params, sizeof row->params);
    row->cells = spec->cells;
    row->h = 1 / spec->cells;
    if (plan->setup.method) row->ppc_asked = spec->ppc; /* a mesh has none */
    row->cfl = spec->cfl > 0 ? spec->cfl : NAN;
    row->t_end = plan->t_end;
}

void report_counts(const Loop *l, Row *row)
{
    Counts c;
    l->plan->solver->counts(l->self, &c);
    if (l->taken_over >= 0) { /* the row is the first method's; nodes the most, fallbacks the sum */
        const Counts second = c;
        c = l->earlier;
        if (second.nodes > c.nodes) c.nodes = second.nodes;
        if (second.fallbacks >= 0)
            c.fallbacks = second.fallbacks + (c.fallbacks > 0 ? c.fallbacks : 0);
    }
    row->ppc = c.ppc;
    row->particles = c.particles;
    row->surface_particles = c.surface;
    row->nodes = known((double)c.nodes);
    row->elements = known(c.elements);
    row->fallbacks = known((double)c.fallbacks);
    row->particle_bytes = c.particle_bytes > 0 ? c.particle_bytes : NAN;
    row->node_bytes = c.node_bytes > 0 ? c.node_bytes : NAN;
}

void report_results(const Loop *l, Row *row)
{
    const Problem *problem = l->plan->scene.problem;
    row->steps = (double)l->done;
    if (problem->exact) {
        row->error_linf = l->worst.linf;
        row->error_l2 = l->worst.l2;
        row->error_l1 = l->worst.l1;
    }
    row->cpu_s = l->steps.cpu;
    row->wall_s = l->steps.wall;
    say_status(l, row);
    if (l->handover.at != AT_NEVER) say_handover(l, row);
    if (problem->projection) return;
    row->dt = l->plan->adaptive && l->done > 0 ? l->t / (double)l->done : l->dt;
    if (l->instants > 1) row->energy_drift = (l->now - l->start) / l->largest;
    row->momentum_drift = l->momentum > 0 ? l->drift / l->momentum : NAN;
    if (l->done > 0) row->ns_per_particle_step = 1e9 * l->steps.cpu / (row->particles * row->steps);
}
