/* test_exact.c: what methods must reproduce exactly, on scenes made for it: linear fields, uniform
 * stretch of contiguous boxes, free fall. In every dimension. */
#include <stdlib.h>
#include "common/contract/layout.h"
#include "tests/fixture.h"

/* ---- a linear velocity field on particles thrown at random into a box */
static const double slope[3][3] = {{2, -3, 0.7}, {1.3, 0.4, -2}, {-0.6, 2.2, 1.1}};
static const double offset[3] = {5, -4, 6};

static int box_init(Scene *s, char why[128])
{
    (void)why;
    s->mat = material_make(NEO_HOOKEAN, 1e4, DIM == 1 ? 0 : 0.3, 2);
    for (int d = 0; d < DIM; d++) s->hi[d] = 6, s->body_lo[d] = 1, s->body_hi[d] = 2;
    s->c = material_wave_speed_bound(&s->mat);
    s->error_scale = 1;
    return 0;
}

static bool throw_in(const Scene *s, double spacing, bool fitted, Layout *out)
{
    (void)spacing, (void)fitted;
    for (int k = 0; k < 500; k++) {
        Vec X;
        for (int d = 0; d < DIM; d++) X[d] = fixture_random(s->body_lo[d], s->body_hi[d]);
        layout_add(out, X, fixture_random(0.001, 0.01), NULL);
    }
    return true;
}

static double field(int a, const Vec x)
{
    double v = offset[a];
    for (int b = 0; b < DIM; b++) v += slope[a][b] * x[b];
    return v;
}

static void linear_start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F,
                         Fields L)
{
    (void)s, (void)u, (void)F;
    for (int p = 0; p < n; p++) {
        Vec x;
        for (int d = 0; d < DIM; d++) x[d] = X[d][p];
        for (int a = 0; a < DIM; a++) {
            v[a][p] = field(a, x);
            for (int b = 0; b < DIM; b++) L[a * DIM + b][p] = slope[a][b];
        }
    }
}

static const Problem thrown = {
    .cfl = 0.1, .init = box_init, .place = throw_in, .start = linear_start};

/* Cells a length: eight particles or more in each of theirs, so that WLS finds an inside. */
enum { THROWN_CELLS = DIM < 3 ? 8 : 3 };

/* Largest error of a node's velocity after a projection. */
static double projection_error(Fixture *r)
{
    Nodes nodes;
    double worst = 0;
    void *core = particle_solver.make(&r->plan.setup, &r->fault);
    CU_ASSERT_PTR_NOT_NULL_FATAL(core);
    CU_ASSERT(particle_solver.project(core).code == OK);
    particle_solver.nodes(core, &nodes);
    CU_ASSERT(nodes.n > 8);
    for (int i = 0; i < nodes.n; i++) {
        Vec x;
        for (int d = 0; d < DIM; d++) x[d] = nodes.x[d][i];
        for (int a = 0; a < DIM; a++) worst = fmax(worst, fabs(nodes.v[a][i] - field(a, x)));
    }
    particle_solver.free(core);
    return worst;
}

/* Every node with mass, edges too; |v| is about 10. What is not exact by design must fail here. */
static void test_linear_field(void)
{
    FOR_METHODS(m) for (int ppc = 1; ppc <= 4; ppc++)
    {
        Fixture r;
        fixture_scene(&r, &thrown, *m, CD, THROWN_CELLS, pow(ppc, DIM));
        const double error = projection_error(&r);
        /* exact but at spurious nodes; from the exact gradient that the scene starts with */
        const bool by_chance = (*m)->surface || (*m)->affine;
        CU_ASSERT((*m)->linear_exact ? error < 1e-13 * 20 : error > 1e-2 || by_chance);
    }
}

/* F = I + dt A after a step of free flight in that field, within the body. */
static void test_gradient_of_field(void)
{
    FOR_METHODS(m)
    {
        Fixture r;
        if (!(*m)->linear_exact) continue;
        fixture_scene(&r, &thrown, *m, CD, THROWN_CELLS, pow(2, DIM));
        r.plan.scene.mat = material_make(NEO_HOOKEAN, 1e-20, 0, 2);
        r.dt = 1e-2;
        Sim *sim = fixture_sim(&r);
        CU_ASSERT_FATAL(fixture_steps(&r, sim, 0, 1));
        double *s = fixture_state(sim);
        const int n = sim->p.count;
        for (int k = 0; k < n; k++)
            for (int a = 0; a < DIM; a++)
                for (int b = 0; b < DIM; b++) {
                    const double F = (a == b) + r.dt * slope[a][b];
                    CHECK_CLOSE(s[(AT_F + a * DIM + b) * n + k], F, 1e-12);
                }
        free(s);
        sim_free(sim);
    }
}

