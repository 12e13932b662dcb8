/* test_contact.c: two bodies on one grid (contact.c, particle_solver.c). */
#include <stdlib.h>
#include <string.h>
#include "tests/fixture.h"

enum { MANY = 20000 };

/* A run's state at its end: both bodies, in placement order. */
typedef struct End {
    int n, second;
    double x[DIM][MANY], v[DIM][MANY], m[MANY], F[NMAT][MANY];
    Vec impulse;
    double friction;
    StatusCode code;
} End;

static double total(const End *e, int a, int from, int to)
{
    double sum = 0;
    for (int k = from; k < to; k++) sum += e->m[k] * e->v[a][k];
    return sum;
}

/* Largest change of total momentum, less what walls and body forces gave, in any one step, over
 * sum m |v| at the start. */
static double steps_of(const Fixture *r, void *core, int from, int to, StatusCode *code)
{
    double worst = 0;
    *code = OK;
    for (int k = from; k < to && *code == OK; k++) {
        Points p;
        Samples q;
        Vec before, after, start, end;
        double scale = 0;
        particle_solver.impulse(core, before);
        for (int pass = 0; pass < 2; pass++) {
            particle_solver.view(core, &p, &q);
            for (int a = 0; a < DIM; a++) {
                double *sum = pass ? &end[a] : &start[a];
                *sum = 0;
                for (int s = 0; s < p.n; s++) *sum += p.m[s] * p.v[a][s];
                for (int s = 0; s < p.n; s++) scale += fabs(p.m[s] * p.v[a][s]);
            }
            if (!pass) *code = particle_solver.step(core, k * r->dt, r->dt, k == 0).code;
        }
        particle_solver.impulse(core, after);
        for (int a = 0; a < DIM; a++)
            worst = fmax(worst, fabs(end[a] - start[a] - after[a] + before[a]) / scale);
    }
    return worst;
}

static End *end_of(const Fixture *r, int steps, double *drift)
{
    Fault fault = {0};
    Points p;
    Samples q;
    End *e = calloc(1, sizeof *e);
    void *core = particle_solver.make(&r->plan.setup, &fault);
    CU_ASSERT_FATAL(e && core);
    const double worst = steps_of(r, core, 0, steps, &e->code);
    if (drift) *drift = worst;
    particle_solver.view(core, &p, &q);
    e->second = p.second;
    for (int s = 0; s < p.n; s++) {
        const int id = p.id[s];
        if (id < 0) continue;
        CU_ASSERT_FATAL(id < MANY);
        e->n = id >= e->n ? id + 1 : e->n;
        e->m[id] = p.m[s];
        for (int d = 0; d < DIM; d++) e->x[d][id] = p.x[d][s], e->v[d][id] = p.v[d][s];
        for (int c = 0; c < NMAT; c++) e->F[c][id] = q.F[c][s];
    }
    particle_solver.impulse(core, e->impulse);
    e->friction = particle_solver.work(core);
    particle_solver.free(core);
    return e;
}

static const Case bars = {1, "collinear_bars", 40, 2, 0.4, NULL};
static const Case disks = {2, "two_disks", 20, 4, 0.4, NULL};
static const Case slope = {2, "sliding_block", 8, 4, 0.4, NULL};

static const Case *scene(void)
{
    return DIM == 1 ? &bars : &disks;
}

/* Steps from before the first contact until after the last of this dimension's scene. */
static int whole(const Fixture *r)
{
    return (int)ceil((DIM == 1 ? 0.025 : 1.8) / r->dt);
}

/* Tents with one projection a step turn particles inside out in 2D, with and without contact. */
static bool tents_alone(const Method *m, Integrator i)
{
    return DIM == 2 && (i == CD || i == USL) && m->width(0.25) == 2 && !(m->pic > 0);
}

/* Momentum of every stable method and integrator, both contacts, with and without friction. WLS
 * loses what its quadrature of masses loses (wls.h). */
