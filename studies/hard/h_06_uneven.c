/* h_06_uneven.c: hard cases H-6 and H-7: particles that are uneven, or few.
 *
 * H-6: a linear velocity field is projected from a lattice, two particles per axis and cell, that
 * is jittered by up to half its spacing, or graded to a third of its density and back; errors of
 * nodes two cells inside. (Cells are square here, always.)
 *
 * H-7: the sine bar and the standing waves of axis_mms with half a particle per axis and cell,
 * three quarters, one, one and a half, and two; a method has enough where its error is below a
 * tenth of the amplitude. */
#include <math.h>
#include "studies/tables/grades.h"

#define USABLE 0.1 /* error over amplitude */

enum { JITTERS = 6, FEW = 5, SCENES = 2, CELLS = 32 };
static const double jitters[JITTERS] = {0, 0.1, 0.2, 0.3, 0.4, 0.5};
static const double few[FEW] = {0.5, 0.75, 1, 1.5, 2}; /* per axis */
static const char *const gradings[2] = {"1", "2"};
static const struct {
    const char *problem, *settings;
    const Engine *engine;
} scenes[SCENES] = {{"sine_bar", "", &engine_1d}, {"axis_mms", " --set layout=radial", &engine_2d}};

static void cases(Cases *list, bool quick)
{
    EACH_GRID_METHOD(m, &engine_2d)
        for (int g = 0; g < 2; g++)
            for (int k = 0; k < JITTERS; k += quick ? 5 : 1)
                case_add(list, "run patch --method %s --cells %d --set jitter=%g --set grading=%s",
                         m->name, CELLS, jitters[k], gradings[g]);
    for (int s = 0; s < SCENES; s++)
        EACH_GRID_METHOD(m, scenes[s].engine)
            for (int k = quick ? FEW - 1 : 0; k < FEW; k++)
                case_add(list, "run %s --method %s --cells %d --ppc %.17g%s", scenes[s].problem,
                         m->name, CELLS, pow(few[k], scenes[s].engine->dim), scenes[s].settings);
}

/* NAME.points.csv: case,problem,method,grading,x,error,status,fallbacks: x is the jitter, or the
 * particles per axis and cell. */
static void write_points(FILE *f, const Table *rows)
{
    for (int row = 0; row < rows->nrow; row++) {
        const double jitter = select_number(rows, row, "jitter");
        const double ppc = select_number(rows, row, "ppc");
        const int dim = select_is(rows, row, "problem", scenes[0].problem) ? 1 : 2;
        const double per_axis = round(pow(ppc, 1.0 / dim) * 4) / 4;
        results_print(f, "%s,%s,%s,%g,%g,%s,%s,%s\n", isnan(jitter) ? "H-7" : "H-6",
                      select_text(rows, row, "problem"), select_text(rows, row, "method"),
                      isnan(jitter) ? NAN : select_number(rows, row, "grading"),
                      isnan(jitter) ? per_axis : jitter, select_text(rows, row, "error_linf"),
                      select_is_lost(rows, row) ? select_text(rows, row, "status") : "ok",
                      select_text(rows, row, "fallbacks"));
    }
}

/* Error over the amplitude at few particles per axis; INFINITY if the run was lost. */
static Measure few_error(const Table *t, int scene, const char *method, double per_axis)
{
    static const char where[] = "case=H-7 problem=%s method=%s x=%g";
    const char *problem = scenes[scene].problem;
    const Measure error = select_value(t, "error", where, problem, method, per_axis);
    const int row = select_next(t, -1, where, problem, method, per_axis);
    if (error.rows || row < 0) return error;
    return measure(select_is_lost(t, row) ? INFINITY : NAN, 1, 1);
}

/* The fewest particles per axis from which on both scenes' errors stay below a tenth of the
 * amplitude; INFINITY if two are not enough. */
static double fewest(const Table *t, const char *method)
{
    double least = INFINITY;
    for (int k = FEW - 1; k >= 0; k--) {
        const Measure bar = few_error(t, 0, method, few[k]), wave = few_error(t, 1, method, few[k]);
        if (!(measure_worse(bar.value, wave.value) < USABLE)) break;
        least = few[k];
    }
    return least;
}

static void write_marks(FILE *f, const Table *t)
{
    EACH_METHOD_OF(m, &engine_2d, t) {
        const char *method = m->name;
        const double e = curve_worst(t, method, 1, "error", "case=H-6").value;
        const double least = fewest(t, method);
        grade_add(f, "H-6", method, grade_mark_of(e, 1e-12, 1),
                  e <= 1e-12 ? "linear fields exact from any particles"
                             : "a linear field off by up to %.2g from jittered, graded particles",
                  e);
        grade_add(f, "H-7", method, grade_mark_of(least, 0.5, 1.5),
                  isinf(least) ? "two particles per axis are not enough for an error below a tenth"
                               : "needs %.2g particles per axis for an error below a tenth",
                  least);
    }
}

static void tables(const Results *r)
{
    write_points(results_write(r, "points", "case,problem,method,grading,x,error,status,fallbacks"),
                 r->rows);
    write_marks(grades_write(r), results_part(r, "points"));
}

static void check(Check *c, const Results *r)
{
    const Table *t = results_part(r, "points");
    Measure lost = measure_sum_of(4);
    claim(c, "H-6.exact",
          "GE-MPM, GE-GIMP, APIC, TPIC, WLS, WLS2 project a linear field exactly from uneven "
          "particles: largest error",
          curve_worst(t, "ge_mpm ge_gimp apic tpic wls wls2", 2 * JITTERS, "error", "case=H-6"), 0,
          1e-12);
    claim(c, "H-6.tent",
          "Linear field projected from uneven particles: tents and GIMP err alike: MPM's error "
          "over GIMP's at jitter 0.5",
          measure_ratio(select_value(t, "error", "case=H-6 method=mpm x=0.5 grading=1"),
                        select_value(t, "error", "case=H-6 method=gimp x=0.5 grading=1")),
          0.9, 1.2);
    claim(c, "H-7.tent",
          "Sine bar with half a particle per cell: tents have empty nodes: MPM's error over the "
          "amplitude",
          few_error(t, 0, "mpm", 0.5), 0.5, 2);
    claim(c, "H-7.gimp",
          "Sine bar with half a particle per cell: GIMP has no empty nodes, as its boxes reach "
          "beyond h/2: its error over the amplitude",
          few_error(t, 0, "gimp", 0.5), 0, USABLE);
    claim(c, "H-7.plane",
          "Axis-aligned displacement with half a particle per axis: too few for GIMP: its error "
          "over the amplitude",
          few_error(t, 1, "gimp", 0.5), 0.5, 3);
    EACH_WORD(m, "wls wls2")
        for (int k = 0; k < 2; k++) {
            const double e = few_error(t, 1, m, few[k]).value;
            measure_add(&lost, isnan(e) ? NAN : isinf(e));
        }
    claim(c, "H-7.wls",
          "Axis-aligned displacement: WLS, WLS2 need three particles in a support: runs lost with "
          "fewer than one particle per axis, of four",
          lost, 4, 4);
    claim(c, "H-7.wls-one",
          "Axis-aligned displacement with one particle per axis: WLS falls back (W11 eq 14): "
          "number of fallbacks",
          select_value(t, "fallbacks", "case=H-7 problem=axis_mms method=wls x=1"), 1, 100);
}

const StudyPage study_h_06_uneven = {.cases = cases, .tables = tables, .check = check, .claims = 7};
