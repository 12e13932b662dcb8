/* test_traction.c: scenes under traction: exact solutions against finite differences, momentum and
 * work against the traction known, threads. In the plane. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include "balance.h"
#include "common/base/table.h"
#include "common/core/skin.h"
#include "tests/fixture.h"

enum { PAR = 6 };
extern const Problem problem_ring;

static const double loaded[PAR] = {0.1, 0, 0, 0, 0, 1};

static Vec *traction_at(const Scene *s, const Vec X, const Vec N, double t, Vec *out)
{
    s->problem->traction(s, 1, (const double *[]){&X[0], &X[1]}, (const double *[]){&N[0], &N[1]},
                         t, (double *[]){&(*out)[0], &(*out)[1]});
    return out;
}

static void test_body_force(void)
{
    const Scene s = fixture_bare_scene(&problem_ring, loaded, 1.0 / 32);
    for (int k = 0; k < 40; k++) {
        const double R = 0.52 + 0.46 * k / 39, angle = 0.3 + 0.02 * k, t = 0.0007 * k;
        const Vec X = {R * cos(angle), R * sin(angle)};
        Vec b, expected;
        body_force(&s, X, t, b);
        balance(&s, X, t, expected);
        CU_ASSERT(hypot(b[0] - expected[0], b[1] - expected[1]) <=
                  1e-8 * fmax(hypot(b[0], b[1]), 1e4));
    }
}

/* P N of the exact motion on both circles, outwards; nothing on the symmetry lines. */
static void test_ring_traction(void)
{
    const Scene s = fixture_bare_scene(&problem_ring, loaded, 1.0 / 32);
    double least = INFINITY;
    for (int k = 0; k < 40; k++) {
        const double R = k % 2 ? 1 : 0.5, angle = 0.03 * k, t = 0.0007 * k, side = k % 2 ? 1 : -1;
        const Vec e = {cos(angle), sin(angle)}, X = {R * e[0], R * e[1]};
        const Vec N = {side * e[0], side * e[1]}, across = {-e[1], e[0]};
        Vec got, none;
        Mat P;
        traction_at(&s, X, N, t, &got);
        traction_at(&s, X, across, t, &none);
        first_stress(&s, X, t, P);
        for (int a = 0; a < 2; a++) {
            CHECK_CLOSE(got[a], P[2 * a] * N[0] + P[2 * a + 1] * N[1], 1e-8 * s.mat.E);
            CU_ASSERT(none[a] == 0);
        }
        if (fabs(cos(M_PI * 100 * t)) > 0.5) least = fmin(least, hypot(got[0], got[1]));
    }
    CU_ASSERT(least > 0.01 * s.mat.E);
}

static double pulled(const Fixture *r, double X, double t)
{
    Vec at = {X, 1}, u;
    r->plan.scene.problem->exact(&r->plan.scene, 1, (const double *[]){&at[0], &at[1]}, t,
                                 (double *[]){&u[0], &u[1]});
    CU_ASSERT(u[1] == 0);
    return u[0];
}

/* The wave equation away from the front (c t = 1 - X, its reflections and the end of the ramp),
 * stress at the end, rest at the wall. */
static void test_pulled_bar(void)
{
    const Case bar = {DIM, "pulled_bar", 40, 0, 0, ""};
    const double c = 100, ds = 1e-4, dt = ds / c / 2;
    Fixture r;
    CU_ASSERT_FATAL(fixture_plan(&r, &bar, "gimp", CD, NULL));
    for (double ct = 0.013; ct < 4; ct += 0.0717) {
        const double t = ct / c;
        for (double X = 0.0131; X < 0.99; X += 0.0379) {
            double near = 1;
            for (int k = -6; k <= 6; k++)
                near = fmin(near, fmin(fabs(ct - X - k), fabs(ct + X - k)));
            if (near < 3 * ds) continue;
            const double u = pulled(&r, X, t);
            const double utt = (pulled(&r, X, t + dt) - 2 * u + pulled(&r, X, t - dt)) / (dt * dt);
            const double uxx = (pulled(&r, X + ds, t) - 2 * u + pulled(&r, X - ds, t)) / (ds * ds);
            CHECK_CLOSE(utt, c * c * uxx, 1e-4 * c * c * 0.01);
        }
        CHECK_CLOSE(pulled(&r, 0, t), 0, 1e-15);
        const double slope = (pulled(&r, 1, t) - pulled(&r, 1 - 1e-6, t)) / 1e-6;
        CHECK_CLOSE(slope, 0.01 * fmin(ct, 1), 1e-7);
    }
}

/* p(k) - p(k-1) = dt [(R + T)(k) + (R + T)(k-1)]/2 with the wall's reaction R and the known end
 * force T: .01 E c t/L times the width of .5. */
