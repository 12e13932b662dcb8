/* test_methods.c: what single ideas promise, whichever methods have them: a uniform velocity moves
 * the body and nothing else, angular momentum, the null space, weights folded at walls. */
#include <stdlib.h>
#include <string.h>
#include "common/core/passes.h"
#include "common/core/scheme.h"
#include "methods/parts/filters.h"
#include "tests/fixture.h"

static const Case blocks[] = {{1, "free_block", 200, 2, 0, NULL},
                              {2, "free_block", 16, 4, 0, NULL},
                              {3, "free_block", 10, 8, 0, NULL}};

typedef void Check(Fixture *r);

static void for_variants(const Case *scene, Check *check, const char *more)
{
    char set[VARIANT_TEXT];
    FOR_METHODS(m) for (int k = 0; k < VARIANTS; k++) FOR_INTEGRATORS(i)
    {
        Fixture r;
        if (!fixture_variant(*m, k, more, set) || !fixture_valid(*m, i, false)) continue;
        CU_ASSERT_FATAL(fixture_plan(&r, scene, (*m)->info.name, i, set));
        check(&r);
    }
}

/* ---- a uniform velocity moves the body and nothing else */

static void check_constant(Fixture *r)
{
    Sim *sim = fixture_sim(r);
    double *start = fixture_state(sim);
    const int n = sim->p.count, steps = 20;
    CU_ASSERT(fixture_steps(r, sim, 0, steps));
    double *end = fixture_state(sim);
    CU_ASSERT(fixture_gap(start, end, n, AT_V, DIM) < 1e-12 * fixture_size(start, n, AT_V, DIM));
    CU_ASSERT(fixture_gap(start, end, n, AT_F, NMAT) < 1e-12);
    for (int k = 0; k < n; k++)
        for (int d = 0; d < DIM; d++)
            CHECK_CLOSE(end[(AT_X + d) * n + k],
                        start[(AT_X + d) * n + k] + steps * r->dt * start[(AT_V + d) * n + k],
                        1e-13);
    free(start), free(end);
    sim_free(sim);
}

static void test_constant(void)
{
    static const Case small = {3, "free_block", 4, 8, 0, NULL};
    for_variants(DIM < 3 ? &blocks[DIM - 1] : &small, check_constant, "spin=0;swing=0");
}

/* ---- angular momentum: sum m (x x v) + m eps : B, where B is what the method keeps for L, or L D
 * with the spread D of its weights */

static double spread_of(const Sim *sim)
{
    const Axis open_axis = {.wall_lo = -INFINITY, .wall_hi = INFINITY};
    Field x = {0}, b = {0};
    Stencil s;
    double D = 0;
    if (sim->method.moments) return 1;
    if (sim->method.list) return 0.25 * sim->dx * sim->dx; /* quadratic splines */
    for (int p = 0; p < CHUNK; p++) x[p] = 20.3;
    sim->method.shape(&open_axis, sim->method.width(0.5), x, b, &s);
    for (int k = 0; k < sim->method.width(0.5); k++)
        D += s.table[T_S][k][0] * pow((s.base[0] + k - x[0]) * sim->dx, 2);
    return D;
}

static double turning(const Sim *sim)
{
    const Particles *p = &sim->p;
    double *const *f = p->field, sum = 0, D = spread_of(sim);
    enum { Y = DIM - 1, XY = 1 % NMAT, YX = DIM % NMAT };
    for (int k = 0; k < p->n; k++)
        if (p->id[k] >= 0)
            sum += f[AT_M][k] * (f[AT_X][k] * f[AT_V + Y][k] - f[AT_X + Y][k] * f[AT_V][k] +
                                 D * (f[AT_L + YX][k] - f[AT_L + XY][k]));
    return sum;
}

/* With uvf particles do not move along the velocity that they carry. */
static void check_turning(Fixture *r)
{
    if (!r->plan.setup.method->turns || r->plan.setup.integrator == UVF) return;
    Sim *sim = fixture_sim(r);
    sim_sort(sim); /* from here on it keeps moments */
    const double before = turning(sim);
    CU_ASSERT(fixture_steps(r, sim, 0, 100));
    CHECK_CLOSE(turning(sim), before, 1e-12 * fabs(before));
    CU_ASSERT(fabs(before) > 1);
    sim_free(sim);
}

static void test_turning(void)
{
    if (DIM == 2) for_variants(&blocks[DIM - 1], check_turning, "");
}

/* ---- the null space: velocities that alternate between neighbours, which S takes to nothing */

