/* cells.c: integrals over cells, full and cut (W11 3.4, 4.4, eqs 19-24), written as
 *   m_i = sum_q S_iq rho_q V_q,  f_ext,i = sum_q S_iq f_q V_q,  f_int,i = -sum_q sigma_q G_iq V_q
 * (eq 24 lacks the sign and has sigma_i). The value at a point is the mean of the good nodes'
 * linear functions there, weights S. Full cells have one point. */
#include <string.h>
#include "wls.h"
#include "common/core/each.h"

static const double centre[3] = {0.5, 0.5, 0.5};

/* What is summed over the points of all cells. */
typedef enum { INTEGRATE, MULTIPLY } Task;

/* A point of a cell: weights of its corners there. */
typedef struct Shape {
    double S[CORNERS], G[CORNERS][DIM];
} Shape;

/* The middle of a full cell, and the rows of its corners in M; place: 1 and x of each corner. */
typedef struct Middle {
    Shape shape;
    Half row[CORNERS], place[CORNERS];
} Middle;

static inline void shape_at(const double xi[DIM], Shape *out)
{
    for (int k = 0; k < CORNERS; k++) {
        out->S[k] = 1;
        for (int d = 0; d < DIM; d++) out->G[k][d] = 1;
        for (int d = 0; d < DIM; d++) {
            const double s = k >> d & 1 ? xi[d] : 1 - xi[d];
            out->S[k] *= s;
            for (int b = 0; b < DIM; b++) out->G[k][b] *= b == d ? (k >> d & 1 ? 1 : -1) : s;
        }
    }
}

/* Eqs 19-21 at xi; false if no corner of the cell is good. */
static inline bool value_at(const Wls *w, const size_t corner[CORNERS], const double xi[DIM],
                            const Shape *shape, Line *out)
{
    Line sum = {0};
    double total = 0;
    for (int k = 0; k < CORNERS; k++) {
        const size_t at = corner[k];
        const double S = w->good[at] ? shape->S[k] : 0;
        if (!(S > 0)) continue;
        Line f = w->fit[at][FIT_VALUE];
        for (int d = 0; d < DIM && w->linear; d++)
            f += (xi[d] - (k >> d & 1)) * w->fit[at][FIT_SLOPE + d];
        sum += S * f;
        total += S;
    }
    if (total > 0) *out = total < 1 || total > 1 ? sum / total : sum;
    return total > 0;
}

/* Eqs 22-24 of one point of `volume` [cells]: every corner gets S m - sum_b G_b flux_b. */
static inline void add_point(Sim *sim, const size_t corner[CORNERS], const Shape *shape,
                             const Line value, double volume)
{
    Grid *g = &sim->g;
    const double V = volume * wls_cell_volume(sim);
    Line mass = {0}, flux[DIM] = {{0}};
    mass[0] = V * value[Q_RHO];
    for (int s = 1 + DIM; s < FLUX; s++) mass[s] = mass[0];
    for (int b = 0; b < DIM; b++)
        for (int a = 0; a < DIM; a++)
            flux[b][FLUX + a] = -value[Q_SIGMA + pair(a, b)] * V * g->cells;
    for (int k = 0; k < CORNERS; k++) {
        Line add = shape->S[k] * mass;
        for (int b = 0; b < DIM; b++) add += shape->G[k][b] * flux[b];
        g->node[corner[k]] += add;
        for (int b = 0; g->outward && b < DIM; b++)
            g->outward[corner[k] * DIM + (size_t)b] += shape->G[k][b] * V * g->cells;
        for (int a = 0; g->force && a < DIM; a++)
            g->force[corner[k] * DIM + (size_t)a] += shape->S[k] * V * value[Q_FORCE + a];
    }
}

/* 1 and `scale` (x - x_k) in the lanes of a row of M: of x [cells] and corner k of a cell. */
static inline void row_lanes(const double x[DIM], double scale, Half out[CORNERS])
{
    for (int k = 0; k < CORNERS; k++) {
        double lane[LANES / 2] = {[I_SUM] = 1};
        for (int d = 0; d < DIM; d++) lane[I_FIRST + d] = scale * (x[d] - (k >> d & 1));
        memcpy(&out[k], lane, sizeof lane);
    }
}

