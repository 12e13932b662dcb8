/* test_mass.c: the mass of bodies: particles and meshes weigh what the body does, in every scene
 * and layout, at every ppc and cell count. */
#include <stdlib.h>
#include <string.h>
#include "common/contract/layout.h"
#include "tests/fixture.h"

static double ends[DIM][2]; /* of the box that `box_scene` makes */

static int box_init(Scene *s, char why[128])
{
    (void)why;
    s->mat = material_make(NEO_HOOKEAN, 1, 0, 1);
    for (int d = 0; d < DIM; d++) {
        s->body_lo[d] = ends[d][0];
        s->body_hi[d] = ends[d][1];
        s->lo[d] = floor(ends[d][0]) - 1;
        s->hi[d] = ceil(ends[d][1]) + 1;
    }
    s->c = 1;
    return 0;
}

static const Problem box = {.info = {.name = "box"}, .cfl = 0.1, .init = box_init};

static double sum(int n, const double x[])
{
    long double total = 0;
    for (int k = 0; k < n; k++) total += x[k];
    return (double)total;
}

/* Volume, mirror symmetry, and GIMP boxes: those of width 2 l0 fill the body, too. */
static void check_box(const Sim *sim, double spacing)
{
    const int n = sim->p.count;
    double volume = 1, *state = fixture_state(sim), points = 1, skew = 0;
    int outside = 0;
    for (int d = 0; d < DIM; d++) {
        const double length = ends[d][1] - ends[d][0], *X = state + (AT_X0 + d) * n;
        volume *= length;
        points *= ceil(length / spacing - 1e-9);
        for (int k = 0; k < n; k++) {
            outside += !(X[k] > ends[d][0] && X[k] < ends[d][1]);
            const double s = fabs(X[k] + X[n - 1 - k] - ends[d][0] - ends[d][1]);
            skew = s <= skew ? skew : s;
        }
    }
    CU_ASSERT(n == points && outside == 0);
    CU_ASSERT(skew < 1e-12);
    CHECK_CLOSE(sum(n, state + AT_VOL * n) / volume, 1, 1e-12);
    CHECK_CLOSE(sum(n, state + AT_M * n) / volume, 1, 1e-12);
    CHECK_CLOSE(n * pow(2 * sim->half * sim->dx, DIM) / volume, 1, 1e-12);
    CHECK_CLOSE(sim->ppc * volume * pow(sim->g.cells, DIM) / n, 1, 1e-12);
    free(state);
}

/* Boxes whose faces lie on the lattice, between its points, on them, and anywhere. */
static void test_boxes(void)
{
    static const double boxes[][2] = {{0, 1}, {0.25, 1.25}, {0.5, 2}, {0.15, 1.15}, {-0.3, 0.4}};
    static const double asked[] = {1, 2, 4, 9};
    for (int b = 0; b < COUNT(boxes); b++)
        for (int cells = 1; cells < (DIM < 3 ? 34 : 9); cells++)
            for (int k = 0; k < COUNT(asked); k++) {
                Fixture r;
                for (int d = 0; d < DIM; d++) {
                    ends[d][0] = boxes[(b + d) % COUNT(boxes)][0];
                    ends[d][1] = boxes[(b + d) % COUNT(boxes)][1];
                }
                const double ppc = DIM == 3 ? asked[k] * sqrt(asked[k]) : asked[k];
                fixture_scene(&r, &box, methods[0], CD, cells, ppc);
                r.plan.setup.fitted = k % 2;
                Sim *sim = fixture_sim(&r);
                check_box(sim, sim->dx / pow(ppc, 1.0 / DIM));
                sim_free(sim);
            }
}