#define STILL "spin=0;drift=0;swing=0" /* no gradient either */

/* What is left of them after three steps, inside; *pic: the share of v that the method replaces. */
static double ringing_left(const char *method, const char *set, double *pic)
{
    Fixture r;
    double left = 0;
    const double reach = DIM < 3 ? 0.2 : 0.06; /* as far from the edges, in cells */
    CU_ASSERT_FATAL(fixture_plan(&r, &blocks[DIM - 1], method, CD, set));
    Sim *sim = fixture_sim(&r);
    Particles *p = &sim->p;
    for (int k = 0; k < p->n; k++)
        for (int a = 0; a < DIM; a++)
            p->field[AT_V + a][k] =
                p->id[k] % 2 ? -1e-6 : 1e-6; /* two particles per cell and axis */
    CU_ASSERT(fixture_steps(&r, sim, 0, 3));
    for (int k = 0; k < p->n; k++) {
        bool inside = p->id[k] >= 0; /* at the edges S v is not nothing */
        for (int d = 0; d < DIM; d++)
            inside = inside && fabs(p->field[AT_X0 + d][k] - 0.75) < reach;
        for (int a = 0; a < DIM && inside; a++)
            left = fmax(left, fabs(p->field[AT_V + a][k]) / 1e-6);
    }
    *pic = sim->method.pic;
    sim_free(sim);
    return left;
}

/* Each step multiplies what S does not see by 1 - pic. (WLS, which sees it, may replace none.) */
static void test_ringing(void)
{
    int blends = 0;
    double pic = 0;
    FOR_METHODS(m) for (int k = 0; k < VARIANTS; k++)
    {
        char set[VARIANT_TEXT];
        if (!fixture_variant(*m, k, STILL, set)) continue;
        const double left = ringing_left((*m)->info.name, set, &pic), kept = pow(1 - pic, 3);
        if (pic > 0 || !(*m)->surface) CHECK_CLOSE(left, kept, 0.1 * kept + 0.01);
        CU_ASSERT(pic >= 0 && pic <= 1 && (!(*m)->filter || pic > 1 - 1e-15));
        blends += pic > 0 && pic < 1;
    }
    CU_ASSERT(blends >= 2);
    if (DIM > 2) return; /* many rounds reach from the edges of this block to its middle */
    CU_ASSERT(ringing_left("xpic", STILL ";order=5", &pic) < 0.01);
    CU_ASSERT(ringing_left("fmpm", STILL ";order=5", &pic) < 0.01);
}

/* x sum_l c_l x^l = 1 - (1 - x)^k */
static void test_filter(void)
{
    for (int k = 1; k <= 8; k++) {
        double c[MAX_ROUNDS + 1];
        CU_ASSERT_EQUAL(binomial_filter(k, c), k - 1);
        for (double x = 0; x <= 1; x += 0.125) {
            double sum = 0;
            for (int l = k - 1; l >= 0; l--) sum = sum * x + c[l];
            CHECK_CLOSE(x * sum, 1 - pow(1 - x, k), 1e-12);
        }
    }
}

/* The particles after ten steps of a smooth swing, and how many they are. */
static double *swing(const char *method, const char *set, int *n)
{
    Fixture r;
    char all[64];
    snprintf(all, sizeof all, "%s;spin=0;drift=0", set);
    CU_ASSERT_FATAL(fixture_plan(&r, &blocks[DIM - 1], method, CD, all));
    Sim *sim = fixture_sim(&r);
    CU_ASSERT(fixture_steps(&r, sim, 0, 10));
    double *state = fixture_state(sim);
    *n = sim->p.count;
    sim_free(sim);
    return state;
}

/* What is left of it: PIC damps most, then less with each order of a filter or share of FLIP. */
static void test_damping(void)
{
    static const char *const orders[] = {"order=1", "order=3", "order=5", NULL};
    static const char *const shares[] = {"alpha=0", "alpha=0.5", "alpha=0.99", "alpha=1", NULL};
    const struct {
        const char *method, *const *set;
    } ladder[] = {{"xpic", orders}, {"fmpm", orders}, {"flip_pic", shares}};
    for (int m = 0; m < COUNT(ladder); m++) {
        double last = -1;
        for (const char *const *set = ladder[m].set; *set; set++) {
            int n;
            double *state = swing(ladder[m].method, *set, &n), energy = 0;
            for (int k = 0; k < DIM * n; k++) energy += pow(state[AT_V * n + k], 2);
            CU_ASSERT(energy > last);
            last = energy;
            free(state);
        }
    }
}

