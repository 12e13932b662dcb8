/* test_axis_mms.c: the axis-aligned solution against finite differences: balance of momentum,
 * start. */
#include "../common/problem.h"
#include "wls_check.h"

extern const Problem problem_axis_mms;

static const double par[] = {0.05, 1e4, 0.3, 2};

/* Central differences of eighth order; offsets k e, k = 1 .. 4. */
static const double weight[4] = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
static const double e = 0.01;

static Scene scene(void)
{
    Scene s = {.problem = &problem_axis_mms, .par = par, .cell = 1};
    char why[128];
    CU_ASSERT(problem_axis_mms.init(&s, why) == 0);
    return s;
}

static void displacement(const Scene *s, const Vec X, double t, Vec u)
{
    const double *in[] = {&X[0], &X[1]};
    double *out[] = {&u[0], &u[1]};
    problem_axis_mms.exact(s, 1, in, t, out);
}

/* F_ab = delta_ab + du_a/dX_b */
static void gradient(const Scene *s, const Vec X, double t, Mat F)
{
    for (int b = 0; b < DIM; b++) {
        for (int a = 0; a < DIM; a++) F[a * DIM + b] = a == b;
        for (int k = 1; k <= 4; k++)
            for (int side = -1; side <= 1; side += 2) {
                Vec at = {X[0], X[1]}, u;
                at[b] += side * k * e;
                displacement(s, at, t, u);
                for (int a = 0; a < DIM; a++) F[a * DIM + b] += side * weight[k - 1] * u[a] / e;
            }
    }
}

/* P = mu (F - F^-T) + lambda ln J F^-T */
static void first_stress(const Scene *s, const Vec X, double t, Mat P)
{
    Mat F;
    gradient(s, X, t, F);
    const double J = determinant(F), ln_J = log(J);
    for (int a = 0; a < DIM; a++)
        for (int b = 0; b < DIM; b++) {
            const double inverse = cofactor(F, a, b) / J;
            P[a * DIM + b] =
                s->mat.mu * (F[a * DIM + b] - inverse) + s->mat.lambda * ln_J * inverse;
        }
}

/* b_a = u_a,tt - P_ab,b / rho */
static void balance(const Scene *s, const Vec X, double t, Vec b)
{
    Vec u;
    const double w = M_PI * s->c;
    displacement(s, X, t, u);
    for (int a = 0; a < DIM; a++) b[a] = -w * w * u[a];
    for (int axis = 0; axis < DIM; axis++)
        for (int k = 1; k <= 4; k++)
            for (int side = -1; side <= 1; side += 2) {
                Vec at = {X[0], X[1]};
                Mat P;
                at[axis] += side * k * e;
                first_stress(s, at, t, P);
                for (int a = 0; a < DIM; a++)
                    b[a] -= side * weight[k - 1] * P[a * DIM + axis] / e / s->mat.rho;
            }
}

static void test_balance(void)
{
    const Scene s = scene();
    for (int k = 0; k < 40; k++) {
        const Vec X = {fmod(0.37 * k, 1), fmod(0.61 * k + 0.2, 1)};
        const double t = s.t_end * k / 40, *in[] = {&X[0], &X[1]};
        Vec b, expected;
        double *out[] = {&b[0], &b[1]};
        problem_axis_mms.body(&s, 1, in, t, out);
        balance(&s, X, t, expected);
        for (int a = 0; a < DIM; a++) CHECK_CLOSE(b[a], expected[a], 1e-7 * s.c * s.c);
    }
}

/* v is du/dt and L its gradient; both vanish across the sides they must not cross. */
static void test_start(void)
{
    const Scene s = scene();
    for (int k = 0; k < 40; k++) {
        const Vec X = {k % 4 ? 0.0257 * k : 0, k % 4 == 1 ? 1 : 0.0257 * k};
        const double *in[] = {&X[0], &X[1]}, dt = 1e-3 * s.t_end;
        double v[DIM] = {0}, L[NMAT] = {0}, none[NMAT] = {0};
        double *pv[] = {&v[0], &v[1]}, *pL[] = {&L[0], &L[1], &L[2], &L[3]};
        double *unused[] = {none, none, none, none};
        Vec u;
        Mat F;
        problem_axis_mms.start(&s, 1, in, unused, pv, unused, pL);
        displacement(&s, X, dt, u);
        gradient(&s, X, dt, F);
        for (int a = 0; a < DIM; a++) CHECK_CLOSE(v[a], u[a] / dt, 1e-4 * s.c * par[0]);
        for (int a = 0; a < NMAT; a++)
            CHECK_CLOSE(L[a], (F[a] - (a % 3 == 0)) / dt, 1e-4 * s.c * par[0]);
        if (k % 4 == 0) CHECK_CLOSE(v[0], 0, 1e-13);
        if (k % 4 == 1) CHECK_CLOSE(v[1], 0, 1e-13);
    }
}

extern const TestCase axis_tests[];
const TestCase axis_tests[] = {
    {"body force balances the exact motion (finite differences)", test_balance},
    {"starts with the exact velocity and its gradient", test_start},
    {NULL, NULL},
};
