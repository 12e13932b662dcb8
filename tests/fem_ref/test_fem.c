/* test_fem.c: the FEM solver on its own: patch, rotation, ledger, order, threads. */
#include <string.h>
#include "fem_check.h"
#include "tests/fixture.h"

extern const Problem problem_ring;

/* ---- scenes */

static const double affine[NMAT] = {1.2, 0.3, -0.1,
                                    0.9}; /* a gradient of displacement + I, or of v */

static void start_affine(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F,
                         Fields L)
{
    (void)v, (void)F, (void)L;
    const double *G = s->k;
    for (int p = 0; p < n; p++)
        for (int a = 0; a < DIM; a++)
            u[a][p] = G[a * DIM] * X[0][p] + G[a * DIM + 1] * X[1][p] - X[a][p];
}

static void start_moving(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F,
                         Fields L)
{
    (void)u, (void)F, (void)L;
    const double *G = s->k;
    for (int p = 0; p < n; p++)
        for (int a = 0; a < DIM; a++) v[a][p] = G[a * DIM] * X[0][p] + G[a * DIM + 1] * X[1][p];
}

static const Problem strained = {.info = {.name = "strained"}, .start = start_affine};
static const Problem moving = {.info = {.name = "moving"}, .start = start_moving};
/* A hole plate: a mesh of unequal triangles; no walls. */
static Scene plate(const Problem *problem, const double G[NMAT])
{
    Scene s = {.problem = problem,
               .mat = material_make(NEO_HOOKEAN, 1e4, 0.3, 1),
               .body_hi = {1, 1},
               .body = {BODY_HOLE_PLATE, {0, 0}, 0.5, 0, 0, M_PI / 2}};
    s.c = material_wave_speed_p(&s.mat);
    memcpy(s.k, G, sizeof(Mat));
    return s;
}

static const double quarter[6] = {0.1}, full[6] = {0.1, 1, 0.3, -0.4, 25};

/* ---- one step */

static bool is_inside(const Fem *f, int i)
{
    const double x = f->X[0][i], y = f->X[1][i], near = 1e-9;
    return x > near && y > near && x < 1 - near && y < 1 - near && hypot(x, y) > 0.5 + near;
}

/* F and sigma = T/J of every node where all elements have the scene's G. */
static void check_uniform(const Fem *f)
{
    static double store[2 * NMAT][1000];
    double *F[NMAT], *sigma[NMAT];
    const double *now[NMAT];
    Field G[NMAT], T[NMAT];
    for (int k = 0; k < NMAT; k++) {
        F[k] = store[k], sigma[k] = store[NMAT + k], now[k] = G[k];
        for (int p = 0; p < CHUNK; p++) G[k][p] = f->scene->k[k];
    }
    CU_ASSERT_FATAL(f->nodes <= 1000);
    material_kirchhoff(&f->scene->mat, now, T);
    solver_fem.point_stress(f, F, sigma);
    const double J = determinant(f->scene->k), E = f->scene->mat.E;
    for (int i = 0; i < f->nodes; i++)
        for (int k = 0; k < NMAT; k++) {
            CHECK_CLOSE(F[k][i], f->scene->k[k], 1e-13);
            CHECK_CLOSE(sigma[k][i], T[k][0] / J, 1e-12 * E);
        }
}

/* A uniform strain is seen exactly by every element and leaves the nodes inside without force. */
static void test_patch(void)
{
    for (int law = NEO_HOOKEAN; law <= LINEAR; law++) {
        Scene s = plate(&strained, affine);
        s.mat.law = (Law)law;
        Fem *f = make(&s, 16, 1);
        double inside = 0, outside = 0, dt = 1e-6;
        for (int e = 0; e < f->elements; e++)
            for (int k = 0; k < NMAT; k++) CHECK_CLOSE(f->F[k][e], affine[k], 1e-13);
        check_uniform(f);
        CU_ASSERT(solver_fem.step(f, 0, dt, true).code == OK);
        for (int i = 0; i < f->nodes; i++) {
            double *worst = is_inside(f, i) ? &inside : &outside;
            *worst = fmax(*worst, hypot(f->v[0][i], f->v[1][i]));
        }
        CU_ASSERT(outside > 1e-3);
        CU_ASSERT(inside < 1e-11 * outside);
        solver_fem.free(f);
    }
}

