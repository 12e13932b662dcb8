/* w07_12_bar_ppc.c: error of the suddenly stopped bar against particles per cell, and runs that are
 * lost. Wallstedt and Guilkey (2007), fig. 12 (eq. 5.2).
 *
 * 40 cells, N = 41, 50, ... 392 particles for one period (and 1/4, 1/2, 2); the error is a running
 * maximum, so it grows with duration. The census counts the runs of N = 41, 49, ... 393 that end
 * before five periods. Orders in h: at three PPC that are not whole. */
#include <math.h>
#include "forty_percent.h"
#include "studies/runs/run_row.h"
#include "studies/tables/curves.h"

enum { MPM, GIMP, GE_MPM, GE_GIMP, METHODS, ORDERS = 3, MESHES = 5 };
enum { FEWEST = 41, MOST = 392, APART = 9, RUNS = 40 /* of each duration */, CENSUS = 45 };
static const char *const methods[METHODS] = {"mpm", "gimp", "ge_mpm", "ge_gimp"};
static const double period = 0.04 /* [s] 4 L/c */, durations[] = {0.25, 0.5, 1, 2};
static const int meshes[MESHES] = {20, 28, 40, 57, 80};
static const int counts[ORDERS] = {95, 149, 212}; /* particles in 40 cells: rows of the sweep */
static const char run[] = "run bar --method %s --cells %d --t-end %.17g --set particles=%d";
static const char asked[] = "method=%s cells=40 t_end=%.17g"; /* rows that were to last so long */

static int particles(int order, int mesh)
{
    return (int)lround((double)counts[order] * meshes[mesh] / 40);
}

static void cases(Cases *list, bool quick)
{
    for (int d = 0; d < 4; d++)
        for (int m = 0; m < METHODS; m++)
            for (int n = FEWEST; n <= MOST; n += quick ? 90 : APART)
                case_add(list, run, methods[m], 40, durations[d] * period, n);
    for (int m = 0; m < METHODS; m++)
        for (int n = FEWEST; n <= 393; n += quick ? 176 : 8)
            case_add(list, run, methods[m], 40, 5 * period, n);
    for (int m = GIMP; !quick && m < METHODS; m += GE_GIMP - GIMP)
        for (int k = 0; k < ORDERS; k++)
            for (int i = 0; i < MESHES; i++)
                if (meshes[i] != 40)
                    case_add(list, run, methods[m], meshes[i], period, particles(k, i));
}

/* Of the runs that were to last for so many periods: how many ended before `until` periods, or,
 * with a limit on the error, ended or got worse than that. */
static Measure lost_by(const Table *t, int method, double periods, double until, double limit)
{
    Measure lost = measure_sum_of(fabs(periods - 5) < 0.1 ? CENSUS : RUNS);
    EACH_ROW(row, t, asked, methods[method], periods * period) {
        const double end = select_number(t, row, "steps") * select_number(t, row, "dt") / period;
        const bool early = select_is_lost(t, row) && (until >= periods || !(end >= until));
        const double error = isinf(limit) || early ? 0 : select_number(t, row, "error_linf");
        measure_add(&lost, isnan(error) ? NAN : early || error > limit);
    }
    return lost;
}

/* Share of the census lost by each time, for the figure. */
static void tables(const Results *r)
{
    FILE *f = results_write(r, "census", "method,periods,lost,runs");
    for (int m = 0; m < METHODS; m++)
        for (int k = 0; k <= 100; k++) {
            const Measure lost = lost_by(r->rows, m, 5, 0.05 * k, INFINITY);
            results_print(f, "%s,%.17g,%g,%d\n", methods[m], 0.05 * k, lost.value, lost.rows);
        }
}

/* Does this number of particles per cell lie between low and high, and is it not a whole one? */
static bool is_awkward(double ppc, double low, double high)
{
    return ppc > low && ppc < high && fabs(ppc - round(ppc)) > 1e-9;
}

/* Median error at awkward PPC; a lost run of MPM counts as an infinite error, others lose none. */
static Measure typical(const Table *t, int method, double periods, double low, double high)
{
    double errors[RUNS];
    Measure out = measure_sum_of(0);
    int n = 0;
    for (int count = FEWEST; count <= MOST; count += APART)
        out.needs += is_awkward(count / 40.0, low, high);
    EACH_ROW(row, t, asked, methods[method], periods * period) {
        if (n == RUNS || !is_awkward(select_number(t, row, "ppc"), low, high)) continue;
        errors[n] = select_kept(t, row, "error_linf");
        if (method == MPM && select_is_lost(t, row)) errors[n] = INFINITY;
        out.rows += !isnan(errors[n++]);
    }
    return measure_with(out, out.rows == n ? measure_median(n, errors) : NAN);
}

/* Exponent of h in an error after one period: mean of the awkward numbers of particles. */
static Measure order(const Table *t, const char *method, const char *error)
{
    Measure mean = measure_sum_of(0);
    for (int k = 0; k < ORDERS; k++) {
        Curve c = {0};
        for (int i = 0; i < MESHES; i++)
            curve_add(&c, 1.0 / meshes[i],
                      run_row_value(t, error, run, method, meshes[i], period, particles(k, i)));
        const Measure one = curve_order(&c, 0, 1, MESHES);
        mean = measure_sum(mean, measure_with(one, one.value / (double)ORDERS));
    }
    return mean;
}

/* Of MPM's census: how many ended with this status (energy_growth is no loss). */
static Measure ended_as(const Table *t, const char *status)
{
    Measure n = measure_sum_of(CENSUS);
    EACH_ROW(row, t, asked, "mpm", 5 * period) measure_add(&n, select_is(t, row, "status", status));
    return n;
}