/* The ends of the blend: FLIP to the last bit, and PIC, which FMPM of order 1 is. */
static void test_blend(void)
{
    int n;
    double *flip = swing("flip_pic", "alpha=1", &n), *gimp = swing("gimp", "spin=0", &n);
    double *pic = swing("flip_pic", "alpha=0", &n), *fmpm = swing("fmpm", "order=1", &n);
    CU_ASSERT(memcmp(flip, gimp, sizeof *flip * (size_t)(FIELDS * n)) == 0);
    CU_ASSERT(fixture_distance(fmpm, pic, n, false) < 1e-13);
    CU_ASSERT(fixture_distance(flip, pic, n, false) > 1e-3);
    free(flip), free(gimp), free(pic), free(fmpm);
}

/* ---- folded weights: sum S = 1, sum S x_i = x, sum G = 0, sum G x_i = 1 up to walls, past them,
 * and nothing beyond */

static void check_folded(const Field x)
{
    const Axis axis = {.wall_lo = 10, .wall_hi = 14};
    Stencil s;
    Field b = {0};
    folded_shape(&axis, 3, x, b, &s);
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
        CHECK_CLOSE(one, 1, 1e-14);
        CHECK_CLOSE(at, x[p], 1e-13);
        CHECK_CLOSE(zero, 0, 1e-14);
        CHECK_CLOSE(slope, 1, 1e-13);
        CHECK_CLOSE(outside, 0, 0);
    }
}

/* Inside they are the plain spline's, at a wall a tent. */
static void test_folded(void)
{
    const Axis axis = {.wall_lo = 10, .wall_hi = 14};
    Stencil folded, plain;
    Field x, b = {0};
    for (int p = 0; p < CHUNK; p++) x[p] = 10 + 4 * (p + 0.5) / (double)CHUNK;
    check_folded(x);
    folded_shape(&axis, 3, x, b, &folded), spline_shape(&axis, 3, x, b, &plain);
    for (int p = 0; p < CHUNK; p++)
        for (int k = 0; k < 3; k++) {
            if (x[p] > 10.5 && x[p] < 13.5)
                CHECK_CLOSE(folded.table[T_S][k][p], plain.table[T_S][k][p], 1e-15);
            if (x[p] < 10.5)
                CHECK_CLOSE(folded.table[T_S][k][p], k ? 1 - fabs(9 + k - x[p]) : 0, 1e-14);
        }
    for (int p = 0; p < CHUNK; p++) x[p] = p % 2 ? 10 - 0.02 * p : 14 + 0.02 * p;
    check_folded(x);
}

/* A method on folded splines takes a linear field to its particles exactly, next to the wall too.
 */
static void test_wall_field(void)
{
    const char *const scene[] = {"bar", "ring", "shell"};
    const Case c = {DIM, scene[DIM - 1], DIM < 3 ? 16 : 6, 0, 0, NULL};
    Fixture r;
    static Work w;
    CU_ASSERT_FATAL(fixture_plan(&r, &c, "bspline", CD, NULL));
    Sim *sim = fixture_sim(&r);
    CU_ASSERT(fixture_steps(&r, sim, 0, 50)); /* and it runs */
    for (int k = 0; DIM == 1 && k < sim->p.n / CHUNK; k++) {
        const Chunk chunk = sim_chunk(sim, k);
        make_stencils(sim, &chunk, &w);
        for (int p = 0; p < CHUNK; p++) {
            double L = 0;
            for (int i = 0; i < 3; i++) { /* v = x inside, 0 beyond the wall, as walls leave it */
                const double at = w.stencil[0].base[p] + i - sim->g.axis[0].wall_lo;
                L += w.stencil[0].table[T_G][i][p] * fmax(at, 0);
            }
            CHECK_CLOSE(L, 1, 1e-13);
        }
    }
    sim_free(sim);
}

static const TestCase tests[] = {
    {"a uniform velocity, every variant", test_constant},
    {"angular momentum where declared", test_turning},
    {"what rings: each step leaves 1 - pic of it", test_ringing},
    {"filter of order k", test_filter},
    {"higher orders and more FLIP damp less", test_damping},
    {"FLIP/PIC at its ends is FLIP and PIC", test_blend},
    {"folded weights reproduce linear fields up to the wall", test_folded},
    {"and so do the core's", test_wall_field},
    {NULL, NULL},
};
CHECK_SUITE(tests)
