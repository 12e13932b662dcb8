/* t_01_ge_wls.c: gradient-enhanced WLS beside FEM at equal mesh size and WLS2: ring, axis_mms,
 * vortex, plate and disk; whole rings off the grid lines, long times, denser particles and many
 * time steps. Most parts were chosen on one ring; the other scenes show what of that is luck (part
 * by part: t_01_parts.c). Errors as in the rows; CFL .3 on the ring. */
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <string.h>
#include "studies/tables/files.h"
#include "studies/tables/hole.h"

static const char name[] = "t_01_ge_wls";

enum { RUNS = 39, INSTANTS = 300, RIM = 30 }; /* of ge_wls; of a history; along the hole */
enum { MESHES = 9, OFFSETS = 10, STEPS = 7, TIMES = 2 };
static const int cells[MESHES] = {8, 11, 16, 23, 32, 45, 64, 91, 128};
static const double cfl[STEPS] = {0.05, 0.1, 0.2, 0.4, 0.6, 0.7, 0.8};
static const double t_end[TIMES] = {0.08, 0.4}; /* 4 and 20 periods */
static const double late = 4;                   /* [s] the disk's second impact is over */
static const char *const rivals[] = {"ge_wls", "wls2", "fem"};
enum { RIVALS = sizeof rivals / sizeof *rivals };

/* Numbers k/golden ratio: as even as random ones can be, and the same for ever. */
static double spread(int k, double ratio)
{
    return fmod(k * ratio, 1);
}

static void add_rivals(Cases *list, const char *method, bool quick)
{
    for (int k = 0; k < (quick ? 2 : MESHES); k++)
        case_add(list, "run ring --method %s --cells %d", method, cells[k]);
    for (int n = 16; n <= (quick ? 16 : 32); n *= 2) {
        case_add(list, "run axis_mms --method %s --cells %d", method, n);
        case_add(list, "run vortex --method %s --cells %d --set G=0.2 --cfl 0.1", method, n);
    }
    for (int k = 0; k < TIMES; k++)
        for (int n = 16; n <= (quick ? 16 : k ? 32 : 64); n *= 2)
            case_add(list, "run ring --method %s --cells %d --t-end %g", method, n,
                     quick ? 0.04 : t_end[k]);
    for (int k = 0; k < STEPS; k++)
        case_add(list, "run ring --method %s --cells %d --cfl %g", method, quick ? 8 : 32, cfl[k]);
    for (int k = 0; k < (quick ? 2 : OFFSETS); k++)
        case_add(list,
                 "run ring --method %s --cells %d --set sector=full --set offset_x=%.3f --set "
                 "offset_y=%.3f --set angle=%.3f",
                 method, quick ? 8 : 32, spread(k + 1, 0.6180339887), spread(k + 1, 0.4142135624),
                 90 * spread(k + 1, 0.7320508076));
}

static void cases(Cases *list, bool quick)
{
    char file[64];
    snprintf(file, sizeof file, "%s.reference.csv", name);
    case_add_with(list, "samples", file, "run hole_plate --method fem --cells %d",
                  quick ? 32 : 256);
    for (int m = 0; m < RIVALS; m++) add_rivals(list, rivals[m], quick); /* first: see value_of */
    snprintf(file, sizeof file, "%s.plate.csv", name);
    case_add_with(list, "samples", file, "run hole_plate --method ge_wls --cells %d",
                  quick ? 8 : 32);
    snprintf(file, sizeof file, "%s.disk.csv", name);
    case_add_with(list, "history", file, "run disk_impact --method ge_wls --cells %d --t-end %g",
                  quick ? 12 : 48, late);
    for (int ppc = 9; ppc <= (quick ? 9 : 16); ppc += 7)
        case_add(list, "run ring --method ge_wls --cells %d --ppc %d", quick ? 8 : 32, ppc);
}

