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
 * Tents. A grid that kept its velocities would take 2/omega = 2 sqrt(eps h)/c (omega.h). But the
 * node's velocity is projected anew at each step from particles that hardly feel its force: the
 * strain of the last cell obeys e <- (1 - (omega dt)^2) e, which is stable to sqrt(2)/omega only.
 * NAME.omega.csv has 2/omega_max with the same weights and positions, beside the step found. */
#include <math.h>
#include <stdlib.h>
#include "studies/tables/ladder.h"
#include "studies/tables/omega.h"

enum { PER_CELL = 2, RUNGS = 8, DEPTHS = 6, EDGES = 3, DIMS = 2, QUICK = 2 /* its depth */ };
static const double rungs[RUNGS] = {0.0095, 0.025, 0.05, 0.1, 0.2, 0.4, 0.8, 1.6};

/* What lies eps beyond a node, by its distance from the last particle in cells. */
static const struct {
    const char *name;
    double beyond;
} edges[EDGES] = {{"particle", 0}, {"box", 0.5 / (double)PER_CELL}, {"spline", 0.5}};

/* The block by dimension. */
static const struct {
    const Engine *engine;
    int cells, ppc, n;     /* n: of depths */
    double depths[DEPTHS]; /* eps/h */
    double fastest;        /* speed of its P waves, which limit the step [m/s] */
} scenes[DIMS] = {{&engine_1d, 10, PER_CELL, 6, {0.1, 0.03, 0.01, 0.003, 0.001, 1e-4}, BLOCK_SPEED},
                  {&engine_2d, 4, PER_CELL *PER_CELL, 2, {0.01, 1e-4}, BLOCK_P_SPEED}};

/* Lengths in cells. The end of the block lies on a node before it is moved. */
typedef struct Placement {
    int edge;
    double depth, last, moved; /* last: of the last particle beyond a node */
} Placement;

/* One of EDGES * scenes[dim].n. */
static Placement placement(int dim, int k)
{
    const int edge = k / scenes[dim].n;
    const double depth = scenes[dim].depths[k % scenes[dim].n], last = depth - edges[edge].beyond;
    return (Placement){edge, depth, last, last + 0.5 / (double)PER_CELL};
}

static void add_ladder(Cases *list, int dim, const char *method, double moved)
{
    const char *second = dim > 0 ? phrase(" --set offset_y=%.10g", moved) : "";
    for (int k = 0; k < RUNGS; k++)
        case_add(list,
                 "run block --method %s --integrator cd --cells %d --ppc %d --cfl %g --t-end %g "
                 "--set dim=%d --set offset_x=%.10g%s --set stop_growth=1 --set stretch=1.00000003 "
                 "--set drift_x=1.6e-7",
                 method, scenes[dim].cells, scenes[dim].ppc, rungs[k],
                 40 / (scenes[dim].cells * BLOCK_SPEED), dim + 1, moved, second);
}

static void cases(Cases *list, bool quick)
{
    for (int dim = 0; dim < (quick ? 1 : DIMS); dim++)
        EACH_METHOD(m, scenes[dim].engine)
            for (int k = 0; k < EDGES * scenes[dim].n; k++)
                if (!quick || k % scenes[dim].n == QUICK)
                    add_ladder(list, dim, m->name, placement(dim, k).moved);
}

static void refine(Cases *list, const Table *rows, bool quick)
{
    const double relative = quick ? 0.2 : 0.01;
    ladder_refine_windows(list, rows, relative, 10 * relative);
}

static void write_point(FILE *f, const Table *rows, const Ladder *l)
{
    const double moved = select_number(rows, l->row[0], "offset_x");
    const int dim = select_number(rows, l->row[0], "dim") > 1;
    const double scale = scenes[dim].fastest * scenes[dim].cells;
    int low, high, k = 0;
    while (k < EDGES * scenes[dim].n - 1 && fabs(placement(dim, k).moved - moved) > 1e-9) k++;
    const Placement p = placement(dim, k);
    const bool some = ladder_window(l, &low, &high);
    results_print(f, "%d,%s,%s,%d,%g,%.6g,%.6g\n", dim + 1, select_text(rows, l->row[0], "method"),
                  edges[p.edge].name, p.edge, p.depth,
                  some ? scale * select_number(rows, l->row[high], "dt") : 0,
                  some && low > 0 ? scale * select_number(rows, l->row[low - 1], "dt") : 0);
}

