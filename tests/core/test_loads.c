/* test_loads.c: scenes that are known by their load alone: all of it, and its moment about the
 * wall that holds the body. */
#include "common/contract/layout.h"
#include "common/contract/problem.h"
#include "tests/fixture.h"

extern const Problem problem_cantilever, problem_hanging_bar;

typedef struct Load {
    double force[2], moment; /* [N/m] [N]: about the origin, counter-clockwise */
} Load;

/* Sums over the particles of 1/32 m that the scene places. */
static Load load_at(const Scene *s, double t)
{
    Layout out = {0};
    Load sum = {{0, 0}, 0};
    CU_ASSERT_FATAL(layout_make(&out, s, 1.0 / 32, 0, false, NULL) == 0);
    for (int p = 0; p < out.n; p++) {
        const double m = s->mat.rho * out.volume[p], x = out.X[0][p], y = out.X[1][p];
        double b[2];
        s->problem->body(s, 1, (const double *[]){&x, &y}, t, (double *[]){&b[0], &b[1]});
        for (int d = 0; d < 2; d++) sum.force[d] += m * b[d];
        sum.moment += m * (x * b[1] - y * b[0]);
    }
    layout_free(&out);
    return sum;
}

/* tau H = .01 E downwards at the end of the ramp, in proportion to time before. The load grows
 * linearly over the last metre: its centre lies at X = 3 + 2/3 (by midpoints: 1/(12 32^2) less). */
static void test_cantilever(void)
{
    const double par[] = {1e4, 0.3, 0.01, 0}, tau = 0.01 * 1e4;
    const Scene s = fixture_bare_scene(&problem_cantilever, par, 1.0 / 16);
    for (int k = 1; k <= 4; k++) {
        const double part = k < 4 ? k / 3.0 : 1;
        const Load load = load_at(&s, k / 3.0 * s.t_end);
        CHECK_CLOSE(load.force[0], 0, 0);
        CHECK_CLOSE(load.force[1], -part * tau, 1e-11 * tau);
        CHECK_CLOSE(load.moment, -part * tau * (11.0 / 3), 4e-4 * tau);
    }
    const double plane = 1e4 / (1 - 0.09), w = pow(1.8751 / 4, 2) * sqrt(plane / 12);
    CHECK_CLOSE(s.t_end, 2 * M_PI / w, 1e-12 * s.t_end);
    CU_ASSERT(s.nwall == 1 && s.wall[0].hold == 3 && s.wall[0].axis == 0);
}

/* Its weight, from the first instant on; held where y = 4. */
static void test_hanging_bar(void)
{
    const double par[] = {1e6, 0.3, 1050, 1000};
    const Scene s = fixture_bare_scene(&problem_hanging_bar, par, 1.0 / 16);
    for (int k = 0; k < 2; k++) {
        const Load load = load_at(&s, k * s.t_end);
        CHECK_CLOSE(load.force[0], 0, 0);
        CHECK_CLOSE(load.force[1], -1.05e6, 1e-6);
        CHECK_CLOSE(load.moment, -1.05e6 / 2, 1e-6);
    }
    CU_ASSERT(s.nwall == 1 && s.wall[0].hold == 3 && s.wall[0].axis == 1 && s.wall[0].side == 1);
    CHECK_CLOSE(s.wall[0].at, s.body_hi[1], 0);
}

static const TestCase tests[] = {
    {"cantilever: end shear, its ramp and its place", test_cantilever},
    {"hanging bar: weight", test_hanging_bar},
    {NULL, NULL},
};
CHECK_SUITE(tests)
