/* test_sort_and_walls.c: the order of particles, blocks for threads, and what walls and symmetry
 * lines leave of the nodes' motion. */
#include <stdlib.h>
#include "tests/fixture.h"

static const Case moving[] = {{1, "free_block", 200, 3, 0, "drift=10;box=2"},
                              {2, "free_block", 16, 4, 0, "drift=4;spin=2;box=2"},
                              {3, "free_block", 10, 8, 0.1, "drift=2;box=2;swing=0"}};

/* Where the particle's stencil stands: GIMP's about the nearest node. */
static void lattice_cell(const Sim *sim, int slot, int cell[DIM])
{
    for (int d = 0; d < DIM; d++)
        cell[d] = (int)floor(sim->p.field[AT_X + d][slot] * sim->g.cells + 0.5);
}

/* -1, 0, 1: last axis first. */
static int compare_cells(const int a[DIM], const int b[DIM])
{
    for (int d = DIM - 1; d >= 0; d--)
        if (a[d] != b[d]) return a[d] < b[d] ? -1 : 1;
    return 0;
}

/* After a sort: cells ascend, and in one cell particles keep the order they had. */
static void check_sorted(const Sim *sim, const int before[])
{
    int last = -1, same = 0, cell[DIM], next[DIM];
    for (int s = 0; s < sim->p.n; s++) {
        const int id = sim->p.id[s];
        if (id < 0) continue;
        lattice_cell(sim, s, next);
        const int order = last < 0 ? -1 : compare_cells(cell, next);
        CU_ASSERT(order <= 0);
        if (order == 0) CU_ASSERT(before[last] < before[id]);
        same += order == 0;
        last = id;
        for (int d = 0; d < DIM; d++) cell[d] = next[d];
    }
    CU_ASSERT(same > 10);
}

static void test_sort(void)
{
    Fixture r;
    CU_ASSERT_FATAL(fixture_plan(&r, &moving[DIM - 1], "gimp", CD, NULL));
    Sim *sim = fixture_sim(&r);
    int *before = calloc((size_t)sim->p.count, sizeof *before);
    CU_ASSERT_PTR_NOT_NULL_FATAL(before);
    for (int k = 0; k < 10; k++) {
        CU_ASSERT_FATAL(fixture_steps(&r, sim, 10 * k, 10 * k + 10));
        for (int s = 0; s < sim->p.n; s++)
            if (sim->p.id[s] >= 0) before[sim->p.id[s]] = s;
        sim_sort(sim);
        CU_ASSERT(sim_is_valid(sim));
        check_sorted(sim, before);
    }
    free(before);
    sim_free(sim);
}

/* First and last line of nodes, across the last axis, that a block's chunks write to. */
static void reach_of(const Sim *sim, const Block *block, int *lo, int *hi)
{
    const Method *m = sim->setup->method;
    const int d = DIM - 1, width = m->width(fmax(0.5, sim->half_now));
    Stencil stencil;
    *lo = sim->g.n[d], *hi = -1;
    for (int k = block->first; k < block->last; k++) {
        Field x, b;
        for (int p = 0; p < CHUNK; p++) {
            const int s = k * CHUNK + p;
            const int at = sim->total ? AT_X0 : AT_X; /* reference frame: undeformed boxes at X */
            x[p] = sim->p.field[at + d][s] * sim->g.cells - sim->g.origin[d];
            b[p] = sim->half * (sim->total ? 1 : fabs(sim->p.field[AT_F + NMAT - 1][s]));
        }
        m->shape(&sim->g.axis[d], width, x, b, &stencil);
        for (int p = 0; p < CHUNK; p++) {
            *lo = stencil.base[p] < *lo ? stencil.base[p] : *lo;
            *hi = stencil.base[p] + width > *hi ? stencil.base[p] + width : *hi;
        }
    }
}

/* Blocks of equal parity, which threads work on at once, never meet at a node. */
static void check_blocks(const Sim *sim)
{
    int end[2] = {-1, -1};
    for (int b = 0; b < sim->nblock; b++) {
        int lo, hi;
        if (sim->block[b].first == sim->block[b].last) continue;
        reach_of(sim, &sim->block[b], &lo, &hi);
        CU_ASSERT(lo >= end[b % 2]);
        end[b % 2] = hi;
    }
    CU_ASSERT(end[0] > 0 && end[1] > 0);
}

