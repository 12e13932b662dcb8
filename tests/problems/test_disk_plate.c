/* test_disk_plate.c: the scenes disk_impact and hole_plate: their points, walls and body force as
 * data, walls that hold and walls that let go, energy after the impact, strain of the plate. */
#include <string.h>
#include "common/run/ledger.h"
#include "common/contract/layout.h"
#include "common/run/plan.h"
#include "common/core/step.h"
#include "common/base/table.h"
#include "tests/fixture.h"

extern const Problem problem_disk_impact, problem_hole_plate;

static const double bilateral[1] = {0}, unilateral[1] = {1};

static void test_disk_points(void)
{
    const Scene s = fixture_bare_scene(&problem_disk_impact, bilateral, 1.0 / 48);
    Layout out = {0};
    double area = 0, moment[DIM] = {0};
    int surface = 0;
    CU_ASSERT_FATAL(layout_make(&out, &s, 1.0 / 96, 0, true, NULL) == 0);
    for (int p = 0; p < out.n; p++) {
        const double x = out.X[0][p] - 0.3, y = out.X[1][p] - 0.3, R = hypot(x, y);
        area += out.volume[p];
        moment[0] += out.volume[p] * x;
        moment[1] += out.volume[p] * y;
        if (out.volume[p] > 0) continue;
        surface++;
        CHECK_CLOSE(R, 0.2, 1e-14);
        CHECK_CLOSE((out.normal[0][p] * x + out.normal[1][p] * y) / R, 1, 1e-14);
    }
    CHECK_CLOSE(area, M_PI * 0.04, 1e-14);
    for (int d = 0; d < DIM; d++) CHECK_CLOSE(moment[d], 0, 1e-15);
    CU_ASSERT_EQUAL(surface, 121); /* ceil(2 pi .2 96) */
    layout_free(&out);
}

static void test_disk_lattice(void)
{
    const Scene s = fixture_bare_scene(&problem_disk_impact, bilateral, 1.0 / 48);
    Layout out = {0};
    CU_ASSERT_FATAL(layout_make(&out, &s, 1.0 / 96, 0, false, NULL) == 0);
    for (int p = 0; p < out.n; p++) CU_ASSERT(hypot(out.X[0][p] - 0.3, out.X[1][p] - 0.3) <= 0.2);
    CHECK_CLOSE(out.n / (96.0 * 96), M_PI * 0.04, 2e-3);
    layout_free(&out);
}

static void test_disk_walls(void)
{
    const double *const par[] = {bilateral, unilateral};
    for (int k = 0; k < 2; k++) {
        const Scene s = fixture_bare_scene(&problem_disk_impact, par[k], 1.0 / 48);
        double v[DIM] = {0}, none[NMAT] = {0}, X[DIM] = {0.3, 0.3};
        CU_ASSERT_EQUAL(s.nwall, 2 * DIM);
        for (int w = 0; w < s.nwall; w++) {
            const Wall *wall = &s.wall[w];
            CU_ASSERT(wall->hold == 1u << wall->axis); /* slip */
            CU_ASSERT(wall->at == (wall->side < 0 ? 0 : 1));
            CU_ASSERT(!wall->mirror && wall->unilateral == (k == 1));
        }
        problem_disk_impact.start(&s, 1, (const double *[]){&X[0], &X[1]}, NULL,
                                  (double *[]){&v[0], &v[1]}, NULL, (double *[]){none, none});
        CU_ASSERT(v[0] == 0.2 && v[1] == -0.2);
        CHECK_CLOSE(s.c, sqrt(1000 * (0.3 / (1.3 * 0.4) + 1.5 / 1.3) / 1000), 1e-14); /* eq 33 */
    }
}

/* Outward normal of a surface point of the plate, judged by where it is. */
static void check_plate_normal(const Layout *out, int p)
{
    const double X = out->X[0][p], Y = out->X[1][p], R = hypot(X, Y);
    const double nx = out->normal[0][p], ny = out->normal[1][p];
    CHECK_CLOSE(hypot(nx, ny), 1, 1e-14);
    CU_ASSERT(X > 1e-3 && Y > 1e-3); /* none on a symmetry line */
    const bool right = X == 1 && nx == 1 && ny == 0, top = Y == 1 && nx == 0 && ny == 1;
    const bool corner = X == 1 && Y == 1 && nx == ny && nx > 0;
    const bool hole = R < 0.51 && fabs((nx * X + ny * Y) / R + 1) < 1e-14;
    CU_ASSERT(right + top + corner + hole == 1);
}

