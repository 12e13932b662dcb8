/* h_05_small_mass.c: a node that a body hardly touches: how small does it make the time step?
 *
 * A free bar (2D: square), two particles per cell and axis, in slow uniform motion with a weak
 * oscillation (strains of 3e-8); its ends reach eps into otherwise empty cells. What
 * reaches so far is the last particle itself (tents), the edge of its box (GIMP; WLS's free
 * surface), or the support of a spline, half a cell further: the body is placed in each of these
 * three ways, for every method. The critical step is found by bisection of the CFL number to 1 %
 * (limited by the whole number of steps): over a time of 40 h/c energy grows by less than 5 %. Some
 * methods fail again below a smaller step, because energy then grows slowly with time rather than
 * per step; the largest such step is recorded as grows_below. The uniform motion holds most of the
 * energy, so that the start, when waves leave a velocity field that no grid resolves, cannot count
 * as growth.
 *
 * Tents. The far node has m = rho (h/n) eps/h and stiffness E/(n h), so that M^-1 K has omega =
 * c/sqrt(eps h) and a grid that kept its velocities would take 2/omega = 2 sqrt(eps h)/c. But the
 * node's velocity is projected anew at each step from particles that hardly feel its force: the
 * strain of the last cell obeys e <- (1 - (omega dt)^2) e, which is stable to sqrt(2)/omega only.
 * NAME.omega.csv has 2/omega_max of M^-1 K (GSL) with the same weights and positions, beside the
 * step that was found. */
#include <gsl/gsl_blas.h>
#include <gsl/gsl_eigen.h>
#include <math.h>
#include <stdlib.h>
#include "studies/tables/ladder.h"
#include "studies/runs/must.h"

enum { PER_CELL = 2, RUNGS = 8, DEPTHS = 6, EDGES = 3, DIMS = 2 };
static const double rungs[RUNGS] = {0.0095, 0.025, 0.05, 0.1, 0.2, 0.4, 0.8, 1.6};
static const double depths[DEPTHS] = {0.1, 0.03, 0.01, 0.003, 0.001, 1e-4}; /* eps/h */

/* What lies eps beyond a node, by its distance from the last particle in cells. */
static const struct {
    const char *name;
    double beyond;
} edges[EDGES] = {{"particle", 0}, {"box", 0.5 / (double)PER_CELL}, {"spline", 0.5}};

/* The block by dimension; speeds of its P waves, which limit the step, and in its dt0 [m/s]. */
static const struct {
    const Engine *engine;
    int cells, ppc;
    unsigned depths; /* bit k: depths[k] */
    double fastest, c;
} scenes[DIMS] = {{&engine_1d, 10, PER_CELL, 63, 100, 100},
                  {&engine_2d, 4, PER_CELL *PER_CELL, 4 | 32, BLOCK_P_SPEED, BLOCK_SPEED}};

/* Where the last particle is [cells beyond a node]. */
static double place(int edge, int depth)
{
    return depths[depth] - edges[edge].beyond;
}

/* How far the block, whose end is on a node at first, is moved for that [cells]. */
static double offset(int edge, int depth)
{
    return place(edge, depth) + 0.5 / (double)PER_CELL;
}

static void add_ladder(Cases *list, int dim, const char *method, int e, int d)
{
    const char *second = dim > 0 ? phrase(" --set offset_y=%.10g", offset(e, d)) : "";
    for (int k = 0; k < RUNGS; k++)
        case_add(list,
                 "run block --method %s --integrator cd --cells %d --ppc %d --cfl %g --t-end %g "
                 "--set dim=%d --set offset_x=%.10g%s --set stop_growth=1 --set stretch=1.00000003 "
                 "--set drift_x=1.6e-7",
                 method, scenes[dim].cells, scenes[dim].ppc, rungs[k],
                 40 / (scenes[dim].cells * scenes[dim].c), dim + 1, offset(e, d), second);
}

static void cases(Cases *list, bool quick)
{
    for (int dim = 0; dim < (quick ? 1 : DIMS); dim++)
        EACH_METHOD(m, scenes[dim].engine)
            for (int e = 0; e < EDGES; e++)
                for (int d = 0; d < DEPTHS; d++)
                    if (scenes[dim].depths >> d & 1 && !(quick && d != 2))
                        add_ladder(list, dim, m->name, e, d);
}

/* The window of stable runs about the largest one: *low, *high are its ends among the rungs. False
 * if no run is stable. */
static bool window(const Ladder *l, int *low, int *high)
{
    *high = l->n - 1;
    while (*high >= 0 && l->grade[*high] != MARK_OK) *high -= 1;
    *low = *high;
    while (*low > 0 && l->grade[*low - 1] == MARK_OK) *low -= 1;
    return *high >= 0;
}