static void test_momentum(void)
{
    static const char *const more[] = {"mu=0", "mu=0.5", "contact=none"};
    int runs = 0;
    FOR_METHODS(m) FOR_INTEGRATORS(i) for (int k = 0; k < COUNT(more); k++)
    {
        Fixture r;
        double drift;
        if ((*m)->surface || !fixture_valid(*m, i, false) ||
            !fixture_plan(&r, scene(), (*m)->info.name, i, more[k]))
            continue;
        runs++;
        End *e = end_of(&r, whole(&r), &drift);
        CU_ASSERT(e->code == OK || tents_alone(*m, i));
        CU_ASSERT(drift < 1e-14);
        CU_ASSERT(k == 2 || e->code != OK || total(e, 0, 0, e->second) < 0); /* rebound */
        free(e);
    }
    CU_ASSERT(runs > 50);
}

/* Each of two bodies with a method of its own. */
static void test_two_methods(void)
{
    Fixture r;
    double drift;
    CU_ASSERT_FATAL(fixture_plan(&r, scene(), "ge_gimp+apic", CD, NULL));
    End *e = end_of(&r, whole(&r), &drift);
    CU_ASSERT(e->code == OK && drift < 1e-14);
    CU_ASSERT(total(e, 0, 0, e->second) < 0 && total(e, 0, e->second, e->n) > 0); /* exchanged */
    free(e);
    CU_ASSERT(fixture_plan(&r, scene(), "gimp+gimp", CD, NULL));
    CHECK_TEXT(r.spec.method, "gimp");
    CU_ASSERT(!fixture_plan(&r, scene(), "gimp+fem", CD, NULL));
    CU_ASSERT(!fixture_plan(&r, scene(), "ge_gimp+gimp", MUSL, "contact=none")); /* unstable */
    CU_ASSERT(!fixture_plan(&r, scene(), "gimp", MUSL, NULL));                   /* contact.c */
    CU_ASSERT(fixture_plan(&r, scene(), "gimp", MUSL, "contact=none"));
    CU_ASSERT(fixture_plan(&r, scene(), "gimp+mpm", CD, NULL));
}

/* contact=none is one body with the particles of both: the same scene as a single Sim. */
static Problem single;

static bool inside_either(const Scene *s, const Vec X)
{
    Scene own = *s;
    bool in = false;
    for (int b = 0; b < 2; b++) {
        own.problem->part(&own, b);
        bool here = true;
        for (int d = 0; d < DIM; d++) here &= X[d] >= own.body_lo[d] && X[d] <= own.body_hi[d];
        in |= here && (!s->problem->inside || s->problem->inside(&own, X));
        own = *s;
    }
    return in;
}

static bool inside_single(const Scene *s, const Vec X)
{
    Scene own = *s;
    for (const Problem *const *p = problems; *p; p++)
        if (!strcmp((*p)->info.name, single.info.name)) own.problem = *p;
    return inside_either(&own, X);
}

/* Largest distance of any particle of a from its nearest one of b (placement orders differ). */
static double distance(const End *a, const End *b)
{
    double worst = 0;
    for (int k = 0; k < a->n; k++) {
        double nearest = INFINITY;
        for (int l = 0; l < b->n; l++) {
            double far = 0;
            for (int d = 0; d < DIM; d++)
                far = fmax(far, fmax(fabs(a->x[d][k] - b->x[d][l]), fabs(a->v[d][k] - b->v[d][l])));
            nearest = fmin(nearest, far);
        }
        worst = fmax(worst, nearest);
    }
    return worst;
}

static void test_single_field(void)
{
    static const char *const names[] = {"mpm", "gimp", "ge_gimp", "apic"};
    static const Integrator integrator[] = {UVF, MUSL, CD, CD};
    for (int k = 0; k < COUNT(names); k++) {
        Fixture r;
        CU_ASSERT_FATAL(fixture_plan(&r, scene(), names[k], integrator[k], "contact=none"));
        End *two = end_of(&r, whole(&r) / 2, NULL);
        single = *r.plan.scene.problem;
        single.part = NULL;
        single.place = NULL;
        single.inside = inside_single;
        r.plan.scene.problem = &single;
        End *one = end_of(&r, whole(&r) / 2, NULL);
        CU_ASSERT(one->n == two->n && one->code == OK && two->code == OK);
        CU_ASSERT(distance(two, one) < 1e-11);
        CU_ASSERT(distance(one, two) < 1e-11);
        free(one);
        free(two);
    }
}

