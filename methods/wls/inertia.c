/* inertia.c: accelerations nearer to those of the consistent mass matrix M than the row sums D
 * give: one step of M a = f from a0 = D^-1 f,
 *   a = a0 + D^-1 (f - M a0) = 2 a0 - D^-1 M a0,
 * at good nodes; spurious and massless ones take the mean of theirs (wls/nodes.c). See wls.h.
 *
 * Particle velocities are updated with a. With motion=lagged particles move with v + dt a0: the fit
 * of the next step returns a filtered by the weights, which equals a0 to fourth order. Moving
 * particles with v + dt a now would differ from it by dt h^2/4 grad^2 a, and energy would be lost
 * in proportion to dt. Spurious nodes move particles with v + dt (2 a_j - a_k), extrapolated
 * linearly from good nodes, k beyond j. With velocity=corrected (wls/velocity.c) the next fit finds
 * v + dt a, and nothing is held back.
 *
 * Real cells alone are summed: on a symmetry line the mirrored half doubles M a0 and D alike. */
#include "wls.h"
#include "common/core/each.h"

unsigned wls_held(const Grid *g, int row, int i)
{
    int index[DIM];
    unsigned held = 0;
    wls_index_of(g, row, i, index);
    for (int d = 0; d < DIM; d++) held |= g->hold[d][index[d]];
    for (int k = 0; k < g->nmirror; k++)
        if (index[g->mirror[k].axis] == g->mirror[k].at) held |= 1u << g->mirror[k].axis;
    return held;
}

double wls_drive(const Grid *g, int row, int i, int a)
{
    int index[DIM];
    wls_index_of(g, row, i, index);
    return g->drive[a] ? g->drive[a][index[a]] : 0;
}

void wls_record_change(Sim *sim, int row, size_t at, double dt, const Line before, unsigned held)
{
    const Line node = sim->g.node[at];
    const double real = node[0] > 0 ? node[1 + DIM] / node[0] : 0; /* a half on symmetry lines */
    for (int a = 0; a < DIM; a++)
        if (!(held >> a & 1))
            sim->g.impulse[row][a] -= dt * real * (node[FLUX + a] - before[FLUX + a]);
}

double wls_whole_force(const Grid *g, size_t at, int a)
{
    double f = g->force ? g->force[at * DIM + (size_t)a] : 0;
    for (int b = 0; b < DIM; b++) f += g->node[at][FLUX + b * DIM + a];
    return f;
}

/* The factors a0, v of a row, with boundary conditions. Whether a unilateral wall stops a component
 * is decided by momentum and force before any correction; a stopped component has a0 = -v/dt. */
static void start_row(Sim *sim, int row, const void *own)
{
    const double dt = *(const double *)own;
    const Grid *g = &sim->g;
    Wls *w = wls_of(sim);
    for (int i = g->lo[row]; i < g->hi[row]; i++) {
        const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
        const unsigned held = wls_held(g, row, i);
        const double mass = g->node[at][0];
        const Line v = w->fit[at][FIT_VALUE];
        for (int a = 0; a < DIM; a++) g->node[at][1 + a] = mass * v[Q_V + a];
        const unsigned stops = g->nstop ? sim_stops(g, row, i, dt) & ~held : 0;
        w->stops[at] = (unsigned char)stops;
        w->inertia[at] = (Inertia){{0}, {0}, {0}};
        for (int a = 0; a < DIM && w->corrected && mass > sim->mass_cut; a++)
            if (!(held >> a & 1))
                w->inertia[at].factor[I_A + a] =
                    stops >> a & 1 ? -v[Q_V + a] / dt : wls_whole_force(g, at, a) / mass;
        if (w->sharpened) wls_velocity_start(sim, at, row, i, held | stops);
    }
}

/* Writes v to the nodes' planes and a, as internal force, to the nodes, from which the equations of
 * motion read it; and updates the momentum ledger. Over all nodes the changes cancel: sum_i (D a0 -
 * M a0)_i = 0, since D are the row sums of M. A component that a wall holds or stops has a given a0
 * and is not changed; its share (D a0 - M a0)_i of that sum is borne by the wall, whose impulse is
 * that of the integrated force plus dt (M a0 - D a0)_i. */
