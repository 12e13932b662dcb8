/* test_handover.c: a run that goes on with another method: what the particles keep, for every pair
 * of methods, and what the run records. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "common/core/passes.h"
#include "common/run/loop.h"
#include "tests/fixture.h"

/* A body that turns, drifts, stretches and shears, without walls. In 2D its particles fill no whole
 * chunks. */
static const Case scenes[] = {{1, "free_block", 12, 0, 0, "dim=1"},
                              {2, "free_block", 12, 9, 0, "dim=2"},
                              {3, "free_block", 6, 8, 0, "dim=3"}};

/* Momentum and, about the origin, angular momentum: (0, 1), (0, 2), (1, 2). */
typedef struct Motion {
    double p[DIM], turn[3], size, energy;
} Motion;

static Motion motion_zero(void)
{
    return (Motion){.size = 0};
}

static void add(Motion *m, double mass, const double x[DIM], const double v[DIM])
{
    for (int a = 0, k = 0; a < DIM; a++) {
        m->p[a] += mass * v[a];
        m->size += mass * fabs(v[a]);
        for (int b = a + 1; b < DIM; b++) m->turn[k++] += mass * (x[a] * v[b] - x[b] * v[a]);
    }
}

/* Of the nodes that the particles' velocities give: their affine parts included. */
static Motion of_nodes(Sim *sim)
{
    Motion m = motion_zero();
    const Grid *g = &sim->g;
    if (sim->travel > 0) sim_sort(sim);
    deposit_all(sim, 0, MOTION);
    for (int row = 0; row < g->rows; row++)
        for (int i = g->lo[row]; i < g->hi[row]; i++) {
            const Line n = g->node[(size_t)row * (size_t)g->n[0] + (size_t)i];
            double x[DIM], p[DIM];
            int index[DIM] = {i}, rest = row;
            for (int d = 1; d < DIM; d++) index[d] = rest % g->n[d], rest /= g->n[d];
            for (int d = 0; d < DIM; d++) {
                x[d] = (index[d] + g->origin[d]) * sim->dx;
                p[d] = n[1 + d];
            }
            add(&m, 1, x, p);
        }
    return m;
}

/* Of the particles, with K + S. */
static Motion of_particles(const Sim *sim)
{
    Motion m = motion_zero();
    const Particles *p = &sim->p;
    for (int k = 0; k < p->n; k++) {
        double x[DIM], v[DIM], w, F[NMAT];
        const double *f[NMAT];
        for (int d = 0; d < DIM; d++) x[d] = p->field[AT_X + d][k], v[d] = p->field[AT_V + d][k];
        for (int c = 0; c < NMAT; c++) F[c] = p->field[AT_F + c][k], f[c] = &F[c];
        add(&m, p->field[AT_M][k], x, v);
        material_stored_energy(&sim->setup->scene->mat, 1, f, &w);
        m.energy += p->field[AT_VOL][k] * w;
        for (int d = 0; d < DIM; d++) m.energy += 0.5 * p->field[AT_M][k] * v[d] * v[d];
    }
    return m;
}

/* With affine parts, where a method has them on its grid: that of least squares has its own mass,
 * and corners that move by themselves have another middle than the particle. */
static Motion of_method(Sim *sim)
{
    const bool moves = sim->method.own && !sim->method.modes;
    return sim->method.assemble || moves ? of_particles(sim) : of_nodes(sim);
}

static bool carries_slopes(const Method *m)
{
    return m->affine || m->modes;
}

static double gap(const Motion *a, const Motion *b)
{
    double most = 0;
    for (int d = 0; d < DIM; d++) most = fmax(most, fabs(a->p[d] - b->p[d]));
    for (int k = 0; k < 3; k++) most = fmax(most, fabs(a->turn[k] - b->turn[k]));
    return most / a->size;
}

/* Steps before and after a hand-over. */
enum { STEPS = IN_THIS_DIM(10, 10, 4) };

/* Largest change of K + S in one of these steps. */
static double run_up(const Fixture *r, Sim *sim)
{
    double most = 0;
    for (int k = 0; k < STEPS; k++) {
        const double before = of_particles(sim).energy;
        CU_ASSERT(fixture_steps(r, sim, k, k + 1));
        most = fmax(most, fabs(of_particles(sim).energy - before));
    }
    return most;
}

static void check_pair(const Method *first, const Method *second)
{
    Fixture a, b;
    Fault fault = {0};
    if (DIM > 2 && !first->affine && !second->affine && first != second) return; /* for time */
    if (!fixture_plan(&a, &scenes[DIM - 1], first->info.name, CD, NULL)) return;
    if (!fixture_plan(&b, &scenes[DIM - 1], second->info.name, CD,
                      a.plan.setup.fitted ? "layout=radial" : "layout=cartesian"))
        return;
    if (first->frame == FRAME_TOTAL || second->frame == FRAME_TOTAL) return; /* refused */
    Sim *from = fixture_sim(&a), *to = fixture_sim(&b);
    const double step = run_up(&a, from);
    const Motion before = of_method(from);
    const double energy = of_particles(from).energy;
    CU_ASSERT(sim_take_over(to, from, &fault) == 0);
    const Motion particles = of_particles(to), after = of_method(to);
    const bool tents = !to->method.smooth && !to->method.assemble; /* unstable, some of them */
    const bool turned = carries_slopes(&from->method) && !carries_slopes(&to->method);
    CHECK_CLOSE(gap(&before, &after), 0, 1e-12);
    CU_ASSERT(before.size > 0 && step > 0);
    CU_ASSERT(turned || fabs(particles.energy - energy) <= step);
    CU_ASSERT(fixture_steps(&b, to, STEPS, 2 * STEPS) || tents);
    sim_free(from);
    sim_free(to);
}

static void test_pairs(void)
{
    FOR_METHODS(first)
    FOR_METHODS(second) check_pair(*first, *second);
}

static const TestCase tests[] = {
    {"momentum, angular momentum and energy, for every pair of methods", test_pairs},
    {NULL, NULL},
};
CHECK_SUITE(tests)
