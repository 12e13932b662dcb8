/* block.c: a unit block in an empty box, in the simplest states of motion and stress; the scene of
 * many hard cases.
 *
 *   free motion     x = X + (F - I)(X - X_c) + offset, uniform F = R(angle) [stretch 0; 0 1],
 *                   uniform velocity, plus velocities that alternate from particle to particle
 *                   (ripple), which the grid cannot see. Inside, no force acts but gravity.
 *   imposed motion  spin or rate is not 0: in every step v = w (-y, x) or v = rate (x, 0) at the
 *                   current position, and there is no stress.
 *
 * Coordinates about the block's centre. In 1D the same along its only axis; in 3D it is turned
 * and spins about z. */
#include <math.h>
#include <string.h>
#include "common/contract/problem.h"

enum {
    BOX,
    STRETCH,
    ANGLE,
    OFFSET_X,
    OFFSET_Y,
    DRIFT_X,
    DRIFT_Y,
    GRAVITY,
    RIPPLE,
    SPIN,
    RATE,
    OFFSET_Z,
    DRIFT_Z,
    PARAMS
};

enum { SPACE = DIM > 2 ? 3 : 2 }; /* axes of the tables below */
typedef double Square[SPACE][SPACE];

static const Param params[PARAMS + 1] = {
    {"box", 3, 1, 1000, "m", "width of the empty square around the block", "", NULL},
    {"stretch", 1, 0.01, 100, "", "initial stretch along x", "", NULL},
    {"angle", 0, -360, 360, "degrees", "rotation of the stretched block (2D, 3D)", "", NULL},
    {"offset_x", 0, -1, 1, "h", "initial offset of the block on the grid along x", "", NULL},
    {"offset_y", 0, -1, 1, "h", "initial offset of the block on the grid along y", "", NULL},
    {"drift_x", 0, -10, 10, "c", "uniform velocity along x", "", NULL},
    {"drift_y", 0, -10, 10, "c", "uniform velocity along y", "", NULL},
    {"gravity", 0, -1e9, 1e9, "m/s^2", "body force per mass along the last axis, downwards", "",
     NULL},
    {"ripple", 0, -1, 1, "c", "velocity added with a sign that alternates between neighbours", "",
     NULL},
    {"spin", 0, -10, 10, "c/m", "imposed: angular velocity (2D, 3D)", "", NULL},
    {"rate", 0, -10, 10, "c/m", "imposed: rate of stretch along x", "", NULL},
    /* A list ends with a NULL name: in 1D and 2D here. */
    {DIM > 2 ? "offset_z" : NULL, 0, -1, 1, "h", "initial offset along z", "", NULL},
    {"drift_z", 0, -10, 10, "c", "uniform velocity along z", "", NULL},
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static bool is_imposed(const Scene *s)
{
    return fabs(s->par[SPIN]) > 0 || fabs(s->par[RATE]) > 0;
}

static int init(Scene *s, char why[128])
{
    if (DIM == 1 && fabs(s->par[SPIN]) + fabs(s->par[ANGLE]) > 0) {
        strcpy(why, "spin and angle take two dimensions");
        return -1;
    }
    const double E = 1e4, nu = DIM == 1 ? 0 : 0.3;
    s->mat = material_make(NEO_HOOKEAN, E, nu, 1);
    s->c = material_wave_speed_bar(&s->mat);
    if (is_imposed(s)) s->mat = material_make(NEO_HOOKEAN, 1e-15 * E, nu, 1);
    for (int d = 0; d < DIM; d++) {
        s->hi[d] = s->par[BOX];
        s->body_lo[d] = 0.5 * s->par[BOX] - 0.5;
        s->body_hi[d] = 0.5 * s->par[BOX] + 0.5;
    }
    s->error_scale = 1;
    return 0;
}

/* Velocity gradient of an imposed motion [1/s]; zero of a free one. */
static void imposed_gradient(const Scene *s, Square L)
{
    for (int k = 0; k < SPACE * SPACE; k++) L[k / SPACE][k % SPACE] = 0;
    L[0][0] = s->par[RATE] * s->c;
    L[0][1] = -s->par[SPIN] * s->c;
    L[1][0] = s->par[SPIN] * s->c;
}

static double about_centre(const Scene *s, int axis, double x)
{
    return axis < DIM ? x - 0.5 * s->par[BOX] : 0;
}

static void impose(const Scene *s, int n, ConstFields x, double t, Fields v)
{
    Square L;
    (void)t;
    if (!is_imposed(s)) return;
    imposed_gradient(s, L);
    for (int a = 0; a < DIM; a++)
        for (int p = 0; p < n; p++)
            v[a][p] =
                L[a][0] * about_centre(s, 0, x[0][p]) + L[a][1] * about_centre(s, 1, x[AXIS_Y][p]);
}

/* A sign that changes from point to point along every axis. The spacing is that of the first two
 * points. */
static double alternating(ConstFields X, int n, int p)
{
    const double spacing = n > 1 ? X[0][1] - X[0][0] : 1;
    long steps = 0;
    for (int d = 0; d < DIM; d++) steps += lround((X[d][p] - X[d][0]) / spacing);
    return steps % 2 ? -1 : 1;
}

/* Initial offset [m] and velocity [m/s] of the whole block. */
static void uniform_motion(const Scene *s, double offset[SPACE], double drift[SPACE])
{
    const int offsets[] = {OFFSET_X, OFFSET_Y, OFFSET_Z}, drifts[] = {DRIFT_X, DRIFT_Y, DRIFT_Z};
    for (int a = 0; a < SPACE; a++) {
        offset[a] = s->par[offsets[a]] * s->cell;
        drift[a] = s->par[drifts[a]] * s->c;
    }
}

/* F - I of the initial stretch and turn. */
static void initial_strain(const Scene *s, Square H)
{
    const double angle = DIM > 1 ? s->par[ANGLE] * M_PI / 180 : 0;
    for (int k = 0; k < SPACE * SPACE; k++) H[k / SPACE][k % SPACE] = 0;
    H[0][0] = cos(angle) * s->par[STRETCH] - 1;
    H[0][1] = -sin(angle);
    H[1][0] = sin(angle) * s->par[STRETCH];
    H[1][1] = cos(angle) - 1;
}

static void start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    double offset[SPACE], drift[SPACE];
    Square H, grad;
    uniform_motion(s, offset, drift);
    initial_strain(s, H);
    imposed_gradient(s, grad);
    for (int a = 0; a < DIM; a++)
        for (int p = 0; p < n; p++) {
            u[a][p] = offset[a];
            v[a][p] = drift[a] + s->par[RIPPLE] * s->c * alternating(X, n, p);
            for (int b = 0; b < DIM; b++) {
                u[a][p] += H[a][b] * about_centre(s, b, X[b][p]);
                v[a][p] += grad[a][b] * about_centre(s, b, X[b][p]);
                F[a * DIM + b][p] += H[a][b];
                L[a * DIM + b][p] = grad[a][b];
            }
        }
}