/* v = G X moves F from I to I + dt G. */
static void test_affine_velocity(void)
{
    const Scene s = plate(&moving, affine);
    Fem *f = make(&s, 16, 1);
    const double dt = 1e-3;
    CU_ASSERT(solver_fem.step(f, 0, dt, true).code == OK);
    for (int e = 0; e < f->elements; e++)
        for (int k = 0; k < NMAT; k++)
            CHECK_CLOSE(f->F[k][e], (k % 3 == 0) + dt * affine[k], 1e-13);
    solver_fem.free(f);
}

static void test_rotation(void)
{
    const double angle = 77 * M_PI / 180, c = cos(angle), q = sin(angle);
    const Scene s = plate(&strained, (Mat){c, -q, q, c});
    Fem *f = make(&s, 16, 1);
    check_uniform(f);
    CU_ASSERT(solver_fem.step(f, 0, 1e-3, true).code == OK);
    for (int i = 0; i < f->nodes; i++) CHECK_CLOSE(hypot(f->v[0][i], f->v[1][i]), 0, 1e-8 * s.c);
    solver_fem.free(f);
}

/* ---- the ring; ledger and error are written here once more */

static double strain(const Fem *f)
{
    double sum = 0;
    for (int e = 0; e < f->elements; e++) {
        const double *F[NMAT] = {&f->F[0][e], &f->F[1][e], &f->F[2][e], &f->F[3][e]};
        double psi;
        material_stored_energy(&f->scene->mat, 1, F, &psi);
        sum += psi * f->A0[e];
    }
    return sum;
}

/* Power of the body force at time t with the velocity at hand. */
static double power(const Fem *f, double t)
{
    double sum = 0;
    for (int i = 0; i < f->nodes; i++) {
        Vec b;
        f->scene->problem->body(f->scene, 1, (const double *[]){&f->X[0][i], &f->X[1][i]}, t,
                                (double *[]){&b[0], &b[1]});
        for (int d = 0; d < DIM; d++) sum += f->m[i] * b[d] * f->v[d][i];
    }
    return sum;
}

static double error_now(const Fem *f, double t)
{
    double worst = 0;
    for (int i = 0; i < f->nodes; i++) {
        Vec u;
        f->scene->problem->exact(f->scene, 1, (const double *[]){&f->X[0][i], &f->X[1][i]}, t,
                                 (double *[]){&u[0], &u[1]});
        worst = fmax(worst, hypot(f->x[0][i] - f->X[0][i] - u[0], f->x[1][i] - f->X[1][i] - u[1]));
    }
    return worst;
}

/* Runs a ring to its end: largest error, and largest |K + S - W - start| over the largest K + S. At
 * t^n K and the power are means over the half steps around it; the ring starts at rest. */
static void run_ring(const double par[6], int cells, double cfl, double *error, double *drift)
{
    const Scene s = fixture_bare_scene(&problem_ring, par, 1.0 / cells);
    Fem *f = make(&s, cells, 1);
    const int n = (int)ceil(s.t_end / (cfl * solver_fem.unit_dt(f)) - 1e-9);
    const double dt = s.t_end / n, start = strain(f);
    double K = 0, P = 0, S = start, W = 0, off = 0, largest = 0;
    *error = 0;
    for (int k = 0; k < n; k++) {
        double old_K = kinetic(f), old_S = strain(f), old_P = P, P_before = power(f, k * dt);
        CU_ASSERT_FATAL(solver_fem.step(f, k * dt, dt, k == 0).code == OK);
        K = k > 0 ? 0.5 * (old_K + kinetic(f)) : 0;
        P = k > 0 ? 0.5 * (P_before + power(f, k * dt)) : 0;
        S = old_S;
        W += 0.5 * dt * (old_P + P);
        off = fmax(off, fabs(K + S - W - start));
        largest = fmax(largest, K + S);
        *error = fmax(*error, error_now(f, (k + 1) * dt));
    }
    *drift = off / largest;
    solver_fem.free(f);
}

