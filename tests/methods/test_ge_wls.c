/* test_ge_wls.c: the pieces of gradient-enhanced WLS alone: cells with a curved side, gradients as
 * samples, the product with the mass matrix. */
#include <math.h>
#include <stdlib.h>
#include "methods/wls/wls.h"
#include "wls_check.h"

static double random_in(double lo, double hi)
{
    return lo + (hi - lo) * (double)rand() / RAND_MAX;
}

/* Area of the unit square within the circle of radius R about (x, y): strips by their exact height.
 */
static double circle_area(double x, double y, double R)
{
    enum { STRIPS = 20000 };
    double sum = 0;
    for (int k = 0; k < STRIPS; k++) {
        const double s = (k + 0.5) / (double)STRIPS - x,
                     half = R * R > s * s ? sqrt(R * R - s * s) : 0;
        sum += fmax(0, fmin(1, y + half) - fmax(0, y - half));
    }
    return sum / (double)STRIPS;
}

/* The same by the cell's own rule; inside out: what is beyond the circle. */
static double cell_area(double x, double y, double R, bool outside, bool bent, double first[2])
{
    double d[4], xi[MAX_POINTS][DIM], weight[MAX_POINTS], area = 0;
    Bend bend[4];
    for (int k = 0; k < 4; k++) {
        const double away[2] = {(k & 1) - x, (k >> 1) - y}, r = hypot(away[0], away[1]);
        const double sign = outside ? -1 : 1;
        d[k] = sign * (R - r);
        bend[k] = (Bend){{sign * away[0] / r, sign * away[1] / r}, {sign / R}};
    }
    const int n = wls_cell_points(d, bent ? bend : NULL, QUADRATURE_EXACT, xi, weight);
    first[0] = first[1] = 0;
    for (int q = 0; q < n; q++) {
        area += weight[q];
        for (int a = 0; a < 2; a++) first[a] += weight[q] * xi[q][a];
    }
    return area;
}

/* Circles of 6 to 12 cells cross a cell anywhere: both sides fill it, and the curved side has the
 * segment's area where the straight one misses kappa l^3/12. */
static void test_circles(void)
{
    double worst = 0, straight = 0, in[2], out[2];
    srand(4);
    for (int trial = 0; trial < 400; trial++) {
        const double R = random_in(6, 12), angle = random_in(0, 2 * M_PI);
        const double off = R + random_in(-0.6, 0.6);
        const double x = 0.5 - off * cos(angle), y = 0.5 - off * sin(angle);
        const double exact = circle_area(x, y, R), area = cell_area(x, y, R, false, true, in);
        CHECK_CLOSE(area + cell_area(x, y, R, true, true, out), 1, 1e-12);
        for (int a = 0; a < 2; a++) CHECK_CLOSE(in[a] + out[a], 0.5, 1e-12);
        worst = fmax(worst, fabs(area - exact));
        straight = fmax(straight, fabs(cell_area(x, y, R, false, false, in) - exact));
    }
    CU_ASSERT(worst < 5e-4);
    CU_ASSERT(straight > 10 * worst);
}

/* A gradient is as good as particles around: v is fitted from samples that all lie to one side, and
 * other quantities are what they are without it. */
static void test_gradients(void)
{
    const double hermite = 4, slope[DIM][DIM] = {{0.7, -1.3}, {0.4, 0.9}}, value[DIM] = {2, -1};
    Line fit[FIT] = {{0}}, plain[FIT];
    srand(5);
    for (int s = 0; s < 5; s++) {
        const double W = random_in(0.1, 0.5), r[DIM] = {random_in(0.2, 0.9), random_in(0.2, 0.9)};
        Line f = {0};
        f[Q_RHO] = 3 + sin(9 * r[0]);
        for (int a = 0; a < DIM; a++) f[Q_V + a] = value[a];
        for (int a = 0; a < DIM; a++)
            for (int d = 0; d < DIM; d++) f[Q_V + a] += slope[a][d] * r[d];
        fit[FIT_MOMENTS][M_ONE] += W;
        fit[FIT_VALUE] += W * f;
        for (int d = 0; d < DIM; d++) {
            fit[FIT_MOMENTS][M_FIRST + d] += W * r[d];
            fit[FIT_SLOPE + d] += W * r[d] * f;
            for (int a = 0; a < DIM; a++) fit[FIT_SLOPE + d][Q_V + a] += W * hermite * slope[a][d];
            for (int e = d; e < DIM; e++)
                fit[FIT_MOMENTS][M_SECOND + pair(d, e)] += W * r[d] * r[e];
        }
    }
    memcpy(plain, fit, sizeof fit);
    CU_ASSERT(wls_solve(fit, true, hermite, 1e-10) && wls_solve(plain, true, 0, 1e-10));
    for (int a = 0; a < DIM; a++) {
        CHECK_CLOSE(fit[FIT_VALUE][Q_V + a], value[a], 1e-13);
        for (int d = 0; d < DIM; d++) CHECK_CLOSE(fit[FIT_SLOPE + d][Q_V + a], slope[a][d], 1e-13);
    }
    for (int k = FIT_VALUE; k < FIT; k++) CHECK_CLOSE(fit[k][Q_RHO], plain[k][Q_RHO], 1e-13);
}

