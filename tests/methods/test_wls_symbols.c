/* test_wls_symbols.c: what each transfer of GE-WLS does to a plane wave of wave number k [1/cell]
 * far from surfaces, as the coefficient c of 1 - c k^2, beside the value that was derived; then the
 * consistent mass matrix. Two particles a cell and axis, on a lattice. In one dimension and in two.
 */
#include <stdlib.h>
#include "common/core/passes.h"
#include "methods/wls/wls.h"
#include "tests/fixture.h"

enum { CELLS = 16 };
static const double k_wave = 2 * M_PI / 128; /* [1/cell] */
static const double epsilon = 3e-7;          /* amplitude of the strain */
static const double dx = 1.0 / CELLS;

/* The block in the middle of its box, its lattice on the grid lines. */
static Sim *block_open(Rig *r, const char *more)
{
    const Case block = {.dim = DIM, .problem = "block", .cells = CELLS};
    char set[256];
    snprintf(set, sizeof set, "dim=%d;layout=radial;%s", DIM, more);
    CU_ASSERT_FATAL(rig_plan(r, &block, "ge_wls", CD, set));
    Sim *sim = rig_sim(r);
    sim_sort(sim);
    return sim;
}

static double middle(const Sim *sim)
{
    return 0.5 * (sim->setup->scene->lo[0] + sim->setup->scene->hi[0]);
}

/* v = cos(k x) along `axis` in all components, with its gradient. */
static void set_velocity(Sim *sim, int axis)
{
    const Particles *p = &sim->p;
    for (int s = 0; s < p->n; s++) {
        const double phase = k_wave * (p->field[AT_X + axis][s] - middle(sim)) * CELLS;
        for (int a = 0; a < DIM; a++) {
            p->field[AT_V + a][s] = cos(phase);
            for (int b = 0; b < DIM && p->field[AT_L]; b++)
                p->field[AT_L + a * DIM + b][s] = b == axis ? -k_wave * CELLS * sin(phase) : 0;
        }
    }
}

/* Strain along `axis` is epsilon sin(k x), so that a = epsilon c^2 k/h cos(k x), c of P waves. */
static double set_strain(Sim *sim, int axis)
{
    const double nu = DIM > 1 ? 0.3 : 0, modulus = 1e4 * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
    const Particles *p = &sim->p;
    for (int s = 0; s < p->n; s++) {
        const double phase = k_wave * (p->field[AT_X + axis][s] - middle(sim)) * CELLS;
        p->field[AT_F + axis * (DIM + 1)][s] = 1 + epsilon * sin(phase);
    }
    return epsilon * modulus * k_wave * CELLS;
}

static size_t middle_node(const Sim *sim)
{
    const Grid *g = &sim->g;
    size_t at = 0;
    for (int d = DIM - 1; d >= 0; d--)
        at = at * (size_t)g->n[d] + (size_t)(lround(middle(sim) * CELLS) - g->origin[d]);
    return at;
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

static double coefficient(double ratio)
{
    return (1 - ratio) / (k_wave * k_wave);
}

/* Within 1 % of what was derived; where that is 0, of the smallest that is not, 1/24. */
static void check_coefficient(double ratio, double derived)
{
    const double most = derived == 0 ? 1.0 / 24 : fabs(derived);
    CHECK_CLOSE(coefficient(ratio), derived, 0.01 * most);
}

/* The fit of v (a node's own), and what a particle moves with: fit and return, of its velocity. */
static void check_motion(const char *set, int axis, double fit, double motion)
{
    Rig r;
    Sim *sim = block_open(&r, set);
    const int id = middle_particle(sim);
    set_velocity(sim, axis);
    const double before = sim->p.field[AT_X + axis][slot_of(sim, id)];
    const double wave = cos(k_wave * (before - middle(sim)) * CELLS);
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
    Rig r;
    Sim *sim = block_open(&r, set);
    const double dt = 10 * r.dt; /* one step: nothing can grow */
    const int id = middle_particle(sim);
    const double most = set_strain(sim, axis);
    const double before = sim->p.field[AT_X + axis][slot_of(sim, id)];
    const double wave = most * cos(k_wave * (before - middle(sim)) * CELLS);
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
        Rig r;
        Sim *sim = block_open(&r, "return=spline");
        const int slot = slot_of(sim, middle_particle(sim));
        CU_ASSERT(sim_project(sim).code == OK);
        Grid *g = &sim->g;
        for (int row = 0; row < g->rows; row++)
            for (int i = g->lo[row]; i < g->hi[row]; i++) {
                const int index[] = {i, row, 0};
                const double x = (index[axis] + g->origin[axis]) * dx - middle(sim);
                for (int a = 0; a < DIM; a++)
                    g->node[(size_t)row * (size_t)g->n[0] + (size_t)i][a] = cos(k_wave * x * CELLS);
            }
        const double before = sim->p.field[AT_X + axis][slot];
        gather_all(sim, dx, TAKE_X);
        const double moved = (sim->p.field[AT_X + axis][slot] - before) / dx;
        check_coefficient(moved / cos(k_wave * (before - middle(sim)) * CELLS), 1.0 / 8);
        sim_free(sim);
    }
}

