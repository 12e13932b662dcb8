/* patch.c: projection of a linear velocity field from particles that are not ideal, or to nodes at
 * a body's edges: v = (1 + x + 2 y, 2 - x + y), with its exact gradient.
 *
 * Bodies of rectangles: a block, a strip of one and a half cells, a concave corner, and a block in
 * two with a gap of half a cell. All edges are 0.3 cells off the grid's lines, or half a cell more
 * or less. Particles are a lattice from the rectangle's corner on, jittered (gsl_rng_taus2, fixed
 * seed) or graded: denser to the left. */
#include <gsl/gsl_rng.h>
#include <math.h>
#include "common/contract/layout.h"
#include "common/contract/problem.h"

enum { BODY, JITTER, GRADING, EDGES };
enum { BLOCK, STRIP, CORNER, SLIT };

static const Param params[] = {
    {"body", BLOCK, 0, 3, "", "what is filled", "", "block|strip|corner|slit"},
    {"jitter", 0, 0, 0.5, "spacing", "most that a particle is moved along an axis", "", NULL},
    {"grading", 1, 1, 4, "", "exponent of x that moves particles to the left; 1: none", "", NULL},
    {"edges", 0, 0, 1, "", "0: errors of nodes two cells inside only; 1: of all nodes with mass",
     "", "0|1"},
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

typedef struct Box {
    double lo[2], hi[2];
} Box;

/* The body's rectangles; how many. */
static int boxes(const Scene *s, Box out[2])
{
    const double h = s->cell, cells = round(0.3 / h); /* of half a side */
    const double lo = (floor(0.2 / h) + 0.3) * h, mid = lo + cells * h, hi = lo + 2 * cells * h;
    const Box all = {{lo, lo}, {hi, hi}};
    out[0] = out[1] = all;
    switch ((int)s->par[BODY]) {
    case STRIP:
        out[0].hi[1] = lo + 1.5 * h;
        return 1;
    case CORNER:
        out[0].hi[1] = out[1].lo[1] = out[1].hi[0] = mid;
        return 2;
    case SLIT:
        out[0].hi[0] = mid - 0.25 * h;
        out[1].lo[0] = mid + 0.25 * h;
        return 2;
    default:
        return 1;
    }
}

static int init(Scene *s, char why[128])
{
    Box box[2];
    (void)why;
    boxes(s, box);
    s->mat = material_make(NEO_HOOKEAN, 1, 0, 1);
    for (int d = 0; d < DIM; d++) {
        s->hi[d] = 1;
        /* whose nodes count */
        s->body_lo[d] = s->par[EDGES] > 0 ? 0 : box[0].lo[d % 2] + 2 * s->cell;
        s->body_hi[d] = s->par[EDGES] > 0 ? 1 : box[0].hi[d % 2] - 2 * s->cell;
    }
    s->c = 1;
    s->error_scale = 1;
    return 0;
}

/* A fraction of a box's length moved to the left. */
static double graded(const Scene *s, double f)
{
    return pow(f, s->par[GRADING]);
}

/* Width of particle k of n on the graded axis, over that of an even row: the stretch of the length
 * that its own share was moved to, so that all together fill the box. */
static double graded_width(const Scene *s, int k, int n)
{
    if (!(s->par[GRADING] > 1)) return 1;
    return n * (graded(s, (k + 1.0) / n) - graded(s, (double)k / n));
}

static void fill(const Scene *s, const Box *b, double spacing, gsl_rng *random, Layout *out)
{
    const double side[] = {b->hi[0] - b->lo[0], b->hi[1] - b->lo[1]};
    const int n[] = {(int)fmax(round(side[0] / spacing), 1),
                     (int)fmax(round(side[1] / spacing), 1)};
    for (int k = 0; k < n[0] * n[1]; k++) {
        const int index[] = {k % n[0], k / n[0]};
        Vec X = {0};
        for (int d = 0; d < DIM && d < 2; d++) {
            const double f = (index[d] + 0.5) / n[d];
            const double moved = s->par[JITTER] * (2 * gsl_rng_uniform(random) - 1) / n[d];
            X[d] = b->lo[d] + side[d] * ((d ? f : graded(s, f)) + moved);
        }
        layout_add(out, X, side[0] * side[1] / (n[0] * n[1]) * graded_width(s, index[0], n[0]),
                   NULL);
    }
}

static bool is_in(const Box *b, double x, double y)
{
    return x > b->lo[0] && x < b->hi[0] && y > b->lo[1] && y < b->hi[1];
}

/* Surface points at mid spacing on the face across `axis` that are not inside `other`. */
static void face(const Box *b, const Box *other, int axis, int side, double spacing, Layout *out)
{
    const int along = 1 - axis;
    const double length = b->hi[along] - b->lo[along];
    const int n = (int)ceil(length / spacing - 1e-9);
    for (int k = 0; k < n; k++) {
        double at[2];
        Vec X = {0}, normal = {0};
        at[axis] = side < 0 ? b->lo[axis] : b->hi[axis];
        at[along] = b->lo[along] + (k + 0.5) / n * length;
        for (int d = 0; d < DIM && d < 2; d++) {
            X[d] = at[d];
            normal[d] = d == axis ? side : 0;
        }
        at[axis] += side * 1e-6;
        if (!other || !is_in(other, at[0], at[1])) layout_add(out, X, 0, normal);
    }
}

static bool place(const Scene *s, double spacing, bool fitted, Layout *out)
{
    Box box[2];
    const int n = boxes(s, box);
    gsl_rng *random = gsl_rng_alloc(gsl_rng_taus2);
    for (int k = 0; random && k < n; k++) fill(s, &box[k], spacing, random, out);
    if (!random) out->lost++;
    gsl_rng_free(random);
    for (int k = 0; fitted && k < n; k++)
        for (int axis = 0; axis < 2; axis++)
            for (int side = -1; side <= 1; side += 2)
                face(&box[k], n > 1 ? &box[1 - k] : NULL, axis, side,
                     layout_surface_spacing(out, spacing), out);
    return true;
}

static void exact(const Scene *s, int n, ConstFields X, double t, Fields v)
{
    (void)s, (void)t;
    for (int p = 0; p < n; p++) {
        const double y = DIM > 1 ? X[DIM > 1][p] : 0;
        const double field[] = {1 + X[0][p] + 2 * y, 2 - X[0][p] + y, 0};
        for (int a = 0; a < DIM; a++) v[a][p] = field[a];
    }
}

static void start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    const double gradient[2][2] = {{1, 2}, {-1, 1}};
    (void)u, (void)F;
    exact(s, n, X, 0, v);
    for (int a = 0; a < DIM && a < 2; a++)
        for (int b = 0; b < DIM && b < 2; b++)
            for (int p = 0; p < n; p++) L[a * DIM + b][p] = gradient[a][b];
}

const Problem problem_patch = {
    .info = {.name = "patch",
             .label = "patch of particles",
             .about = "projection of a linear field: uneven particles, edges, corners, no time",
             .source = "",
             .formula = "v = (1 + x + 2 y, 2 - x + y), projected to the nodes",
             .scale = "|v(x_i)| of each node",
             .params = params},
    .cells = 16,
    .ppc = 4,
    .projection = true,
    .init = init,
    .place = place,
    .start = start,
    .exact = exact,
};
