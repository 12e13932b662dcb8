/* solve.c: the nodes' equations of motion (passes.h): W11 eqs 25, 26 with walls. */
#include "passes.h"

/* Is the internal force booked as it was deposited, before symmetry or a repair changes it? Its sum
 * over all nodes is nothing; a repair books what it adds at nodes that no wall holds (wls.h). */
static bool books_early(const Sim *sim)
{
    return sim->g.nmirror > 0 || sim->method.repair;
}

/* Internal force on the real particles' nodes, before symmetry adds the mirrored ones; and their
 * momentum, where the update will replace it. */
static void book_forces(Sim *sim, double dt)
{
    Grid *g = &sim->g;
    for (int row = 0; row < g->rows; row++)
        for (int i = g->lo[row]; i < g->hi[row]; i++) {
            const Line n = g->node[(size_t)row * (size_t)g->n[0] + (size_t)i];
            for (int l = FLUX; l < LANES; l++) g->impulse[row][(l - FLUX) % DIM] -= dt * n[l];
            for (int a = 0; sim->method.pic && a < DIM; a++) g->impulse[row][a] -= n[1 + a];
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

/* A wall holds while the free momentum p + f dt is directed into it; a body that would be pulled
 * back leaves. */
unsigned grid_stops(const Grid *g, int row, int i, double dt)
{
    const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
    const Line n = g->node[at];
    unsigned held = 0;
    for (int k = 0; k < g->nstop; k++) {
        const Stop *s = &g->stop[k];
        int index = i, rest = row;
        for (int d = 1; d < DIM && d <= s->axis; d++) {
            index = rest % g->n[d];
            rest /= g->n[d];
        }
        if (s->side * (index - s->at) < 0) continue;
        double f = g->force ? g->force[at * DIM + (size_t)s->axis] : 0;
        for (int b = 0; b < DIM; b++) f += n[FLUX + b * DIM + s->axis];
        if (s->side * (n[1 + s->axis] + f * dt) > 0) held |= s->hold;
    }
    return held;
}

/* One node: v = p/m, a = f/m times `scale`, walls, v += a dt; then what a gather reads. Held
 * components have v = a = 0; `stopped` ones of them the a that brings v to rest, so that particles
 * do not keep a velocity into a wall that is to let them go. Books the momentum that particles will
 * get, less what they bring and the internal force, which must sum to nothing: m a times `share` =
 * dt, or m v times 1 where the update replaces velocities. */
static inline void solve_node(Sim *sim, size_t at, unsigned held, unsigned stopped, double dt,
                              double scale, double share, double impulse[DIM])
{
    Grid *g = &sim->g;
    const bool pic = sim->method.pic;
    const Line in = g->node[at];
    const double inverse = 1 / in[0];
    Line out = {0};
    for (int a = 0; a < DIM; a++) {
        double f = 0;
        for (int b = 0; b < DIM; b++) f += in[FLUX + b * DIM + a];
        if (!books_early(sim)) impulse[a] -= dt * scale * f + (pic ? share * in[1 + a] : 0);
        if (g->force) f += g->force[at * DIM + (size_t)a];
        const bool hold = held >> a & 1;
        double acc = hold ? 0 : f * inverse * scale;
        if (stopped >> a & 1) acc = -in[1 + a] * inverse / dt;
        const double v = hold ? 0 : in[1 + a] * inverse + acc * dt;
        impulse[a] += share * in[1 + DIM] * (pic ? v : acc);
        out[a] = v;
        out[DIM + a] = acc;
        for (int b = 0; b < DIM; b++) out[FLUX + b * DIM + a] = v;
    }
    g->node[at] = out;
}

/* A node without mass has no motion; what pulls at it is the wall's if one holds it, else it is
 * lost. */
static inline void clear_node(Sim *sim, size_t at, unsigned held, double dt, double impulse[DIM])
{
    const Line in = sim->g.node[at];
    for (int l = FLUX; l < LANES && !books_early(sim); l++)
        if (held >> (l - FLUX) % DIM & 1) impulse[(l - FLUX) % DIM] -= dt * in[l];
    sim->g.node[at] = (Line){0};
}

/* Nodes that are nobody's are set to zero; ghosts of a symmetry line are left to it. */
static void solve_row(Sim *sim, int row, double dt, double scale, double share, bool force)
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
        const unsigned stops = g->nstop ? grid_stops(g, row, i, dt * scale) : 0;
        const unsigned own = held | g->hold[0][i] | stops;
        if (g->mass) g->mass[at] = empty ? 0 : mass;
        live += !empty;
        if (empty)
            clear_node(sim, at, own, dt * scale, g->impulse[row]);
        else
            solve_node(sim, at, own, force ? stops & ~(held | g->hold[0][i]) : 0, dt, scale, share,
                       g->impulse[row]);
    }
    g->live[row] = live;
}

void solve_all(Sim *sim, double dt, double scale, bool force)
{
    Grid *g = &sim->g;
    const double share = sim->method.pic ? force : dt;
    for (int row = 0; row < g->rows; row++)
        for (int a = 0; a < DIM; a++) g->impulse[row][a] = 0;
    if (books_early(sim) && force) book_forces(sim, dt * scale);
    if (g->nmirror) mirror_fold(sim);
    if (sim->method.repair) sim->method.repair(sim, dt * scale);
#pragma omp parallel for schedule(static) num_threads(sim->setup->threads)
    for (int row = 0; row < g->rows; row++)
        if (g->lo[row] < g->hi[row] && !mirror_is_ghost_row(g, row, 0))
            solve_row(sim, row, dt, scale, share, force);
    if (g->nmirror) mirror_unfold(sim, share);
    if (sim->method.wall_images) mirror_wall_images(sim);
    long live = 0;
    for (int row = 0; row < g->rows; row++) {
        if (g->lo[row] < g->hi[row]) live += g->live[row];
        for (int a = 0; a < DIM; a++) sim->impulse[a] += g->impulse[row][a];
    }
    sim->live = live;
    if (live > sim->nodes) sim->nodes = live;
}
