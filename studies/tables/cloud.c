/* cloud.c: see cloud.h. */
#include "cloud.h"

#include <math.h>
#include <stdlib.h>
#include "points.h"
#include "studies/measure.h"

typedef double Point[3]; /* X, Y, error */

/* The nearest of n points, if there are some on all sides within h; or NULL. */
static const double *nearest_inside(int n, Point point[], const double at[2], double h)
{
    const double *nearest = NULL;
    double best = INFINITY;
    int sides = 0;
    for (int k = 0; k < n; k++) {
        const double dx = point[k][0] - at[0], dy = point[k][1] - at[1], d = dx * dx + dy * dy;
        if (d > h * h) continue;
        sides |= 1 << ((dx > 0) + 2 * (dy > 0));
        if (d >= best) continue;
        best = d;
        nearest = point[k];
    }
    return sides == 15 ? nearest : NULL;
}

CloudErrors cloud_compare(const Table *mesh, const Table *particles, double h)
{
    const Table *file[2] = {mesh, particles};
    CloudErrors e = {.nodes = mesh->nrow};
    Point *point[2];
    for (int c = 0; c < 2; c++) {
        point[c] = (Point *)points_all(file[c], "X Y error");
        for (int k = 0; k < file[c]->nrow; k++) e.all[c] = measure_worse(e.all[c], point[c][k][2]);
    }
    for (int k = 0; k < mesh->nrow; k++) {
        const double *node = point[0][k];
        const double *other = nearest_inside(particles->nrow, point[1], node, h);
        const double error[2] = {node[2], other ? other[2] : 0};
        e.pairs += other != NULL;
        for (int c = 0; c < 2 && other; c++) {
            e.linf[c] = measure_worse(e.linf[c], error[c]);
            e.l1[c] += error[c];
        }
    }
    for (int c = 0; c < 2; c++) {
        e.l1[c] /= e.pairs;
        free(point[c]);
    }
    return e;
}
