/* mirror.c: symmetry lines by folding nodes: as if the mirrored particles were there.
 * With ghost i' the image of node i: a deposit of the mirrored body at i is the parity times the
 * real deposit at i'; on the line itself it is the parity times its own. */
#include <limits.h>
#include <math.h>
#include <string.h>
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

static void fold_node(Sim *sim, const Mirror *m, size_t ghost, size_t image, int image_row,
                      void *own)
{
    Grid *g = &sim->g;
    (void)image_row, (void)own;
    g->node[image] += deposit_parity(m->axis) * g->node[ghost];
    for (int a = 0; g->force && a < DIM; a++)
        g->force[image * DIM + (size_t)a] +=
            (a == m->axis ? -1 : 1) * g->force[ghost * DIM + (size_t)a];
}

static void unfold_node(Sim *sim, const Mirror *m, size_t ghost, size_t image, int image_row,
                        void *own)
{
    Grid *g = &sim->g;
    const Given *given = own;
    if (ghost == image) return;
    const double mass = g->node[ghost][1 + DIM];
    g->node[ghost] = gather_parity(m->axis) * g->node[image];
    for (int a = 0; a < DIM; a++) {
        g->impulse[image_row][a] += given->a_share * mass * g->node[ghost][DIM + a];
        g->impulse[image_row][a] += given->v_share * mass * g->node[ghost][a];
    }
    if (g->mass) g->mass[ghost] = 0;
}

bool mirror_is_ghost_row(const Grid *g, int row, int above)
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
static void visit_pairs(Sim *sim, const Mirror *m, bool back, PairVisit *visit, void *own)
{
    Grid *g = &sim->g;
    int stride = 1; /* of rows along the axis */
    for (int d = 1; d < m->axis; d++) stride *= g->n[d];
    for (int row = 0; row < g->rows; row++) {
        if (back && mirror_is_ghost_row(g, row, m->axis)) continue;
        if (DIM == 1 || m->axis == 0) {
            const int from = m->side < 0 ? g->lo[row] : m->at;
            const int to = m->side < 0 ? m->at + 1 : g->hi[row];
            for (int i = from; i < to && g->hi[row] > g->lo[row]; i++)
                visit(sim, m, (size_t)row * (size_t)g->n[0] + (size_t)i,
                      (size_t)row * (size_t)g->n[0] + (size_t)(2 * m->at - i), row, own);
            continue;
        }
        const int k = row / stride % g->n[m->axis];
        if (m->side * (k - m->at) < 0 || g->lo[row] >= g->hi[row]) continue;
        const int image = row + 2 * (m->at - k) * stride;
        for (int i = g->lo[row]; i < g->hi[row]; i++)
            visit(sim, m, (size_t)row * (size_t)g->n[0] + (size_t)i,
                  (size_t)image * (size_t)g->n[0] + (size_t)i, image, own);
    }
}

void mirror_visit_pairs(Sim *sim, bool back, PairVisit *visit, void *own)
{
    for (int k = 0; k < sim->g.nmirror; k++) visit_pairs(sim, &sim->g.mirror[k], back, visit, own);
}

void mirror_fold(Sim *sim)
{
    mirror_visit_pairs(sim, false, fold_node, NULL);
}

void mirror_unfold(Sim *sim, Given given)
{
    mirror_visit_pairs(sim, true, unfold_node, &given);
}

size_t mirror_image(const Grid *g, const int index[DIM], double sign[DIM])
{
    int own[DIM];
    for (int d = 0; d < DIM; d++) own[d] = index[d], sign[d] = 1;
    for (int k = 0; k < g->nmirror; k++) {
        const Mirror *m = &g->mirror[k];
        if (m->side * (own[m->axis] - m->at) <= 0) continue;
        own[m->axis] = 2 * m->at - own[m->axis];
        sign[m->axis] = -1;
    }
    int row = 0;
    for (int d = DIM - 1; d > 0; d--) {
        if (own[d] < 0 || own[d] >= g->n[d]) return NOWHERE;
        row = row * g->n[d] + own[d];
    }
    if (own[0] < g->lo[row] || own[0] >= g->hi[row]) return NOWHERE;
    return (size_t)row * (size_t)g->n[0] + (size_t)own[0];
}

bool mirror_has_node(const Grid *g, int axis, int i, int row)
{
    int index = i;
    for (int d = 1; d < DIM && d <= axis; d++) index = row % g->n[d], row /= g->n[d];
    for (int k = 0; k < g->nmirror; k++)
        if (g->mirror[k].axis == axis && g->mirror[k].at == index) return true;
    return false;
}

/* The image of every live ghost is live. */
static void reach_images(Grid *g, const Mirror *m)
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

