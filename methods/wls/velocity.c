/* velocity.c: corrects node velocities for what fit and return filter. See wls.h.
 *
 * Of a wave of wave number k [1/cell] the fit (eqs 7-10, weight W) finds 1 - k^2/8, and the return
 * through W gives 1 - k^2/8 of what the nodes have; so particles would move with 1 - k^2/4 of their
 * own velocity. The consistent mass matrix M over its row sums D has 1 - k^2/6. Hence
 *   v_i' = v_i - 3/2 D_i^-1 sum_j M_ij (v_j - v_i - c_i . (x_j - x_i)),  3/2 = (1/4)/(1/6),
 * moves them with 1 + O(k^4). The node's own plane c_i is subtracted, so that velocities linear in
 * space are not changed, in cut cells either. Applied at good nodes without spurious neighbours,
 * since the factors above are those of a fit with particles on all sides. Spurious nodes then take
 * the planes of good neighbours (wls/nodes.c); components that a wall holds are not changed.
 *
 * Only real cells are summed. On a symmetry line the mirrored half would double M v and D alike and
 * cancel the first moment across the line; there c_i of components that are not held has no slope
 * across it, so the result is the same. */
#include "wls.h"

void wls_velocity_start(Sim *sim, size_t at, int row, int i, unsigned held)
{
    Wls *w = wls_of(sim);
    int index[DIM];
    double v[DIM];
    for (int a = 0; a < DIM; a++) v[a] = w->fit[at][FIT_VALUE][Q_V + a];
    if (!w->good[at] && sim->g.node[at][0] > 0) { /* without mass it has no part in M */
        wls_index_of(&sim->g, row, i, index);
        wls_velocity_at(sim, index, v);
    }
    for (int a = 0; a < DIM; a++)
        w->inertia[at].factor[I_V + a] = held >> a & 1 ? wls_drive(&sim->g, row, i, a) : v[a];
}

/* Are all neighbours of a node good, those beyond a wall left out? */
static bool is_surrounded(const Sim *sim, int row, int i)
{
    const Grid *g = &sim->g;
    int index[DIM];
    wls_index_of(g, row, i, index);
    for (int k = 0; k < NEIGHBOURS; k++) {
        int next[DIM];
        double sign[DIM];
        bool beyond = false;
        wls_neighbour(index, k, next);
        for (int d = 0; d < DIM; d++) {
            beyond |= next[d] != index[d] && g->hold[d][index[d]] && next[d] >= 0 &&
                      next[d] < g->n[d] && g->hold[d][next[d]];
        }
        const size_t at = mirror_image(g, next, sign);
        if (!beyond && (at == NOWHERE || !wls_of(sim)->good[at])) return false;
    }
    return true;
}

void wls_velocity_finish(Sim *sim, size_t at, int row, int i, unsigned held)
{
    Wls *w = wls_of(sim);
    const Inertia *in = &w->inertia[at];
    if (!wls_all_good(sim, row, i) && !is_surrounded(sim, row, i)) return;
    for (int a = 0; a < DIM; a++) {
        double plane = in->row[I_SUM] * in->factor[I_V + a];
        for (int d = 0; d < DIM; d++)
            plane += in->row[I_FIRST + d] * w->fit[at][FIT_SLOPE + d][Q_V + a];
        if (!(held >> a & 1))
            w->fit[at][FIT_VALUE][Q_V + a] -= 1.5 * (in->product[I_V + a] - plane) / in->row[I_SUM];
    }
}
