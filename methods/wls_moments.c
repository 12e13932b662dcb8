/* wls_moments.c: weighted least squares at every node (W11 3.2): particles deposit the moments and
 * loads of a plane, sum_p W (c0 + c . r - f_p)^2, for all quantities in one sweep. See wls.h.
 *
 * W is the product of quadratic splines (eq 4), three nodes an axis. Every particle counts as a
 * sample whatever it weighs, surface points included. */
#include <math.h>
#include "wls.h"

/* Tables of one axis: W, W r, W r^2, tent; for the nodes base, base + 1, base + 2. */
enum { W_ONE, W_R, W_RR, W_TENT, KERNELS };

typedef struct Kernel {
    int base[CHUNK];
    Field off; /* of the particle from the middle node */
    Field table[KERNELS][3];
} Kernel;

typedef struct Deposit {
    Kernel kernel[DIM];
    Field T[NMAT], body[DIM], quantity[LANES];
    Line A[CHUNK]; /* quantities by particle */
} Deposit;

/* Which table of an axis a lane of the moments takes. */
static int moment_table(int lane, int axis)
{
    if (lane == M_BETA) return W_TENT;
    if (lane >= M_FIRST && lane < M_SECOND) return lane - M_FIRST == axis ? W_R : W_ONE;
    for (int d = 0; d < DIM; d++)
        for (int e = d; e < DIM; e++)
            if (lane == M_SECOND + pair(d, e)) return (d == axis) + (e == axis);
    return W_ONE;
}

typedef struct MomentPattern {
    Line e[DIM][KERNELS], one;
} MomentPattern;

static MomentPattern moment_pattern(void)
{
    MomentPattern q;
    for (int l = 0; l < LANES; l++) q.one[l] = 1;
    for (int d = 0; d < DIM; d++)
        for (int t = 0; t < KERNELS; t++)
            for (int l = 0; l < LANES; l++) q.e[d][t][l] = l <= M_BETA && moment_table(l, d) == t;
    return q;
}

static void make_kernel(const double x[], int cells, int origin, Kernel *out)
{
    for (int p = 0; p < CHUNK; p++) {
        const double at = x[p] * cells - origin, c = floor(at + 0.5), r = at - c;
        out->base[p] = (int)c - 1;
        out->off[p] = r;
        out->table[W_ONE][0][p] = 0.5 * (0.5 - r) * (0.5 - r);
        out->table[W_ONE][1][p] = 0.75 - r * r;
        out->table[W_ONE][2][p] = 0.5 * (0.5 + r) * (0.5 + r);
    }
    for (int k = 0; k < 3; k++)
        for (int p = 0; p < CHUNK; p++) {
            const double w = out->table[W_ONE][k][p], s = out->off[p] - (k - 1), tent = 1 - fabs(s);
            out->table[W_R][k][p] = w * s;
            out->table[W_RR][k][p] = w * s * s;
            out->table[W_TENT][k][p] = tent > 0 ? tent : 0;
        }
}

/* beta of eq 13 rides on the tents of axis 0; padding has no weight at all. */
static void weigh(const Wls *w, const Chunk *c, Kernel *kernel)
{
    Field real, beta;
    for (int p = 0; p < CHUNK; p++) {
        real[p] = c->id[p] >= 0 ? 1 : 0;
        beta[p] = c->V0[p] > 0 ? 2 : real[p] * w->surface_beta;
    }
    for (int k = 0; k < 3; k++)
        for (int p = 0; p < CHUNK; p++) {
            for (int t = 0; t < W_TENT; t++) kernel->table[t][k][p] *= real[p];
            kernel->table[W_TENT][k][p] *= beta[p];
        }
}

