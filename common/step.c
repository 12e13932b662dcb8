/* step.c: see step.h. PHYSICS of the integrators: W11 4.6-4.7 (cd), Wallstedt & Guilkey 2008 (uvf),
 * Sulsky et al. 1995 (musl), Bardenhagen 2002 (usl, usf).
 *
 * An integrator is a list of passes; each deposits (with forces or without), solves on the grid and
 * gathers what it takes. A pass without forces is a re-projection: v of the particles as they are. */
#include <math.h>
#include "scheme.h"
#include "step.h"

typedef struct Pass {
    bool used, force;
    unsigned take;  /* TAKE_* */
    unsigned fresh; /* taken too with refresh=1: L from the accelerated velocity */
} Pass;

static const struct {
    bool half_first; /* a is halved in the first step: velocities live half a step later */
    Pass pass[2];
} integrators[INTEGRATORS] = {
    [CD] = {true, {{true, true, TAKE_V | TAKE_X | TAKE_F, 0}}},
    [UVF] = {true, {{true, true, TAKE_V, TAKE_L}, {true, false, TAKE_X | TAKE_F, 0}}},
    [MUSL] = {true,
              {{true, true, TAKE_V | STASH_X, TAKE_L}, {true, false, MOVE_STASH | TAKE_F, 0}}},
    [USL] = {false, {{true, true, TAKE_V | TAKE_X | TAKE_F, 0}}},
    [USF] = {false, {{true, false, TAKE_F, 0}, {true, true, TAKE_V | TAKE_X, 0}}},
};

const char *const integrator_names[INTEGRATORS + 1] = {"cd", "uvf", "musl", "usl", "usf", NULL};

/* Extremes of one block of particles, kept per lane so that the loops vectorize. */
typedef struct Extremes {
    Field move, half, bad;
} Extremes;

static void clear_row(Grid *g, int row)
{
    const size_t start = (size_t)row * (size_t)g->n[0];
    for (int i = g->lo[row]; i < g->hi[row]; i++) g->node[start + (size_t)i] = (Line){0};
    if (!g->force) return;
    for (int i = g->lo[row]; i < g->hi[row]; i++)
        for (int a = 0; a < DIM; a++) g->force[(start + (size_t)i) * DIM + (size_t)a] = 0;
}

void sim_stress(const Sim *sim, const Chunk *c, Field T[NMAT])
{
    kirchhoff(&sim->setup->scene->mat, (const double *const *)c->F, T);
}

