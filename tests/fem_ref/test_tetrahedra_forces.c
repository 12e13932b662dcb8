/* test_tetrahedra_forces.c: the FEM in 3D: patch test, forces as slopes of energy, body force. */
#include <math.h>
#include "fem_check.h"

static const Mat affine = {1.2, 0.3, -0.1, -0.05, 0.9, 0.2, 0.1, -0.15, 1.1};

static void start_affine(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F,
                         Fields L)
{
    (void)s, (void)v, (void)F, (void)L;
    for (int p = 0; p < n; p++)
        for (int a = 0; a < DIM; a++) {
            u[a][p] = -X[a][p];
            for (int b = 0; b < DIM; b++) u[a][p] += affine[a * DIM + b] * X[b][p];
        }
}

/* b = (1, 2, 3) + X: linear, so that one point an element integrates it exactly. */
static void linear_body(const Scene *s, int n, ConstFields X, double t, Fields b)
{
    (void)s, (void)t;
    for (int a = 0; a < DIM; a++)
        for (int p = 0; p < n; p++) b[a][p] = a + 1 + X[a][p];
}

static const Problem strained = {.info = {.name = "strained"}, .start = start_affine};
static const Problem pulled = {.info = {.name = "pulled"}, .body = linear_body};

/* The octant of a shell, or (kind box) a unit cube; no walls. */
static Scene free_body(const Problem *problem, BodyKind kind)
{
    Scene s = {.problem = problem,
               .mat = material_make(NEO_HOOKEAN, 1e4, 0.3, 2),
               .body_hi = {1, 1, 1},
               .octant = true,
               .body = {.kind = kind, .inner = 0.5, .outer = 1}};
    for (int d = 0; d < DIM; d++) s.turn[d * (DIM + 1)] = 1;
    s.c = material_wave_speed_p(&s.mat);
    return s;
}

static bool is_inside(const Fem *f, int i)
{
    double R = 0;
    bool in = true;
    for (int d = 0; d < DIM; d++) {
        R += f->X[d][i] * f->X[d][i];
        in = in && f->X[d][i] > 1e-9;
    }
    return in && R > pow(0.5 + 1e-9, 2) && R < pow(1 - 1e-9, 2);
}

/* A uniform strain is seen exactly by every element and leaves the nodes inside without force. */
static void test_patch(void)
{
    const Scene s = free_body(&strained, BODY_SHELL);
    Fem *f = make(&s, 8, 1);
    double inside = 0, outside = 0;
    for (int e = 0; e < f->elements; e++)
        for (int k = 0; k < NMAT; k++) CHECK_CLOSE(f->F[k][e], affine[k], 1e-12);
    CU_ASSERT(solver_fem.step(f, 0, 1e-6, true).code == OK);
    for (int i = 0; i < f->nodes; i++) {
        double *worst = is_inside(f, i) ? &inside : &outside;
        for (int d = 0; d < DIM; d++) *worst = fmax(*worst, fabs(f->v[d][i]));
    }
    CU_ASSERT(outside > 1e-3);
    CU_ASSERT(inside > 0 && inside < 1e-11 * outside);
    fem_free(f);
}

/* The force on a corner is minus the slope of the stored energy as that corner moves. */
static void test_gradient(void)
{
    const Scene s = free_body(&strained, BODY_SHELL);
    Fem *f = make(&s, 4, 1);
    const int e = 7;
    for (int c = 0; c < CORNERS; c++)
        for (int d = 0; d < DIM; d++) {
            const int i = f->corner[c][e];
            const double step = 1e-5, force = f->force[force_at(e, c)][d];
            double psi[2];
            for (int side = 0; side < 2; side++) {
                const double *F[NMAT];
                f->now[i][d] += side ? 2 * step : -step;
                fem_strain(f);
                for (int k = 0; k < NMAT; k++) F[k] = f->F[k] + e;
                material_stored_energy(&s.mat, 1, F, &psi[side]);
            }
            f->now[i][d] -= step;
            fem_strain(f);
            CHECK_CLOSE(force, -f->A0[e] * (psi[1] - psi[0]) / (2 * step), 1e-6 * s.mat.E * 0.01);
        }
    fem_free(f);
}

/* Both ways of taking a linear body force give the body the same momentum, by half a step; inside
 * the integral over an element's corners is what is taken at the node. */
static void test_body(void)
{
    const Scene s = free_body(&pulled, BODY_BOX);
    const double integrate[] = {1}, dt = 1e-5;
    Fault fault = {0};
    Setup setup = {
        .scene = &s, .cells = 6, .integrator = CD, .threads = 1, .method_par = integrate};
    check_context(DIM, s.problem->info.name, "fem", "cd", "body=elements");
    Fem *f = solver_fem.make(&setup, &fault);
    CU_ASSERT_PTR_NOT_NULL_FATAL(f);
    CU_ASSERT(solver_fem.step(f, 0, dt, true).code == OK);
    Vec given;
    solver_fem.impulse(f, given);
    for (int d = 0; d < DIM; d++)
        CHECK_CLOSE(given[d], 0.5 * dt * s.mat.rho * (d + 1.5), 1e-12 * dt);
    double gap = 0;
    for (int i = 0; i < f->nodes; i++) {
        bool in = true;
        for (int d = 0; d < DIM; d++) in = in && f->X[d][i] > 0.01 && f->X[d][i] < 0.99;
        for (int d = 0; d < DIM && in; d++)
            gap = fmax(gap, fabs(f->v[d][i] - 0.5 * dt * (d + 1 + f->X[d][i])));
    }
    CU_ASSERT(gap < 1e-9 * dt);
    fem_free(f);
}

static const TestCase tests[] = {
    {"patch: uniform strain", test_patch},
    {"forces are the slopes of the stored energy", test_gradient},
    {"body force integrated over elements", test_body},
    {NULL, NULL},
};
CHECK_SUITE(tests)
