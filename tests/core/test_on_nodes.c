/* test_on_nodes.c: tents and particles on nodes: what the rule of common/core/on_node.c promises,
 * and what WLS does instead. Without it L = -v/h in a body that drifts, and momentum is not
 * conserved. (Mirrored bodies, threads: test_invariants.c; walls, symmetry lines: test_textbook.c.)
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/fixture.h"

static const double speed = 100; /* the block's c [m/s] */

/* Whose weights are tents in this dimension; WLS's when it returns with them. */
static const char *const tents[] = {"mpm", "ge_mpm", "wls", "wls2", "ge_wls"};
enum { WLS = 2, TENTS = COUNT(tents), CELLS = IN_THIS_DIM(8, 8, 4) };

/* `set` with a leading '1': one particle per cell. */
static double *block_state(double cells, const char *method, Integrator i, const char *set,
                           int steps, int *n)
{
    Fixture r;
    const bool one = set[0] == '1', wls = strstr(method, "wls");
    const Case c = {DIM, "block", cells, one ? 1 : 0, 0.3, set + one};
    CU_ASSERT_FATAL(fixture_plan(&r, &c, method, i,
                                 wls ? "allow_unstable=1;return=linear" : "allow_unstable=1"));
    Sim *sim = fixture_sim(&r);
    CU_ASSERT(fixture_steps(&r, sim, 0, steps));
    double *s = fixture_state(sim);
    *n = sim->p.count;
    sim_free(sim);
    return s;
}

/* A body that only drifts: F stays 1, v as it is. Offsets put its edge on a node, or a round-off
 * beside it, or its corner so near one that the node's mass is no more than the product of two
 * small weights. A drift of 5/6 c goes from node to node in four steps. */
static void test_drift_on_nodes(void)
{
    static const char *const set[] = {
        "offset_x=0.25;drift_x=0.1",
        "offset_x=-0.25;drift_x=-0.1;offset_y=0.25",
        "drift_x=0.8333333333333334;drift_y=-0.8333333333333334;box=5",
        "offset_x=0.2500000000000004;drift_x=1e-13;offset_y=-0.2500000000000004",
        "offset_x=0.2499999;offset_y=0.2499999;drift_x=1e-9;drift_y=0.1",
        "1offset_x=0.5;offset_y=0.5;drift_x=0.1",
    };
    for (int k = 0; k < COUNT(set); k++)
        for (int m = 0; m < TENTS; m++) FOR_INTEGRATORS(i)
            {
                int n;
                if (DIM > 2 && i > UVF) continue; /* one pass and two, for time */
                double *s = block_state(k % 2 ? CELLS : 4, tents[m], i, set[k], 20, &n);
                /* WLS multiplies round-off (H-2): with one particle per cell 1.7e-13 at -O1 */
                const double least = m == WLS && set[k][0] == '1' ? 1e-12 : 1e-13;
                for (int p = 0; p < n; p++) {
                    for (int d = 0; d < NMAT; d++)
                        CHECK_CLOSE(s[(AT_F + d) * n + p], d % (DIM + 1) == 0, least);
                    CHECK_CLOSE(s[AT_V * n + p], s[AT_V * n], 1e-12 * speed);
                }
                free(s);
            }
}

/* The same as a run says it: no error, no growth. */
static void test_drift_row(void)
{
    Row row = row_empty();
    Fault fault = {0};
    const Case c = {DIM, "block", 16, 0, 0, "drift_x=0.5"};
    const RunSpec spec = fixture_spec(&c, "mpm", "cd", NULL);
    CU_ASSERT_FATAL(run_spec(&spec, &row, &fault) == 0);
    CHECK_TEXT(row.status, "ok");
    CU_ASSERT(row.error_linf < 1e-13);
}

/* A free body under stress, at rest: its momentum stays nothing, whatever lies on nodes. */
static void test_stress_on_nodes(void)
{
    static const char *const set[] = {
        "stretch=1.5;offset_x=0.375",
        "stretch=1.5;offset_x=-0.375;offset_y=0.25",
        "stretch=2;offset_x=0.5",
        "stretch=1.2;offset_x=0.2;offset_y=0.25",
        "stretch=1.1;offset_x=0.2249999;offset_y=0.2499999",
        "stretch=0.5",
        "1stretch=1.5;offset_x=0.25;offset_y=0.5",
        "1stretch=4",
    };
    for (int k = 0; k < COUNT(set); k++)
        for (int ge = 0; ge < 2; ge++) FOR_INTEGRATORS(i)
            {
                int n;
                double *s = block_state(4, ge ? "ge_mpm" : "mpm", i, set[k], 1, &n);
                for (int d = 0; d < DIM; d++) {
                    double sum = 0;
                    for (int p = 0; p < n; p++) sum += s[AT_M * n + p] * s[(AT_V + d) * n + p];
                    CHECK_CLOSE(sum, 0, 1e-12 * speed);
                }
                free(s);
            }
}

