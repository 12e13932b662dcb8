/* t_02_work_precision.c: speed against error: what accuracy costs, for every method and FEM with
 * their sensible options, on every problem that has an exact solution.
 *
 * Cost is the CPU time of the step loop alone (cpu_s of a row), best of three runs that lie apart:
 * all cases once, then all again, so that a slow spell of the machine hits none of them thrice.
 * Beside it stand counts that no machine changes: particle-steps (FEM: element-steps), and
 * instructions where `make bench` has counted those of one particle-step. Claims are ratios of
 * costs within one run. What is made of the rows: effort.h. */
#include <math.h>
#include <string.h>
#include "studies/tables/effort.h"
#include "studies/tables/curves.h"
#include "studies/runs/engines.h"
#include "studies/runs/run_args.h"

enum { REPEATS = 3, PPCS = 3, MOST_MESHES = 8, USUAL = 1, INTEGRATORS = 5 };
static const char *const integrators[INTEGRATORS] = {"cd", "usl", "musl", "uvf", "usf"};

typedef struct Ladder {
    const Engine *engine;
    const char *run; /* problem and settings */
    const char *ppc[PPCS];
    int cells[MOST_MESHES];
    int meshes[PPCS]; /* how many of them at each ppc */
    int fem;          /* and how many without particles */
    bool layouts, moves;
} Ladder;

static const Ladder ladders[] = {
    {&engine_1d,
     "squeeze --set field=quadratic",
     {"1.3", "2.3", "4.3"},
     {50, 100, 200, 400, 800},
     {5, 5, 5},
     0,
     false,
     false},
    {&engine_1d,
     "sine_bar --set law=linear",
     {"1", "2", "4"},
     {10, 20, 40, 80, 160, 320},
     {6, 6, 6},
     0,
     false,
     true},
    {&engine_2d,
     "plate_vibration --set A=.0004",
     {"1", "4", "9"},
     {8, 16, 32, 48, 64, 128},
     {4, 4, 3},
     6,
     false,
     true},
    {&engine_2d, "ring", {"1", "4", "9"}, {8, 16, 32, 48, 64, 128}, {4, 4, 3}, 6, true, true},
    {&engine_2d, "axis_mms", {"1", "4", "9"}, {8, 16, 32, 48, 64}, {3, 3, 2}, 5, false, false},
    {&engine_2d,
     "vortex --set G=.1",
     {"1", "4", "9"},
     {8, 16, 32, 48, 64},
     {3, 3, 2},
     5,
     true,
     false},
};
enum { LADDERS = sizeof ladders / sizeof *ladders };

typedef struct Ask {
    Cases *list;
    const Ladder *ladder;
    const char *method;
    int repeat;
    bool quick;
} Ask;

/* The run's own command with everything spelled out; false if it is refused. */
static bool resolved(const Ask *a, const char *options, char command[SPEC_TEXT])
{
    char text[SPEC_TEXT];
    const Engine *engine;
    RunSpec spec;
    snprintf(text, sizeof text, "run %s --method %s%s", a->ladder->run, a->method, options);
    if (run_args_resolve(text, &spec, &engine, NULL)) return false;
    spec_command(&spec, command);
    return true;
}

static void ladder_add(const Ask *a, int meshes, const char *options)
{
    for (int k = 0; k < meshes && !(a->quick && k > 1); k++)
        case_add(a->list, "run %s --method %s --cells %d%s --set repeat=%d", a->ladder->run,
                 a->method, a->ladder->cells[k], options, a->repeat);
}

/* What the method takes besides its defaults, at the usual number of particles. */
static void others_add(const Ask *a, int meshes, const char *option, const char *const words[],
                       int n)
{
    char options[128], ppc[64], usual[SPEC_TEXT], command[SPEC_TEXT];
    snprintf(ppc, sizeof ppc, " --ppc %s", a->ladder->ppc[USUAL]);
    if (!resolved(a, ppc, usual)) return;
    for (int k = 0; k < n; k++) {
        snprintf(options, sizeof options, "%s%s%s", ppc, option, words[k]);
        if (resolved(a, options, command) && strcmp(command, usual) != 0)
            ladder_add(a, meshes, options);
    }
}

static void method_add(const Ask *a)
{
    static const char *const layouts[] = {"cartesian", "radial"};
    char options[128];
    if (!engine_has_grid(a->ladder->engine, a->method)) { /* it has no particles */
        ladder_add(a, a->ladder->fem, "");
        return;
    }
    for (int p = 0; p < PPCS; p++) {
        snprintf(options, sizeof options, " --ppc %s", a->ladder->ppc[p]);
        ladder_add(a, a->ladder->meshes[p], options);
    }
    const int meshes = a->ladder->meshes[USUAL];
    if (a->ladder->layouts) others_add(a, meshes, " --set layout=", layouts, 2);
    if (a->ladder->moves) others_add(a, meshes - 1, " --integrator ", integrators, INTEGRATORS);
}

static void cases(Cases *list, bool quick)
{
    for (int repeat = 1; repeat <= (quick ? 1 : REPEATS); repeat++)
        for (int k = 0; k < LADDERS; k++)
            for (const Info *const *m = ladders[k].engine->methods; *m; m++)
                method_add(&(Ask){list, &ladders[k], (*m)->name, repeat, quick});
}

static void tables(const Results *r)
{
    effort_tables(r, r->quick ? 1 : REPEATS);
}

typedef struct Reach {
    const Table *table;
    const char *problem, *target;
} Reach;

/* A number of the table of costs for one method; NAN if it does not get there by itself. */
static Measure reach(const Reach *r, const char *method, const char *column)
{
    return select_value(r->table, column, "problem=%s target=%s method=%s how=reached", r->problem,
                        r->target, method);
}

static Measure ratio(const Reach *r, const char *method, const char *beside, const char *column)
{
    return measure_ratio(reach(r, method, column), reach(r, beside, column));
}

static void check(Check *c, const Results *r)
{
    const Table *t = results_part(r, "reach");
    const Reach bar = {t, "sine_bar", "0.001"}, ring = {t, "ring", "0.001"};
    claim(c, "T-2.bar-ge-steps",
          "sine bar to 1e-3: particle-steps of GIMP over GE-GIMP's, each at its best",
          ratio(&bar, "gimp", "ge_gimp", "work"), 1.2, 3);
    claim(c, "T-2.bar-ge-time",
          "sine bar to 1e-3: CPU time of GIMP over GE-GIMP's, each at its best",
          ratio(&bar, "gimp", "ge_gimp", "seconds"), 1, 4);
    claim(c, "T-2.ring-fem", "ring to 1e-3: CPU time of GIMP at its best over FEM's",
          ratio(&ring, "gimp", "fem", "seconds"), 3, 100);
}

const Study study_t_02_work_precision = {
    .name = "t_02_work_precision",
    .figure = "T-2",
    .about = "speed against error: every method and FEM on every problem with an exact solution",
    .cases = cases,
    .tables = tables,
    .check = check,
    .claims = 3,
    .timed = true,
};
