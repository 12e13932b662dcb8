/* surface.c: how far every node lies inside the body (W11 3.3), from sums over surface points:
 *   eq 14           rough: beta_i above the threshold is inside, one cell from the surface
 *   eqs 15-17       distance to the mean of nearby surface points, sign by the gradient of beta
 *   normals         d_i = sum S (x_p - x_i) . n_p / sum S, second order: points carry their normals
 *   curved          the same on a circle through them
 *   exact           where the scene knows it. */
#include <math.h>
#include "wls.h"

/* A node this near the surface [cells] lies inside: a body that ends on a wall of the grid fills
 * its last cells, corners included, whatever round-off says. */
static const double ON_SURFACE = 1e-9;

/* Current outward normal F^-T N of surface point p, of unit length. */
static void push_normal(const Chunk *c, int p, double n[DIM])
{
    double length = 0;
    Mat F;
    for (int k = 0; k < NMAT; k++) F[k] = c->F[k][p];
    for (int a = 0; a < DIM; a++) {
        n[a] = 0;
        for (int b = 0; b < DIM; b++) n[a] += cofactor(F, a, b) * c->normal[b][p];
        length += n[a] * n[a];
    }
    for (int a = 0; a < DIM && length > 0; a++) n[a] /= sqrt(length);
}

Line *wls_skin_of(Wls *w, size_t at)
{
    if (!w->skinned[at]) w->skin[at][0] = w->skin[at][1] = (Line){0};
    w->skinned[at] = true;
    return w->skin[at];
}

/* Adds a surface point of weight S and normal n, `away` from a node, to the node's sums. */
static inline void add_to_skin(double S, const double away[DIM], const double n[DIM], Line skin[2])
{
    double *first = (double *)&skin[0], *second = (double *)&skin[1];
    int k = K_RR;
    first[K_ONE] += S;
    for (int d = 0; d < DIM; d++) {
        const double r = S * away[d];
        first[K_FIRST + d] += r;
        first[K_NORMAL + d] += S * n[d];
        first[K_ALONG] += r * n[d];
        for (int e = d; e < DIM; e++) second[k++] += r * away[e]; /* pair(d, e) */
        for (int e = 0; e < DIM; e++) second[K_RN + d * DIM + e] += r * n[e];
    }
}

void wls_skin_point(Sim *sim, const Chunk *c, int p)
{
    const Grid *g = &sim->g;
    double n[DIM], away[2][DIM], S[2][DIM];
    int base[DIM];
    push_normal(c, p, n);
    for (int d = 0; d < DIM; d++) {
        const double x = c->x[d][p] * g->cells - g->origin[d], low = floor(x);
        base[d] = (int)low;
        for (int far = 0; far < 2; far++) {
            away[far][d] = x - (low + far);
            S[far][d] = 1 - fabs(away[far][d]);
        }
    }
    for (int k = 0; k < CORNERS; k++) {
        double weight = 1, r[DIM];
        size_t at = 0;
        for (int d = DIM - 1; d >= 0; d--) {
            at = at * (size_t)g->n[d] + (size_t)(base[d] + (k >> d & 1));
            r[d] = away[k >> d & 1][d];
            weight *= S[k >> d & 1][d];
        }
        add_to_skin(weight, r, n, wls_skin_of(wls_of(sim), at));
    }
}

/* n = sum_i G_i(x) beta_i, eq 16, at x [cells from node 0]; nodes beyond the live ones have none.
 */
static void beta_gradient(const Sim *sim, const double x[DIM], double n[DIM])
{
    const Wls *w = sim->own;
    int base[DIM];
    for (int d = 0; d < DIM; d++) base[d] = (int)floor(x[d]), n[d] = 0;
    for (int k = 0; k < CORNERS; k++) {
        int index[DIM];
        double sign[DIM];
        for (int d = 0; d < DIM; d++) index[d] = base[d] + (k >> d & 1);
        const size_t at = mirror_image(&sim->g, index, sign);
        if (at == NOWHERE) continue;
        for (int d = 0; d < DIM; d++) {
            double G = w->fit[at][FIT_MOMENTS][M_BETA];
            for (int e = 0; e < DIM; e++) {
                const double f = x[e] - base[e], far = k >> e & 1;
                G *= e == d ? 2 * far - 1 : far > 0 ? f : 1 - f;
            }
            n[d] += G;
        }
    }
}

/* Eqs 15-17. */
static double mean_distance(const Sim *sim, const int index[DIM], const Line skin)
{
    double x[DIM], away[DIM], n[DIM], square = 0, dot = 0;
    for (int d = 0; d < DIM; d++) {
        away[d] = skin[K_FIRST + d] / skin[K_ONE];
        x[d] = index[d] + away[d];
        square += away[d] * away[d];
    }
    beta_gradient(sim, x, n);
    for (int d = 0; d < DIM; d++) dot += away[d] * n[d];
    return dot < 0 ? sqrt(square) : -sqrt(square);
}

static double distance_by_points(const Sim *sim, const int index[DIM], size_t at)
{
    const Wls *w = sim->own;
    const Line *skin = w->skin[at];
    if (w->bend) return wls_curved_distance(skin, &w->bend[at]);
    return w->distance_by == DISTANCE_NORMALS ? skin[0][K_ALONG] / skin[0][K_ONE]
                                              : mean_distance(sim, index, skin[0]);
}

void wls_distances(Sim *sim, int row, double t)
{
    Wls *w = wls_of(sim);
    const Grid *g = &sim->g;
    int index[DIM], rest = row;
    for (int d = 1; d < DIM; d++) index[d] = rest % g->n[d], rest /= g->n[d];
    for (index[0] = g->lo[row]; index[0] < g->hi[row]; index[0]++) {
        const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)index[0];
        if (w->bend) w->bend[at] = (Bend){{0}, {0}};
        double d = w->fit[at][FIT_MOMENTS][M_BETA] > w->inside ? 1 : -1;
        if (w->distance_by == DISTANCE_EXACT)
            d = sim_distance(sim, index, t);
        else if (w->skinned[at] && w->skin[at][0][K_ONE] > 0)
            d = distance_by_points(sim, index, at);
        w->distance[at] = fabs(d) < ON_SURFACE ? ON_SURFACE : d;
    }
}

bool wls_normal(const Sim *sim, size_t node, double n[DIM])
{
    const Wls *w = sim->own;
    const Line *skin = w->skin[node];
    double square = 0;
    if (!w->skinned[node] || !(skin[0][K_ONE] > 0)) return false;
    for (int d = 0; d < DIM; d++) square += skin[0][K_NORMAL + d] * skin[0][K_NORMAL + d];
    const double length = sqrt(square);
    if (!(length > 0.5 * skin[0][K_ONE])) return false; /* an edge, or two surfaces */
    for (int d = 0; d < DIM; d++) n[d] = skin[0][K_NORMAL + d] / length;
    return true;
}
