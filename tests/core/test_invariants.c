/* test_invariants.c: conservation, symmetry, no effect of threads and empty space. */
#include <stdlib.h>
#include <string.h>
#include "pairs.h"

/* Momentum, and sum m |v| for its scale. */
static double momentum_of(const double *s, int n, Vec out)
{
    double size = 0;
    for (int d = 0; d < DIM; d++) out[d] = 0;
    for (int k = 0; k < n; k++)
        for (int d = 0; d < DIM; d++) {
            out[d] += s[AT_M * n + k] * s[(AT_V + d) * n + k];
            size += fabs(s[AT_M * n + k] * s[(AT_V + d) * n + k]);
        }
    return size;
}

enum { MOVES = IN_THIS_DIM(20, 20, 10) };

/* To round-off where nodes are sums over particles. WLS's are integrals: the body gains dt sum_i
 * (M_i - m_i) a_i (wls.h), at most 4.4e-6, 5.5e-5 and 3.5e-4 of sum m |v| here (h = 1/200,
 * 1/20, 1/5); a third more is allowed. */
static void check_momentum(Fixture *r)
{
    Vec before, after;
    const double share =
        r->plan.setup.method->assemble ? IN_THIS_DIM(5.8e-6, 7.3e-5, 4.7e-4) : 1e-12;
    Sim *sim = fixture_sim(r);
    const int n = sim->p.count;
    double *start = fixture_state(sim);
    int steps = 0;
    while (steps < MOVES && fixture_steps(r, sim, steps, steps + 1)) steps++;
    const Method *m = r->plan.setup.method; /* GE-MPM, tents that keep L, may be lost; in 3D all
                                               tents: corner masses eps^3 (H-5) */
    CU_ASSERT(steps == MOVES ||
              (steps >= IN_THIS_DIM(5, 5, 2) && (m->keeps_L || DIM > 2) && !m->smooth));
    double *end = fixture_state(sim), size = momentum_of(start, n, before);
    momentum_of(end, n, after);
    for (int d = 0; d < DIM; d++) CHECK_CLOSE(after[d], before[d], share * size);
    CU_ASSERT(fixture_distance(start, end, n, false) > 1e-3); /* it has moved */
    for (int k = 0; k < n; k++) CU_ASSERT(start[AT_M * n + k] == end[AT_M * n + k]);
    free(start), free(end), sim_free(sim);
}

static void test_momentum(void)
{
    for_cases(full(), check_momentum), for_total(&blocks[DIM - 1], check_momentum);
    for (int k = 0; k < 2; k++) for_cases(&on_nodes[DIM - 1][k], check_momentum);
}

/* The nodes carry the block's mass, rho times its volume, after any step. WLS integrates a fitted
 * density (off by 3e-6 in 1D, 4e-4) over cells cut straight: each of four corners, in 3D of twelve
 * edges, may lose half of one. */
static void check_mass(Fixture *r)
{
    Nodes nodes;
    const double h = r->plan.scene.cell,
                 wls = DIM == 1 ? 5e-6 : 5e-4 + IN_THIS_DIM(0, 2, 6) * h * h;
    const double off = r->plan.setup.method->assemble ? wls : 1e-11; /* empty nodes hold 1e-12 */
    r->plan.setup.snapshot_nodes = true;
    void *core = particle_solver.make(&r->plan.setup, &r->fault);
    CU_ASSERT_PTR_NOT_NULL_FATAL(core);
    for (int k = 0; k < 8; k++) {
        double mass = 0;
        CU_ASSERT_FATAL(particle_solver.step(core, k * r->dt, r->dt, k == 0).code == OK);
        particle_solver.nodes(core, &nodes);
        for (int i = 0; i < nodes.n; i++) mass += nodes.m[i];
        CHECK_CLOSE(mass, r->plan.scene.mat.rho, off); /* a unit block */
    }
    particle_solver.free(core);
}

static void test_mass(void)
{
    for_cases(full(), check_mass);
}

/* ---- mirror symmetry: a mirrored start gives the mirrored result */

enum { MIRRORED = IN_THIS_DIM(5, 5, 3) };
static int moves = MIRRORED; /* steps */
static void mirror_fields(double *const field[FIELDS], int n, int axis, double width)
{
    for (int k = 0; k < n; k++) {
        field[AT_X0 + axis][k] = width - field[AT_X0 + axis][k];
        field[AT_X + axis][k] = width - field[AT_X + axis][k];
        field[AT_V + axis][k] *= -1;
        if (field[AT_N]) field[AT_N + axis][k] *= -1;
        for (int a = 0; a < DIM; a++)
            for (int b = 0; b < DIM; b++)
                if ((a == axis) != (b == axis)) {
                    field[AT_F + a * DIM + b][k] *= -1;
                    if (field[AT_L]) field[AT_L + a * DIM + b][k] *= -1;
                }
    }
}

/* Sums run backwards: round-off alone, a few ulp per step. The scale of L is that of its terms,
 * v/h, of moments v h. */