/* A body that turns or stretches, its velocity carried by GE: L is that of the motion, to
 * round-off, on nodes and off, at corners and edges. */
static void test_linear_on_nodes(void)
{
    static const char *const at[] = {"offset_x=0.25", "offset_x=0.25;offset_y=0.25",
                                     "1offset_x=0.5;offset_y=-0.5",
                                     "offset_x=-0.25;offset_y=0.2499999"};
    for (int k = 0; k < COUNT(at); k++)
        for (int turn = 0; turn < (DIM > 1 ? 2 : 1); turn++) {
            int n;
            char set[128];
            snprintf(set, sizeof set, "%s;%s", at[k], turn ? "spin=0.5" : "rate=0.5");
            double *s = block_state(CELLS, "ge_mpm", USL, set, 1, &n);
            const double w = 0.5 * speed;
            for (int p = 0; p < n; p++)
                for (int a = 0; a < DIM; a++)
                    for (int b = 0; b < DIM; b++) {
                        const double spin = a < 2 && b < 2 ? (b - a) * -w : 0, /* about z */
                            L = turn         ? spin
                                : a + b == 0 ? w
                                             : 0;
                        CHECK_CLOSE(s[(AT_L + a * DIM + b) * n + p], L, 1e-10 * w);
                    }
            free(s);
        }
}

/* WLS gives a particle on a node the slope of the cell above it. All nodes of a cell that holds a
 * particle have velocities, spurious ones by extrapolation (wls: by their mean, which is exact only
 * in translation), so that this is the motion's, too. F after a step is GE-MPM's, tested above. */
static void test_wls_linear_on_nodes(void)
{
    static const char *const at[] = {"offset_x=0.25", "offset_x=0.25;offset_y=0.25",
                                     "offset_x=-0.25;offset_y=0.2499999"};
    for (int k = 0; k < COUNT(at); k++)
        for (int turn = 0; turn < (DIM > 1 ? 2 : 1); turn++)
            for (int m = WLS + 1; m < TENTS; m++) {
                int n, others;
                char set[128];
                snprintf(set, sizeof set, "%s;%s", at[k], turn ? "spin=0.5" : "rate=0.5");
                double *want = block_state(CELLS, "ge_mpm", USL, set, 1, &others);
                double *s = block_state(CELLS, tents[m], USL, set, 1, &n);
                for (int d = 0; d < NMAT; d++)
                    for (int p = 0; p < n; p++)
                        CHECK_CLOSE(s[(AT_F + d) * n + p], want[(AT_F + d) * others], 1e-13);
                free(s), free(want);
            }
}

/* What a stressed block gains in a step is the integrals' error (wls.h), not the node's: it is the
 * same for a block that lies a little beside, on either side. (In 3D no plane of symmetry is a
 * plane of nodes: there eq 17, the length of the mean of surface points with a sign, is not
 * continuous; and less stretch: edges and corners under 1.5 may invert ge_wls at once with
 * return=linear.) */
static void test_wls_stress_on_nodes(void)
{
#define AT_STRETCH                                                                                 \
    "stretch=" IN_THIS_DIM("1.5", "1.5", "1.1;offset_z=0.1") ";offset_y=0.25;offset_x="
    static const char *const at[] = {AT_STRETCH "0.37499999", AT_STRETCH "0.375",
                                     AT_STRETCH "0.37500001"};
    for (int m = WLS; m < TENTS; m++) {
        double gain[COUNT(at)] = {0}, size = 0;
        for (int k = 0; k < COUNT(at); k++) {
            int n;
            double *s = block_state(8, tents[m], USL, at[k], 1, &n);
            for (int p = 0; p < n; p++) gain[k] += s[AT_M * n + p] * s[AT_V * n + p];
            for (int p = 0; p < n; p++) size += s[AT_M * n + p] * fabs(s[AT_V * n + p]) / COUNT(at);
            free(s);
        }
        CU_ASSERT(size > 1e-3 * speed);
        CHECK_CLOSE(gain[0], gain[1], 1e-5 * size);
        CHECK_CLOSE(gain[2], gain[1], 1e-5 * size);
    }
}

static const TestCase tests[] = {
    {"a drifting body", test_drift_on_nodes},
    {"the same, a whole run", test_drift_row},
    {"a stressed body", test_stress_on_nodes},
    {"linear motion", test_linear_on_nodes},
    {"WLS: linear motion", test_wls_linear_on_nodes},
    {"WLS: a stressed body", test_wls_stress_on_nodes},
    {NULL, NULL},
};
CHECK_SUITE(tests)