static void test_blocks(void)
{
    FOR_METHODS(m) for (int ppc = 1; ppc <= 2; ppc++)
    {
        Fixture r;
        Case c = moving[DIM - 1];
        /* alone in the middle of a cell in 3D a particle has the weight 1/8: below the trigger */
        if (DIM > 2 && ppc == 1 && (*m)->assemble) continue;
        if ((*m)->list) continue; /* no stencil of one axis */
        c.ppc = pow(ppc, DIM);    /* 1: half widths beyond h/2 */
        CU_ASSERT_FATAL(fixture_plan(&r, &c, (*m)->info.name, USL, "allow_unstable=1"));
        Sim *sim = fixture_sim(&r);
        sim_sort(sim);
        for (int k = 0; k < 20; k++) {
            check_blocks(sim);
            CU_ASSERT_FATAL(fixture_steps(&r, sim, k, k + 1));
            CU_ASSERT(sim_is_valid(sim));
        }
        sim_free(sim);
    }
}

static const Case walled[] = {{1, "bar", 20, 2, 0, NULL},
                              {1, "sine_bar", 20, 2, 0, "A=0.1"},
                              {2, "plate_vibration", 10, 4, 0, "A=0.05"},
                              {2, "ring", 8, 4, 0, NULL},
                              {3, "axis_mms", 6, 8, 0, NULL},
                              {3, "shell", 6, 8, 0, NULL}};

/* On a wall, and beyond if there are no images, held components are exactly 0; on a symmetry line
 * the normal one is, to the round-off of its two equal halves. */
static int check_wall(const Wall *w, bool images, const Nodes *n, double fastest)
{
    int touched = 0;
    for (int i = 0; i < n->n; i++) {
        const double beyond = w->side * (n->x[w->axis][i] - w->at);
        for (int a = 0; a < DIM; a++) {
            if (!w->mirror && w->hold >> a & 1 && beyond > -1e-9 && !(images && beyond > 1e-9)) {
                CU_ASSERT(n->v[a][i] == 0);
                touched++;
            }
            if (w->mirror && a == w->axis && fabs(beyond) < 1e-9) {
                CHECK_CLOSE(n->v[a][i], 0, 1e-13 * fastest);
                touched++;
            }
        }
    }
    return touched;
}

static void check_walls(Fixture *r)
{
    Nodes nodes;
    const Method own = method_adapted(r->plan.setup.method, r->plan.setup.method_par);
    r->plan.setup.snapshot_nodes = true;
    void *core = particle_solver.make(&r->plan.setup, &r->fault);
    CU_ASSERT_PTR_NOT_NULL_FATAL(core);
    for (int k = 0; k < 10; k++) {
        double fastest = 0;
        CU_ASSERT_FATAL(particle_solver.step(core, k * r->dt, r->dt, k == 0).code == OK);
        particle_solver.nodes(core, &nodes);
        for (int i = 0; i < nodes.n; i++)
            for (int a = 0; a < DIM; a++) fastest = fmax(fastest, fabs(nodes.v[a][i]));
        CU_ASSERT(fastest > 0.1);
        for (int w = 0; w < r->plan.scene.nwall; w++)
            CU_ASSERT(check_wall(&r->plan.scene.wall[w], own.wall_images, &nodes, fastest) > 0);
    }
    particle_solver.free(core);
}

static void test_walls(void)
{
    for (int k = 0; k < COUNT(walled); k++) FOR_METHODS(m)
        {
            Fixture r;
            if (walled[k].dim != DIM) continue;
            CU_ASSERT_FATAL(fixture_plan(&r, &walled[k], (*m)->info.name, USF, "allow_unstable=1"));
            check_walls(&r);
        }
}

static const TestCase tests[] = {
    {"sorted by cell, and stable", test_sort},
    {"blocks that run at once are apart", test_blocks},
    {"walls and symmetry lines hold their nodes", test_walls},
    {NULL, NULL},
};
CHECK_SUITE(tests)
