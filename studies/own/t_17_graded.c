/* t_17_graded.c: projection onto grids whose cells differ in size, and from particles that do (W07,
 * abstract and section 2). The program's cells are equal: graded.h has its own projector in 1D.
 * Cells grow and shrink in turn by a ratio from 1 to 1.5 from one to the next, three times; or the
 * two particles of every second cell have lengths of that ratio.
 *
 * And the condition number of the moment matrix of WLS (W11 eq 9) on H-6's uneven particles. */
#include <gsl/gsl_eigen.h>
#include <math.h>
#include <stdlib.h>
#include "studies/tables/curves.h"
#include "studies/tables/graded.h"
#include "studies/tables/points.h"
#include "studies/tables/spline.h"

enum { RATIOS = 6, GRIDS = 4, JITTERS = 6, CELLS = 32 };
static const char *const kinds[2] = {"cells", "sizes"}, *const fields[2] = {"linear", "quadratic"};
static const double ratios[RATIOS] = {1, 1.1, 1.2, 1.3, 1.4, 1.5};
static const int grids[GRIDS] = {24, 48, 96, 192};
static const double jitters[JITTERS] = {0, 0.1, 0.2, 0.3, 0.4, 0.5};

static void write_errors(FILE *f, GradedMethod m, int kind, int n, double ratio)
{
    Graded g;
    graded_make(&g, n, kind ? 1 : ratio, kind ? ratio : 1);
    for (int field = 0; field < 2; field++)
        results_print(f, "%s,%s,%s,%d,%.17g,%.17g\n", graded_names[m], kinds[kind], fields[field],
                      n, ratio, graded_error(&g, m, field));
}

/* Largest difference of the weights here from the program's, on equal cells. */
static double largest_difference(void)
{
    Graded g;
    double most = 0;
    graded_make(&g, 12, 1, 1.3);
    for (GradedMethod m = GRADED_TENT; m <= GRADED_GIMP; m++)
        for (int p = 6; p < 18; p++) {
            double S, G;
            engine_1d.weight(graded_names[m], 12 * (g.at[p] - g.x[6]), 12 * g.half[p], &S, &G);
            most = fmax(most, fabs(S - graded_weight(&g, m, 6, p)));
        }
    return most;
}

static void cases(Cases *list, bool quick)
{
    for (int grading = 1; grading < 3; grading++)
        for (int k = 0; k < JITTERS; k += quick ? 5 : 1)
            case_add_with(list, "particles", phrase("uneven_%d_%d", grading, k),
                          "run patch --method wls2 --cells %d --set jitter=%g --set grading=%d",
                          CELLS, jitters[k], grading);
}

/* Largest over least eigenvalue of the moments of node (i, j); n points, cells of 1/CELLS. */
static double condition(int n, const double *x, int i, int j)
{
    double M[9] = {0}, e[3];
    gsl_matrix_view view = gsl_matrix_view_array(M, 3, 3);
    gsl_vector_view values = gsl_vector_view_array(e, 3);
    gsl_eigen_symm_workspace *work = gsl_eigen_symm_alloc(3);
    for (int p = 0; p < n; p++) {
        const double r[3] = {1, (double)CELLS * x[2 * p] - i, (double)CELLS * x[2 * p + 1] - j};
        const double W = spline_quadratic(r[1]) * spline_quadratic(r[2]);
        for (int k = 0; k < 9 && W > 0; k++) M[k] += W * r[k / 3] * r[k % 3];
    }
    gsl_eigen_symm(&view.matrix, &values.vector, work);
    gsl_eigen_symm_free(work);
    return fmax(fmax(e[0], e[1]), e[2]) / fmin(fmin(e[0], e[1]), e[2]);
}

/* The largest of 36 nodes inside: the body reaches from about .2 to .8. */
static void write_condition(FILE *f, const Results *r, int grading, int jitter)
{
    const Table *t = results_run(r, "uneven_%d_%d", grading, jitter);
    double *x = points_all(t, "X Y"), most = 0;
    for (int node = 0; node < 36 && t->nrow > 0; node++)
        most = fmax(most, condition(t->nrow, x, 11 + node % 6 * 2, 11 + node / 6 * 2));
    if (t->nrow > 0) results_print(f, "%d,%g,%.17g\n", grading, jitters[jitter], most);
    free(x);
}

static void tables(const Results *r)
{
    FILE *f = results_write(r, "errors", "method,kind,field,cells,ratio,error");
    for (GradedMethod m = 0; m < GRADED_METHODS; m++)
        for (int kind = 0; kind < 2; kind++) {
            for (int k = 0; k < RATIOS; k++) write_errors(f, m, kind, 48, ratios[k]);
            for (int k = 0; k < GRIDS; k++)
                if (grids[k] != 48) write_errors(f, m, kind, grids[k], 1.5);
        }
    f = results_write(r, "program", "cells,difference");
    results_print(f, "12,%.17g\n", largest_difference());
    f = results_write(r, "condition", "grading,jitter,condition");
    for (int grading = 1; grading < 3; grading++)
        for (int k = 0; k < JITTERS; k++) write_condition(f, r, grading, k);
}

static Measure order(const Table *t, GradedMethod method, int kind, int field)
{
    return curve_order_in_h(t, "error", 24, 192, GRIDS, "method=%s kind=%s field=%s ratio=1.5",
                            graded_names[method], kinds[kind], fields[field]);
}

static Measure linear_error(const Table *t, GradedMethod method, int kind)
{
    return select_value(t, "error", "method=%s kind=%s field=linear cells=48 ratio=1.5",
                        graded_names[method], kinds[kind]);
}

/* What MPM and GIMP lose. */
static void check_plain(Check *c, const Table *t, GradedMethod m)
{
    const char *label = engine_label(graded_names[m]);
    claim(c, phrase("T-17.cells-%s", graded_names[m]),
          phrase("%s, 1D, 48 cells whose sizes differ by 1.5 from one to the next: largest error "
                 "of a linear field over the mean cell size",
                 label),
          measure_times(linear_error(t, m, 0), 48), 0.02, 0.4);
    claim(c, phrase("T-17.sizes-%s", graded_names[m]),
          phrase("%s, 1D, 48 equal cells, in every second of which two particles differ by 1.5 "
                 "in length: largest error of a linear field over the cell size",
                 label),
          measure_times(linear_error(t, m, 1), 48), 0.001, 0.01);
    claim(c, phrase("T-17.order-%s", graded_names[m]),
          phrase("%s, cells that differ by 1.5: order of the error of a linear field", label),
          order(t, m, 0, 0), 0.9, 1.1);
}

static void check(Check *c, const Results *r)
{
    const Table *t = results_part(r, "errors"), *k = results_part(r, "condition");
    claim(
        c, "T-17.exact",
        "GE-MPM, GE-GIMP and the least-squares fit project a linear field exactly on graded grids "
        "and from graded particles: largest error",
        curve_worst(t, "ge_mpm ge_gimp wls", 2 * (RATIOS + GRIDS - 1), "error", "field=linear"), 0,
        1e-13);
    for (GradedMethod m = GRADED_TENT; m <= GRADED_GIMP; m++) check_plain(c, t, m);
    for (GradedMethod m = GRADED_GE_GIMP; m <= GRADED_FIT; m++)
        claim(c, phrase("T-17.order-%s", graded_names[m]),
              phrase("%s, cells that differ by 1.5: order of the error of a quadratic field",
                     m == GRADED_FIT ? "The least-squares fit" : engine_label(graded_names[m])),
              order(t, m, 0, 1), 1.9, 2.1);
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
