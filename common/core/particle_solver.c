/* particle_solver.c: the particle core as a Solver (solver.h). */
#include <stdlib.h>
#include "skin.h"
#include "step.h"

/* A Sim with what its views need on the side. */
typedef struct Core {
    Sim *sim;
    Status start; /* a scene that is wrong from the start says so at its first step */
    double *x[DIM], *v[DIM], *m; /* live nodes, if asked for */
} Core;

static bool node_views(Core *c)
{
    const Grid *g = &c->sim->g;
    const size_t n = (size_t)g->rows * (size_t)g->n[0];
    bool ok = (c->m = malloc(n * sizeof(double))) != NULL;
    for (int d = 0; d < DIM; d++) {
        ok = (c->x[d] = malloc(n * sizeof(double))) && ok;
        ok = (c->v[d] = malloc(n * sizeof(double))) && ok;
    }
    return ok;
}

static void core_free(void *self)
{
    Core *c = self;
    sim_free(c->sim);
    for (int d = 0; d < DIM; d++) free(c->x[d]), free(c->v[d]);
    free(c->m);
    free(c);
}

static void *core_make(const Setup *setup, Fault *fault)
{
    Core *c = calloc(1, sizeof *c);
    if (!c) {
        fault_set(fault, FAULT_MACHINE, "out of memory");
        return NULL;
    }
    c->sim = sim_new(setup, fault);
    if (!c->sim || (setup->snapshot_nodes && !node_views(c))) {
        if (c->sim) fault_set(fault, FAULT_MACHINE, "out of memory");
        core_free(c);
        return NULL;
    }
    c->start = c->sim->p.count > c->sim->surface ? sim_check(c->sim) : (Status){EMPTY, -1, 0};
    if (c->start.code == OK) sim_sort(c->sim);
    return c;
}

static Status core_step(void *self, double t, double dt, bool first)
{
    Core *c = self;
    return c->start.code == OK ? sim_step(c->sim, t, dt, first) : c->start;
}

static Status core_project(void *self)
{
    Core *c = self;
    return c->start.code == OK ? sim_project(c->sim) : c->start;
}

static void core_view(const void *self, Points *points, Samples *samples)
{
    const Particles *p = &((const Core *)self)->sim->p;
    *points = (Points){.n = p->n, .id = p->id, .m = p->field[AT_M], .V0 = p->field[AT_VOL]};
    points->own_name = ((const Core *)self)->sim->method.own;
    points->own = p->field + AT_OWN;
    for (int d = 0; d < DIM; d++) {
        points->X[d] = p->field[AT_X0 + d];
        points->x[d] = p->field[AT_X + d];
        points->v[d] = p->field[AT_V + d];
    }
    *samples = (Samples){.n = p->n, .V0 = p->field[AT_VOL]};
    for (int k = 0; k < NMAT; k++) samples->F[k] = p->field[AT_F + k];
}

static void core_nodes(const void *self, Nodes *nodes)
{
    const Core *c = self;
    const Grid *g = &c->sim->g;
    int n = 0;
    for (int row = 0; row < g->rows; row++)
        for (int i = g->lo[row]; i < g->hi[row]; i++) {
            const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
            if (!(g->mass[at] > 0)) continue;
            int rest = row, index[DIM] = {i};
            for (int d = 1; d < DIM; d++) {
                index[d] = rest % g->n[d];
                rest /= g->n[d];
            }
            for (int d = 0; d < DIM; d++) {
                c->x[d][n] = (double)(index[d] + g->origin[d]) / g->cells;
                c->v[d][n] = g->node[at][d];
            }
            c->m[n++] = g->mass[at];
        }
    *nodes = (Nodes){.n = n, .m = c->m};
    for (int d = 0; d < DIM; d++) nodes->x[d] = c->x[d], nodes->v[d] = c->v[d];
}

static void core_counts(const void *self, Counts *counts)
{
    const Sim *sim = ((const Core *)self)->sim;
    *counts = (Counts){.ppc = sim->ppc,
                       .particles = sim->p.count - sim->surface,
                       .surface = sim->surface,
                       .elements = -1,
                       .moved = sim->moved,
                       .nodes = sim->nodes > 0 ? sim->nodes : -1,
                       .fallbacks = sim->method.assemble ? sim->fallbacks : -1};
}

static void core_impulse(const void *self, Vec out)
{
    for (int d = 0; d < DIM; d++) out[d] = ((const Core *)self)->sim->impulse[d];
}

static double core_work(const void *self)
{
    const Sim *sim = ((const Core *)self)->sim;
    return skin_work(sim->skin) + sim->driven;
}

static void core_outside(const void *self, Vec out)
{
    for (int d = 0; d < DIM; d++) out[d] = ((const Core *)self)->sim->outside[d];
}

static void core_patches(const void *self, PatchVisit *visit, void *own)
{
    const Sim *sim = ((const Core *)self)->sim;
    if (sim->method.patches) sim->method.patches(sim, visit, own);
}

static void core_stress(const void *self, Fields F, Fields sigma)
{
    const Sim *sim = ((const Core *)self)->sim;
    for (int at = 0; at < sim->p.n; at += CHUNK) {
        const Chunk c = sim_chunk(sim, at / CHUNK);
        Field T[NMAT];
        material_kirchhoff(&sim->setup->scene->mat, (const double *const *)c.F, T);
        for (int p = 0; p < CHUNK && at + p < sim->p.n; p++) {
            Mat f;
            for (int k = 0; k < NMAT; k++) F[k][at + p] = f[k] = c.F[k][p];
            for (int k = 0; k < NMAT; k++) sigma[k][at + p] = T[k][p] / determinant(f);
        }
    }
}

static void *core_take_over(const Setup *setup, void *self, Fault *fault)
{
    Core *next = core_make(setup, fault), *before = self;
    if (!next) return NULL;
    next->start = before->start;
    next->sim->dt_before = before->sim->dt_before;
    if (!sim_take_over(next->sim, before->sim, fault)) return next;
    core_free(next);
    return NULL;
}

static void core_stash(void *self, Stash *s)
{
    Core *c = self;
    sim_stash(c->sim, s);
    STASH(s, c->start);
}

const Solver particle_solver = {
    .make = core_make,
    .take_over = core_take_over,
    .stash = core_stash,
    .step = core_step,
    .project = core_project,
    .view = core_view,
    .nodes = core_nodes,
    .counts = core_counts,
    .impulse = core_impulse,
    .work = core_work,
    .outside = core_outside,
    .patches = core_patches,
    .point_stress = core_stress,
    .free = core_free,
};
