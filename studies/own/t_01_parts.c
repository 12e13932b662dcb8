/* t_01_parts.c: GE-WLS with one part removed at a time: what each part buys, on seven scenes. The
 * ring at several meshes beside FEM; then one number per scene, over that of the whole method:
 *   ring, axis_mms, vortex   largest error
 *   plate                    rms difference of stress along the hole from a fine FEM mesh's
 *   disk                     |E/E_0 - 1| at t = 2.3
 *   block                    velocities that the grid cannot see: sqrt(K/K_0) after 1500 steps
 *   bar                      momentum drift
 * Then WLS2 with those parts that end its growth of invisible velocities, and one that does not. */
#include <math.h>
#include <string.h>
#include "studies/tables/files.h"
#include "studies/tables/grades.h"
#include "studies/tables/hole.h"

static const char name[] = "t_01_parts";

/* The parts, and what stands in their place without them. */
enum { AVERAGE, DISTANCE, HERMITE, MASS, MOTION, RETURN, VELOCITY, PARTS };
static const struct {
    const char *setting, *with, *without;
} parts[PARTS] = {
    [AVERAGE] = {"average", "folded", "weighted"},  [DISTANCE] = {"distance", "curved", "normals"},
    [HERMITE] = {"hermite", "1000", "0"},           [MASS] = {"mass", "corrected", "lumped"},
    [MOTION] = {"motion", "consistent", "lagged"},  [RETURN] = {"return", "spline", "linear"},
    [VELOCITY] = {"velocity", "corrected", "plain"}};

