/* test_material.c: logarithm, sine and cosine of chunks, stress against stored energy, rotations.
 */
#include <stdlib.h>
#include "common/contract/chunk_log.h"
#include "common/contract/chunk_trig.h"
#include "tests/fixture.h"

enum { NUMBERS = 200000 };

static double ulps(double x)
{
    const long double exact = logl((long double)x);
    const double ulp = nextafter(fabs((double)exact), INFINITY) - fabs((double)exact);
    return (double)fabsl((long double)log_one(x) - exact) / ulp;
}

/* All magnitudes, J near 1 down to the last bits, and around the cut at sqrt(1/2). */
static void test_log(void)
{
    double worst = 0;
    for (int k = 0; k < NUMBERS; k++) {
        worst = fmax(worst, ulps(exp2(fixture_random(-1020, 1020))));
        worst = fmax(worst, ulps(1 + fixture_random(-1, 1) * exp2(-fixture_random(1, 52))));
        worst = fmax(worst, ulps(fixture_random(0.7, 0.72)));
    }
    CU_ASSERT(worst <= 1.5);
    CU_ASSERT(log_one(1) == 0);
    CU_ASSERT(isnan(log_one(0)) && isnan(log_one(-1)) && isnan(log_one(NAN)));
}

static void test_log_n(void)
{
    double x[CHUNK + 3], y[CHUNK + 3];
    for (int k = 0; k < COUNT(x); k++) x[k] = fixture_random(0.1, 3);
    log_n(COUNT(x), x, y);
    for (int k = 0; k < COUNT(x); k++) CHECK_CLOSE(y[k], log(x[k]), 1e-15);
}

/* Error of y = f(x) in units of the last place of f, or of 1e-16 |x| near zeros of f. */
static double trig_ulps(double y, long double exact, double x)
{
    const double size = fabs((double)exact), ulp = nextafter(size, INFINITY) - size;
    return (double)fabsl((long double)y - exact) / fmax(ulp, 1e-16 * fabs(x));
}

/* All magnitudes up to 1e5, and around the cuts at odd multiples of pi/4. */
static void test_trig(void)
{
    double worst = 0, s, c;
    for (int k = 0; k < NUMBERS; k++) {
        const double cut = (2 * floor(fixture_random(-20, 20)) + 1) * M_PI / 4;
        const double at[] = {copysign(pow(10, fixture_random(-10, 5)), fixture_random(-1, 1)),
                             fixture_random(-4, 4), cut + fixture_random(-1, 1) * 1e-9};
        for (int j = 0; j < COUNT(at); j++) {
            trig_sin_cos(at[j], &s, &c);
            worst = fmax(worst, trig_ulps(s, sinl((long double)at[j]), at[j]));
            worst = fmax(worst, trig_ulps(c, cosl((long double)at[j]), at[j]));
        }
    }
    CU_ASSERT(worst <= 1);
    trig_sin_cos(0, &s, &c);
    CU_ASSERT(s == 0 && c == 1);
    trig_sin_cos(NAN, &s, &c);
    CU_ASSERT(isnan(s) && isnan(c));
    CU_ASSERT(trig_sin(0.5) == -trig_sin(-0.5) && trig_cos(0.5) == trig_cos(-0.5));
}

static double energy(const Material *m, const Mat F)
{
    const double *f[NMAT];
    double psi;
    for (int k = 0; k < NMAT; k++) f[k] = &F[k];
    material_stored_energy(m, 1, f, &psi);
    return psi;
}

/* dpsi/dF_k by central differences of sixth order, e = 1e-2: e^6 d7psi and 1e-16/e are below 1e-11.
 */
static double first_stress(const Material *m, const Mat F, int k)
{
    static const double weight[] = {3.0 / 4, -3.0 / 20, 1.0 / 60};
    const double e = 2e-3;
    double sum = 0;
    for (int n = 1; n <= 3; n++)
        for (int side = -1; side <= 1; side += 2) {
            Mat at;
            for (int j = 0; j < NMAT; j++) at[j] = F[j] + (j == k ? side * n * e : 0);
            sum += side * weight[n - 1] * energy(m, at) / e;
        }
    return sum;
}

/* 64 deformations, none far from I, in the arrays that material_kirchhoff wants. */
static void deformations(Field F[NMAT], const double *f[NMAT])
{
    for (int k = 0; k < NMAT; k++) {
        f[k] = F[k];
        for (int p = 0; p < CHUNK; p++) F[k][p] = (k % (DIM + 1) == 0) + fixture_random(-0.2, 0.2);
    }
}

/* T = P F^T, P = dpsi/dF. */
static void test_stress(void)
{
    Field F[NMAT], T[NMAT];
    const double *f[NMAT];
    for (int law = NEO_HOOKEAN; law <= LINEAR; law++) {
        const Material m = material_make((Law)law, 2, DIM == 1 ? 0 : 0.3, 1);
        deformations(F, f);
        material_kirchhoff(&m, f, T);
        for (int p = 0; p < CHUNK; p++)
            for (int a = 0; a < DIM; a++)
                for (int b = 0; b < DIM; b++) {
                    Mat own;
                    double t = 0;
                    for (int k = 0; k < NMAT; k++) own[k] = F[k][p];
                    for (int k = 0; k < DIM; k++)
                        t += first_stress(&m, own, a * DIM + k) * own[b * DIM + k];
                    CHECK_CLOSE(T[a * DIM + b][p], t, 1e-9);
                }
    }
}

