/* test_wls_symbols.c: what each transfer of GE-WLS does to a plane wave of wave number k [1/cell]
 * far from surfaces, as the coefficient c of 1 - c k^2, beside the value that was derived. Two
 * particles per cell and axis, on a lattice. In one dimension and in two. */
#include <stdlib.h>
#include "common/core/passes.h"
#include "methods/wls/wls.h"
#include "wave.h"

/* v = cos(k x) along `axis` in all components, with its gradient. */
static void set_velocity(Sim *sim, int axis)
{
    const Particles *p = &sim->p;
    for (int s = 0; s < p->n; s++) {
        const double phase = k_wave * (p->field[AT_X + axis][s] - middle(sim)) * (double)CELLS;
        for (int a = 0; a < DIM; a++) {
            p->field[AT_V + a][s] = cos(phase);
            for (int b = 0; b < DIM && p->field[AT_L]; b++)
                p->field[AT_L + a * DIM + b][s] =
                    b == axis ? -k_wave * (double)CELLS * sin(phase) : 0;
        }
    }
}

/* Strain along `axis` is epsilon sin(k x), so that a = epsilon c^2 k/h cos(k x), c of P waves. */
static double set_strain(Sim *sim, int axis)
{
    const double nu = DIM > 1 ? 0.3 : 0, modulus = 1e4 * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
    const Particles *p = &sim->p;
    for (int s = 0; s < p->n; s++) {
        const double phase = k_wave * (p->field[AT_X + axis][s] - middle(sim)) * (double)CELLS;
        p->field[AT_F + axis * (DIM + 1)][s] = 1 + epsilon * sin(phase);
    }
    return epsilon * modulus * k_wave * (double)CELLS;
}

/* The particle next to the middle, by id: slots change when particles are sorted. */
static int slot_of(const Sim *sim, int id)
{
    int s = 0;
    while (sim->p.id[s] != id) s++;
    return s;
}

static int middle_particle(const Sim *sim)
{
    int best = -1;
    double least = INFINITY;
    for (int s = 0; s < sim->p.n; s++) {
        double away = 0;
        for (int d = 0; d < DIM; d++)
            away += fabs(sim->p.field[AT_X0 + d][s] - middle(sim) - 0.25 * dx);
        if (sim->p.id[s] >= 0 && sim->p.field[AT_VOL][s] > 0 && away < least)
            least = away, best = sim->p.id[s];
    }
    return best;
}

/* The fit of v (a node's own), and what a particle moves with: fit and return, of its velocity. */
static void check_motion(const char *set, int axis, double fit, double motion)
{
    Fixture r;
    Sim *sim = block_open(&r, set);
    const int id = middle_particle(sim);
    set_velocity(sim, axis);
    const double before = sim->p.field[AT_X + axis][slot_of(sim, id)];
    const double wave = cos(k_wave * (before - middle(sim)) * (double)CELLS);
    CU_ASSERT(sim_step(sim, 0, r.dt, false).code == OK);
    const double moved = sim->p.field[AT_X + axis][slot_of(sim, id)] - before;
    for (int a = 0; a < DIM; a++) check_coefficient(sim->g.node[middle_node(sim)][a], fit);
    check_coefficient(moved / (r.dt * wave), motion);
    sim_free(sim);
}

static void test_motion(void)
{
    for (int axis = 0; axis < DIM; axis++) {
        check_motion("velocity=plain;hermite=0", axis, 1.0 / 8, 1.0 / 4);
        check_motion("velocity=plain;hermite=2", axis, 1.0 / 8, 1.0 / 4);
        check_motion("velocity=corrected;hermite=2", axis, -1.0 / 8, 0);
        check_motion("velocity=corrected;hermite=1000", axis, -1.0 / 8, 0);
        check_motion("velocity=corrected;mass=lumped;hermite=1e6", axis, -1.0 / 8, 0);
    }
}

/* A wave of stress: acceleration of a node as lumped and as corrected, a particle's kick, and how
 * far the grid's own acceleration moves it. */
static void check_kick(const char *set, int axis, double node, double kick, double carry)
{
    Fixture r;
    Sim *sim = block_open(&r, set);
    const double dt = 10 * r.dt; /* one step: nothing can grow */
    const int id = middle_particle(sim);
    const double most = set_strain(sim, axis);
    const double before = sim->p.field[AT_X + axis][slot_of(sim, id)];
    const double wave = most * cos(k_wave * (before - middle(sim)) * (double)CELLS);
    CU_ASSERT(sim_step(sim, 0, dt, false).code == OK);
    const int s = slot_of(sim, id);
    check_coefficient(sim->g.node[middle_node(sim)][DIM + axis] / most, node);
    check_coefficient(sim->p.field[AT_V + axis][s] / (dt * wave), kick);
    check_coefficient((sim->p.field[AT_X + axis][s] - before) / (dt * dt * wave), carry);
    sim_free(sim);
}

static void test_kick(void)
{
    const double lumped = 1.0 / 24, back = 1.0 / 8, point = 1.0 / 4, exact = 1.0 / 6;
    for (int axis = 0; axis < DIM; axis++) {
        check_kick("mass=lumped;velocity=plain", axis, lumped, lumped + back, lumped + back);
        check_kick("mass=corrected;velocity=plain;motion=lagged", axis, lumped - point,
                   lumped - point + back, lumped + back);
        check_kick("mass=corrected;velocity=plain;motion=consistent", axis, lumped - point,
                   lumped - point + back, lumped - point + back);
        check_kick("mass=corrected;velocity=corrected;motion=consistent", axis, lumped - exact, 0,
                   0);
    }
}

/* The return alone: nodes that have the wave itself. */
static void test_return(void)
{
    for (int axis = 0; axis < DIM; axis++) {
        Fixture r;
        Sim *sim = block_open(&r, "return=spline");
        const int slot = slot_of(sim, middle_particle(sim));
        CU_ASSERT(sim_project(sim).code == OK);
        Grid *g = &sim->g;
        for (int row = 0; row < g->rows; row++)
            for (int i = g->lo[row]; i < g->hi[row]; i++) {
                const int index[] = {i, row, 0};
                const double x = (index[axis] + g->origin[axis]) * dx - middle(sim);
                for (int a = 0; a < DIM; a++)
                    g->node[(size_t)row * (size_t)g->n[0] + (size_t)i][a] =
                        cos(k_wave * x * (double)CELLS);
            }
        const double before = sim->p.field[AT_X + axis][slot];
        gather_all(sim, dx, TAKE_X);
        const double moved = (sim->p.field[AT_X + axis][slot] - before) / dx;
        check_coefficient(moved / cos(k_wave * (before - middle(sim)) * (double)CELLS), 1.0 / 8);
        sim_free(sim);
    }
}

static const TestCase tests[] = {
    {"fit 1 - k^2/8, motion 1 - k^2/4, corrected 1", test_motion},
    {"kick of a lumped, a one-point and an exact mass matrix", test_kick},
    {"return 1 - k^2/8", test_return},
    {NULL, NULL},
};
CHECK_SUITE(tests)
