/* deposit.c: particles to nodes (passes.h). */
#include <string.h>
#include "half_line.h"
#include "list.h"
#include "moments.h"
#include "parts.h"
#include "passes.h"
#include "each.h"

static void clear_row(Sim *sim, int row, const void *unused)
{
    Grid *g = &sim->g;
    (void)unused;
    const size_t start = (size_t)row * (size_t)g->n[0];
    const Line zero = g->zero; /* from memory: plain stores, not a call of memset for a short row */
    for (int i = g->lo[row]; i < g->hi[row]; i++) g->node[start + (size_t)i] = zero;
    if (!g->force) return;
    for (int i = g->lo[row]; i < g->hi[row]; i++)
        for (int a = 0; a < DIM; a++) g->force[(start + (size_t)i) * DIM + (size_t)a] = 0;
    for (int i = g->lo[row]; i < g->hi[row] && g->outward; i++)
        for (int a = 0; a < DIM; a++) g->outward[(start + (size_t)i) * DIM + (size_t)a] = 0;
}

void sim_body(const Sim *sim, const Chunk *c, double t, Field b[DIM])
{
    const Scene *scene = sim->setup->scene;
    double *to[DIM];
    for (int a = 0; a < DIM; a++) to[a] = b[a];
    if (scene->problem->body)
        scene->problem->body(scene, CHUNK, c->X, t, to);
    else
        for (int a = 0; a < DIM; a++)
            for (int p = 0; p < CHUNK; p++) b[a][p] = 0;
}

double sim_distance(const Sim *sim, const int index[DIM], double t)
{
    const Scene *scene = sim->setup->scene;
    Vec x;
    for (int d = 0; d < DIM; d++) x[d] = (index[d] + sim->g.origin[d]) * sim->dx;
    return scene->problem->distance ? scene->problem->distance(scene, x, t) * sim->g.cells : NAN;
}

/* J sigma becomes P = J sigma F^-T. */
static void refer_stress(const Chunk *c, Field T[NMAT])
{
    for (int p = 0; p < CHUNK; p++) {
        Mat F, tau;
        for (int k = 0; k < NMAT; k++) F[k] = c->F[k][p], tau[k] = T[k][p];
        const double inverse = 1 / determinant(F);
        for (int k = 0; k < NMAT; k++) {
            const int a = k / DIM, b = k % DIM;
            double P = 0;
            for (int e = 0; e < DIM; e++) P += tau[a * DIM + e] * cofactor(F, e, b);
            T[k][p] = P * inverse;
        }
    }
}

/* Where particles may break. */
static void weighted_stress(const Sim *sim, const Chunk *c, const Field weight, Field T[NMAT])
{
    sim_stress(sim, c, T);
    for (int k = 0; k < NMAT; k++)
        for (int p = 0; p < CHUNK; p++) T[k][p] *= weight[p];
}

/* T = V0 J sigma / h [N], in the total frame V0 P / h, the momentum flux of a chunk; 0 in passes
 * without forces. */
static void chunk_stress(const Sim *sim, const Chunk *c, bool force, Field T[NMAT])
{
    Field weight;
    for (int p = 0; p < CHUNK; p++) weight[p] = c->V0[p] * sim->g.cells;
    if (!force || sim->method.integrate)
        memset(T, 0, sizeof(Field) * NMAT);
    else if (c->strength)
        weighted_stress(sim, c, weight, T);
    else
        material_kirchhoff_weighted(&sim->setup->scene->mat, (const double *const *)c->F, weight,
                                    T);
    if (force && sim->total) refer_stress(c, T);
}

static void chunk_body(const Sim *sim, const Chunk *c, double t, Field body[DIM])
{
    sim_body(sim, c, t, body);
    for (int a = 0; a < DIM; a++)
        for (int p = 0; p < CHUNK; p++) body[a][p] *= c->m[p];
}

