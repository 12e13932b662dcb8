/* burst_ring.c: a quarter ring, symmetry lines on both sides, under a pulse of pressure inside,
 * above what it holds (W11 section 6 names such ruptures, and the hand-over to GIMP that follows
 * them).
 *
 * The pressure is the nominal traction p sin^2(pi t/T), along the reference normals, for 0 < t < T,
 * T = L/c, L = 1 m; static, it would make the hoop stress 5/3 p at the inner radius and p on
 * average. Matter within weak_angle of the x axis bears the tension `weak` times `strength`, the
 * rest `strength`: the ring opens at the x axis first, on both sides, as its mirror images say. */
#include <math.h>
#include "circles.h"

enum { PRESSURE, STRENGTH, WEAK, WEAK_ANGLE };

static const Param params[] = {
    {"pressure", 0.2, 0, 0.5, "E", "height of the pulse of pressure inside", "", NULL},
    {"strength", 0.15, 0.001, 10, "E", "largest principal stress that the matter bears", "", NULL},
    {"weak", 0.5, 0.01, 1, "", "its share near the x axis", "", NULL},
    {"weak_angle", 5, 0, 45, "deg", "how near", "", NULL},
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static int init(Scene *s, char why[128])
{
    (void)why;
    s->mat = material_make(NEO_HOOKEAN, 1e4, 0, 1);
    s->c = material_wave_speed_bar(&s->mat);
    s->t_end = 4 / s->c;
    s->error_scale = NAN;
    s->traction = true;
    s->body = (Body){.kind = BODY_RING, .inner = 0.5, .outer = 1, .angle_hi = M_PI / 2};
    for (int d = 0; d < 2; d++) {
        s->hi[d] = 4;
        s->body_hi[d] = s->body.outer;
        s->wall[s->nwall++] = (Wall){.axis = d, .side = -1, .at = 0, .mirror = true};
    }
    return 0;
}

static bool inside(const Scene *s, const Vec X)
{
    const double R = hypot(X[0], X[1]);
    return R >= s->body.inner && R <= s->body.outer;
}

static void strength(const Scene *s, int n, ConstFields X, double out[])
{
    const double tangent = tan(s->par[WEAK_ANGLE] * M_PI / 180);
    for (int p = 0; p < n; p++)
        out[p] = s->par[STRENGTH] * s->mat.E * (X[1][p] < tangent * X[0][p] ? s->par[WEAK] : 1);
}

static void traction(const Scene *s, int n, ConstFields X, ConstFields N, double t, Fields out)
{
    const double phase = s->c * t;
    const double wave = phase > 0 && phase < 1 ? sin(M_PI * phase) : 0;
    for (int p = 0; p < n; p++) {
        const bool inner = hypot(X[0][p], X[1][p]) < 0.5 * (s->body.inner + s->body.outer);
        for (int d = 0; d < 2; d++)
            out[d][p] = inner ? -s->par[PRESSURE] * s->mat.E * wave * wave * N[d][p] : 0;
    }
}

const Problem problem_burst_ring = {
    .info = {.name = "burst_ring",
             .label = "Bursting ring",
             .about = "a ring that a pulse of pressure inside breaks: traction, tension cut-off",
             .source = "W11 section 6",
             .params = params},
    .cells = 32,
    .ppc = 4,
    .cfl = 0.2,
    .init = init,
    .inside = inside,
    .place = circles_place,
    .surface = circles_surface,
    .traction = traction,
    .strength = strength,
};
