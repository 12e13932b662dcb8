/* test_wls_hard.c: bodies that ask too much of WLS: whatever happens has a name, and is counted. */
#include <stdlib.h>
#include "common/contract/layout.h"
#include "methods/wls/wls.h"
#include "wls_check.h"

extern const Method method_wls, method_wls2, method_ge_wls;

#define H 16 /* cells per unit length */

/* Points of a lattice of `n` an axis and cell within lo .. hi where `keep` says so. */
static void lattice(Layout *out, const Vec lo, const Vec hi, double n, bool (*keep)(const Vec X))
{
    const double s = 1 / (n * H);
    for (double y = lo[1] + 0.5 * s; y < hi[1]; y += s)
        for (double x = lo[0] + 0.5 * s; x < hi[0]; x += s)
            if (!keep || keep((Vec){x, y})) layout_add(out, (Vec){x, y}, s * s, NULL);
}

/* Surface points from a to b, outward normal to the right of the way. */
static void edge(Layout *out, const Vec a, const Vec b)
{
    const double dx = b[0] - a[0], dy = b[1] - a[1], length = hypot(dx, dy);
    const int n = (int)ceil(2 * H * length);
    for (int k = 0; k < n; k++) {
        const double f = (k + 0.5) / n;
        layout_add(out, (Vec){a[0] + f * dx, a[1] + f * dy}, 0, (Vec){dy / length, -dx / length});
    }
}

static void box_edges(Layout *out, const Vec lo, const Vec hi, int edges)
{
    const Vec corner[5] = {
        {lo[0], lo[1]}, {hi[0], lo[1]}, {hi[0], hi[1]}, {lo[0], hi[1]}, {lo[0], lo[1]}};
    for (int k = 0; k < edges; k++) edge(out, corner[k], corner[k + 1]);
}

/* .7 of a cell wide: both surfaces in one cell. */
static bool strip(const Scene *s, double spacing, bool fitted, Layout *out)
{
    const Vec lo = {0.3, 0.51}, hi = {0.9, 0.51 + 0.7 / H};
    (void)s, (void)spacing, (void)fitted;
    lattice(out, lo, hi, 2, NULL);
    box_edges(out, lo, hi, 4);
    return true;
}

static bool in_wedge(const Vec X)
{
    return X[1] - 0.4 < 0.2 * (X[0] - 0.2);
}

static bool wedge(const Scene *s, double spacing, bool fitted, Layout *out)
{
    const Vec tip = {0.2, 0.4}, foot = {1, 0.4}, head = {1, 0.56};
    (void)s, (void)spacing, (void)fitted;
    lattice(out, tip, (Vec){1, 0.56}, 2, in_wedge);
    edge(out, tip, foot), edge(out, foot, head), edge(out, head, tip);
    return true;
}

/* A slit of a third of a cell between two blocks. */
static bool slit(const Scene *s, double spacing, bool fitted, Layout *out)
{
    const double x = 0.61, gap = 0.33 / H;
    (void)s, (void)spacing, (void)fitted;
    lattice(out, (Vec){0.3, 0.3}, (Vec){x, 0.7}, 2, NULL);
    lattice(out, (Vec){x + gap, 0.3}, (Vec){0.95, 0.7}, 2, NULL);
    box_edges(out, (Vec){0.3, 0.3}, (Vec){x, 0.7}, 4);
    box_edges(out, (Vec){x + gap, 0.3}, (Vec){0.95, 0.7}, 4);
    return true;
}

static bool outside_hole(const Vec X)
{
    return hypot(X[0] - 0.6, X[1] - 0.5) > 2.5 / H;
}

/* Particles are missing, no surface says so, and one side of the body has no surface points. */
static bool gaps(const Scene *s, double spacing, bool fitted, Layout *out)
{
    const Vec lo = {0.3, 0.3}, hi = {0.9, 0.8};
    (void)s, (void)spacing, (void)fitted;
    lattice(out, lo, hi, 2, outside_hole);
    box_edges(out, lo, hi, 3);
    return true;
}

/* One particle to four cells. */
static bool sparse(const Scene *s, double spacing, bool fitted, Layout *out)
{
    (void)s, (void)spacing, (void)fitted;
    lattice(out, (Vec){0.3, 0.3}, (Vec){0.9, 0.9}, 0.5, NULL);
    return true;
}

