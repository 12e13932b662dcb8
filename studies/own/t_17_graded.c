/* t_17_graded.c: projection onto grids whose cells differ in size, and from particles that do (W07,
 * abstract and section 2). The program's cells are equal, so this page has its own projector in 1D:
 * tents on any grid; GIMP, their mean over a particle's length; both with the particle's gradient
 * (W07 eq 4.1); and a weighted least-squares fit, W the quadratic spline over the mean of a node's
 * two cells. Cells grow and shrink in turn by a ratio from 1 to 1.5 from one to the next, three
 * times; or the two particles of every second cell have lengths of that ratio. Nodes two cells and
 * more inside count.
 *
 * And the condition number of the moment matrix of WLS (W11 eq 9) on H-6's uneven particles. */
#include <gsl/gsl_eigen.h>
#include <math.h>
#include "studies/runs/must.h"
#include "studies/tables/curves.h"

enum { TENT, GIMP, GE_TENT, GE_GIMP, FIT, METHODS, RATIOS = 6, GRIDS = 4, MOST = 192, JITTERS = 6 };
static const char *const names[METHODS] = {"mpm", "gimp", "ge_mpm", "ge_gimp", "wls"};
static const char *const kinds[2] = {"cells", "sizes"}, *const fields[2] = {"linear", "quadratic"};
static const double ratios[RATIOS] = {1, 1.1, 1.2, 1.3, 1.4, 1.5};
static const int grids[GRIDS] = {24, 48, 96, 192};
static const double jitters[JITTERS] = {0, 0.1, 0.2, 0.3, 0.4, 0.5};

typedef struct Line1 {
    int n; /* cells */
    double x[MOST + 1];
    double at[2 * MOST], half[2 * MOST]; /* particles: middle and half length */
} Line1;

static void make_line(Line1 *g, int n, double cells, double sizes)
{
    static const int steps[] = {0, 1, 2, 3, 2, 1};
    g->n = n;
    g->x[0] = 0;
    for (int k = 0; k < n; k++) g->x[k + 1] = g->x[k] + pow(cells, steps[k % 6]);
    const double length = g->x[n];
    for (int k = 0; k <= n; k++) g->x[k] /= length;
    for (int k = 0; k < n; k++) {
        const double h = g->x[k + 1] - g->x[k], first = h / (1 + (k % 2 ? 1 : sizes));
        g->half[2 * k] = 0.5 * first;
        g->half[2 * k + 1] = 0.5 * (h - first);
        g->at[2 * k] = g->x[k] + 0.5 * first;
        g->at[2 * k + 1] = g->x[k] + 0.5 * (h + first);
    }
}

/* Integral of node i's tent from its left neighbour to x. */
static double tent_integral(const Line1 *g, int i, double x)
{
    const double a = g->x[i - 1], b = g->x[i], c = g->x[i + 1];
    const double left = fmin(fmax(x, a), b) - a, right = c - fmin(fmax(x, b), c);
    return 0.5 * left * left / (b - a) + 0.5 * (c - b) - 0.5 * right * right / (c - b);
}

static double tent(const Line1 *g, int i, double x)
{
    const double side = x < g->x[i] ? g->x[i] - g->x[i - 1] : g->x[i + 1] - g->x[i];
    return fmax(1 - fabs(x - g->x[i]) / side, 0);
}

static double weight(const Line1 *g, int method, int i, int p)
{
    const double x = g->at[p], l = g->half[p];
    if (method == FIT) {
        const double r = fabs(x - g->x[i]) / (0.5 * (g->x[i + 1] - g->x[i - 1]));
        return r < 0.5 ? 0.75 - r * r : r < 1.5 ? 0.5 * (1.5 - r) * (1.5 - r) : 0;
    }
    if (method == TENT || method == GE_TENT) return tent(g, i, x);
    return (tent_integral(g, i, x + l) - tent_integral(g, i, x - l)) / (2 * l);
}

static double velocity(int field, double x)
{
    return 1 + (field ? x * x : x);
}

