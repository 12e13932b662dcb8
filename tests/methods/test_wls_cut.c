/* test_wls_cut.c: GE-WLS at cut surfaces: velocities linear in space reach every node; forces of
 * spurious nodes go, with average=folded, to good nodes and to walls, and nowhere else; distances
 * from surface points. In every dimension. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "common/core/passes.h"
#include "methods/wls/wls.h"
#include "tests/fixture.h"

static const Case block = {.dim = DIM, .problem = "block", .cells = DIM < 3 ? 16 : 6};

/* Off the grid's lines and turned: all cells of its edge are cut. */
static const char *const askew[] = {"dim=1;offset_x=.3", "dim=2;offset_x=.3;offset_y=.2;angle=20",
                                    "dim=3;offset_x=.3;offset_y=.2;offset_z=.1;angle=20"};

/* v = (1, ..) + B x is exact at every node within reach of a particle, spurious ones included,
 * whatever is corrected. */
static void check_affine(const char *method, const char *set)
{
    static const double B[3][3] = {{0.7, -0.4, 0.2}, {0.3, 1.1, -0.5}, {0.6, -0.2, 0.9}};
    Fixture r;
    char both[192];
    snprintf(both, sizeof both, "layout=radial;%s;%s", askew[DIM - 1], set);
    CU_ASSERT_FATAL(fixture_plan(&r, &block, method, CD, both));
    Sim *sim = fixture_sim(&r);
    sim_sort(sim);
    const double dx = sim->dx;
    const Particles *p = &sim->p;
    for (int s = 0; s < p->n; s++)
        for (int a = 0; a < DIM; a++) {
            p->field[AT_V + a][s] = 1;
            for (int b = 0; b < DIM; b++) {
                p->field[AT_V + a][s] += B[a][b] * p->field[AT_X + b][s];
                if (p->field[AT_L]) p->field[AT_L + a * DIM + b][s] = B[a][b];
            }
        }
    CU_ASSERT(sim_project(sim).code == OK);
    const Grid *g = &sim->g;
    int spurious = 0, seen = 0;
    for (int row = 0; row < g->rows; row++)
        for (int i = g->lo[row]; i < g->hi[row]; i++) {
            const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
            double x[DIM] = {(i + g->origin[0]) * dx};
            for (int d = 1, rest = row; d < DIM; d++, rest /= g->n[d - 1])
                x[d] = (rest % g->n[d] + g->origin[d]) * dx;
            if (!(wls_of(sim)->fit[at][FIT_MOMENTS][M_ONE] > 0)) continue;
            seen++;
            spurious += !wls_of(sim)->good[at];
            for (int a = 0; a < DIM; a++) {
                double v = 1;
                for (int b = 0; b < DIM; b++) v += B[a][b] * x[b];
                CHECK_CLOSE(g->node[at][a], v, 1e-13 * fabs(v));
            }
        }
    CU_ASSERT(spurious > 0 && seen > block.cells);
    sim_free(sim);
}

static void test_affine(void)
{
    static const char *const set[] = {"hermite=0", "hermite=2", "hermite=1000", "hermite=1e6",
                                      "mass=lumped;hermite=1000"};
    for (int k = 0; k < COUNT(set); k++) check_affine("ge_wls", set[k]);
    check_affine("wls2", "");
}

/* The largest error of a distance from the curved surface of ring or shell [cells], at nodes where
 * the curvature is determined. */
static double distance_error(int cells)
{
    const Case c = {DIM, DIM < 3 ? "ring" : "shell", cells, 0, 0, NULL};
    double error = 0;
    int seen = 0;
    Fixture r;
    CU_ASSERT_FATAL(fixture_plan(&r, &c, "ge_wls", CD, NULL));
    Sim *sim = fixture_sim(&r);
    sim_sort(sim);
    deposit_all(sim, 0, FORCES);
    const Grid *g = &sim->g;
    const Wls *w = wls_of(sim);
    for (int row = 0; row < g->rows; row++)
        for (int i = g->lo[row]; i < g->hi[row]; i++) {
            const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
            int index[DIM];
            double sign[DIM], bends = 0;
            wls_index_of(g, row, i, index);
            for (int k = 0; k < BENDS; k++) bends += fabs(w->bend[at].kappa[k]);
            if (!(bends > 0) || mirror_image(g, index, sign) != at) continue;
            error = fmax(error, fabs(w->distance[at] - sim_distance(sim, index, 0)));
            seen++;
        }
    CU_ASSERT(seen > cells);
    sim_free(sim);
    return error;
}

/* The error is .32 h^2 cells in 2D, .31 h^2 in 3D (h = 1/cells): as a length, of third order. */
static void test_curved_distances(void)
{
    for (int cells = 8; DIM > 1 && cells <= 24; cells += 8)
        CU_ASSERT(distance_error(cells) < 0.35 / (cells * cells));
}

/* What surface points add to beta, summed over all nodes (W11 eq 13). */
static double surface_beta(const char *set)
{
    double beta = 0;
    Fixture r;
    CU_ASSERT_FATAL(fixture_plan(&r, &block, "wls", CD, set));
    Sim *sim = fixture_sim(&r);
    sim_sort(sim);
    wls_deposit(sim, wls_of(sim), 0, false);
    const Grid *g = &sim->g;
    for (int row = 0; row < g->rows; row++)
        for (int i = g->lo[row]; i < g->hi[row]; i++)
            beta +=
                wls_of(sim)->fit[(size_t)row * (size_t)g->n[0] + (size_t)i][FIT_MOMENTS][M_BETA];
    for (int s = 0; s < sim->p.n; s++) beta -= sim->p.field[AT_VOL][s] > 0 ? 2 : 0;
    sim_free(sim);
    return beta;
}