/* The share of one point, of `mass`, in the products with M. */
static inline void multiply_point(Wls *w, const size_t corner[CORNERS], const double xi[DIM],
                                  const Shape *shape, double mass)
{
    Half mean = {0}, row[CORNERS];
    for (int k = 0; k < CORNERS; k++) mean += shape->S[k] * w->inertia[corner[k]].factor;
    mean *= mass;
    row_lanes(xi, 1, row);
    for (int k = 0; k < CORNERS; k++) {
        w->inertia[corner[k]].product += shape->S[k] * mean;
        w->inertia[corner[k]].row += shape->S[k] * mass * row[k];
    }
}

/* Adds a point's share to M_kj of a cut cell, k >= j. */
static inline void add_to_matrix(const Shape *shape, double mass, double M[CORNER_PAIRS])
{
    for (int k = 0; k < CORNERS; k++) {
        const double own = mass * shape->S[k];
        for (int j = 0; j <= k; j++) *M++ += own * shape->S[j];
    }
}

/* Adds a cut cell's products with M, and for each corner k the sum of its row and the first moments
 * about it: sum_j M_kj (x_j - x_k) is exact, since sum_j S_j x_j = x. */
static inline void multiply_cut(Wls *w, const size_t corner[CORNERS], const Half place[CORNERS],
                                const double M[CORNER_PAIRS])
{
    for (int k = 0; k < CORNERS; k++) {
        Inertia *own = &w->inertia[corner[k]];
        Half product = {0}, row = {0};
        for (int j = 0; j < CORNERS; j++) {
            const double entry = M[j <= k ? k * (k + 1) / 2 + j : j * (j + 1) / 2 + k];
            product += entry * w->inertia[corner[j]].factor;
            row += entry * place[j];
        }
        for (int d = 0; d < DIM; d++) row[I_FIRST + d] -= (k >> d & 1) * row[I_SUM];
        own->product += product;
        own->row += row;
    }
}

/* A full cell of constant density: M is its mass times a product over the axes of 1/3 (the same
 * node) and 1/6 (the two nodes), the integrals of the tents' products. */
static inline void multiply_full(Wls *w, const size_t corner[CORNERS], const Half row[CORNERS],
                                 double mass)
{
    double scale = mass;
    Half f[CORNERS];
    for (int d = 0; d < DIM; d++) scale /= 6;
    for (int k = 0; k < CORNERS; k++) f[k] = scale * w->inertia[corner[k]].factor;
    for (int d = 0; d < DIM; d++)
        for (int k = 0; k < CORNERS; k++) {
            if (k >> d & 1) continue;
            const Half both = f[k] + f[k | 1 << d];
            f[k] += both;
            f[k | 1 << d] += both;
        }
    for (int k = 0; k < CORNERS; k++) {
        w->inertia[corner[k]].product += f[k];
        w->inertia[corner[k]].row += mass / (double)CORNERS * row[k];
    }
}

/* A full cell has one point, in the middle; its mass is kept for the products with M. These use the
 * same point, unless velocities are corrected: their factor 3/2 (velocity.c) holds for the full
 * matrix (multiply_full). */
static inline void take_full(Sim *sim, const size_t corner[CORNERS], const Middle *m, Task task,
                             long *lost)
{
    Wls *w = wls_of(sim);
    Line value;
    if (task == MULTIPLY) {
        if (w->sharpened)
            multiply_full(w, corner, m->row, w->cell_mass[corner[0]]);
        else
            multiply_point(w, corner, centre, &m->shape, w->cell_mass[corner[0]]);
        return;
    }
    const bool known = value_at(w, corner, centre, &m->shape, &value);
    if (known) add_point(sim, corner, &m->shape, value, 1);
    if (w->inertia) w->cell_mass[corner[0]] = known ? value[Q_RHO] * wls_cell_volume(sim) : 0;
    *lost += !known;
}

