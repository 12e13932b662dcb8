/* polyhedron.c: see polyhedron.h. W11 3.4; Lorensen & Cline 1987, without their table: the six
 * sides of the cube are cut like squares. Each chord that closes such a polygon runs from an edge
 * that leaves the shape to one that enters it. Every cut edge belongs to two sides, in opposite
 * directions. Therefore the chords, reversed, form closed loops, the boundaries of the cut faces.
 */
#include <math.h>
#include <string.h>
#include "polygon.h"
#include "polyhedron.h"

enum { CORNER = 8, VERTICES = POLYHEDRON_VERTICES };

static double along(const CurvatureTensor K, const double u[3])
{
    double sum = 0;
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++) sum += u[a] * K[tensor_index(a, b)] * u[b];
    return sum;
}

/* Corner k of a side (axis, near or far), counter-clockwise from outside. */
static int side_corner(int side, int k)
{
    const int axis = side >> 1, far = side & 1, turn = far ? k : 3 - k;
    const int b = turn == 1 || turn == 2, c = turn > 1;
    return far << axis | b << (axis + 1) % 3 | c << (axis + 2) % 3;
}

/* The axis of the edge between two corners; the number of its cut. */
static int edge_axis(int a, int b)
{
    return (a ^ b) >> 1;
}

static int cut_of(int a, int b)
{
    const int axis = edge_axis(a, b), near = a & b;
    return CORNER + 4 * axis + (near >> (axis + 1) % 3 & 1) + 2 * (near >> (axis + 2) % 3 & 1);
}

static void place_cut(Polyhedron *p, const double d[8], const CurvatureTensor *K, int in, int out)
{
    const int axis = edge_axis(in, out), own = tensor_index(axis, axis);
    const double bulge = K ? 0.25 * (K[in][own] + K[out][own]) : 0;
    const double t = polygon_cut(d[in], d[out], bulge);
    double *x = p->x[cut_of(in, out)];
    for (int a = 0; a < 3; a++) x[a] = in >> a & 1;
    x[axis] = in >> axis & 1 ? 1 - t : t;
}

static Face *new_face(Polyhedron *p, bool cut)
{
    Face *f = &p->face[p->faces++];
    *f = (Face){.cut = cut};
    return f;
}

/* Closes a polygon of a side: its vertices become one piece, and its chords go to next[], reversed.
 */
static void close_side(Polyhedron *p, const Face *f, int next[VERTICES])
{
    for (int k = 0; k < f->sides; k++) {
        const int v = f->vertex[k], after = f->vertex[(k + 1) % f->sides];
        const int old = p->piece[after], own = p->piece[v];
        if (v >= CORNER && after >= CORNER) next[after] = v;
        for (int j = 0; j < VERTICES && old != own; j++)
            if (p->piece[j] == old) p->piece[j] = own;
    }
}

static void add_side(Polyhedron *p, const double d[8], int side, int next[VERTICES])
{
    int c[4];
    bool in[4];
    for (int k = 0; k < 4; k++) c[k] = side_corner(side, k), in[k] = d[c[k]] > 0;
    const bool saddle = in[0] == in[2] && in[1] == in[3] && in[0] != in[1];
    if (saddle && !((d[c[0]] + d[c[2]]) + (d[c[1]] + d[c[3]]) > 0)) {
        for (int k = in[0] ? 0 : 1; k < 4; k += 2) {
            Face *f = new_face(p, false);
            f->vertex[f->sides++] = cut_of(c[(k + 3) % 4], c[k]);
            f->vertex[f->sides++] = c[k];
            f->vertex[f->sides++] = cut_of(c[k], c[(k + 1) % 4]);
            close_side(p, f, next);
        }
        return;
    }
    if (!in[0] && !in[1] && !in[2] && !in[3]) return;
    Face *f = new_face(p, false);
    for (int k = 0; k < 4; k++) {
        if (in[k]) f->vertex[f->sides++] = c[k];
        if (in[k] != in[(k + 1) % 4]) f->vertex[f->sides++] = cut_of(c[k], c[(k + 1) % 4]);
    }
    close_side(p, f, next);
}

