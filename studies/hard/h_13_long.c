/* h_13_long.c: hard case H-13: long runs. Twenty periods of the ring; the disk to t = 20, which is
 * ten or more impacts. Every method with its defaults, and those that have it with return=spline.
 *
 * The ledger is kinetic + strain energy less the work of body forces, less what it was at first, as
 * a share of the largest energy (energy_drift of the row). A method is graded good if
 * this stays within 5 % (a larger gain has the status energy_growth), weak if it loses or gains
 * more (every method with damping loses more), and lost if the run is lost. */
#include <math.h>
#include "studies/tables/grades.h"
#include "studies/tables/variants.h"

enum { SCENES = 2, MESHES = 2, VARIANTS = 2, EVERY = 20 };
static const struct {
    const char *problem;
    double t_end;
    int cells[MESHES];
} scenes[SCENES] = {{"ring", 0.4, {16, 32}}, {"disk_impact", 20, {24, 48}}};
static const char shown[] = "gimp bspline wls wls2 ge_wls";
static const Variant variants[VARIANTS] = {{"usual", ""}, {"spline", "return=spline"}};

static const char *part_name(int scene, const char *method, int variant)
{
    return phrase("%s.%s.%s", scenes[scene].problem, method, variants[variant].name);
}

/* Does it return through splines, by default or by this variant? */
static bool is_spline(const Info *method, int variant)
{
    const Param *p = info_param_find(method->params, "return");
    return p && (variant > 0 || p->value > 0);
}

/* False where return=spline is the default of the method, which is run already. */
static bool has_variant(const Info *method, int variant)
{
    return variant == 0 || is_spline(method, variant) != is_spline(method, 0);
}

static void add(Cases *list, int scene, const Info *method, int mesh, int variant, bool quick)
{
    const char *run = variant_run(&variants[variant], "run %s --method %s --cells %d --t-end %.17g",
                                  scenes[scene].problem, method->name, scenes[scene].cells[mesh],
                                  scenes[scene].t_end * (quick ? 0.05 : 1));
    if (mesh == MESHES - 1 && select_is_word(shown, method->name))
        case_add_with(list, "history", part_name(scene, method->name, variant), "%s", run);
    else
        case_add(list, "%s", run);
}

static void cases(Cases *list, bool quick)
{
    for (int s = 0; s < SCENES; s++)
        for (int k = 0; k < (quick ? 1 : MESHES); k++)
            EACH_METHOD(m, &engine_2d)
                for (int v = 0; v < VARIANTS; v++)
                    if (has_variant(m, v)) add(list, s, m, k, v, quick);
}

/* NAME.drift.csv: of a method on all meshes of a scene: how many of n runs were lost, the largest
 * gain and loss of the ledger. */
static void write_drift(FILE *f, const Table *rows, int scene, const Info *method, int variant)
{
    double gain = -INFINITY, loss = -INFINITY;
    int lost = 0, n = 0;
    EACH_ROW(row, rows, "method=%s problem=%s", method->name, scenes[scene].problem) {
        const bool spline = select_meets(rows, row, "return=spline");
        const double drift = select_number(rows, row, "energy_drift");
        if (spline != is_spline(method, variant)) continue;
        n++;
        lost += select_is_lost(rows, row);
        gain = measure_worse(gain, isnan(drift) ? INFINITY : drift);
        loss = measure_worse(loss, isnan(drift) ? INFINITY : -drift);
    }
    if (n > 0)
        results_print(f, "%s,%s,%s,%d,%.10g,%.10g,%d,%s\n", scenes[scene].problem, method->name,
                      variants[variant].name, lost, gain, loss, n, lost ? "lost" : "ok");
}

/* The largest gain or loss in both scenes; NAN if a run was lost. */
static double worst(const Table *t, const char *column, const char *method, int variant)
{
    return select_max(t, column, 1, "method=%s variant=%s", method, variants[variant].name).value;
}

static Mark mark_of(const Table *t, const char *method, int variant)
{
    const double gain = worst(t, "gain", method, variant), loss = worst(t, "loss", method, variant);
    return grade_mark_of(measure_worse(gain, loss), ENGINE_GROWTH, INFINITY);
}

static void write_marks(FILE *f, FILE *remedies, const Table *t)
{
    EACH_METHOD_OF(m, &engine_2d, t) {
        const Mark usual = mark_of(t, m->name, 0);
        double lost = 0;
        EACH_ROW(row, t, "method=%s variant=usual", m->name) lost += select_number(t, row, "lost");
        if (usual == MARK_LOST)
            grade_add(f, "H-13", m->name, usual, "%.0f of four long runs lost", lost);
        else
            grade_add(f, "H-13", m->name, usual,
                      "energy from %+.0f to %+.0f %% after twenty periods, ten impacts",
                      -100 * worst(t, "loss", m->name, 0), 100 * worst(t, "gain", m->name, 0));
        if (has_variant(m, 1))
            grade_remedy_add(remedies, "H-13", m->name, variants[1].setting, usual,
                             mark_of(t, m->name, 1), "");
    }
}

