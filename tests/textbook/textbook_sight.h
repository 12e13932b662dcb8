/* textbook_sight.h: the nodes that a particle of the textbook code reaches, their weights and
 * gradients. W07 eq 2.1; Bardenhagen & Kober 2004; W11 eq 4. */
#ifndef MPMLAB_TEXTBOOK_SIGHT_H
#define MPMLAB_TEXTBOOK_SIGHT_H

#include <math.h>
#include "textbook.h"
#include "textbook_corners.h"

enum { REACH = 16 }; /* most nodes that a particle may see along one axis */

/* The nodes that a particle sees along one axis. */
typedef struct Sight {
    int first, count;
    bool kink; /* a tent's particle on its node, the middle one of three: node_of has the slope */
    double S[REACH], G[REACH]; /* [-] [1/m] */
    Corners corners;           /* in the first axis' place, if weights are theirs */
} Sight;

/* The part of [-b, b] in which 1 + side (r + s) is the tent of a node at distance r: s from lo to
 * hi. */
static inline void clip(double r, double b, int side, double *lo, double *hi)
{
    const double from = side > 0 ? -1 - r : -r, to = side > 0 ? -r : 1 - r;
    *lo = from > -b ? from : -b;
    *hi = to < b ? to : b;
}

/* Mean over [-b, b] of the tent and of its slope: each flank is a trapezium, midpoint times base.
 */
static inline void gimp_weight(double r, double b, double *S, double *G)
{
    *S = *G = 0;
    for (int side = -1; side <= 1; side += 2) {
        double lo, hi;
        clip(r, b, side, &lo, &hi);
        if (!(hi > lo)) continue;
        *S += (hi - lo) / (2 * b) * (1 + side * (r + 0.5 * (lo + hi)));
        *G += side * (hi - lo) / (2 * b);
    }
}

/* The tent's cell [first, first + 1], in which x need not lie. */
static inline void tent(int first, double x, double cells, Sight *s)
{
    s->first = first;
    s->count = 2;
    s->S[0] = 1 - (x - first), s->S[1] = x - first;
    s->G[0] = -cells, s->G[1] = cells;
}

/* The tent from a node: no slope of its own. */
static inline void tent_on_node(double x, Sight *s)
{
    const double r = x - round(x);
    s->first = (int)lround(x) - 1;
    s->count = 3;
    s->kink = true;
    s->S[0] = fmax(-r, 0), s->S[1] = 1 - fabs(r), s->S[2] = fmax(r, 0);
    for (int k = 0; k < 3; k++) s->G[k] = 0;
}

/* Quadratic B-spline, W11 eq 4. Folded at a wall it is the tent of the last cell, from the wall's
 * half cell on (Steffen, Kirby & Berzins 2008). */
static inline void spline(const Twin *w, int axis, double x, double cells, Sight *s)
{
    const double nearest = floor(x + 0.5);
    if (nearest <= w->wall_lo[axis]) {
        tent((int)w->wall_lo[axis], x, cells, s);
        return;
    }
    if (nearest >= w->wall_hi[axis]) {
        tent((int)w->wall_hi[axis] - 1, x, cells, s);
        return;
    }
    s->first = (int)nearest - 1;
    s->count = 3;
    for (int k = 0; k < 3; k++) {
        const double r = x - (s->first + k), tail = 1.5 - fabs(r);
        s->S[k] = fabs(r) < 0.5 ? 0.75 - r * r : 0.5 * tail * tail;
        s->G[k] = fabs(r) < 0.5 ? -2 * r * cells : (r > 0 ? -tail : tail) * cells;
    }
}

/* Cubic B-spline in the two pieces of its books. The node beyond a wall extrapolates from the two
 * within. */
static inline void cubic(const Twin *w, int axis, double x, double cells, Sight *s)
{
    const double lo = w->wall_lo[axis], hi = w->wall_hi[axis];
    const int cell = (int)fmax(fmin(floor(x), hi - 1), lo);
    s->first = cell - 1;
    s->count = 4;
    for (int k = 0; k < 4; k++) {
        const double r = x - (s->first + k), q = fabs(r), tail = 2 - q;
        s->S[k] = q < 1 ? 0.5 * q * q * q - q * q + 2 / 3.0 : tail * tail * tail / 6;
        s->G[k] = (q < 1 ? (1.5 * q - 2) * q : -0.5 * tail * tail) * (r > 0 ? cells : -cells);
    }
    for (int side = 0; side < 2; side++) {
        const int out = side ? 3 : 0, wall = side ? 2 : 1, in = side ? 1 : 2;
        if (side ? cell + 2 <= hi : cell - 1 >= lo) continue;
        s->S[wall] += 2 * s->S[out], s->S[in] -= s->S[out], s->S[out] = 0;
        s->G[wall] += 2 * s->G[out], s->G[in] -= s->G[out], s->G[out] = 0;
    }
}

