/* t_06_norms.c: one run, six norms, six orders: how the norm changes the verdict.
 *
 * Of each run: largest error, root mean square and mean over the points with mass, weighted by
 * their reference volumes; each as running maximum over all steps (columns of the row) and at the
 * end (from the file that --errors leaves). common/run/norm.c takes them all, of particles and of
 * FEM's nodes alike.
 *
 * Same points. FEM has nodes on the surface, where errors are largest and a particle method has no
 * points. NAME.same.csv compares them where both have some: at every node that has particles on all
 * sides within h, with the particle whose reference position is nearest; equal weights. */
#include <math.h>
#include <string.h>
#include "studies/tables/cloud.h"
#include "studies/tables/curves.h"

enum { NORMS = 6, MESHES = 5 };
static const char *const norms[NORMS] = {"linf over time",  "l2 over time",  "l1 over time",
                                         "linf at the end", "l2 at the end", "l1 at the end"};
static const char *const columns[3] = {"error_linf", "error_l2", "error_l1"};

typedef struct Ladder {
    const char *problem, *settings, *methods[3];
    int cells[MESHES], usual; /* the mesh whose errors are shown */
} Ladder;

enum { RING, BAR, AXIS, VORTEX, LADDERS };
static const Ladder ladders[LADDERS] = {
    [RING] = {"ring", "", {"gimp", "ge_gimp", "fem"}, {8, 16, 32, 64}, 32},
    [BAR] = {"sine_bar", " --set law=linear", {"gimp", "ge_gimp"}, {10, 20, 40, 80, 160}, 40},
    [AXIS] = {"axis_mms", "", {"gimp", "ge_gimp", "fem"}, {8, 16, 32}, 32},
    [VORTEX] =
        {"vortex", " --set G=.1 --set layout=radial", {"gimp", "ge_gimp", "fem"}, {8, 16, 32}, 32},
};

static int meshes_of(const Ladder *l)
{
    int n = 0;
    while (n < MESHES && l->cells[n]) n++;
    return n;
}

static const char *part_name(const Ladder *l, const char *method, int cells)
{
    return phrase("%s.%s.%d", l->problem, method, cells);
}

static void cases(Cases *list, bool quick)
{
    for (const Ladder *l = ladders; l < ladders + LADDERS; l++)
        for (int m = 0; m < 3 && l->methods[m]; m++)
            for (int k = 0; k < (quick ? 3 : meshes_of(l)); k++)
                case_add_with(list, "errors", part_name(l, l->methods[m], l->cells[k]),
                              "run %s --method %s --cells %d%s", l->problem, l->methods[m],
                              l->cells[k], l->settings);
}

/* All norms of one run: over time from its row, at the end from its file. False: it has none. */
static bool norms_of(const Results *r, const Ladder *l, const char *method, int cells,
                     double out[NORMS])
{
    static const char where[] = "problem=%s method=%s cells=%d";
    const Table *points = results_run(r, "%s", part_name(l, method, cells));
    double most = 0, square = 0, total = 0, weight = 0;
    for (int k = 0; k < 3; k++)
        out[k] = select_value(r->rows, columns[k], where, l->problem, method, cells).value;
    for (int k = 0; k < points->nrow; k++) {
        const double e = select_number(points, k, "error"), w = select_number(points, k, "weight");
        most = measure_worse(most, e);
        square += w * e * e;
        total += w * e;
        weight += w;
    }
    out[3] = most;
    out[4] = sqrt(square / weight);
    out[5] = total / weight;
    return points->nrow > 0;
}

/* One line per norm: its error on the usual mesh, its order over all. */
static void write_norms(FILE *f, const Results *r, const Ladder *l, const char *method)
{
    double error[NORMS][MESHES], h[MESHES], one[NORMS], usual[NORMS] = {NAN};
    int n = 0;
    for (int k = 0; k < meshes_of(l); k++) {
        if (!norms_of(r, l, method, l->cells[k], one)) continue;
        h[n] = 1.0 / l->cells[k];
        for (int m = 0; m < NORMS; m++) error[m][n] = one[m];
        if (l->cells[k] == l->usual) memcpy(usual, one, sizeof usual);
        n++;
    }
    for (int m = 0; m < NORMS && n > 0; m++)
        results_print(f, "%s,%s,%d,%s,%.10g,%.6g,%d\n", l->problem, method, m, norms[m], usual[m],
                      curve_slope(n, h, error[m]), n);
}

/* FEM beside a method on the ring. */
static void write_same(FILE *f, const Results *r, const char *method, int cells)
{
    const Ladder *l = &ladders[RING];
    const Table *mesh = results_run(r, "%s", part_name(l, "fem", cells));
    const Table *particles = results_run(r, "%s", part_name(l, method, cells));
    const CloudErrors e = cloud_compare(mesh, particles, 1.0 / cells);
    if (e.pairs)
        results_print(f, "%s,%d,%d,%d,%.10g,%.10g,%.10g,%.10g,%.10g,%.10g\n", method, cells,
                      e.nodes, e.pairs, e.all[0], e.all[1], e.linf[0], e.linf[1], e.l1[0], e.l1[1]);
}

