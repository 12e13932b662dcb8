/* particle_solver.c: the particle core as a Solver (solver.h). */
#include <stdlib.h>
#include "bodies.h"
#include "skin.h"

/* The sims of a scene's bodies, with what their views need on the side. */
typedef struct Core {
    Bodies all;
    Status start;                /* fault of the initial state, which the first step returns */
    double *x[DIM], *v[DIM], *m; /* live nodes, if asked for */
} Core;

static bool node_views(Core *c)
{
    size_t n = 0;
    for (int b = 0; b < c->all.n; b++) {
        const Grid *g = &c->all.sim[b]->g;
        n += (size_t)g->rows * (size_t)g->n[0];
    }
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
    bodies_free(&c->all);
    for (int d = 0; d < DIM; d++) free(c->x[d]), free(c->v[d]);
    free(c->m);
    free(c);
}

static Status check_start(const Sim *sim)
{
    return sim->p.count > sim->surface ? sim_check(sim) : (Status){EMPTY, -1, 0};
}

static void *core_make(const Setup *setup, Fault *fault)
{
    Core *c = calloc(1, sizeof *c);
    if (!c) {
        fault_set(fault, FAULT_MACHINE, "out of memory");
        return NULL;
    }
    const bool made = bodies_make(&c->all, setup, fault);
    if (!made || (setup->snapshot_nodes && !node_views(c))) {
        if (made) fault_set(fault, FAULT_MACHINE, "out of memory");
        core_free(c);
        return NULL;
    }
    c->start = (Status){OK, -1, 0};
    for (int b = 0; b < c->all.n && c->start.code == OK; b++) c->start = check_start(c->all.sim[b]);
    for (int b = 0; b < c->all.n && c->start.code == OK; b++) sim_sort(c->all.sim[b]);
    return c;
}

static Status core_step(void *self, double t, double dt, bool first)
{
    Core *c = self;
    return c->start.code == OK ? bodies_step(&c->all, t, dt, first) : c->start;
}

static Status core_project(void *self)
{
    Core *c = self;
    return c->start.code == OK ? sim_project(c->all.sim[0]) : c->start;
}

static void core_view(const void *self, Points *points, Samples *samples)
{
    bodies_view(&((const Core *)self)->all, points, samples);
}

/* Adds the live nodes of a body to the n there are; returns their number. */
static int add_nodes(const Core *c, const Sim *sim, int n)
{
    const Grid *g = &sim->g;
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
    return n;
}

static void core_nodes(const void *self, Nodes *nodes)
{
    const Core *c = self;
    int n = 0;
    for (int b = 0; b < c->all.n; b++) n = add_nodes(c, c->all.sim[b], n);
    *nodes = (Nodes){.n = n, .m = c->m};
    for (int d = 0; d < DIM; d++) nodes->x[d] = c->x[d], nodes->v[d] = c->v[d];
}

static void core_counts(const void *self, Counts *counts)
{
    bodies_counts(&((const Core *)self)->all, counts);
}

static void core_impulse(const void *self, Vec out)
{
    const Bodies *all = &((const Core *)self)->all;
    for (int d = 0; d < DIM; d++) out[d] = all->sim[0]->impulse[d];
    for (int d = 0; d < DIM && all->n > 1; d++) out[d] += all->sim[1]->impulse[d];
}

static double core_work(const void *self)
{
    const Bodies *all = &((const Core *)self)->all;
    double work = all->n > 1 ? all->contact.work : skin_work(all->sim[0]->skin);
    for (int b = 0; b < all->n; b++) work += all->sim[b]->driven - sim_lost(all->sim[b]);
    return work;
}

static void core_outside(const void *self, Vec out)
{
    const Bodies *all = &((const Core *)self)->all;
    for (int d = 0; d < DIM; d++) out[d] = all->sim[0]->outside[d];
    for (int d = 0; d < DIM && all->n > 1; d++) out[d] += all->sim[1]->outside[d];
}

static void core_patches(const void *self, PatchVisit *visit, void *own)
{
    const Bodies *all = &((const Core *)self)->all;
    for (int b = 0; b < all->n; b++)
        if (all->sim[b]->method.patches) all->sim[b]->method.patches(all->sim[b], visit, own);
}

static void add_stress(const Sim *sim, int first, Fields F, Fields sigma)
{
    for (int at = 0; at < sim->p.n; at += CHUNK) {
        const Chunk c = sim_chunk(sim, at / CHUNK);
        Field T[NMAT];
        sim_stress_now(sim, &c, T);
        for (int p = 0; p < CHUNK && at + p < sim->p.n; p++) {
            Mat f;
            const int to = first + at + p;
            for (int k = 0; k < NMAT; k++) F[k][to] = f[k] = c.F[k][p];
            for (int k = 0; k < NMAT; k++) sigma[k][to] = T[k][p] / determinant(f);
        }
    }
}

static void core_stress(const void *self, Fields F, Fields sigma)
{
    const Bodies *all = &((const Core *)self)->all;
    for (int b = 0; b < all->n; b++) add_stress(all->sim[b], b ? all->sim[0]->p.n : 0, F, sigma);
}

/* Of one body: hand-over is refused in scenes with two. */
static void *core_take_over(const Setup *setup, void *self, Fault *fault)
{
    Core *next = core_make(setup, fault), *before = self;
    if (!next) return NULL;
    Sim *to = next->all.sim[0], *from = before->all.sim[0];
    next->start = before->start;
    to->dt_before = from->dt_before;
    if (!sim_take_over(to, from, fault)) return next;
    core_free(next);
    return NULL;
}

static void core_stash(void *self, Stash *s)
{
    Core *c = self;
    bodies_stash(&c->all, s);
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
