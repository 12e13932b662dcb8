/* t_01_ge_wls.c: gradient-enhanced WLS with one part removed at a time, on ring, axis_mms, vortex,
 * plate and disk; then whole rings off the grid lines, long times, denser particles and many time
 * steps, beside FEM at equal mesh size. Most parts were chosen on one ring; the other scenes show
 * what of that is luck. Errors as in the rows; CFL .3 on the ring. */
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include "studies/tables/curves.h"
#include "studies/tables/hole.h"

/* The parts, and what stands in place of each without it. */
enum { AVERAGE, DISTANCE, HERMITE, MASS, MOTION, RETURN, VELOCITY, PARTS };
static const struct {
    const char *setting, *with, *without;
} parts[PARTS] = {
    [AVERAGE] = {"average", "folded", "weighted"},  [DISTANCE] = {"distance", "curved", "normals"},
    [HERMITE] = {"hermite", "1000", "0"},           [MASS] = {"mass", "corrected", "lumped"},
    [MOTION] = {"motion", "consistent", "lagged"},  [RETURN] = {"return", "spline", "linear"},
    [VELOCITY] = {"velocity", "corrected", "plain"}};

enum { RUNS = 130, INSTANTS = 300, RIM = 30 }; /* of ge_wls; of a history; along the hole */
enum { MESHES = 9, COARSE = 7, OFFSETS = 10, STEPS = 7, TIMES = 2 };
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

static void add_parts(Cases *list, bool quick)
{
    char name[64], set[64];
    for (int part = -1; part < PARTS; part++) {
        if (part < 0)
            *set = 0;
        else
            snprintf(set, sizeof set, " --set %s=%s", parts[part].setting, parts[part].without);
        for (int k = 0; k < (quick ? 2 : COARSE); k++)
            if (part >= 0) case_add(list, "run ring --method ge_wls --cells %d%s", cells[k], set);
        for (int n = 16; part >= 0 && n <= (quick ? 16 : 32); n *= 2) {
            case_add(list, "run axis_mms --method ge_wls --cells %d%s", n, set);
            case_add(list, "run vortex --method ge_wls --cells %d --set G=0.2 --cfl 0.1%s", n, set);
        }
        snprintf(name, sizeof name, "plate.%d", part);
        case_add_with(list, "samples", name, "run hole_plate --method ge_wls --cells %d%s",
                      quick ? 8 : 32, set);
        snprintf(name, sizeof name, "disk.%d", part);
        case_add_with(list, "history", name,
                      "run disk_impact --method ge_wls --cells %d --t-end "
                      "%g%s",
                      quick ? 12 : 48, late, set);
    }
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
                  quick ? 32 : 256);
    for (int m = 0; m < RIVALS; m++) add_rivals(list, rivals[m], quick); /* first: see value_of */
    add_parts(list, quick);
    for (int ppc = 9; ppc <= (quick ? 9 : 16); ppc += 7)
        case_add(list, "run ring --method ge_wls --cells %d --ppc %d", quick ? 8 : 32, ppc);
}

/* A number of the first such row: that of the method as it is, unless a setting is named. */
static Measure value_of(const Table *rows, const char *problem, const char *method, int n,
                        const char *setting, const char *want)
{
    return select_value(rows, want, "problem=%s method=%s cells=%d %s", problem, method, n,
                        setting);
}

static const char *setting_without(int part, char text[64])
{
    text[0] = '\0';
    if (part >= 0) snprintf(text, 64, "%s=%s", parts[part].setting, parts[part].without);
    return text;
}

/* Errors over FEM's on the same mesh: of the whole, of the whole less a part, of WLS2. */
static void tables(const Results *r)
{
    static const char *const problem[] = {"ring", "axis_mms", "vortex"};
    char text[64];
    FILE *f = results_write(r, "shares", "problem,what,cells,share");
    for (int what = -1; what <= PARTS; what++)
        for (int p = 0; p < 3; p++)
            for (int k = 0; k < MESHES; k++) {
                const bool other = what == PARTS;
                const char *method = other ? "wls2" : "ge_wls";
                const char *set = setting_without(other ? -1 : what, text);
                const double share =
                    measure_ratio(
                        value_of(r->rows, problem[p], method, cells[k], set, "error_linf"),
                        value_of(r->rows, problem[p], "fem", cells[k], "", "error_linf"))
                        .value;
                const char *label = other || what < 0 ? method : parts[what].setting;
                if (!isnan(share))
                    fprintf(f, "%s,%s,%d,%.17g\n", problem[p], label, cells[k], share);
            }
}