/* The surface's share of beta does not depend on how many points it has. */
static void test_surface_density(void)
{
    const double usual = surface_beta(NULL);
    CU_ASSERT(usual > 1);
    CHECK_CLOSE(surface_beta("surface_per_cell=4"), usual, 1e-11 * usual);
    CHECK_CLOSE(surface_beta("surface_per_cell=7"), usual, 1e-11 * usual);
}

/* Random forces on the nodes that pass theirs on; none on the others. Symmetry is not folded yet.
 */
static void set_spurious_forces(Sim *sim)
{
    const Grid *g = &sim->g;
    Wls *w = wls_of(sim);
    for (int row = 0; row < g->rows; row++)
        for (int i = g->lo[row]; i < g->hi[row]; i++) {
            const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
            const bool massive = g->node[at][0] > sim->mass_cut;
            const unsigned held = wls_held(g, row, i);
            if (w->good[at] && massive) w->good[at] |= SOUND;
            w->inertia[at] = (Inertia){{0}, {0}, {0}};
            for (int a = 0; a < DIM; a++) {
                if (g->force) g->force[at * DIM + (size_t)a] = 0;
                for (int b = 0; b < DIM; b++) g->node[at][FLUX + b * DIM + a] = 0;
                if (!w->good[at] && massive && !(held >> a & 1))
                    g->node[at][FLUX + a] = fixture_random(-1, 1);
            }
        }
}

/* Sums of the forces passed on by spurious nodes, received by good nodes, and by walls as impulse.
 */
typedef struct Folded {
    Vec given, taken, wall;
    double size;
} Folded;

static void add_folded(const Sim *sim, int row, int i, double dt, Folded *out)
{
    const Grid *g = &sim->g;
    const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
    const bool sound = wls_is_sound(sim, at);
    unsigned walls = g->hold[0][i];
    int index[DIM] = {i}, rest = row;
    double sign[DIM];
    for (int d = 1; d < DIM; d++, rest /= g->n[d - 1])
        index[d] = rest % g->n[d], walls |= g->hold[d][index[d]];
    if (mirror_image(g, index, sign) != at) return;
    for (int a = 0; a < DIM; a++) {
        const double real = g->node[at][1 + DIM];
        const double f = real / g->node[at][0] * wls_whole_force(g, at, a);
        if (sound) out->taken[a] += dt * real * wls_of(sim)->inertia[at].factor[I_A + a];
        if (!wls_of(sim)->good[at] && !walls && real > 0) out->given[a] += dt * f;
        if (!wls_of(sim)->good[at] && !walls && real > 0) out->size += fabs(dt * f);
    }
}

/* What spurious nodes give, their good neighbours and the walls get. Counts
 * scenes in which some gave, and in which walls bore a part. */
static void check_folded(Fixture *r, int count[2])
{
    Sim *sim = fixture_sim(r);
    Grid *g = &sim->g;
    Folded sum = {{0}, {0}, {0}, 0};
    CU_ASSERT_FATAL(sim_project(sim).code == OK);
    deposit_all(sim, 0, FORCES);
    if (g->nmirror) mirror_fold(sim);
    set_spurious_forces(sim);
    memset(g->impulse, 0, (size_t)g->rows * sizeof *g->impulse);
    wls_spread(sim, r->dt);
    for (int row = 0; row < g->rows; row++)
        for (int i = g->lo[row]; i < g->hi[row]; i++) add_folded(sim, row, i, r->dt, &sum);
    double borne = 0;
    for (int a = 0; a < DIM; a++) {
        for (int row = 0; row < g->rows; row++) sum.wall[a] -= g->impulse[row][a];
        CHECK_CLOSE(sum.taken[a] + sum.wall[a], sum.given[a], 1e-12 * sum.size);
        borne += fabs(sum.wall[a]);
    }
    count[0] += sum.size > 0;
    count[1] += borne > 1e-6 * sum.size;
    sim_free(sim);
}

/* Walls, symmetry lines, free bodies; tops held where a free side meets them. */
static const Case scenes[] = {
    {1, "sine_bar", 16, 2, 0, NULL},    {1, "bar", 40, 2, 0, NULL},
    {1, "column", 19, 2, 0, "dim=1"},   {2, "axis_mms", 8, 4, 0, NULL},
    {2, "ring", 8, 4, 0, NULL},         {2, "disk_impact", 12, 4, 0, NULL},
    {2, "hanging_bar", 8, 4, 0, NULL},  {2, "column", 11, 4, 0, "dim=2"},
    {2, "free_block", 12, 4, 0, NULL},  {3, "shell", 6, 8, 0, NULL},
    {3, "ball_impact", 10, 8, 0, NULL}, {3, "free_block", 6, 8, 0, NULL}};

static void test_folded(void)
{
    int count[2] = {0, 0};
    for (int k = 0; k < COUNT(scenes); k++) {
        Fixture r;
        if (scenes[k].dim != DIM) continue;
        CU_ASSERT_FATAL(fixture_plan(&r, &scenes[k], "ge_wls", CD, NULL));
        check_folded(&r, count);
    }
    CU_ASSERT(DIM == 1 || count[0] >= 2); /* bars have no spurious nodes with mass */
    CU_ASSERT(DIM == 1 || count[1] >= 1);
}

static const TestCase tests[] = {
    {"velocities linear in space", test_affine},
    {"folded forces, given and taken", test_folded},
    {"distances from curved surfaces", test_curved_distances},
    {"denser surface points weigh less", test_surface_density},
    {NULL, NULL},
};
CHECK_SUITE(tests)