/* f_ext = rho b, sigma = T/J; a law whose T is not symmetric gives half of both. */
static void load_forces(const Sim *sim, const Chunk *c, double t, Deposit *w)
{
    const Field *rho = (const Field *)&w->quantity[Q_RHO], *T = (const Field *)w->T;
    const double half = 0.5 / sim->setup->scene->mat.rho;
    sim_stress(sim, c, w->T);
    sim_body(sim, c, t, w->body);
    for (int a = 0; a < DIM; a++) {
        for (int p = 0; p < CHUNK; p++) w->quantity[Q_FORCE + a][p] = (*rho)[p] * w->body[a][p];
        for (int b = a; b < DIM; b++)
            for (int p = 0; p < CHUNK; p++)
                w->quantity[Q_SIGMA + pair(a, b)][p] =
                    half * (*rho)[p] * (T[a * DIM + b][p] + T[b * DIM + a][p]);
    }
}

/* All quantities of a chunk (4.1), rho = rho0/J among them. */
static void load_quantities(const Sim *sim, const Chunk *c, double t, bool force, Deposit *w)
{
    const double rho0 = sim->setup->scene->mat.rho;
    for (int a = 0; a < DIM; a++)
        for (int p = 0; p < CHUNK; p++) w->quantity[Q_V + a][p] = c->v[a][p];
    for (int p = 0; p < CHUNK; p++) {
        Mat F;
        for (int k = 0; k < NMAT; k++) F[k] = c->F[k][p];
        w->quantity[Q_RHO][p] = rho0 / determinant(F);
    }
    for (int l = Q_FORCE; l < LANES; l++)
        for (int p = 0; p < CHUNK; p++) w->quantity[l][p] = 0;
    if (force) load_forces(sim, c, t, w);
    for (int p = 0; p < CHUNK; p++)
        for (int l = 0; l < LANES; l++) w->A[p][l] = w->quantity[l][p];
}

static inline size_t first_node(const Grid *g, const Kernel k[DIM], int p, int r)
{
    size_t row = 0;
    for (int d = DIM - 1; d > 0; d--)
        row = row * (size_t)g->n[d] + (size_t)(k[d].base[p] + (d == 1 ? r % 3 : r / 3));
    return row * (size_t)g->n[0] + (size_t)k[0].base[p];
}

static inline __attribute__((always_inline)) Line lanes(const Kernel *k, int node, int p,
                                                        const Line e[KERNELS])
{
    Line w = k->table[W_ONE][node][p] * e[W_ONE];
    for (int t = 1; t < KERNELS; t++) w += k->table[t][node][p] * e[t];
    return w;
}

/* One particle to its 3^DIM nodes. */
static inline __attribute__((always_inline)) void scatter(const Grid *g, Wls *wls, const Deposit *w,
                                                          int p, const MomentPattern *q)
{
    const Kernel *k = w->kernel;
    const Line A = w->A[p];
    Line x[3];
    for (int i = 0; i < 3; i++) x[i] = lanes(&k[0], i, p, q->e[0]);
    for (int r = 0; r < (DIM == 1 ? 1 : DIM == 2 ? 3 : 9); r++) {
        const size_t at = first_node(g, k, p, r);
        Line y = DIM > 1 ? lanes(&k[DIM > 1], r % 3, p, q->e[DIM > 1]) : q->one;
        double row = DIM > 1 ? k[DIM > 1].table[W_ONE][r % 3][p] : 1;
        for (int d = 2; d < DIM; d++) {
            y *= lanes(&k[d], r / 3, p, q->e[d]);
            row *= k[d].table[W_ONE][r / 3][p];
        }
        for (int i = 0; i < 3; i++) {
            Line *fit = wls->fit[at + (size_t)i];
            const double weight = k[0].table[W_ONE][i][p] * row, most = wls->most[at + (size_t)i];
            const Line load = weight * A;
            fit[FIT_MOMENTS] += x[i] * y;
            fit[FIT_VALUE] += load;
            fit[FIT_SLOPE] += (k[0].off[p] - (i - 1)) * load;
            for (int d = 1; d < DIM; d++)
                fit[FIT_SLOPE + d] += (k[d].off[p] - ((d == 1 ? r % 3 : r / 3) - 1)) * load;
            wls->most[at + (size_t)i] = weight > most ? weight : most;
        }
    }
}