static bool lone(const Scene *s, double spacing, bool fitted, Layout *out)
{
    (void)s, (void)spacing, (void)fitted;
    layout_add(out, (Vec){0.51, 0.52}, 1e-3, NULL);
    return true;
}

static void swing(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    (void)u, (void)F, (void)L;
    for (int p = 0; p < n; p++) {
        v[0][p] = s->c * (0.02 + 0.05 * sin(7 * X[1][p]));
        v[1][p] = s->c * (0.03 * X[0][p] - 0.01);
    }
}

static void defaults(const Param *p, double value[])
{
    for (int k = 0; p[k].name; k++) value[k] = p[k].value;
}

/* What a Sim points to. */
typedef struct Case {
    Scene scene;
    double par[MAX_PARAMS];
    Setup setup;
} Case;

/* The body of `problem` with some four particles per cell; sorted. */
static Sim *set_up(const Method *method, const Problem *problem, Case *out)
{
    Fault fault = {0};
    Scene *s = &out->scene;
    *s = (Scene){.problem = problem,
                 .mat = material_make(NEO_HOOKEAN, 1e4, 0.3, 1),
                 .hi = {1.25, 1.25},
                 .body_lo = {0.2, 0.2},
                 .body_hi = {1, 1},
                 .error_scale = 1};
    s->c = material_wave_speed_bound(&s->mat);
    s->cell = 1.0 / H;
    defaults(method->info.params, out->par);
    out->setup = (Setup){.scene = s,
                         .method = method,
                         .method_par = out->par,
                         .cells = H,
                         .ppc = 4,
                         .fitted = true,
                         .threads = 1};
    check_context(DIM, problem->info.name, method->info.name, NULL, NULL);
    Sim *sim = sim_new(&out->setup, &fault);
    CU_ASSERT_PTR_NOT_NULL_FATAL(sim);
    sim_sort(sim);
    return sim;
}

/* Steps until something fails, at most 60; every state in between must be made of numbers. */
static long endure(const Method *method, const Problem *problem, StatusCode *end)
{
    Case c;
    Sim *sim = set_up(method, problem, &c);
    *end = OK;
    for (int k = 0; k < 60 && *end == OK; k++) {
        const double dt = 0.3 * c.scene.cell / c.scene.c;
        *end = sim_step(sim, k * dt, dt, k == 0).code;
        for (int f = 0; f < AT_M; f++)
            for (int p = 0; p < sim->p.n; p++) CU_ASSERT(isfinite(sim->p.field[f][p]));
    }
    const long fallbacks = sim->fallbacks;
    sim_free(sim);
    return fallbacks;
}

static void test_hard(void)
{
    static const struct {
        const char *name;
        bool (*place)(const Scene *s, double spacing, bool fitted, Layout *out);
    } cases[] = {{"strip", strip}, {"wedge", wedge},   {"slit", slit},
                 {"gaps", gaps},   {"sparse", sparse}, {"lone", lone}};
    const Method *const all[] = {&method_wls, &method_wls2, &method_ge_wls};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
        for (int m = 0; m < 3; m++) {
            const Problem problem = {
                .info = {.name = cases[k].name}, .start = swing, .place = cases[k].place};
            StatusCode end;
            const long fallbacks = endure(all[m], &problem, &end);
            CU_ASSERT(end != NOT_A_NUMBER);
            CU_ASSERT((end == SINGULAR) == (cases[k].place == lone || cases[k].place == sparse));
            CU_ASSERT(fallbacks > 0);
        }
}

/* A block, and so few particles beside it that eq 14 finds no inside, and no cell there has mass.
 */
static bool thin(const Scene *s, double spacing, bool fitted, Layout *out)
{
    (void)s, (void)spacing, (void)fitted;
    lattice(out, (Vec){0.2, 0.2}, (Vec){0.3, 1}, 2, NULL);
    lattice(out, (Vec){0.5, 0.2}, (Vec){1.2, 1}, 1 / 1.2, NULL);
    return true;
}

static void shear(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    (void)u, (void)F;
    for (int p = 0; p < n; p++) {
        L[1][p] = 0.1 * s->c;
        L[2][p] = 0.03 * s->c;
        v[0][p] = 0.02 * s->c + L[1][p] * X[1][p];
        v[1][p] = L[2][p] * X[0][p];
    }
}