/* The wave on the nodes times M, over D; one entry of M after the other in a full cell's middle. */
static void multiply(Sim *sim, const double *x)
{
    const Grid *g = &sim->g;
    Wls *w = wls_of(sim);
    for (int row = 0; row < g->rows; row++)
        for (int i = g->lo[row]; i < g->hi[row]; i++) {
            const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
            w->inertia[at] = (Inertia){{0}, {0}, {0}};
            w->inertia[at].factor[I_V] = x[at];
        }
    wls_mass_times(sim);
}

static double *node_field(const Sim *sim)
{
    double *x = calloc((size_t)sim->g.rows * (size_t)sim->g.n[0] + 1, sizeof *x);
    CU_ASSERT_PTR_NOT_NULL_FATAL(x);
    return x;
}

static void test_matrix_symbol(void)
{
    Rig r;
    static const char *const set[] = {"velocity=plain", "velocity=corrected"};
    for (int exact = 0; exact < 2; exact++) {
        Sim *sim = block_open(&r, set[exact]);
        const Grid *g = &sim->g;
        CU_ASSERT(sim_project(sim).code == OK);
        double *x = node_field(sim);
        for (int row = 0; row < g->rows; row++)
            for (int i = 0; i < g->n[0]; i++)
                x[row * g->n[0] + i] = cos(k_wave * (i + g->origin[0] - middle(sim) * CELLS));
        multiply(sim, x);
        const Inertia in = wls_of(sim)->inertia[middle_node(sim)];
        check_coefficient(in.product[I_V] / in.row[I_SUM], exact ? 1.0 / 6 : 1.0 / 4);
        free(x), sim_free(sim);
    }
}

/* Entries 2/3 and 1/6 an axis, rho h^DIM their unit; others are 0. */
static void test_matrix_entries(void)
{
    Rig r;
    Sim *sim = block_open(&r, "velocity=corrected");
    CU_ASSERT(sim_project(sim).code == OK);
    const size_t middle_at = middle_node(sim), row = (size_t)sim->g.n[0];
    double *x = node_field(sim);
    x[middle_at] = 1;
    multiply(sim, x);
    for (int j = DIM > 1 ? -2 : 0; j <= (DIM > 1 ? 2 : 0); j++)
        for (int i = -2; i <= 2; i++) {
            static const double entry[] = {2.0 / 3, 1.0 / 6, 0};
            const size_t at = (size_t)((ptrdiff_t)middle_at + j * (ptrdiff_t)row + i);
            const double want = entry[abs(i)] * (DIM > 1 ? entry[abs(j)] : 1) * pow(dx, DIM);
            CHECK_CLOSE(wls_of(sim)->inertia[at].product[I_V], want, 1e-14 * pow(dx, DIM));
        }
    free(x), sim_free(sim);
}

/* Off the grid's lines, turned in the plane: all cells of its edge are cut. */
static const char askew[] =
    "offset_x=.3;velocity=corrected" IN_THIS_DIM("", ";offset_y=.2;angle=20", "");

/* sum over live nodes of y times (M x). */
static double form(Sim *sim, const double *y, const double *x)
{
    const Grid *g = &sim->g;
    double sum = 0;
    multiply(sim, x);
    for (int row = 0; row < g->rows; row++)
        for (int i = g->lo[row]; i < g->hi[row]; i++) {
            const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i;
            sum += y[at] * wls_of(sim)->inertia[at].product[I_V];
        }
    return sum;
}

/* First moments are M times coordinates less row sums; and M is symmetric, cut cells included. */
static void test_moments(void)
{
    Rig r;
    Sim *sim = block_open(&r, askew);
    CU_ASSERT(sim_project(sim).code == OK);
    const Grid *g = &sim->g;
    const size_t n = (size_t)g->rows * (size_t)g->n[0];
    double *x = node_field(sim), *y = node_field(sim);
    for (int d = 0; d < DIM; d++) {
        const size_t wide = (size_t)g->n[0];
        for (size_t at = 0; at < n; at++) x[at] = (double)(d ? at / wide : at % wide);
        multiply(sim, x);
        for (size_t at = 0; at < n; at++) {
            const int row = (int)(at / wide), i = (int)(at % wide);
            if (i < g->lo[row] || i >= g->hi[row]) continue;
            const Inertia in = wls_of(sim)->inertia[at];
            CHECK_CLOSE(in.product[I_V], in.row[I_FIRST + d] + x[at] * in.row[I_SUM],
                        1e-12 * pow(dx, DIM));
        }
    }
    for (size_t at = 0; at < n; at++) x[at] = rig_random(-1, 1), y[at] = rig_random(-1, 1);
    const double sum = form(sim, y, x);
    CHECK_CLOSE(sum, form(sim, x, y), 1e-14);
    CU_ASSERT(fabs(sum) > 1e-5);
    free(x), free(y), sim_free(sim);
}

extern const TestCase wls_symbols_tests[];
const TestCase wls_symbols_tests[] = {
    {"fit 1 - k^2/8, motion 1 - k^2/4, corrected 1", test_motion},
    {"kick of a lumped, a one-point and an exact mass matrix", test_kick},
    {"return 1 - k^2/8", test_return},
    {"mass matrix 1 - k^2/6", test_matrix_symbol},
    {"its entries in full cells", test_matrix_entries},
    {"its first moments and symmetry, cut cells included", test_moments},
    {NULL, NULL},
};