/* NAME.ledger.csv: problem,method,variant,t,ledger: every so many instants of the histories. */
static void write_ledger(FILE *f, const Results *r)
{
    for (int s = 0; s < SCENES; s++)
        EACH_WORD(m, shown)
            for (int v = 0; v < VARIANTS; v++) {
                const Table *t = results_ended(r, "%s", part_name(s, m, v));
                const double most = select_largest(t, "total", 1).value;
                for (int k = 0; k < t->nrow; k += EVERY)
                    results_print(f, "%s,%s,%s,%.6g,%.6g\n", scenes[s].problem, m, variants[v].name,
                                  select_number(t, k, "t"),
                                  (select_number(t, k, "total") -
                                   select_number(t, k, "external_work") -
                                   select_number(t, 0, "total")) /
                                      most);
            }
}

static void tables(const Results *r)
{
    FILE *drift = results_write(r, "drift", "problem,method,variant,lost,gain,loss,runs,status");
    EACH_METHOD(m, &engine_2d)
        for (int s = 0; s < SCENES; s++)
            for (int v = 0; v < VARIANTS; v++)
                if (has_variant(m, v)) write_drift(drift, r->rows, s, m, v);
    write_ledger(results_write(r, "ledger", "problem,method,variant,t,ledger"), r);
    write_marks(grades_write(r), grades_write_remedies(r), results_part(r, "drift"));
}

/* Most runs lost of a method and scene, over those methods; all runs must be there. */
static Measure most_lost(const Table *t, const char *methods, const char *where, int each)
{
    Measure lost = measure_max_of(0);
    EACH_WORD(m, methods) {
        Measure own = measure_max_of(each);
        EACH_ROW(row, t, "method=%s runs=%d %s", m, MESHES, where)
            measure_add_max(&own, select_number(t, row, "lost"));
        lost = measure_max(lost, own);
    }
    return lost;
}

static void check(Check *c, const Results *r)
{
    static const char smooth[] = "gimp ge_gimp bspline apic tpic xpic fmpm fem";
    const Table *t = results_part(r, "drift");
    const double growth = ENGINE_GROWTH;
    claim(c, "H-13.smooth",
          "Long runs: GIMP, GE-GIMP, B-splines, APIC, TPIC, XPIC, FMPM, FEM: most runs lost of any "
          "method and scene",
          most_lost(t, smooth, "variant=usual", SCENES), 0, 0);
    claim(c, "H-13.smooth-gain",
          "Long runs: GIMP, GE-GIMP, B-splines, APIC, TPIC, XPIC, FMPM, FEM gain less than 5 % of "
          "energy: most gained",
          curve_worst(t, smooth, SCENES, "gain", "variant=usual runs=2"), -1, growth);
    claim(c, "H-13.wls",
          "WLS (as published) gains energy slowly: share gained in twenty periods of the ring",
          curve_worst(t, "wls", 1, "gain", "problem=ring variant=usual runs=2"), growth, 10);
    claim_differs(c, "H-13.wls2",
                  "WLS2 keeps its energy bounded: share gained in twenty periods of the ring",
                  curve_worst(t, "wls2", 1, "gain", "problem=ring variant=usual runs=2"), -1,
                  growth, growth, 1,
                  "it creeps up by 12 %, half as much as WLS's: velocities fitted through splines "
                  "are returned through tents, which amplifies the null space (H-2)");
    claim(c, "H-13.spline",
          "WLS, WLS2 with return=spline keep their energy bounded: most gained in twenty periods "
          "of the ring",
          curve_worst(t, "wls wls2", 1, "gain", "problem=ring variant=spline runs=2"), -1, growth);
    claim(c, "H-13.ge_wls-gain",
          "GE-WLS keeps its energy bounded: share gained in twenty periods of the ring",
          curve_worst(t, "ge_wls", 1, "gain", "problem=ring variant=usual runs=2"), -1, growth);
    claim(c, "H-13.ge_wls-loss",
          "GE-WLS keeps its energy bounded: share lost in twenty periods of the ring",
          curve_worst(t, "ge_wls", 1, "loss", "problem=ring variant=usual runs=2"), -1, 0.1);
    claim(c, "H-13.disk", "WLS2 with return=spline survives ten impacts of the disk: runs lost",
          most_lost(t, "wls2", "problem=disk_impact variant=spline", 1), 0, 0);
}

const StudyPage study_h_13_long = {.cases = cases, .tables = tables, .check = check, .claims = 8};