/* Without mass, but with particles, nodes go where these go. */
static void test_thin(void)
{
    const Method *const all[] = {&method_wls, &method_wls2, &method_ge_wls};
    const Problem problem = {.info = {.name = "thin"}, .start = shear, .place = thin};
    for (int m = 0; m < 3; m++) {
        Case c;
        Sim *sim = set_up(all[m], &problem, &c);
        const double dt = 0.1 * c.scene.cell / c.scene.c, speed = c.scene.c;
        int inner = 0;
        CU_ASSERT(sim_step(sim, 0, dt, true).code == OK);
        for (int p = 0; p < sim->p.n; p++) {
            const double *const *f = (const double *const *)sim->p.field;
            const double X[2] = {f[AT_X0][p], f[AT_X0 + 1][p]};
            if (fmax(fabs(X[0] - 0.85), fabs(X[1] - 0.6)) > 0.2) continue;
            CU_ASSERT_DOUBLE_EQUAL(f[AT_X][p], X[0] + dt * speed * (0.02 + 0.1 * X[1]), 1e-14);
            CU_ASSERT_DOUBLE_EQUAL(f[AT_X + 1][p], X[1] + dt * speed * 0.03 * X[0], 1e-14);
            CU_ASSERT_DOUBLE_EQUAL(f[AT_F + 1][p], 0.1 * dt * speed, 1e-13);
            inner++;
        }
        CU_ASSERT(inner > 20);
        CU_ASSERT(sim->fallbacks > 0);
        sim_free(sim);
    }
}

/* Force over mass of the sound nodes around node `at`; returns their number. */
static int neighbours_move(const Sim *sim, size_t at, Vec acc)
{
    const Grid *g = &sim->g;
    double mass = 0;
    int n = 0;
    for (int a = 0; a < DIM; a++) acc[a] = 0;
    for (int k = 0; k < 9; k++) {
        const size_t j =
            at + (size_t)(k / 3) * (size_t)g->n[0] + (size_t)(k % 3) - (size_t)g->n[0] - 1;
        if (!wls_is_sound(sim, j)) continue;
        n++;
        mass += g->node[j][0];
        for (int a = 0; a < DIM; a++)
            acc[a] += g->node[j][FLUX + a] + g->force[j * DIM + (size_t)a];
    }
    for (int a = 0; a < DIM && n; a++) acc[a] /= mass;
    return n;
}

/* A node under a particle that no cell gave mass moves with a = sum f / sum m of the sound ones. */
static void test_massless(void)
{
    Trial t;
    int massless = 0;
    trial_open(&t, "ring", "wls2", 12, "sector=full,offset_x=.3,offset_y=.1", 1);
    const Grid *g = &t.sim->g;
    const size_t n = (size_t)g->rows * (size_t)g->n[0];
    bool *light = calloc(n, sizeof *light);
    for (size_t at = 0; at < n; at++) g->node[at] = (Line){0};
    for (size_t k = 0; k < n * DIM; k++) g->force[k] = 0;
    wls_assemble(t.sim, 0, true);
    for (size_t at = 0; at < n; at++) light[at] = !(g->node[at][0] > t.sim->mass_cut);
    wls_repair(t.sim, 1e-4);
    for (int row = 1; row + 1 < g->rows; row++)
        for (int i = g->lo[row]; i < g->hi[row]; i++) {
            const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
            Vec acc;
            if (!light[at] || !(wls_of(t.sim)->fit[at][FIT_MOMENTS][M_ONE] > 0)) continue;
            if (!neighbours_move(t.sim, at, acc)) continue;
            massless++;
            for (int a = 0; a < DIM; a++)
                CHECK_CLOSE(g->node[at][FLUX + a] / g->node[at][0], acc[a], 1e-9 * fabs(acc[a]));
        }
    CU_ASSERT(massless > 10);
    free(light);
    trial_close(&t);
}

static const TestCase tests[] = {
    {"thin strip, sharp corner, slit, gaps, too few: named ends, counted", test_hard},
    {"so few particles that no cell has mass: nodes still move with them", test_thin},
    {"nodes without mass move with their neighbours", test_massless},
    {NULL, NULL},
};
CHECK_SUITE(tests)