/* Where the lattice from the origin tiles the box, its points are those of always, to the bit. */
static void test_lattice(void)
{
    for (int cells = 2; cells < 40; cells += 2) {
        Fixture r;
        const double s = 1.0 / cells / 2;
        for (int d = 0; d < DIM; d++) ends[d][0] = 0.5, ends[d][1] = 1.5;
        if (DIM == 3 && cells > 8) return;
        fixture_scene(&r, &box, methods[0], CD, cells, pow(2, DIM));
        Sim *sim = fixture_sim(&r);
        double *state = fixture_state(sim);
        int moved = 0;
        for (int k = 0; k < sim->p.count; k++) {
            int rest = k;
            for (int d = 0; d < DIM; d++, rest /= 2 * cells)
                moved +=
                    state[(AT_X0 + d) * sim->p.count + k] != (cells + rest % (2 * cells) + 0.5) * s;
        }
        CU_ASSERT(sim->p.count == pow(2 * cells, DIM) && moved == 0);
        free(state);
        sim_free(sim);
    }
}

/* Volume of a scene's body, and the length of its curved sides; in 3D their area. */
static double body_of(const Scene *s, double *curved)
{
    const Body *b = &s->body;
    double volume = 1;
    for (int d = 0; d < DIM; d++) volume *= s->body_hi[d] - s->body_lo[d];
    *curved = 0;
    if (b->kind == BODY_BOX) return volume;
    if (b->kind >= BODY_SHELL) {
        const double part = 4 * M_PI / (s->octant ? 8 : 1), hole = pow(b->inner, 3) / 3;
        const bool cavity = b->kind == BODY_CAVITY;
        *curved = part * (b->inner * b->inner + (cavity ? 0 : b->outer * b->outer));
        return cavity ? volume - part * hole : part * (pow(b->outer, 3) / 3 - hole);
    }
    const double thickness = DIM > 2 ? s->body_hi[DIM - 1] - s->body_lo[DIM - 1] : 1;
    const double angle = b->angle_hi - b->angle_lo;
    const double outer = b->kind == BODY_HOLE_PLATE ? 0 : b->outer;
    *curved = thickness * angle * (b->inner + outer);
    if (b->kind == BODY_HOLE_PLATE) return volume - 0.5 * angle * b->inner * b->inner;
    return thickness * 0.5 * angle * (b->outer * b->outer - b->inner * b->inner);
}

/* Boxes to round-off; rings and disks of their own layout, too; what a lattice is cut out of by a
 * curve to half the area of the boxes on it; linear triangles by their chords. */
static double allowed(const Scene *s, const Case *c, bool fitted, bool mesh, double curved)
{
    const double h = s->cell, spacing = h / pow(c->ppc, 1.0 / DIM), radius = s->body.outer;
    const BodyKind kind = s->body.kind;
    if (kind == BODY_BOX) return 0;
    if (mesh) return curved * h * h / (4 * (s->body.inner > 0 ? s->body.inner : radius));
    return fitted && kind != BODY_HOLE_PLATE && kind != BODY_CAVITY ? 0 : 0.5 * curved * spacing;
}

/* Volume of a scene's bodies, and the error that is allowed. */
static double bodies_of(const Scene *s, const Case *c, bool fitted, bool mesh, double *error)
{
    double volume = 0;
    *error = 0;
    for (int b = 0; b < (s->problem->part ? 2 : 1); b++) {
        Scene own = *s;
        double curved;
        if (s->problem->part) s->problem->part(&own, b);
        volume += body_of(&own, &curved);
        *error += allowed(&own, c, fitted, mesh, curved);
    }
    return volume;
}

static void check_scene(const Case *c, const char *method, bool fitted)
{
    Fixture r;
    Points p;
    Samples q;
    Counts counts;
    double error;
    if (!fixture_plan(&r, c, method, CD, fitted ? "layout=radial" : "layout=cartesian")) return;
    const Scene *s = &r.plan.scene;
    const bool mesh = r.plan.setup.method == NULL;
    void *self = r.plan.solver->make(&r.plan.setup, &r.fault);
    CU_ASSERT_PTR_NOT_NULL_FATAL(self);
    r.plan.solver->view(self, &p, &q);
    r.plan.solver->counts(self, &counts);
    const double volume = bodies_of(s, c, fitted, mesh, &error);
    const double V = sum(p.n, p.V0), m = sum(p.n, p.m);
    if (counts.particles > 0) CHECK_CLOSE(V, volume, error + 1e-12 * volume);
    CHECK_CLOSE(m, s->mat.rho * V, 1e-12 * s->mat.rho * volume);
    if (counts.particles > 0 && !mesh)
        CHECK_CLOSE(counts.ppc * V, counts.particles * pow(s->cell, DIM), 1e-9 * V);
    r.plan.solver->free(self);
}