static void finish_row(Sim *sim, int row, const void *own)
{
    const double dt = *(const double *)own;
    Grid *g = &sim->g;
    Wls *w = wls_of(sim);
    for (int i = g->lo[row]; i < g->hi[row]; i++) {
        const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
        const Inertia in = w->inertia[at];
        const Line before = g->node[at];
        if (!(in.row[I_SUM] > 0)) continue;
        const unsigned stops = w->stops[at], held = wls_held(g, row, i) | stops;
        for (int a = 0; a < DIM; a++) {
            const double borne = in.product[I_A + a] - in.row[I_SUM] * in.factor[I_A + a];
            if (!(held >> a & 1)) continue;
            g->impulse[row][a] += dt * borne;
            if (g->work) g->work[row] += dt * borne * wls_drive(g, row, i, a);
        }
        if (!wls_is_sound(sim, at)) continue;
        if (w->sharpened) wls_velocity_finish(sim, at, row, i, held);
        for (int a = 0; a < DIM && w->corrected; a++) {
            const double acc = held >> a & 1
                                   ? in.factor[I_A + a]
                                   : 2 * in.factor[I_A + a] - in.product[I_A + a] / in.row[I_SUM];
            const double outer = g->force ? g->force[at * DIM + (size_t)a] : 0;
            if (!(stops >> a & 1)) g->node[at][FLUX + a] = g->node[at][0] * acc - outer;
            w->inertia[at].product[I_A + a] = acc;
        }
        wls_record_change(sim, row, at, dt, before, held);
    }
}

void wls_correct(Sim *sim, double dt)
{
    each_row(sim, start_row, &dt);
    if (wls_of(sim)->folded) wls_spread(sim, dt);
    wls_mass_times(sim);
    each_row(sim, finish_row, &dt);
}

/* a of a spurious node from pairs of good ones with mass, weights m_j; false: there are none. */
static bool extrapolated(const Sim *sim, const int index[DIM], double acc[DIM])
{
    const Wls *w = sim->own;
    const Grid *g = &sim->g;
    double total = 0;
    for (int a = 0; a < DIM; a++) acc[a] = 0;
    for (int k = 0; k < NEIGHBOURS; k++) {
        int next[DIM], beyond[DIM];
        double sign[DIM], sign2[DIM];
        wls_neighbour(index, k, next);
        for (int d = 0; d < DIM; d++) beyond[d] = 2 * next[d] - index[d];
        if (k == NEIGHBOURS / 2) continue;
        const size_t j = mirror_image(g, next, sign), at = mirror_image(g, beyond, sign2);
        if (j == NOWHERE || at == NOWHERE || !wls_is_sound(sim, j) || !wls_is_sound(sim, at))
            continue;
        const double mass = g->node[j][0];
        total += mass;
        for (int a = 0; a < DIM; a++)
            acc[a] += mass * (2 * sign[a] * w->inertia[j].product[I_A + a] -
                              sign2[a] * w->inertia[at].product[I_A + a]);
    }
    for (int a = 0; a < DIM && total > 0; a++) acc[a] /= total;
    return total > 0;
}

void wls_hold_back(const Sim *sim, size_t at, const int index[DIM], double dt, double v[DIM])
{
    const Wls *w = sim->own;
    const Inertia *in = &w->inertia[at];
    const double mass = sim->g.node[at][0];
    double acc[DIM];
    if (w->good[at])
        for (int a = 0; a < DIM && in->row[I_SUM] > 0; a++)
            v[a] += dt * (in->factor[I_A + a] - in->product[I_A + a]);
    else if (extrapolated(sim, index, acc))
        for (int a = 0; a < DIM; a++)
            v[a] += dt * (acc[a] - wls_whole_force(&sim->g, at, a) / mass);
}
