/* t_01_ge_wls.c: gradient-enhanced WLS beside FEM at equal mesh size and WLS2: ring, axis_mms,
 * vortex, plate and disk; whole rings off the grid lines, long times, denser particles and many
 * time steps. Most parts were chosen by their error on one ring; the other scenes show whether they
 * also help elsewhere (part by part: t_01_parts.c). Errors as in the rows; CFL .3 on the ring. */
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include "studies/tables/curves.h"
#include "studies/tables/hole.h"

enum { RUNS = 39, INSTANTS = 300, RIM = 30 }; /* of ge_wls; of a history; along the hole */
enum { MESHES = 9, OFFSETS = 10, STEPS = 7, TIMES = 2 };
static const int cells[MESHES] = {8, 11, 16, 23, 32, 45, 64, 91, 128};
static const double cfl[STEPS] = {0.05, 0.1, 0.2, 0.4, 0.6, 0.7, 0.8};
static const double t_end[TIMES] = {0.08, 0.4}; /* 4 and 20 periods */
static const double late = 4;                   /* [s] the disk's second impact is over */
static const char *const rivals[] = {"ge_wls", "wls2", "fem"};
enum { RIVALS = sizeof rivals / sizeof *rivals };

/* Fractional part of k times an irrational ratio: spread evenly over [0, 1), and the same in every
 * run. */
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
    case_add_with(list, "samples", "reference", "run hole_plate --method fem --cells %d",
                  quick ? 32 : 128);
    for (int m = 0; m < RIVALS; m++) add_rivals(list, rivals[m], quick); /* first: see value_of */
    case_add_with(list, "samples", "plate", "run hole_plate --method ge_wls --cells %d",
                  quick ? 8 : 32);
    case_add_with(list, "history", "disk", "run disk_impact --method ge_wls --cells %d --t-end %g",
                  quick ? 12 : 48, late);
    for (int ppc = 9; ppc <= (quick ? 9 : 16); ppc += 7)
        case_add(list, "run ring --method ge_wls --cells %d --ppc %d", quick ? 8 : 32, ppc);
}

/* A number of the first such row. */
static Measure value_of(const Table *rows, const char *problem, const char *method, int n,
                        const char *want)
{
    return select_value(rows, want, "problem=%s method=%s cells=%d", problem, method, n);
}

/* Error of a method over FEM's on the same mesh. */
static Measure share_of(const Table *rows, const char *problem, const char *method,
                        const char *norm, int n)
{
    return measure_ratio(value_of(rows, problem, method, n, norm),
                         value_of(rows, problem, "fem", n, norm));
}

static void tables(const Results *r)
{
    static const char *const problem[] = {"ring", "axis_mms", "vortex"};
    FILE *f = results_write(r, "shares", "problem,method,cells,share");
    for (int m = 0; m < RIVALS - 1; m++)
        for (int p = 0; p < 3; p++)
            for (int k = 0; k < MESHES; k++) {
                const double share =
                    share_of(r->rows, problem[p], rivals[m], "error_linf", cells[k]).value;
                if (!isnan(share))
                    results_print(f, "%s,%s,%d,%.17g\n", problem[p], rivals[m], cells[k], share);
            }
}

/* The largest on the ring, over meshes from .. to. */
static Measure worst_share(const Table *rows, const char *norm, int from, int to)
{
    Measure worst = measure_max_of(0);
    for (int k = 0; k < MESHES; k++)
        if (cells[k] >= from && cells[k] <= to)
            worst = measure_max(worst, share_of(rows, "ring", "ge_wls", norm, cells[k]));
    return worst;
}

static void check_ring(Check *c, const Table *rows)
{
    claim(c, "T-1b.linf", "GE-WLS, ring: largest error over FEM's, worst of N = 16 ... 64",
          worst_share(rows, "error_linf", 16, 64), 0, 0.85);
    claim(c, "T-1b.linf-fine", "GE-WLS, ring: largest error over FEM's, worst of N = 91 and 128",
          worst_share(rows, "error_linf", 91, 128), 0, 1);
    claim(c, "T-1b.rms", "GE-WLS, ring: rms error over FEM's, worst of N = 16 ... 45",
          worst_share(rows, "error_l2", 16, 45), 0, 0.75);
    claim(c, "T-1b.rms-fine", "GE-WLS, ring: rms error over FEM's, worst of N = 64 ... 128",
          worst_share(rows, "error_l2", 64, 128), 0, 0.75);
    static const char four_periods[] = "problem=ring method=%s cells=%d t_end=0.08";
    for (int n = 32; n <= 64; n *= 2)
        claim(c, phrase("T-1b.four-%d", n),
              phrase("GE-WLS, ring, four periods, N = %d: largest error over FEM's", n),
              measure_ratio(select_value(rows, "error_linf", four_periods, "ge_wls", n),
                            select_value(rows, "error_linf", four_periods, "fem", n)),
              0, 1);
}