/* Largest error of the nodes inside. */
static double projection_error(const Line1 *g, int method, int field)
{
    double most = 0;
    for (int i = 2; i <= g->n - 2; i++) {
        double sum[3] = {0}, load[2] = {0};
        for (int p = 0; p < 2 * g->n; p++) {
            const double m = method == FIT ? 1 : g->half[p], w = m * weight(g, method, i, p);
            if (w == 0) continue;
            const double r = g->at[p] - g->x[i], slope = field ? 2 * g->at[p] : 1;
            const bool enhanced = method == GE_TENT || method == GE_GIMP;
            const double v = velocity(field, g->at[p]) - (enhanced ? slope * r : 0);
            for (int k = 0; k < 3; k++) sum[k] += w * pow(r, k);
            for (int k = 0; k < 2; k++) load[k] += w * v * pow(r, k);
        }
        const double det = sum[0] * sum[2] - sum[1] * sum[1];
        const double value =
            method == FIT ? (load[0] * sum[2] - load[1] * sum[1]) / det : load[0] / sum[0];
        most = fmax(most, fabs(value - velocity(field, g->x[i])));
    }
    return most;
}

static void write_errors(FILE *f, int m, int kind, int n, double ratio)
{
    Line1 g;
    make_line(&g, n, kind ? 1 : ratio, kind ? ratio : 1);
    for (int field = 0; field < 2; field++)
        fprintf(f, "%s,%s,%s,%d,%.17g,%.17g\n", names[m], kinds[kind], fields[field], n, ratio,
                projection_error(&g, m, field));
}

/* Largest difference of the weights here from the program's, on equal cells. */
static double largest_difference(void)
{
    Line1 g;
    double most = 0;
    make_line(&g, 12, 1, 1.3);
    for (int m = 0; m < 2; m++)
        for (int p = 6; p < 18; p++) {
            double S, G;
            engine_1d.weight(names[m], 12 * (g.at[p] - g.x[6]), 12 * g.half[p], &S, &G);
            most = fmax(most, fabs(S - weight(&g, m, 6, p)));
        }
    return most;
}

static void cases(Cases *list, bool quick)
{
    for (int grading = 1; grading < 3; grading++)
        for (int k = 0; k < JITTERS; k += quick ? 5 : 1)
            case_add_with(list, "particles", phrase("uneven_%d_%d", grading, k),
                          "run patch --method wls2 --cells 32 --set jitter=%g --set grading=%d",
                          jitters[k], grading);
}

/* X and Y of each row, lengths in cells; the caller frees them. */
static double *points_of(const Table *t, int cells)
{
    double *x = must(malloc(sizeof *x * 2 * ((size_t)t->nrow + 1)));
    for (int row = 0; row < t->nrow; row++)
        for (int d = 0; d < 2; d++) x[2 * row + d] = cells * table_number(t, row, d ? "Y" : "X");
    return x;
}

/* Largest over least eigenvalue of the moments of node (i, j) of n points, lengths in cells. */
static double condition(int n, const double *x, int i, int j)
{
    double M[9] = {0}, e[3];
    gsl_matrix_view view = gsl_matrix_view_array(M, 3, 3);
    gsl_vector_view values = gsl_vector_view_array(e, 3);
    gsl_eigen_symm_workspace *work = gsl_eigen_symm_alloc(3);
    for (int p = 0; p < n; p++) {
        const double r[3] = {1, x[2 * p] - i, x[2 * p + 1] - j};
        double W = 1;
        for (int d = 1; d < 3; d++) {
            const double a = fabs(r[d]);
            W *= a < 0.5 ? 0.75 - a * a : a < 1.5 ? 0.5 * (1.5 - a) * (1.5 - a) : 0;
        }
        for (int k = 0; k < 9 && W > 0; k++) M[k] += W * r[k / 3] * r[k % 3];
    }
    gsl_eigen_symm(&view.matrix, &values.vector, work);
    gsl_eigen_symm_free(work);
    return fmax(fmax(e[0], e[1]), e[2]) / fmin(fmin(e[0], e[1]), e[2]);
}

