/* wls_squares.c: see wls_squares.h. W11 3.4.3, fig 2; Lorensen & Cline 1987. */
#include <stdbool.h>
#include "wls_squares.h"

/* Corners counter-clockwise, as numbers of distance[]. */
static const int around[4] = {0, 1, 3, 2};
static const double corner_x[4] = {0, 1, 0, 1}, corner_y[4] = {0, 0, 1, 1};

static void add(Polygon *p, double x, double y)
{
    p->x[p->n][0] = x;
    p->x[p->n++][1] = y;
}

/* Where the edge from corner a to corner b leaves the shape or enters it, eq 18. */
static void add_cut(Polygon *p, const double d[4], int a, int b)
{
    const double t = d[a] / (d[a] - d[b]);
    add(p, corner_x[a] + t * (corner_x[b] - corner_x[a]),
        corner_y[a] + t * (corner_y[b] - corner_y[a]));
}

/* The triangle that holds corner `k` of the walk alone. */
static void one_corner(Polygon *p, const double d[4], int k)
{
    const int own = around[k], before = around[(k + 3) % 4], after = around[(k + 1) % 4];
    add_cut(p, d, before, own);
    add(p, corner_x[own], corner_y[own]);
    add_cut(p, d, own, after);
}

int square_pieces(const double distance[4], Polygon piece[MAX_PIECES])
{
    const double *d = distance;
    const bool in[4] = {d[0] > 0, d[1] > 0, d[2] > 0, d[3] > 0};
    const bool saddle = in[0] == in[3] && in[1] == in[2] && in[0] != in[1];
    int n = 0;
    piece[0].n = piece[1].n = 0;
    if (saddle && !(d[0] + d[1] + d[2] + d[3] > 0)) {
        for (int k = 0; k < 4; k++)
            if (in[around[k]]) one_corner(&piece[n++], d, k);
        return n;
    }
    for (int k = 0; k < 4; k++) {
        const int a = around[k], b = around[(k + 1) % 4];
        if (in[a]) add(&piece[0], corner_x[a], corner_y[a]);
        if (in[a] != in[b]) add_cut(&piece[0], d, a, b);
    }
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

/* A fan about the centroid, so that mirrored shapes have mirrored points. */
int polygon_points(const Polygon *p, double x[MAX_SQUARE_POINTS][2],
                   double weight[MAX_SQUARE_POINTS])
{
    double centre[2];
    int n = 0;
    if (p->n == 3) return triangle_points(p->x[0], p->x[1], p->x[2], x, weight);
    if (!(polygon_area(p, centre) > 0)) return 0;
    for (int k = 0; k < p->n; k++)
        n += triangle_points(centre, p->x[k], p->x[(k + 1) % p->n], x + n, weight + n);
    return n;
}
