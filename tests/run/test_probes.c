/* test_probes.c: --probe and wall reactions in histories, against the particle file and the
 * momentum balance. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include "common/base/table.h"
#include "common/run/loop.h"
#include "tests/fixture.h"

typedef struct Files {
    char history[64], particles[64];
} Files;

static Files name_files(void)
{
    Files f;
    snprintf(f.history, sizeof f.history, "probes_h%d.csv", (int)getpid());
    snprintf(f.particles, sizeof f.particles, "probes_p%d.csv", (int)getpid());
    return f;
}

static void add_probe(RunSpec *spec, double x, double y, double z)
{
    spec->probe[spec->nprobe++] = (Probe){{x, y, z}, DIM, "probe"};
}

static void run_files(RunSpec *spec, const Files *f, Table **history, Table **particles)
{
    Row row;
    Fault fault = {0};
    spec->history = f->history;
    spec->particles = f->particles;
    CU_ASSERT_FATAL(run_spec(spec, &row, &fault) == 0);
    *history = table_read(f->history, &fault);
    *particles = table_read(f->particles, &fault);
    CU_ASSERT_FATAL(*history && *particles);
    unlink(f->history);
    unlink(f->particles);
}

/* Row of the particle nearest to x, y, z, the first of equals. */
static int nearest_row(const Table *p, const double at[3])
{
    static const char *const axes[] = {"X", "Y", "Z"};
    double least = INFINITY;
    int found = -1;
    for (int r = 0; r < p->nrow; r++) {
        double square = 0;
        for (int d = 0; d < DIM; d++) square += pow(table_number(p, r, axes[d]) - at[d], 2);
        if (square < least * (1 - 1e-9)) least = square, found = r;
    }
    return found;
}

static void compare(const Table *h, const Table *p, int n, int row)
{
    static const char *const columns[] = {"sxx", "syy", "szz", "sxy", "sxz", "syz"};
    static const char *const at[] = {"X", "Y", "Z"}, *const now[] = {"x", "y", "z"};
    char name[32];
    const int last = h->nrow - 1;
    for (int d = 0; d < 3; d++) {
        snprintf(name, sizeof name, "probe%d_u%s", n, now[d]);
        const double u = table_number(p, row, now[d]) - table_number(p, row, at[d]);
        CU_ASSERT(d < DIM ? fabs(table_number(h, last, name) - u) <= 1e-14
                          : isnan(table_number(h, last, name)));
    }
    for (int c = 0; c < 6; c++) {
        snprintf(name, sizeof name, "probe%d_%s", n, columns[c]);
        const double want = table_number(p, row, columns[c]), got = table_number(h, last, name);
        CU_ASSERT(isnan(want) ? isnan(got) : fabs(got - want) <= 1e-12 * (1 + fabs(want)));
    }
}

/* Two probes, one of them as near to several points, of methods with and without a mesh. */
static void test_probe_columns(void)
{
    static const char *const names[] = {"gimp", "wls2", "fem"};
    for (int m = 0; m < COUNT(names); m++) {
        const Case scene = {DIM, DIM == 1 ? "column" : "block", 8, 0, 0, ""};
        const double at[2][3] = {{1.5, 0, 0}, {1.2, 0, 0}},
                     more[2][3] = {{1, 1, 1}, {1.2, 1.3, 1.4}};
        Table *h, *p;
        const Files files = name_files();
        if (DIM == 1 && m == 2) continue;
        RunSpec spec =
            fixture_spec(&scene, names[m], "cd", DIM == 1 ? "steps=7" : "spin=1;steps=7");
        for (int k = 0; k < 2; k++) {
            const double *x = DIM == 1 ? at[k] : more[k];
            add_probe(&spec, x[0], x[1], x[2]);
        }
        run_files(&spec, &files, &h, &p);
        for (int k = 0; k < 2; k++)
            compare(h, p, k + 1, nearest_row(p, DIM == 1 ? at[k] : more[k]));
        table_free(h);
        table_free(p);
    }
}

/* p(k) - p(k-1) = dt [(R + m g)(k) + (R + m g)(k-1)]/2 for momenta centred in time: the wall on top
 * of the column is the only one. */
static void test_reactions(void)
{
    static const char *const names[] = {"gimp", "mpm", "apic", "wls2", "fem"};
    const char *const p_name = DIM == 1 ? "px" : DIM == 2 ? "py" : "pz";
    const char *const f_name = DIM == 1 ? "wall1_fx" : DIM == 2 ? "wall1_fy" : "wall1_fz";
    for (int m = 0; m < COUNT(names) && DIM < 3; m++) {
        const Case scene = {DIM, "column", 16, 0, 0, ""};
        Table *h, *p;
        const Files files = name_files();
        if (DIM == 1 && strcmp(names[m], "fem") == 0) continue;
        RunSpec spec = fixture_spec(&scene, names[m], NULL, "steps=60");
        run_files(&spec, &files, &h, &p);
        const double dt = table_number(h, 0, "dt"), weight = DIM == 1 ? 100 : 50;
        double worst = 0, most = 0;
        for (int k = 2; k < h->nrow; k++) {
            const double R = 0.5 * (table_number(h, k, f_name) + table_number(h, k - 1, f_name));
            const double gained = table_number(h, k, p_name) - table_number(h, k - 1, p_name);
            worst = fmax(worst, fabs(gained / dt - R + weight));
            most = fmax(most, fabs(R));
        }
        /* the cells of wls2 integrate the weight: 2e-5 of it differs from the particles' sum */
        CU_ASSERT(worst < (strcmp(names[m], "wls2") == 0 ? 1e-4 : 1e-9) * weight);
        CU_ASSERT(most > 0.5 * weight);
        table_free(h);
        table_free(p);
    }
}

/* Wrong numbers of coordinates and places off the body are refused. */
static void test_refused(void)
{
    const Case scene = {DIM, DIM == 1 ? "column" : "block", 8, 0, 0, ""};
    for (int k = 0; k < 3; k++) {
        Plan plan;
        Fault fault = {0};
        RunSpec spec = fixture_spec(&scene, "gimp", NULL, NULL);
        spec.history = "h.csv";
        add_probe(&spec, k == 1 ? 9 : 1.2, 1.5, 1.5);
        if (k == 2) spec.probe[0].axes = DIM - 1;
        CU_ASSERT(plan_make(&spec, &plan, &fault) == (k ? FAULT_USAGE : 0));
        CU_ASSERT(!k || strstr(fault.text, "--probe: got 'probe'") != NULL);
    }
}

static const TestCase tests[] = {
    {"probes show the nearest point's displacement and stress", test_probe_columns},
    {"wall reactions and weight balance the change of momentum", test_reactions},
    {"a probe off the body is refused", test_refused},
    {NULL, NULL}};
CHECK_SUITE(tests)
