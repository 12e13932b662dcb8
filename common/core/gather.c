/* gather.c: nodes to particles, and the check of the moved particles (passes.h). */
#include "half_line.h"
#include "list.h"
#include "moments.h"
#include "parts.h"
#include "passes.h"
#include "strain.h"
#include "common/base/team.h"

/* Extremes of one block of particles, kept per lane so that the loops vectorize; and whether any
 * went wrong. */
typedef struct Extremes {
    Field move, half;
    int bad;
} Extremes;

/* Distance moved, half widths and faults of a chunk after its update. */
static inline __attribute__((always_inline)) void
inspect_by(const Domain domain, const Sim *sim, const Chunk *c, const Work *w, Extremes *e)
{
    const Grid *g = &sim->g;
    const Scene *scene = sim->setup->scene;
    long bad = 0; /* as wide as a double, so that it stays in the comparisons' own lanes */
    for (int d = 0; d < DIM; d++) {
        const double lo = scene->lo[d] - sim->dx, hi = scene->hi[d] + sim->dx;
        const double *x = c->x[d];
        for (int p = 0; p < CHUNK; p++) {
            const double move = fabs(x[p] * g->cells - g->origin[d] - w->x[d][p]);
            const double half = sim->half * domain_stretch(domain, c->F, d, p);
            e->move[p] = move > e->move[p] ? move : e->move[p];
            e->half[p] = half > e->half[p] ? half : e->half[p];
            bad |= !(x[p] >= lo) | !(x[p] <= hi);
        }
    }
    for (int p = 0; p < CHUNK; p++) {
        Mat F;
        for (int k = 0; k < NMAT; k++) F[k] = c->F[k][p];
        bad |= !(determinant(F) > 0);
    }
    e->bad |= bad != 0;
}

/* Half widths of general weights: the method states how far they reach. */
static void inspect_reach(const Sim *sim, const Chunk *c, Extremes *e)
{
    const Place place = sim_place(sim);
    const Chunk at = sim_weight_chunk(sim, c);
    Field reach;
    sim->method.reach(&at, &place, reach);
    for (int p = 0; p < CHUNK; p++) e->half[p] = reach[p] > e->half[p] ? reach[p] : e->half[p];
}

static void inspect_chunk(const Sim *sim, const Chunk *c, const Work *w, Extremes *e)
{
    if (sim->method.list) inspect_reach(sim, c, e);
    if (sim->domain == DOMAIN_FXX)
        inspect_by(DOMAIN_FXX, sim, c, w, e);
    else if (sim->domain == DOMAIN_STRETCH)
        inspect_by(DOMAIN_STRETCH, sim, c, w, e);
    else
        inspect_by(DOMAIN_UNDEFORMED, sim, c, w, e);
}

static inline __attribute__((always_inline)) void gather_line(const Grid *g, Work *w, int width,
                                                              const int table)
{
    if (width == 2)
        gather_lines(g, w, 2, table);
    else if (width == 3)
        gather_lines(g, w, 3, table);
    else
        gather_lines(g, w, width, table);
}

static inline __attribute__((always_inline)) void gather_moments(const Sim *sim, Work *w, int width)
{
    make_moments(w, width);
    gather_line(&sim->g, w, width, T_R);
    unpack_sums(w, LANES, sim->dx);
}

/* The sums that an update reads. (Not inlined: in the loop over chunks gcc lacks registers.) */
static __attribute__((noinline)) void gather_sums(const Sim *sim, const Chunk *c, Work *w)
{
    if (sim->method.list) {
        make_list(sim, c, w);
        gather_list_and_points(sim, w);
        unpack_sums(w, 0, sim->g.cells);
        return;
    }
    const int width = make_stencils(sim, c, w);
    gather_line(&sim->g, w, width, T_G);
    if (w->on_node && sim->g.body) on_node_gather(sim, w);
    unpack_sums(w, 0, sim->g.cells);
    if (sim->method.moments) gather_moments(sim, w, width);
}