static void tables(const Results *r)
{
    FILE *f = results_write(r, "errors", "method,kind,field,cells,ratio,error");
    for (int m = 0; m < 2 * METHODS; m++) {
        for (int k = 0; k < RATIOS; k++) write_errors(f, m / 2, m % 2, 48, ratios[k]);
        for (int k = 0; k < GRIDS; k++)
            if (grids[k] != 48) write_errors(f, m / 2, m % 2, grids[k], 1.5);
    }
    f = results_write(r, "program", "cells,difference");
    fprintf(f, "12,%.17g\n", largest_difference());
    f = results_write(r, "condition", "grading,jitter,condition");
    for (int grading = 1; grading < 3; grading++)
        for (int k = 0; k < JITTERS; k++) {
            const Table *t = results_run(r, "uneven_%d_%d", grading, k);
            double *x = points_of(t, 32),
                   most = 0; /* nodes inside: the body reaches from about .2 to .8 */
            for (int node = 0; node < 36 && t->nrow > 0; node++)
                most = fmax(most, condition(t->nrow, x, 11 + node % 6 * 2, 11 + node / 6 * 2));
            if (t->nrow > 0) fprintf(f, "%d,%g,%.17g\n", grading, jitters[k], most);
            free(x);
        }
}

static Measure order(const Table *t, int method, int kind, int field)
{
    return curve_order_in_h(t, "error", 24, 192, GRIDS, "method=%s kind=%s field=%s ratio=1.5",
                            names[method], kinds[kind], fields[field]);
}

static Measure linear_error(const Table *t, int method, int kind)
{
    return select_value(t, "error", "method=%s kind=%s field=linear cells=48 ratio=1.5",
                        names[method], kinds[kind]);
}

/* What MPM and GIMP lose. */
static void check_plain(Check *c, const Table *t, int m)
{
    const char *label = engine_label(names[m]);
    claim(c, phrase("T-17.cells-%s", names[m]),
          phrase("%s, 1D, 48 cells whose sizes differ by 1.5 from one to the next: largest error "
                 "of a linear field over the mean cell size",
                 label),
          measure_times(linear_error(t, m, 0), 48), 0.02, 0.4);
    claim(c, phrase("T-17.sizes-%s", names[m]),
          phrase("%s, 1D, 48 equal cells, in every second of which two particles differ by 1.5 "
                 "in length: largest error of a linear field over the cell size",
                 label),
          measure_times(linear_error(t, m, 1), 48), 0.001, 0.01);
    claim(c, phrase("T-17.order-%s", names[m]),
          phrase("%s, cells that differ by 1.5: order of the error of a linear field", label),
          order(t, m, 0, 0), 0.9, 1.1);
}

static void check(Check *c, const Results *r)
{
    const Table *t = results_part(r, "errors"), *k = results_part(r, "condition");
    Measure exact = measure_max_of(3 * 2 * (RATIOS + GRIDS - 1));
    EACH_ROW(row, t, "field=linear")
        if (!select_is(t, row, "method", "mpm") && !select_is(t, row, "method", "gimp"))
            measure_add_max(&exact, select_number(t, row, "error"));
    claim(
        c, "T-17.exact",
        "GE-MPM, GE-GIMP and the least-squares fit project a linear field exactly on graded grids "
        "and from graded particles: largest error",
        exact, 0, 1e-13);
    for (int m = TENT; m <= GIMP; m++) check_plain(c, t, m);
    claim(c, "T-17.order-ge_gimp",
          "GE-GIMP, cells that differ by 1.5: order of the error of a quadratic field",
          order(t, GE_GIMP, 0, 1), 1.9, 2.1);
    claim(
        c, "T-17.order-wls",
        "The least-squares fit, cells that differ by 1.5: order of the error of a quadratic field",
        order(t, FIT, 0, 1), 1.9, 2.1);
    claim(c, "T-17.program",
          "Tents and GIMP here and in the program on equal cells: largest difference of a weight",
          select_value(results_part(r, "program"), "difference", "cells=12"), 0, 1e-14);
    claim(
        c, "T-17.condition",
        "H-6's particles: condition number of WLS's moments, largest of 36 nodes inside, jitter .5 "
        "and grading 2 over the lattice",
        measure_ratio(select_value(k, "condition", "grading=2 jitter=0.5"),
                      select_value(k, "condition", "grading=1 jitter=0")),
        1.1, 10);
}

const StudyPage study_t_17_graded = {
    .cases = cases, .tables = tables, .check = check, .claims = 11};
