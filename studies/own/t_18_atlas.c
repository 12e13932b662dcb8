/* t_18_atlas.c: which findings of the hard cases in the plane hold in three dimensions? H-1, H-2,
 * H-5, H-8 and H-14 on coarse meshes; what is measured: the pages hard/h_*.c.
 *
 *   H-1   one step of a stretched block in uniform motion: nodal forces four cells and more inside;
 *         a block that drifts from node to node with its particles on nodes
 *   H-2   particle velocities that alternate: their amplitude after 300 steps
 *   H-5   a corner that reaches .01 h into empty cells: the largest stable step of a few
 *   H-8   one turn, imposed (growth of J over exp(2 pi w dt)) or free (loss of angular momentum)
 *   H-14  a block falls freely */
#include <math.h>
#include "studies/tables/block_nodes.h"
#include "studies/tables/corner.h"
#include "studies/tables/grades.h"
#include "studies/tables/masses.h"

enum { INSIDE = 12, CELLS = 8, CORNER = 4, STEPS = 300, INTEGRATORS = 5 };
#define STRETCH 1.0717
#define DRIFT   0.1
#define EPS     0.01 /* H-5, in h */
#define OFF     "--set offset_x=.13 --set offset_y=.42 --set offset_z=.77"
static const char uniform[] = "mpm gimp ge_gimp bspline wls2 ge_wls";
static const char ripple[] = "mpm gimp ge_gimp bspline apic tpic wls wls2 ge_wls";
static const char spun[] = "mpm gimp ge_gimp apic tpic wls2", freely[] = "gimp ge_gimp apic";
static const char half[] = "cd uvf musl", whole[] = "usl usf"; /* first steps of integrators */

/* H-5: tents, the edges of boxes, a free surface. */
enum { CORNERS = 3 };
static const Corner corners[CORNERS] = {
    {"mpm", 0, EPS, 0.141421}, {"gimp", 0.25, EPS, 1}, {"ge_wls", 0.5, EPS, 1}};

static void add_files(Cases *list, bool quick)
{
    for (int turned = 0; turned < 2; turned++)
        case_add_each(list, "nodes", turned ? "turned" : "stretch", uniform,
                      "run block --cells %d --integrator usl --set dim=3 --set steps=1 --set "
                      "allow_unstable=1 --set stretch=%g --set angle=%d --set drift_x=%g " OFF,
                      INSIDE, STRETCH, turned * 30, DRIFT);
    case_add_each(list, "history", "ripple", ripple,
                  "run block --cells %d --set dim=3 --set ripple=1e-4 " OFF " --t-end %.17g", CELLS,
                  (quick ? 10 : STEPS) * BLOCK_CFL / ((double)CELLS * BLOCK_SPEED));
}

static void cases(Cases *list, bool quick)
{
    const char *all = phrase("%s %s", half, whole);
    add_files(list, quick);
    for (int k = 0; k < CORNERS; k++) corner_add(list, &corners[k]);
    case_add_each(list, "particles", "spin", spun,
                  "run block --cells %d --t-end %.17g --set dim=3 --set box=4 --set spin=1", CELLS,
                  2 * M_PI / BLOCK_SPEED);
    case_add_each(list, "history", "free", freely,
                  "run free_block --cells %d --t-end %.17g --set dim=3 --set box=2 --set swing=0 "
                  "--set drift=0",
                  CELLS, FREE_TURN);
    EACH_WORD(m, "mpm ge_mpm")
        EACH_WORD(i, all)
            case_add(list,
                     "run block --method %s --integrator %s --set allow_unstable=1 --set dim=3 "
                     "--cells %d --set steps=20 --set drift_x=0.8333333333333334 --set "
                     "offset_x=0.25 --set offset_y=0.25 --set offset_z=0.25",
                     m, i, CELLS);
    EACH_METHOD(m, &engine_3d) {
        const bool grid = engine_has_grid(&engine_3d, m->name);
        EACH_WORD(i, grid ? all : "cd")
            case_add(list,
                     "run block --method %s --integrator %s --cells %d --set dim=3 --set "
                     "gravity=1000 " OFF " --set refresh=%d --set allow_unstable=1 --set steps=20",
                     m->name, i, CORNER, grid);
    }
}

/* H-1: the largest force inside over |sigma| and the area of a cell's face. */
static double force(const Table *t, double degrees)
{
    static const double off[] = {0.13, 0.42, 0.77};
    const BlockNodes b = {3, INSIDE, 3, off, STRETCH, degrees, DRIFT, 0.5 - 4 / (double)INSIDE};
    return block_nodes_largest(&b, t);
}

/* H-8: mean J over exp(2 pi w dt). */
static double growth(const Table *t)
{
    return masses_sum(t, (const double[2]){2, 2}).J / exp(2 * M_PI * BLOCK_CFL / (double)CELLS);
}

static void tables(const Results *r)
{
    FILE *f = results_write(r, "found", "what,method,value,status");
    static const char *const what[] = {"stretch", "turned", "ripple", "spin", "free"};
    const char *const methods[] = {uniform, uniform, ripple, spun, freely};
    for (int k = 0; k < 5; k++)
        EACH_WORD(m, methods[k]) {
            const char *part = phrase("%s.%s", what[k], m);
            const Table *t = results_run(r, "%s", part);
            const double x = k < 2    ? force(t, 30 * k)
                             : k == 2 ? sqrt(curve_growth(t, "kinetic"))
                             : k == 3 ? growth(t)
                                      : 1 - curve_growth(t, "angular_z");
            if (t->nrow)
                results_print(f, "%s,%s,%.10g,%s\n", what[k], m, x, results_status(r, part));
        }
}

