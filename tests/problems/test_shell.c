/* test_shell.c: scenes of 3D: balance of momentum and initial state against finite differences,
 * points on spheres. */
#include <stdlib.h>
#include "balance.h"
#include "common/contract/sphere.h"
#include "tests/fixture.h"

extern const Problem problem_shell, problem_ring, problem_axis_mms, problem_cavity;

static const double octant[] = {0.1, 0, 0, 0, 0, 0, 0}, moved[] = {0.1, 1, 0.3, -0.2, 0.4, 25, 0};
static const double loaded[] = {0.1, 0, 0, 0, 0, 0, 1}, loaded_ring[] = {0.1, 0, 0, 0, 0, 1};
static const double turned_ring[] = {0.1, 1, 0.3, -0.2, 0, 0}, waves[] = {0.05, 1e4, 0.3, 2};

/* A place inside the body. */
static void place(const Scene *s, int k, Vec X)
{
    const double R = 0.55 + 0.4 * fmod(0.37 * k, 1), up = 2 * fmod(0.61 * k, 1) - 1;
    const double across = sqrt(1 - up * up), e[] = {across * cos(k), across * sin(k), up};
    for (int d = 0; d < DIM; d++) X[d] = s->body.centre[d] + R * e[d];
    if (s->problem == &problem_ring) {
        X[0] = s->body.centre[0] + R * cos(k);
        X[1] = s->body.centre[1] + R * sin(k);
        X[2] = 0.25 * fmod(0.43 * k, 1);
    }
    if (s->problem == &problem_axis_mms)
        for (int d = 0; d < DIM; d++) X[d] = fmod(0.37 * k + 0.61 * k * d + 0.05, 1);
}

static void check_balance(const Problem *problem, const double *par)
{
    const Scene s = fixture_bare_scene(problem, par, 0.125);
    double size = 0, gap = 0;
    for (int k = 0; k < 60; k++) {
        const double t = s.t_end * k / 60;
        Vec X, b, expected;
        place(&s, k, X);
        body_force(&s, X, t, b);
        balance(&s, X, t, expected);
        for (int a = 0; a < DIM; a++) {
            size = fmax(size, fabs(expected[a]));
            gap = fmax(gap, fabs(b[a] - expected[a]));
        }
    }
    CU_ASSERT(size > 100); /* [m/s^2] */
    CU_ASSERT(gap <= 1e-8 * size);
}

static void test_balance(void)
{
    check_balance(&problem_shell, octant);
    check_balance(&problem_shell, moved);
    check_balance(&problem_ring, turned_ring);
    check_balance(&problem_shell, loaded);
    check_balance(&problem_ring, loaded_ring);
    check_balance(&problem_axis_mms, waves);
}

/* u, v, F and L at the start are those of the exact motion; L is a gradient with respect to x. */
static void check_start(const Problem *problem, const double *par)
{
    const Scene s = fixture_bare_scene(problem, par, 0.125);
    for (int k = 0; k < 40; k++) {
        Vec X, u, v, exact_u, exact_v;
        Mat F, L, exact_F, rate;
        place(&s, k, X);
        start_velocity(&s, X, v, L, u, F);
        displacement(&s, X, 0, exact_u);
        exact_gradient(&s, X, 0, exact_F);
        exact_velocity(&s, X, exact_v, rate);
        for (int a = 0; a < DIM; a++) {
            CHECK_CLOSE(u[a], exact_u[a], 1e-15);
            CHECK_CLOSE(v[a], exact_v[a], 1e-8 * s.c);
            for (int b = 0; b < DIM; b++) {
                double LF = 0;
                for (int j = 0; j < DIM; j++) LF += L[a * DIM + j] * F[j * DIM + b];
                CHECK_CLOSE(F[a * DIM + b], exact_F[a * DIM + b], 1e-10);
                CHECK_CLOSE(LF, rate[a * DIM + b], 1e-7 * s.c);
            }
        }
    }
}

static void test_start(void)
{
    check_start(&problem_shell, octant);
    check_start(&problem_shell, moved);
    check_start(&problem_ring, turned_ring);
    check_start(&problem_axis_mms, waves);
}

/* Its surfaces carry no traction: P N = 0 at both radii. */
static void test_traction(void)
{
    const Scene s = fixture_bare_scene(&problem_shell, octant, 0.125);
    for (int k = 0; k < 20; k++) {
        const double R = k % 2 ? 0.5 : 1, e[] = {0.48, 0.6, 0.64};
        const Vec X = {R * e[0], R * e[1], R * e[2]};
        Mat P;
        first_stress(&s, X, s.t_end * k / 20, P);
        for (int a = 0; a < DIM; a++) {
            double traction = 0;
            for (int b = 0; b < DIM; b++) traction += P[a * DIM + b] * e[b];
            CHECK_CLOSE(traction, 0, 1e-8 * s.mat.E);
        }
    }
}