/* A turn in the first plane stores nothing; and I is free of stress in both laws. */
static void test_rotation(void)
{
    Field F[NMAT], T[NMAT];
    const double *f[NMAT];
    for (int k = 0; k < NMAT; k++) f[k] = F[k];
    for (int law = NEO_HOOKEAN; law <= LINEAR; law++) {
        const Material m = material_make((Law)law, 2, DIM == 1 ? 0 : 0.3, 1);
        for (int p = 0; p < CHUNK; p++) {
            const double angle = law == LINEAR || DIM == 1 ? 0 : p, c = cos(angle), s = sin(angle);
            for (int k = 0; k < NMAT; k++) F[k][p] = k % (DIM + 1) == 0;
            F[0][p] = c, F[NMAT == 1 ? 0 : DIM + 1][p] = c;
            if (DIM > 1) F[1 % NMAT][p] = -s, F[DIM % NMAT][p] = s;
        }
        material_kirchhoff(&m, f, T);
        for (int k = 0; k < NMAT; k++)
            for (int p = 0; p < CHUNK; p++) CHECK_CLOSE(T[k][p], 0, 1e-14);
    }
}

/* Plane strain: along an axis of the plane that is not strained, stress is that across the plane.
 */
static void test_out_of_plane(void)
{
    for (int law = NEO_HOOKEAN; law <= LINEAR; law++) {
        const Material m = material_make((Law)law, 2, DIM == 1 ? 0 : 0.3, 1);
        for (double s = 0.7; s < 1.5; s += 0.1) {
            Field F[NMAT], T[NMAT];
            const double *f[NMAT];
            Mat own;
            for (int k = 0; k < NMAT; k++) {
                f[k] = F[k];
                own[k] = k == 0 ? s : k % (DIM + 1) == 0;
                for (int p = 0; p < CHUNK; p++) F[k][p] = own[k];
            }
            material_kirchhoff(&m, f, T);
            CHECK_CLOSE(material_out_of_plane_stress(&m, own), DIM == 1 ? 0 : T[NMAT - 1][0] / s,
                        1e-14);
        }
    }
}

static void test_speeds(void)
{
    const Material m = material_make(NEO_HOOKEAN, 1e4, DIM == 1 ? 0 : 0.3, 2);
    const double nu = DIM == 1 ? 0 : 0.3;
    CHECK_CLOSE(m.mu, 5e3 / (1 + nu), 1e-9);
    CHECK_CLOSE(m.lambda, 1e4 * nu / ((1 + nu) * (1 - 2 * nu)), 1e-9);
    CHECK_CLOSE(material_wave_speed_bar(&m), sqrt(5e3), 1e-12);
    CU_ASSERT(material_wave_speed_p(&m) < material_wave_speed_bound(&m));
}

/* What bears no tension: psi's derivative is T, T has no positive principal value, nothing is
 * stored where all stretches exceed 1, and what is compressed along all axes is the sound matter.
 */
static void test_without_tension(void)
{
    const Material m = material_make(NEO_HOOKEAN, 1e4, DIM == 1 ? 0 : 0.3, 1);
    const double eps = 1e-6;
    for (int trial = 0; trial < 40; trial++) {
        Mat F, T, none;
        for (int k = 0; k < NMAT; k++)
            F[k] = (k % (DIM + 1) == 0 ? 1 : 0) + fixture_random(-0.25, 0.25);
        material_without_tension(&m, F, T);
        CU_ASSERT(material_largest_stress(T) < 1e-10 * m.E);
        for (int k = 0; k < NMAT; k++) { /* dpsi = T : L, of F + eps L F, L along k */
            double psi[2];
            for (int side = 0; side < 2; side++) {
                Mat G;
                for (int c = 0; c < NMAT; c++) G[c] = F[c];
                for (int c = 0; c < DIM; c++)
                    G[k / DIM * DIM + c] += (side ? eps : -eps) * F[k % DIM * DIM + c];
                psi[side] = material_without_tension(&m, G, none);
            }
            CHECK_CLOSE((psi[1] - psi[0]) / (2 * eps), T[k], 1e-5 * m.E);
        }
    }
    Mat F = {0}, T;
    const double *f[NMAT];
    double psi;
    for (int side = 0; side < 2; side++) {
        for (int d = 0; d < DIM; d++) F[d * (DIM + 1)] = side ? 1.2 + 0.1 * d : 0.8 - 0.1 * d;
        for (int k = 0; k < NMAT; k++) f[k] = &F[k];
        material_stored_energy(&m, 1, f, &psi);
        CHECK_CLOSE(material_without_tension(&m, F, T), side ? 0 : psi, 1e-12 * m.E);
        if (side) CHECK_CLOSE(material_largest_stress(T), 0, 0);
    }
    for (int k = 0; k < NMAT; k++) T[k] = k == 0 ? 3 : k % (DIM + 1) == 0 ? 4 : DIM == 2 ? 1 : 0;
    CHECK_CLOSE(material_largest_stress(T), DIM == 1 ? 3 : DIM == 2 ? 3.5 + sqrt(1.25) : 4, 1e-14);
}

static const TestCase tests[] = {
    {"logarithm to 1.5 ulp", test_log},
    {"logarithms of many", test_log_n},
    {"sine and cosine", test_trig},
    {"stress is the derivative of stored energy", test_stress},
    {"rest and rotation are free of stress", test_rotation},
    {"stress across the plane", test_out_of_plane},
    {"Lame constants and wave speeds", test_speeds},
    {"matter without tension", test_without_tension},
    {NULL, NULL},
};
CHECK_SUITE(tests)