/* A round of a velocity filter: mass and m w. */
static void deposit_round(Sim *sim, int k, Work *w)
{
    const Chunk c = sim_chunk(sim, k);
    const int width = sim->method.list ? 0 : make_stencils(sim, &c, w);
    if (!width) make_list(sim, &c, w);
    for (int p = 0; p < CHUNK; p++) {
        w->A[p] = (Line){0}; /* the spare lanes too: the ledger multiplies them by 0 */
        w->A[p][0] = c.m[p];
        for (int a = 0; a < DIM; a++) w->A[p][1 + a] = c.m[p] * c.w[a][p];
    }
    if (!width)
        deposit_list(&sim->g, w, false);
    else if (width == 3)
        deposit_half(&sim->g, w, 3);
    else
        deposit_half(&sim->g, w, width);
}

/* Fills w->A and w->B with the deposit of a chunk. */
static void make_payload(const Sim *sim, const Chunk *c, bool force, int width, Work *w)
{
    const Method *method = &sim->method;
    chunk_stress(sim, c, force, w->T);
    method->payload(c, (const Field *)w->T, &w->payload);
    if (method->moments) divide_by_spread(sim, w, width);
    pack_payload(sim, w, method->affine);
}

/* With general weights. */
static void deposit_listed(Sim *sim, int k, double t, Deposit what, Work *w)
{
    const Chunk c = sim_chunk(sim, k);
    make_list(sim, &c, w);
    make_payload(sim, &c, what == FORCES, 0, w);
    deposit_list(&sim->g, w, sim->method.modes);
    if (what != FORCES || !sim->g.force) return;
    chunk_body(sim, &c, t, w->body);
    deposit_force_list(&sim->g, w);
}

static void deposit_chunk(Sim *sim, int k, double t, Deposit what, Work *w)
{
    const bool affine = sim->method.affine;
    const Chunk c = sim_chunk(sim, k);
    Grid *g = &sim->g;
    const int width = make_stencils(sim, &c, w);
    make_payload(sim, &c, what == FORCES, width, w);
    if (width == 2)
        affine ? deposit_lines(g, w, 2, true) : deposit_lines(g, w, 2, false);
    else if (width == 3)
        affine ? deposit_lines(g, w, 3, true) : deposit_lines(g, w, 3, false);
    else
        affine ? deposit_lines(g, w, width, true) : deposit_lines(g, w, width, false);
    if (what != FORCES || !g->force) return;
    chunk_body(sim, &c, t, w->body);
    if (width == 3)
        deposit_force(g, w, 3);
    else
        deposit_force(g, w, width);
}

/* Adds the stress of particles on nodes, which the deposit left out. */
static void deposit_slopes(Sim *sim, int k, Work *w)
{
    const Chunk c = sim_chunk(sim, k);
    const int width = make_stencils(sim, &c, w);
    if (!w->on_node) return;
    make_payload(sim, &c, true, width, w);
    on_node_deposit(sim, w);
}

typedef enum { ALL, ON_NODES } Which;

typedef struct Task {
    double t;
    Deposit what;
    Which which;
    bool on_node; /* some particle lies on a node */
} Task;

static void deposit_chunks(Sim *sim, int first, int last, void *own)
{
    Task *task = own;
    Work w;
    bool on_node = false;
    for (int k = first; k < last; k++) {
        if (task->which == ON_NODES)
            deposit_slopes(sim, k, &w);
        else if (task->what == ROUND)
            deposit_round(sim, k, &w);
        else if (sim->method.list)
            deposit_listed(sim, k, task->t, task->what, &w);
        else
            deposit_chunk(sim, k, task->t, task->what, &w);
        on_node = on_node || w.on_node;
    }
    if (!on_node) return;
#pragma omp atomic write /* by any thread of the team: team.h */
    task->on_node = true;
}

/* Returns true if some particle lies on a node. */
static bool deposit_blocks(Sim *sim, double t, Deposit what, Which which)
{
    Task task = {t, what, which, false};
    each_block(sim, deposit_chunks, &task);
    return task.on_node;
}

void deposit_all(Sim *sim, double t, Deposit what)
{
    each_row(sim, clear_row, NULL);
    if (sim->method.assemble) {
        sim->method.assemble(sim, t, what == FORCES);
        return;
    }
    const bool on_node = deposit_blocks(sim, t, what, ALL);
    if (what == FORCES && sim->method.integrate) sim->method.integrate(sim);
    if (!on_node || what == ROUND) return;
    on_node_mark_body(sim);
    if (what == FORCES) deposit_blocks(sim, t, what, ON_NODES);
}
