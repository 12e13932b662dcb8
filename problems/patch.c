/* patch.c: projection of a linear velocity field from particles that are not ideal, or to nodes at
 * a body's edges: v = (1 + x + 2 y, 2 - x + y), in 3D v = (1 + x + 2 y + z, 2 - x + y + 3 z,
 * 1 + 2 x - y + z), with its exact gradient.
 *
 * Bodies of rectangles (in 3D of the same thickness along z as the block's side): a block, a strip
 * of one and a half cells, a concave corner, and a block in two with a gap of half a cell. All
 * edges are 0.3 cells off the grid's lines, or half a cell more or less. Particles are a lattice
 * from the rectangle's corner on, jittered (gsl_rng_taus2, fixed seed) or graded: denser to the
 * left. */
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

enum { SPACE = DIM > 2 ? 3 : 2 };
typedef struct Box {
    double lo[SPACE], hi[SPACE];
} Box;

/* Gradient of v [1/s]. */
static const double gradient[3][3] = {{1, 2, 1}, {-1, 1, 3}, {2, -1, 1}};

/* Fills in the body's rectangles. Returns how many there are. */
static int boxes(const Scene *s, Box out[2])
{
    const double h = s->cell, cells = round(0.3 / h); /* of half a side */
    const double lo = (floor(0.2 / h) + 0.3) * h, mid = lo + cells * h, hi = lo + 2 * cells * h;
    for (int d = 0; d < SPACE; d++) {
        out[0].lo[d] = out[1].lo[d] = lo;
        out[0].hi[d] = out[1].hi[d] = hi;
    }
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
        /* nodes within count */
        s->body_lo[d] = s->par[EDGES] > 0 ? 0 : box[0].lo[d % SPACE] + 2 * s->cell;
        s->body_hi[d] = s->par[EDGES] > 0 ? 1 : box[0].hi[d % SPACE] - 2 * s->cell;
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

/* Width of particle k of n along the graded axis, over that in an even row: the length that grading
 * gives to the particle's share of the axis, so that all particles together fill the box. */
static double graded_width(const Scene *s, int k, int n)
{
    if (!(s->par[GRADING] > 1)) return 1;
    return n * (graded(s, (k + 1.0) / n) - graded(s, (double)k / n));
}

static void fill(const Scene *s, const Box *b, double spacing, gsl_rng *random, Layout *out)
{
    double side[SPACE], volume = 1;
    int n[SPACE], total = 1;
    for (int d = 0; d < SPACE; d++) {
        side[d] = b->hi[d] - b->lo[d];
        n[d] = (int)fmax(round(side[d] / spacing), 1);
        volume *= side[d];
        total *= n[d];
    }
    for (int k = 0; k < total && !out->lost; k++) {
        Vec X = {0};
        for (int d = 0, rest = k; d < DIM && d < SPACE; rest /= n[d++]) {
            const double f = (rest % n[d] + 0.5) / n[d];
            const double moved = s->par[JITTER] * (2 * gsl_rng_uniform(random) - 1) / n[d];
            X[d] = b->lo[d] + side[d] * ((d ? f : graded(s, f)) + moved);
        }
        layout_add(out, X, volume / total * graded_width(s, k % n[0], n[0]), NULL);
    }
}

static bool is_in(const Box *b, const double at[SPACE])
{
    bool in = true;
    for (int d = 0; d < SPACE; d++) in = in && at[d] > b->lo[d] && at[d] < b->hi[d];
    return in;
}

/* Surface points at mid spacing on the face across `axis` that are not inside `other`. */
static void face(const Box *b, const Box *other, int axis, int side, double spacing, Layout *out)
{
    int n[SPACE], total = 1;
    for (int d = 0; d < SPACE; d++) {
        n[d] = d == axis ? 1 : (int)ceil((b->hi[d] - b->lo[d]) / spacing - 1e-9);
        total *= n[d];
    }
    for (int k = 0; k < total && !out->lost; k++) {
        double at[SPACE];
        Vec X = {0}, normal = {0};
        for (int d = 0, rest = k; d < SPACE; rest /= n[d++])
            at[d] = b->lo[d] + (rest % n[d] + 0.5) / n[d] * (b->hi[d] - b->lo[d]);
        at[axis] = side < 0 ? b->lo[axis] : b->hi[axis];
        for (int d = 0; d < DIM && d < SPACE; d++) {
            X[d] = at[d];
            normal[d] = d == axis ? side : 0;
        }
        at[axis] += side * 1e-6;
        if (!other || !is_in(other, at)) layout_add(out, X, 0, normal);
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
        for (int axis = 0; axis < SPACE; axis++)
            for (int side = -1; side <= 1; side += 2)
                face(&box[k], n > 1 ? &box[1 - k] : NULL, axis, side,
                     layout_surface_spacing(out, spacing), out);
    return true;
}

static void exact(const Scene *s, int n, ConstFields X, double t, Fields v)
{
    static const double at_origin[3] = {1, 2, 1};
    (void)s, (void)t;
    for (int p = 0; p < n; p++)
        for (int a = 0; a < DIM; a++) {
            double sum = at_origin[a];
            for (int b = 0; b < DIM; b++) sum += gradient[a][b] * X[b][p];
            v[a][p] = sum;
        }
}

static void start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    (void)u, (void)F;
    exact(s, n, X, 0, v);
    for (int a = 0; a < DIM; a++)
        for (int b = 0; b < DIM; b++)
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
    .ppc = IN_THIS_DIM(2, 4, 8),
    .projection = true,
    .init = init,
    .place = place,
    .start = start,
    .exact = exact,
};