static void check_mirror(Fixture *r)
{
    const double width = r->plan.scene.hi[0];
    const Method *method = r->plan.setup.method;
    for (int axis = 0; axis < DIM; axis++) {
        Sim *plain = fixture_sim(r), *turned = fixture_sim(r);
        const int n = plain->p.count;
        double *field[FIELDS];
        mirror_fields(turned->p.field, n, axis, width);
        sim_start_own(turned);
        CU_ASSERT_FATAL(fixture_steps(r, plain, 0, moves) && fixture_steps(r, turned, 0, moves));
        double *a = fixture_state(plain), *b = fixture_state(turned);
        for (int f = 0; f < FIELDS; f++) field[f] = b + f * n;
        mirror_fields(field, n, axis, width);
        CU_ASSERT(fixture_distance(a, b, n, false) < 1e-14);
        const double size_v = fixture_size(a, n, AT_V, DIM), h = r->plan.scene.cell;
        if (method->keeps_L)
            CU_ASSERT(fixture_gap(a, b, n, AT_L, NMAT) <
                      1e-14 * (method->moments ? size_v * h : size_v / h));
        free(a), free(b);
        sim_free(plain), sim_free(turned);
    }
}

/* One step, from the nodes: just beside them, the small mass of the next node makes a thousand ulps
 * of one. (WLS returns through the cell above a node; of GIMP's boxes some end on nodes.) */
static void check_tent_mirror(Fixture *r)
{
    if (r->plan.setup.method->smooth || r->plan.setup.method->assemble) return;
    moves = 1, check_mirror(r), moves = MIRRORED;
}

static void test_mirror(void)
{
    for_cases(&between[DIM - 1], check_mirror), for_total(&between[DIM - 1], check_mirror);
    for_cases(&on_nodes[DIM - 1][1], check_tent_mirror);
}

/* Between two symmetry planes nothing moves across: measured 2e-17 of the speed. */
static void test_planes(void)
{
    static const Case ring = {3, "ring", 5, 8, 0.2, "dim=3;allow_unstable=1"};
    if (DIM < 3) return;
    FOR_METHODS(m)
    {
        Fixture r;
        CU_ASSERT_FATAL(fixture_plan(&r, &ring, (*m)->info.name, CD, NULL));
        Sim *sim = fixture_sim(&r);
        CU_ASSERT(fixture_steps(&r, sim, 0, 6));
        double *s = fixture_state(sim);
        const double speed = fixture_size(s, sim->p.count, AT_V, DIM);
        CU_ASSERT(speed > 1);
        CU_ASSERT(fixture_size(s, sim->p.count, AT_V + DIM - 1, 1) < 1e-12 * speed);
        free(s), sim_free(sim);
    }
}

/* ---- threads */

static double *run_threads(Fixture *r, int threads)
{
    r->plan.setup.threads = threads;
    Sim *sim = fixture_sim(r);
    CU_ASSERT(fixture_steps(r, sim, 0, FEW) || (DIM > 2 && !r->plan.setup.method->smooth));
    CU_ASSERT(sim->nblock >= 3);
    double *state = fixture_state(sim);
    sim_free(sim);
    return state;
}

static void check_threads(Fixture *r)
{
    double *one = run_threads(r, 1);
    const size_t bytes = sizeof(double) * FIELDS;
    Sim *sim = fixture_sim(r);
    for (int threads = 3; threads <= 4; threads++) { /* `make repeat` has 1 to 4 */
        if (threads != 3 && (DIM > 2 || r->plan.setup.integrator != CD)) continue; /* for time */
        double *many = run_threads(r, threads);
        CU_ASSERT(memcmp(one, many, bytes * (size_t)sim->p.count) == 0);
        free(many);
    }
    free(one);
    sim_free(sim);
}

static void test_threads(void)
{
#ifndef _OPENMP
    return; /* one thread, whatever is asked for */
#endif
    for_pairs(check_threads), for_total(&blocks[DIM - 1], check_threads);
    for_cases(&on_nodes[DIM - 1][DIM > 2], check_threads);
}

/* ---- empty space: twice the box, the same block (on the same lines of the grid) */

static void check_empty_space(Fixture *r)
{
    Fixture wide = {.spec = r->spec, .dt = r->dt};
    CU_ASSERT_FATAL(spec_set(&wide.spec, "box=3", NULL) == 0);
    CU_ASSERT_FATAL(plan_make(&wide.spec, &wide.plan, &wide.fault) == 0);
    const double moved = 0.5 * (wide.plan.scene.hi[0] - r->plan.scene.hi[0]);
    Sim *small = fixture_sim(r), *large = fixture_sim(&wide);
    const int n = small->p.count;
    CU_ASSERT_FATAL(large->p.count == n);
    CU_ASSERT_FATAL(fixture_steps(r, small, 0, 10) && fixture_steps(&wide, large, 0, 10));
    double *a = fixture_state(small), *b = fixture_state(large);
    for (int k = 0; k < DIM * n; k++) b[AT_X * n + k] -= moved;
    /* positions round off differently; one particle per cell in space makes ill-conditioned planes
     */
    CU_ASSERT(fixture_distance(a, b, n, false) < (r->plan.setup.method->integrate ? 1e-10 : 1e-12));
    CU_ASSERT(small->nodes == large->nodes);
    free(a), free(b), sim_free(small), sim_free(large);
}

static void test_empty_space(void)
{
    for_cases(DIM < 3 ? &blocks[DIM - 1] : &apart, check_empty_space);
}

static const TestCase tests[] = {
    {"momentum", test_momentum},
    {"mass", test_mass},
    {"mirrored scenes", test_mirror},
    {"between two symmetry planes", test_planes},
    {"bitwise the same on any number of threads", test_threads},
    {"empty space changes nothing", test_empty_space},
    {NULL, NULL},
};
CHECK_SUITE(tests)
