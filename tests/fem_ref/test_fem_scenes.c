/* test_fem_scenes.c: the FEM solver on scenes of the tests' own: static limit, impact, failures. */
#include "fem_check.h"

enum { SPIN, RAMP }; /* scene constants: w^2 [1/s^2], duration of the ramp [s] */

/* Centrifugal force, switched on smoothly. */
static void spin(const Scene *s, int n, ConstFields X, double t, Fields b)
{
    const double x = fmin(t / s->k[RAMP], 1);
    const double w2 = s->k[SPIN] * x * x * x * (10 - 15 * x + 6 * x * x);
    for (int p = 0; p < n; p++)
        for (int d = 0; d < DIM; d++) b[d][p] = w2 * X[d][p];
}

/* W11 5.2 */
static void start_thrown(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F,
                         Fields L)
{
    (void)s, (void)X, (void)u, (void)F, (void)L;
    for (int p = 0; p < n; p++) v[0][p] = 0.2, v[1][p] = -0.2;
}

static void start_turned_inside_out(const Scene *s, int n, ConstFields X, Fields u, Fields v,
                                    Fields F, Fields L)
{
    (void)s, (void)v, (void)F, (void)L;
    for (int p = 0; p < n; p++) u[0][p] = -2 * X[0][p];
}

static void no_number(const Scene *s, int n, ConstFields X, double t, Fields b)
{
    (void)s, (void)X;
    for (int p = 0; p < n; p++) b[0][p] = t > 0 ? NAN : 0;
}

static const Problem spinning = {.info = {.name = "spinning"}, .body = spin};
static const Problem thrown = {.info = {.name = "thrown"}, .start = start_thrown};
static const Problem inverted = {.info = {.name = "inverted"}, .start = start_turned_inside_out};
static const Problem poisoned = {.info = {.name = "poisoned"}, .body = no_number};

static Scene quarter_ring(const Problem *problem)
{
    Scene s = {
        .problem = problem,
        .mat = material_make(NEO_HOOKEAN, 1e4, 0.3, 1),
        .body_hi = {1, 1},
        .body = {BODY_RING, {0, 0}, 0.5, 1, 0, M_PI / 2},
        .wall = {{.axis = 0, .side = -1, .mirror = true}, {.axis = 1, .side = -1, .mirror = true}},
        .nwall = 2};
    s.c = material_wave_speed_p(&s.mat);
    return s;
}

/* Radial displacement of a thick cylinder that turns with w (plane strain, small strain): Lame's
 * solution with centrifugal force; Timoshenko & Goodier, Theory of Elasticity, art. 32, with E and
 * nu of plane stress replaced by E/(1 - nu^2), nu/(1 - nu). */
static double spinning_cylinder(const Material *m, double w2, double r)
{
    const double E = m->E / (1 - m->nu * m->nu), nu = m->nu / (1 - m->nu), a2 = 0.25, b2 = 1;
    const double common = (3 + nu) * (a2 + b2), hole = (3 + nu) * a2 * b2 / (r * r);
    const double radial = m->rho * w2 / 8 * (common - hole - (3 + nu) * r * r);
    const double hoop = m->rho * w2 / 8 * (common + hole - (1 + 3 * nu) * r * r);
    return r / E * (hoop - nu * radial);
}

/* Largest error of a slow ramp, relative to the largest displacement. The ramp lasts some 15
 * periods of the lowest mode, so that what is left is static; strains are 1e-5, so that it is
 * linear. */
static double static_error(int cells)
{
    Scene s = quarter_ring(&spinning);
    s.k[SPIN] = 0.1;
    s.k[RAMP] = 0.6;
    Fem *f = make(&s, cells, 1);
    const int n = (int)ceil(s.k[RAMP] / (0.5 * solver_fem.unit_dt(f)));
    double worst = 0, largest = 0;
    for (int k = 0; k < n; k++)
        CU_ASSERT_FATAL(solver_fem.step(f, k * s.k[RAMP] / n, s.k[RAMP] / n, k == 0).code == OK);
    for (int i = 0; i < f->nodes; i++) {
        double r = hypot(f->X[0][i], f->X[1][i]), u = spinning_cylinder(&s.mat, s.k[SPIN], r),
               off = 0;
        for (int d = 0; d < DIM; d++)
            off = hypot(off, f->x[d][i] - f->X[d][i] - u * f->X[d][i] / r);
        worst = fmax(worst, off);
        largest = fmax(largest, u);
    }
    solver_fem.free(f);
    return worst / largest;
}

static void test_static_limit(void)
{
    const double coarse = static_error(16), fine = static_error(32);
    CU_ASSERT(fine < 2.2e-3);
    CHECK_CLOSE(log2(coarse / fine), 2, 0.1);
}