static void gather_chunk(Sim *sim, int k, double dt, unsigned take, Work *w, Extremes *e)
{
    const Method *method = &sim->method;
    Chunk c = sim_chunk(sim, k);
    gather_sums(sim, &c, w);
    if (method->list) c.list = &w->list;
    const bool linear = !sim->total && sim->setup->strain == STRAIN_LINEAR;
    const bool own_strain = take & TAKE_F && !linear;
    method->update(&c, (const Field *)w->sums, dt,
                   own_strain ? (take & ~(unsigned)TAKE_F) | TAKE_L : take);
    if (own_strain) strain_chunk(sim->setup, &c, (const Field *)w->sums, dt);
    if (take & (TAKE_X | TAKE_F | MOVE_STASH)) inspect_chunk(sim, &c, w, e);
}

void gather_start_moments(Sim *sim)
{
    Work w;
    for (int k = 0; k < sim->p.n / CHUNK; k++) {
        const Chunk c = sim_chunk(sim, k);
        const int width = make_stencils(sim, &c, &w);
        for (int d = 0; d < DIM; d++) {
            spread(sim, &w, d, width, w.b[d]);
            for (int a = 0; a < DIM; a++)
                for (int p = 0; p < CHUNK; p++) c.L[a * DIM + d][p] *= w.b[d][p];
        }
    }
}

void gather_gradient(Sim *sim, double *const L[NMAT], double *const D[DIM])
{
    Work w;
    for (int k = 0; k * CHUNK < sim->p.n; k++) {
        const Chunk c = sim_chunk(sim, k);
        const int width = sim->method.list ? 0 : make_stencils(sim, &c, &w), at = k * CHUNK;
        if (!width) make_list(sim, &c, &w);
        for (int d = 0; d < DIM; d++)
            width ? spread(sim, &w, d, width, D[d] + at) : list_spread(sim, &w, d, D[d] + at);
        if (L) gather_sums(sim, &c, &w);
        if (!L) continue;
        for (int a = 0; a < DIM; a++)
            for (int b = 0; b < DIM; b++)
                for (int p = 0; p < CHUNK; p++)
                    L[a * DIM + b][at + p] = w.sums[FLUX + b * DIM + a][p];
    }
}

static void gather_velocities(void *own, int first, int last)
{
    Sim *sim = own;
    Work w;
    for (int k = first; k < last; k++) {
        const Chunk c = sim_chunk(sim, k);
        const int width = sim->method.list ? 0 : make_stencils(sim, &c, &w);
        if (!width)
            make_list(sim, &c, &w), gather_list(&sim->g, &w);
        else if (width == 3)
            gather_half(&sim->g, &w, 3);
        else
            gather_half(&sim->g, &w, width);
        for (int p = 0; p < CHUNK; p++)
            for (int a = 0; a < DIM; a++) c.w[a][p] = w.A[p][a];
    }
}

void gather_velocity(Sim *sim)
{
    team_share(sim->setup->threads, sim->p.n / CHUNK, gather_velocities, sim);
}

typedef struct Gather {
    Sim *sim;
    double dt;
    unsigned take;
    double move, half; /* the largest of all chunks so far */
    int bad;
} Gather;

static void gather_chunks(void *own, int first, int last)
{
    Gather *all = own;
    Work w;
    Extremes e = {0};
    for (int k = first; k < last; k++) gather_chunk(all->sim, k, all->dt, all->take, &w, &e);
#pragma omp critical /* of all threads of the team: team.h */
    {
        for (int p = 0; p < CHUNK; p++) {
            all->move = fmax(all->move, e.move[p]);
            all->half = fmax(all->half, e.half[p]);
        }
        all->bad |= e.bad;
    }
}

bool gather_all(Sim *sim, double dt, unsigned take)
{
    Gather all = {.sim = sim, .dt = dt, .take = take};
    team_share(sim->setup->threads, sim->p.n / CHUNK, gather_chunks, &all);
    if (!sim->total) sim->travel += all.move;
    const unsigned widens = sim->method.list ? TAKE_X | TAKE_F | MOVE_STASH : TAKE_F;
    if (take & widens) sim->half_now = fmin(all.half, sim->half_max);
    return all.bad;
}
