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
#include <stdlib.h>
#include <string.h>
#include "studies/tables/curves.h"
#include "studies/runs/must.h"

enum { NORMS = 6, MESHES = 5 };
static const char *const norms[NORMS] = {"linf over time",  "l2 over time",  "l1 over time",
                                         "linf at the end", "l2 at the end", "l1 at the end"};
static const char *const columns[3] = {"error_linf", "error_l2", "error_l1"};

typedef struct Ladder {
    const char *problem, *settings, *methods[3];
    int cells[MESHES], usual; /* the mesh whose errors are shown */
} Ladder;

static const Ladder ladders[] = {
    {"ring", "", {"gimp", "ge_gimp", "fem"}, {8, 16, 32, 64}, 32},
    {"sine_bar", " --set law=linear", {"gimp", "ge_gimp"}, {10, 20, 40, 80, 160}, 40},
    {"axis_mms", "", {"gimp", "ge_gimp", "fem"}, {8, 16, 32}, 32},
    {"vortex", " --set G=.1 --set layout=radial", {"gimp", "ge_gimp", "fem"}, {8, 16, 32}, 32},
};
enum { LADDERS = sizeof ladders / sizeof *ladders };

static const char *part_name(const Ladder *l, const char *method, int cells)
{
    return phrase("%s.%s.%d", l->problem, method, cells);
}

static void cases(Cases *list, bool quick)
{
    for (const Ladder *l = ladders; l < ladders + LADDERS; l++)
        for (int m = 0; m < 3 && l->methods[m]; m++)
            for (int k = 0; k < (quick ? 3 : MESHES) && l->cells[k]; k++)
                case_add_with(list, "errors", part_name(l, l->methods[m], l->cells[k]),
                              "run %s --method %s --cells %d%s", l->problem, l->methods[m],
                              l->cells[k], l->settings);
}

/* linf, l2, l1 of a file of errors. */
static void end_norms(const Table *points, double out[3])
{
    double most = points->nrow ? 0 : NAN, square = 0, total = 0, weight = 0;
    for (int k = 0; k < points->nrow; k++) {
        const double e = select_number(points, k, "error"), w = select_number(points, k, "weight");
        most = measure_worse(most, e);
        square += w * e * e;
        total += w * e;
        weight += w;
    }
    out[0] = most;
    out[1] = sqrt(square / weight);
    out[2] = total / weight;
}

static int six_norms(const Results *r, const Ladder *l, const char *method, int cells,
                     double out[NORMS])
{
    const Table *points = results_run(r, "%s", part_name(l, method, cells));
    if (!points->nrow) return -1;
    for (int k = 0; k < 3; k++)
        out[k] = select_value(r->rows, columns[k], "problem=%s method=%s cells=%d", l->problem,
                              method, cells)
                     .value;
    end_norms(points, out + 3);
    return 0;
}

/* One line per norm: its error on the usual mesh, its order over all. */
static void write_norms(FILE *f, const Results *r, const Ladder *l, const char *method)
{
    double error[NORMS][MESHES], h[MESHES], one[NORMS], usual[NORMS] = {NAN};
    int n = 0;
    for (int k = 0; k < MESHES && l->cells[k]; k++) {
        if (six_norms(r, l, method, l->cells[k], one)) continue;
        h[n] = 1.0 / l->cells[k];
        for (int m = 0; m < NORMS; m++) error[m][n] = one[m];
        if (l->cells[k] == l->usual) memcpy(usual, one, sizeof usual);
        n++;
    }
    for (int m = 0; m < NORMS && n > 0; m++)
        fprintf(f, "%s,%s,%d,%s,%.10g,%.6g,%d\n", l->problem, method, m, norms[m], usual[m],
                curve_slope(n, h, error[m]), n);
}

typedef struct Cloud {
    int n;
    double *x, *y, *error;
} Cloud;

static Cloud cloud_read(const Results *r, const Ladder *l, const char *method, int cells)
{
    const Table *t = results_run(r, "%s", part_name(l, method, cells));
    Cloud c = {.n = t->nrow};
    c.x = must(calloc(3 * (size_t)c.n + 1, sizeof *c.x));
    c.y = c.x + c.n;
    c.error = c.y + c.n;
    for (int k = 0; k < c.n; k++) {
        c.x[k] = select_number(t, k, "X");
        c.y[k] = select_number(t, k, "Y");
        c.error[k] = select_number(t, k, "error");
    }
    return c;
}

/* The point of c nearest to (x, y), if c has points on all sides of it within h; or -1. */
static int nearest_inside(const Cloud *c, double x, double y, double h)
{
    double best = INFINITY;
    int at = -1, sides = 0;
    for (int k = 0; k < c->n; k++) {
        const double dx = c->x[k] - x, dy = c->y[k] - y, d = dx * dx + dy * dy;
        if (d > h * h) continue;
        sides |= 1 << ((dx > 0) + 2 * (dy > 0));
        if (d >= best) continue;
        best = d;
        at = k;
    }
    return sides == 15 ? at : -1;
}

typedef struct Same {
    int pairs;
    double linf[2], l1[2]; /* of the mesh, of the particles: at the same points */
    double all[2];         /* linf over all points of each */
} Same;

