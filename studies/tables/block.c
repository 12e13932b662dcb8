/* block.c: see block.h. */
#include "block.h"

#include <math.h>
#include "points.h"

/* T/J with T = mu (F F^T - 1) + lambda ln J; turning the block changes nothing. */
double block_stress(const Block *b)
{
    const double E = 1e4, nu = b->dim > 1 ? 0.3 : 0, mu = E / (2 + 2 * nu);
    const double lambda = E * nu / ((1 + nu) * (1 - 2 * nu)), across = lambda * log(b->stretch);
    const double along = mu * (b->stretch * b->stretch - 1) + across;
    return sqrt(along * along + (b->dim - 1) * across * across) / b->stretch;
}

bool block_force(const Block *b, const Table *nodes, int i, double f[3])
{
    const double h = 1.0 / b->cells, a = b->degrees * M_PI / 180;
    const double unit = block_stress(b) * pow(h, b->dim - 1), dt = BLOCK_CFL * h / BLOCK_SPEED;
    const double mass = select_number(nodes, i, "mass");
    double x[3], v[3];
    points_row(nodes, i, "x y z", x);
    points_row(nodes, i, "vx vy vz", v);
    v[0] -= b->speed;
    for (int d = 0; d < 3; d++) {
        x[d] = d < b->dim ? x[d] - 1.5 - b->offset[d] * h : 0;
        f[d] = d < b->dim ? v[d] * mass / (dt * unit) : 0;
    }
    const double own[] = {(cos(a) * x[0] + sin(a) * x[1]) / b->stretch,
                          cos(a) * x[1] - sin(a) * x[0], x[2]};
    return fmax(fmax(fabs(own[0]), fabs(own[1])), fabs(own[2])) < 0.5 - 4 * h;
}
