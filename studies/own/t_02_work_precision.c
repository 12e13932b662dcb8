/* t_02_work_precision.c: speed against error: what accuracy costs, for every method and FEM with
 * their sensible options, on every problem that has an exact solution.
 *
 * Cost is the CPU time of the step loop alone (cpu_s of a row), best of two runs that lie apart:
 * all cases once, then all again, so that a slow spell of the machine hits none of them twice.
 * Beside it stand counts that no machine changes: particle-steps (FEM: element-steps), and
 * instructions where `make bench` has counted those of one particle-step. Schemes that studies run
 * on request have their defaults only, in both layouts. Claims are ratios of costs within one run.
 * What is made of the rows: effort.h. */
#include <math.h>
#include <string.h>
#include "studies/tables/effort.h"
#include "studies/tables/curves.h"
#include "studies/runs/run_args.h"

enum { REPEATS = 2, PPCS = 3, MOST_MESHES = 8, USUAL = 1 };

typedef struct Ladder {
    const Engine *engine;
    const char *run; /* problem and settings */
    const char *ppc[PPCS];
    int cells[MOST_MESHES];
    int meshes[PPCS]; /* how many of them at each ppc */
    int fem;          /* and how many without particles */
    bool layouts, moves;
    bool tried; /* what the problem refuses is left out */
} Ladder;

#define BAR   .engine = &engine_1d, .ppc = {"1", "2", "4"}, .moves = true
#define PLANE .engine = &engine_2d, .ppc = {"1", "4", "9"}
static const Ladder ladders[] = {
    {.engine = &engine_1d,
     .run = "squeeze --set field=quadratic",
     .ppc = {"1.3", "2.3", "4.3"},
     .cells = {50, 100, 200, 400, 800},
     .meshes = {5, 5, 5}},
    {BAR, .run = "sine_bar --set law=linear", .cells = {10, 20, 40, 80, 160, 320},
     .meshes = {6, 6, 6}},
    {PLANE, .run = "plate_vibration --set A=.0004", .cells = {8, 16, 32, 48, 64, 128},
     .meshes = {4, 4, 3}, .fem = 6, .moves = true},
    {PLANE, .run = "ring", .cells = {8, 16, 32, 48, 64, 128}, .meshes = {4, 4, 3}, .fem = 6,
     .layouts = true, .moves = true},
    {PLANE, .run = "axis_mms", .cells = {8, 16, 32, 48, 64}, .meshes = {3, 3, 2}, .fem = 5},
    {PLANE, .run = "vortex --set G=.1", .cells = {8, 16, 32, 48, 64}, .meshes = {3, 3, 2}, .fem = 5,
     .layouts = true},
    /* a fifth of its time: a step is short beside the slide */
    {PLANE, .run = "sliding_block --t-end .1", .cells = {8, 16}, .meshes = {2, 2, 1},
     .tried = true},
};
enum { LADDERS = sizeof ladders / sizeof *ladders };

/* Any other problem with an exact solution, by dimension. */
static const Ladder others[] = {
    {BAR, .cells = {10, 20, 40, 80}, .meshes = {4, 4, 4}, .fem = 4, .tried = true},
    {PLANE, .cells = {8, 16, 32}, .meshes = {3, 3, 2}, .fem = 3, .tried = true},
};
enum { OTHERS = sizeof others / sizeof *others };

static bool is_listed(const char *problem)
{
    for (int k = 0; k < LADDERS; k++) {
        const char *run = ladders[k].run;
        if (strcmp(select_word(&run), problem) == 0) return true;
    }
    return false;
}

typedef struct Ask {
    Cases *list;
    const Ladder *ladder;
    const char *method;
    int repeat;
    bool quick, brief; /* brief: the usual particles and integrator, all meshes but the finest */
} Ask;

/* The run's own command with everything spelled out; false if it is refused. */
static bool resolved(const Ask *a, const char *options, char command[SPEC_TEXT])
{
    const char *text = phrase("run %s --method %s%s", a->ladder->run, a->method, options);
    const Engine *engine;
    RunSpec spec;
    if (run_args_resolve(text, &spec, &engine, NULL)) return false;
    spec_command(&spec, command);
    return true;
}

static void ladder_add(const Ask *a, int meshes, const char *options)
{
    char command[SPEC_TEXT];
    if (a->ladder->tried && !resolved(a, options, command)) return;
    for (int k = 0; k < meshes && !(a->quick && k > 1); k++)
        case_add(a->list, "run %s --method %s --cells %d%s --set repeat=%d", a->ladder->run,
                 a->method, a->ladder->cells[k], options, a->repeat);
}

/* What the method takes besides its defaults, at the usual number of particles: an option with each
 * of these words. */
static void others_add(const Ask *a, int meshes, const char *option, const char *words)
{
    const char *ppc = phrase(" --ppc %s", a->ladder->ppc[USUAL]);
    char usual[SPEC_TEXT], command[SPEC_TEXT];
    if (!resolved(a, ppc, usual)) return;
    EACH_WORD(w, words) {
        const char *options = phrase("%s%s%s", ppc, option, w);
        if (resolved(a, options, command) && strcmp(command, usual) != 0)
            ladder_add(a, meshes, options);
    }
}