static Same compare(const Cloud *mesh, const Cloud *particles, double h)
{
    Same s = {0};
    for (int k = 0; k < mesh->n; k++) {
        s.all[0] = measure_worse(s.all[0], mesh->error[k]);
        const int p = nearest_inside(particles, mesh->x[k], mesh->y[k], h);
        if (p < 0) continue;
        const double e[2] = {mesh->error[k], particles->error[p]};
        for (int c = 0; c < 2; c++) {
            s.linf[c] = measure_worse(s.linf[c], e[c]);
            s.l1[c] += e[c];
        }
        s.pairs++;
    }
    for (int k = 0; k < particles->n; k++) s.all[1] = measure_worse(s.all[1], particles->error[k]);
    for (int c = 0; c < 2; c++) s.l1[c] /= s.pairs;
    return s;
}

static void write_same(FILE *f, const Results *r, const Ladder *l, const char *method, int cells)
{
    Cloud mesh = cloud_read(r, l, l->methods[2], cells);
    Cloud particles = cloud_read(r, l, method, cells);
    const Same s = compare(&mesh, &particles, 1.0 / cells);
    if (s.pairs)
        fprintf(f, "%s,%d,%d,%d,%.10g,%.10g,%.10g,%.10g,%.10g,%.10g\n", method, cells, mesh.n,
                s.pairs, s.all[0], s.all[1], s.linf[0], s.linf[1], s.l1[0], s.l1[1]);
    free(mesh.x);
    free(particles.x);
}

static void tables(const Results *r)
{
    FILE *f = results_write(r, "norms", "problem,method,norm,name,error,order,meshes");
    FILE *g =
        results_write(r, "same", "method,cells,nodes,pairs,fem_all,all,fem_linf,linf,fem_l1,l1");
    for (const Ladder *l = ladders; l < ladders + LADDERS; l++)
        for (int m = 0; m < 3 && l->methods[m]; m++) write_norms(f, r, l, l->methods[m]);
    for (int m = 0; m < 2; m++)
        for (int k = 0; k < MESHES && ladders[0].cells[k]; k++)
            write_same(g, r, &ladders[0], ladders[0].methods[m], ladders[0].cells[k]);
}

/* Of norm k; an order stands on as many rows as there are meshes. */
static Measure norm(const Table *t, const char *problem, const char *method, int k,
                    const char *what)
{
    static const char where[] = "problem=%s method=%s norm=%d";
    const Measure m = select_value(t, what, where, problem, method, k);
    if (strcmp(what, "order") != 0) return m;
    const Ladder *l = ladders;
    int meshes = 0;
    while (strcmp(l->problem, problem) != 0) l++;
    while (meshes < MESHES && l->cells[meshes]) meshes++;
    const double had = select_value(t, "meshes", where, problem, method, k).value;
    return measure(m.value, m.rows ? (int)had : 0, meshes);
}

/* Largest less least order of six. */
static Measure order_spread(const Table *t, const char *problem, const char *method)
{
    Measure most = measure_max_of(0), low = measure_min_of(0);
    for (int k = 0; k < NORMS; k++) {
        most = measure_max(most, norm(t, problem, method, k, "order"));
        low = measure_min(low, norm(t, problem, method, k, "order"));
    }
    return measure_with(most, most.value - low.value);
}

/* GIMP's error over FEM's on the ring: the largest ratio of six over the least. */
static Measure ratio_spread(const Table *t)
{
    Measure most = measure_max_of(0), low = measure_min_of(0);
    for (int k = 0; k < NORMS; k++) {
        const Measure r =
            measure_ratio(norm(t, "ring", "gimp", k, "error"), norm(t, "ring", "fem", k, "error"));
        most = measure_max(most, r);
        low = measure_min(low, r);
    }
    return measure_times(most, 1 / low.value);
}

static Measure same_ratio(const Table *same, int cells, const char *particles, const char *mesh)
{
    return measure_ratio(select_value(same, particles, "method=gimp cells=%d", cells),
                         select_value(same, mesh, "method=gimp cells=%d", cells));
}

static void check_tables(Check *c, const Table *t, const Table *same)
{
    claim(c, "T-6.gimp-order",
          "Ring: the norm decides GIMP's order: largest order less least of six norms",
          order_spread(t, "ring", "gimp"), 0.2, 0.5);
    claim(c, "T-6.fem-order", "Ring: FEM has one order in all six norms: largest order less least",
          order_spread(t, "ring", "fem"), 0, 0.25);
    claim(c, "T-6.bar-order",
          "Sine bar, smooth: GIMP has one order in all norms: largest order less least",
          order_spread(t, "sine_bar", "gimp"), 0, 0.05);
    claim(c, "T-6.axis-fem-order",
          "Axis-aligned displacement: FEM has one order in all six norms: largest order less least",
          order_spread(t, "axis_mms", "fem"), 0, 0.25);
    claim(c, "T-6.vortex-fem-order",
          "Vortex: FEM has one order in all six norms: largest order less least",
          order_spread(t, "vortex", "fem"), 0, 0.25);
    claim(c, "T-6.axis-gimp-order",
          "Axis-aligned displacement, smooth: GIMP is of second order: order of the largest error",
          norm(t, "axis_mms", "gimp", 0, "order"), 1.8, 2.2);
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

static void check(Check *c, const Results *r)
{
    const Table *t = results_part(r, "norms"), *same = results_part(r, "same");
    check_tables(c, t, same);
}

const StudyPage study_t_06_norms = {.cases = cases, .tables = tables, .check = check, .claims = 11};