/* The sum of all volumes, and of surface normals times what is on their right. */
static void check_layout(const Scene *s, double spacing, double volume)
{
    Layout out = {0};
    double sum = 0, balance_of_normals = 0;
    int wrong = 0, surface = 0;
    CU_ASSERT_FATAL(s->problem->place(s, spacing, true, &out) && !out.lost);
    for (int k = 0; k < out.n; k++) {
        double R = 0, along = 0, size = 0;
        for (int d = 0; d < DIM; d++) {
            const double r = out.X[d][k] - s->body.centre[d];
            R += r * r;
            along += r * out.normal[d][k];
            size += out.normal[d][k] * out.normal[d][k];
            wrong += s->octant && !(r > 0); /* none on a symmetry plane */
        }
        R = sqrt(R);
        sum += out.volume[k];
        surface += !(out.volume[k] > 0);
        if (out.volume[k] > 0) {
            wrong += !(R > 0.5 && R < 1) || size > 0;
            continue;
        }
        const double side = R < 0.75 ? -1 : 1;
        wrong += fabs(R - (side < 0 ? 0.5 : 1)) > 1e-14 || fabs(size - 1) > 1e-14;
        balance_of_normals = fmax(balance_of_normals, fabs(along - side * R));
    }
    CHECK_CLOSE(sum / volume, 1, 1e-13);
    CU_ASSERT(wrong == 0 && surface > 0 && balance_of_normals < 1e-14);
    layout_free(&out);
}

static void test_spheres(void)
{
    const double whole = 4.0 / 3 * M_PI * (1 - 0.125);
    const Scene part = fixture_bare_scene(&problem_shell, octant, 0.125),
                full = fixture_bare_scene(&problem_shell, moved, 0.125);
    for (int n = 2; n < 20; n += 5) {
        check_layout(&part, 0.5 / n, whole / 8);
        check_layout(&full, 0.5 / n, whole);
    }
}

/* The set of points is the same after an exchange of axes: sums of products of odd powers. */
static void test_exchange(void)
{
    const Scene s = fixture_bare_scene(&problem_shell, octant, 0.125);
    Layout out = {0};
    double moment[6] = {0};
    sphere_add(&out, &s, 0.7, 0.1, 0.08, 0);
    for (int k = 0; k < out.n; k++)
        for (int q = 0; q < 6; q++) {
            static const int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                            {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
            const double x = out.X[order[q][0]][k], y = out.X[order[q][1]][k];
            moment[q] += out.volume[k] * x * x * x * y;
        }
    for (int q = 1; q < 6; q++) CHECK_CLOSE(moment[q] / moment[0], 1, 1e-13);
    CU_ASSERT_EQUAL(out.n, 3 * 7 * 7); /* ceil(sqrt(pi/6) .7/.08) = 7 */
    layout_free(&out);
}

/* The turn is a rotation that keeps its axis. */
static void test_turn(void)
{
    const double axis[3] = {1, 2, 3};
    Mat Q;
    sphere_turn(axis, 0.7, Q);
    CHECK_CLOSE(determinant(Q), 1, 1e-15);
    double trace = 0;
    for (int a = 0; a < DIM; a++) {
        double kept = 0;
        for (int b = 0; b < DIM; b++) kept += Q[a * DIM + b] * axis[b];
        CHECK_CLOSE(kept, axis[a], 1e-14);
        trace += Q[a * DIM + a];
    }
    CHECK_CLOSE(trace, 1 + 2 * cos(0.7), 1e-15);
    sphere_turn((double[3]){0, 0, 2}, 0.5, Q);
    CHECK_CLOSE(Q[DIM], sin(0.5), 1e-15); /* x turns towards y */
}

/* Points of the cavity fill the cube less an eighth of a ball, but for the seam of two layouts. */
static void test_cavity(void)
{
    const Scene s = fixture_bare_scene(&problem_cavity, NULL, 0.125);
    Layout out = {0};
    double sum = 0;
    CU_ASSERT(s.problem->place(&s, 1.0 / 32, true, &out));
    for (int k = 0; k < out.n; k++) sum += out.volume[k];
    CHECK_CLOSE(sum, 1 - M_PI / 48, 2e-3);
    layout_free(&out);
}

/* Points of the loaded surfaces have their areas; runs under traction follow the exact motion as
 * closely as free ones, and the work of the traction is in the ledger. */
static void test_loaded(void)
{
    static const char *const judged[] = {"gimp", "wls2", "fem"};
    const double areas[] = {4 * M_PI / 8 * (0.25 + 1), M_PI / 2 * (0.5 + 1) * 0.25};
    for (int ring = 0; ring < 2; ring++) {
        const Scene s = fixture_bare_scene(ring ? &problem_ring : &problem_shell,
                                           ring ? loaded_ring : loaded, 0.125);
        Layout out = {0};
        double area = 0;
        s.problem->surface(&s, 1.0 / 16, &out);
        for (int k = 0; k < out.n; k++) area += out.volume[k];
        CHECK_CLOSE(area, areas[ring], 1e-12);
        layout_free(&out);
        for (int m = 0; m < 3; m++) {
            const Case c = {3, ring ? "ring" : "shell", 8, 8, 0, "dim=3;traction=1"};
            RunSpec spec = fixture_spec(&c, judged[m], NULL, NULL);
            Row row;
            spec.t_end = 0.004;
            CU_ASSERT_FATAL(run_spec(&spec, &row, NULL) == 0);
            CHECK_TEXT(row.status, "ok");
            CU_ASSERT(row.error_linf < (m ? 0.004 : 0.006));
            CHECK_CLOSE(row.energy_drift, 0, m ? 0.003 : 0.016);
        }
    }
}

static const TestCase tests[] = {
    {"body forces balance the exact motion (finite differences)", test_balance},
    {"starts from the exact state", test_start},
    {"no traction on the surfaces of the shell", test_traction},
    {"traction on shell and ring", test_loaded},
    {"points on spheres fill the shell", test_spheres},
    {"points on spheres are the same after an exchange of axes", test_exchange},
    {"a turn about an axis", test_turn},
    {"points around the cavity", test_cavity},
    {NULL, NULL},
};
CHECK_SUITE(tests)