static void refine(Cases *list, const Table *rows, bool quick)
{
    Ladder *ladders;
    const int n = ladder_read_all(rows, &ladders);
    const double relative = quick ? 0.2 : 0.01;
    for (const Ladder *l = ladders; l < ladders + n; l++) {
        int low, high;
        if (!window(l, &low, &high)) continue;
        if (high < l->n - 1) ladder_split(list, rows, l, high, relative, 0);
        if (low > 0) ladder_split(list, rows, l, low - 1, 10 * relative, 0);
    }
    free(ladders);
}

static void write_point(FILE *f, const Table *rows, const Ladder *l)
{
    const double moved = select_number(rows, l->row[0], "offset_x");
    const int dim = select_number(rows, l->row[0], "dim") > 1;
    int low, high, e = 0, d = 0;
    for (int k = 0; k < EDGES * DEPTHS; k++)
        if (fabs(offset(k / DEPTHS, k % DEPTHS) - moved) < 1e-9) e = k / DEPTHS, d = k % DEPTHS;
    const bool some = window(l, &low, &high);
    const double scale = scenes[dim].fastest * scenes[dim].cells;
    fprintf(f, "%d,%s,%s,%d,%g,%.6g,%.6g\n", dim + 1, select_text(rows, l->row[0], "method"),
            edges[e].name, e, depths[d], some ? scale * select_number(rows, l->row[high], "dt") : 0,
            some && low > 0 ? scale * select_number(rows, l->row[low - 1], "dt") : 0);
}

enum { CELLS = 10, NODES = CELLS + 8, COUNT = CELLS * PER_CELL };

/* Lumped masses and stiffness, in units of rho h and E/h, of particles as in the runs. */
static void assemble(const char *method, double x, double m[NODES], gsl_matrix *K)
{
    gsl_vector *G = gsl_vector_calloc(NODES);
    for (int p = 0; p < COUNT; p++) {
        for (size_t i = 0; i < NODES; i++) {
            const double end = CELLS + 4 + x; /* of the last particle, from node 0 */
            double S = 0, slope = 0;
            engine_1d.weight(method, end - (double)p / (double)PER_CELL - (double)i,
                             0.5 / (double)PER_CELL, &S, &slope);
            m[i] += S / (double)PER_CELL;
            gsl_vector_set(G, i, slope);
        }
        gsl_blas_dger(1 / (double)PER_CELL, G, G, K);
    }
    gsl_vector_free(G);
}

/* 2/omega_max [h/c], omega^2 the eigenvalues of M^-1/2 K M^-1/2. */
static double two_over_omega(const char *method, double x)
{
    double m[NODES] = {0};
    gsl_matrix *A = gsl_matrix_calloc(NODES, NODES);
    gsl_vector *squares = gsl_vector_alloc(NODES);
    gsl_eigen_symm_workspace *work = gsl_eigen_symm_alloc(NODES);
    assemble(method, x, m, A);
    for (size_t i = 0; i < NODES; i++)
        for (size_t j = 0; j < NODES; j++) {
            double *a = gsl_matrix_ptr(A, i, j);
            *a = m[i] > 1e-14 && m[j] > 1e-14 ? *a / sqrt(m[i] * m[j]) : 0;
        }
    gsl_eigen_symm(A, squares, work);
    const double largest = gsl_vector_max(squares);
    gsl_eigen_symm_free(work);
    gsl_vector_free(squares);
    gsl_matrix_free(A);
    return 2 / sqrt(largest);
}

/* The least critical step over all depths and dimensions: .3 is the usual CFL number. */
static void write_marks(FILE *f, const Table *t)
{
    EACH_METHOD(m, &engine_2d) {
        double least = INFINITY;
        EACH_ROW(row, t, "method=%s", m->name)
            least = measure_lesser(least, select_number(t, row, "critical"));
        if (isinf(least)) continue;
        grade_add(f, "H-5", m->name, grade_mark_of(-least, -0.3, -0.1),
                  "an edge barely inside a cell limits the step to %.2g h/c", least);
    }
}

static void tables(const Results *r)
{
    Ladder *ladders;
    const int n = ladder_read_all(r->rows, &ladders);
    FILE *points = results_write(r, "points", "dim,method,edge,place,depth,critical,grows_below");
    FILE *omega = results_write(r, "omega", "dim,method,edge,place,depth,two_over_omega");
    for (int k = 0; k < n; k++) write_point(points, r->rows, &ladders[k]);
    free(ladders);
    EACH_METHOD(m, &engine_1d)
        for (int e = 0; e < EDGES; e++)
            for (int d = 0; d < DEPTHS; d++)
                fprintf(omega, "1,%s,%s,%d,%g,%.6g\n", m->name, edges[e].name, e, depths[d],
                        two_over_omega(m->name, place(e, d)));
    write_marks(grades_write(r), results_part(r, "points"));
}