/* The second disk is the first one turned by half a turn; bars are mirrored. */
static void test_symmetry(void)
{
    FOR_METHODS(m)
    {
        Fixture r;
        const double middle = DIM == 1 ? 2 : 0.5;
        if ((*m)->surface || !fixture_plan(&r, scene(), (*m)->info.name, CD, "allow_unstable=1"))
            continue;
        if (!fixture_valid(*m, CD, false) || tents_alone(*m, CD)) continue;
        /* fixed modes amplify round-off: to the time of the impact only */
        const int steps = (*m)->modes ? whole(&r) / 2 : whole(&r);
        End *e = end_of(&r, steps, NULL), *turned = calloc(1, sizeof *e);
        CU_ASSERT_FATAL(turned != NULL);
        *turned = *e;
        for (int d = 0; d < DIM; d++)
            for (int k = 0; k < e->n; k++) {
                turned->x[d][k] = 2 * middle - e->x[d][k];
                turned->v[d][k] = -e->v[d][k];
            }
        CU_ASSERT(distance(e, turned) < 1e-12);
        free(turned);
        free(e);
    }
}

/* The number of threads changes no bit. */
static void test_threads(void)
{
    Fixture r;
    CU_ASSERT_FATAL(fixture_plan(&r, scene(), "gimp", CD, "mu=0.3"));
    End *one = end_of(&r, whole(&r), NULL);
    r.plan.setup.threads = 3;
    End *three = end_of(&r, whole(&r), NULL);
    CU_ASSERT(memcmp(one, three, sizeof *one) == 0);
    free(one);
    free(three);
}

/* A block on an incline, by method and friction: it has the acceleration of a rigid block from a
 * quarter of the time on, the base rests, and friction takes the work that it does on the way. */
static void test_incline(void)
{
    static const char *const names[] = {"gimp", "ge_gimp", "flip_pic"};
    static const double mu[] = {0, 0.1, 0.3, 0.4}, t = 0.2, whole_mass = 500;
    for (int k = 0; DIM == 2 && k < COUNT(names) * COUNT(mu); k++) {
        Fixture r;
        char set[32];
        double drift;
        const double f = mu[k % COUNT(mu)], down = 10 * sin(M_PI / 9), press = 10 * cos(M_PI / 9);
        const double a = fmax(0, down - f * press), work = f * press * a * t * t / 2 * whole_mass;
        snprintf(set, sizeof set, "mu=%g", f);
        CU_ASSERT_FATAL(fixture_plan(&r, &slope, names[k / COUNT(mu)], CD, set));
        const int n = (int)ceil(t / r.dt), early = n / 4;
        End *e = end_of(&r, n, &drift), *from = end_of(&r, early, NULL);
        CU_ASSERT(e->code == OK && (drift < 1e-14 || !(a > 0))); /* at rest sum m |v| is no scale */
        const double gain = total(e, 0, 0, e->second) - total(from, 0, 0, e->second);
        CHECK_CLOSE(gain / whole_mass, a * (n - early) * r.dt, 0.01 * down * (n - early) * r.dt);
        if (a > 0) CHECK_CLOSE(gain / whole_mass / ((n - early) * r.dt), a, 0.01 * a);
        if (a > 0) CHECK_CLOSE(-e->friction, work, 0.05 * work + 1e-12);
        for (int d = 0; d < DIM; d++) CU_ASSERT(total(e, d, e->second, e->n) == 0);
        free(e);
        free(from);
    }
}

/* Two disks: with the approach of a node lost in one step the energy would be .060 less. */
static void test_slow_loss(void)
{
    RunSpec spec = fixture_spec(&disks, "gimp", NULL, NULL);
    Row row = row_empty();
    if (DIM != 2) return;
    spec.t_end = 0.8;
    CU_ASSERT_FATAL(run_spec(&spec, &row, NULL) == 0);
    CU_ASSERT(row.energy_drift < 0 && row.energy_drift > -0.045);
}

static const TestCase tests[] = {{"contact conserves momentum, every method", test_momentum},
                                 {"two bodies, two methods", test_two_methods},
                                 {"contact=none is one body of both", test_single_field},
                                 {"a turned set-up gives a turned result", test_symmetry},
                                 {"threads change no bit of a contact", test_threads},
                                 {"a block slides down an incline", test_incline},
                                 {"particles lose their approach slowly", test_slow_loss},
                                 {NULL, NULL}};
CHECK_SUITE(tests)
