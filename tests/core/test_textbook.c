/* test_textbook.c: the fast core against the textbook code (textbook.h): every method that it has,
 * every integrator, on scenes with motion, rotation, walls, symmetry lines and body forces. */
#include <stdlib.h>
#include "tests/fixture.h"
#include "tests/textbook/textbook.h"

/* Both add the same numbers in other orders: a step differs by a few ulp (1e-16), measured 1e-15 to
 * 1e-13 relative to each quantity after 20 steps; 1e-12 is far below anything done differently. The
 * scale of L is that of its terms, v/h, of moments v h. */
static const double same = 1e-12;

/* None of these comes within 1e-7 cells of where GIMP's weight of a node ends, where an ulp of x is
 * 1e-9 of what it gives L.
 * Half widths beyond h/2: ppc 0.7, or 1 and stretched. Turning, drifting and swinging; walls;
 * mirrors with a corner, and body force that depends on time (ring); walls that hold one component
 * (plate). */
static const Case short_scenes[] = {
    {1, "bar", 20, 0, 0, NULL},
    {1, "bar", 20, 0.7, 0, "law=linear"},
    {1, "sine_bar", 20, 1, 0, "A=0.1"},
    {1, "sine_bar", 20, 2.3, 0, "A=0.1;law=linear"},
    {1, "free_block", 16, 0.7, 0, "drift=5"},
    {1, "free_block", 80, 2.9, 0, "box=1.51"},
    {2, "free_block", 16, 4, 0, "box=1.63"},
    {2, "free_block", 10, 1, 0.1, "box=1.63;swing=2;spin=3"},
    {2, "ring", 8, 4, 0.2, "A=0.03"},
    {2, "ring", 8, 1, 0.1, NULL},
    {2, "plate_vibration", 8, 4, 0, "A=0.04"},
    {2, "plate_vibration", 8, 1, 0, "A=0.04;law=linear"},
};

/* Particles start on nodes, some or all, along one axis or both, at the body's edges and inside; or
 * come to lie on them: at CFL 0.3 a drift of 5/6 c is a quarter of a cell a step. */
static const Case node_scenes[] = {
    {1, "block", 4, 2, 0.1, "offset_x=0.25;drift_x=0.1"},
    {1, "block", 4, 2, 0.1, "offset_x=0.375;stretch=1.5"},
    {1, "block", 16, 1, 0.3, "offset_x=0.5;drift_x=0.8333333333333334"},
    {1, "free_block", 80, 1, 0.1, "box=1.5125"},
    {2, "block", 8, 4, 0.1, "offset_x=0.125;offset_y=-0.25;stretch=1.5"},
    {2, "block", 8, 1, 0.1, "offset_x=0.5;offset_y=0.5;angle=90;stretch=1.01"},
    {2, "block", 8, 4, 0.3, "drift_x=0.8333333333333334;drift_y=-0.8333333333333334"},
    {2, "free_block", 16, 4, 0.1, "box=1.53125"},
    {2, "free_block", 10, 1, 0.1, "box=1.6;swing=2"},
};

static const Case long_scenes[] = {
    {1, "sine_bar", 20, 2, 0, "A=0.1"},
    {1, "free_block", 150, 2.9, 0, "drift=5;box=2.01"},
    {2, "free_block", 8, 4, 0, "box=4;spin=0.5;drift=3"},
    {2, "ring", 8, 4, 0, NULL},
};

static double *twin_state(const Twin *w)
{
    const int n = w->n;
    double *s = calloc((size_t)(FIELDS * n) + 1, sizeof *s);
    CU_ASSERT_PTR_NOT_NULL_FATAL(s);
    for (int k = 0; k < n; k++) {
        const TwinParticle *p = &w->p[k];
        for (int d = 0; d < DIM; d++) {
            s[(AT_X + d) * n + k] = p->x[d];
            s[(AT_V + d) * n + k] = p->v[d];
            for (int b = 0; b < DIM; b++) {
                s[(AT_F + d * DIM + b) * n + k] = p->F[d][b];
                s[(AT_L + d * DIM + b) * n + k] = p->L[d][b];
            }
        }
    }
    return s;
}

/* Steps both; returns how often the particles were sorted again on the way. */
static int step_both(const Fixture *r, Sim *sim, Twin *w, int steps)
{
    int sorts = 0;
    for (int k = 0; k < steps; k++) {
        const double *const order = sim->p.field[AT_X]; /* a sort moves fields */
        const bool ok = fixture_steps(r, sim, k, k + 1);
        CU_ASSERT(ok);
        if (!ok) break;
        CU_ASSERT(sim_is_valid(sim));
        twin_step(w, k * r->dt, r->dt, k == 0);
        sorts += k > 0 && sim->p.field[AT_X] != order;
    }
    return sorts;
}

