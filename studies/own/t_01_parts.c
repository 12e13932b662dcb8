/* t_01_parts.c: GE-WLS with one part removed at a time: the effect of each part on seven scenes.
 * The ring at several meshes beside FEM; then one number per scene, over that of the whole method:
 *   ring, axis_mms, vortex   largest error
 *   plate                    rms difference of stress along the hole from a fine FEM mesh's
 *   disk                     |E/E_0 - 1| at t = 2.3
 *   block                    velocities in the null space: sqrt(K/K_0) after 1500 steps
 *   bar                      momentum drift
 * Then WLS2 with one part of GE-WLS (velocity=corrected; return=spline), with which velocities in
 * the null space still grow, and with two (return=spline, hermite=1000), with which they do not. */
#include <math.h>
#include "studies/runs/run_row.h"
#include "studies/tables/grades.h"
#include "studies/tables/hole.h"

/* The parts, and what stands in their place without them. */
enum { AVERAGE, DISTANCE, HERMITE, MASS, MOTION, RETURN, VELOCITY, PARTS, WHOLE = -1 };
static const struct {
    const char *setting, *with, *without;
} parts[PARTS] = {
    [AVERAGE] = {"average", "folded", "weighted"},  [DISTANCE] = {"distance", "curved", "normals"},
    [HERMITE] = {"hermite", "1000", "0"},           [MASS] = {"mass", "corrected", "lumped"},
    [MOTION] = {"motion", "consistent", "lagged"},  [RETURN] = {"return", "spline", "linear"},
    [VELOCITY] = {"velocity", "corrected", "plain"}};

enum { RING, AXIS, VORTEX, PLATE, DISK, BLOCK, BAR, SCENES };
static const struct {
    const char *problem, *column, *file, *more; /* a column of the row, or a file beside it */
    int cells, quick;
} scenes[SCENES] = {[RING] = {"ring", "error_linf", NULL, "", 32, 8},
                    [AXIS] = {"axis_mms", "error_linf", NULL, "", 32, 8},
                    [VORTEX] = {"vortex", "error_linf", NULL, " --set G=0.2 --cfl 0.1", 32, 8},
                    [PLATE] = {"hole_plate", NULL, "samples", "", 32, 8},
                    [DISK] = {"disk_impact", NULL, "history", " --t-end 2.3", 48, 12},
                    [BLOCK] = {"block", NULL, "history",
                               " --set dim=2 --set ripple=1e-4 --set offset_x=0.3 --set "
                               "offset_y=0.2",
                               16, 16},
                    [BAR] = {"bar", "momentum_drift", NULL, "", 40, 10}};

enum { MESHES = 7, STEPS = 1500, RIM = 30, FINE = 256, CURES = 3 };
static const int cells[MESHES] = {8, 11, 16, 23, 32, 45, 64};
static const char *const cures[CURES] = {"velocity=corrected", "return=spline",
                                         "return=spline --set hermite=1000"};

static const char *part_label(int part)
{
    return part == WHOLE ? "all" : parts[part].setting;
}

static const char *file_part(int scene, const char *what)
{
    return phrase("%s.%s", scenes[scene].problem, what);
}

/* The setting that takes a part away, as an option. */
static const char *without(int part)
{
    return part == WHOLE ? "" : phrase(" --set %s=%s", parts[part].setting, parts[part].without);
}

/* set: " --set name=value", or "". */
static void add_scene(Cases *list, int scene, const char *method, const char *what, const char *set,
                      bool quick)
{
    const int n = quick ? scenes[scene].quick : scenes[scene].cells;
    const char *end = "", *line;
    if (scene == BLOCK)
        end = phrase(" --t-end %.17g", (quick ? 10 : STEPS) * BLOCK_CFL / (n * BLOCK_SPEED));
    line = phrase("run %s --method %s --cells %d%s%s%s", scenes[scene].problem, method, n,
                  scenes[scene].more, end, set);
    if (scenes[scene].file)
        case_add_with(list, scenes[scene].file, file_part(scene, what), "%s", line);
    else
        case_add(list, "%s", line);
}

static void cases(Cases *list, bool quick)
{
    case_add_with(list, "samples", "reference", "run hole_plate --method fem --cells %d",
                  quick ? 32 : FINE);
    for (int k = 0; k < (quick ? 2 : MESHES); k++)
        case_add(list, "run ring --method fem --cells %d", cells[k]);
    for (int part = WHOLE; part < PARTS; part++) {
        for (int s = 0; s < SCENES; s++)
            add_scene(list, s, "ge_wls", part_label(part), without(part), quick);
        for (int k = 0; k < (quick ? 2 : MESHES); k++)
            if (cells[k] != (quick ? scenes[RING].quick : scenes[RING].cells))
                case_add(list, "run ring --method ge_wls --cells %d%s", cells[k], without(part));
    }
    for (int k = 0; k < CURES; k++)
        add_scene(list, BLOCK, "wls2", phrase("wls2-%d", k), phrase(" --set %s", cures[k]), quick);
}