/* Stress of a chunk as momentum flux V0 J sigma / h [N], or none. */
static void chunk_stress(const Sim *sim, const Chunk *c, bool force, Field T[NMAT])
{
    if (force) sim_stress(sim, c, T);
    for (int k = 0; k < NMAT; k++)
        for (int p = 0; p < CHUNK; p++) T[k][p] = force ? T[k][p] * c->V0[p] * sim->g.cells : 0;
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

static void chunk_body(const Sim *sim, const Chunk *c, double t, Field body[DIM])
{
    sim_body(sim, c, t, body);
    for (int a = 0; a < DIM; a++)
        for (int p = 0; p < CHUNK; p++) body[a][p] *= c->m[p];
}

static void deposit_chunk(Sim *sim, int k, double t, bool force, Work *w)
{
    const Method *method = &sim->method;
    const Chunk c = sim_chunk(sim, k);
    Grid *g = &sim->g;
    const int width = make_stencils(sim, &c, w);
    chunk_stress(sim, &c, force, w->T);
    method->payload(&c, (const Field *)w->T, &w->payload);
    pack_payload(sim, w, method->affine);
    if (width == 2)
        method->affine ? deposit(g, w, 2, true) : deposit(g, w, 2, false);
    else if (width == 3)
        method->affine ? deposit(g, w, 3, true) : deposit(g, w, 3, false);
    else
        method->affine ? deposit(g, w, width, true) : deposit(g, w, width, false);
    if (!force || !g->force) return;
    chunk_body(sim, &c, t, w->body);
    if (width == 3)
        deposit_force(g, w, 3);
    else
        deposit_force(g, w, width);
}

static void clear_all(Sim *sim)
{
    Grid *g = &sim->g;
#pragma omp parallel for schedule(static) num_threads(sim->setup->threads)
    for (int row = 0; row < g->rows; row++)
        if (g->lo[row] < g->hi[row]) clear_row(g, row);
}

/* Even blocks, then odd blocks: two of one parity never meet, so sums have one order. */
static void deposit_all(Sim *sim, double t, bool force)
{
    clear_all(sim);
    if (sim->method.assemble) {
        sim->method.assemble(sim, t, force);
        return;
    }
#pragma omp parallel num_threads(sim->setup->threads)
    {
        Work w;
        for (int parity = 0; parity < 2; parity++) {
#pragma omp for schedule(dynamic, 1)
            for (int b = parity; b < sim->nblock; b += 2)
                for (int k = sim->block[b].first; k < sim->block[b].last; k++)
                    deposit_chunk(sim, k, t, force, &w);
        }
    }
}

/* The moved distance, half widths and faults of a chunk after its update. */
static void inspect_chunk(const Sim *sim, const Chunk *c, const Work *w, Extremes *e)
{
    const Grid *g = &sim->g;
    const Scene *scene = sim->setup->scene;
    for (int d = 0; d < DIM; d++) {
        const double lo = scene->lo[d] - sim->dx, hi = scene->hi[d] + sim->dx;
        const double *x = c->x[d], *F = c->F[d * (DIM + 1)];
        for (int p = 0; p < CHUNK; p++) {
            const double move = fabs(x[p] * g->cells - g->origin[d] - w->x[d][p]);
            const double half = sim->half * fabs(F[p]);
            e->move[p] = move > e->move[p] ? move : e->move[p];
            e->half[p] = half > e->half[p] ? half : e->half[p];
            e->bad[p] += !(x[p] >= lo && x[p] <= hi);
        }
    }
    for (int p = 0; p < CHUNK; p++) {
        Mat F;
        for (int k = 0; k < NMAT; k++) F[k] = c->F[k][p];
        e->bad[p] += !(determinant(F) > 0);
    }
}

static inline __attribute__((always_inline)) void gather_line(const Grid *g, Work *w, int width, const int table)
{
    if (width == 2)
        gather(g, w, 2, table);
    else if (width == 3)
        gather(g, w, 3, table);
    else
        gather(g, w, width, table);
}

static void gather_moments(const Sim *sim, Work *w, int width)
{
    make_moments(w, width);
    gather_line(&sim->g, w, width, T_R);
    unpack_sums(w, LANES, sim->dx);
    spread(sim, w, width);
}

static void gather_chunk(Sim *sim, int k, double dt, unsigned take, Work *w, Extremes *e)
{
    const Method *method = &sim->method;
    const Chunk c = sim_chunk(sim, k);
    const int width = make_stencils(sim, &c, w);
    gather_line(&sim->g, w, width, T_G);
    unpack_sums(w, 0, sim->g.cells);
    if (method->moments) gather_moments(sim, w, width);
    method->update(&c, (const Field *)w->sums, dt, take);
    if (take & (TAKE_X | TAKE_F | MOVE_STASH)) inspect_chunk(sim, &c, w, e);
}

/* Gathers everywhere; keeps the extremes of the run's state. Returns whether anything went wrong. */
static bool gather_all(Sim *sim, double dt, unsigned take)
{
    double move = 0, half = 0, bad = 0;
    const int chunks = sim->p.n / CHUNK;
#pragma omp parallel num_threads(sim->setup->threads) reduction(max : move, half, bad)
    {
        Work w;
        Extremes e = {0};
#pragma omp for schedule(static)
        for (int k = 0; k < chunks; k++) gather_chunk(sim, k, dt, take, &w, &e);
        for (int p = 0; p < CHUNK; p++) {
            move = fmax(move, e.move[p]);
            half = fmax(half, e.half[p]);
            bad = fmax(bad, e.bad[p]);
        }
    }
    sim->travel += move;
    if (take & TAKE_F) sim->half_now = fmin(half, sim->half_max);
    return bad > 0;
}

/* Internal force on the real particles' nodes, before symmetry adds the mirrored ones. */
static void book_forces(Sim *sim, double dt)
{
    Grid *g = &sim->g;
    for (int row = 0; row < g->rows; row++)
        for (int i = g->lo[row]; i < g->hi[row]; i++) {
            const Line n = g->node[(size_t)row * (size_t)g->n[0] + (size_t)i];
            for (int l = FLUX; l < LANES; l++) g->impulse[row][(l - FLUX) % DIM] -= dt * n[l];
        }
}

static unsigned row_hold(const Grid *g, int row)
{
    unsigned held = 0;
    for (int d = 1; d < DIM; d++) {
        held |= g->hold[d][row % g->n[d]];
        row /= g->n[d];
    }
    return held;
}

/* One node: v = p/m, a = f/m times `scale`, walls, v += a dt; then what a gather reads. Books the
 * impulse m a dt (less the internal force, which must sum to nothing). */
static inline void solve_node(Sim *sim, size_t at, unsigned held, double dt, double scale,
                              double impulse[DIM])
{
    Grid *g = &sim->g;
    const Line in = g->node[at];
    const double inverse = 1 / in[0];
    Line out = {0};
    for (int a = 0; a < DIM; a++) {
        double f = 0;
        for (int b = 0; b < DIM; b++) f += in[FLUX + b * DIM + a];
        if (!sim->g.nmirror) impulse[a] -= dt * scale * f;
        if (g->force) f += g->force[at * DIM + (size_t)a];
        const bool hold = held >> a & 1;
        const double acc = hold ? 0 : f * inverse * scale;
        const double v = hold ? 0 : in[1 + a] * inverse + acc * dt;
        impulse[a] += dt * in[1 + DIM] * acc;
        out[a] = v;
        out[DIM + a] = acc;
        for (int b = 0; b < DIM; b++) out[FLUX + b * DIM + a] = v;
    }
    g->node[at] = out;
}

/* A node without mass has no motion; what pulls at it is the wall's if one holds it, else it is lost. */
static inline void clear_node(Sim *sim, size_t at, unsigned held, double dt, double impulse[DIM])
{
    const Line in = sim->g.node[at];
    for (int l = FLUX; l < LANES && !sim->g.nmirror; l++)
        if (held >> (l - FLUX) % DIM & 1) impulse[(l - FLUX) % DIM] -= dt * in[l];
    sim->g.node[at] = (Line){0};
}

/* Nodes that are nobody's are set to zero; ghosts of a symmetry line are left to it. */
static void solve_row(Sim *sim, int row, double dt, double scale)
{
    Grid *g = &sim->g;
    const size_t start = (size_t)row * (size_t)g->n[0];
    const unsigned held = row_hold(g, row);
    int lo = g->lo[row], hi = g->hi[row], live = 0;
    for (int k = 0; k < g->nmirror; k++) {
        const Mirror *m = &g->mirror[k];
        if (m->axis == 0 && m->side < 0 && lo < m->at) lo = m->at;
        if (m->axis == 0 && m->side > 0 && hi > m->at + 1) hi = m->at + 1;
    }
    for (int i = lo; i < hi; i++) {
        const size_t at = start + (size_t)i;
        const double mass = g->node[at][0];
        const bool empty = mass <= sim->mass_cut; /* false for NaN, which must spread */
        if (g->mass) g->mass[at] = empty ? 0 : mass;
        live += !empty;
        if (empty)
            clear_node(sim, at, held | g->hold[0][i], dt * scale, g->impulse[row]);
        else
            solve_node(sim, at, held | g->hold[0][i], dt, scale, g->impulse[row]);
    }
    g->live[row] = live;
}

static void solve_all(Sim *sim, double dt, double scale, bool force)
{
    Grid *g = &sim->g;
    for (int row = 0; row < g->rows; row++)
        for (int a = 0; a < DIM; a++) g->impulse[row][a] = 0;
    if (g->nmirror) {
        if (force) book_forces(sim, dt * scale);
        grid_fold(sim);
    }
    if (sim->method.repair) sim->method.repair(sim, force);
#pragma omp parallel for schedule(static) num_threads(sim->setup->threads)
    for (int row = 0; row < g->rows; row++)
        if (g->lo[row] < g->hi[row] && !grid_is_ghost_row(g, row, 0)) solve_row(sim, row, dt, scale);
    if (g->nmirror) grid_unfold(sim, dt);
    long live = 0;
    for (int row = 0; row < g->rows; row++) {
        if (g->lo[row] < g->hi[row]) live += g->live[row];
        for (int a = 0; a < DIM; a++) sim->impulse[a] += g->impulse[row][a];
    }
    if (live > sim->nodes) sim->nodes = live;
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

/* Stencils stay within the live spans while nobody drifted a cell or outgrew the planned width. */
static void sort_if_due(Sim *sim)
{
    if (sim->travel > 1 || sim->half_now > sim->half_plan) sim_sort(sim);
}

Status sim_step(Sim *sim, double t, double dt, bool first)
{
    const Setup *s = sim->setup;
    const double scale = first && integrators[s->integrator].half_first ? 0.5 : 1;
    sort_if_due(sim);
    for (int k = 0; k < 2 && integrators[s->integrator].pass[k].used; k++) {
        const Pass *pass = &integrators[s->integrator].pass[k];
        deposit_all(sim, t, pass->force);
        solve_all(sim, dt, scale, pass->force);
        if (gather_all(sim, dt, pass->take | (s->refresh ? pass->fresh : 0))) {
            const Status status = sim_check(sim);
            if (status.code != OK) return status;
        }
        if (sim->half_now > sim->half_plan && k == 0 && integrators[s->integrator].pass[1].used)
            sim_sort(sim);
    }
    return (Status){OK, -1, 0};
}

Status sim_project(Sim *sim)
{
    sort_if_due(sim);
    deposit_all(sim, 0, false);
    solve_all(sim, 0, 1, false);
    return (Status){OK, -1, 0};
}