/* A disk against a frictionless floor: no node below it, no sticking, all momentum from the floor,
 * and almost all energy back. */
static void test_impact(void)
{
    Scene s = {.problem = &thrown,
               .mat = material_make(NEO_HOOKEAN, 1000, 0.3, 1000),
               .body_lo = {0.1, 0.1},
               .body_hi = {0.5, 0.5},
               .body = {BODY_DISK, {0.3, 0.3}, 0, 0.2, 0, 2 * M_PI},
               .wall = {{.axis = 1, .side = -1, .at = 0, .hold = 2}},
               .nwall = 1};
    s.c = material_wave_speed_bound(&s.mat);
    Fem *f = make(&s, 48, 1);
    const double dt = 0.4 * solver_fem.unit_dt(f), start = kinetic(f);
    double lowest = 1, least = start, p[DIM] = {0}, mass = 0;
    Vec impulse;
    for (int k = 0; k * dt < 2.2; k++) {
        CU_ASSERT_FATAL(solver_fem.step(f, k * dt, dt, k == 0).code == OK);
        for (int i = 0; i < f->nodes; i++) lowest = fmin(lowest, f->x[1][i]);
        least = fmin(least, kinetic(f));
    }
    solver_fem.impulse(f, impulse);
    for (int i = 0; i < f->nodes; i++) {
        mass += f->m[i];
        for (int d = 0; d < DIM; d++) p[d] += f->m[i] * f->v[d][i];
    }
    CU_ASSERT(lowest == 0);
    CHECK_CLOSE(least / start, 0.53, 0.03); /* of finer meshes */
    CHECK_CLOSE(p[0], 0.2 * mass, 1e-12 * mass);
    CHECK_CLOSE(p[1], -0.2 * mass + impulse[1], 1e-12 * mass);
    CU_ASSERT(p[1] > 0.15 * mass);
    solver_fem.free(f);
}

static void test_glued_wall(void)
{
    Scene s = quarter_ring(&spinning);
    s.k[SPIN] = 100;
    s.k[RAMP] = 1e-3;
    s.wall[0] = (Wall){.axis = 0, .side = -1, .hold = 3}; /* both components, bilateral */
    Fem *f = make(&s, 8, 1);
    for (int k = 0; k < 40; k++) CU_ASSERT(solver_fem.step(f, k * 1e-4, 1e-4, k == 0).code == OK);
    for (int i = 0; i < f->nodes; i++)
        for (int d = 0; d < DIM; d++)
            if (f->X[0][i] == 0) CU_ASSERT(f->x[d][i] == f->X[d][i]);
    solver_fem.free(f);
}

static void test_failures(void)
{
    Scene s = quarter_ring(&inverted);
    Fem *f = make(&s, 8, 1);
    Status status = solver_fem.step(f, 0, 1e-4, true);
    CU_ASSERT(status.code == INVERTED && status.point == 0 && status.value < 0);
    solver_fem.free(f);

    s = quarter_ring(&poisoned);
    f = make(&s, 8, 1);
    CU_ASSERT(solver_fem.step(f, 0, 1e-4, true).code == OK);
    status = solver_fem.step(f, 1e-4, 1e-4, false);
    CU_ASSERT(status.code == NOT_A_NUMBER && status.point == 0);
    solver_fem.free(f);

    s = quarter_ring(&spinning); /* far beyond the stable step */
    s.k[SPIN] = s.k[RAMP] = 1;
    f = make(&s, 8, 1);
    status = (Status){OK, -1, 0};
    for (int k = 0; k < 2000 && status.code == OK; k++)
        status = solver_fem.step(f, 0.01 * k, 2 * solver_fem.unit_dt(f), k == 0);
    CU_ASSERT(status.code == INVERTED || status.code == NOT_A_NUMBER);
    CU_ASSERT(status.point >= 0);
    solver_fem.free(f);
}

static void test_integrator(void)
{
    const Scene s = quarter_ring(&spinning);
    Fault fault = {0};
    Setup setup = {.scene = &s, .cells = 8, .integrator = UVF, .threads = 1};
    check_context(DIM, s.problem->info.name, "fem", "uvf", NULL);
    CU_ASSERT_PTR_NULL(solver_fem.make(&setup, &fault));
    CU_ASSERT_EQUAL(fault.code, FAULT_USAGE);
}

static const TestCase tests[] = {
    {"static limit: a thick cylinder that turns", test_static_limit},
    {"impact on a frictionless wall", test_impact},
    {"a wall that holds every component", test_glued_wall},
    {"failures name their element", test_failures},
    {"central difference only", test_integrator},
    {NULL, NULL},
};
CHECK_SUITE(tests)