/* A number of GE-WLS without this part. */
static Measure value_of(const Table *rows, int scene, int n, int part)
{
    const Measure m =
        run_row_value(rows, scenes[scene].column, "run %s --method ge_wls --cells %d%s%s",
                      scenes[scene].problem, n, scenes[scene].more, without(part));
    return measure_with(m, fabs(m.value));
}

/* From a history: sqrt(K/K_0) at its end, or |E/E_0 - 1|. */
static Measure history_end(const Results *r, int scene, const char *what)
{
    const Table *h = results_run(r, "%s", file_part(scene, what));
    const double ratio = curve_growth(h, scene == BLOCK ? "kinetic" : "total");
    return measure(scene == BLOCK ? sqrt(ratio) : fabs(ratio - 1), !isnan(ratio), 1);
}

static Measure plate_rms(const Results *r, const char *what)
{
    Measure rms = measure_sum_of(RIM), scatter = measure_sum_of(RIM);
    hole_measure(results_run(r, "reference"), FINE, results_run(r, "%s", file_part(PLATE, what)),
                 scenes[PLATE].cells, &rms, &scatter);
    return rms;
}

static Measure scene_value(const Results *r, int scene, int part)
{
    if (scene == PLATE) return plate_rms(r, part_label(part));
    if (scenes[scene].file) return history_end(r, scene, part_label(part));
    return value_of(r->rows, scene, scenes[scene].cells, part);
}

static void write_ring(FILE *f, const Table *rows, int part)
{
    for (int k = 0; k < MESHES; k++) {
        const Measure fem =
            run_row_value(rows, "error_linf", "run ring --method fem --cells %d", cells[k]);
        const double share = measure_ratio(value_of(rows, RING, cells[k], part), fem).value;
        if (!isnan(share))
            results_print(f, "%s,share,%d,%.17g\n", part_label(part), cells[k], share);
    }
}

static void tables(const Results *r)
{
    FILE *f = results_write(r, "gains", "part,what,at,value");
    for (int part = WHOLE; part < PARTS; part++) {
        write_ring(f, r->rows, part);
        for (int s = 0; s < SCENES && part != WHOLE; s++) {
            const Measure gain = measure_ratio(scene_value(r, s, part), scene_value(r, s, WHOLE));
            results_print(f, "%s,%s,%d,%.17g\n", part_label(part), scenes[s].problem, s,
                          gain.value);
        }
    }
}

/* Each part must be needed somewhere: the largest factor over the scenes. */
static void check_parts(Check *c, const Table *gains)
{
    static const double low[PARTS] = {1.4, 1.1, 5, 2, 50, 50, 2};
    for (int part = 0; part < PARTS; part++) {
        Measure most = measure_max_of(SCENES);
        for (int s = 0; s < SCENES; s++)
            EACH_ROW(row, gains, "part=%s what=%s", part_label(part), scenes[s].problem)
                measure_add_max(&most, select_number(gains, row, "value"));
        claim(c, phrase("T-1c.%s", parts[part].setting),
              phrase("GE-WLS without %s=%s: error over that of the whole method, largest of seven "
                     "scenes",
                     parts[part].setting, parts[part].with),
              most, low[part], 1e5);
    }
}

static void check(Check *c, const Results *r)
{
    check_parts(c, results_part(r, "gains"));
    claim(c, "T-1c.ringing",
          "GE-WLS keeps velocities in the null space: amplitude after 1500 steps over the first",
          history_end(r, BLOCK, "all"), 0.9, 1.1);
    claim(c, "T-1c.wls2-spline",
          "WLS2 with return=spline alone amplifies velocities in the null space: amplitude after "
          "1500 steps over the first",
          history_end(r, BLOCK, "wls2-1"), 1.1, 100);
    claim(c, "T-1c.wls2-cured",
          "WLS2 with return=spline and hermite=1000 keeps velocities in the null space: amplitude "
          "after 1500 steps over the first",
          history_end(r, BLOCK, "wls2-2"), 0.9, 1.1);
}

const StudyPage study_t_01_parts = {.cases = cases, .tables = tables, .check = check, .claims = 10};
