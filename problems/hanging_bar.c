/* hanging_bar.c: a 1 x 1 m block that hangs from its top and falls into its own weight, applied at
 * once (plane strain): stretches beyond 2 (Sadeghirad, Brannon & Burghardt 2011).
 *
 * Top nodes are held, sides and bottom are free; the box leaves room for a stretch of 4. A linear
 * bar would sink by up to 2 (rho g H^2/(2 E')) and come back in 4 H/c. */
#include <math.h>
#include "common/contract/problem.h"

enum { E, NU, RHO, GRAVITY };

static const double top = 4; /* [m] on a grid line of every mesh */

static const Param params[] = {
    {"E", 1e6, 1e-12, 1e15, "Pa", "Young's modulus", "Sadeghirad et al. 2011", NULL},
    {"nu", 0.3, 0, 0.49, "", "Poisson's ratio", "Sadeghirad et al. 2011", NULL},
    {"rho", 1050, 1e-12, 1e15, "kg/m^3", "density", "Sadeghirad et al. 2011", NULL},
    {"g", 1000, 0, 1e6, "m/s^2", "gravity", "Sadeghirad et al. 2011", NULL},
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static int init(Scene *s, char why[128])
{
    (void)why;
    s->mat = material_make(NEO_HOOKEAN, s->par[E], s->par[NU], s->par[RHO]);
    s->lo[0] = -1;
    s->hi[0] = 2;
    s->hi[1] = top;
    s->body_hi[0] = 1;
    s->body_lo[1] = top - 1;
    s->body_hi[1] = top;
    s->wall[s->nwall++] = (Wall){.axis = 1, .side = 1, .at = top, .hold = (1u << DIM) - 1};
    s->c = material_wave_speed_bound(&s->mat);
    s->t_end = 0.25;
    s->error_scale = 1;
    return 0;
}

static void body(const Scene *s, int n, ConstFields X, double t, Fields b)
{
    (void)X, (void)t;
    for (int p = 0; p < n; p++) b[0][p] = 0, b[1][p] = -s->par[GRAVITY];
}

const Problem problem_hanging_bar = {
    .info = {.name = "hanging_bar",
             .label = "hanging bar",
             .about = "a block stretched to more than twice its length by its own weight",
             .source = "Sadeghirad et al. 2011",
             .params = params},
    .cells = 16,
    .ppc = 4,
    .cfl = 0.2,
    .init = init,
    .body = body,
};
