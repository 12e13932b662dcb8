/* spread.c: average=folded: forces of spurious nodes go to their good neighbours. See wls.h.
 *
 * A spurious node s moves with its good neighbours, so its own force f_s has no effect. But only
 * the f_i of all nodes together sum to zero; without f_s a body at rest whose surface carries
 * stress would start to move. The part of f_s that the motion of s does not use, r_s = f_s - m_s
 * a_s,  a_s = 2 a_j - a_k (k beyond j), the mass-weighted mean over good j, is added to the f of
 * its good neighbours in proportion to their mass. Then the sum of m a is that of f for every
 * uniform a. A node that a wall holds keeps its force, which acts on the wall; the share of r_s for
 * a held component of a good neighbour does so, too, and is added to the impulse. */
#include "wls.h"
#include "common/core/each.h"

/* Does the node pass its force on: is it spurious, with mass, and held by no wall? (Symmetry lines
 * do not count.) */
static bool gives(const Sim *sim, size_t at, const int index[DIM])
{
    const Grid *g = &sim->g;
    unsigned held = wls_of(sim)->stops[at];
    for (int d = 0; d < DIM; d++) held |= g->hold[d][index[d]];
    return !wls_of(sim)->good[at] && g->node[at][0] > sim->mass_cut && !held;
}

/* Sums over the sound neighbours j of a node: m_j; m_j a_j; over those with a sound node k beyond,
 * m_j and m_j (2 a_j - a_k). */
typedef struct Sums {
    double mass, pairs, mean[DIM], line[DIM];
} Sums;

static Sums sum_around(const Sim *sim, const int index[DIM])
{
    const Wls *w = sim->own;
    Sums out = {0};
    for (int k = 0; k < NEIGHBOURS; k++) {
        int next[DIM], beyond[DIM];
        double sign[DIM], sign2[DIM];
        wls_neighbour(index, k, next);
        for (int d = 0; d < DIM; d++) beyond[d] = 2 * next[d] - index[d];
        const size_t j = mirror_image(&sim->g, next, sign),
                     l = mirror_image(&sim->g, beyond, sign2);
        if (j == NOWHERE || !wls_is_sound(sim, j)) continue;
        const bool pair = l != NOWHERE && wls_is_sound(sim, l);
        const double mass = sim->g.node[j][0];
        out.mass += mass;
        out.pairs += pair ? mass : 0;
        for (int a = 0; a < DIM; a++) {
            const double near = sign[a] * w->inertia[j].factor[I_A + a];
            out.mean[a] += mass * near;
            if (pair) out.line[a] += mass * (2 * near - sign2[a] * w->inertia[l].factor[I_A + a]);
        }
    }
    return out;
}

/* r_s over the mass of its good neighbours: the acceleration that each of them gets. */
static void give_row(Sim *sim, int row, const void *unused)
{
    const Grid *g = &sim->g;
    (void)unused;
    for (int i = g->lo[row]; i < g->hi[row]; i++) {
        const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
        Inertia *own = &wls_of(sim)->inertia[at];
        int index[DIM];
        if (wls_of(sim)->good[at]) continue;
        wls_index_of(g, row, i, index);
        if (!gives(sim, at, index)) continue;
        const Sums s = sum_around(sim, index);
        for (int a = 0; a < DIM && s.mass > 0; a++) {
            const double along = s.pairs > 0 ? s.line[a] / s.pairs : s.mean[a] / s.mass;
            own->product[I_A + a] = (wls_whole_force(g, at, a) - g->node[at][0] * along) / s.mass;
        }
    }
}

/* Adds a share of one spurious node's force, given as an acceleration, to node `at`. On a symmetry
 * line the mirrored half of the body adds the opposite normal share; the line bears that of the
 * real half. */
static void take(Sim *sim, int row, size_t at, int a, double sign, double share, unsigned held,
                 double dt)
{
    if (held >> a & 1)
        sim->g.impulse[row][a] -= dt * sim->g.node[at][1 + DIM] * share;
    else
        wls_of(sim)->inertia[at].factor[I_A + a] += sign * share;
}

static void take_row(Sim *sim, int row, const void *own)
{
    const double dt = *(const double *)own;
    const Grid *g = &sim->g;
    Wls *w = wls_of(sim);
    for (int i = g->lo[row]; i < g->hi[row]; i++) {
        const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
        int index[DIM], next[DIM];
        double sign[DIM];
        if (!wls_is_sound(sim, at) || wls_all_good(sim, row, i)) continue;
        const unsigned held = wls_held(g, row, i) | w->stops[at];
        wls_index_of(g, row, i, index);
        for (int k = 0; k < NEIGHBOURS; k++) {
            wls_neighbour(index, k, next);
            const size_t s = mirror_image(g, next, sign);
            for (int a = 0; a < DIM && s != NOWHERE && !w->good[s]; a++)
                take(sim, row, at, a, sign[a], w->inertia[s].product[I_A + a], held, dt);
        }
    }
}

static void clear_row(Sim *sim, int row, const void *unused)
{
    const Grid *g = &sim->g;
    (void)unused;
    const size_t start = (size_t)row * (size_t)g->n[0];
    for (size_t at = start + (size_t)g->lo[row]; at < start + (size_t)g->hi[row]; at++)
        wls_of(sim)->inertia[at].product = (Half){0};
}

void wls_spread(Sim *sim, double dt)
{
    each_row(sim, give_row, NULL);
    each_row(sim, take_row, &dt);
    each_row(sim, clear_row, NULL);
}