static void method_add(const Ask *a)
{
    if (!engine_has_grid(a->ladder->engine, a->method)) { /* it has no particles */
        ladder_add(a, a->ladder->fem, "");
        return;
    }
    for (int p = 0; p < PPCS; p++)
        if (!a->brief || p == USUAL)
            ladder_add(a, a->ladder->meshes[p] - a->brief, phrase(" --ppc %s", a->ladder->ppc[p]));
    const int meshes = a->ladder->meshes[USUAL] - a->brief;
    if (a->ladder->layouts) others_add(a, meshes, " --set layout=", "cartesian radial");
    if (a->ladder->moves && !a->brief)
        others_add(a, meshes - 1, " --integrator ", "cd usl musl uvf usf");
}

static void ladder_add_methods(Cases *list, const Ladder *ladder, int repeat, bool quick)
{
    EACH_METHOD(m, ladder->engine)
        if (!ladder->tried || !m->on_request)
            method_add(&(Ask){list, ladder, m->name, repeat, quick, m->on_request});
}

static void cases(Cases *list, bool quick)
{
    for (int repeat = 1; repeat <= (quick ? 1 : REPEATS); repeat++) {
        for (int k = 0; k < OTHERS; k++)
            for (const Info *const *p = others[k].engine->problems; *p; p++) {
                Ladder ladder = others[k];
                ladder.run = (*p)->name;
                const bool other = k == 0 && engine_has_problem(&engine_2d, ladder.run);
                if (!other && ladder.engine->has_exact(ladder.run) && !is_listed(ladder.run))
                    ladder_add_methods(list, &ladder, repeat, quick);
            }
        for (int k = 0; k < LADDERS; k++) ladder_add_methods(list, &ladders[k], repeat, quick);
    }
}

static void tables(const Results *r)
{
    effort_tables(r, r->quick ? 1 : REPEATS);
}

/* A number of the ring's run on 32 cells with the usual particles, on a lattice. */
static Measure at_ring(const Results *r, const char *method, const char *column)
{
    return select_value(results_part(r, "points"), column,
                        "problem=ring method=%s cells=32 ppc=4 layout=cartesian integrator=cd",
                        method);
}

/* Particle-steps of a method with two particles per cell and cd to an error of 1e-3 on the sine
 * bar: on a straight line in log-log between 40 and 80 cells, whatever the clock says. */
static Measure bar_steps(const Results *r, const char *method)
{
    static const char where[] = "problem=sine_bar method=%s ppc=2 integrator=cd cells=%d";
    const Table *t = results_part(r, "points");
    double work[2], error[2];
    Measure all = measure_sum_of(2);
    for (int k = 0; k < 2; k++) {
        error[k] = select_value(t, "error", where, method, 40 << k).value;
        work[k] = select_value(t, "work", where, method, 40 << k).value;
        measure_add(&all, error[k] + work[k]);
    }
    const double part = log(error[0] / 1e-3) / log(error[0] / error[1]);
    return measure_with(all, work[0] * pow(work[1] / work[0], part));
}

static void check(Check *c, const Results *r)
{
    static const char bar[] = "problem=sine_bar target=0.001", ring[] = "problem=ring target=0.001";
    claim(c, "T-2.bar-ge-steps",
          "Sine bar to 1e-3, 2 particles per cell, cd, between N = 40 and 80 on a line in log-log: "
          "particle-steps of GIMP over GE-GIMP's",
          measure_ratio(bar_steps(r, "gimp"), bar_steps(r, "ge_gimp")), 1.2, 3);
    claim(c, "T-2.bar-ge-time",
          "Sine bar to 1e-3: CPU time of GIMP over GE-GIMP's, each at its best",
          effort_ratio(r, bar, "seconds", "gimp", "ge_gimp"), 1, 4);
    claim(c, "T-2.ring-fem", "Ring to 1e-3: CPU time of GIMP at its best over FEM's",
          effort_ratio(r, ring, "seconds", "gimp", "fem"), 3, 100);
    claim(c, "T-2.cpdi-time", "Ring, 32 cells, same particles: CPU time of CPDI over GIMP's",
          measure_ratio(at_ring(r, "cpdi", "cpu_s"), at_ring(r, "gimp", "cpu_s")), 1, 9);
    claim(c, "T-2.mls-error", "Ring, 32 cells, same particles: error of MLS-MPM over APIC's",
          measure_ratio(at_ring(r, "mls_mpm", "error"), at_ring(r, "apic", "error")), 0.5, 1);
}

const StudyPage study_t_02_work_precision = {.cases = cases,
                                             .tables = tables,
                                             .check = check,
                                             .claims = 5,
                                             .timed = true,
                                             .also = "mls_mpm,bspline3,tlmpm,cpdi,cpdi2"};
