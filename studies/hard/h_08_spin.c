/* h_08_spin.c: hard cases H-8a and H-8b: large rotation.
 *
 * (a) Ten turns of v = w x r, imposed, without stress. F += dt L F takes F to (I + dt W) F, whose
 * determinant grows by 1 + (w dt)^2 per step: J = exp(2 pi w dt) per turn; so does the area that
 * the particles' positions enclose. At a quarter turn the half width l0 |F_xx| of boxes vanishes.
 *
 * (b) Ten turns of a free elastic block, by each method's usual scheme. Angular momentum is that
 * of the particles' motion about the centre of mass, without what APIC and TPIC keep in L. */
#include <math.h>
#include "studies/tables/grades.h"
#include "studies/tables/masses.h"
#include "studies/tables/variants.h"

enum { CELLS = 16, TURNS = 10, METHODS = 12 /* that finish the imposed spin */ };
enum { USUAL, STRETCH, EXPONENTIAL, SUBCYCLED, VARIANTS };
#define SPIN       1.0                                /* (a): w [c/m] */
#define PER_STEP   (SPIN * BLOCK_CFL / (double)CELLS) /* (a): w dt */
#define BLOCK_TURN (2 * M_PI / (SPIN * BLOCK_SPEED))  /* (a) [s] */

static const Variant variants[VARIANTS] = {{"usual", ""},
                                           {"stretch", "domain=stretch"},
                                           {"exponential", "strain_update=exponential"},
                                           {"subcycled", "strain_update=subcycled"}};

enum { SPUN, QUARTER, FREE, SCENES };
static const struct {
    const char *name, *problem, *settings;
    double turn, turns; /* [s] and how many */
    int variants;       /* so many; free and subcycled lies between usual and exponential */
    const char *hard_case, *column;
    double exact, ok, weak; /* how far the column may be from exact */
} scenes[SCENES] = {
    [SPUN] = {"spin", "block", "--set dim=2 --set box=4 --set spin=1", BLOCK_TURN, TURNS, VARIANTS,
              "H-8a", "J", 1, 0.01, INFINITY},
    [QUARTER] = {"quarter", "block", "--set dim=2 --set box=4 --set spin=1", BLOCK_TURN, 0.25, 1,
                 "", "", 0, 0, 0},
    [FREE] = {"free", "free_block", "--set dim=2 --set box=2 --set swing=0 --set drift=0",
              FREE_TURN, TURNS, SUBCYCLED, "H-8b", "loss", 0, 0.002, 1},
};

static const char *part_name(int scene, const char *method, int variant)
{
    return phrase("%s.%s.%s", scenes[scene].name, method, variants[variant].name);
}

static void cases(Cases *list, bool quick)
{
    EACH_METHOD(m, &engine_2d)
        for (int s = 0; s < SCENES; s++)
            for (int v = 0; v < scenes[s].variants; v++) {
                const double turns = quick ? fmin(scenes[s].turns, 0.5) : scenes[s].turns;
                const char *run = variant_run(
                    &variants[v], "run %s --method %s --cells %d --t-end %.17g %s",
                    scenes[s].problem, m->name, CELLS, turns * scenes[s].turn, scenes[s].settings);
                if (run) case_add_with(list, "particles", part_name(s, m->name, v), "%s", run);
            }
}

/* Writes one line per run. growth: that of J per turn over exp(2 pi w dt); loss: that of angular
 * momentum per turn. */