/* Sum of one lane of M's products times another field over all nodes. */
static double dot(const Sim *sim, int lane, const double *other)
{
    const Grid *g = &sim->g;
    double sum = 0;
    for (int row = 0; row < g->rows; row++)
        for (int i = g->lo[row]; i < g->hi[row]; i++) {
            const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
            sum += wls_of(sim)->inertia[at].product[lane] * other[at];
        }
    return sum;
}

/* M is symmetric, its row sums are D, and they are the mass of all cells. */
static void test_mass(void)
{
    Trial t;
    trial_open(&t, "ring", "ge_wls", 12, "sector=full,offset_x=.3,offset_y=.1", 1);
    const Grid *g = &t.sim->g;
    const size_t n = (size_t)g->rows * (size_t)g->n[0];
    for (size_t at = 0; at < n; at++) g->node[at] = (Line){0};
    wls_assemble(t.sim, 0, true);
    double *x = calloc(n, sizeof *x), *y = calloc(n, sizeof *y), *one = calloc(n, sizeof *one);
    Wls *w = wls_of(t.sim);
    double mass = 0;
    srand(6);
    for (size_t at = 0; at < n; at++)
        x[at] = random_in(-1, 1), y[at] = random_in(-1, 1), one[at] = 1;
    for (int row = 0; row < g->rows; row++)
        for (int i = g->lo[row]; i < g->hi[row]; i++) {
            const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
            w->inertia[at] = (Inertia){{0}, {0}, {0}};
            w->inertia[at].factor[0] = x[at];
            w->inertia[at].factor[1] = y[at];
            w->inertia[at].factor[2] = 1;
            mass += g->node[at][0];
        }
    wls_mass_times(t.sim);
    const double a = dot(t.sim, 0, y), b = dot(t.sim, 1, x);
    CHECK_CLOSE(a, b, 1e-14 * mass);
    CHECK_CLOSE(dot(t.sim, 0, one), dot(t.sim, 2, x), 1e-14 * mass);
    CHECK_CLOSE(dot(t.sim, 2, one), mass, 1e-13 * mass);
    CU_ASSERT(fabs(a) > 1e-6 * mass);
    free(x), free(y), free(one);
    trial_close(&t);
}

/* All cells onto empty nodes; a0 = f/m of every node, M a0 and the row sums D beside it. */
static void start_inertia(Sim *sim)
{
    const Grid *g = &sim->g;
    const size_t n = (size_t)g->rows * (size_t)g->n[0];
    for (size_t at = 0; at < n; at++) {
        g->node[at] = (Line){0};
        for (int a = 0; a < DIM; a++) g->force[at * DIM + (size_t)a] = 0;
    }
    wls_assemble(sim, 0, true);
    for (size_t at = 0; at < n; at++) {
        Inertia *in = &wls_of(sim)->inertia[at];
        *in = (Inertia){{0}, {0}, {0}};
        for (int a = 0; a < DIM && g->node[at][0] > sim->mass_cut; a++) {
            double f = g->force[at * DIM + (size_t)a];
            for (int b = 0; b < DIM; b++) f += g->node[at][FLUX + b * DIM + a];
            in->factor[I_A + a] = f / g->node[at][0];
        }
    }
    wls_mass_times(sim);
}

/* What v of each component must be of all nodes: its fit plus dt (a0 - a), a = 2 a0 - D^-1 M a0:
 * plus dt a that is v + dt a0. Returns the largest dt |a0 - a| of a node with mass. */
static double held_back(const Sim *sim, double dt, double (*v)[DIM])
{
    const Grid *g = &sim->g;
    double most = 0;
    for (size_t at = 0; at < (size_t)g->rows * (size_t)g->n[0]; at++) {
        const Inertia in = wls_of(sim)->inertia[at];
        for (int a = 0; a < DIM; a++) {
            const double mean = in.product[I_A + a] / in.row[I_SUM];
            const double lag = in.row[I_SUM] > 0 ? dt * (mean - in.factor[I_A + a]) : 0;
            v[at][a] = wls_of(sim)->fit[at][FIT_VALUE][Q_V + a] + lag;
            most = fmax(most, fabs(lag));
        }
    }
    return most;
}

/* The velocity that carries particles is the uncorrected one, at every good node, if
 * motion=lagged. */
static void test_carried(void)
{
    const double dt = 1e-4;
    Trial t;
    int sound = 0;
    trial_open(&t, "ring", "ge_wls", 12,
               "sector=full,offset_x=.3,offset_y=.1,motion=lagged,velocity=plain,average=weighted",
               1);
    const Grid *g = &t.sim->g;
    double(*v)[DIM] = calloc((size_t)g->rows * (size_t)g->n[0], sizeof *v);
    start_inertia(t.sim);
    const double most = held_back(t.sim, dt, v);
    wls_repair(t.sim, dt);
    for (int row = 0; row < g->rows; row++)
        for (int i = g->lo[row]; i < g->hi[row]; i++) {
            const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
            if (!wls_is_sound(t.sim, at)) continue;
            sound++;
            for (int a = 0; a < DIM; a++)
                CHECK_CLOSE(g->node[at][1 + a] / g->node[at][0], v[at][a], 1e-12 * most);
        }
    CU_ASSERT(sound > 300 && most > 1e-3);
    free(v);
    trial_close(&t);
}

static const TestCase tests[] = {
    {"cells with a curved side", test_circles},
    {"gradients as samples", test_gradients},
    {"the mass matrix", test_mass},
    {"the velocity that carries particles", test_carried},
    {NULL, NULL},
};
CHECK_SUITE(tests)
