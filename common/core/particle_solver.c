/* particle_solver.c: the particle core as a Solver (solver.h). */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "contact.h"
#include "step.h"

/* The sims of a scene's bodies, one or two, with what their views need on the side. */
typedef struct Core {
    Sim *sim[2];
    int bodies;
    Setup setup[2]; /* of two bodies, with the scene of each */
    Scene scene[2];
    Contact contact;
    double *field[FIELDS]; /* of both bodies, one after the other */
    int *id;
    Status start; /* a scene that is wrong from the start says so at its first step */
    double *x[DIM], *v[DIM], *m; /* live nodes, if asked for */
} Core;

static bool node_views(Core *c)
{
    size_t n = 0;
    for (int b = 0; b < c->bodies; b++) n += (size_t)c->sim[b]->g.rows * (size_t)c->sim[b]->g.n[0];
    bool ok = (c->m = malloc(n * sizeof(double))) != NULL;
    for (int d = 0; d < DIM; d++) {
        ok = (c->x[d] = malloc(n * sizeof(double))) && ok;
        ok = (c->v[d] = malloc(n * sizeof(double))) && ok;
    }
    return ok;
}

static bool is_viewed(int field)
{
    return field <= AT_VOL;
}

/* Contact of two bodies, and room for the view of both. */
static bool join_bodies(Core *c)
{
    const Scene *scene = &c->scene[0];
    const size_t n = (size_t)(c->sim[0]->p.room + c->sim[1]->p.room);
    bool ok = (c->id = malloc(n * sizeof(int))) != NULL;
    for (int f = 0; f < FIELDS; f++)
        if (is_viewed(f)) ok = (c->field[f] = malloc(n * sizeof(double))) && ok;
    return contact_make(&c->contact, c->sim[0], c->sim[1], scene->contact, scene->friction) && ok;
}

static void core_free(void *self)
{
    Core *c = self;
    for (int b = 0; b < 2; b++) sim_free(c->sim[b]);
    for (int d = 0; d < DIM; d++) free(c->x[d]), free(c->v[d]);
    for (int f = 0; f < FIELDS; f++) free(c->field[f]);
    free(c->id), free(c->m);
    contact_free(&c->contact);
    free(c);
}

/* Setup of one of two bodies: its share of a number of particles is that of its length. */
static void set_part(Core *c, const Setup *whole, int b)
{
    Setup *s = &c->setup[b];
    double length[2];
    *s = *whole;
    s->scene = &c->scene[b];
    s->snapshot_nodes = true; /* contact looks at masses */
    if (b && whole->method_b) s->method = whole->method_b, s->method_par = whole->method_b_par;
    for (int k = 0; k < 2; k++) {
        c->scene[b] = *whole->scene;
        whole->scene->problem->part(&c->scene[b], k ? b : 1 - b);
        length[k] = c->scene[b].body_hi[0] - c->scene[b].body_lo[0];
    }
    s->count = (int)lround(whole->count * length[1] / (length[0] + length[1]));
}

static bool make_sims(Core *c, const Setup *setup, Fault *fault)
{
    c->bodies = setup->scene->problem->part ? 2 : 1;
    for (int b = 0; b < c->bodies; b++) {
        if (c->bodies > 1) set_part(c, setup, b);
        if (!(c->sim[b] = sim_new(c->bodies > 1 ? &c->setup[b] : setup, fault))) return false;
    }
    if ((!setup->snapshot_nodes || node_views(c)) && (c->bodies == 1 || join_bodies(c)))
        return true;
    fault_set(fault, FAULT_MACHINE, "out of memory");
    return false;
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
    if (!make_sims(c, setup, fault)) {
        core_free(c);
        return NULL;
    }
    c->start = (Status){OK, -1, 0};
    for (int b = 0; b < c->bodies && c->start.code == OK; b++) c->start = check_start(c->sim[b]);
    for (int b = 0; b < c->bodies && c->start.code == OK; b++) sim_sort(c->sim[b]);
    return c;
}

static Status core_step(void *self, double t, double dt, bool first)
{
    Core *c = self;
    int culprit = 0;
    if (c->start.code != OK) return c->start;
    if (c->bodies == 1) return sim_step(c->sim[0], t, dt, first);
    Status s = sim_step_bodies(c->sim, 2, t, dt, first, contact_meet, &c->contact, &culprit);
    if (culprit > 0 && s.point >= 0) s.point += c->sim[0]->p.count;
    return s;
}

