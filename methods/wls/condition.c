/* condition.c: which nodes are spurious (W11 3.5): by the trigger weight, or by the two tests that
 * the paper finds too weak if used alone, the determinant of the moments or the number of
 * particles. See wls.h. */
#include <math.h>
#include "wls.h"

static void count_chunk(Sim *sim, int k)
{
    const Grid *g = &sim->g;
    Wls *w = wls_of(sim);
    const Chunk c = sim_chunk(sim, k);
    for (int p = 0; p < CHUNK; p++) {
        int middle[DIM];
        if (c.id[p] < 0) continue;
        for (int d = 0; d < DIM; d++)
            middle[d] = (int)floor(c.x[d][p] * g->cells - g->origin[d] + 0.5);
        for (int q = 0; q < NEIGHBOURS; q++) {
            int index[DIM];
            size_t at = 0;
            wls_neighbour(middle, q, index);
            for (int d = DIM - 1; d >= 0; d--) at = at * (size_t)g->n[d] + (size_t)index[d];
            w->count[at]++;
        }
    }
}

static void fold_count(Sim *sim, const Mirror *m, size_t ghost, size_t image, int image_row,
                       void *own)
{
    (void)m, (void)image_row, (void)own;
    wls_of(sim)->count[image] += wls_of(sim)->count[ghost];
}

void wls_count(Sim *sim)
{
    const Grid *g = &sim->g;
    Wls *w = wls_of(sim);
    for (int row = 0; row < g->rows; row++)
        for (int i = g->lo[row]; i < g->hi[row]; i++)
            w->count[(size_t)row * (size_t)g->n[0] + (size_t)i] = 0;
    for (int b = 0; b < sim->nblock; b++)
        for (int k = sim->block[b].first; k < sim->block[b].last; k++) count_chunk(sim, k);
    if (g->nmirror) mirror_visit_pairs(sim, false, fold_count, NULL);
}

bool wls_solve_node(Wls *w, size_t at)
{
    const double least = w->condition == CONDITION_COUNT ? 0 : 1e-10;
    const bool near = w->condition == CONDITION_COUNT    ? w->count[at] > DIM
                      : w->condition == CONDITION_WEIGHT ? w->most[at] > w->trigger
                                                         : true;
    const bool whole = wls_solve(w->fit[at], near, w->hermite, least);
    w->good[at] = w->condition == CONDITION_WEIGHT ? near : whole;
    return whole;
}
