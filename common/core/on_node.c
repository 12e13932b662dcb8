/* on_node.c: the slope of a tent for a particle that lies on a node (passes.h).
 *
 * There the slope jumps. Of the cell above the node it is (v+ - v0)/h, of the cell below
 * (v0 - v-)/h; either is a gradient, exact for linear fields. The far node of such a cell has
 * weight S = 0 but slope G = 1/h. If no other particle gives it mass it has no velocity: read as 0
 * it would make L = -v0/h of a body that merely drifts, and the force given to it would be lost,
 * and with it the momentum of the pair.
 *
 * The rule: nodes 0, + and - count if they have mass.
 *
 *   both + and -    G = (-1, 0, 1)/2h, the mean of the two cells, as of a vanishing GIMP box
 *   one of them     the cell that has it
 *   neither         G = 0: the particle gives no force along this axis and gets no strain from it
 *
 * In every case sum_i G_i = 0 and, but in the last, sum_i G_i (x_i - x_p) = 1, over nodes that have
 * mass. The first makes L = 0 of a uniform velocity and sum_i f_i = -T sum_i G_i = 0: no momentum
 * is made; the second makes L exact for linear fields (a turning body) and a symmetric T give no
 * torque. Deposit and gather take the same G, so that the work of the forces is that of the stress.
 * A mirrored body has the mirrored G: the mean is taken, never the cell above.
 *
 * In 2D and 3D the rule holds on every line of nodes along the axis: those of the particle's cell
 * across it, with the weights S_k of the other axes. Lines without a slope leave their share to
 * those that have one: G = sum_k S_k G_k / sum_k S_k over the latter. Lines that the particle does
 * not reach (it lies on a node of the other axis, too) do not count.
 *
 * "On" a node is within ON_NODE cells, since round-off decides on which side a particle lies; a
 * node "has mass" if that exceeds ON_NODE times a particle's: a smaller one is of particles on
 * other nodes, and its acceleration would be of order 1/ON_NODE. Across a symmetry line a ghost has
 * mass if its image has. */
#include "passes.h"
#include "scheme.h"
#include "each.h"

/* Is particle p on a node of this axis? (S is f and 1 - f.) */
static bool lies_on_node(const Stencil *s, int p)
{
    return s->table[T_S][0][p] * s->table[T_S][1][p] < ON_NODE;
}

void on_node_clear_slopes(Stencil *s)
{
    for (int p = 0; p < CHUNK; p++)
        if (lies_on_node(s, p)) s->table[T_G][0][p] = s->table[T_G][1][p] = 0;
}

static void mark_row(Sim *sim, int row, const void *unused)
{
    Grid *g = &sim->g;
    (void)unused;
    for (int i = g->lo[row]; i < g->hi[row]; i++) {
        const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
        g->body[at] = g->node[at][0] > sim->mass_body;
    }
}

static void fold_mark(Sim *sim, const Mirror *m, size_t ghost, size_t image, int row, void *own)
{
    (void)m, (void)row, (void)own;
    sim->g.body[image] |= sim->g.body[ghost];
}

static void unfold_mark(Sim *sim, const Mirror *m, size_t ghost, size_t image, int row, void *own)
{
    (void)m, (void)row, (void)own;
    sim->g.body[ghost] = sim->g.body[image];
}

void on_node_mark_body(Sim *sim)
{
    each_row(sim, mark_row, NULL);
    mirror_visit_pairs(sim, false, fold_mark, NULL);
    mirror_visit_pairs(sim, true, unfold_mark, NULL);
}

/* The nodes along one axis on which a particle's slope stands: three per line. */
enum { LINES = 1 << (DIM - 1) };
typedef struct Slopes {
    int lines;
    size_t at[LINES][3];
    double G[LINES][3]; /* [1/cell] */
} Slopes;

/* One line, of weight S, about its node `mid`. Returns the weight, or 0 if it has no slope. */
static double add_line(const Grid *g, size_t mid, size_t stride, double S, Slopes *out)
{
    const bool below = g->body[mid - stride], above = g->body[mid + stride];
    if (S < ON_NODE || !g->body[mid] || !(below || above)) return 0;
    const double share = below && above ? 0.5 * S : S;
    const int l = out->lines++;
    for (int k = 0; k < 3; k++) out->at[l][k] = mid + (size_t)k * stride - stride;
    out->G[l][0] = below ? -share : 0;
    out->G[l][2] = above ? share : 0;
    out->G[l][1] = -out->G[l][0] - out->G[l][2];
    return S;
}

/* The rule for particle p and axis d. */
static Slopes find_slopes(const Grid *g, const Stencil s[DIM], int p, int d)
{
    Slopes out = {0};
    size_t stride[DIM], first = 0;
    double total = 0;
    for (int e = 0; e < DIM; e++) {
        stride[e] = e == 0 ? 1 : stride[e - 1] * (size_t)g->n[e - 1];
        first += stride[e] * (size_t)s[e].base[p];
    }
    if (s[d].table[T_S][1][p] > 0.5) first += stride[d]; /* from just below the node */
    for (int k = 0; k < LINES; k++) {
        size_t mid = first;
        double S = 1;
        for (int e = 0, rest = k; e < DIM; e++) {
            if (e == d) continue;
            mid += (size_t)(rest & 1) * stride[e];
            S *= s[e].table[T_S][rest & 1][p];
            rest >>= 1;
        }
        total += add_line(g, mid, stride[d], S, &out);
    }
    for (int l = 0; l < out.lines; l++)
        for (int k = 0; k < 3; k++) out.G[l][k] /= total;
    return out;
}

void on_node_deposit(Sim *sim, const Work *w)
{
    Grid *g = &sim->g;
    for (int p = 0; p < CHUNK; p++)
        for (int d = 0; d < DIM; d++) {
            if (!w->stencil[d].on_node || !lies_on_node(&w->stencil[d], p)) continue;
            const Slopes s = find_slopes(g, w->stencil, p, d);
            for (int l = 0; l < s.lines; l++)
                for (int k = 0; k < 3; k++)
                    for (int a = 0; a < DIM; a++)
                        g->node[s.at[l][k]][FLUX + d * DIM + a] +=
                            s.G[l][k] * w->A[p][FLUX + d * DIM + a];
        }
}

void on_node_gather(const Sim *sim, Work *w)
{
    const Grid *g = &sim->g;
    for (int p = 0; p < CHUNK; p++)
        for (int d = 0; d < DIM; d++) {
            if (!w->stencil[d].on_node || !lies_on_node(&w->stencil[d], p)) continue;
            const Slopes s = find_slopes(g, w->stencil, p, d);
            for (int l = 0; l < s.lines; l++)
                for (int k = 0; k < 3; k++)
                    for (int a = 0; a < DIM; a++)
                        w->A[p][FLUX + d * DIM + a] +=
                            s.G[l][k] * g->node[s.at[l][k]][FLUX + d * DIM + a];
        }
}
