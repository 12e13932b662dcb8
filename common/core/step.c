/* step.c: see step.h. The integrators: W11 4.6-4.7 (cd), Wallstedt & Guilkey 2008 (uvf),
 * Sulsky et al. 1995 (musl), Bardenhagen 2002 (usl, usf).
 *
 * An integrator is a list of passes; each deposits (with forces or without), solves on the grid and
 * gathers what it takes. A pass without forces is a re-projection: v of the particles as they are.
 */
#include <limits.h>
#include <math.h>
#include "passes.h"
#include "skin.h"
#include "step.h"

typedef struct Pass {
    bool used, force;
    unsigned take;  /* TAKE_* */
    unsigned fresh; /* taken too with refresh=1: L from the accelerated velocity */
} Pass;

static const struct {
    bool half_first; /* a is halved in the first step, so that velocities belong to half steps */
    Pass pass[2];
} integrators[INTEGRATORS] = {
    [CD] = {true, {{true, true, TAKE_V | TAKE_X | TAKE_F, 0}}},
    [UVF] = {true, {{true, true, TAKE_V, TAKE_L}, {true, false, TAKE_X | TAKE_F, 0}}},
    [MUSL] = {true,
              {{true, true, TAKE_V | STASH_X, TAKE_L}, {true, false, MOVE_STASH | TAKE_F, 0}}},
    [USL] = {false, {{true, true, TAKE_V | TAKE_X | TAKE_F, 0}}},
    [USF] = {false, {{true, false, TAKE_F, 0}, {true, true, TAKE_V | TAKE_X, 0}}},
};

const Info step_integrators[INTEGRATORS] = {
    [CD] = {.name = "cd",
            .label = "CD",
            .about = "central differences: one projection a step, half the first acceleration",
            .source = "W11 4.6, 4.7",
            .formula = "v += dt a; x += dt S v, F += dt L F with the accelerated grid velocity"},
    [UVF] = {.name = "uvf",
             .label = "UVF",
             .about = "update velocity first: x and F move with the velocities projected once more",
             .source = "Wallstedt & Guilkey 2008",
             .formula = "v_p += dt S a, project v_p again, x += dt S v, F += dt L F"},
    [MUSL] = {.name = "musl",
              .label = "MUSL",
              .about = "modified update stress last: F alone takes the velocities projected again",
              .source = "Sulsky et al. 1995",
              .formula = "v_p += dt S a, x += dt S v, project v_p again, F += dt L F"},
    [USL] = {.name = "usl",
             .label = "USL",
             .about = "update stress last: cd without the half first step",
             .source = "Bardenhagen 2002",
             .formula = "v += dt a; x += dt S v, F += dt L F with the accelerated grid velocity"},
    [USF] = {.name = "usf",
             .label = "USF",
             .about = "update stress first: F takes the projected velocities before the forces",
             .source = "Bardenhagen 2002",
             .formula = "F += dt L F with the projected v, then v += dt a, x += dt S v"},
};

bool step_half_first(Integrator i)
{
    return integrators[i].half_first;
}

bool step_strain_first(Integrator i)
{
    return !integrators[i].pass[0].force && integrators[i].pass[0].take & TAKE_F;
}

Status sim_check(const Sim *sim)
{
    const Particles *p = &sim->p;
    const Scene *scene = sim->setup->scene;
    Status worst = {OK, -1, 0};
    for (int s = 0; s < p->n; s++) {
        if (p->id[s] < 0 || (worst.code != OK && p->id[s] > worst.point)) continue;
        Status own = {OK, p->id[s], 0};
        Mat F;
        for (int k = 0; k < NMAT; k++) F[k] = p->field[AT_F + k][s];
        own.value = determinant(F);
        if (!(own.value > 0)) own.code = INVERTED;
        if (isnan(own.value)) own.code = NOT_A_NUMBER;
        for (int d = 0; d < DIM; d++) {
            const double x = p->field[AT_X + d][s];
            if (!(x >= scene->lo[d] - sim->dx && x <= scene->hi[d] + sim->dx)) {
                own.value = x;
                own.code = isnan(x) ? NOT_A_NUMBER : LEFT_GRID;
            }
        }
        if (own.code != OK) worst = own;
    }
    return worst;
}

/* The status if no node has mass; it names the particle of lowest id. */
static Status without_support(const Sim *sim)
{
    int first = INT_MAX;
    for (int s = 0; s < sim->p.n; s++)
        if (sim->p.id[s] >= 0 && sim->p.id[s] < first) first = sim->p.id[s];
    return (Status){SINGULAR, first, 0};
}

/* Sorts before any particle has drifted a cell or outgrown the planned width, so that stencils stay
 * within the live spans. */
