/* nodes.c: nodes whose own data are not usable (W11 3.5, 4.5): spurious nodes take force and
 * velocity from their good neighbours, and so do nodes that a particle's W reaches but that no cell
 * gave mass. Neighbours beyond a symmetry line are images. */
#include "wls.h"

/* Sums over the good neighbours of a node. */
typedef struct Around {
    double count, massive; /* good ones, and those of them with mass */
    double v[DIM];         /* of their functions, at the node */
    double mass;
    double inner[DIM], outer[DIM]; /* forces of the massive ones */
} Around;

static void add_neighbour(const Sim *sim, size_t at, const double sign[DIM], const double away[DIM],
                          Around *out)
{
    const Wls *w = sim->own;
    const Grid *g = &sim->g;
    out->count += 1;
    for (int a = 0; a < DIM; a++) {
        double v = w->fit[at][FIT_VALUE][Q_V + a];
        for (int d = 0; d < DIM; d++) v -= sign[d] * away[d] * w->fit[at][FIT_SLOPE + d][Q_V + a];
        out->v[a] += sign[a] * v;
    }
    if (!wls_is_sound(sim, at)) return;
    out->massive += 1;
    out->mass += g->node[at][0];
    for (int a = 0; a < DIM; a++) {
        out->inner[a] += sign[a] * g->node[at][FLUX + a];
        if (g->force) out->outer[a] += sign[a] * g->force[at * DIM + (size_t)a];
    }
}

static Around look_around(const Sim *sim, const int index[DIM])
{
    const Wls *w = sim->own;
    Around out = {0};
    for (int k = 0; k < NEIGHBOURS; k++) {
        int other[DIM];
        double sign[DIM], away[DIM];
        wls_neighbour(index, k, other);
        for (int d = 0; d < DIM; d++) away[d] = other[d] - index[d];
        const size_t at = k == NEIGHBOURS / 2 ? NOWHERE : mirror_image(&sim->g, other, sign);
        if (at != NOWHERE && w->good[at]) add_neighbour(sim, at, sign, away, &out);
    }
    return out;
}

/* f_i = m_i sum f_j / sum m_j. (The paper prints the mean of the f_j, which is unstable at once:
 * average=literal.) Body forces are included where accelerations are corrected, because otherwise
 * only those of good nodes would be; and under traction, whose force does not vanish with the
 * node's mass. */
static void average_force(const Sim *sim, size_t at, Line *node, const Around *n)
{
    const Wls *w = sim->own;
    const bool whole = sim->g.force && (w->corrected || sim->skin);
    const double *own = whole ? &sim->g.force[at * DIM] : NULL;
    for (int a = 0; a < DIM; a++) {
        const double inner =
            w->literal ? n->inner[a] / n->massive : (*node)[0] * n->inner[a] / n->mass;
        (*node)[FLUX + a] = inner + (own ? (*node)[0] * n->outer[a] / n->mass - own[a] : 0);
    }
}

/* Gives a node without mass a small one, so that it moves with a = sum f / sum m of its neighbours,
 * or keeps its own v if no neighbour has mass. (Where particles are sparse, eq 14 finds no inside
 * node.) */
static void move_along(Sim *sim, size_t at, Line *node, const Around *n)
{
    Grid *g = &sim->g;
    const double token = 1e3 * sim->mass_cut, share = n->massive > 0 ? token / n->mass : 0;
    (*node)[0] = token;
    for (int s = 1 + DIM; s < FLUX; s++) (*node)[s] = token;
    for (int a = 0; a < DIM; a++) {
        (*node)[FLUX + a] = share * (n->inner[a] + n->outer[a]);
        if (g->force) g->force[at * DIM + (size_t)a] = 0;
    }
}

bool wls_all_good(const Sim *sim, int row, int i)
{
    const Grid *g = &sim->g;
    for (int k = 0; k < NEIGHBOURS / 3; k++) {
        int next = row, stride = 1, rest = k;
        for (int d = 1; d < DIM; d++, rest /= 3) {
            next += (rest % 3 - 1) * stride;
            stride *= g->n[d];
        }
        if (next < 0 || next >= g->rows || i <= g->lo[next] || i + 1 >= g->hi[next]) return false;
        const unsigned char *good =
            wls_of(sim)->good + (size_t)next * (size_t)g->n[0] + (size_t)i - 1;
        if (!good[0] || !good[1] || !good[2]) return false;
    }
    return true;
}

void wls_velocity_at(const Sim *sim, const int index[DIM], double v[DIM])
{
    const Around n = look_around(sim, index);
    for (int a = 0; a < DIM && wls_of(sim)->extrapolate && n.count > 0; a++)
        v[a] = n.v[a] / n.count;
}

static void repair_node(Sim *sim, size_t at, int row, const int index[DIM], double dt)
{
    Wls *w = wls_of(sim);
    Line *node = &sim->g.node[at];
    const Line before = *node;
    const bool light = !((*node)[0] > sim->mass_cut), used = w->fit[at][FIT_MOMENTS][M_ONE] > 0;
    const bool repaired = light ? used : !w->good[at];
    double v[DIM];
    for (int a = 0; a < DIM; a++) v[a] = w->fit[at][FIT_VALUE][Q_V + a];
    if (repaired) {
        const Around n = look_around(sim, index);
        for (int a = 0; a < DIM && w->extrapolate && !w->good[at] && n.count > 0; a++)
            v[a] = n.v[a] / n.count;
        if (light && used && w->body) move_along(sim, at, node, &n);
        if (!light && n.massive > 0) average_force(sim, at, node, &n);
        w->fallbacks[row] += used && !(n.massive > 0);
    }
    if (w->lagged && (*node)[0] > sim->mass_cut) wls_hold_back(sim, at, index, dt, v);
    for (int a = 0; a < DIM; a++) (*node)[1 + a] = (*node)[0] * v[a];
    if (repaired) {
        /* a wall, be it one that holds or one that stops, bears the integrated force */
        const unsigned stops = sim_stops(&sim->g, row, index[0], dt);
        wls_record_change(sim, row, at, dt, before, wls_held(&sim->g, row, index[0]) | stops);
    }
}

void wls_repair_row(Sim *sim, int row, const void *own)
{
    const double dt = *(const double *)own;
    const Grid *g = &sim->g;
    int index[DIM], rest = row;
    if (mirror_is_ghost_row(g, row, 0)) return;
    for (int d = 1; d < DIM; d++) index[d] = rest % g->n[d], rest /= g->n[d];
    for (index[0] = g->lo[row]; index[0] < g->hi[row]; index[0]++) {
        double sign[DIM], ghost = 0;
        const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)index[0];
        for (int d = 0; d < DIM; d++) sign[d] = 1;
        if (g->nmirror) ghost = mirror_image(g, index, sign) != at;
        if (!(ghost > 0)) repair_node(sim, at, row, index, dt);
    }
}
