/* cantilever.c: a 4 x 1 m beam held at its root and sheared at its end, for locking near
 * incompressibility: in plane strain, or 1 m thick with free sides.
 *
 * The end shear tau = .01 E, downwards, is spread as a body force over the last metre of the
 * reference body, so that every method and the FEM on any mesh solve the same problem:
 *   b_y = -(tau(t)/rho) 2 (X - 3)/1^2,  3 < X < 4,
 * whose sum over the beam's height is tau. It is linear, so that midpoints (particles) and
 * trapezoids (the FEM's lumped nodes) both give it exactly wherever a cell's side falls on X = 3.
 * load=end puts tau on the end face instead, as a traction of constant direction.
 * The shear grows linearly over one period T of the beam's lowest bending mode and is held then: at
 * t = T and after, a linear beam is at rest (the ramp excites nothing of that period).
 *   T = 2 pi/w, w = (1.8751/L)^2 sqrt(E' I/(rho H)), I = H^3/12,
 *   E' = E/(1 - nu^2) in plane strain, E in 3D.
 * By linear beam theory the tip sinks by 2.2 m under the full load at nu = .3: rotations are
 * large. */
#include <math.h>
#include "common/contract/layout.h"
#include "common/contract/problem.h"

enum { E, NU, SHEAR, LOAD };
enum { STRIP, END };
enum { RAMP, TAU }; /* s->k */

static const double length = 4, height = 1, strip = 1, rho = 1; /* [m] [m] [m] [kg/m^3] */

static const Param params[] = {
    {"E", 1e4, 1e-12, 1e15, "Pa", "Young's modulus", "", NULL},
    {"nu", 0.3, 0, 0.4999, "", "Poisson's ratio", "", NULL},
    {"shear", 0.01, 0, 0.1, "E", "end shear per height", "", NULL},
    {"load", STRIP, 0, 1, "",
     "the end shear: a body force over the last metre, or a traction on the "
     "end face",
     "W11 eq 3", "strip|end"},
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static int init(Scene *s, char why[128])
{
    (void)why;
    s->mat = material_make(NEO_HOOKEAN, s->par[E], s->par[NU], rho);
    const double nu = DIM > 2 ? 0 : s->par[NU], plane = s->par[E] / (1 - nu * nu),
                 inertia = pow(height, 3) / 12;
    const double w = pow(1.8751 / length, 2) * sqrt(plane * inertia / (rho * height));
    s->hi[0] = length + 1;
    s->lo[1] = -length;
    s->hi[1] = height + 1;
    s->body_hi[0] = length;
    s->body_hi[1] = height;
    if (DIM > 2) {
        s->lo[AXIS_LAST] = -1;
        s->hi[AXIS_LAST] = height + 1;
        s->body_hi[AXIS_LAST] = height;
    }
    s->wall[s->nwall++] = (Wall){.axis = 0, .side = -1, .at = 0, .hold = (1u << DIM) - 1};
    s->c = material_wave_speed_bound(&s->mat);
    s->k[RAMP] = s->t_end = 2 * M_PI / w;
    s->k[TAU] = s->par[SHEAR] * s->par[E];
    s->traction = s->par[LOAD] == (double)END;
    s->error_scale = 1;
    return 0;
}

/* [Pa] downwards. */
static double shear_at(const Scene *s, double t)
{
    return s->k[TAU] * fmin(t / s->k[RAMP], 1);
}

static void body(const Scene *s, int n, ConstFields X, double t, Fields b)
{
    const double tau = s->traction ? 0 : shear_at(s, t), scale = 2 * tau / (rho * strip * strip);
    for (int p = 0; p < n; p++) {
        const double into = X[0][p] - (length - strip);
        for (int d = 0; d < DIM; d++) b[d][p] = 0;
        b[1][p] = into > 0 ? -scale * into : 0;
    }
}

static void surface(const Scene *s, double spacing, Layout *out)
{
    layout_add_face(out, s, 0, 1, spacing, true);
}

static void traction(const Scene *s, int n, ConstFields X, ConstFields N, double t, Fields out)
{
    for (int p = 0; p < n; p++)
        for (int d = 0; d < DIM; d++)
            out[d][p] = d == 1 && N[0][p] > 0.5 && X[0][p] > 0.5 * length ? -shear_at(s, t) : 0;
}

const Problem problem_cantilever = {
    .info = {.name = "cantilever",
             .label = "cantilever",
             .about = "a beam bent by end shear: locking near incompressibility",
             .source = "",
             .params = params},
    .cells = 8,
    .ppc = IN_THIS_DIM(2, 4, 8),
    .cfl = 0.4,
    .init = init,
    .body = body,
    .surface = surface,
    .traction = traction,
};
