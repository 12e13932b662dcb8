/* test_vortex.c: the generalized vortex's exact solution against finite differences, its points. */
#include "common/contract/layout.h"
#include "balance.h"
#include "tests/fixture.h"

extern const Problem problem_vortex;

static const double par[] = {1, 1000, 0.3, 1000, 0.3, -0.4};

/* Point k of 40 in the ring: both circles among them. */
static void point(const Scene *s, int k, Vec X)
{
    const double R = 0.75 + 0.5 * k / 39, angle = 2.4 * k;
    X[0] = s->body.centre[0] + R * cos(angle);
    X[1] = s->body.centre[1] + R * sin(angle);
}

static void test_balance(void)
{
    const Scene s = fixture_bare_scene(&problem_vortex, par, 1.0 / 32);
    for (int k = 0; k < 40; k++) {
        Vec X, b, expected;
        point(&s, k, X);
        body_force(&s, X, 0.025 * k, b);
        balance(&s, X, 0.025 * k, expected);
        for (int a = 0; a < DIM; a++) CHECK_CLOSE(b[a], expected[a], 1e-6);
    }
}

static void test_start(void)
{
    const Scene s = fixture_bare_scene(&problem_vortex, par, 1.0 / 32);
    for (int k = 0; k < 40; k++) {
        Vec X, v, expected, u;
        Mat L, gradient, F;
        point(&s, k, X);
        start_velocity(&s, X, v, L, u, F);
        exact_velocity(&s, X, expected, gradient);
        for (int a = 0; a < DIM; a++) CHECK_CLOSE(v[a], expected[a], 1e-9);
        for (int a = 0; a < NMAT; a++) CHECK_CLOSE(L[a], gradient[a], 1e-8);
    }
}

/* No volume changes anywhere; no displacement and no traction P N on the circles. */
static void test_free_surfaces(void)
{
    const Scene s = fixture_bare_scene(&problem_vortex, par, 1.0 / 32);
    double shear = 0;
    for (int k = 0; k < 40; k++)
        for (int j = 1; j <= 3; j++) {
            Vec X, u;
            Mat F, P;
            point(&s, k, X);
            exact_gradient(&s, X, 0.25 * j, F);
            CHECK_CLOSE(determinant(F), 1, 1e-8);
            shear = fmax(shear, fabs(F[0] * F[1] + F[2] * F[3]));
            if (k > 0 && k < 39) continue;
            const double Nx = X[0] - s.body.centre[0], Ny = X[1] - s.body.centre[1];
            displacement(&s, X, 0.25 * j, u);
            first_stress(&s, X, 0.25 * j, P);
            CHECK_CLOSE(hypot(u[0], u[1]), 0, 1e-14);
            CHECK_CLOSE(hypot(P[0] * Nx + P[1] * Ny, P[2] * Nx + P[3] * Ny), 0, 1e-8 * s.mat.mu);
        }
    CU_ASSERT(shear > 2);
}

/* The body comes back: nothing has moved at t = 1, everything at rest on the way back. */
static void test_ends(void)
{
    const Scene s = fixture_bare_scene(&problem_vortex, par, 1.0 / 32);
    for (int k = 0; k < 40; k++) {
        Vec X, u;
        point(&s, k, X);
        displacement(&s, X, s.t_end, u);
        CHECK_CLOSE(hypot(u[0], u[1]), 0, 1e-14);
        CHECK_CLOSE(s.problem->distance(&s, X, 0.3), k < 20 ? 0.5 * k / 39 : 0.5 * (39 - k) / 39,
                    1e-14);
    }
}

static void test_fitted_points(void)
{
    Layout out = {0};
    const Scene s = fixture_bare_scene(&problem_vortex, par, 1.0 / 32);
    double area = 0;
    int surface = 0;
    CU_ASSERT_FATAL(layout_make(&out, &s, 1.0 / 64, 0, true, NULL) == 0);
    for (int p = 0; p < out.n; p++) {
        const double x = out.X[0][p] - s.body.centre[0], y = out.X[1][p] - s.body.centre[1];
        const double R = hypot(x, y), dot = (out.normal[0][p] * x + out.normal[1][p] * y) / R;
        area += out.volume[p];
        if (out.volume[p] > 0) continue;
        surface++;
        CHECK_CLOSE(dot, R > 1 ? 1 : -1, 1e-14);
        CHECK_CLOSE(R, R > 1 ? 1.25 : 0.75, 1e-14);
    }
    CHECK_CLOSE(area, M_PI, 1e-12);
    CU_ASSERT_EQUAL(surface, 302 + 503); /* ceil(2 pi R / s) on either circle */
    layout_free(&out);
}

static const TestCase tests[] = {
    {"body force balances the exact motion (finite differences)", test_balance},
    {"starts with the exact velocity and its gradient", test_start},
    {"keeps its volume; both circles rest, free of traction", test_free_surfaces},
    {"comes back at t = 1; distance to the circles", test_ends},
    {"body-fitted points: area, surface, normals", test_fitted_points},
    {NULL, NULL},
};
CHECK_SUITE(tests)