/* ---- uniform stretch: boxes that follow F stay contiguous */
/* Stretches stand in scene->k. */
static void stretch_start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F,
                          Fields L)
{
    (void)v, (void)L;
    for (int d = 0; d < DIM; d++)
        for (int p = 0; p < n; p++) {
            u[d][p] = (s->k[d] - 1) * X[d][p];
            F[d * (DIM + 1)][p] = s->k[d];
        }
}

static const Problem stretched = {.cfl = 0.1, .init = box_init, .start = stretch_start};

static bool inside(const Fixture *r, const Vec x, double margin)
{
    const double *k = r->plan.scene.k;
    for (int d = 0; d < DIM; d++)
        if (x[d] < k[d] + margin || x[d] > 2 * k[d] - margin) return false;
    return true;
}

/* Do the weights depend on the particle's half width? */
static bool follows_F(const Method *m)
{
    double S, S2, G;
    return !ENGINE_NAME.weight(m->info.name, 0, 0.1, &S, &G) &&
           !ENGINE_NAME.weight(m->info.name, 0, 0.4, &S2, &G) && fabs(S - S2) > 1e-3;
}

/* A node one cell within the body then carries rho/J h^DIM, and feels no force. */
static void check_nodes(void *core, const Fixture *r)
{
    Nodes nodes;
    double J = 1, worst = 0;
    int within = 0;
    const double h = r->plan.scene.cell;
    for (int d = 0; d < DIM; d++) J *= r->plan.scene.k[d];
    const double mass = r->plan.scene.mat.rho / J * pow(h, DIM);
    particle_solver.nodes(core, &nodes);
    for (int i = 0; i < nodes.n; i++) {
        Vec x;
        for (int d = 0; d < DIM; d++) x[d] = nodes.x[d][i];
        if (!inside(r, x, h)) continue;
        worst = fmax(worst, fabs(nodes.m[i] / mass - 1));
        within++;
    }
    CU_ASSERT(within > 1);
    CU_ASSERT(worst < 1e-12);
}

/* Velocities after one step from rest, deep inside and at the edge. */
static void check_forces(const Sim *sim, const Fixture *r)
{
    double *s = fixture_state(sim), deep = 0, edge = 0;
    const int n = sim->p.count;
    for (int k = 0; k < n; k++) {
        Vec x;
        for (int d = 0; d < DIM; d++) x[d] = s[(AT_X + d) * n + k];
        double *worst = inside(r, x, 4.5 * r->plan.scene.cell) ? &deep : &edge;
        for (int d = 0; d < DIM; d++) *worst = fmax(*worst, fabs(s[(AT_V + d) * n + k]));
    }
    CU_ASSERT(edge > 1e-2);
    CU_ASSERT(deep < 1e-11 * edge);
    free(s);
}

static void test_contiguous(void)
{
    const double factors[] = {0.6, 1.37, 2.3};
    FOR_METHODS(m) for (int k = 0; k < COUNT(factors); k++)
    {
        Fixture r;
        if (!follows_F(*m)) continue;
        fixture_scene(&r, &stretched, *m, CD, 10, pow(2, DIM));
        for (int d = 0; d < DIM; d++) r.plan.scene.k[d] = factors[k] + 0.05 * d;
        void *core = particle_solver.make(&r.plan.setup, &r.fault);
        CU_ASSERT_PTR_NOT_NULL_FATAL(core);
        CU_ASSERT(particle_solver.project(core).code == OK);
        check_nodes(core, &r);
        particle_solver.free(core);
        if (k == 0) continue; /* shrunk to 6 cells: nothing is deep inside */
        Sim *sim = fixture_sim(&r);
        CU_ASSERT_FATAL(fixture_steps(&r, sim, 0, 1));
        check_forces(sim, &r);
        sim_free(sim);
    }
}