/* A number of the first such row. */
static Measure value_of(const Table *rows, const char *problem, const char *method, int n,
                        const char *want)
{
    for (int row = 0; row < rows->nrow; row++)
        if (strcmp(table_text(rows, row, "problem"), problem) == 0 &&
            strcmp(table_text(rows, row, "method"), method) == 0 &&
            lround(table_number(rows, row, "cells")) == n)
            return measure(kept_number(rows, row, want), !isnan(kept_number(rows, row, want)), 1);
    return measure(NAN, 0, 1);
}

/* Errors over FEM's on the same mesh. */
static int tables(const char *dir, bool quick, Fault *fault)
{
    static const char *const problem[] = {"ring", "axis_mms", "vortex"};
    char path[PATH_TEXT];
    (void)quick;
    table_part_path(path, dir, name, "shares");
    Table *rows = table_read_part(dir, name, NULL, fault);
    FILE *f = rows ? file_begin(path, fault) : NULL;
    if (f) fputs("problem,method,cells,share\n", f);
    for (int m = 0; f && m < RIVALS - 1; m++)
        for (int p = 0; p < 3; p++)
            for (int k = 0; k < MESHES; k++) {
                const double share =
                    over(value_of(rows, problem[p], rivals[m], cells[k], "error_linf"),
                         value_of(rows, problem[p], "fem", cells[k], "error_linf"))
                        .value;
                if (!isnan(share))
                    fprintf(f, "%s,%s,%d,%.17g\n", problem[p], rivals[m], cells[k], share);
            }
    table_free(rows);
    return f ? file_commit(f, path, fault) : FAULT_MACHINE;
}

/* Of ge_wls over FEM on one mesh. */
static Measure share_of(const Table *rows, const char *problem, const char *norm, int n)
{
    return over(value_of(rows, problem, "ge_wls", n, norm),
                value_of(rows, problem, "fem", n, norm));
}

/* The largest on the ring, over meshes from .. to. */
static Measure worst_share(const Table *rows, const char *norm, int from, int to)
{
    Measure worst = largest_of(0);
    for (int k = 0; k < MESHES; k++)
        if (cells[k] >= from && cells[k] <= to)
            worst = largest(worst, share_of(rows, "ring", norm, cells[k]));
    return worst;
}

static void check_ring(Check *c, const Table *rows)
{
    claim(c, "T-1b.linf", "ring: largest error over FEM's, worst of N = 16 ... 64",
          worst_share(rows, "error_linf", 16, 64), 0, 0.85);
    claim(c, "T-1b.linf-fine", "ring: largest error over FEM's, worst of N = 91 and 128",
          worst_share(rows, "error_linf", 91, 128), 0, 1);
    claim(c, "T-1b.rms", "ring: rms error over FEM's, worst of N = 16 ... 45",
          worst_share(rows, "error_l2", 16, 45), 0, 0.75);
    claim(c, "T-1b.rms-fine", "ring: rms error over FEM's, worst of N = 64 ... 128",
          worst_share(rows, "error_l2", 64, 128), 0, 0.75);
    static const char four_periods[] = "problem=ring method=%s cells=%d t_end=0.08";
    for (int n = 32; n <= 64; n *= 2) {
        char id[32], text[96];
        snprintf(id, sizeof id, "T-1b.four-%d", n);
        snprintf(text, sizeof text, "four periods, N = %d: largest error over FEM's", n);
        claim(c, id, text,
              over(select_value(rows, "error_linf", four_periods, "ge_wls", n),
                   select_value(rows, "error_linf", four_periods, "fem", n)),
              0, 1);
    }
}

/* Mean and spread of errors over whole rings off the grid lines. */
static Measure offsets(const Table *rows, const char *method, double *sd)
{
    double error[OFFSETS] = {0};
    Measure mean = sum_of(OFFSETS);
    int n = 0;
    for (int row = 0; row < rows->nrow && n < OFFSETS; row++)
        if (strcmp(table_text(rows, row, "method"), method) == 0 &&
            strstr(table_text(rows, row, "params"), "sector=full"))
            add_sum(&mean, error[n++] = kept_number(rows, row, "error_linf"));
    *sd = n > 1 ? gsl_stats_sd(error, 1, (size_t)n) : NAN;
    return with_value(mean, gsl_stats_mean(error, 1, (size_t)n));
}

