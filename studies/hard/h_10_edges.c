/* h_10_edges.c: hard case H-10: where a body ends. A linear velocity field is projected from a
 * block, a strip of one and a half cells, a concave corner, and a block with a gap of half a cell
 * (two surfaces in one cell), none of them on the grid's lines. All nodes with mass count.
 *
 * A node at an edge receives contributions from one side only: mass-weighted projection gives it
 * the mean velocity of particles about half a cell away, an error of first order in h. Velocity
 * gradients, or a linear fit, extrapolate to the node. */
#include "studies/tables/grades.h"

enum { BODIES = 4, MESHES = 4 };
static const char *const bodies[BODIES] = {"block", "strip", "corner", "slit"};
static const int meshes[MESHES] = {16, 32, 64, 128};

static void cases(Cases *list, bool quick)
{
    for (int b = 0; b < BODIES; b++)
        EACH_GRID_METHOD(m, &engine_2d)
            for (int k = 0; k < (quick ? 2 : MESHES); k++)
                case_add(list, "run patch --method %s --cells %d --set body=%s --set edges=1",
                         m->name, meshes[k], bodies[b]);
}

/* NAME.edges.csv: body,method,status,error,order,fallbacks,meshes: error on the finest mesh, order
 * in h over all meshes. */
static void write_edges(FILE *f, const Table *rows)
{
    for (int b = 0; b < BODIES; b++)
        EACH_METHOD_OF(m, &engine_2d, rows) {
            const char *where = phrase("method=%s body=%s", m->name, bodies[b]);
            const bool lost = select_count_lost(rows, 1, where).value > 0;
            Curve c;
            curve_pick(&c, rows, "h", "error_linf", "%s", where);
            if (c.n > 0)
                results_print(f, "%s,%s,%s,%.10g,%.6g,%g,%d\n", bodies[b], m->name,
                              lost ? "lost" : "ok", c.y[c.n - 1], curve_slope(c.n, c.x, c.y),
                              select_max(rows, "fallbacks", 1, "%s", where).value, c.n);
        }
}

static void write_marks(FILE *f, const Table *t)
{
    EACH_METHOD_OF(m, &engine_2d, t) {
        const double e = curve_worst(t, m->name, 1, "error", "status=ok").value;
        grade_add(f, "H-10", m->name, grade_mark_of(e, 1e-12, 1),
                  e <= 1e-12 ? "linear fields exact at edges, corners, gaps"
                             : "at edges off by O(h): %.2g on the finest mesh",
                  e);
    }
}

static void tables(const Results *r)
{
    write_edges(results_write(r, "edges", "body,method,status,error,order,fallbacks,meshes"),
                r->rows);
    write_marks(grades_write(r), results_part(r, "edges"));
}

/* Number of lost runs among all rows, of which there must be as many as cases() lists. */
static Measure lost(const Table *rows)
{
    int runs = 0;
    EACH_GRID_METHOD(m, &engine_2d)
        if (!m->on_request) runs += BODIES * MESHES;
    return select_count_lost(rows, runs, "");
}

/* Order in h of a method's error in the block, over all meshes. */
static Measure order(const Table *t, const char *method)
{
    return select_value(t, "order", "method=%s body=block meshes=%d", method, MESHES);
}

static void check(Check *c, const Results *r)
{
    const Table *t = results_part(r, "edges");
    claim(c, "H-10.defined",
          "Linear field at edges, of a thin strip, at a concave corner, two surfaces in a cell: "
          "runs lost",
          lost(r->rows), 0, 0);
    claim(c, "H-10.order",
          "Linear field projected from a block: MPM and GIMP are of first order at its edges: "
          "order in h of the largest error",
          measure_max(order(t, "mpm"), order(t, "gimp")), 0.8, 1.2);
    claim(c, "H-10.ge",
          "GE-MPM, GE-GIMP, APIC, TPIC project a linear field exactly at edges of all four bodies: "
          "largest error",
          curve_worst(t, "ge_mpm ge_gimp apic tpic", BODIES, "error", "meshes=4"), 0, 1e-12);
    claim(c, "H-10.wls2",
          "WLS2 projects a linear field exactly at edges of all four bodies: largest error",
          curve_worst(t, "wls2", BODIES, "error", "meshes=4"), 0, 1e-12);
    claim_differs(c, "H-10.wls",
                  "WLS projects a linear field exactly at edges of all four bodies: largest error",
                  curve_worst(t, "wls", BODIES, "error", "meshes=4"), 0, 1e-12, 1e-3, 0.1,
                  "off by .010: spurious nodes take a mean of their neighbours' velocities, which "
                  "is O(h) wrong; WLS2 extrapolates");
    claim(c, "H-10.wls-order",
          "Linear field projected from a block: WLS's error at the edges falls with h: order of "
          "the largest error",
          order(t, "wls"), 0.5, 1.2);
}

const StudyPage study_h_10_edges = {.cases = cases, .tables = tables, .check = check, .claims = 6};
