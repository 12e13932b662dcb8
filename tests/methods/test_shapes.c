/* test_shapes.c: what the weights of every method must do whatever they are (W07 section 2): add up
 * to one, reproduce positions, and have gradients that are their derivatives. */
#include "tests/fixture.h"

enum { ROUNDS = 200 };

/* Methods whose weights are products over the axes, which failures name. */
static bool has_shape(const Method *m)
{
    check_context(DIM, "none", m->info.name, "none", NULL);
    return m->shape;
}
#define FOR_PRODUCTS(m) FOR_METHODS(m) if (has_shape(*m))

/* Sums of a few weights round off by some ulp. Weights are differences over 2b: where a chunk is
 * wide and this particle narrow, that round-off is of order 1e-16/b. */
static double tolerance(double b)
{
    return 1e-14 * (1 + 0.1 / b);
}

static void shape(const Method *m, const Field x, const Field b, double widest, Stencil *s)
{
    const Axis open_axis = {.wall_lo = -INFINITY, .wall_hi = INFINITY};
    m->shape(&open_axis, m->width(widest), x, b, s);
}

/* sum S = 1, sum S (x_i - x) = 0, sum G = 0, sum G (x_i - x) = 1. */
static void check_sums(const Method *m, const Stencil *s, double widest, const Field x,
                       const Field b)
{
    const int width = m->width(widest);
    CU_ASSERT_FATAL(width <= MAX_WIDTH);
    for (int p = 0; p < CHUNK; p++) {
        double S = 0, Sr = 0, G = 0, Gr = 0, least = 0;
        for (int k = 0; k < width; k++) {
            const double r = s->base[p] + k - x[p];
            S += s->table[T_S][k][p], Sr += s->table[T_S][k][p] * r;
            G += s->table[T_G][k][p], Gr += s->table[T_G][k][p] * r;
            least = fmin(least, s->table[T_S][k][p]);
        }
        CHECK_CLOSE(S, 1, tolerance(b[p]));
        CHECK_CLOSE(Sr, 0, 3 * tolerance(b[p])); /* |r| < 3 */
        CHECK_CLOSE(G, 0, tolerance(b[p]));
        CHECK_CLOSE(Gr, 1, 3 * tolerance(b[p]));
        CU_ASSERT(least >= -tolerance(b[p]));
    }
}

/* Half widths up to half a cell, and in wide chunks up to the widest that stencils allow. */
static void test_sums(void)
{
    const double widest[] = {0.5, 0.8, 1, 2, (MAX_WIDTH - 5) / 2.0};
    Stencil s;
    Field x, b;
    FOR_PRODUCTS(m) for (int round = 0; round < ROUNDS; round++)
    {
        const double most = widest[round % COUNT(widest)];
        for (int p = 0; p < CHUNK; p++)
            x[p] = fixture_random(10, 20), b[p] = p ? fixture_random(1e-3, most) : most;
        shape(*m, x, b, most, &s);
        check_sums(*m, &s, most, x, b);
    }
}

/* Particles on nodes, on cell centres, and boxes that end on nodes. */
static void test_edges(void)
{
    const double half[] = {0.125, 0.25, 0.5, 1, 1.5, 2, 7, (MAX_WIDTH - 5) / 2.0};
    Stencil s;
    Field x, b;
    FOR_PRODUCTS(m) for (int k = 0; k < COUNT(half); k++)
    {
        for (int p = 0; p < CHUNK; p++) x[p] = 20 + p / 8.0 - 4, b[p] = half[k];
        shape(*m, x, b, half[k], &s);
        check_sums(*m, &s, half[k], x, b);
    }
}

/* Weight of the node at `node`, 0 beyond the stencil. */
static double weight_at(const Method *m, const Stencil *s, double widest, int table, int node,
                        int p)
{
    const int k = node - s->base[p];
    return k >= 0 && k < m->width(widest) ? s->table[table][k][p] : 0;
}

/* G = dS/dx by central differences: their error is e/b where the second derivative jumps, 1e-16/e/b
 * by round-off; a tent's corner, within e of a node, is left out. */