/* x in cells from node 0, b = l/h. */
static inline void look(const Twin *w, int axis, double x, double b, Sight *s)
{
    const double cells = w->setup->cells;
    *s = (Sight){0};
    if (w->method.shape == TWIN_TENT && fabs(x - round(x)) < ON_NODE) {
        tent_on_node(x, s);
        return;
    }
    if (w->method.shape == TWIN_TENT) {
        tent((int)floor(x), x, cells, s);
        return;
    }
    if (w->method.shape == TWIN_SPLINE) {
        spline(w, axis, x, cells, s);
        return;
    }
    if (w->method.shape == TWIN_CUBIC) {
        cubic(w, axis, x, cells, s);
        return;
    }
    s->first = (int)floor(x - 1 - b) + 1;
    s->count = (int)ceil(x + 1 + b) - s->first;
    for (int k = 0; k < s->count && k < REACH; k++) {
        gimp_weight(x - (s->first + k), b, &s->S[k], &s->G[k]);
        s->G[k] *= cells;
    }
}

/* Is its grid the reference one? Then a particle stands where it was placed, undeformed. */
static inline bool is_total(const Twin *w)
{
    return w->setup->frame == FRAME_TOTAL;
}

static inline double place(const Twin *w, const TwinParticle *p, int d)
{
    return is_total(w) ? p->X[d] : p->x[d];
}

/* Slopes of moving least squares: S (x_i - x) over 1/4 cell^2 of the quadratic spline, 1/3 of the
 * cubic one (Hu et al. 2018), over its sum where a wall folds it; a tent has its own. */
static inline void fit_slopes(const Twin *w, double x, Sight *s)
{
    const bool cubic = w->method.shape == TWIN_CUBIC;
    double D = 0;
    for (int k = 0; k < s->count; k++) D += s->S[k] * pow(s->first + k - x, 2);
    if (s->count == 2 || D < 1e-9) return;
    if (!cubic) D = 0.25;
    if (cubic && fabs(D - 1 / 3.0) < 1e-9) D = 1 / 3.0;
    for (int k = 0; k < s->count; k++) s->G[k] = s->S[k] * (s->first + k - x) / D * w->setup->cells;
}

static inline bool has_corners(const Twin *w)
{
    return w->method.shape == TWIN_CPDI || w->method.shape == TWIN_CPDI2;
}