static void test_momentum(void)
{
    static const char *const names[] = {"gimp", "mpm", "wls2", "fem"};
    for (int m = 0; m < COUNT(names); m++) {
        const Case bar = {DIM, "pulled_bar", 16, 0, 0, ""};
        char path[64];
        Row row;
        Fault fault = {0};
        RunSpec spec = fixture_spec(&bar, names[m], NULL, "steps=60");
        snprintf(path, sizeof path, "traction_%d.csv", (int)getpid());
        spec.history = path;
        CU_ASSERT_FATAL(run_spec(&spec, &row, &fault) == 0);
        Table *h = table_read(path, &fault);
        CU_ASSERT_FATAL(h != NULL);
        unlink(path);
        const double dt = table_number(h, 0, "dt");
        double worst = 0;
        for (int k = 2; k < h->nrow; k++) {
            const double now = fmin(100 * table_number(h, k, "t"), 1);
            const double before = fmin(100 * table_number(h, k - 1, "t"), 1);
            const double R =
                0.5 * (table_number(h, k, "wall1_fx") + table_number(h, k - 1, "wall1_fx"));
            const double gained = table_number(h, k, "px") - table_number(h, k - 1, "px");
            worst = fmax(worst, fabs(gained / dt - R - 50 * 0.5 * (now + before)));
        }
        /* WLS gives its nodes the forces of the cells' boundary, whose length differs from the
         * points' a little */
        CU_ASSERT(worst < (strcmp(names[m], "wls2") == 0 ? 0.1 : 1e-9) * 50);
        table_free(h);
    }
}

static void test_threads(void)
{
    static const char *const names[] = {"gimp", "wls2", "fem"};
    for (int m = 0; m < COUNT(names); m++) {
        const Case ring = {DIM, "ring", 16, 0, 0, ""};
        Row row[2];
        Fault fault = {0};
        for (int k = 0; k < 2; k++) {
            RunSpec spec = fixture_spec(&ring, names[m], NULL, "traction=1;steps=40");
            spec.threads = 1 + 2 * k;
            CU_ASSERT_FATAL(run_spec(&spec, &row[k], &fault) == 0);
        }
        CU_ASSERT(row[0].error_linf == row[1].error_linf);
        CU_ASSERT(row[0].energy_drift == row[1].energy_drift);
        CU_ASSERT(row[0].error_linf < 3e-3);
    }
}

/* Nodes outside the live spans hold anything, the first one as well. */
static void test_dead_nodes(void)
{
    static const char *const names[] = {"gimp", "wls2"};
    for (int m = 0; m < COUNT(names); m++) {
        const Case ring = {DIM, "ring", 8, 0, 0, ""};
        Fixture r;
        CU_ASSERT_FATAL(fixture_plan(&r, &ring, names[m], CD, "traction=1"));
        Sim *sim = fixture_sim(&r);
        CU_ASSERT_FATAL(fixture_steps(&r, sim, 0, 1));
        CU_ASSERT_FATAL(sim->g.lo[0] >= sim->g.hi[0]);
        for (int l = 0; l < LANES; l++) sim->g.node[0][l] = NAN;
        CU_ASSERT(fixture_steps(&r, sim, 1, 20));
        CU_ASSERT(isfinite(skin_work(sim->skin)));
        sim_free(sim);
    }
}

/* A ring that bursts: nothing depends on threads, across a hand-over at rupture; one that holds is
 * not handed over. The pulled bar goes on under its traction, with its work. */
static void test_burst(void)
{
    const Case burst = {DIM, "burst_ring", 24, 0, 0, ""},
               weak = {DIM, "burst_ring", 16, 0, 0.1, ""};
    const Case bar = {DIM, "pulled_bar", 16, 0, 0, ""};
    Row row[4];
    Fault fault = {0};
    for (int k = 0; k < 3; k++) {
        RunSpec spec =
            fixture_spec(&burst, "wls2", NULL,
                         k < 2 ? "then=gimp;at=rupture" : "then=gimp;at=rupture;strength=9");
        spec.threads = 1 + 2 * (k == 1);
        spec.t_end = 0.01;
        CU_ASSERT_FATAL(run_spec(&spec, &row[k], &fault) == 0);
    }
    CU_ASSERT(strstr(row[0].reason, "gimp from step") != NULL);
    CU_ASSERT(strstr(row[2].reason, "never") != NULL);
    CU_ASSERT(row[0].energy_drift == row[1].energy_drift);
    CU_ASSERT(row[0].momentum_drift == row[1].momentum_drift);
    CHECK_CLOSE(row[0].energy_drift, 0, 0.035);
    RunSpec spec =
        fixture_spec(&weak, "gimp", NULL, "layout=radial;domain=undeformed;strength=.1;weak=1");
    spec.t_end = 0.01;
    CU_ASSERT_FATAL(run_spec(&spec, &row[3], &fault) == 0);
    CHECK_CLOSE(row[3].energy_drift, 0, 0.025); /* -.047 without what was lost */
    spec = fixture_spec(&bar, "wls2", NULL, "then=gimp;at=.012");
    CU_ASSERT_FATAL(run_spec(&spec, &row[3], &fault) == 0);
    CHECK_CLOSE(row[3].energy_drift, 0, 0.02);
    CU_ASSERT(row[3].error_linf < 0.02);
}

static const TestCase tests[] = {
    {"a ring that bursts, a bar handed over under traction", test_burst},
    {"nodes that are not live are not read", test_dead_nodes},
    {"body force of the ring under traction by finite differences", test_body_force},
    {"its traction is P N on both circles", test_ring_traction},
    {"the pulled bar's exact solution", test_pulled_bar},
    {"end force and wall reaction balance the change of momentum", test_momentum},
    {"threads change nothing under traction", test_threads},
    {NULL, NULL}};
CHECK_SUITE(tests)