static void compare(Fixture *r, int steps, int least_sorts)
{
    const bool L = r->plan.setup.method->keeps_L;
    Twin *w = twin_new(&r->plan.setup);
    if (!w) return; /* a method that the textbook code does not have */
    Sim *sim = fixture_sim(r);
    CU_ASSERT_FATAL(sim->p.count == w->n);
    const int sorts = step_both(r, sim, w, steps);
    CU_ASSERT(sorts >= least_sorts && 3 * sorts < steps); /* often enough, and not for nothing */
    CU_ASSERT(sorts == 0 || !sim->total);
    double *fast = fixture_state(sim), *slow = twin_state(w);
    CU_ASSERT(fixture_distance(slow, fast, w->n, false) < same);
    const double size_v = fixture_size(slow, w->n, AT_V, DIM), h = w->h;
    const double size_L = w->method.moments ? size_v * h : size_v / h;
    if (L) CU_ASSERT(fixture_gap(slow, fast, w->n, AT_L, NMAT) < same * size_L);
    free(fast), free(slow);
    twin_free(w);
    sim_free(sim);
}

static void test_pairs(void)
{
    for (int k = 0; k < COUNT(short_scenes); k++)
        FOR_METHODS(m) FOR_INTEGRATORS(i) for (int fresh = 0; fresh < 2; fresh++)
        {
            Fixture r;
            const char *more = fresh ? "allow_unstable=1;refresh=1" : "allow_unstable=1";
            if (short_scenes[k].dim != DIM || (fresh && i != UVF && i != MUSL)) continue;
            CU_ASSERT_FATAL(fixture_plan(&r, &short_scenes[k], (*m)->info.name, i, more));
            compare(&r, (*m)->modes ? 5 : 10, 0); /* light nodes amplify round-off */
        }
}

/* Tents alone: GIMP's weights end where ulps decide. */
static bool has_slopes_on_nodes(const Method *m)
{
    return !m->smooth && !m->assemble;
}

static void test_on_nodes(void)
{
    for (int k = 0; k < COUNT(node_scenes); k++)
        FOR_METHODS(m) FOR_INTEGRATORS(i) for (int fresh = 0; fresh < 2; fresh++)
        {
            Fixture r;
            const char *more = fresh ? "allow_unstable=1;refresh=1" : "allow_unstable=1";
            if (node_scenes[k].dim != DIM || !has_slopes_on_nodes(*m)) continue;
            CU_ASSERT_FATAL(fixture_plan(&r, &node_scenes[k], (*m)->info.name, i, more));
            compare(&r, (*m)->keeps_L ? 4 : 6, 0); /* GE-MPM amplifies round-off, 6 times a step */
        }
}

/* ---- a scene of every dimension: a block in a corner of symmetry lines, pushed to and fro, held
 * at one end; its particles in the midst of cells or, moved by half a cell, on nodes, lines and
 * wall */

static double corner_shift; /* [m] */

static int corner_init(Scene *s, char why[128])
{
    (void)why;
    s->mat = material_make(NEO_HOOKEAN, 1e4, DIM == 1 ? 0 : 0.3, 2);
    for (int d = 0; d < DIM; d++) {
        s->hi[d] = 1.5, s->body_hi[d] = 1;
        s->wall[s->nwall++] = (Wall){.axis = d, .side = -1, .at = 0, .mirror = true};
    }
    s->wall[s->nwall++] = (Wall){.axis = 0, .side = 1, .at = 1, .hold = 1};
    s->c = material_wave_speed_bound(&s->mat);
    return 0;
}

static void corner_start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F,
                         Fields L)
{
    (void)L;
    for (int d = 0; d < DIM; d++)
        for (int p = 0; p < n; p++) {
            const int next = (d + 1) % DIM;
            u[d][p] = corner_shift;
            v[d][p] = 0.1 * s->c * sin(2 * X[d][p]) * cos(X[next][p]);
            F[d * (DIM + 1)][p] = 1.05;
            F[d * DIM + next][p] += 0.03 * X[d][p];
        }
}

static void corner_push(const Scene *s, int n, ConstFields X, double t, Fields b)
{
    for (int d = 0; d < DIM; d++)
        for (int p = 0; p < n; p++)
            b[d][p] = 0.2 * s->c * s->c * X[d][p] * cos(s->c * t + X[(d + 1) % DIM][p]);
}

/* Steps: in 3D, where the textbook code is slow, enough for all that a step leaves to the next. */
enum { CORNER_CELLS = IN_THIS_DIM(6, 6, 4), CORNER_STEPS = IN_THIS_DIM(20, 20, 6) };

static const Problem corner = {
    .cfl = 0.1, .init = corner_init, .start = corner_start, .body = corner_push};

