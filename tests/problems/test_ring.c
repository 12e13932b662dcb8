/* test_ring.c: the oscillating ring's exact solution against finite differences, and its points. */
#include "common/contract/layout.h"
#include "balance.h"
#include "tests/fixture.h"

extern const Problem problem_ring;

enum { FULL = 1 };

static const double quarter[6] = {0.1}, moved[6] = {0.1, FULL, 0.3, -0.4, 25};

static void test_body_force_values(void)
{
    static const struct {
        double R, t, b;
    } known[] = {
        {0.5, 0, -1837.006}, {0.75, 0, -8193.199}, {1, 0, -14915.06}, {0.75, 0.02 / 3, 4020.148}};
    const Scene s = fixture_bare_scene(&problem_ring, quarter, 1);
    for (int k = 0; k < 4; k++) {
        Vec b;
        body_force(&s, (Vec){known[k].R, 0}, known[k].t, b);
        CHECK_CLOSE(b[0], known[k].b, 4e-7 * fabs(known[k].b));
        CHECK_CLOSE(b[1], 0, 1e-12);
    }
}

static void test_body_force_balance(void)
{
    const Scene s = fixture_bare_scene(&problem_ring, moved, 1.0 / 32);
    for (int k = 0; k < 40; k++) {
        double R = 0.5 + 0.5 * k / 39, angle = 2.4 * k, t = 0.0007 * k;
        Vec X = {s.body.centre[0] + R * cos(angle), s.body.centre[1] + R * sin(angle)}, b, expected;
        body_force(&s, X, t, b);
        balance(&s, X, t, expected);
        double error = hypot(b[0] - expected[0], b[1] - expected[1]);
        CU_ASSERT(error <= 1e-6 * fmax(hypot(b[0], b[1]), 1));
    }
}

static void test_start(void)
{
    const Scene s = fixture_bare_scene(&problem_ring, moved, 1.0 / 32);
    for (int k = 0; k < 40; k++) {
        double R = 0.5 + 0.5 * k / 39, angle = 2.4 * k, none[NMAT] = {0};
        Vec X = {s.body.centre[0] + R * cos(angle), s.body.centre[1] + R * sin(angle)}, u, exact;
        Mat F, expected;
        double *pu[] = {&u[0], &u[1]}, *pF[] = {&F[0], &F[1], &F[2], &F[3]},
               *unused[] = {none, none, none, none};
        problem_ring.start(&s, 1, (const double *[]){&X[0], &X[1]}, pu, unused, pF, unused);
        displacement(&s, X, 0, exact);
        exact_gradient(&s, X, 0, expected);
        for (int d = 0; d < DIM; d++) CHECK_CLOSE(u[d], exact[d], 1e-16);
        for (int d = 0; d < NMAT; d++) CHECK_CLOSE(F[d], expected[d], 1e-11);
    }
}

/* F_rr = 1 on both circles: with nu = 0 they are free of traction. */
static void test_free_surfaces(void)
{
    const Scene s = fixture_bare_scene(&problem_ring, quarter, 1);
    for (int k = 0; k < 2; k++) {
        Mat F;
        exact_gradient(&s, (Vec){k ? 1 : 0.5, 0}, 0.003, F);
        CHECK_CLOSE(F[0], 1, 1e-12);
    }
}

static void test_fitted_points(void)
{
    const double *const par[] = {quarter, moved};
    for (int k = 0; k < 2; k++) {
        Layout out = {0};
        const Scene s = fixture_bare_scene(&problem_ring, par[k], 1.0 / 32);
        double area = 0, sum = 0;
        int surface = 0;
        CU_ASSERT_FATAL(layout_make(&out, &s, 1.0 / 64, 0, true, NULL) == 0);
        for (int p = 0; p < out.n; p++) {
            double x = out.X[0][p] - s.body.centre[0], y = out.X[1][p] - s.body.centre[1];
            double R = hypot(x, y), dot = (out.normal[0][p] * x + out.normal[1][p] * y) / R;
            area += out.volume[p];
            sum += out.volume[p] * x;
            if (out.volume[p] > 0) continue;
            surface++;
            CHECK_CLOSE(dot, R > 0.75 ? 1 : -1, 1e-14); /* out of the material */
            CHECK_CLOSE(R, R > 0.75 ? 1 : 0.5, 1e-14);
        }
        CHECK_CLOSE(area, (k ? 4 : 1) * M_PI / 4 * 0.75, 1e-12);
        if (k) CHECK_CLOSE(sum, 0, 1e-12);
        CU_ASSERT_EQUAL(surface, (k ? 4 : 1) * (51 + 101)); /* ceil(pi R/2 / s) on either circle */
        layout_free(&out);
    }
}

static void test_refused(void)
{
    char why[128] = "";
    static const double offset[5] = {0.1, 0, 0.5, 0, 0};
    Scene s = {.problem = &problem_ring, .par = offset, .cell = 1};
    CU_ASSERT(problem_ring.init(&s, why) == -1);
    CU_ASSERT(why[0] != '\0');
}

static const TestCase tests[] = {
    {"body force: known values", test_body_force_values},
    {"body force balances the exact motion (finite differences)", test_body_force_balance},
    {"initial F is the gradient of the initial u", test_start},
    {"both circles are free of traction", test_free_surfaces},
    {"body-fitted points: area, surface, normals", test_fitted_points},
    {"an offset of the quarter ring is refused", test_refused},
    {NULL, NULL},
};
CHECK_SUITE(tests)