static void sort_if_due(Sim *sim)
{
    if (isinf(sim->travel)) sim->status = sim_check(sim); /* first step: check the initial state */
    if (sim->status.code == OK && (sim->travel > 1 || sim->half_now > sim->half_plan))
        sim_sort(sim);
}

static bool is_filtered(const Sim *sim, const Pass *pass)
{
    return sim->method.filter && (pass->force || !sim->method.filter_first);
}

static void impose_motion(Sim *sim, double t)
{
    const Scene *scene = sim->setup->scene;
    const Particles *p = &sim->p;
    if (scene->problem->impose)
        scene->problem->impose(scene, p->n, (const double *const *)(p->field + AT_X), t,
                               p->field + AT_V);
}

static Status take_to_nodes(Sim *sim, const Pass *pass, double t, double dt, double scale)
{
    deposit_all(sim, t, pass->force ? FORCES : MOTION);
    if (pass->force && sim->skin) skin_deposit(sim, t);
    if (is_filtered(sim, pass)) filter_open(sim);
    solve_all(sim, dt, scale, pass->force);
    return sim->live == 0 ? without_support(sim) : (Status){OK, -1, 0};
}

static Status take_to_particles(Sim *sim, const Pass *pass, double dt, bool last)
{
    if (is_filtered(sim, pass)) filter_all(sim, dt, pass->force);
    sim->moved = pass->take & (TAKE_X | MOVE_STASH);
    if (gather_all(sim, dt, pass->take | (sim->setup->refresh ? pass->fresh : 0))) {
        const Status status = sim_check(sim);
        if (status.code != OK) return status;
    }
    if (sim->half_now > sim->half_plan && !last) sim_sort(sim);
    return (Status){OK, -1, 0};
}

/* Status of the first body that went wrong; *culprit is its number. */
static Status worst_of(Sim *const body[], int n, int *culprit)
{
    for (int b = 0; b < n; b++)
        if (body[b]->status.code != OK) {
            *culprit = b;
            return body[b]->status;
        }
    return (Status){OK, -1, 0};
}

static void open_step(Sim *sim, double t)
{
    sim->moved = false;
    if (sim->status.code == OK) sort_if_due(sim);
    if (sim->status.code == OK) impose_motion(sim, t);
    mirror_move_walls(sim, t);
}

/* Factor of this step's accelerations: (dt_before + dt)/(2 dt) if velocities belong to half steps,
 * with dt_before = 0 in the first step; otherwise 1. */
static double find_scale(Sim *sim, double dt, bool first)
{
    const double before = first ? 0 : sim->dt_before > 0 ? sim->dt_before : dt;
    sim->dt_before = dt;
    return integrators[sim->setup->integrator].half_first ? 0.5 * (before + dt) / dt : 1;
}

Status sim_step_bodies(Sim *const body[], int n, double t, double dt, bool first, Meet *meet,
                       void *own, int *culprit)
{
    const Pass *passes = integrators[body[0]->setup->integrator].pass;
    double scale[MAX_BODIES];
    for (int b = 0; b < n; b++) open_step(body[b], t);
    if (worst_of(body, n, culprit).code != OK) return worst_of(body, n, culprit);
    for (int b = 0; b < n; b++) scale[b] = find_scale(body[b], dt, first);
    for (int k = 0; k < 2 && passes[k].used; k++) {
        const Pass *pass = &passes[k];
        const bool last = k > 0 || !passes[1].used;
        for (int b = 0; b < n; b++) body[b]->status = take_to_nodes(body[b], pass, t, dt, scale[b]);
        if (worst_of(body, n, culprit).code != OK) return worst_of(body, n, culprit);
        if (meet) meet(own, dt, pass->force);
        for (int b = 0; b < n; b++) body[b]->status = take_to_particles(body[b], pass, dt, last);
        if (worst_of(body, n, culprit).code != OK) return worst_of(body, n, culprit);
    }
    for (int b = 0; b < n; b++)
        if (body[b]->skin) skin_move(body[b], t, dt);
    return (Status){OK, -1, 0};
}

Status sim_step(Sim *sim, double t, double dt, bool first)
{
    int culprit;
    return sim_step_bodies(&sim, 1, t, dt, first, NULL, NULL, &culprit);
}

Status sim_project(Sim *sim)
{
    if (sim->status.code == OK) sort_if_due(sim);
    if (sim->status.code != OK) return sim->status;
    deposit_all(sim, 0, MOTION);
    if (sim->method.filter) filter_open(sim);
    solve_all(sim, 0, 1, false);
    if (sim->method.filter && !sim->method.filter_first) filter_all(sim, 0, false);
    return (Status){OK, -1, 0};
}
