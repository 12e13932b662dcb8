/* moments.c: weighted least squares at every node (W11 3.2): particles deposit the moments and
 * loads of a plane, sum_p W (c0 + c . r - f_p)^2, for all quantities in one sweep. See wls.h.
 *
 * W is the product of quadratic splines (eq 4), three nodes per axis. Every particle counts as a
 * sample whatever it weighs, surface points included. */
#include <math.h>
#include "kernel.h"
#include "space.h"
#include "common/core/each.h"

/* Do the sums of a row of nodes fit into the registers? */
enum { RUNS = 3 * FIT * (int)sizeof(Line) <= (int)REGISTERS * VECTOR_BYTES };

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
            for (int l = 0; l < LANES; l++) q.e[d][t][l] = l < MOMENTS && moment_table(l, d) == t;
    return q;
}

static void make_kernel(const double x[], int cells, int origin, double shift, Kernel *out)
{
    for (int p = 0; p < CHUNK; p++) {
        const double at = x[p] * cells - origin - shift, c = floor(at + 0.5), r = at - c;
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

/* Volumes now [cells]. */
static void find_volumes(const Sim *sim, const Chunk *c, Field V)
{
    for (int p = 0; p < CHUNK; p++) {
        Mat F;
        for (int k = 0; k < NMAT; k++) F[k] = c->F[k][p];
        V[p] = c->V0[p] * determinant(F);
        for (int d = 0; d < DIM; d++) V[p] *= sim->g.cells;
    }
}

/* beta of eq 13 rides on the tents of axis 0; padding has no weight at all. */
static void weigh(const Sim *sim, const Wls *w, const Chunk *c, Kernel *kernel)
{
    Field real, beta;
    for (int p = 0; p < CHUNK; p++) {
        real[p] = c->id[p] >= 0 ? 1 : 0;
        beta[p] = c->V0[p] > 0 ? 2 : real[p] * w->surface_beta;
    }
    if (w->centres) find_volumes(sim, c, beta);
    for (int k = 0; k < 3; k++)
        for (int p = 0; p < CHUNK; p++) {
            for (int t = 0; t < W_TENT; t++) kernel->table[t][k][p] *= real[p];
            kernel->table[W_TENT][k][p] *= beta[p];
        }
}

/* f_ext = rho b, sigma = T/J; a law whose T is not symmetric gives half of both. */
static void load_forces(const Sim *sim, const Chunk *c, double t, const Field rho, bool body,
                        Deposit *w)
{
    const double half = 0.5 / sim->setup->scene->mat.rho;
    sim_stress(sim, c, w->T);
    if (body) sim_body(sim, c, t, w->body);
    for (int a = 0; a < DIM; a++) {
        for (int p = 0; body && p < CHUNK; p++)
            w->quantity[Q_FORCE + a][p] = rho[p] * w->body[a][p];
        for (int b = a; b < DIM; b++) {
            const int lane = Q_SIGMA + pair(a, b), ab = a * DIM + b, ba = b * DIM + a;
            for (int p = 0; p < CHUNK; p++)
                w->quantity[lane][p] = half * rho[p] * (w->T[ab][p] + w->T[ba][p]);
        }
    }
}

/* All quantities of a chunk (4.1), rho = rho0/J among them. */
static void load_quantities(const Sim *sim, const Chunk *c, double t, bool force, bool body,
                            Deposit *w)
{
    const double rho0 = sim->setup->scene->mat.rho;
    Field rho;
    for (int a = 0; a < DIM; a++)
        for (int p = 0; p < CHUNK; p++) w->quantity[Q_V + a][p] = c->v[a][p];
    for (int p = 0; p < CHUNK; p++) {
        Mat F;
        for (int k = 0; k < NMAT; k++) F[k] = c->F[k][p];
        rho[p] = rho0 / determinant(F);
    }
    for (int p = 0; p < CHUNK; p++) w->quantity[Q_RHO][p] = rho[p];
    for (int l = Q_FORCE; l < LANES; l++)
        for (int p = 0; p < CHUNK; p++) w->quantity[l][p] = 0;
    if (force) load_forces(sim, c, t, rho, body, w);
    for (int d = 0; d < DIM && R_RIDES; d++)
        for (int p = 0; p < CHUNK; p++) w->quantity[Q_R + d][p] = w->kernel[d].off[p];
    four_lines_from_fields(w->quantity, w->A);
}

/* The particle's gradient is a sample of the slopes of v: adds g^2 h^2 |c - L|^2 to the sum of
 * squares. */
static void load_gradients(const Sim *sim, const Chunk *c, double hermite, Deposit *w)
{
    const double scale = hermite * sim->dx; /* L per cell */
    for (int p = 0; p < CHUNK; p++)
        for (int d = 0; d < DIM; d++) {
            w->B[p][d] = (Line){0};
            for (int a = 0; a < DIM; a++) w->B[p][d][Q_V + a] = scale * c->L[a * DIM + d][p];
        }
}

static inline __attribute__((always_inline)) Line lanes(const Kernel *k, int node, int p,
                                                        const Line e[KERNELS])
{
    Line w = k->table[W_ONE][node][p] * e[W_ONE];
    for (int t = 1; t < KERNELS; t++) w += k->table[t][node][p] * e[t];
    return w;
}

/* Particle p to row r of its nodes, three of them. */
static inline __attribute__((always_inline)) void add_to_row(const Deposit *w, int p, int r,
                                                             const MomentPattern *q, bool hermite,
                                                             Line fit[3][FIT], double most[3])
{
    const Kernel *k = w->kernel;
    const Line A = w->A[p];
    const Line y = DIM > 1 ? lanes(&k[AXIS_Y], r, p, q->e[AXIS_Y]) : q->one;
    const double row = DIM > 1 ? k[AXIS_Y].table[W_ONE][r][p] : 1;
    for (int i = 0; i < 3; i++) {
        const double weight = k[0].table[W_ONE][i][p] * row, before = most[i];
        const Line load = weight * A;
        fit[i][FIT_MOMENTS] += w->x[p][i] * y;
        fit[i][FIT_VALUE] += load;
        fit[i][FIT_SLOPE] += (k[0].off[p] - (i - 1)) * load;
        for (int d = 1; d < DIM; d++) fit[i][FIT_SLOPE + d] += (k[d].off[p] - (r - 1)) * load;
        for (int d = 0; d < DIM && hermite; d++)
            if (RUNS)
                fit[i][FIT_SLOPE + d] += weight * w->B[p][d];
            else
                *(Half *)&fit[i][FIT_SLOPE + d] += weight * *(const Half *)&w->B[p][d];
        most[i] = weight > before ? weight : before;
    }
}

/* Particles from <= p < to, which see the same nodes: summed in registers, a row at a time. */
static inline __attribute__((always_inline)) void scatter_run(const Grid *g, Wls *wls,
                                                              const Deposit *w, int from, int to,
                                                              const MomentPattern *q, bool hermite)
{
    const size_t first = first_of(g, w->kernel, from);
    for (int r = 0; r < (DIM == 1 ? 1 : 3); r++) {
        const size_t at = first + row_offset(g, 3, r);
        Line fit[3][FIT] = {{{0}}};
        double most[3] = {0};
        for (int p = from; p < to; p++) add_to_row(w, p, r, q, hermite, fit, most);
        for (int i = 0; i < 3; i++) {
            double *before = &wls->most[at + (size_t)i];
            for (int l = 0; l < FIT; l++) wls->fit[at + (size_t)i][l] += fit[i][l];
            *before = most[i] > *before ? most[i] : *before;
        }
    }
}

static inline __attribute__((always_inline)) void
scatter_one(const Grid *g, Wls *wls, const Deposit *w, int p, const MomentPattern *q, bool hermite)
{
    const size_t first = first_of(g, w->kernel, p);
    for (int r = 0; r < (DIM == 1 ? 1 : 3); r++) {
        const size_t at = first + row_offset(g, 3, r);
        add_to_row(w, p, r, q, hermite, wls->fit + at, wls->most + at);
    }
}

/* Particles are sorted by their nearest node: several in a row see the same nodes. */
static inline __attribute__((always_inline)) void scatter(const Grid *g, Wls *wls, Deposit *w,
                                                          const MomentPattern *q, bool hermite)
{
    const Kernel *k = w->kernel;
    for (int p = 0; p < CHUNK; p++)
        for (int i = 0; i < 3; i++) w->x[p][i] = lanes(&k[0], i, p, q->e[0]);
    for (int from = 0, to; from < CHUNK; from = to) {
        for (to = from + 1; RUNS && to < CHUNK && same_nodes(k, to - 1);) to++;
        if (RUNS)
            scatter_run(g, wls, w, from, to, q, hermite);
        else
            scatter_one(g, wls, w, from, q, hermite);
    }
}

static void deposit_chunk(Sim *sim, Wls *wls, int k, double t, bool force, Deposit *w)
{
    const Chunk c = sim_chunk(sim, k);
    const MomentPattern q = moment_pattern();
    for (int d = 0; d < DIM; d++)
        make_kernel(c.x[d], sim->g.cells, sim->g.origin[d], wls->centres ? 0.5 : 0, &w->kernel[d]);
    weigh(sim, wls, &c, &w->kernel[0]);
    load_quantities(sim, &c, t, force, !wls->centres, w);
    const bool hermite = wls->hermite > 0;
    if (hermite) load_gradients(sim, &c, wls->hermite, w);
    if (R_RIDES)
        scatter_in_space(&sim->g, wls, w, hermite);
    else if (hermite)
        scatter(&sim->g, wls, w, &q, true);
    else
        scatter(&sim->g, wls, w, &q, false);
    for (int p = 0; sim->surface && p < CHUNK; p++)
        if (c.id[p] >= 0 && !(c.V0[p] > 0)) wls_skin_point(sim, &c, p);
}

typedef struct Task {
    Wls *wls;
    double t;
    bool force;
} Task;

static void clear_row(Sim *sim, int row, const void *own)
{
    const Task *task = own;
    const Grid *g = &sim->g;
    Wls *w = task->wls;
    const size_t start = (size_t)row * (size_t)g->n[0];
    const Line zero = g->zero;
    for (size_t at = start + (size_t)g->lo[row]; at < start + (size_t)g->hi[row]; at++) {
        for (int k = 0; k < FIT; k++) w->fit[at][k] = zero;
        w->skinned[at] = false;
        w->most[at] = 0;
    }
}

static void deposit_chunks(Sim *sim, int first, int last, void *own)
{
    const Task *task = own;
    Deposit w;
    for (int k = first; k < last; k++) deposit_chunk(sim, task->wls, k, task->t, task->force, &w);
}

void wls_deposit(Sim *sim, Wls *wls, double t, bool force)
{
    Task task = {wls, t, force};
    each_row(sim, clear_row, &task);
    each_block(sim, deposit_chunks, &task);
    if (sim->g.nmirror) wls_fold(sim, wls);
}
