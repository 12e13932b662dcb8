/* free_block.c: a free neo-Hookean unit block that rotates, drifts and oscillates in an empty box;
 * the scene of the bench, of free flight and of rotation tests. In 1D the same along its first
 * axis; in 3D a cube, alike along z, whose faces across z are free.
 *
 *   v(X) = w (-Y, X) + (.03, .02) c + .05 c cos 3X cos 2Y (.2 X/(.1 + X^2 + Y^2), Y)
 * with X, Y from the centre, w = .2 c/.7071 (corner speed .2 c) and c of W11 eq 33. */
#include <math.h>
#include "common/contract/problem.h"

enum { BOX, SPIN, DRIFT, SWING };

static const Param params[] = {
    {"box", 1.5, 1, 1000, "m", "width of the empty square around the block", "", NULL},
    {"spin", 1, -10, 10, "", "factor of the rotation", "", NULL},
    {"drift", 1, -10, 10, "", "factor of the uniform motion", "", NULL},
    {"swing", 1, -10, 10, "", "factor of the oscillation", "", NULL},
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static int init(Scene *s, char why[128])
{
    (void)why;
    s->mat = material_make(NEO_HOOKEAN, 1e4, DIM == 1 ? 0 : 0.3, 1);
    for (int d = 0; d < DIM; d++) {
        s->hi[d] = s->par[BOX];
        s->body_lo[d] = 0.5 * s->par[BOX] - 0.5;
        s->body_hi[d] = 0.5 * s->par[BOX] + 0.5;
    }
    s->c = material_wave_speed_bound(&s->mat);
    s->error_scale = 1;
    return 0;
}

/* Oscillation (.2 x/D, y) g with g = cos 3x cos 2y, D = .1 + x^2 + y^2, and its gradient. */
static void swing(double x, double y, double v[2], double L[4])
{
    const double g = cos(3 * x) * cos(2 * y), D = 0.1 + x * x + y * y, a = 0.2 * x / D;
    const double gx = -3 * sin(3 * x) * cos(2 * y), gy = -2 * cos(3 * x) * sin(2 * y);
    v[0] = g * a;
    v[1] = g * y;
    L[0] = gx * a + g * (0.2 / D - 0.4 * x * x / (D * D));
    L[1] = gy * a - g * 0.4 * x * y / (D * D);
    L[2] = gx * y;
    L[3] = gy * y + g;
}

static void start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    const double c = s->c, w = s->par[SPIN] * 0.2 * c / 0.7071, k = s->par[SWING] * 0.05 * c;
    const double drift[] = {s->par[DRIFT] * 0.03 * c, s->par[DRIFT] * 0.02 * c};
    (void)u, (void)F;
    for (int p = 0; p < n; p++) {
        const double middle = 0.5 * s->par[BOX], x = X[0][p] - middle;
        const double y = DIM > 1 ? X[AXIS_Y][p] - middle : 0;
        const double spin[] = {-w * y, w * x}, turn[] = {0, -w, w, 0};
        double osc[2], grad[4];
        swing(x, y, osc, grad);
        for (int a = 0; a < DIM && a < 2; a++) {
            v[a][p] = spin[a] + drift[a] + k * osc[a];
            for (int b = 0; b < DIM && b < 2; b++)
                L[a * DIM + b][p] = turn[2 * a + b] + k * grad[2 * a + b];
        }
    }
}

const Problem problem_free_block = {
    .info = {.name = "free_block",
             .label = "free block",
             .about = "a free block rotates, drifts and oscillates in an empty box",
             .source = "",
             .params = params},
    .cells = 128,
    .ppc = IN_THIS_DIM(4, 4, 8),
    .cfl = 0.3,
    .steps = 100,
    .init = init,
    .start = start,
};
