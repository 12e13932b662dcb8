/* polygon.c: see polygon.h. W11 3.4.3, fig 2; Lorensen & Cline 1987. */
#include <math.h>
#include <stddef.h>
#include "polygon.h"

/* Corners counter-clockwise, as numbers of distance[]. */
static const int around[4] = {0, 1, 3, 2};
static const double corner_x[4] = {0, 1, 0, 1}, corner_y[4] = {0, 0, 1, 1};

static void add(Polygon *p, double x, double y)
{
    p->x[p->n][0] = x;
    p->x[p->n++][1] = y;
}

/* The curvature of the boundary where it crosses the edge from corner a to corner b, and the
 * square of the edge's part along the boundary. */
static double edge_curvature(const Curved *c, int a, int b, double *along)
{
    double n[2], square = 0;
    for (int d = 0; d < 2; d++) {
        n[d] = c->normal[a][d] + c->normal[b][d];
        square += n[d] * n[d];
    }
    if (!(square > 0)) return *along = 0;
    const int axis = corner_x[a] < corner_x[b] || corner_x[a] > corner_x[b] ? 0 : 1;
    *along = 1 - n[axis] * n[axis] / square;
    return 0.5 * (c->kappa[a] + c->kappa[b]);
}

double polygon_cut(double in, double out, double bulge)
{
    const double slope = out - in + bulge;
    return 2 * in / (sqrt(slope * slope + 4 * bulge * in) - slope);
}

/* Where the edge from corner a to corner b leaves the shape or enters it, eq 18, with a bulge of
 * (kappa/2) t_e^2. */
static void add_cut(Polygon *p, const double d[4], const Curved *c, int a, int b)
{
    double along = 0;
    const double kappa = c ? edge_curvature(c, a, b, &along) : 0, bulge = 0.5 * kappa * along;
    const double s = polygon_cut(d[a] > 0 ? d[a] : d[b], d[a] > 0 ? d[b] : d[a], bulge);
    const double t = d[a] > 0 ? s : 1 - s;
    add(p, corner_x[a] + t * (corner_x[b] - corner_x[a]),
        corner_y[a] + t * (corner_y[b] - corner_y[a]));
}

/* The triangle that holds corner `k` of the walk alone. */
static void one_corner(Polygon *p, const double d[4], int k)
{
    const int own = around[k], before = around[(k + 3) % 4], after = around[(k + 1) % 4];
    add_cut(p, d, NULL, before, own);
    add(p, corner_x[own], corner_y[own]);
    add_cut(p, d, NULL, own, after);
}

/* The middle of the chord from corner `at` of p to the next, moved outward by kappa l^2/6, becomes
 * corner 0: the area gained is kappa l^3/12, that of the circular segment. */
static void bend_chord(Polygon *p, int at, double kappa)
{
    const double *a = p->x[at], *b = p->x[(at + 1) % p->n];
    const double x = b[0] - a[0], y = b[1] - a[1], out = kappa * sqrt(x * x + y * y) / 6;
    Polygon q = {1, true, {{0.5 * (a[0] + b[0]) + out * y, 0.5 * (a[1] + b[1]) - out * x}}};
    for (int k = 1; k <= p->n; k++) add(&q, p->x[(at + k) % p->n][0], p->x[(at + k) % p->n][1]);
    *p = q;
}

/* One piece of all corners inside and all cuts. Its chord, if it has one only, may be bent. */
static void whole_piece(Polygon *p, const double d[4], const Curved *c, bool one_chord)
{
    int exit = -1;
    double kappa = 0, unused;
    for (int k = 0; k < 4; k++) {
        const int a = around[k], b = around[(k + 1) % 4];
        const bool in = d[a] > 0, next = d[b] > 0;
        if (in) add(p, corner_x[a], corner_y[a]);
        if (in == next) continue;
        if (in) exit = p->n;
        add_cut(p, d, c, a, b);
        if (c) kappa += 0.5 * edge_curvature(c, a, b, &unused);
    }
    if (one_chord && exit >= 0 && fabs(kappa) > 0) bend_chord(p, exit, kappa);
}

int polygon_pieces(const double distance[4], const Curved *curved, Polygon piece[MAX_PIECES])
{
    const double *d = distance;
    const bool in[4] = {d[0] > 0, d[1] > 0, d[2] > 0, d[3] > 0};
    const bool saddle = in[0] == in[3] && in[1] == in[2] && in[0] != in[1];
    int n = 0;
    piece[0] = piece[1] = (Polygon){0};
    if (saddle && !(d[0] + d[1] + d[2] + d[3] > 0)) {
        for (int k = 0; k < 4; k++)
            if (in[around[k]]) one_corner(&piece[n++], d, k);
        return n;
    }
    whole_piece(&piece[0], d, saddle ? NULL : curved, !saddle);
    return piece[0].n > 0;
}

/* Twice the area of the triangle of corners 0, k, k + 1. */
static double twice_fan(const Polygon *p, int k)
{
    const double ax = p->x[k][0] - p->x[0][0], ay = p->x[k][1] - p->x[0][1];
    const double bx = p->x[k + 1][0] - p->x[0][0], by = p->x[k + 1][1] - p->x[0][1];
    return ax * by - ay * bx;
}

double polygon_area(const Polygon *p, double centroid[2])
{
    double area = 0, sum[2] = {0, 0};
    for (int k = 1; k + 1 < p->n; k++) {
        const double a = 0.5 * twice_fan(p, k);
        area += a;
        for (int d = 0; d < 2; d++) sum[d] += a * (p->x[0][d] + p->x[k][d] + p->x[k + 1][d]) / 3;
    }
    for (int d = 0; d < 2 && area > 0; d++) centroid[d] = sum[d] / area;
    return area;
}

/* The three points of one triangle. */
static int triangle_points(const double *a, const double *b, const double *c, double x[][2],
                           double weight[])
{
    const double *corner[3] = {a, b, c};
    const double twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    for (int q = 0; q < 3; q++) {
        weight[q] = twice / 6;
        for (int d = 0; d < 2; d++) x[q][d] = (a[d] + b[d] + c[d] + 3 * corner[q][d]) / 6;
    }
    return 3;
}

/* A fan about the centroid, or the bulge, so that mirrored shapes have mirrored points. */
int polygon_points(const Polygon *p, double x[MAX_SQUARE_POINTS][2],
                   double weight[MAX_SQUARE_POINTS])
{
    double centre[2];
    int n = 0;
    if (p->n == 3) return triangle_points(p->x[0], p->x[1], p->x[2], x, weight);
    if (!(polygon_area(p, centre) > 0)) return 0;
    for (int k = 1; p->bent && k + 1 < p->n; k++)
        n += triangle_points(p->x[0], p->x[k], p->x[k + 1], x + n, weight + n);
    if (p->bent) return n;
    for (int k = 0; k < p->n; k++)
        n += triangle_points(centre, p->x[k], p->x[(k + 1) % p->n], x + n, weight + n);
    return n;
}