static void write_one(FILE *f, const Results *r, int row)
{
    static const double middle[2] = {1, 1}; /* box = 2 */
    const Table *rows = r->rows;
    const bool whole = select_number(rows, row, "t_end") > 0.4 * BLOCK_TURN; /* --quick: half */
    const bool is_free = select_is(rows, row, "problem", scenes[FREE].problem);
    const int s = is_free ? FREE : whole ? SPUN : QUARTER;
    const int v = variant_of_row(variants, VARIANTS, rows, row);
    const char *method = select_text(rows, row, "method");
    const double steps = select_number(rows, row, "steps"), dt = select_number(rows, row, "dt");
    const double turns = steps * dt / scenes[s].turn, w = 2 * M_PI / FREE_TURN;
    const MassSums end = masses_sum(results_ended(r, "%s", part_name(s, method, v)), middle);
    if (end.n == 0) return;
    const double growth = pow(end.J, 1 / turns) / exp(2 * M_PI * PER_STEP);
    const double loss = 1 - pow(measure_worse(end.angular / (w * end.inertia), 0), 1 / turns);
    results_print(f, "%s,%s,%s,%s,%.6g,%.10g,%.10g,%.10g,%.10g,%.10g,%.10g\n", scenes[s].name,
                  method, variants[v].name,
                  select_is_lost(rows, row) ? select_text(rows, row, "status") : "ok", turns, end.J,
                  end.least_J, end.most_J, end.least_Fxx, is_free ? NAN : growth,
                  is_free ? loss : NAN);
}

static const char where[] = "scene=%s method=%s variant=%s";

/* How far the area, or the angular momentum lost per turn, is off; NAN: the run was lost. */
static double deviation(const Table *t, int s, const char *method, int v)
{
    const Measure x =
        select_value(t, scenes[s].column, where, scenes[s].name, method, variants[v].name);
    return fabs(x.value - scenes[s].exact);
}

static Mark mark_of(const Table *t, int s, const char *method, int v)
{
    return grade_mark_of(deviation(t, s, method, v), scenes[s].ok, scenes[s].weak);
}

static void write_remedy(FILE *f, const Table *t, int s, const char *method, int v)
{
    if (select_next(t, -1, where, scenes[s].name, method, variants[v].name) < 0) return;
    const double before = deviation(t, s, method, USUAL), after = deviation(t, s, method, v);
    const char *was = isnan(before) ? "lost" : phrase("%.2g", before);
    const char *note = isnan(after) ? "lost" : phrase("%s -> %.2g of it lost per turn", was, after);
    grade_remedy_add(f, scenes[s].hard_case, method, variants[v].setting,
                     mark_of(t, s, method, USUAL), mark_of(t, s, method, v), s == FREE ? note : "");
}

static void write_marks(FILE *f, FILE *remedies, const Table *t)
{
    EACH_ROW(row, t, "scene=free variant=usual") {
        const char *method = select_text(t, row, "method");
        const Mark free = mark_of(t, FREE, method, USUAL);
        grade_add(f, "H-8a", method, mark_of(t, SPUN, method, USUAL),
                  "area %.3g times the right one after %d imposed turns",
                  select_ended(t, "J", where, "spin", method, "usual").value, TURNS);
        if (free == MARK_LOST)
            grade_add(f, "H-8b", method, free, "lost after %.2g turns",
                      select_number(t, row, "turns"));
        else
            grade_add(f, "H-8b", method, free, "angular momentum changes by %.2g %% per turn",
                      -100 * select_number(t, row, "loss"));
        for (int v = 1; v < VARIANTS; v++)
            for (int s = 0; s < SCENES; s++) write_remedy(remedies, t, s, method, v);
    }
}

static void tables(const Results *r)
{
    FILE *f = results_write(r, "turns",
                            "scene,method,variant,status,turns,J,least,most,narrowest,growth,loss");
    for (int row = 0; row < r->rows->nrow; row++) write_one(f, r, row);
    write_marks(grades_write(r), grades_write_remedies(r), results_part(r, "turns"));
}