static void add_loops(Polyhedron *p, int next[VERTICES])
{
    for (int v = CORNER; v < VERTICES; v++) {
        if (next[v] < 0) continue;
        Face *f = new_face(p, true);
        for (int k = v; next[k] >= 0;) {
            const int after = next[k];
            f->vertex[f->sides++] = k;
            next[k] = -1;
            k = after;
        }
    }
}

/* Pieces are numbered in the order of their faces. */
static void number_pieces(Polyhedron *p)
{
    int number[VERTICES];
    for (int v = 0; v < VERTICES; v++) number[v] = -1;
    for (int k = 0; k < p->faces; k++) {
        int *own = &number[p->piece[p->face[k].vertex[0]]];
        if (*own < 0) *own = p->pieces++;
        p->face[k].piece = *own;
    }
    for (int v = 0; v < VERTICES; v++) p->piece[v] = number[p->piece[v]];
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

/* Corner k of a face from its apex. */
static void spoke(const Polyhedron *p, const Face *f, int k, double u[3])
{
    for (int a = 0; a < 3; a++) u[a] = p->x[f->vertex[k % f->sides]][a] - f->apex[a];
}

/* Raises the apex of a cut face from the mean of its vertices onto the curved surface, and then
 * further, until the fan encloses as much as the surface: between each triangle and the surface
 * lies the volume A_t/24 sum_edges e.K.e, and an apex raised by z adds z A/3. */
static void raise_apex(const Polyhedron *p, Face *f, const CurvatureTensor K)
{
    double normal[3] = {0}, area = 0, lift = 0, gap = 0;
    for (int k = 0; k < f->sides; k++) {
        double u[3], v[3], e[3], n[3];
        spoke(p, f, k, u);
        spoke(p, f, k + 1, v);
        cross(u, v, n);
        for (int a = 0; a < 3; a++) e[a] = v[a] - u[a], normal[a] += 0.5 * n[a];
        const double triangle = 0.5 * sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        area += triangle;
        lift += along(K, u) / (2 * f->sides);
        gap += triangle / 24 * (along(K, u) + along(K, v) + along(K, e));
    }
    const double length =
        sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    if (!(area > 0) || !(length > 0)) return;
    for (int a = 0; a < 3; a++) f->apex[a] += (lift + 3 * gap / area) * normal[a] / length;
}

/* Mean curvature tensor of the edges that a cut face ends on. */
static void face_curvature(const Face *f, const CurvatureTensor *K, CurvatureTensor mean)
{
    memset(mean, 0, sizeof(CurvatureTensor));
    for (int k = 0; k < f->sides; k++) {
        const int cut = f->vertex[k] - CORNER, axis = cut / 4;
        const int near = (cut & 1) << (axis + 1) % 3 | (cut >> 1 & 1) << (axis + 2) % 3;
        for (int j = 0; j < 6; j++)
            mean[j] += (K[near][j] + K[near | 1 << axis][j]) / (2 * f->sides);
    }
}

static void set_apex(const Polyhedron *p, Face *f, const CurvatureTensor *curvature)
{
    CurvatureTensor K;
    for (int k = 0; k < f->sides; k++)
        for (int a = 0; a < 3; a++) f->apex[a] += p->x[f->vertex[k]][a] / f->sides;
    if (!f->cut || !curvature) return;
    face_curvature(f, curvature, K);
    raise_apex(p, f, K);
}

void polyhedron_make(const double distance[8], const CurvatureTensor *curvature, Polyhedron *out)
{
    int next[VERTICES];
    out->pieces = out->faces = 0;
    for (int v = 0; v < VERTICES; v++) next[v] = -1, out->piece[v] = v;
    for (int k = 0; k < CORNER; k++)
        for (int a = 0; a < 3; a++) {
            const int far = k | 1 << a;
            out->x[k][a] = k >> a & 1;
            if (far == k || (distance[k] > 0) == (distance[far] > 0)) continue;
            if (distance[k] > 0)
                place_cut(out, distance, curvature, k, far);
            else
                place_cut(out, distance, curvature, far, k);
        }
    for (int side = 0; side < 6; side++) add_side(out, distance, side, next);
    add_loops(out, next);
    number_pieces(out);
    for (int k = 0; k < out->faces; k++) set_apex(out, &out->face[k], curvature);
}
