/* test_moment_pass.c: the plug-in contract carries a pass that no method here was made for: moments
 * of a weighted-least-squares method (W11 eq 9) by the chunked loops, against plain sums. */
#include "common/core/passes.h"
#include "common/core/moments.h"
#include "tests/fixture.h"

/* Lane 0: sum W. Lanes 1 .. DIM: sum W r_d, r from the particle to the node. */
static Pattern moment_pattern(void)
{
    Pattern q = {0};
    for (int d = 0; d < DIM; d++)
        for (int l = 0; l < LANES; l++) q.e[d][T_S][l] = 1;
    for (int d = 0; d < DIM; d++) { /* lane 1 + d: R on axis d */
        q.e[d][T_S][1 + d] = 0;
        q.e[d][T_R][1 + d] = 1;
    }
    return q;
}

static void deposit_moments(Grid *g, const Work *w, const int width)
{
    const Pattern q = moment_pattern();
    const unsigned tables = 1u << T_G | 1u << T_R; /* several: the loop that takes any pattern */
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
    const Case block = {.problem = "free_block", .cells = 16};
    Fixture fixture;
    static Work w;
    CU_ASSERT_FATAL(fixture_plan(&fixture, &block, "bspline", CD, NULL));
    Sim *sim = fixture_sim(&fixture);
    sim_sort(sim);
    Grid *g = &sim->g;
    deposit_all(sim, 0, MOTION); /* clears the live spans and sets masses, taken off again */
    const int row = g->rows / 2, column = g->n[0] / 2;
    const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)column;
    const Line before = g->node[at];
    double sum[2] = {0};
    for (int chunk = 0; chunk < sim->p.n / CHUNK; chunk++) {
        const Chunk c = sim_chunk(sim, chunk);
        const int width = make_stencils(sim, &c, &w);
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
            sum[0] += W, sum[1] += W * r;
        }
    }
    const Line now = g->node[at] - before;
    CHECK_CLOSE(now[0], sum[0], 1e-13);
    CHECK_CLOSE(now[1], sum[1], 1e-13);
    CU_ASSERT(sum[0] > 0.5);
    sim_free(sim);
}

static const TestCase tests[] = {
    {"a least-squares moment pass fits", test_moments},
    {NULL, NULL},
};
CHECK_SUITE(tests)