/* A body from an image has no volume of its own; test_scan.c. */
static bool is_scan(const Problem *p)
{
    return info_param_find(p->info.params, "pixels") != NULL;
}

static void test_scenes(void)
{
    static const double cells[] = {1, 2, 3, 4, 5, 7, 8, 13, 16, 31}, ppc[] = {1, 2, 3, 4, 9};
    for (const Problem *const *p = problems; *p; p++)
        for (int n = 0; n < COUNT(cells) && !(*p)->projection && !is_scan(*p); n++)
            for (int k = 0; k < COUNT(ppc); k++) {
                const double own = DIM < 3 ? ppc[k] : pow(k + 1, 3);
                const Case c = {DIM, (*p)->info.name, cells[n], own, 0, NULL};
                if (DIM > 2 && cells[n] * (k + 1) > 20) continue;
                check_scene(&c, "gimp", false);
                check_scene(&c, "gimp", true);
                if (DIM > 1 && k == 0) check_scene(&c, "fem", false);
            }
}

/* The bodies of `patch` are rectangles; what grading makes narrower is made up for. */
static void test_patch(void)
{
    static const char *const sets[] = {"grading=1", "grading=2", "grading=3.3;layout=radial",
                                       "jitter=.3", "body=strip;grading=2"};
    for (int cells = 2; DIM == 2 && cells < 40; cells++)
        for (int k = 0; k < COUNT(sets); k++) {
            const Case c = {2, "patch", cells, 4, 0, sets[k]};
            const double side = 2 * round(0.3 / (1.0 / cells)) / cells;
            Fixture r;
            CU_ASSERT_FATAL(fixture_plan(&r, &c, "gimp", CD, NULL));
            Sim *sim = fixture_sim(&r);
            double *state = fixture_state(sim);
            const double V = sum(sim->p.count, state + AT_VOL * sim->p.count);
            CHECK_CLOSE(V / (side * (k < 4 ? side : 1.5 / cells)), 1, 1e-12);
            free(state);
            sim_free(sim);
        }
}

/* The column ppc says what was used, ppc_asked what repeats the run. */
static void test_ppc_column(void)
{
    static const struct {
        Case scene;
        const char *method;
        double ppc, mass;
    } runs[] = {{{2, "axis_mms", 8, 2, 0, "steps=1"}, "wls2", 2.25, 1},
                {{2, "hanging_bar", 4, 2, 0, "steps=1"}, "wls2", 2.25, 1050},
                {{2, "ring", 8, 2, 0, "steps=1"}, "wls2", 84 / (64 * M_PI * 0.75 / 4), 1},
                {{2, "free_block", 5, 4, 0, "steps=1"}, "gimp", 4, 1},
                {{1, "squeeze", 10, 5, 0, "arrangement=centred"}, "gimp", 2, 1},
                {{1, "bar", 10, 2.34, 0, "steps=1"}, "gimp", 2.3, 1}};
    for (int k = 0; k < COUNT(runs); k++) {
        const RunSpec spec = fixture_spec(&runs[k].scene, runs[k].method, NULL, NULL);
        Row row = row_empty();
        if (runs[k].scene.dim != DIM) continue;
        CU_ASSERT_FATAL(run_spec(&spec, &row, NULL) == 0);
        CHECK_CLOSE(row.ppc, runs[k].ppc, 1e-12);
        CHECK_CLOSE(row.ppc_asked, DIM == 1 && runs[k].scene.ppc < 3 ? 2.3 : runs[k].scene.ppc, 0);
    }
}

static const TestCase tests[] = {
    {"boxes", test_boxes},   {"lattice as always", test_lattice}, {"scenes", test_scenes},
    {"patches", test_patch}, {"column ppc", test_ppc_column},     {NULL, NULL},
};
CHECK_SUITE(tests)