/* ---- free fall from rest (H-14) */
static const double gravity[3] = {-30, 20, 50};

static void fall(const Scene *s, int n, ConstFields X, double t, Fields b)
{
    (void)s, (void)X, (void)t;
    for (int d = 0; d < DIM; d++)
        for (int p = 0; p < n; p++) b[d][p] = gravity[d];
}

static const Problem falling = {.cfl = 0.3, .init = box_init, .body = fall};

/* x - X = g t^2/2 where velocities live half a step later (cd, uvf, musl); else g dt^2 n (n + 1)/2.
 */
static void check_fall(const Fixture *r, const Sim *sim, int steps)
{
    const Integrator I = r->plan.setup.integrator;
    const double n = steps, n2 = I == USL || I == USF ? n * (n + 1) : n * n;
    double *s = fixture_state(sim);
    const int count = sim->p.count;
    for (int d = 0; d < DIM; d++)
        for (int k = 0; k < count; k++)
            CHECK_CLOSE(s[(AT_X + d) * count + k] - s[(AT_X0 + d) * count + k],
                        0.5 * gravity[d] * r->dt * r->dt * n2, 1e-13);
    free(s);
}

static void test_fall(void)
{
    FOR_METHODS(m) FOR_INTEGRATORS(i)
    {
        const int steps = IN_THIS_DIM(40, 40, 16);
        Fixture r;
        if (!fixture_valid(*m, i, true)) continue;
        fixture_scene(&r, &falling, *m, i, IN_THIS_DIM(7, 7, 4), pow(2, DIM));
        r.plan.setup.refresh = !fixture_valid(*m, i, false);
        Sim *sim = fixture_sim(&r);
        CU_ASSERT_FATAL(fixture_steps(&r, sim, 0, steps));
        check_fall(&r, sim, steps);
        sim_free(sim);
    }
}

/* ---- a node of round-off weight: a strained particle, alone, that reaches scene->k[3] beyond a
 * node, by its centre (tents) or its edge */

static bool place_one(const Scene *s, double spacing, bool fitted, Layout *out)
{
    Vec X;
    (void)fitted;
    for (int d = 0; d < DIM; d++) X[d] = 1.5 + s->k[3] - s->k[4] * spacing;
    layout_add(out, X, pow(spacing, DIM), NULL);
    return true;
}

static void strained(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    (void)s, (void)X, (void)u, (void)v, (void)L;
    for (int d = 0; d < DIM; d++)
        for (int p = 0; p < n; p++) F[d * (DIM + 1)][p] = 1.1;
}

static const Problem alone = {.cfl = 0.1, .init = box_init, .place = place_one, .start = strained};

/* Its strain must not jump: a tent's far node of mass 1e-14 m would receive the whole force, and F
 * would change by 1e10; with smooth weights the force vanishes with the mass. Without that node F
 * changes by a few per cent. */
static void test_light_node(void)
{
    const double edge[] = {0, 0.5 * 1.1}; /* half a spacing, stretched */
    FOR_METHODS(m) for (int k = 0; k < COUNT(edge); k++)
    {
        Fixture r;
        fixture_scene(&r, &alone, *m, USL, IN_THIS_DIM(8, 8, 4), pow(2, DIM));
        r.plan.scene.k[3] = 1e-15, r.plan.scene.k[4] = edge[k];
        Sim *sim = fixture_sim(&r);
        const bool moved = fixture_steps(&r, sim, 0, 1); /* or it fills no cell */
        CU_ASSERT(moved || ((*m)->assemble && sim->status.code == SINGULAR));
        double *s = fixture_state(sim);
        for (int d = 0; d < DIM; d++) CHECK_CLOSE(s[AT_F + d * (DIM + 1)], 1.1, 0.2);
        free(s);
        sim_free(sim);
    }
}

static const TestCase tests[] = {
    {"gradient-enhanced methods reproduce linear fields from any particles", test_linear_field},
    {"and hand its gradient to F", test_gradient_of_field},
    {"stretched boxes stay contiguous: even mass, no force inside", test_contiguous},
    {"free fall", test_fall},
    {"a node of round-off weight moves nothing", test_light_node},
    {NULL, NULL},
};
CHECK_SUITE(tests)