static void tables(const Results *r)
{
    FILE *f = results_write(r, "norms", "problem,method,norm,name,error,order,meshes");
    FILE *g =
        results_write(r, "same", "method,cells,nodes,pairs,fem_all,all,fem_linf,linf,fem_l1,l1");
    for (const Ladder *l = ladders; l < ladders + LADDERS; l++)
        for (int m = 0; m < 3 && l->methods[m]; m++) write_norms(f, r, l, l->methods[m]);
    for (int m = 0; m < 2; m++)
        for (int k = 0; k < meshes_of(&ladders[RING]); k++)
            write_same(g, r, ladders[RING].methods[m], ladders[RING].cells[k]);
}

static Measure norm(const Table *t, int ladder, const char *method, int k, const char *what)
{
    return select_value(t, what, "problem=%s method=%s norm=%d", ladders[ladder].problem, method,
                        k);
}

/* Of norm k; it is computed from as many rows as there are meshes. */
static Measure order(const Table *t, int ladder, const char *method, int k)
{
    const Measure m = norm(t, ladder, method, k, "order"),
                  had = norm(t, ladder, method, k, "meshes");
    return measure(m.value, m.rows ? (int)had.value : 0, meshes_of(&ladders[ladder]));
}

/* Largest less least order of six. */
static Measure order_spread(const Table *t, int ladder, const char *method)
{
    Measure orders[NORMS];
    for (int k = 0; k < NORMS; k++) orders[k] = order(t, ladder, method, k);
    const Measure most = measure_largest(NORMS, orders);
    return measure_with(most, most.value - measure_least(NORMS, orders).value);
}

/* GIMP's error over FEM's on the ring: the largest ratio of six over the least. */
static Measure ratio_spread(const Table *t)
{
    Measure ratios[NORMS];
    for (int k = 0; k < NORMS; k++)
        ratios[k] =
            measure_ratio(norm(t, RING, "gimp", k, "error"), norm(t, RING, "fem", k, "error"));
    return measure_times(measure_largest(NORMS, ratios), 1 / measure_least(NORMS, ratios).value);
}

static Measure same_ratio(const Table *same, int cells, const char *particles, const char *mesh)
{
    return measure_ratio(select_value(same, particles, "method=gimp cells=%d", cells),
                         select_value(same, mesh, "method=gimp cells=%d", cells));
}

static void check(Check *c, const Results *r)
{
    const Table *t = results_part(r, "norms"), *same = results_part(r, "same");
    claim(c, "T-6.gimp-order",
          "Ring: the norm decides GIMP's order: largest order less least of six norms",
          order_spread(t, RING, "gimp"), 0.2, 0.5);
    claim(c, "T-6.fem-order", "Ring: FEM has one order in all six norms: largest order less least",
          order_spread(t, RING, "fem"), 0, 0.25);
    claim(c, "T-6.bar-order",
          "Sine bar, smooth: GIMP has one order in all norms: largest order less least",
          order_spread(t, BAR, "gimp"), 0, 0.05);
    claim(c, "T-6.axis-fem-order",
          "Axis-aligned displacement: FEM has one order in all six norms: largest order less least",
          order_spread(t, AXIS, "fem"), 0, 0.25);
    claim(c, "T-6.vortex-fem-order",
          "Vortex: FEM has one order in all six norms: largest order less least",
          order_spread(t, VORTEX, "fem"), 0, 0.25);
    claim(c, "T-6.axis-gimp-order",
          "Axis-aligned displacement, smooth: GIMP is of second order: order of the largest error",
          order(t, AXIS, "gimp", 0), 1.8, 2.2);
    claim(c, "T-6.ratio",
          "Ring, N = 32: GIMP's error over FEM's: the largest ratio of six over the least",
          ratio_spread(t), 3, 6);
    claim(c, "T-6.same-32", "Ring: GIMP's largest error over FEM's, N = 32, all points of each",
          same_ratio(same, 32, "all", "fem_all"), 15, 30);
    claim(c, "T-6.same-32-inside",
          "Ring: GIMP's largest error over FEM's, N = 32, same points inside the body",
          same_ratio(same, 32, "linf", "fem_linf"), 9, 16);
    claim(c, "T-6.same-8",
          "Ring, N = 8, all points: by the largest error FEM wins: GIMP's over FEM's",
          same_ratio(same, 8, "all", "fem_all"), 2, 3);
    claim(c, "T-6.same-8-inside", "Ring, N = 8, same points inside: by the mean error GIMP wins",
          same_ratio(same, 8, "l1", "fem_l1"), 0.7, 0.95);
}

const StudyPage study_t_06_norms = {.cases = cases, .tables = tables, .check = check, .claims = 11};