static inline void take_cell(Sim *sim, const size_t corner[CORNERS], int mask, const Middle *m,
                             Task task, long *lost)
{
    Wls *w = wls_of(sim);
    double xi[MAX_POINTS][DIM], weight[MAX_POINTS], d[CORNERS];
    Bend bend[CORNERS];
    Shape shape;
    if (mask == (1 << CORNERS) - 1) {
        take_full(sim, corner, m, task, lost);
        return;
    }
    double *M = w->inertia ? w->cut[corner[0]] : NULL;
    if (task == MULTIPLY) {
        multiply_cut(w, corner, m->place, M);
        return;
    }
    for (int k = 0; k < CORNERS; k++) {
        d[k] = w->distance[corner[k]];
        if (w->bend) bend[k] = w->bend[corner[k]];
    }
    for (int k = 0; M && k < CORNER_PAIRS; k++) M[k] = 0;
    const int n = wls_cell_points(d, w->bend ? bend : NULL, w->quadrature, xi, weight);
    for (int q = 0; q < n; q++) {
        Line value;
        shape_at(xi[q], &shape);
        const bool known = value_at(w, corner, xi[q], &shape, &value);
        if (known) add_point(sim, corner, &shape, value, weight[q]);
        if (known && M) add_to_matrix(&shape, value[Q_RHO] * weight[q] * wls_cell_volume(sim), M);
        *lost += !known;
    }
}

bool wls_mirrored_cell(const Grid *g, int axis, int i)
{
    for (int k = 0; k < g->nmirror; k++) {
        const Mirror *m = &g->mirror[k];
        if (m->axis == axis && (m->side < 0 ? i < m->at : i >= m->at)) return true;
    }
    return false;
}

bool wls_cell_row(const Grid *g, int row, CellRow *out)
{
    int rest = row;
    *out = (CellRow){.lo = g->lo[row], .hi = g->hi[row]};
    for (int d = 1; d < DIM; d++) {
        if (rest % g->n[d] + 1 >= g->n[d] || wls_mirrored_cell(g, d, rest % g->n[d])) return false;
        rest /= g->n[d];
    }
    for (int k = 0; k < CORNERS; k++) {
        int up = 0, stride = 1;
        for (int d = 1; d < DIM; d++) {
            up += (k >> d & 1) * stride;
            stride *= g->n[d];
        }
        out->offset[k] = (size_t)up * (size_t)g->n[0] + (size_t)(k & 1);
        out->lo = g->lo[row + up] > out->lo ? g->lo[row + up] : out->lo;
        out->hi = g->hi[row + up] < out->hi ? g->hi[row + up] : out->hi;
    }
    return true;
}

/* The cells whose first node lies in `row`. */
static inline void take_row(Sim *sim, int row, Task task)
{
    const Grid *g = &sim->g;
    Wls *w = wls_of(sim);
    CellRow cells;
    Middle middle;
    if (!wls_cell_row(g, row, &cells)) return;
    shape_at(centre, &middle.shape);
    row_lanes(centre, 2.0 / 3, middle.row);
    for (int k = 0; k < CORNERS; k++) {
        middle.place[k] = (Half){0};
        middle.place[k][I_SUM] = 1;
        for (int d = 0; d < DIM; d++) middle.place[k][I_FIRST + d] = k >> d & 1;
    }
    for (int i = cells.lo; i < cells.hi && i + 1 < cells.hi; i++) {
        size_t corner[CORNERS];
        int mask = 0;
        for (int k = 0; k < CORNERS; k++) {
            corner[k] = (size_t)row * (size_t)g->n[0] + (size_t)i + cells.offset[k];
            mask |= (w->distance[corner[k]] > 0) << k;
        }
        if (mask && !wls_mirrored_cell(g, 0, i))
            take_cell(sim, corner, mask, &middle, task, &w->fallbacks[row]);
    }
}

/* Is the row's index odd along y and z? One bit per axis. Two rows with equal bits share no node,
 * so that threads may take them at once. */
static int parities(const Grid *g, int row)
{
    int bits = 0;
    for (int d = 1; d < DIM; d++) {
        bits |= (row % g->n[d] & 1) << (d - 1);
        row /= g->n[d];
    }
    return bits;
}

static void integrate_row(Sim *sim, int row, const void *turn)
{
    if (parities(&sim->g, row) == *(const int *)turn) take_row(sim, row, INTEGRATE);
}

static void multiply_row(Sim *sim, int row, const void *turn)
{
    if (parities(&sim->g, row) == *(const int *)turn) take_row(sim, row, MULTIPLY);
}

void wls_integrate(Sim *sim)
{
    for (int turn = 0; turn < CORNERS / 2; turn++) each_row(sim, integrate_row, &turn);
}

void wls_mass_times(Sim *sim)
{
    for (int turn = 0; turn < CORNERS / 2; turn++) each_row(sim, multiply_row, &turn);
}
