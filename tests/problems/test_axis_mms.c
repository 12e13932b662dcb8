/* test_axis_mms.c: the axis-aligned solution against finite differences: balance of momentum,
 * start. */
#include "balance.h"
#include "tests/fixture.h"

extern const Problem problem_axis_mms;

static const double par[] = {0.05, 1e4, 0.3, 2};

static void test_balance(void)
{
    const Scene s = fixture_bare_scene(&problem_axis_mms, par, 1);
    for (int k = 0; k < 40; k++) {
        const Vec X = {fmod(0.37 * k, 1), fmod(0.61 * k + 0.2, 1)};
        const double t = s.t_end * k / 40;
        Vec b, expected;
        body_force(&s, X, t, b);
        balance(&s, X, t, expected);
        for (int a = 0; a < DIM; a++) CHECK_CLOSE(b[a], expected[a], 1e-7 * s.c * s.c);
    }
}

/* v is du/dt and L its gradient; both vanish across the sides they must not cross. */
static void test_start(void)
{
    const Scene s = fixture_bare_scene(&problem_axis_mms, par, 1);
    for (int k = 0; k < 40; k++) {
        const Vec X = {k % 4 ? 0.0257 * k : 0, k % 4 == 1 ? 1 : 0.0257 * k};
        Vec v, expected, u;
        Mat L, gradient, F;
        start_velocity(&s, X, v, L, u, F);
        exact_velocity(&s, X, expected, gradient);
        for (int a = 0; a < DIM; a++) CHECK_CLOSE(v[a], expected[a], 1e-9 * s.c * par[0]);
        for (int a = 0; a < NMAT; a++) CHECK_CLOSE(L[a], gradient[a], 1e-9 * s.c * par[0]);
        if (k % 4 == 0) CHECK_CLOSE(v[0], 0, 1e-13);
        if (k % 4 == 1) CHECK_CLOSE(v[1], 0, 1e-13);
    }
}

static const TestCase tests[] = {
    {"body force balances the exact motion (finite differences)", test_balance},
    {"starts with the exact velocity and its gradient", test_start},
    {NULL, NULL},
};
CHECK_SUITE(tests)