/* Current outward normal F^-T N of surface point p, not yet of unit length. */
static void push_normal(const Chunk *c, int p, double n[DIM])
{
    Mat F;
    for (int k = 0; k < NMAT; k++) F[k] = c->F[k][p];
    for (int a = 0; a < DIM; a++) {
        n[a] = 0;
        for (int b = 0; b < DIM; b++) n[a] += cofactor(F, a, b) * c->normal[b][p];
    }
}

/* Surface point p to the sums of its 2^DIM nodes. */
static void scatter_skin(const Grid *g, Wls *wls, const Deposit *w, const Chunk *c, int p)
{
    double n[DIM], length = 0;
    push_normal(c, p, n);
    for (int d = 0; d < DIM; d++) length += n[d] * n[d];
    length = length > 0 ? sqrt(length) : 1;
    for (int r = 0; r < (DIM == 1 ? 1 : DIM == 2 ? 3 : 9); r++)
        for (int i = 0; i < 3; i++) {
            const size_t at = first_node(g, w->kernel, p, r) + (size_t)i;
            double S = 1, dot = 0, away[DIM];
            for (int d = 0; d < DIM; d++) {
                const int k = d == 0 ? i : d == 1 ? r % 3 : r / 3;
                away[d] = c->x[d][p] * g->cells - g->origin[d] - (w->kernel[d].base[p] + k);
                S *= fabs(away[d]) < 1 ? 1 - fabs(away[d]) : 0;
                dot += away[d] * n[d] / length;
            }
            if (!(S > 0)) continue;
            wls->skin[at][K_ONE] += S;
            for (int d = 0; d < DIM; d++) wls->skin[at][K_FIRST + d] += S * away[d];
            wls->skin[at][K_NORMAL] += S * dot;
        }
}

static void deposit_chunk(Sim *sim, int k, double t, bool force, Deposit *w)
{
    Wls *wls = wls_of(sim);
    const Chunk c = sim_chunk(sim, k);
    const MomentPattern q = moment_pattern();
    for (int d = 0; d < DIM; d++)
        make_kernel(c.x[d], sim->g.cells, sim->g.origin[d], &w->kernel[d]);
    weigh(wls, &c, &w->kernel[0]);
    load_quantities(sim, &c, t, force, w);
    for (int p = 0; p < CHUNK; p++) scatter(&sim->g, wls, w, p, &q);
    for (int p = 0; sim->surface && p < CHUNK; p++)
        if (c.id[p] >= 0 && !(c.V0[p] > 0)) scatter_skin(&sim->g, wls, w, &c, p);
}

static void clear_row(const Grid *g, Wls *w, int row)
{
    const size_t start = (size_t)row * (size_t)g->n[0];
    const Line zero = g->zero;
    for (size_t at = start + (size_t)g->lo[row]; at < start + (size_t)g->hi[row]; at++) {
        for (int k = 0; k < FIT; k++) w->fit[at][k] = zero;
        if (w->skin[at][K_ONE] > 0) w->skin[at] = zero; /* few nodes */
        w->most[at] = 0;
    }
}

/* Signs of a mirrored particle's moments, quantities and surface sums, for a mirror across `axis`.
 */
typedef struct Parity {
    Line moments, value, skin;
} Parity;

static Parity parity_of(int axis)
{
    Parity q;
    for (int l = 0; l < LANES; l++) q.moments[l] = q.value[l] = q.skin[l] = 1;
    q.moments[M_FIRST + axis] = q.value[Q_V + axis] = q.value[Q_FORCE + axis] =
        q.skin[K_FIRST + axis] = -1;
    for (int d = 0; d < DIM; d++)
        if (d != axis) q.moments[M_SECOND + pair(d, axis)] = q.value[Q_SIGMA + pair(d, axis)] = -1;
    return q;
}

