/* sim.c: see sim.h. Everything a run needs is allocated here, once. */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>
#include "common/contract/layout.h"
#include "sim.h"
#include "skin.h"

/* Cap of half widths [cells]: a stretch of 4, at least 1.5 cells; of general weights, the widest.
 */
static double widest_half(double half, bool list)
{
    const double most = (MAX_WIDTH - 5) / 2.0;
    return list ? most : fmin(fmax(1.5, 4 * half), most);
}

static bool field_used(const Sim *sim, int field)
{
    if (field >= AT_OWN) return field - AT_OWN < sim_own_count(&sim->method);
    if (field >= AT_STRENGTH) return sim->setup->scene && sim->setup->scene->problem->strength;
    if (field >= AT_N) return sim->method.surface;
    if (field >= AT_W) return sim->method.filter;
    if (field >= AT_U) return sim->setup->integrator == MUSL;
    if (field >= AT_L) return sim->method.keeps_L || sim->setup->refresh;
    return true;
}

void *sim_array(size_t n, size_t size)
{
    void *memory = NULL;
    const size_t line = _Alignof(Line) > 64 ? _Alignof(Line) : 64; /* 3D: two cache lines */
    if (posix_memalign(&memory, line, (n + 1) * size)) return NULL;
    return memory;
}

/* The same in huge pages, where the system gives them: a fault of each small page costs more than a
 * step of the particles in it. */
static void *get_huge(size_t n, size_t size)
{
    enum { HUGE = 1 << 21 };
    void *memory = NULL;
    if (n * size < 2 * HUGE) return sim_array(n, size);
    if (posix_memalign(&memory, HUGE, n * size)) return NULL;
    madvise(memory, n * size, MADV_HUGEPAGE); /* else it stays as it is */
    return memory;
}

static bool has_moving_walls(const Scene *scene)
{
    for (int k = 0; k < scene->nwall; k++)
        if (fabs(scene->wall[k].speed) > 0) return true;
    return false;
}

/* Nodes are allocated and not touched here: only live spans ever cost memory. */
static bool grid_alloc(Sim *sim)
{
    Grid *g = &sim->g;
    const Setup *s = sim->setup;
    const size_t n = (size_t)g->rows * (size_t)g->n[0];
    int longest = 0, ok = true;
    for (int d = 0; d < DIM; d++) {
        longest = g->n[d] > longest ? g->n[d] : longest;
        ok = (g->hold[d] = calloc((size_t)g->n[d], 1)) && ok;
    }
    ok = (g->node = sim_array(n, sizeof(Line))) && ok;
    ok = (g->lo = sim_array((size_t)g->rows, sizeof(int))) && ok;
    ok = (g->hi = sim_array((size_t)g->rows, sizeof(int))) && ok;
    ok = (g->live = calloc((size_t)g->rows, sizeof(int))) && ok;
    for (int d = 0; d < DIM && has_moving_walls(s->scene); d++)
        ok = (g->drive[d] = calloc((size_t)g->n[d], sizeof(double))) && ok;
    if (has_moving_walls(s->scene)) ok = (g->work = calloc((size_t)g->rows, sizeof(double))) && ok;
    ok = (g->impulse = calloc((size_t)g->rows, sizeof(Vec))) && ok;
    ok = (g->count = sim_array((size_t)longest + 1, sizeof(int))) && ok;
    if (s->scene->problem->body || s->scene->traction)
        ok = (g->force = sim_array(n * DIM, sizeof(double))) && ok;
    if (s->scene->traction && s->method->assemble)
        ok = (g->outward = sim_array(n * DIM, sizeof(double))) && ok;
    if (s->method->filter) ok = (g->keep = sim_array(n, sizeof(Line))) && ok;
    if (s->snapshot_nodes) ok = (g->mass = calloc(n, sizeof(double))) && ok;
    if (!s->method->assemble) ok = (g->body = calloc(n, 1)) && ok;
    return ok;
}

/* All fields in one piece, each nine cache lines further than a multiple of a page: the same chunk
 * of all fields would else fall into the same few sets of the first-level cache. */
static bool fields_alloc(Sim *sim)
{
    enum { PAGE = 4096 / sizeof(double), STAGGER = 9 * 64 / sizeof(double) };
    Particles *p = &sim->p;
    const size_t stride = ((size_t)p->room + PAGE - 1) / PAGE * PAGE + STAGGER;
    size_t used = 0, fields = 1;
    for (int f = 0; f < FIELDS; f++) fields += field_used(sim, f);
    if (!(p->arena = get_huge(fields * stride, sizeof(double)))) return false;
    p->spare = p->arena;
    for (int f = 0; f < FIELDS; f++)
        if (field_used(sim, f)) p->field[f] = p->arena + ++used * stride;
    return true;
}