enum { RING, AXIS, VORTEX, PLATE, DISK, BLOCK, BAR, SCENES };
static const struct {
    const char *problem, *column, *part, *more; /* a column of the row, or a file beside it */
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

enum { MESHES = 7, STEPS = 1500, RIM = 30, CURES = 3 };
static const int cells[MESHES] = {8, 11, 16, 23, 32, 45, 64};
static const char *const cures[CURES] = {"velocity=corrected", "return=spline",
                                         "return=spline --set hermite=1000"};

static const char *setting_without(int part, char text[64])
{
    *text = 0;
    if (part >= 0) snprintf(text, 64, "%s=%s", parts[part].setting, parts[part].without);
    return text;
}

static void file_part(char text[64], int scene, const char *what)
{
    snprintf(text, 64, "%s.%s", scenes[scene].problem, what);
}

static void add_scene(Cases *list, int scene, const char *method, const char *what, const char *set,
                      bool quick)
{
    char part[64], file[96], end[48] = "", line[320];
    const int n = quick ? scenes[scene].quick : scenes[scene].cells;
    file_part(part, scene, what);
    snprintf(file, sizeof file, "%s.%s.csv", name, part);
    if (scene == BLOCK)
        snprintf(end, sizeof end, " --t-end %.17g",
                 (quick ? 10 : STEPS) * BLOCK_CFL / (n * BLOCK_SPEED));
    snprintf(line, sizeof line, "run %s --method %s --cells %d%s%s%s%s", scenes[scene].problem,
             method, n, scenes[scene].more, end, *set ? " --set " : "", set);
    if (scenes[scene].part)
        case_add_with(list, scenes[scene].part, file, "%s", line);
    else
        case_add(list, "%s", line);
}

static void cases(Cases *list, bool quick)
{
    char file[64], set[64];
    snprintf(file, sizeof file, "%s.reference.csv", name);
    case_add_with(list, "samples", file, "run hole_plate --method fem --cells %d",
                  quick ? 32 : 256);
    for (int k = 0; k < (quick ? 2 : MESHES); k++)
        case_add(list, "run ring --method fem --cells %d", cells[k]);
    for (int part = -1; part < PARTS; part++) { /* the whole method first: see row_of */
        setting_without(part, set);
        for (int s = 0; s < SCENES; s++)
            add_scene(list, s, "ge_wls", part < 0 ? "all" : parts[part].setting, set, quick);
        for (int k = 0; k < (quick ? 2 : MESHES); k++)
            if (cells[k] != (quick ? scenes[RING].quick : scenes[RING].cells))
                case_add(list, "run ring --method ge_wls --cells %d%s%s", cells[k],
                         *set ? " --set " : "", set);
    }
    for (int k = 0; k < CURES; k++) {
        snprintf(set, sizeof set, "wls2-%d", k);
        add_scene(list, BLOCK, "wls2", set, cures[k], quick);
    }
}

/* The first row of a run, that of the whole method unless a setting is named; -1: there is none. */
static int row_of(const Table *rows, const char *problem, const char *method, int n,
                  const char *setting)
{
    for (int row = 0; row < rows->nrow; row++)
        if (strcmp(table_text(rows, row, "problem"), problem) == 0 &&
            strcmp(table_text(rows, row, "method"), method) == 0 &&
            (n < 0 || lround(table_number(rows, row, "cells")) == n) &&
            strstr(table_text(rows, row, "params"), setting))
            return row;
    return -1;
}

static Measure number_of(const Table *rows, int row, const char *column)
{
    const double x = row < 0 ? NAN : kept_number(rows, row, column);
    return measure(fabs(x), !isnan(x), 1);
}

/* From a history: sqrt(K/K_0) at its end, or |E/E_0 - 1|. */
static Measure history_end(const Files *files, int scene, const char *what)
{
    char part[64];
    file_part(part, scene, what);
    Table *h = file_read(files, part);
    const int last = h ? h->nrow - 1 : 0;
    const char *column = scene == BLOCK ? "kinetic" : "total";
    const double ratio =
        h && last > 0 ? table_number(h, last, column) / table_number(h, 0, column) : NAN;
    table_free(h);
    return measure(scene == BLOCK ? sqrt(ratio) : fabs(ratio - 1), !isnan(ratio), 1);
}

static Measure plate_rms(const Files *files, const char *what)
{
    Measure rms = sum_of(RIM), scatter = sum_of(RIM);
    char part[64], fine[PATH_TEXT], path[PATH_TEXT];
    file_part(part, PLATE, what);
    if (file_path(files, "reference", fine) && file_path(files, part, path))
        rim_measure(fine, 256, path, scenes[PLATE].cells, &rms, &scatter);
    return rms;
}

static Measure scene_value(const Table *rows, const Files *files, int scene, int part)
{
    char text[64];
    const char *what = part < 0 ? "all" : parts[part].setting;
    if (scene == PLATE) return plate_rms(files, what);
    if (!scenes[scene].column) return history_end(files, scene, what);
    return number_of(rows,
                     row_of(rows, scenes[scene].problem, "ge_wls", scenes[scene].cells,
                            setting_without(part, text)),
                     scenes[scene].column);
}

static void write_ring(FILE *f, const Table *rows, int part)
{
    char text[64];
    setting_without(part, text);
    for (int k = 0; k < MESHES; k++) {
        const double share =
            over(number_of(rows, row_of(rows, "ring", "ge_wls", cells[k], text), "error_linf"),
                 number_of(rows, row_of(rows, "ring", "fem", cells[k], ""), "error_linf"))
                .value;
        if (!isnan(share))
            fprintf(f, "%s,share,%d,%.17g\n", part < 0 ? "all" : parts[part].setting, cells[k],
                    share);
    }
}

static int tables(const char *dir, bool quick, Fault *fault)
{
    char path[PATH_TEXT];
    Files files;
    (void)quick;
    table_part_path(path, dir, name, "gains");
    Table *rows = table_read_part(dir, name, NULL, fault);
    FILE *f = rows ? file_begin(path, fault) : NULL;
    if (!f) return table_free(rows), FAULT_MACHINE;
    files_open(&files, dir, name);
    fputs("part,what,at,value\n", f);
    for (int part = -1; part < PARTS; part++) {
        write_ring(f, rows, part);
        for (int s = 0; s < SCENES && part >= 0; s++) {
            const double factor =
                over(scene_value(rows, &files, s, part), scene_value(rows, &files, s, -1)).value;
            if (!isnan(factor))
                fprintf(f, "%s,%s,%d,%.17g\n", parts[part].setting, scenes[s].problem, s, factor);
        }
    }
    files_close(&files);
    table_free(rows);
    return file_commit(f, path, fault);
}

/* Each part must be needed somewhere: the largest factor over the scenes. */
static void check_parts(Check *c, const Table *rows, const Files *files)
{
    static const double low[PARTS] = {1.4, 1.1, 5, 2, 50, 50, 2};
    for (int part = 0; part < PARTS; part++) {
        char id[64], text[160];
        Measure most = largest_of(0);
        for (int s = 0; s < SCENES; s++)
            most = largest(
                most, over(scene_value(rows, files, s, part), scene_value(rows, files, s, -1)));
        snprintf(id, sizeof id, "T-1c.%s", parts[part].setting);
        snprintf(text, sizeof text,
                 "GE-WLS without %s=%s: largest factor by which an error grows, of seven scenes",
                 parts[part].setting, parts[part].with);
        claim(c, id, text, most, low[part], 1e5);
    }
}

static void check(Check *c, const Table *rows, const char *dir)
{
    Files files;
    files_open(&files, dir, name);
    check_parts(c, rows, &files);
    claim(c, "T-1c.ringing",
          "GE-WLS keeps velocities that the grid cannot see: left after 1500 steps, of 1",
          history_end(&files, BLOCK, "all"), 0.9, 1.1);
    claim(c, "T-1c.wls2-spline",
          "WLS2 with return=spline alone amplifies them: left after 1500 steps, of 1",
          history_end(&files, BLOCK, "wls2-1"), 1.1, 100);
    claim(c, "T-1c.wls2-cured",
          "WLS2 with return=spline and hermite=1000 keeps them: left after 1500 steps, of 1",
          history_end(&files, BLOCK, "wls2-2"), 0.9, 1.1);
    files_close(&files);
}

const Study study_t_01_parts = {
    .name = name,
    .figure = "T-1c",
    .about = "GE-WLS with one part removed at a time: what each part buys, on seven scenes",
    .cases = cases,
    .tables = tables,
    .check = check,
    .claims = 10,
};
