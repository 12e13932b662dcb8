/* sliding_block.c: a block on an incline, which slides or sticks by Coulomb friction (Bardenhagen
 * et al. 2001).
 *
 * The base, a second body, is held and lies along x; gravity is turned by `angle` instead. The
 * centre of mass of the block moves as a rigid body does:
 *   u_x = a t^2/2,  a = max(0, g (sin angle - mu cos angle)).
 * It starts in the strain of a column that moves so (nu = 0, first order in the strain, which is
 * below .02 %), so that it neither bounces nor waits until shear has built up: at the depth s below
 * its top F_yy = 1 - rho g cos(angle) s/E and F_xy = f rho g cos(angle) s/G with f = min(mu, tan
 * angle) and G = E/2. Only at its sides, which carry no stress, this is no equilibrium. */
#include <math.h>
#include "contact.h"

enum { ANGLE = CONTACT_PARAMS, E };

static const double rho = 1000, g = 10;                                      /* [kg/m^2] [m/s^2] */
static const double ground = 0.5, block_from = 0.5, width = 1, height = 0.5; /* [m] */

static const Param params[] = {
    CONTACT_PARAM_LIST(0),
    {"angle", 20, 0, 60, "degrees", "of the incline", "", NULL},
    {"E", 5e7, 1e5, 1e12, "Pa", "Young's modulus of both bodies; Poisson's ratio is 0", "", NULL},
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static double slope(const Scene *s)
{
    return s->par[ANGLE] * M_PI / 180;
}

static int init(Scene *s, char why[128])
{
    (void)why;
    contact_read(s);
    s->mat = material_make(NEO_HOOKEAN, s->par[E], 0, rho);
    s->lo[0] = s->lo[1] = -0.5;
    s->hi[0] = 3.5;
    s->hi[1] = 2;
    s->body_hi[0] = 3;
    s->body_hi[1] = ground + height;
    s->c = material_wave_speed_bound(&s->mat);
    s->t_end = 0.5;
    s->error_scale = 1;
    return 0;
}

static bool in_block(const Scene *s, double x, double y)
{
    (void)s;
    return x >= block_from && x <= block_from + width && y >= ground;
}

static void part(Scene *s, int body)
{
    if (body == 0) {
        s->body_lo[0] = block_from;
        s->body_hi[0] = block_from + width;
        s->body_lo[1] = ground;
        return;
    }
    s->body_hi[1] = ground;
    for (int side = -1; side <= 1; side += 2) /* nodes on both sides of a line: all */
        s->wall[s->nwall++] = (Wall){.axis = 1, .side = side, .at = 0, .hold = (1u << DIM) - 1};
}

/* [1/m] Compression and shear strain per metre of depth. */
static void strains(const Scene *s, double *press, double *shear)
{
    *press = rho * g * cos(slope(s)) / s->par[E];
    *shear = 2 * fmin(s->friction, tan(slope(s))) * *press;
}

static void start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    double press, shear;
    (void)v, (void)L;
    strains(s, &press, &shear);
    for (int p = 0; p < n; p++) {
        const double up = X[1][p] - ground, deep = height - up;
        if (!in_block(s, X[0][p], X[1][p])) continue;
        u[0][p] = shear * (height - 0.5 * up) * up;
        u[1][p] = -press * (height - 0.5 * up) * up;
        F[1][p] = shear * deep;
        F[NMAT - 1][p] -= press * deep;
    }
}

static void exact(const Scene *s, int n, ConstFields X, double t, Fields u)
{
    const double a = fmax(0, g * (sin(slope(s)) - s->friction * cos(slope(s))));
    double press, shear;
    strains(s, &press, &shear);
    for (int p = 0; p < n; p++) {
        const bool moves = in_block(s, X[0][p], X[1][p]);
        const double up = X[1][p] - ground, bent = (height - 0.5 * up) * up;
        u[0][p] = moves ? 0.5 * a * t * t + shear * bent : 0;
        u[1][p] = moves ? -press * bent : 0;
    }
}

static void body(const Scene *s, int n, ConstFields X, double t, Fields b)
{
    const double along = g * sin(slope(s)), across = -g * cos(slope(s));
    (void)t;
    for (int p = 0; p < n; p++) {
        const bool moves = in_block(s, X[0][p], X[1][p]);
        b[0][p] = moves ? along : 0;
        b[1][p] = moves ? across : 0;
    }
}

const Problem problem_sliding_block = {
    .info = {.name = "sliding_block",
             .label = "sliding block",
             .about = "a block slides down an incline, or sticks, by Coulomb friction",
             .source = "Bardenhagen et al. 2001",
             .formula = "u_x = t^2/2 max(0, g (sin angle - mu cos angle)) of the block's centre",
             .scale = "1 m",
             .params = params},
    .cells = 16,
    .ppc = 4,
    .cfl = 0.4,
    .init = init,
    .part = part,
    .start = start,
    .exact = exact,
    .body = body,
};