/* Largest |step/(factor sqrt(eps/h)) - 1|. */
static Measure off_root(const Table *t, const char *what, int dim, const char *method,
                        double factor)
{
    Curve curve;
    Measure worst = measure_max_of(0);
    for (int d = 0; d < DEPTHS; d++) worst.needs += (scenes[dim - 1].depths >> d & 1) != 0;
    curve_pick(&curve, t, "depth", what, "dim=%d method=%s edge=particle", dim, method);
    for (int k = 0; k < curve.n; k++)
        measure_add_max(&worst, fabs(curve.y[k] / (factor * sqrt(curve.x[k])) - 1));
    return worst;
}

/* Least value of a column for one method in 1D or 2D, over all placements of the block. */
static Measure smallest(const Table *t, const char *what, int dim, const char *method)
{
    return select_min(t, what, EDGES * (dim == 1 ? DEPTHS : 2), "dim=%d method=%s", dim, method);
}

static const char forgets[] =
    "2/omega holds for nodes that keep their velocities; here these are projected anew in each "
    "step, and the limit is sqrt(2)/omega, 29 % less";

static void check_tents(Check *check, const Table *points, const Table *omega)
{
    claim(check, "H-5.tent-omega",
          "Tents: 2/omega_max of M^-1 K is 2 sqrt(eps/h) h/c if the last particle lies eps inside "
          "a cell: largest relative deviation",
          off_root(omega, "two_over_omega", 1, "mpm", 2), 0, 0.1);
    claim_differs(check, "H-5.tent",
                  "Tents, last particle eps inside a cell: the critical step is 2 sqrt(eps/h) h/c, "
                  "as 2/omega_max suggests: largest relative deviation",
                  off_root(points, "critical", 1, "mpm", 2), 0, 0.1, 0.25, 0.35, forgets);
    claim(check, "H-5.tent-sqrt2",
          "Tents, last particle eps inside a cell: the critical step is sqrt(2 eps/h) h/c: largest "
          "relative deviation, 1D",
          off_root(points, "critical", 1, "mpm", M_SQRT2), 0, 0.1);
    claim(check, "H-5.tent-plane",
          "Tents, last particles eps inside a cell: the critical step is sqrt(2 eps/h) h/c of P "
          "waves: largest relative deviation, 2D (own measurement)",
          off_root(points, "critical", 2, "mpm", M_SQRT2), 0, 0.1);
    claim(check, "H-5.ge-tent",
          "GE-MPM, last particle eps inside a cell: particles return the node's velocity to it, "
          "and the critical step is 2 sqrt(eps/h) h/c: largest relative deviation",
          off_root(points, "critical", 1, "ge_mpm", 2), 0, 0.1);
}

static void check_floors(Check *check, const Table *points, const Table *omega)
{
    claim(check, "H-5.gimp-omega",
          "GIMP, bar that ends anywhere in a cell: 2/omega_max of M^-1 K does not fall below a "
          "floor however small the last node's mass [h/c]",
          smallest(omega, "two_over_omega", 1, "gimp"), 0.76, 0.84);
    claim_differs(check, "H-5.gimp",
                  "GIMP, bar that ends anywhere in a cell: the critical step stays above .76 h/c, "
                  "the floor of 2/omega_max: least [h/c]",
                  smallest(points, "critical", 1, "gimp"), 0.76, 0.84, 0.56, 0.76, forgets);
    claim(check, "H-5.bspline-omega",
          "B-splines, bar that ends anywhere in a cell: 2/omega_max of M^-1 K does not fall below "
          "a floor higher than GIMP's [h/c]",
          smallest(omega, "two_over_omega", 1, "bspline"), 0.9, 1);
    claim_differs(check, "H-5.bspline",
                  "B-splines, bar that ends anywhere in a cell: the critical step stays above .9 "
                  "h/c, the floor of 2/omega_max: least [h/c]",
                  smallest(points, "critical", 1, "bspline"), 0.9, 1, 0.66, 0.9, forgets);
    claim(check, "H-5.ge_wls",
          "GE-WLS, bar that ends anywhere in a cell: least critical step [h/c] (own measurement)",
          smallest(points, "critical", 1, "ge_wls"), 0.55, 1);
    claim(check, "H-5.ge_wls-plane",
          "GE-WLS, block that ends anywhere in a cell, 2D, P waves: least critical step [h/c] (own "
          "measurement)",
          smallest(points, "critical", 2, "ge_wls"), 0.55, 1);
}

static void check(Check *check, const Results *r)
{
    const Table *points = results_part(r, "points"), *omega = results_part(r, "omega");
    check_tents(check, points, omega);
    check_floors(check, points, omega);
}

const StudyPage study_h_05_small_mass = {
    .cases = cases, .refine = refine, .tables = tables, .check = check, .claims = 11};
