/* centres.c: IMPM (Sulsky & Gong 2016) with the fits of this room: velocities from planes fitted at
 * nodes, stresses from planes fitted at the middle of cells, where one point integrates the
 * internal force. See wls.h and methods/impm.c.
 *
 * How full a cell is: the sum of its particles' volumes, weighted with the tent about its middle,
 * over (7/8)^DIM of a cell, which is that sum for a full cell at a corner of a body; at most 1. (If
 * a cell counted as full as soon as a particle enters it, it would push nodes that have hardly any
 * mass.) */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "wls.h"
#include "common/core/each.h"

typedef struct Centres {
    Wls node, cell;
    double *share; /* [nodes] of the cell above a node: how full it is */
} Centres;

bool wls_make_centres(Sim *sim)
{
    const size_t n = (size_t)sim->g.rows * (size_t)sim->g.n[0] + 1;
    Centres *c = sim->own = calloc(1, sizeof *c);
    if (!c) return false;
    c->node.trigger = c->cell.trigger = sim->setup->method_par[0];
    c->cell.centres = true;
    c->share = calloc(n, sizeof *c->share);
    if (!c->share || !wls_alloc(sim, &c->node) || !wls_alloc(sim, &c->cell)) return false;
    /* particles near the surface add to cells above nodes that are not live; these sums are not
     * read */
    memset(c->cell.fit, 0, n * sizeof *c->cell.fit);
    memset(c->cell.most, 0, n * sizeof *c->cell.most);
    return true;
}

void wls_free_centres(Sim *sim)
{
    Centres *c = sim->own;
    wls_release(&c->node);
    wls_release(&c->cell);
    free(c->share);
    free(c);
}

/* Is the cell above node i of a row part of the scene: neither a mirror image nor beyond a wall? */
static bool is_within(const Grid *g, int row, int i)
{
    int index[DIM];
    wls_index_of(g, row, i, index);
    for (int d = 0; d < DIM; d++) {
        const Axis *a = &g->axis[d];
        if ((!a->open_lo && index[d] < a->wall_lo) || (!a->open_hi && index[d] >= a->wall_hi) ||
            wls_mirrored_cell(g, d, index[d]))
            return false;
    }
    return true;
}

static void solve_cells(Sim *sim, int row, const void *unused)
{
    Centres *c = sim->own;
    (void)unused;
    const Grid *g = &sim->g;
    const double least = pow(7 / 8.0, DIM);
    for (int i = g->lo[row]; i < g->hi[row]; i++) {
        const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
        const double sum = c->cell.fit[at][FIT_MOMENTS][M_BETA];
        wls_solve_node(&c->cell, at);
        c->share[at] = is_within(g, row, i) ? fmin(sum / least, 1) : 0;
    }
}

/* Adds f_i = -V_c sigma_c G_ic of one cell to its corner k; each component of G_ic is +-2/(2^n h).
 */
static void add_cell(const Sim *sim, const Centres *c, size_t cell, int k, Line *node)
{
    const double V = c->share[cell] * 2 / (double)CORNERS * sim->g.cells * wls_cell_volume(sim);
    for (int b = 0; b < DIM; b++)
        for (int a = 0; a < DIM; a++)
            (*node)[FLUX + b * DIM + a] -=
                (k >> b & 1 ? V : -V) * c->cell.fit[cell][FIT_VALUE][Q_SIGMA + pair(a, b)];
}

/* Adds to each node of a row the forces of its cells, always in the same order. */
static void add_forces(Sim *sim, int row, const void *unused)
{
    const Centres *c = sim->own;
    Grid *g = &sim->g;
    (void)unused;
    for (int k = 0; k < CORNERS; k++) {
        int below = row, stride = 1;
        for (int d = 1; d < DIM; stride *= g->n[d++]) below -= (k >> d & 1) * stride;
        if (below < 0) continue;
        for (int i = g->lo[row]; i < g->hi[row]; i++) {
            const int first = i - (k & 1);
            const size_t cell = (size_t)below * (size_t)g->n[0] + (size_t)first;
            if (first >= g->lo[below] && first < g->hi[below] && c->share[cell] > 0)
                add_cell(sim, c, cell, k, &g->node[(size_t)row * (size_t)g->n[0] + (size_t)i]);
        }
    }
}

void wls_integrate_centres(Sim *sim)
{
    wls_deposit(sim, &((Centres *)sim->own)->cell, 0, true);
    each_row(sim, solve_cells, NULL);
    each_row(sim, add_forces, NULL);
}

/* Sets the momenta of a row to mass times the fitted velocity; spurious nodes take the mean, and
 * are counted. */
static void set_velocities(Sim *sim, int row, const void *unused)
{
    const Grid *g = &sim->g;
    Wls *w = &((Centres *)sim->own)->node;
    int index[DIM];
    (void)unused;
    if (mirror_is_ghost_row(g, row, 0)) return;
    w->fallbacks[row] = 0;
    wls_index_of(g, row, 0, index);
    for (index[0] = g->lo[row]; index[0] < g->hi[row]; index[0]++) {
        double sign[DIM];
        const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)index[0];
        Line *node = &g->node[at];
        if (!((*node)[0] > sim->mass_cut)) continue;
        if (g->nmirror && mirror_image(g, index, sign) != at) continue; /* a ghost */
        w->fallbacks[row] += !wls_solve_node(w, at);
        for (int a = 0; a < DIM; a++) (*node)[1 + a] = (*node)[0] * w->fit[at][FIT_VALUE][Q_V + a];
    }
}

void wls_repair_centres(Sim *sim, double dt)
{
    const Grid *g = &sim->g;
    Wls *w = &((Centres *)sim->own)->node;
    (void)dt;
    wls_deposit(sim, w, 0, false);
    each_row(sim, set_velocities, NULL);
    for (int row = 0; row < g->rows; row++)
        if (g->lo[row] < g->hi[row] && !mirror_is_ghost_row(g, row, 0))
            sim->fallbacks += w->fallbacks[row];
}