static Status core_project(void *self)
{
    Core *c = self;
    return c->start.code == OK ? sim_project(c->sim[0]) : c->start;
}

/* Copies both bodies' particles, one after the other; the second one's ids go on where the first
 * one's end. Returns the number of slots. */
static int copy_both(const Core *c)
{
    int n = 0;
    for (int b = 0; b < c->bodies; b++) {
        const Particles *p = &c->sim[b]->p;
        for (int f = 0; f < FIELDS; f++)
            if (is_viewed(f)) memcpy(c->field[f] + n, p->field[f], sizeof(double) * (size_t)p->n);
        for (int k = 0; k < p->n; k++)
            c->id[n + k] = p->id[k] < 0 ? -1 : p->id[k] + (b ? c->sim[0]->p.count : 0);
        n += p->n;
    }
    return n;
}

static void core_view(const void *self, Points *points, Samples *samples)
{
    const Core *c = self;
    const Particles *p = &c->sim[0]->p;
    const bool both = c->bodies > 1;
    double *const *field = both ? c->field : p->field;
    const int n = both ? copy_both(c) : p->n;
    *points = (Points){.n = n,
                       .id = both ? c->id : p->id,
                       .m = field[AT_M],
                       .V0 = field[AT_VOL],
                       .second = both ? p->count : 0};
    for (int d = 0; d < DIM; d++) {
        points->X[d] = field[AT_X0 + d];
        points->x[d] = field[AT_X + d];
        points->v[d] = field[AT_V + d];
    }
    *samples = (Samples){.n = n, .V0 = field[AT_VOL]};
    for (int k = 0; k < NMAT; k++) samples->F[k] = field[AT_F + k];
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
    for (int b = 0; b < c->bodies; b++) n = add_nodes(c, c->sim[b], n);
    *nodes = (Nodes){.n = n, .m = c->m};
    for (int d = 0; d < DIM; d++) nodes->x[d] = c->x[d], nodes->v[d] = c->v[d];
}

static void core_counts(const void *self, Counts *counts)
{
    const Core *c = self;
    double cells = 0;
    *counts = (Counts){.elements = -1, .fallbacks = -1};
    for (int b = 0; b < c->bodies; b++) {
        const Sim *sim = c->sim[b];
        const int own = sim->p.count - sim->surface;
        cells += own / sim->ppc;
        counts->ppc = b ? (counts->particles + own) / cells : sim->ppc;
        counts->particles += own;
        counts->surface += sim->surface;
        counts->nodes += sim->nodes;
        if (sim->method.assemble)
            counts->fallbacks = (counts->fallbacks > 0 ? counts->fallbacks : 0) + sim->fallbacks;
    }
    if (counts->nodes == 0) counts->nodes = -1;
}

static void core_impulse(const void *self, Vec out)
{
    const Core *c = self;
    for (int d = 0; d < DIM; d++) out[d] = c->sim[0]->impulse[d];
    for (int d = 0; d < DIM && c->bodies > 1; d++) out[d] += c->sim[1]->impulse[d];
}

static double core_friction(const void *self)
{
    return ((const Core *)self)->contact.work;
}

static void core_patches(const void *self, PatchVisit *visit, void *own)
{
    const Core *c = self;
    for (int b = 0; b < c->bodies; b++)
        if (c->sim[b]->method.patches) c->sim[b]->method.patches(c->sim[b], visit, own);
}

static void add_stress(const Sim *sim, int first, Fields F, Fields sigma)
{
    for (int at = 0; at < sim->p.n; at += CHUNK) {
        const Chunk c = sim_chunk(sim, at / CHUNK);
        Field T[NMAT];
        material_kirchhoff(&sim->setup->scene->mat, (const double *const *)c.F, T);
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
    const Core *c = self;
    for (int b = 0; b < c->bodies; b++) add_stress(c->sim[b], b ? c->sim[0]->p.n : 0, F, sigma);
}

const Solver particle_solver = {
    .make = core_make,
    .step = core_step,
    .project = core_project,
    .view = core_view,
    .nodes = core_nodes,
    .counts = core_counts,
    .impulse = core_impulse,
    .friction = core_friction,
    .patches = core_patches,
    .point_stress = core_stress,
    .free = core_free,
};