/* Largest over median error after one period, awkward numbers of particles from 1 per cell. */
static Measure unevenness(const Table *t, int method)
{
    Measure worst = measure_max_of(0);
    EACH_ROW(row, t, asked, methods[method], period)
        if (is_awkward(select_number(t, row, "ppc"), 1, 10))
            measure_add_max(&worst, select_number(t, row, "error_linf"));
    return measure_ratio(worst, typical(t, method, 1, 1, 10));
}

static void check_losses(Check *c, const Table *t)
{
    claim(c, "W07-12.mpm-lost-2", "Stopped bar: a few MPM runs crash: lost by two periods, of 45",
          lost_by(t, MPM, 5, 2, INFINITY), 1, 6);
    claim(c, "W07-12.mpm-lost-5", "Stopped bar: MPM runs lost by five periods, of 45",
          lost_by(t, MPM, 5, 5, INFINITY), 14, 28);
    claim(c, "W07-12.mpm-grown-5",
          "Stopped bar: MPM runs whose energy has grown by five periods, of 45",
          ended_as(t, "energy_growth"), 14, 30);
    claim(c, "W07-12.mpm-ok-5",
          "Stopped bar: MPM runs neither lost nor grown by five periods, of 45", ended_as(t, "ok"),
          0, 4);
    claim(c, "W07-12.gimp-lost", "Stopped bar: no GIMP run is lost in five periods",
          lost_by(t, GIMP, 5, 5, INFINITY), 0, 0);
    claim(c, "W07-12.ge-gimp-lost", "Stopped bar: no GE-GIMP run is lost in five periods",
          lost_by(t, GE_GIMP, 5, 5, INFINITY), 0, 0);
    claim(c, "W07-12.ge-mpm-unstable",
          "Stopped bar: GE-MPM is pathologically unstable: share of runs lost, or with an error "
          "above .2 v0 L/c, by two periods",
          measure_times(lost_by(t, GE_MPM, 2, 2, 0.2), 1 / (double)RUNS), 0.8, 1);
}

static void check_forty_percent(Check *c, const Table *t)
{
    Measure ratios[4];
    for (int d = 0; d < 4; d++)
        ratios[d] = measure_ratio(typical(t, GE_GIMP, durations[d], 2, 10),
                                  typical(t, GIMP, durations[d], 2, 10));
    claim(c, "W07-12.ratio",
          "Stopped bar: GE-GIMP's median error over GIMP's, one period, PPC 2 to 10 without whole "
          "numbers",
          ratios[2], 0.69, 0.77);
    claim(c, "W07-12.ratio-least",
          "Stopped bar: GE-GIMP's median error over GIMP's, PPC 2 to 10 without whole numbers, "
          "least of 1/4, 1/2, 1, 2 periods",
          measure_least(4, ratios), 0.66, 0.74);
    claim_differs(c, "W07-12.forty-percent",
                  "Gradient enhancement lowers GIMP's error by about forty percent, stopped bar: "
                  "ratio of the medians after one period, PPC 2 to 10 without whole numbers",
                  ratios[2], FORTY_PERCENT_LOW, FORTY_PERCENT_HIGH, 0.70, 0.77,
                  "it saves 27 percent of the largest error after one period, 19 to 30 after 1/4 "
                  "to 2; 47 percent of a smooth solution's (W07-13)");
}

static void check(Check *c, const Results *r)
{
    const Table *t = r->rows;
    claim_note(c, "mpm_median", typical(t, MPM, 1, 2, 10).value);
    claim(c, "W07-12.gimp-median",
          "Stopped bar: GIMP's median error after one period, PPC 2 to 10 without whole numbers",
          typical(t, GIMP, 1, 2, 10), 0.0453, 0.0513);
    claim(c, "W07-12.ge-gimp-median",
          "Stopped bar: GE-GIMP's median error after one period, PPC 2 to 10 without whole numbers",
          typical(t, GE_GIMP, 1, 2, 10), 0.0325, 0.0385);
    claim(c, "W07-12.low-ppc",
          "Stopped bar: GIMP is far better at few particles per cell: MPM's median error over "
          "GIMP's, PPC 1 to 3 without whole numbers, a lost run counts as an infinite error",
          measure_ratio(typical(t, MPM, 1, 1, 3), typical(t, GIMP, 1, 1, 3)), 2, 100);
    claim(c, "W07-12.consistent",
          "Stopped bar: GIMP's error depends little on the number of particles, PPC 1 to 10 "
          "without whole numbers: its largest over its median, over the same of MPM",
          measure_ratio(unevenness(t, GIMP), unevenness(t, MPM)), 0, 0.7);
    check_forty_percent(c, t);
    check_losses(c, t);
    claim(c, "W07-12.order-rms",
          "Stopped bar: first order in h: GIMP's rms error after one period, h = 1/20 to 1/80, "
          "mean of three PPC",
          order(t, "gimp", "error_l2"), 0.9, 1.1);
    claim_differs(c, "W07-12.order-max",
                  "Stopped bar: first order in h: GIMP's largest error (eq. 5.2) after one period, "
                  "h = 1/20 to 1/80, mean of three PPC",
                  order(t, "gimp", "error_linf"), 0.9, 1.1, 0.55, 0.75,
                  "order .62: dispersion of a second-order scheme rounds a kink over a width that "
                  "goes as h^(2/3) t^(1/3), and the largest error with it");
}

const StudyPage study_w07_12_bar_ppc = {
    .cases = cases, .tables = tables, .check = check, .claims = 16};
