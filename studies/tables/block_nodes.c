/* block_nodes.c: see block_nodes.h. */
#include "block_nodes.h"

#include <math.h>
#include "grades.h"
#include "studies/select.h"

/* |sigma| of sigma = T/J, T = mu (F F^T - 1) + lambda ln J, F a stretch along x; turning it changes
 * nothing. */
static double stress_of(int dim, double stretch)
{
    const double E = 1e4, nu = dim > 1 ? 0.3 : 0, mu = E / (2 + 2 * nu); /* problems/block.c */
    const double lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
    const double along = mu * (stretch * stretch - 1) + lambda * log(stretch);
    const double across = sqrt(dim - 1) * lambda * log(stretch);
    return hypot(along, across) / stretch;
}

static bool counts(const BlockNodes *b, const double place[3])
{
    const double a = b->angle * M_PI / 180, *x = place;
    return fabs(cos(a) * x[0] + sin(a) * x[1]) / b->stretch < b->inner &&
           fabs(cos(a) * x[1] - sin(a) * x[0]) < b->inner && fabs(x[2]) < b->inner;
}

bool block_node_force(const BlockNodes *b, const Table *nodes, int row, double place[3],
                      double force[3])
{
    static const char *const axes[] = {"x", "y", "z"}, *const velocities[] = {"vx", "vy", "vz"};
    const double h = 1.0 / b->cells, dt = BLOCK_CFL * h / BLOCK_SPEED;
    const double unit = stress_of(b->dim, b->stretch) * pow(h, b->dim - 1);
    const double m = select_number(nodes, row, "mass") / (dt * unit);
    for (int a = 0; a < 3; a++) {
        const double V = a == 0 ? b->drift * BLOCK_SPEED : 0;
        const double moved = b->shift && a < b->dim ? b->shift[a] * h : 0;
        place[a] = force[a] = 0;
        if (a >= b->dim) continue;
        place[a] = select_number(nodes, row, axes[a]) - b->box / 2 - moved;
        force[a] = m * (select_number(nodes, row, velocities[a]) - V);
    }
    return counts(b, place);
}

double block_nodes_largest(const BlockNodes *b, const Table *nodes)
{
    double most = -INFINITY, place[3], force[3];
    for (int row = 0; row < nodes->nrow; row++)
        for (int a = 0; a < 3 && block_node_force(b, nodes, row, place, force); a++)
            most = measure_worse(most, fabs(force[a]));
    return isinf(most) ? NAN : most;
}