/* Mean and spread of errors over whole rings off the grid lines. */
static Measure offsets(const Table *rows, const char *method, double *sd)
{
    double error[OFFSETS] = {0};
    Measure mean = measure_sum_of(OFFSETS);
    const int n = select_all(rows, "error_linf", OFFSETS, error, "method=%s sector=full", method);
    for (int k = 0; k < n; k++) measure_add(&mean, error[k]);
    *sd = n > 1 ? gsl_stats_sd(error, 1, (size_t)n) : NAN;
    return measure_with(mean, gsl_stats_mean(error, 1, (size_t)n));
}

/* Largest error of ge_wls at any time step but the longest, over FEM's at the shortest. */
static Measure worst_step(const Table *rows)
{
    static const char where[] = "problem=ring method=%s cells=32 cfl=%.17g";
    Measure worst = measure_max_of(0);
    for (int k = 0; k < STEPS - 1; k++)
        worst = measure_max(worst, select_value(rows, "error_linf", where, "ge_wls", cfl[k]));
    return measure_ratio(worst, select_value(rows, "error_linf", where, "fem", cfl[0]));
}

static void check_doubts(Check *c, const Table *rows)
{
    double sd, sd_fem;
    const Measure mean = offsets(rows, "ge_wls", &sd);
    claim(c, "T-1b.offsets",
          "GE-WLS, whole rings at ten offsets and angles, N = 32: mean error over FEM's",
          measure_ratio(mean, offsets(rows, "fem", &sd_fem)), 0, 0.8);
    claim_note(c, "spread", sd / mean.value);
    claim(c, "T-1b.cfl", "GE-WLS, ring, CFL .05 to .7, N = 32: largest error over FEM's at CFL .05",
          worst_step(rows), 0, 1);
    claim(c, "T-1b.lost", "GE-WLS, all scenes beside FEM: runs lost, of 39",
          select_count_lost(rows, RUNS, "method=ge_wls"), 0, 0);
    claim(c, "T-1b.vortex", "GE-WLS, vortex, G = .2, N = 32: largest error over FEM's",
          share_of(rows, "vortex", "ge_wls", "error_linf", 32), 0, 1);
    claim(c, "T-1b.axis",
          "GE-WLS, axis-aligned displacement (no free surface), N = 32: largest error over FEM's",
          share_of(rows, "axis_mms", "ge_wls", "error_linf", 32), 0, 0.3);
}

/* Energy over that at the start: the last before `t` [s], or the largest so far. */
static Measure disk_energy(const Results *r, double t, bool most)
{
    Measure out = measure_max_of(INSTANTS);
    double last = NAN;
    const Table *h = results_run(r, "disk");
    for (int k = 0; k < h->nrow && select_number(h, k, "t") <= t; k++) {
        last = select_number(h, k, "total") / select_number(h, 0, "total");
        measure_add_max(&out, last);
    }
    return most || isnan(out.value) ? out : measure_with(out, last);
}

static void check_scenes(Check *c, const Results *r)
{
    Measure rms = measure_sum_of(RIM), scatter = measure_sum_of(RIM);
    claim_differs(c, "T-1b.disk", "GE-WLS, disk: energy over E0 at t = 2.3 is .99 or more",
                  disk_energy(r, 2.3, false), 0.99, 1.001, 0.985, 0.99,
                  "E/E_0 falls to .978 in the first impact and recovers to .9899 only");
    claim(c, "T-1b.disk-late", "GE-WLS, disk: energy over E0 at t = 4", disk_energy(r, late, false),
          0.91, 1.005);
    claim(c, "T-1b.disk-most", "GE-WLS, disk: largest energy over E0 until t = 4",
          disk_energy(r, late, true), 0.99, 1.001);
    hole_measure(results_run(r, "reference"), 128, results_run(r, "plate"), 32, &rms, &scatter);
    claim(
        c, "T-1b.plate",
        "GE-WLS, plate, h = 1/32: rms difference of stress along the hole from the reference [GPa]",
        rms, 0, 2.2);
    claim(c, "T-1b.plate-scatter",
          "GE-WLS, plate, h = 1/32: scatter of stress along the hole [GPa]", scatter, 0, 1.8);
}

static void check(Check *c, const Results *r)
{
    check_ring(c, r->rows);
    check_doubts(c, r->rows);
    check_scenes(c, r);
}

const StudyPage study_t_01_ge_wls = {
    .cases = cases, .tables = tables, .check = check, .claims = 16};