/* Known for a block without stress only; NAN otherwise. */
static void exact(const Scene *s, int n, ConstFields X, double t, Fields u)
{
    const double strange = fabs(s->par[STRETCH] - 1) + fabs(s->par[ANGLE]) + fabs(s->par[RIPPLE]);
    const bool known = !is_imposed(s) && !(strange > 0);
    double offset[SPACE], drift[SPACE];
    uniform_motion(s, offset, drift);
    (void)X;
    for (int a = 0; a < DIM; a++) {
        const double g = a == DIM - 1 ? s->par[GRAVITY] : 0;
        for (int p = 0; p < n; p++)
            u[a][p] = known ? offset[a] + drift[a] * t - 0.5 * g * t * t : NAN;
    }
}

static void body(const Scene *s, int n, ConstFields X, double t, Fields b)
{
    (void)X, (void)t;
    for (int a = 0; a < DIM; a++)
        for (int p = 0; p < n; p++) b[a][p] = a == DIM - 1 ? -s->par[GRAVITY] : 0;
}

const Problem problem_block = {
    .info = {.name = "block",
             .label = "block",
             .about = "a block in uniform motion and strain: what should not change",
             .source = "",
             .formula = "x = X + (F - I)(X - X_c) + offset, then uniform motion",
             .scale = "1 m",
             .params = params},
    .cells = 16,
    .ppc = IN_THIS_DIM(2, 4, 8),
    .cfl = 0.3,
    .steps = 100,
    .init = init,
    .start = start,
    .exact = exact,
    .body = body,
    .impose = impose,
};
