/* test_time_order.c: the order in time of every method and integrator. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "tests/fixture.h"

/* Positions of a case at time T after `steps` steps. */
static double *positions_at(const Case *c, const Method *m, Integrator i, double T, int steps,
                            int *count)
{
    Fixture r;
    const bool fresh = !fixture_valid(m, i, false);
    CU_ASSERT_FATAL(
        fixture_plan(&r, c, m->info.name, i, fresh ? "refresh=1;allow_unstable=1" : NULL));
    Sim *sim = fixture_sim(&r);
    r.dt = T / steps;
    CU_ASSERT_FATAL(fixture_steps(&r, sim, 0, steps));
    double *s = fixture_state(sim);
    *count = sim->p.count;
    sim_free(sim);
    return s;
}

/* By what a difference in position falls when dt is halved from T/steps and halved again. */
static double fall_with_dt(const Case *c, const Method *m, Integrator i, double T, int steps)
{
    double *s[3];
    int n = 0;
    for (int k = 0; k < 3; k++) s[k] = positions_at(c, m, i, T, steps << k, &n);
    const double coarse = fixture_gap(s[0], s[1], n, AT_X, DIM),
                 fine = fixture_gap(s[1], s[2], n, AT_X, DIM);
    for (int k = 0; k < 3; k++) free(s[k]);
    CU_ASSERT(fine > 1e-11); /* above round-off */
    return coarse / fine;
}

/* 4 with the half first step, 2 without, as usl and usf are meant to be. uvf moves particles with
 * what they have and is second order on any mesh. cd and musl move them with P v + a dt, which
 * differs from the re-projection by dt (1 - P S) a, of order dt h^2: small on this fine mesh (3.6
 * measured), and nothing with GE, whose projection is second order itself. */
static void test_time_order_1d(void)
{
    const Case c = {1, "sine_bar", 160, 2, 0, "law=linear;A=0.001"};
    if (DIM != 1) return;
    FOR_METHODS(m) FOR_INTEGRATORS(i)
    {
        if (!(*m)->smooth || fixture_pic(*m) > 0) continue; /* a PIC update damps once a step */
        if (i == MUSL && strncmp((*m)->info.name, "bspline", 7) == 0)
            continue; /* P S of splines is farther from 1 */
        const double fall = fall_with_dt(&c, *m, i, 0.002, 40);
        const double wanted = i == USL || i == USF ? 2 : i == UVF || (*m)->linear_exact ? 4 : 3.7;
        CHECK_CLOSE(fall, wanted, fabs(wanted - 3.7) < 0.1 ? 0.3 : 0.02);
    }
}

static void test_time_order_2d(void)
{
    const Case c = {2, "plate_vibration", 16, 4, 0, NULL};
    if (DIM != 2) return;
    FOR_METHODS(m)
    {
        if (!(*m)->smooth || (*m)->keeps_L || fixture_pic(*m) > 0)
            continue; /* crossings disturb a kept L at first order */
        CHECK_CLOSE(fall_with_dt(&c, *m, UVF, 0.005, 16), 4, 0.2);
        CHECK_CLOSE(fall_with_dt(&c, *m, USL, 0.005, 16), 2, 0.1);
    }
}

static const TestCase tests[] = {
    {"order in time, 1D", test_time_order_1d},
    {"order in time, 2D", test_time_order_2d},
    {NULL, NULL},
};
CHECK_SUITE(tests)