/* Slots: every block of rows may need up to a chunk of padding. */
static bool particles_alloc(Sim *sim)
{
    Particles *p = &sim->p;
    const int blocks = grid_most_blocks(&sim->g);
    p->room = (p->count + blocks * CHUNK + CHUNK - 1) / CHUNK * CHUNK;
    const size_t room = (size_t)p->room;
    bool ok = (sim->block = calloc((size_t)blocks, sizeof(Block))) != NULL;
    ok = fields_alloc(sim) && ok;
    ok = (p->id = sim_array(room, sizeof(int))) && ok;
    ok = (p->order = sim_array(room, sizeof(int))) && ok;
    ok = (p->source = sim_array(room, sizeof(int))) && ok;
    for (int d = 0; d < DIM; d++) ok = (p->key[d] = sim_array(room, sizeof(int))) && ok;
    return ok;
}

double sim_particle_bytes(const Sim *sim)
{
    size_t bytes = (3 + DIM) * sizeof(int); /* id, order, source, key */
    for (int f = 0; f < FIELDS; f++) bytes += field_used(sim, f) * sizeof(double);
    return (double)bytes;
}

double sim_node_bytes(const Sim *sim)
{
    const Scene *scene = sim->setup->scene;
    const bool forces = scene && (scene->problem->body || scene->traction);
    return (double)(sizeof(Line) * (sim->method.filter ? 2 : 1) + sim->method.node_bytes) + 1 +
           (forces ? 8.0 * DIM : 0);
}

/* Estimate of the bytes that a run needs, before any is allocated; a double cannot overflow. The
 * layout has positions and normals of its own. */
static double bytes_needed(const Sim *sim, double particles)
{
    const Scene *scene = sim->setup->scene;
    double nodes = 1;
    for (int d = 0; d < DIM; d++) nodes *= (scene->hi[d] - scene->lo[d]) * sim->g.cells + 8;
    return nodes * sim_node_bytes(sim) +
           particles * (sim_particle_bytes(sim) + 8.0 * (2 * DIM + 1));
}

static double body_volume(const Scene *scene)
{
    double volume = 1;
    for (int d = 0; d < DIM; d++) volume *= scene->body_hi[d] - scene->body_lo[d];
    return volume;
}

/* A scene that cannot fit is refused before any memory is taken. */
static int check_size(const Sim *sim, Fault *fault)
{
    const Setup *s = sim->setup;
    const double particles = body_volume(s->scene) * pow(s->cells, DIM) * s->ppc;
    const double need = bytes_needed(sim, particles);
    const double have = (double)sysconf(_SC_PHYS_PAGES) * (double)sysconf(_SC_PAGESIZE);
    if (need < have && particles < INT_MAX / 2) return 0;
    return fault_set(
        fault, FAULT_MACHINE,
        "%s with %d cells and ppc %g needs %.3g GB of memory, this machine has %.3g GB",
        s->scene->problem->info.name, s->cells, s->ppc, need / 1e9, have / 1e9);
}

static void make_grid(Sim *sim)
{
    Grid *g = &sim->g;
    const Scene *scene = sim->setup->scene;
    const int ghosts = sim->method.width(sim->half_max) / 2 + 4;
    g->rows = 1;
    for (int d = 0; d < DIM; d++) {
        g->origin[d] = (int)floor(scene->lo[d] * g->cells + 1e-9) - ghosts;
        g->n[d] = (int)ceil(scene->hi[d] * g->cells - 1e-9) + ghosts + 1 - g->origin[d];
        if (d > 0) g->rows *= g->n[d];
    }
}

/* Nodes with less than this fraction of a particle's mass count as empty. With C1 weights the force
 * falls as sqrt(mass), so light nodes are safe. With tents it does not fall, but on_node.c removes
 * it from nodes reached by less than ON_NODE along an axis. WLS integrates masses over cells. */
static double least_part(const Method *method)
{
    if (method->smooth) return 1e-24;
    return method->assemble ? 1e-12 : pow(0.01 * ON_NODE, DIM);
}

static void fill_particles(Sim *sim, const Layout *layout)
{
    Particles *p = &sim->p;
    const Scene *scene = sim->setup->scene;
    const bool surface = sim->method.surface;
    int n = 0;
    for (int k = 0; k < layout->n; k++) {
        if (!surface && !(layout->volume[k] > 0)) continue;
        for (int d = 0; d < DIM; d++) p->field[AT_X0 + d][n] = layout->X[d][k];
        for (int d = 0; surface && d < DIM; d++) p->field[AT_N + d][n] = layout->normal[d][k];
        p->field[AT_VOL][n] = layout->volume[k];
        p->field[AT_M][n] = layout->volume[k] * scene->mat.rho;
        p->id[n] = n;
        n++;
    }
    p->n = n;
    const double mean = scene->mat.rho * body_volume(scene) / (n - sim->surface);
    sim->mass_cut = least_part(&sim->method) * mean;
    sim->mass_body = ON_NODE * mean;
}