/* The largest of the numbers that these methods have in NAME.found.csv. */
static Measure largest(const Table *t, const char *what, const char *methods)
{
    return curve_worst(t, methods, 1, "value", phrase("what=%s", what));
}

/* H-14: largest error with these integrators. */
static Measure fall_error(const Table *t, const char *integrators, int needs)
{
    Measure most = measure_max_of(needs);
    EACH_WORD(i, integrators)
        EACH_ROW(row, t, "gravity=1000 integrator=%s", i)
            measure_add_max(&most, select_kept(t, row, "error_linf"));
    return most;
}

static void check_forces(Check *c, const Table *t)
{
    claim(c, "T-18e.h1-tent",
          "Stretched block in 3D, MPM: force inside a uniformly stressed moving body over |sigma| "
          "A, largest",
          largest(t, "stretch", "mpm"), 0.1, 1);
    claim(c, "T-18e.h1-gimp",
          "Stretched block in 3D, GIMP, GE-GIMP: no force inside while boxes tile space: largest "
          "over |sigma| A",
          largest(t, "stretch", "gimp ge_gimp"), 0, 1e-10);
    claim(c, "T-18e.h1-turned",
          "Block turned by 30 degrees in 3D, GIMP: boxes do not tile space: largest force over "
          "|sigma| A",
          largest(t, "turned", "gimp"), 1e-3, 1);
    claim(c, "T-18e.h1-wls",
          "Block in 3D, turned or not, WLS2, GE-WLS: no force inside: largest over |sigma| A",
          measure_max(largest(t, "stretch", "wls2 ge_wls"), largest(t, "turned", "wls2 ge_wls")), 0,
          1e-10);
    claim(c, "T-18e.h2-flip",
          "Alternating velocities in 3D: MPM, GIMP, GE-GIMP, B-splines keep them: least amplitude "
          "left after 300 steps",
          curve_least(t, "mpm gimp ge_gimp bspline", 1, "value", "what=ripple"), 0.9, 1.1);
    claim(c, "T-18e.h2-damp",
          "Alternating velocities in 3D: APIC, TPIC damp them: most amplitude left after 300 steps",
          largest(t, "ripple", "apic tpic"), 0, 0.1);
    claim(c, "T-18e.h2-wls",
          "Alternating velocities in 3D: WLS, WLS2, GE-WLS keep them for 300 steps: most amplitude "
          "left",
          largest(t, "ripple", "wls wls2 ge_wls"), 0.9, 1.1);
}

static void check_turns(Check *c, const Table *t)
{
    claim(c, "T-18e.h8-growth",
          "Imposed turn in 3D: J grows by exp(2 pi w dt) with GE-GIMP, APIC, TPIC, WLS2: largest "
          "ratio",
          largest(t, "spin", "ge_gimp apic tpic wls2"), 0.99, 1.01);
    claim(c, "T-18e.h8-gimp",
          "Imposed turn in 3D: GIMP underestimates the rotation at edges: J over exp(2 pi w dt), "
          "8 cells",
          largest(t, "spin", "gimp"), 0.9, 0.96);
    claim(c, "T-18e.h8-free",
          "Free turn in 3D: angular momentum that GE-GIMP loses over GIMP's loss, 8 cells",
          measure_ratio(largest(t, "free", "ge_gimp"), largest(t, "free", "gimp")), 0, 0.1);
}

static void check(Check *c, const Results *r)
{
    const Table *t = r->rows;
    const double dt = select_value(t, "dt", "gravity=1000 method=mpm").value;
    int methods = 0;
    EACH_GRID_METHOD(m, &engine_3d) methods += !m->on_request;
    check_forces(c, results_part(r, "found"));
    check_turns(c, results_part(r, "found"));
    claim_differs(
        c, "T-18e.h5-tent",
        "Corner .01 h inside a cell in 3D, MPM: the critical step is sqrt(2 eps/h) h/c, "
        "as in the plane: largest stable step of six, over that",
        corner_stable(t, &corners[0]), 0.9, 1, 0.8, 0.8,
        "stable at .8 of it, not at .95 (cd, eps = .01 h); the reason was not looked for");
    for (int k = 1; k < CORNERS; k++)
        claim(c, phrase("T-18e.h5-%s", corners[k].method),
              phrase("Corner .01 h inside a cell in 3D, %s: largest stable step of six [h/c]",
                     engine_label(corners[k].method)),
              corner_stable(t, &corners[k]), 0.5, 0.5);
    claim(c, "T-18e.h12",
          "MPM, GE-MPM, every integrator in 3D: a block drifts from node to node: largest error "
          "of displacement [m]",
          select_max(t, "error_linf", 2 * INTEGRATORS, "drift_x=0.8333333333333334"), 0, 1e-12);
    claim(c, "T-18e.h14-half",
          "Free fall in 3D: x - g t^2/2 vanishes with a half first step (cd, uvf, musl), every "
          "method and FEM: largest [m]",
          fall_error(t, half, 3 * methods + 1), 0, 1e-12);
    claim(c, "T-18e.h14-whole",
          "Free fall in 3D with a whole first step (usl, usf) is g t dt/2 too far: largest error "
          "over that",
          measure_times(fall_error(t, whole, 2 * methods), 1 / (1000 * 20 * dt * dt / 2)), 0.99,
          1.01);
}

const StudyPage study_t_18_atlas = {.cases = cases, .tables = tables, .check = check, .claims = 16};