/* The least critical step over all depths and dimensions: .3 is the usual CFL number. */
static void write_marks(FILE *f, const Table *t)
{
    EACH_METHOD_OF(m, &engine_2d, t) {
        const double least = select_min(t, "critical", 1, "method=%s", m->name).value;
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
        for (int k = 0; k < EDGES * scenes[0].n; k++) {
            const Placement p = placement(0, k);
            results_print(omega, "1,%s,%s,%d,%g,%.6g\n", m->name, edges[p.edge].name, p.edge,
                          p.depth, omega_step_limit(m->name, scenes[0].cells, PER_CELL, p.last));
        }
    write_marks(grades_write(r), results_part(r, "points"));
}

/* Largest |step/(factor sqrt(eps/h)) - 1|. */
static Measure off_root(const Table *t, const char *what, int dim, const char *method,
                        double factor)
{
    Measure worst = measure_max_of(scenes[dim - 1].n);
    EACH_ROW(row, t, "dim=%d method=%s edge=particle", dim, method) {
        const double root = sqrt(select_number(t, row, "depth"));
        measure_add_max(&worst, fabs(select_kept(t, row, what) / (factor * root) - 1));
    }
    return worst;
}

/* Least value of a column for one method in 1D or 2D, over all placements of the block. */
static Measure smallest(const Table *t, const char *what, int dim, const char *method)
{
    return select_min(t, what, EDGES * scenes[dim - 1].n, "dim=%d method=%s", dim, method);
}

static const char forgets[] =
    "2/omega holds for nodes that keep their velocities; here these are projected anew in each "
    "step, and the limit is sqrt(2)/omega, 29 % less";

static void check_tents(Check *c, const Table *points, const Table *omega)
{
    claim(c, "H-5.tent-omega",
          "Tents: 2/omega_max of M^-1 K is 2 sqrt(eps/h) h/c if the last particle lies eps inside "
          "a cell: largest relative deviation",
          off_root(omega, "two_over_omega", 1, "mpm", 2), 0, 0.1);
    claim_differs(c, "H-5.tent",
                  "Tents, last particle eps inside a cell: the estimate 2/omega_max = 2 "
                  "sqrt(eps/h) h/c is the critical step: largest relative deviation",
                  off_root(points, "critical", 1, "mpm", 2), 0, 0.1, 0.25, 0.35, forgets);
    claim(c, "H-5.tent-sqrt2",
          "Tents, last particle eps inside a cell: the critical step is sqrt(2 eps/h) h/c: largest "
          "relative deviation, 1D",
          off_root(points, "critical", 1, "mpm", M_SQRT2), 0, 0.1);
    claim(c, "H-5.tent-plane",
          "Tents, last particles eps inside a cell: the critical step is sqrt(2 eps/h) h/c of P "
          "waves: largest relative deviation, 2D (own measurement)",
          off_root(points, "critical", 2, "mpm", M_SQRT2), 0, 0.1);
    claim(c, "H-5.ge-tent",
          "GE-MPM, last particle eps inside a cell: particles return the node's velocity to it, "
          "and the critical step is 2 sqrt(eps/h) h/c: largest relative deviation",
          off_root(points, "critical", 1, "ge_mpm", 2), 0, 0.1);
}

static void check(Check *c, const Results *r)
{
    const Table *points = results_part(r, "points"), *omega = results_part(r, "omega");
    check_tents(c, points, omega);
    claim(c, "H-5.gimp-omega",
          "GIMP, bar that ends anywhere in a cell: 2/omega_max of M^-1 K does not fall below a "
          "floor however small the last node's mass [h/c]",
          smallest(omega, "two_over_omega", 1, "gimp"), 0.76, 0.84);
    claim_differs(c, "H-5.gimp",
                  "GIMP, bar that ends anywhere in a cell: the critical step stays above .76 h/c, "
                  "the floor of 2/omega_max: least [h/c]",
                  smallest(points, "critical", 1, "gimp"), 0.76, 0.84, 0.56, 0.76, forgets);
    claim(c, "H-5.bspline-omega",
          "B-splines, bar that ends anywhere in a cell: 2/omega_max of M^-1 K does not fall below "
          "a floor higher than GIMP's [h/c]",
          smallest(omega, "two_over_omega", 1, "bspline"), 0.9, 1);
    claim_differs(c, "H-5.bspline",
                  "B-splines, bar that ends anywhere in a cell: the critical step stays above .9 "
                  "h/c, the floor of 2/omega_max: least [h/c]",
                  smallest(points, "critical", 1, "bspline"), 0.9, 1, 0.66, 0.9, forgets);
    claim(c, "H-5.ge_wls",
          "GE-WLS, bar that ends anywhere in a cell: least critical step [h/c] (own measurement)",
          smallest(points, "critical", 1, "ge_wls"), 0.55, 1);
    claim(c, "H-5.ge_wls-plane",
          "GE-WLS, block that ends anywhere in a cell, 2D, P waves: least critical step [h/c] (own "
          "measurement)",
          smallest(points, "critical", 2, "ge_wls"), 0.55, 1);
}

const StudyPage study_h_05_small_mass = {
    .cases = cases, .refine = refine, .tables = tables, .check = check, .claims = 11};
