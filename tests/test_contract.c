/* test_contract.c: four throwaway schemes written against the plug-in contract alone, to prove that
 * it carries more than the methods it was made for: APIC (Jiang et al. 2015), XPIC(2) (Hammerquist
 * & Nairn 2017), quadratic B-splines with weights folded at walls (Steffen et al. 2008), and the
 * moment pass of a weighted-least-squares method (W11 eq 9). */
#include <stdlib.h>
#include "../common/passes.h"
#include "../common/resolve.h"
#include "../common/scheme.h"
#include "../common/step.h"
#include "../methods/shapes.h"
#include "../methods/transfers.h"
#include "check.h"

/* Quadratic B-spline about the nearest node; a node beyond a wall gives its weight to the two
 * inside by linear extrapolation, so that linear fields stay exact up to the wall. */
static int spline_width(double b)
{
    (void)b;
    return 3;
}

static void spline_shape(const Axis *axis, int width, const Field x, const Field b, Stencil *out)
{
    (void)width, (void)b;
    for (int p = 0; p < CHUNK; p++) {
        const double c = floor(x[p] + 0.5), r = x[p] - c;
        const double w[] = {0.5 * (0.5 - r) * (0.5 - r), 0.75 - r * r, 0.5 * (0.5 + r) * (0.5 + r)};
        const double g[] = {r - 0.5, -2 * r, r + 0.5};
        const double low = c - 1 < axis->wall_lo, high = c + 1 > axis->wall_hi;
        const double end[] = {1 - low, 1, 1 - high}, from_low[] = {0, 2 * low, -low};
        const double from_high[] = {-high, 2 * high, 0};
        out->base[p] = (int)c - 1;
        for (int k = 0; k < 3; k++) {
            out->table[T_S][k][p] = end[k] * w[k] + from_low[k] * w[0] + from_high[k] * w[2];
            out->table[T_G][k][p] = end[k] * g[k] + from_low[k] * g[0] + from_high[k] * g[2];
        }
    }
}

/* APIC: PIC velocity, and C = (sum S v (x_i - x_p)^T) D^-1 kept in the place of L. */
static void apic_update(const Chunk *c, const Field sums[], double dt, unsigned take)
{
    for (int a = 0; take & TAKE_V && a < DIM; a++)
        for (int p = 0; p < CHUNK; p++) c->v[a][p] = sums[a][p];
    for (int a = 0; take & TAKE_V && a < DIM; a++)
        for (int b = 0; b < DIM; b++)
            for (int p = 0; p < CHUNK; p++)
                c->L[a * DIM + b][p] = sums[LANES + FLUX + b * DIM + a][p] / sums[LANES + b][p];
    take_position(c, sums, dt, take);
    if (take & TAKE_F) deform(c, sums, dt);
}

static void pic_update(const Chunk *c, const Field sums[], double dt, unsigned take)
{
    for (int a = 0; take & TAKE_V && a < DIM; a++)
        for (int p = 0; p < CHUNK; p++) c->v[a][p] = sums[a][p];
    take_position(c, sums, dt, take);
    if (take & TAKE_F) deform(c, sums, dt);
}

/* P_2 = 2 - S+ S */
static int xpic_filter(const double *par, double c[])
{
    (void)par;
    c[0] = 2, c[1] = -1;
    return 1;
}

static const Method apic = {.keeps_L = true,
                            .affine = true,
                            .moments = true,
                            .smooth = true,
                            .width = spline_width,
                            .shape = spline_shape,
                            .payload = gradient_payload,
                            .update = apic_update};
static const Method xpic = {.smooth = true,
                            .width = gimp_width,
                            .shape = gimp_shape,
                            .payload = mass_payload,
                            .update = pic_update,
                            .filter = xpic_filter,
                            .filter_first = true};
static const Method spline = {.smooth = true,
                              .width = spline_width,
                              .shape = spline_shape,
                              .payload = mass_payload,
                              .update = flip_update};

/* A run of a scene with a scheme of our own in the place of its method. */
typedef struct Trial {
    RunSpec spec;
    Plan plan;
    Sim *sim;
} Trial;