/* Largest error of ge_wls at any time step but the longest, over FEM's at the shortest. */
static Measure worst_step(const Table *rows)
{
    static const char where[] = "problem=ring method=%s cells=32 cfl=%.17g";
    Measure worst = largest_of(0);
    for (int k = 0; k < STEPS - 1; k++)
        worst = largest(worst, select_value(rows, "error_linf", where, "ge_wls", cfl[k]));
    return over(worst, select_value(rows, "error_linf", where, "fem", cfl[0]));
}

static void check_doubts(Check *c, const Table *rows)
{
    double sd, sd_fem;
    const Measure mean = offsets(rows, "ge_wls", &sd);
    claim(c, "T-1b.offsets", "whole rings at ten offsets and angles, N = 32: mean error over FEM's",
          over(mean, offsets(rows, "fem", &sd_fem)), 0, 0.8);
    claim_note(c, "spread", sd / mean.value);
    claim(c, "T-1b.cfl", "CFL .05 to .7, N = 32: largest error over FEM's at CFL .05",
          worst_step(rows), 0, 1);
    claim(c, "T-1b.lost", "runs of ge_wls lost, of all here",
          count_lost(rows, RUNS, "method=ge_wls"), 0, 0);
    claim(c, "T-1b.vortex", "generalized vortex, G = .2, N = 32: largest error over FEM's",
          share_of(rows, "vortex", "error_linf", 32), 0, 1);
    claim(c, "T-1b.axis",
          "axis-aligned displacement (no free surface), N = 32: largest error over FEM's",
          share_of(rows, "axis_mms", "error_linf", 32), 0, 0.3);
}

/* Energy over that at the start: the last before `t` [s], or the largest so far. */
static Measure disk_energy(const Files *files, double t, bool most)
{
    Measure out = largest_of(INSTANTS);
    double last = NAN;
    Table *h = file_read(files, "disk");
    for (int k = 0; h && k < h->nrow && table_number(h, k, "t") <= t; k++) {
        last = table_number(h, k, "total") / table_number(h, 0, "total");
        add_largest(&out, last);
    }
    table_free(h);
    return most || isnan(out.value) ? out : with_value(out, last);
}

static void check_scenes(Check *c, const char *dir)
{
    Measure rms = sum_of(RIM), scatter = sum_of(RIM);
    char path[2][PATH_TEXT];
    Files files;
    files_open(&files, dir, name);
    claim(c, "T-1b.disk", "disk: energy over E0 at t = 2.3", disk_energy(&files, 2.3, false), 0.98,
          1.005);
    claim(c, "T-1b.disk-late", "disk: energy over E0 at t = 4", disk_energy(&files, late, false),
          0.91, 1.005);
    claim(c, "T-1b.disk-most", "disk: largest energy over E0 until t = 4",
          disk_energy(&files, late, true), 0.99, 1.005);
    if (file_path(&files, "reference", path[0]) && file_path(&files, "plate", path[1]))
        rim_measure(path[0], 256, path[1], 32, &rms, &scatter);
    files_close(&files);
    claim(c, "T-1b.plate", "plate, h = 1/32: rms difference of stress from the reference [GPa]",
          rms, 0, 2.2);
    claim(c, "T-1b.plate-scatter", "plate, h = 1/32: scatter of stress along the hole [GPa]",
          scatter, 0, 1.8);
}

static void check(Check *c, const Table *rows, const char *dir)
{
    check_ring(c, rows);
    check_doubts(c, rows);
    check_scenes(c, dir);
}

const Study study_t_01_ge_wls = {
    .name = name,
    .figure = "T-1b",
    .about = "GE-WLS beside FEM at equal mesh size: where it is better and where not",
    .cases = cases,
    .tables = tables,
    .check = check,
    .claims = 16,
};