static void test_plate_points(void)
{
    const Scene s = fixture_bare_scene(&problem_hole_plate, NULL, 1.0 / 48);
    const double spacing = 1.0 / 64;
    Layout out = {0};
    double area = 0;
    int surface = 0, ring[2] = {0}, lattice = 0;
    CU_ASSERT_FATAL(layout_make(&out, &s, spacing, 0, true, NULL) == 0);
    for (int p = 0; p < out.n; p++) {
        const double beyond = (hypot(out.X[0][p], out.X[1][p]) - 0.5) / spacing;
        area += out.volume[p];
        if (!(out.volume[p] > 0)) {
            surface++;
            check_plate_normal(&out, p);
        } else if (fabs(beyond - 0.5) < 1e-9 || fabs(beyond - 1.5) < 1e-9)
            ring[beyond > 1]++;
        else
            lattice += beyond > 2;
    }
    CU_ASSERT_EQUAL(surface + ring[0] + ring[1] + lattice, out.n);
    CU_ASSERT_EQUAL(ring[0], 52); /* ceil(pi/2 (.5 + s/2) / s) */
    CU_ASSERT_EQUAL(ring[1], 53);
    CU_ASSERT_EQUAL(surface, 51 + 2 * 64 + 1); /* ceil(pi/4 / s), 1/s a side, the corner */
    CHECK_CLOSE(area, 1 - M_PI / 16, 2e-3);
    layout_free(&out);
}

static void test_plate_data(void)
{
    const Scene s = fixture_bare_scene(&problem_hole_plate, NULL, 1.0 / 48);
    for (int k = 0; k < 9; k++) {
        const double X[DIM] = {0.125 * k, 0.7};
        Vec b = {1, 1};
        problem_hole_plate.body(&s, 1, (const double *[]){&X[0], &X[1]}, 1e-4 * k,
                                (double *[]){&b[0], &b[1]});
        CU_ASSERT(b[0] == 5e6 * X[0] && b[1] == 0);
    }
    CU_ASSERT_EQUAL(s.nwall, DIM);
    for (int w = 0; w < s.nwall; w++)
        CU_ASSERT(s.wall[w].mirror && s.wall[w].side == -1 && s.wall[w].at == 0);
}

/* A block on the floor that is thrown up (par > 0) or down, against a wall of either kind. */
enum { SPEED };

static void throw(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    (void)X, (void)u, (void)F, (void)L;
    for (int p = 0; p < n; p++) v[1][p] = s->k[SPEED];
}

static const Problem thrown = {.info = {.name = "thrown"}, .start = throw};

static void run_block(const Method *method, bool releases, double speed, int steps, double *gained,
                      double *impulse)
{
    Scene s = {.problem = &thrown,
               .mat = material_make(NEO_HOOKEAN, 1000, 0.3, 1000),
               .hi = {1, 1},
               .body_lo = {0.25, 0},
               .body_hi = {0.75, 0.5},
               .wall = {{.axis = 1, .side = -1, .at = 0, .hold = 2, .unilateral = releases}},
               .nwall = 1};
    double par[MAX_PARAMS] = {0};
    for (int k = 0; method->info.params && method->info.params[k].name; k++)
        par[k] = method->info.params[k].value;
    Setup setup = {.scene = &s,
                   .method = method,
                   .method_par = par,
                   .integrator = (Integrator)method->integrator[DIM],
                   .cells = 16,
                   .ppc = 4,
                   .fitted = method->surface,
                   .threads = 1};
    s.k[SPEED] = speed;
    s.c = material_wave_speed_bound(&s.mat);
    void *self = particle_solver.make(&setup, NULL);
    CU_ASSERT_PTR_NOT_NULL_FATAL(self);
    Points p;
    Samples q;
    Vec given;
    Scratch scratch = {0};
    particle_solver.view(self, &p, &q);
    CU_ASSERT_FATAL(norm_scratch_fit(&scratch, p.n));
    const Side before = ledger_motion(&p, 1, &scratch);
    for (int k = 0; k < steps; k++)
        CU_ASSERT(particle_solver.step(self, 0.01 * k, 0.01, k == 0).code == OK);
    particle_solver.view(self, &p, &q); /* their slots may have been sorted */
    const Side after = ledger_motion(&p, 1, &scratch);
    particle_solver.impulse(self, given);
    *gained = (after.p[1] - before.p[1]) / fabs(before.p[1]);
    *impulse = given[1] / fabs(before.p[1]);
    norm_scratch_free(&scratch);
    particle_solver.free(self);
}