static void test_corner(void)
{
    for (int n = 1; n <= 2; n++)
        for (int k = 0; k < VARIANTS; k++) FOR_METHODS(m) FOR_INTEGRATORS(i)
            {
                Fixture r;
                if (DIM > 2 && i > UVF) continue; /* one pass and two, for time */
                if (DIM > 2 && n > 1 && (i != CD || k > 0)) continue;
                fixture_scene(&r, &corner, *m, i, CORNER_CELLS, pow(n, DIM));
                if (fixture_vary(&r, k)) compare(&r, CORNER_STEPS, 0);
            }
}

/* The same of the reference grid: initial F and L are not trivial here. */
static void test_corner_total(void)
{
    FOR_METHODS(m) FOR_INTEGRATORS(i)
    {
        Fixture r;
        if ((*m)->assemble || (*m)->integrate || (DIM > 2 && i > UVF)) continue;
        fixture_scene(&r, &corner, *m, i, CORNER_CELLS, DIM > 2 ? 1 : pow(2, DIM));
        r.plan.setup.frame = FRAME_TOTAL;
        compare(&r, CORNER_STEPS, 0);
    }
}

static void test_corner_on_nodes(void)
{
    int compared = 0;
    for (int n = 1; n <= 2; n++)
        for (int side = -1; side <= 1; side += 2) FOR_METHODS(m) FOR_INTEGRATORS(i)
            {
                Fixture r;
                if (!has_slopes_on_nodes(*m) || (DIM > 2 && i > (n > 1 ? CD : UVF))) continue;
                corner_shift = side * 0.5 / n / (double)CORNER_CELLS;
                fixture_scene(&r, &corner, *m, i, CORNER_CELLS, pow(n, DIM));
                compare(&r, 20, 0);
                compared++;
            }
    corner_shift = 0;
    CU_ASSERT(compared > 0);
}

/* 120 steps of what is stable, 60 where nothing but the integrator's order of passes is new:
 * smooth weights and valid pairs. (A block that spins faster is lost by XPIC and FMPM with cd, by
 * those of the textbook code as well.) */
static void test_long(void)
{
    for (int k = 0; k < COUNT(long_scenes); k++) FOR_METHODS(m) FOR_INTEGRATORS(i)
        {
            Fixture r;
            const bool fresh = !fixture_valid(*m, i, false);
            if (long_scenes[k].dim != DIM || !(*m)->smooth || !fixture_valid(*m, i, true)) continue;
            if ((*m)->modes) continue; /* light nodes amplify round-off */
            CU_ASSERT_FATAL(
                fixture_plan(&r, &long_scenes[k], (*m)->info.name, i, fresh ? "refresh=1" : NULL));
            compare(&r, i > UVF ? 60 : 120, i > UVF ? 2 : 4);
        }
}

/* The scenes do what they are here for. */
static void test_scenes(void)
{
    int wide = 0, narrow = 0, chunks = 0;
    for (int k = 0; k < COUNT(short_scenes); k++) {
        Fixture r;
        if (short_scenes[k].dim != DIM) continue;
        CU_ASSERT_FATAL(fixture_plan(&r, &short_scenes[k], "gimp", CD, NULL));
        Sim *sim = fixture_sim(&r);
        CU_ASSERT(fixture_steps(&r, sim, 0, 20));
        wide += sim->half_now > 0.5;
        narrow += sim->half_now < 0.5;
        chunks += sim->nblock > 1;
        sim_free(sim);
    }
    if (DIM < 3) CU_ASSERT(wide >= 2 && narrow >= 2 && chunks >= 1); /* 3D: the corner below */
}

/* A velocity gradient about x becomes one about X: L_X = L F. */
static void test_gradient(void)
{
    Particles p = {.n = 1};
    double L[NMAT], F[NMAT], before[NMAT];
    for (int k = 0; k < NMAT; k++) {
        L[k] = before[k] = 1 + k;
        F[k] = 0.5 * k * k - 1;
        p.field[AT_L + k] = &L[k], p.field[AT_F + k] = &F[k];
    }
    sim_refer_gradient(&p);
    for (int k = 0; k < NMAT; k++) {
        double sum = 0;
        for (int j = 0; j < DIM; j++) sum += before[k / DIM * DIM + j] * F[j * DIM + k % DIM];
        CHECK_CLOSE(L[k], sum, 1e-15);
    }
}

static const TestCase tests[] = {
    {"the scenes have wide and narrow stencils and several blocks", test_scenes},
    {"20 steps in a corner of symmetry lines", test_corner},
    {"the same on the reference grid", test_corner_total},
    {"the same, particles on nodes, symmetry lines and wall", test_corner_on_nodes},
    {"10 steps of every method and integrator", test_pairs},
    {"steps of tents with particles on nodes", test_on_nodes},
    {"gradients of the reference grid", test_gradient},
    {"120 steps of the stable smooth pairs, sorted several times", test_long},
    {NULL, NULL},
};
CHECK_SUITE(tests)
