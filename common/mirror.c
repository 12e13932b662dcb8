/* mirror.c: symmetry lines by folding nodes: as if the mirrored particles were there.
 * With ghost i' the image of node i: a deposit of the mirrored body at i is the parity times the
 * real deposit at i'; on the line itself it is the parity times its own. */
#include <limits.h>
#include "sim.h"

/* -1 in lanes whose component is normal to the axis, +1 else; 0 in the spare lanes, which keep the
 * real particles' own mass. */
static Line deposit_parity(int axis)
{
    Line parity;
    for (int l = 0; l < LANES; l++) parity[l] = l == 0 ? 1 : 0;
    for (int a = 0; a < DIM; a++) {
        parity[1 + a] = a == axis ? -1 : 1;
        for (int b = 0; b < DIM; b++) parity[FLUX + b * DIM + a] = a == axis ? -1 : 1;
    }
    return parity;
}

static Line gather_parity(int axis)
{
    Line parity;
    for (int l = 0; l < LANES; l++) parity[l] = l % DIM == axis ? -1 : 1;
    for (int a = 0; a < DIM; a++)
        for (int b = 0; b < DIM; b++) parity[FLUX + b * DIM + a] = a == axis ? -1 : 1;
    return parity;
}

typedef void Visit(Sim *sim, const Mirror *m, size_t ghost, size_t image, int image_row, double dt);

static void fold_node(Sim *sim, const Mirror *m, size_t ghost, size_t image, int image_row,
                      double dt)
{
    Grid *g = &sim->g;
    (void)image_row, (void)dt;
    g->node[image] += deposit_parity(m->axis) * g->node[ghost];
    for (int a = 0; g->force && a < DIM; a++)
        g->force[image * DIM + (size_t)a] +=
            (a == m->axis ? -1 : 1) * g->force[ghost * DIM + (size_t)a];
}

static void unfold_node(Sim *sim, const Mirror *m, size_t ghost, size_t image, int image_row,
                        double dt)
{
    Grid *g = &sim->g;
    if (ghost == image) return;
    const double mass = g->node[ghost][1 + DIM];
    g->node[ghost] = gather_parity(m->axis) * g->node[image];
    const int given = sim->method.pic ? 0 : DIM; /* v, or a */
    for (int a = 0; a < DIM; a++) g->impulse[image_row][a] += dt * mass * g->node[ghost][given + a];
    if (g->mass) g->mass[ghost] = 0;
}

bool grid_is_ghost_row(const Grid *g, int row, int above)
{
    for (int k = 0; k < g->nmirror; k++) {
        const Mirror *m = &g->mirror[k];
        int stride = 1;
        for (int d = 1; d < m->axis; d++) stride *= g->n[d];
        if (DIM > 1 && m->axis > above && m->side * (row / stride % g->n[m->axis] - m->at) > 0)
            return true;
    }
    return false;
}

/* All pairs of live ghost and image nodes of one mirror line, the line's own nodes included. Rows
 * that are ghosts of a later axis are left out on the way back: that axis will fill them whole. */
static void visit_pairs(Sim *sim, const Mirror *m, Visit *visit, double dt)
{
    Grid *g = &sim->g;
    int stride = 1; /* of rows along the axis */
    for (int d = 1; d < m->axis; d++) stride *= g->n[d];
    for (int row = 0; row < g->rows; row++) {
        if (visit == unfold_node && grid_is_ghost_row(g, row, m->axis)) continue;
        if (DIM == 1 || m->axis == 0) {
            const int from = m->side < 0 ? g->lo[row] : m->at;
            const int to = m->side < 0 ? m->at + 1 : g->hi[row];
            for (int i = from; i < to && g->hi[row] > g->lo[row]; i++)
                visit(sim, m, (size_t)row * (size_t)g->n[0] + (size_t)i,
                      (size_t)row * (size_t)g->n[0] + (size_t)(2 * m->at - i), row, dt);
            continue;
        }
        const int k = row / stride % g->n[m->axis];
        if (m->side * (k - m->at) < 0 || g->lo[row] >= g->hi[row]) continue;
        const int image = row + 2 * (m->at - k) * stride;
        for (int i = g->lo[row]; i < g->hi[row]; i++)
            visit(sim, m, (size_t)row * (size_t)g->n[0] + (size_t)i,
                  (size_t)image * (size_t)g->n[0] + (size_t)i, image, dt);
    }
}

void grid_fold(Sim *sim)
{
    for (int k = 0; k < sim->g.nmirror; k++) visit_pairs(sim, &sim->g.mirror[k], fold_node, 0);
}

void grid_unfold(Sim *sim, double dt)
{
    for (int k = 0; k < sim->g.nmirror; k++) visit_pairs(sim, &sim->g.mirror[k], unfold_node, dt);
}

/* The image of every live ghost is live. */
static void mirror_spans(Grid *g, const Mirror *m)
{
    int stride = 1;
    for (int d = 1; d < m->axis; d++) stride *= g->n[d];
    for (int row = 0; row < g->rows; row++) {
        if (g->lo[row] >= g->hi[row]) continue;
        if (DIM == 1 || m->axis == 0) {
            if (m->side < 0 && g->lo[row] < m->at && g->hi[row] <= 2 * m->at - g->lo[row])
                g->hi[row] = 2 * m->at - g->lo[row] + 1;
            if (m->side > 0 && g->hi[row] > m->at && g->lo[row] > 2 * m->at - g->hi[row] + 1)
                g->lo[row] = 2 * m->at - g->hi[row] + 1;
            continue;
        }
        const int k = row / stride % g->n[m->axis];
        if (m->side * (k - m->at) <= 0) continue;
        const int image = row + 2 * (m->at - k) * stride;
        if (g->lo[row] < g->lo[image]) g->lo[image] = g->lo[row];
        if (g->hi[row] > g->hi[image]) g->hi[image] = g->hi[row];
    }
}

void grid_mirror_spans(Grid *g)
{
    for (int k = 0; k < g->nmirror; k++) mirror_spans(g, &g->mirror[k]);
}