/* Initial state: x = X + u; u, v, F, L from Problem.start. */
static bool start_particles(Sim *sim)
{
    Particles *p = &sim->p;
    const Scene *scene = sim->setup->scene;
    const size_t room = (size_t)p->room;
    double *L = calloc(room * NMAT, sizeof(double)), *l[NMAT];
    if (!L) return false;
    for (int k = 0; k < NMAT; k++) {
        l[k] = p->field[AT_L + k] ? p->field[AT_L + k] : L + (size_t)k * room;
        for (int s = 0; s < p->n; s++) l[k][s] = 0, p->field[AT_F + k][s] = k % (DIM + 1) == 0;
    }
    for (int d = 0; d < DIM; d++)
        for (int s = 0; s < p->n; s++) p->field[AT_X + d][s] = p->field[AT_V + d][s] = 0;
    if (scene->problem->start)
        scene->problem->start(scene, p->n, (const double *const *)(p->field + AT_X0),
                              p->field + AT_X, p->field + AT_V, p->field + AT_F, l);
    for (int d = 0; d < DIM; d++)
        for (int s = 0; s < p->n; s++) p->field[AT_X + d][s] += p->field[AT_X0 + d][s];
    sim_start_strength(sim);
    if (sim->total && p->field[AT_L]) sim_refer_gradient(p);
    free(L);
    return true;
}

static int build(Sim *sim, Layout *layout, Fault *fault)
{
    const Setup *s = sim->setup;
    const double per_axis = pow(s->ppc, 1.0 / DIM);
    sim->g.cells = s->cells;
    sim->dx = 1.0 / s->cells;
    if (check_size(sim, fault)) return -1;
    layout->dense = sim->method.surface_per_cell / per_axis;
    if (layout_make(layout, s->scene, sim->dx / per_axis, s->count, s->fitted, fault)) return -1;
    sim->ppc = layout_ppc(layout, s->ppc, sim->dx);
    sim->half = 0.5 / per_axis * (layout->fit > 0 ? layout->fit : 1); /* l0 = h/(2n), n as placed */
    sim->half_max = widest_half(sim->half, sim->method.list);
    for (int k = 0; k < layout->n; k++) {
        const bool surface = s->method->surface && !(layout->volume[k] > 0);
        sim->p.count += surface || layout->volume[k] > 0;
        sim->surface += surface;
    }
    make_grid(sim);
    if (!grid_alloc(sim) || !particles_alloc(sim))
        return fault_set(fault, FAULT_MACHINE, "out of memory for %d particles", sim->p.count);
    mirror_set_walls(sim);
    if (sim->method.make && !sim->method.make(sim))
        return fault_set(fault, FAULT_MACHINE, "out of memory");
    fill_particles(sim, layout);
    if (!start_particles(sim) || !skin_new(&sim->skin, sim, sim->dx / per_axis))
        return fault_set(fault, FAULT_MACHINE, "out of memory");
    sim_restart(sim);
    return 0;
}

Sim *sim_new(const Setup *setup, Fault *fault)
{
    Sim *sim = sim_array(1, sizeof *sim);
    Layout layout = {0};
    if (!sim) {
        fault_set(fault, FAULT_MACHINE, "out of memory");
        return NULL;
    }
    *sim = (Sim){.setup = setup, .method = method_adapted(setup->method, setup->method_par)};
    sim->total = setup->frame == FRAME_TOTAL;
    sim->domain = sim->total ? DOMAIN_UNDEFORMED : setup->domain;
    const int bad = build(sim, &layout, fault);
    layout_free(&layout);
    if (!bad) return sim;
    sim_free(sim);
    return NULL;
}

void sim_free(Sim *sim)
{
    if (!sim) return;
    Grid *g = &sim->g;
    Particles *p = &sim->p;
    if (sim->own) sim->method.free(sim);
    for (int d = 0; d < DIM; d++) free(g->hold[d]), free(g->drive[d]);
    free(g->work);
    free(g->node), free(g->keep), free(g->lo), free(g->hi), free(g->live), free(g->impulse),
        free(g->count);
    free(g->force), free(g->outward), free(g->mass), free(g->body), free(sim->block);
    free(p->arena), free(p->id), free(p->order), free(p->source);
    for (int d = 0; d < DIM; d++) free(p->key[d]);
    skin_free(sim->skin);
    free(sim);
}