static void trial_open(Trial *t, const char *problem, int cells, const Method *method, int threads)
{
    Fault fault = {0};
    *t = (Trial){.spec = {.cells = cells, .threads = threads}};
    snprintf(t->spec.problem, sizeof t->spec.problem, "%s", problem);
    CU_ASSERT_FATAL(plan_make(&t->spec, &t->plan, &fault) == 0);
    if (method) t->plan.setup.method = method;
    t->sim = sim_new(&t->plan.setup, &fault);
    CU_ASSERT_FATAL(t->sim != NULL);
    sim_sort(t->sim);
}

static Status trial_steps(Trial *t, int steps)
{
    const double dt = 0.3 * t->plan.scene.cell / t->plan.scene.c;
    Status status = {OK, -1, 0};
    for (int k = 0; k < steps && status.code == OK; k++)
        status = sim_step(t->sim, k * dt, dt, k == 0);
    return status;
}

/* Sum of m (x x v) + what the affine part carries: m (D_x C_yx - D_y C_xy); a quadratic spline's D
 * is h^2/4 everywhere, which is why APIC is exact with it. */
static double angular_momentum(const Sim *sim, bool affine)
{
    const Particles *p = &sim->p;
    double sum = 0;
    for (int chunk = 0; DIM == 2 && chunk < p->n / CHUNK; chunk++) {
        Work *w = aligned_alloc(64, (sizeof *w + 63) / 64 * 64);
        const Chunk c = sim_chunk(sim, chunk);
        const int width = make_stencils(sim, &c, w);
        make_moments(w, width);
        spread(sim, w, width);
        for (int k = 0; k < CHUNK; k++) {
            sum += c.m[k] * (c.x[0][k] * c.v[DIM - 1][k] - c.x[DIM - 1][k] * c.v[0][k]);
            if (affine)
                sum += c.m[k] * (w->sums[LANES][k] * c.L[DIM % NMAT][k] -
                                 w->sums[LANES + 1][k] * c.L[1 % NMAT][k]);
        }
        free(w);
    }
    return sum;
}

static void test_apic(void)
{
    Trial t;
    trial_open(&t, "free_block", 16, &apic, 1);
    const double before = angular_momentum(t.sim, true);
    CU_ASSERT_EQUAL(trial_steps(&t, 1).code, OK);
    const double first = angular_momentum(t.sim, true);
    CU_ASSERT_EQUAL(trial_steps(&t, 100).code, OK);
    CHECK_CLOSE(angular_momentum(t.sim, true), first, 1e-12 * fabs(first));
    CHECK_CLOSE(first, before, 1e-12 * fabs(before));
    sim_free(t.sim);
}

/* Velocities that alternate between neighbours: S takes them to nothing on the grid. */
static double ringing_left(const Method *method)
{
    Trial t;
    double left = 0;
    trial_open(&t, "free_block", 16, method, 1);
    Particles *p = &t.sim->p;
    for (int k = 0; k < p->n; k++)
        for (int a = 0; a < DIM; a++)
            p->field[AT_V + a][k] = p->id[k] % 2 ? -1e-6 : 1e-6; /* two particles a cell and axis */
    trial_steps(&t, 3);
    for (int k = 0; k < p->n; k++) {
        bool inside = p->id[k] >= 0; /* at the edges S v is not nothing */
        for (int d = 0; d < DIM; d++) inside = inside && fabs(p->field[AT_X0 + d][k] - 0.75) < 0.3;
        for (int a = 0; a < DIM && inside; a++)
            left = fmax(left, fabs(p->field[AT_V + a][k]) / 1e-6);
    }
    sim_free(t.sim);
    return left;
}

static void test_xpic(void)
{
    CU_ASSERT(ringing_left(NULL) > 0.9); /* GIMP keeps it */
    CU_ASSERT(ringing_left(&xpic) < 0.01);
}

/* At every position, walls included: sum S = 1, sum S x_i = x, sum G = 0, sum G x_i = 1. */
static void test_spline(void)
{
    const Axis axis = {10, 14};
    static Stencil s;
    Field x, b = {0};
    for (int p = 0; p < CHUNK; p++) x[p] = 10 + 4 * (p + 0.5) / CHUNK;
    spline_shape(&axis, 3, x, b, &s);
    for (int p = 0; p < CHUNK; p++) {
        double one = 0, at = 0, zero = 0, slope = 0, outside = 0;
        for (int k = 0; k < 3; k++) {
            const int node = s.base[p] + k;
            one += s.table[T_S][k][p];
            at += s.table[T_S][k][p] * node;
            zero += s.table[T_G][k][p];
            slope += s.table[T_G][k][p] * node;
            if (node < 10 || node > 14) outside += fabs(s.table[T_S][k][p]);
        }
        CHECK_CLOSE(one, 1, 1e-15);
        CHECK_CLOSE(at, x[p], 1e-14);
        CHECK_CLOSE(zero, 0, 1e-15);
        CHECK_CLOSE(slope, 1, 1e-14);
        CHECK_CLOSE(outside, 0, 0);
    }
    Trial t;
    trial_open(&t, DIM == 1 ? "bar" : "ring", 16, &spline, 1);
    CU_ASSERT_EQUAL(trial_steps(&t, 50).code, OK);
    sim_free(t.sim);
}

