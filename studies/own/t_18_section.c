/* t_18_section.c: radial and hoop stress of the oscillating shell at 0, 5 and 10 ms in the section
 * |Z| < h/2: the picture of W11 fig. 5 in three dimensions, beside the exact stress.
 *
 * nu = 0, mu = E/2: F is 1 + s g' along the radius and 1 + s g/R across it (problems/radial.h), so
 * that the Cauchy stress is mu (F^2 - 1)/J in each direction. At 5 ms s = 0 and there is none. */
#include <math.h>
#include "studies/tables/curves.h"
#include "studies/tables/points.h"

enum { CELLS = 16, QUICK = 8, TIMES = 3, METHODS = 5 };
enum { POINTS = 100 /* in the section, at least */ };

/* At t = 0 the run takes one step of 1 ns, so that the state is the initial one. */
static const struct {
    const char *name, *t_end;
} instants[TIMES] = {{"0ms", "1e-9"}, {"5ms", "0.005"}, {"10ms", "0.01"}};
static const char *const methods[METHODS] = {"gimp", "wls", "wls2", "ge_wls", "fem"};

static void cases(Cases *list, bool quick)
{
    for (int m = 0; m < METHODS; m++)
        for (int k = 0; k < TIMES; k++)
            case_add_with(list, "samples", phrase("%s.%s", methods[m], instants[k].name),
                          "run shell --method %s --cells %d --t-end %s%s", methods[m],
                          quick ? QUICK : CELLS, instants[k].t_end,
                          m == METHODS - 1 ? " --cfl .6" : " --set layout=radial");
}

/* Exact radial and hoop stress [Pa] at distance R from the centre, at instant k. */
static void exact_stress(double R, int k, double stress[2])
{
    const double A = 0.1, E = 1e4, s = k == 1 ? 0 : k == 0 ? A : -A;
    const double along = 1 + s * (6 - 18 * R + 12 * R * R);
    const double across = 1 + s * (6 - 9 * R + 4 * R * R), J = along * across * across;
    stress[0] = E / 2 * (along * along - 1) / J;
    stress[1] = E / 2 * (across * across - 1) / J;
}

/* The points of one run in the section into `points`, into `sums` the largest stress, the rms
 * difference from the exact one, both components together, and the exact one's largest value. */
static void write_run(FILE *points, FILE *sums, const Results *r, const char *method, int k)
{
    const char *part = phrase("%s.%s", method, instants[k].name);
    const Table *t = results_run(r, "%s", part);
    const double h = 1.0 / (r->quick ? QUICK : CELLS);
    double most = 0, known = 0, square = 0;
    int n = 0;
    for (int row = 0; row < t->nrow; row++) {
        const double Z = select_number(t, row, "Z");
        if (fabs(Z) >= h / 2 || select_number(t, row, "surface") > 0) continue;
        double X[3], x[3], exact[2];
        points_row(t, row, "X Y Z", X);
        points_row(t, row, "x y z", x);
        exact_stress(sqrt(X[0] * X[0] + X[1] * X[1] + X[2] * X[2]), k, exact);
        const double found[2] = {
            points_stress_along(t, row, x),
            points_stress_along(t, row, (const double[3]){-x[1], x[0], 0}),
        };
        for (int c = 0; c < 2; c++) {
            most = measure_worse(most, fabs(found[c]));
            known = measure_worse(known, fabs(exact[c]));
            square += pow(found[c] - exact[c], 2);
        }
        n++;
        results_print(points, "%s,%s,%.8g,%.8g,%.8g,%.8g\n", method, instants[k].name, x[0], x[1],
                      found[0], found[1]);
    }
    if (n > 0)
        results_print(sums, "%s,%s,%d,%.10g,%.10g,%.10g,%s\n", method, instants[k].name, n, most,
                      sqrt(square / (2 * n)), known, results_status(r, part));
}

static void tables(const Results *r)
{
    FILE *points = results_write(r, "points", "method,instant,x,y,radial,hoop");
    FILE *sums = results_write(r, "sums", "method,instant,points,most,rms,exact,status");
    for (int m = 0; m < METHODS; m++)
        for (int k = 0; k < TIMES; k++) write_run(points, sums, r, methods[m], k);
}

static Measure value(const Table *t, const char *column, const char *method, int k)
{
    return select_value(t, column, "method=%s instant=%s", method, instants[k].name);
}

/* Rms difference from the exact stress over its largest value, at instant k. */
static Measure off(const Table *t, const char *method, int k)
{
    return measure_ratio(value(t, "rms", method, k), value(t, "exact", method, k));
}

static void check(Check *c, const Results *r)
{
    static const struct {
        const char *method, *label;
        double low, high;
    } known[METHODS] = {{"gimp", "GIMP, particles on spheres", 0.008, 0.012},
                        {"wls", "WLS", 0.009, 0.013},
                        {"wls2", "WLS2", 0.0066, 0.01},
                        {"ge_wls", "GE-WLS", 0.005, 0.0076},
                        {"fem", "FEM, single tetrahedra", 0.02, 0.029}};
    const Table *t = results_part(r, "sums");
    Measure start = measure_max_of(0), rest = measure_max_of(0), fewest = measure_min_of(0);
    for (int m = 0; m < METHODS; m++) {
        if (m < METHODS - 1) start = measure_max(start, off(t, methods[m], 0));
        rest = measure_max(
            rest, measure_ratio(value(t, "most", methods[m], 1), value(t, "most", methods[m], 0)));
        for (int k = 0; k < TIMES; k++)
            fewest = measure_min(fewest, value(t, "points", methods[m], k));
    }
    claim(c, "T-18.start",
          "Shell at 0 ms, every particle method: rms difference from the exact stress over its "
          "largest value",
          start, 0, 1e-6);
    claim(c, "T-18.rest",
          "Shell: at 5 ms it passes through its stress-free shape: largest stress there over that "
          "at 0 ms, worst method",
          rest, 0, 0.06);
    claim(c, "T-18.points", "Shell, section |Z| < h/2: points of the run with the fewest", fewest,
          POINTS, 1e5);
    for (int m = 0; m < METHODS; m++)
        claim(c, phrase("T-18.%s", known[m].method),
              phrase("Shell at 10 ms, %s, N = 16: rms difference from the exact stress over its "
                     "largest value",
                     known[m].label),
              off(t, known[m].method, 2), known[m].low, known[m].high);
}

const StudyPage study_t_18_section = {
    .cases = cases, .tables = tables, .check = check, .claims = 3 + METHODS};