/* The nodes about all corners. */
static inline void look_at_corners(const Twin *w, const TwinParticle *p, Sight s[3])
{
    static const double I[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const double cells = w->setup->cells;
    double F[DIM][DIM], corner[TWIN_CORNERS][DIM], x[DIM];
    Corners *q = &s[0].corners;
    for (int d = 0; d < DIM; d++) x[d] = place(w, p, d);
    for (int a = 0; a < DIM; a++)
        for (int b = 0; b < DIM; b++) F[a][b] = is_total(w) ? I[a][b] : p->F[a][b];
    *q = (Corners){0};
    if (p->more)
        memcpy(corner, p->more->corner, sizeof corner);
    else
        place_corners(x, (const double(*)[DIM])F, w->half * w->h, corner);
    for (int d = 0; d < DIM; d++) {
        double lo = INFINITY, hi = -INFINITY;
        for (int c = 0; c < TWIN_CORNERS; c++) {
            const double y = corner[c][d] * cells;
            q->y[c][d] = y, lo = fmin(lo, y), hi = fmax(hi, y);
        }
        s[d].first = (int)floor(lo);
        s[d].count = (int)floor(hi) + 2 - s[d].first;
    }
    integrate(q, cells);
}

/* l = l0 |F_dd|, never quite zero. Axes that the dimension lacks have one node of weight 1. */
static inline void look_around(const Twin *w, const TwinParticle *p, Sight s[3])
{
    for (int d = 0; d < DIM; d++) {
        const double stretch = is_total(w) ? 1 : fmax(fabs(p->F[d][d]), 1e-6);
        const double x = place(w, p, d) * w->setup->cells;
        look(w, d, x, w->half * stretch, &s[d]);
        if (w->method.fitted) fit_slopes(w, x, &s[d]);
    }
    if (has_corners(w)) look_at_corners(w, p, s);
    for (int d = DIM; d < 3; d++) {
        s[d].first = 0, s[d].count = 1, s[d].kink = false;
        s[d].S[0] = 1;
    }
}

/* D_p = sum_i S (x_i - x_p)^2 along an axis [m^2]: all of the tensor, since weights are products
 * that reproduce positions. */
static inline double spread(const Twin *w, const TwinParticle *p, const Sight s[3], int axis)
{
    double D = 0;
    for (int k = 0; k < s[axis].count; k++)
        D += s[axis].S[k] * pow(w->h * (s[axis].first + k) - place(w, p, axis), 2);
    return D;
}

/* Node i of a particle's nodes; NULL beyond the grid. */
static inline TwinNode *node_at(const Twin *w, const Sight s[3], const int i[3])
{
    long at = 0;
    for (int d = DIM - 1; d >= 0; d--) {
        const int index = s[d].first + i[d] - w->origin[d];
        if (index < 0 || index >= w->size[d]) return NULL;
        at = at * w->size[d] + index;
    }
    return &w->node[at];
}

/* Has the node of line `line` at place k = 0, 1, 2 along axis d mass of the body's? */
static inline bool has_body(const Twin *w, const Sight s[3], const int line[3], int d, int k)
{
    int i[3] = {line[0], line[1], line[2]};
    i[d] = k;
    const TwinNode *node = node_at(w, s, i);
    return node && node->weight > ON_NODE * w->p[0].m;
}

/* Slope at node i of a particle on a node of axis d [1/m] (common/core/on_node.c): on each line
 * along d the difference of two neighbours if both have mass, else of the one that has and the
 * middle; the lines' mean, weighted with the other axes' S. */
static inline double kink_slope(const Twin *w, const Sight s[3], const int i[3], int d)
{
    const int e = (d + 1) % 3, f = (d + 2) % 3;
    double sum = 0, total = 0;
    int line[3] = {0};
    for (line[e] = 0; line[e] < s[e].count; line[e]++)
        for (line[f] = 0; line[f] < s[f].count; line[f]++) {
            const double S = s[e].S[line[e]] * s[f].S[line[f]];
            const bool below = has_body(w, s, line, d, 0), above = has_body(w, s, line, d, 2);
            if (S < ON_NODE || !has_body(w, s, line, d, 1) || !(below || above)) continue;
            const double cells = below && above ? 0.5 : 1;
            const double G[3] = {below ? -cells : 0, below - above, above ? cells : 0};
            total += S;
            if (line[e] == i[e] && line[f] == i[f]) sum += S * G[i[d]];
        }
    return total > 0 ? sum / total / w->h : 0;
}

/* S and G at the node at x. */
static inline void add_corners(const Corners *q, const double x[DIM], double h, double *S,
                               double G[DIM])
{
    double node[DIM];
    *S = 0;
    for (int d = 0; d < DIM; d++) G[d] = 0, node[d] = round(x[d] / h);
    for (int c = 0; c < TWIN_CORNERS; c++) {
        const double N = corner_tent(q->y[c], node);
        *S += q->w[c] * N;
        for (int d = 0; d < DIM; d++) G[d] += q->g[c][d] * N;
    }
}

/* Node i of a particle's nodes, with its weight, gradient and position; NULL beyond the grid. */
static inline TwinNode *node_of(const Twin *w, const Sight s[3], const int i[3], double *S,
                                double G[DIM], double x[DIM])
{
    for (int d = 0; d < DIM; d++) x[d] = w->h * (s[d].first + i[d]);
    if (has_corners(w)) {
        add_corners(&s[0].corners, x, w->h, S, G);
        return node_at(w, s, i);
    }
    *S = s[0].S[i[0]] * s[1].S[i[1]] * s[2].S[i[2]];
    for (int d = 0; d < DIM; d++) {
        const int e = (d + 1) % 3, f = (d + 2) % 3;
        G[d] = s[d].kink ? kink_slope(w, s, i, d) : s[d].G[i[d]] * s[e].S[i[e]] * s[f].S[i[f]];
    }
    return node_at(w, s, i);
}

/* The loops over the nodes that a particle sees, i[0] fastest. */
#define FOR_NODES(s, i)                                                                            \
    for (int i[3] = {0}; i[2] < (s)[2].count; i[2]++)                                              \
        for (i[1] = 0; i[1] < (s)[1].count; i[1]++)                                                \
            for (i[0] = 0; i[0] < (s)[0].count; i[0]++)

#endif