static void test_gradient(void)
{
    const double e = 1e-6, widest[] = {0.5, 2};
    Stencil s, up, down;
    Field x, xu, xd, b;
    FOR_PRODUCTS(m) for (int round = 0; round < ROUNDS; round++)
    {
        if ((*m)->slopes_fitted) continue; /* which are no derivatives */
        const double most = widest[round % 2];
        for (int p = 0; p < CHUNK; p++) {
            x[p] = floor(fixture_random(10, 20)) + fixture_random(0.001, 0.999);
            xu[p] = x[p] + e, xd[p] = x[p] - e, b[p] = fixture_random(0.05, most);
        }
        shape(*m, x, b, most, &s), shape(*m, xu, b, most, &up), shape(*m, xd, b, most, &down);
        for (int p = 0; p < CHUNK; p++)
            for (int i = (int)x[p] - 4; i <= (int)x[p] + 5; i++)
                CHECK_CLOSE(
                    weight_at(*m, &s, most, T_G, i, p),
                    (weight_at(*m, &up, most, T_S, i, p) - weight_at(*m, &down, most, T_S, i, p)) /
                        (2 * e),
                    1e-4);
    }
}

/* Narrow and wide stencils give the same weights: which one a particle gets depends on its chunk.
 */
static void test_width_is_free(void)
{
    Stencil narrow, wide;
    Field x, b;
    for (int p = 0; p < CHUNK; p++) x[p] = fixture_random(10, 20), b[p] = fixture_random(0.01, 0.5);
    FOR_PRODUCTS(m)
    {
        shape(*m, x, b, 0.5, &narrow), shape(*m, x, b, 2, &wide);
        for (int p = 0; p < CHUNK; p++)
            for (int t = T_S; t <= T_G; t++)
                for (int i = (int)x[p] - 4; i <= (int)x[p] + 5; i++)
                    CHECK_CLOSE(weight_at(*m, &narrow, 0.5, t, i, p),
                                weight_at(*m, &wide, 2, t, i, p), tolerance(b[p]));
    }
}

/* GIMP by hand: S(0) = 1 - b/2 and S(1/2) = 1/2 for b <= 1/2; at b = 1 S(0) = 1/2, S(1) = 1/4. */
static void test_known_values(void)
{
    static const struct {
        double x, b, S, G;
    } known[] = {{0, 0.25, 0.875, 0}, {0.5, 0.25, 0.5, -1}, {1, 0.25, 0.0625, -0.5},
                 {0, 1, 0.5, 0},      {1, 1, 0.25, -0.5},   {-1, 0.25, 0.0625, 0.5},
                 {1.25, 0.25, 0, 0},  {0, 0.5, 0.75, 0}};
    double S, G;
    for (int k = 0; k < COUNT(known); k++) {
        CU_ASSERT_FATAL(ENGINE_NAME.weight("gimp", known[k].x, known[k].b, &S, &G) == 0);
        CHECK_CLOSE(S, known[k].S, 1e-15);
        CHECK_CLOSE(G, known[k].G, 1e-15);
    }
    CU_ASSERT(ENGINE_NAME.weight("mpm", 0.3, 0.25, &S, &G) == 0);
    CHECK_CLOSE(S, 0.7, 1e-14); /* computed at 33.3: 7e-15 */
    for (const Method *const *m = methods; *m; m++)
        CU_ASSERT(ENGINE_NAME.weight((*m)->info.name, 0.3, 0.25, &S, &G) == ((*m)->list ? 1 : 0));
    CU_ASSERT(ENGINE_NAME.weight("fem", 0.3, 0.25, &S, &G) < 0);
    CU_ASSERT(ENGINE_NAME.weight("no such method", 0.3, 0.25, &S, &G) < 0);
}

static const TestCase tests[] = {
    {"partition of unity, positions, gradients add to nothing", test_sums},
    {"the same on nodes and edges", test_edges},
    {"gradients are derivatives", test_gradient},
    {"weights do not depend on the stencil's width", test_width_is_free},
    {"values by hand", test_known_values},
    {NULL, NULL},
};
CHECK_SUITE(tests)