void mirror_spans(Grid *g)
{
    for (int k = 0; k < g->nmirror; k++) reach_images(g, &g->mirror[k]);
}

/* Velocity and acceleration of node `at` from its image across a wall that holds components `held`.
 */
static void reflect(Grid *g, size_t at, size_t image, unsigned held)
{
    for (int l = 0; l < LANES; l++) {
        const int a = l < FLUX ? l % DIM : (l - FLUX) % DIM;
        g->node[at][l] = (held >> a & 1 ? -1 : 1) * g->node[image][l];
    }
}

/* Two lines of nodes beyond the wall at index `at`, towards `side`. */
static void wall_images(Grid *g, int axis, int at, int side)
{
    for (int row = 0; row < g->rows; row++)
        for (int k = 1; k <= 2; k++) {
            int index[DIM], image[DIM], rest = row;
            double sign[DIM];
            for (int d = 1; d < DIM; d++) index[d] = image[d] = rest % g->n[d], rest /= g->n[d];
            if (axis > 0 && index[axis % DIM] != at + side * k) continue;
            if (axis > 0) image[axis % DIM] = at - side * k;
            const int from = axis > 0 ? g->lo[row] : at + side * k;
            const int to = axis > 0 ? g->hi[row] : at + side * k + 1;
            for (index[0] = from; index[0] < to && g->lo[row] < g->hi[row]; index[0]++) {
                image[0] = axis > 0 ? index[0] : at - side * k;
                const size_t ghost = mirror_image(g, index, sign),
                             own = mirror_image(g, image, sign);
                if (ghost != NOWHERE && own != NOWHERE) reflect(g, ghost, own, g->hold[axis][at]);
            }
        }
}

void mirror_wall_images(Sim *sim)
{
    Grid *g = &sim->g;
    for (int d = 0; d < DIM; d++) {
        if (isfinite(g->axis[d].wall_lo)) wall_images(g, d, (int)g->axis[d].wall_lo, -1);
        if (isfinite(g->axis[d].wall_hi)) wall_images(g, d, (int)g->axis[d].wall_hi, 1);
    }
}

static void hold_beyond(Grid *g, const Wall *w, double at)
{
    for (int i = 0; i < g->n[w->axis]; i++) {
        if (w->side * (i - at) < 0) continue;
        g->hold[w->axis][i] |= (unsigned char)w->hold;
        if (g->drive[w->axis]) g->drive[w->axis][i] = w->speed;
    }
}

/* Index at which the nodes begin that a wall holds; in the total frame walls stay with the
 * reference positions. Round-off puts no node on the other side of a wall that starts on it. */
static double wall_index(const Sim *sim, const Wall *w, double t)
{
    const Grid *g = &sim->g;
    const double x = w->at + (sim->total ? 0 : w->speed * t);
    return fabs(w->speed) > 0 ? x * g->cells - g->origin[w->axis] + w->side * -1e-9
                              : (double)(lround(w->at * g->cells) - g->origin[w->axis]);
}

void mirror_move_walls(Sim *sim, double t)
{
    Grid *g = &sim->g;
    const Scene *scene = sim->setup->scene;
    for (int d = 0; d < DIM && g->drive[0]; d++) {
        memset(g->hold[d], 0, (size_t)g->n[d]);
        memset(g->drive[d], 0, sizeof(double) * (size_t)g->n[d]);
        for (const Wall *w = scene->wall; w < scene->wall + scene->nwall; w++)
            if (w->axis == d && !w->mirror && !w->unilateral)
                hold_beyond(g, w, wall_index(sim, w, t));
    }
}

void mirror_set_walls(Sim *sim)
{
    Grid *g = &sim->g;
    const Scene *scene = sim->setup->scene;
    for (int d = 0; d < DIM; d++) {
        g->axis[d] = (Axis){.wall_lo = -INFINITY, .wall_hi = INFINITY};
        for (int k = 0; k < scene->nwall; k++) {
            const Wall *w = &scene->wall[k];
            const int at = (int)lround(w->at * g->cells) - g->origin[d];
            if (w->axis != d || fabs(w->speed) > 0) continue;
            if (!w->mirror) {
                *(w->side < 0 ? &g->axis[d].wall_lo : &g->axis[d].wall_hi) = at;
                *(w->side < 0 ? &g->axis[d].open_lo : &g->axis[d].open_hi) = !(w->hold >> d & 1);
            }
            if (w->mirror) g->mirror[g->nmirror++] = (Mirror){d, at, w->side};
            if (w->unilateral && !w->mirror) g->stop[g->nstop++] = (Stop){d, at, w->side, w->hold};
            if (!w->mirror && !w->unilateral) hold_beyond(g, w, at);
        }
    }
    mirror_move_walls(sim, 0);
}