static void test_walls(void)
{
    for (const Method *const *m = methods; *m; m++) {
        double gained, impulse;
        check_context(DIM, "block on the floor", (*m)->info.name, NULL, NULL);
        run_block(*m, true, 0.1, 20, &gained, &impulse); /* thrown up: it leaves as it is */
        CHECK_CLOSE(gained, 0, 1e-12);
        CHECK_CLOSE(impulse, 0, 1e-12);
        run_block(*m, false, 0.1, 20, &gained, &impulse); /* a wall that holds pulls it back */
        CU_ASSERT(gained < -0.1);
        run_block(*m, true, -0.1, 20, &gained, &impulse); /* thrown down: either wall stops it */
        CU_ASSERT(gained > 0.1);
        if (!(*m)->surface) CHECK_CLOSE(gained, impulse, 1e-12);
        run_block(*m, false, -0.1, 20, &gained, &impulse);
        CU_ASSERT(gained > 0.1);
        if (!(*m)->surface) CHECK_CLOSE(gained, impulse, 1e-12);
    }
}

static Row run_row(const char *problem, const char *method, double t_end, RunSpec spec)
{
    Row row = row_empty();
    Fault fault = {0};
    strcpy(spec.problem, problem);
    strcpy(spec.method, method);
    spec.t_end = t_end;
    check_context_of(DIM, &spec);
    CU_ASSERT_FATAL(run_spec(&spec, &row, &fault) == 0);
    return row;
}

/* Does the method keep its reference grid, so that walls cannot be met later? */
static bool keeps_grid(const Info *info)
{
    for (const Method *const *m = methods; *m; m++)
        if (&(*m)->info == info) return (*m)->frame == FRAME_TOTAL;
    return false;
}

static void test_free_flight(void)
{
    for (const Info *const *m = method_infos; *m; m++) {
        if (keeps_grid(*m)) continue;
        const Row row = run_row("disk_impact", (*m)->name, 0.25, (RunSpec){0});
        CHECK_TEXT(row.status, "ok");
        CHECK_CLOSE(row.energy_drift, 0, 1e-12);
        CHECK_CLOSE(row.momentum_drift, 0, 1e-12);
    }
}

/* Least kinetic energy and what is left at t = 2.3, over E0. */
static void test_impact_energy(void)
{
    static const struct {
        const char *method;
        double low, high;
    } known[] = {{"wls", 0.994, 1.006}, {"wls2", 0.994, 1.006}, {"gimp", 0.970, 0.980}};
    static const char file[] = "disk_history.csv";
    for (int m = 0; m < 3; m++) {
        const Row row = run_row("disk_impact", known[m].method, 2.3, (RunSpec){.history = file});
        CHECK_TEXT(row.status, "ok");
        Table *t = table_read(file, NULL);
        CU_ASSERT_PTR_NOT_NULL_FATAL(t);
        const double E0 = table_number(t, 0, "total");
        double least = E0, when = NAN;
        for (int k = 0; k < t->nrow && table_number(t, k, "t") < 1.6; k++)
            if (table_number(t, k, "kinetic") < least)
                least = table_number(t, k, "kinetic"), when = table_number(t, k, "t");
        const double left = table_number(t, t->nrow - 1, "total") / E0;
        CHECK_CLOSE(least / E0, 0.53, 0.01);
        CHECK_CLOSE(when, 0.93, 0.03);
        CU_ASSERT(left >= known[m].low && left <= known[m].high);
        table_free(t);
        remove(file);
    }
}

static void test_plate_displacement(void)
{
    static const struct {
        const char *method;
        double moved;
    } known[] = {{"wls", 0.365}, {"wls2", 0.365}, {"gimp", 0.3712}, {"fem", 0.3629}};
    static const char file[] = "plate_particles.csv";
    for (int m = 0; m < 4; m++) {
        double most = 0;
        const Row row = run_row("hole_plate", known[m].method, 0, (RunSpec){.particles = file});
        CHECK_TEXT(row.status, "ok"); /* a start from rest is no growth of energy */
        Table *t = table_read(file, NULL);
        CU_ASSERT_PTR_NOT_NULL_FATAL(t);
        for (int k = 0; k < t->nrow; k++)
            most = fmax(most, hypot(table_number(t, k, "x") - table_number(t, k, "X"),
                                    table_number(t, k, "y") - table_number(t, k, "Y")));
        CHECK_CLOSE(most, known[m].moved, 0.001);
        table_free(t);
        remove(file);
    }
}

static const TestCase tests[] = {
    {"disk: rings, surface, normals", test_disk_points},
    {"disk: lattice", test_disk_lattice},
    {"disk: walls and start", test_disk_walls},
    {"plate: rings, lattice, surface, normals", test_plate_points},
    {"plate: body force and symmetry lines", test_plate_data},
    {"a wall holds, or lets go", test_walls},
    {"disk: free flight keeps energy and momentum", test_free_flight},
    {"disk: energy through the impact", test_impact_energy},
    {"plate: largest displacement", test_plate_displacement},
    {NULL, NULL},
};
CHECK_SUITE(tests)