/* Claims about options that change the result. */
static void check_remedies(Check *c, const Table *t)
{
    const char *linear = "ge_mpm ge_gimp apic tpic wls2";
    const double quarter = exp(TURNS * 2 * M_PI * PER_STEP / 4);
    const Measure J = curve_worst(t, linear, 1, "J", "scene=spin variant=exponential");
    claim(c, "H-8a.exponential", "Imposed spin with F = exp(dt L) F: J after ten turns, less 1",
          measure_with(J, J.value - 1), -1e-6, 1e-6);
    claim(
        c, "H-8a.subcycled",
        "Imposed spin with F updated in four parts: J after ten turns over exp(2 pi w dt/4) per "
        "turn",
        measure_times(curve_worst(t, linear, 1, "J", "scene=spin variant=subcycled"), 1 / quarter),
        0.99, 1.01);
    claim(c, "H-8b.stretch",
          "Free spin, boxes of width l0 U_dd: runs lost of GIMP, GE-GIMP, XPIC, FMPM",
          curve_lost(t, "gimp ge_gimp xpic fmpm", 1, "scene=free variant=stretch"), 0, 0);
    claim(
        c, "H-8b.exponential",
        "Free spin: F = exp(dt L) F does not fit x += dt v, and GIMP is lost: after how many turns",
        select_ended(t, "turns", "method=gimp scene=free variant=exponential"), 0, 9.9);
}

static void check(Check *c, const Results *r)
{
    const Table *t = results_part(r, "turns");
    static const char exact[] = "ge_mpm ge_gimp apic tpic wls wls2 fem";
    Measure some = measure_max_of(7), all = measure_max_of(METHODS);
    EACH_ROW(row, t, "scene=spin variant=usual status=ok") {
        const double by = fabs(select_number(t, row, "growth") - 1);
        if (select_is_word(exact, select_text(t, row, "method"))) measure_add_max(&some, by);
        measure_add_max(&all, by);
    }
    claim(c, "H-8a.growth",
          "Imposed spin: J grows by exp(2 pi w dt) per turn with GE-MPM, GE-GIMP, APIC, TPIC, WLS, "
          "WLS2 and FEM: largest relative deviation",
          some, 0, 0.01);
    claim_differs(c, "H-8a.growth-all",
                  "Imposed spin: J grows by exp(2 pi w dt) per turn with every method that "
                  "finishes: largest relative deviation",
                  all, 0, 0.01, 0.01, 0.1,
                  "per turn GIMP and XPIC gain 3.9 % less, FMPM 2.1, B-splines 1.3, MPM 1.1: "
                  "mass-weighted projection underestimates rotation at edges");
    claim(c, "H-8a.extent",
          "Imposed spin: after a quarter turn particle boxes have no width left: least |F_xx| of "
          "GIMP",
          select_value(t, "narrowest", "scene=quarter variant=usual method=gimp"), 0, 0.02);
    claim_differs(
        c, "H-8b.J",
        "Free spin with cd: J stays within 1.5 % of 1: largest mean J of GIMP, GE-GIMP, APIC, FEM",
        curve_worst(t, "gimp ge_gimp apic fem", 1, "J", "scene=free variant=usual"), 1, 1.015,
        1.015, 1.03,
        "it is bounded by 1.022 (FEM), 1.015 (GE-GIMP), 1.012 (APIC), 1.007 (GIMP): the block "
        "starts without the strain of its spin and breathes");
    claim(c, "H-8b.gimp", "Free spin: GIMP loses 1.7 % of its angular momentum per turn",
          select_value(t, "loss", "scene=free variant=usual method=gimp"), 0.012, 0.022);
    claim_differs(c, "H-8b.ge-gimp",
                  "Free spin: GE-GIMP loses a tenth of a per cent of its angular momentum per turn",
                  select_value(t, "loss", "scene=free variant=usual method=ge_gimp"), 0.0005, 0.002,
                  0, 0.0005,
                  "it loses .024 % per turn, a quarter of that, on this mesh of 16 cells per side");
    check_remedies(c, t);
}

const StudyPage study_h_08_spin = {.cases = cases, .tables = tables, .check = check, .claims = 10};