static void fold_pair(Sim *sim, const Mirror *m, size_t ghost, size_t image, int image_row,
                      void *own)
{
    Wls *w = wls_of(sim);
    const Parity q = parity_of(m->axis);
    (void)image_row, (void)own;
    w->fit[image][FIT_MOMENTS] += q.moments * w->fit[ghost][FIT_MOMENTS];
    w->fit[image][FIT_VALUE] += q.value * w->fit[ghost][FIT_VALUE];
    for (int d = 0; d < DIM; d++)
        w->fit[image][FIT_SLOPE + d] +=
            (d == m->axis ? -1.0 : 1.0) * q.value * w->fit[ghost][FIT_SLOPE + d];
    w->skin[image] += q.skin * w->skin[ghost];
    w->most[image] = w->most[ghost] > w->most[image] ? w->most[ghost] : w->most[image];
}

void wls_deposit(Sim *sim, double t, bool force)
{
    Grid *g = &sim->g;
    Wls *wls = wls_of(sim);
#pragma omp parallel num_threads(sim->setup->threads)
    {
        Deposit w;
#pragma omp for schedule(static)
        for (int row = 0; row < g->rows; row++)
            if (g->lo[row] < g->hi[row]) clear_row(g, wls, row);
        for (int parity = 0; parity < 2; parity++) {
#pragma omp for schedule(dynamic, 1)
            for (int b = parity; b < sim->nblock; b += 2)
                for (int k = sim->block[b].first; k < sim->block[b].last; k++)
                    deposit_chunk(sim, k, t, force, &w);
        }
    }
    if (g->nmirror) grid_visit_pairs(sim, false, fold_pair, NULL);
}

/* Inverse of the moment matrix, by elimination without pivots (it is positive definite or of no
 * use). Returns its determinant; the inverse is good if that is positive. */
static double invert(double M[DIM + 1][DIM + 1])
{
    double det = 1;
    for (int k = 0; k <= DIM; k++) {
        const double pivot = M[k][k], inverse = 1 / pivot;
        det *= pivot;
        if (!(pivot > 0)) return 0;
        M[k][k] = 1;
        for (int j = 0; j <= DIM; j++) M[k][j] *= inverse;
        for (int i = 0; i <= DIM; i++) {
            const double factor = M[i][k];
            if (i == k) continue;
            M[i][k] = 0;
            for (int j = 0; j <= DIM; j++) M[i][j] -= factor * M[k][j];
        }
    }
    return det;
}

bool wls_solve(Line fit[FIT], bool near)
{
    const Line m = fit[FIT_MOMENTS];
    double M[DIM + 1][DIM + 1], least = 1e-10;
    const double total = m[M_ONE];
    for (int d = 0; d <= DIM; d++) least *= total;
    M[0][0] = total;
    for (int d = 0; d < DIM; d++) {
        M[0][1 + d] = M[1 + d][0] = m[M_FIRST + d];
        for (int e = 0; e < DIM; e++) M[1 + d][1 + e] = m[M_SECOND + pair(d, e)];
    }
    const bool whole = near && invert(M) > least;
    const Line load = fit[FIT_VALUE];
    if (!whole) {
        fit[FIT_VALUE] = total > 0 ? load / total : (Line){0};
        for (int d = 0; d < DIM; d++) fit[FIT_SLOPE + d] = (Line){0};
        return false;
    }
    Line c[DIM + 1];
    for (int k = 0; k <= DIM; k++) {
        c[k] = M[k][0] * load;
        for (int d = 0; d < DIM; d++) c[k] += M[k][1 + d] * fit[FIT_SLOPE + d];
    }
    for (int k = 0; k <= DIM; k++) fit[FIT_VALUE + k] = c[k];
    return true;
}