/* Of ge_wls over FEM on one mesh. */
static Measure share_of(const Table *rows, const char *problem, const char *norm, int n)
{
    return measure_ratio(value_of(rows, problem, "ge_wls", n, "", norm),
                         value_of(rows, problem, "fem", n, "", norm));
}

/* The largest on the ring, over meshes from .. to. */
static Measure worst_share(const Table *rows, const char *norm, int from, int to)
{
    Measure worst = measure_max_of(0);
    for (int k = 0; k < MESHES; k++)
        if (cells[k] >= from && cells[k] <= to)
            worst = measure_max(worst, share_of(rows, "ring", norm, cells[k]));
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
    for (int n = 32; n <= 64; n *= 2) {
        char id[32], text[96];
        snprintf(id, sizeof id, "T-1b.four-%d", n);
        snprintf(text, sizeof text, "four periods, N = %d: largest error over FEM's", n);
        claim(c, id, text,
              measure_ratio(select_value(rows, "error_linf", four_periods, "ge_wls", n),
                            select_value(rows, "error_linf", four_periods, "fem", n)),
              0, 1);
    }
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
    claim(c, "T-1b.lost", "GE-WLS: runs lost of all here, parts removed included",
          select_count_lost(rows, RUNS, "method=ge_wls"), 0, 0);
    claim(c, "T-1b.vortex", "GE-WLS, vortex, G = .2, N = 32: largest error over FEM's",
          share_of(rows, "vortex", "error_linf", 32), 0, 1);
    claim(c, "T-1b.axis",
          "GE-WLS, axis-aligned displacement (no free surface), N = 32: largest error over FEM's",
          share_of(rows, "axis_mms", "error_linf", 32), 0, 0.3);
}

/* Each part must earn its place somewhere: the largest of its gains. */
static void check_parts(Check *c, const Table *rows)
{
    for (int part = 0; part < PARTS; part++) {
        char id[64], text[128], setting[64];
        Measure gain = measure_sum_of(0);
        setting_without(part, setting);
        for (int k = 0; k < COARSE; k++) {
            if (cells[k] < 16) continue;
            const Measure ratio =
                measure_ratio(value_of(rows, "ring", "ge_wls", cells[k], setting, "error_l2"),
                              value_of(rows, "ring", "ge_wls", cells[k], "", "error_l2"));
            gain = measure_sum(gain, measure_with(ratio, log(ratio.value) / 5));
        }
        snprintf(id, sizeof id, "T-1b.part-%s", parts[part].setting);
        snprintf(text, sizeof text,
                 "without %s=%s: rms error on the ring grows, mean factor over N = 16 ... 64",
                 parts[part].setting, parts[part].with);
        claim_differs(c, id, text, measure_with(gain, exp(gain.value)), 1, 10, 0.5, 1,
                      "what it buys lies elsewhere: see the figure's other scenes");
    }
}

/* Energy over that at the start: the last before `t` [s], or the largest so far. */
static Measure disk_energy(const Results *r, double t, bool most)
{
    Measure out = measure_max_of(INSTANTS);
    double last = NAN;
    Table *h = results_file(r, "disk.-1");
    for (int k = 0; h && k < h->nrow && select_number(h, k, "t") <= t; k++) {
        last = select_number(h, k, "total") / select_number(h, 0, "total");
        measure_add_max(&out, last);
    }
    table_free(h);
    return most || isnan(out.value) ? out : measure_with(out, last);
}

static void check_scenes(Check *c, const Results *r)
{
    Measure rms = measure_sum_of(RIM), scatter = measure_sum_of(RIM);
    claim(c, "T-1b.disk", "GE-WLS, disk: energy over E0 at t = 2.3", disk_energy(r, 2.3, false),
          0.98, 1.005);
    claim(c, "T-1b.disk-late", "GE-WLS, disk: energy over E0 at t = 4", disk_energy(r, late, false),
          0.91, 1.005);
    claim(c, "T-1b.disk-most", "GE-WLS, disk: largest energy over E0 until t = 4",
          disk_energy(r, late, true), 0.99, 1.005);
    Table *reference = results_file(r, "reference"), *plate = results_file(r, "plate.-1");
    hole_measure(reference, 256, plate, 32, &rms, &scatter);
    table_free(reference);
    table_free(plate);
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
    check_parts(c, r->rows);
    check_scenes(c, r);
}

const Study study_t_01_ge_wls = {
    .name = "t_01_ge_wls",
    .figure = "T-1b",
    .about = "GE-WLS: what each part buys, and where it does and does not beat FEM",
    .cases = cases,
    .tables = tables,
    .check = check,
    .claims = 23,
};