/* The moments sum W {1, r, r r^T} and the loads sum W f {1, r} of a linear field f, lanes 0 .. 2
 * DIM + 1 plus DIM more: enough to solve for the field's value and slope at the node. */
static Pattern moment_pattern(void)
{
    Pattern q = {0};
    for (int d = 0; d < DIM; d++)
        for (int l = 0; l < LANES; l++) q.e[d][T_S][l] = 1;
    for (int d = 0; d < DIM; d++) { /* lane 1 + d: R on axis d */
        q.e[d][T_S][1 + d] = 0;
        q.e[d][T_R][1 + d] = 1;
    }
    q.e[0][T_S][LANES - 1] = 0; /* the last lane: Q on axis 0 */
    q.e[0][T_Q][LANES - 1] = 1;
    return q;
}

static void deposit_moments(Grid *g, const Work *w, const int width)
{
    const Pattern q = moment_pattern();
    const unsigned tables = 1u << T_R | 1u << T_Q;
    for (int p = 0; p < CHUNK; p++) FOR_ROWS(r, width)
        {
            Line *node = g->node + first_node(g, w->stencil, p) + row_offset(g, width, r);
            Line y = w->A[p];
            if (DIM > 1) y *= row_weight(w->stencil, &q, p, width, r, tables);
            for (int i = 0; i < width; i++)
                node[i] += axis_weight(w->stencil, 0, i, p, &q, tables) * y;
        }
}

/* Moments by the chunked pass against plain sums over particles. */
static void test_moments(void)
{
    Trial t;
    static Work w;
    trial_open(&t, "free_block", 16, &spline, 1);
    Grid *g = &t.sim->g;
    deposit_all(t.sim, 0,
                MOTION); /* clears the live spans and sets masses, which we take off again */
    const int row = g->rows / 2, column = g->n[0] / 2;
    const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)column;
    const Line before = g->node[at];
    double sum[3] = {0};
    for (int chunk = 0; chunk < t.sim->p.n / CHUNK; chunk++) {
        const Chunk c = sim_chunk(t.sim, chunk);
        const int width = make_stencils(t.sim, &c, &w);
        make_moments(&w, width);
        for (int p = 0; p < CHUNK; p++)
            for (int l = 0; l < LANES; l++) w.A[p][l] = c.id[p] >= 0;
        deposit_moments(g, &w, width);
        for (int p = 0; p < CHUNK; p++) {
            double W = c.id[p] >= 0, r = 0;
            for (int d = 0; d < DIM; d++) {
                const double z = fabs((d ? row : column) - w.x[d][p]);
                W *= z < 0.5 ? 0.75 - z * z : z < 1.5 ? 0.5 * (1.5 - z) * (1.5 - z) : 0;
                if (d == 0) r = column - w.x[d][p];
            }
            sum[0] += W, sum[1] += W * r, sum[2] += W * r * r;
        }
    }
    const Line now = g->node[at] - before;
    CHECK_CLOSE(now[0], sum[0], 1e-13);
    CHECK_CLOSE(now[1], sum[1], 1e-13);
    CHECK_CLOSE(now[LANES - 1], sum[2], 1e-13);
    CU_ASSERT(sum[2] > 0.5);
    sim_free(t.sim);
}

extern const TestCase contract_tests[];
const TestCase contract_tests[] = {
    {"APIC fits: angular momentum to 1e-12 over 100 steps", test_apic},
    {"XPIC(2) fits: kills what rings", test_xpic},
    {"quadratic B-spline fits: linear fields up to the wall", test_spline},
    {"a least-squares moment pass fits", test_moments},
    {NULL, NULL},
};