static void test_ring_error(void)
{
    static const struct {
        int cells;
        double error;
    } known[] = {{8, 5.93e-3}, {16, 1.34e-3}, {32, 3.50e-4}};
    double error[3], drift;
    for (int k = 0; k < 3; k++) {
        run_ring(quarter, known[k].cells, 0.3, &error[k], &drift);
        CHECK_CLOSE(error[k], known[k].error, 0.02 * known[k].error);
    }
    CHECK_CLOSE(log2(error[0] / error[2]) / 2, 2, 0.1);
}

/* The whole ring, off the grid line and turned, has the error of a quarter. */
static void test_full_ring(void)
{
    double error, whole, drift;
    run_ring(quarter, 16, 0.3, &error, &drift);
    run_ring(full, 16, 0.3, &whole, &drift);
    CHECK_CLOSE(whole, error, 0.03 * error);
}

static void test_energy(void)
{
    double error, coarse, fine;
    run_ring(quarter, 32, 0.3, &error, &coarse);
    run_ring(quarter, 32, 0.15, &error, &fine);
    CU_ASSERT(fine < 1e-4);
    CHECK_CLOSE(coarse / fine, 4, 0.2); /* second order in time */
}

static void test_momentum(void)
{
    const Scene s = fixture_bare_scene(&problem_ring, quarter, 1.0 / 16);
    Fem *f = make(&s, 16, 1);
    Vec impulse;
    double dt = 0.3 * solver_fem.unit_dt(f);
    for (int k = 0; k < 40; k++) CU_ASSERT(solver_fem.step(f, k * dt, dt, k == 0).code == OK);
    solver_fem.impulse(f, impulse);
    for (int d = 0; d < DIM; d++) {
        double p = 0, size = 0;
        int bound = 0;
        for (int i = 0; i < f->nodes; i++) {
            p += f->m[i] * f->v[d][i];
            size += f->m[i] * fabs(f->v[d][i]);
            if (f->X[d][i] != 0) continue;
            bound++;
            CU_ASSERT(f->x[d][i] == 0);
        }
        CU_ASSERT_EQUAL(bound, 9);
        CU_ASSERT(size > 0.1);
        CHECK_CLOSE(p, impulse[d], 1e-13 * size);
    }
    solver_fem.free(f);
}

static void test_threads(void)
{
    const Scene s = fixture_bare_scene(&problem_ring, full, 1.0 / 64);
    Fem *one = make(&s, 64, 1);
    const double dt = 0.3 * solver_fem.unit_dt(one);
    for (int k = 0; k < 20; k++) solver_fem.step(one, k * dt, dt, k == 0);
    for (int threads = 2; threads <= 7; threads += 5) {
        Fem *f = make(&s, 64, threads);
        CU_ASSERT_EQUAL(f->threads, threads);
        for (int k = 0; k < 20; k++) solver_fem.step(f, k * dt, dt, k == 0);
        for (int d = 0; d < DIM; d++) {
            const size_t bytes = (size_t)f->nodes * sizeof(double);
            CU_ASSERT(memcmp(f->x[d], one->x[d], bytes) == 0);
            CU_ASSERT(memcmp(f->v[d], one->v[d], bytes) == 0);
        }
        solver_fem.free(f);
    }
    solver_fem.free(one);
}

static const TestCase tests[] = {
    {"patch: uniform strain", test_patch},
    {"patch: affine velocity", test_affine_velocity},
    {"a rotation is free of stress", test_rotation},
    {"ring: published errors, second order", test_ring_error},
    {"ring: whole, moved and turned", test_full_ring},
    {"ring: work in = kinetic + strain", test_energy},
    {"ring: momentum = impulse", test_momentum},
    {"bitwise the same on any number of threads", test_threads},
    {NULL, NULL},
};
CHECK_SUITE(tests)
