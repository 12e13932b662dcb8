/* test_blocks.c: what is measured of many points, in blocks with a rest, against plain loops: error
 * norms, kinetic energy and momentum, work of body forces; the same bits with any number of
 * threads.
 */
#include "common/run/ledger.h"
#include "tests/fixture.h"

enum { MANY = 5000, MOST_THREADS = 4 };
static double mass[MANY], weight[MANY], X[DIM][MANY], x[DIM][MANY], v[DIM][MANY];
static int ids[MANY]; /* 0 ... MANY - 1 in another order; -1 in every seventh slot */

static Points fill(void)
{
    Points q = {.n = MANY, .id = ids, .m = mass, .V0 = weight};
    for (int k = 0; k < MANY; k++) {
        const bool real = k % 7 != 3;
        ids[k] = real ? k * 7 % MANY : -1;
        mass[k] = real ? fixture_random(0, 1) : 0;
        weight[k] = real ? fixture_random(0, 1) : 0;
        for (int d = 0; d < DIM; d++) {
            X[d][k] = fixture_random(-1, 1);
            x[d][k] = fixture_random(-1, 1);
            v[d][k] = fixture_random(-1, 1);
        }
    }
    for (int d = 0; d < DIM; d++) q.X[d] = X[d], q.x[d] = x[d], q.v[d] = v[d];
    return q;
}

static void test_motion(void)
{
    Scratch scratch = {0};
    const Points q = fill();
    double kinetic = 0, px = 0;
    for (int k = 0; k < MANY; k++) {
        px += mass[k] * v[0][k];
        for (int d = 0; d < DIM; d++) kinetic += 0.5 * mass[k] * v[d][k] * v[d][k];
    }
    CU_ASSERT_FATAL(norm_scratch_fit(&scratch, MANY));
    const Side one = ledger_motion(&q, 1, &scratch);
    CHECK_CLOSE(one.kinetic / kinetic, 1, 1e-13);
    CHECK_CLOSE(one.p[0], px, 1e-11);
    for (int threads = 2; threads <= MOST_THREADS; threads++) {
        const Side many = ledger_motion(&q, threads, &scratch);
        CU_ASSERT(memcmp(&one, &many, sizeof one) == 0);
    }
    norm_scratch_free(&scratch);
}

/* u = t X_d */
static void stretch(const Scene *s, int n, ConstFields at, double t, Fields u)
{
    (void)s;
    for (int d = 0; d < DIM; d++)
        for (int p = 0; p < n; p++) u[d][p] = t * at[d][p];
}

/* The error of a point without weight does not count, even if it is not a number. */
static void test_norms(void)
{
    const Problem problem = {.exact = stretch};
    const Scene scene = {.problem = &problem, .error_scale = 0.5};
    Scratch scratch = {0};
    const Points q = fill();
    double most = 0, square = 0, sum = 0, total = 0;
    for (int k = 0; k < MANY; k++) {
        double e = 0;
        for (int d = 0; d < DIM; d++) e += pow(x[d][k] - 3 * X[d][k], 2);
        e = weight[k] > 0 ? sqrt(e) / 0.5 : 0;
        most = fmax(most, e);
        square += weight[k] * e * e, sum += weight[k] * e, total += weight[k];
    }
    x[0][3] = NAN; /* weight[3] = 0 */
    CU_ASSERT_FATAL(norm_scratch_fit(&scratch, MANY));
    const Errors one = norm_displacement(&scene, &q, 2, 1, &scratch);
    CHECK_CLOSE(one.linf, most, 1e-14);
    CHECK_CLOSE(one.l2, sqrt(square / total), 1e-12);
    CHECK_CLOSE(one.l1, sum / total, 1e-12);
    for (int threads = 2; threads <= MOST_THREADS; threads++) {
        const Errors many = norm_displacement(&scene, &q, 2, threads, &scratch);
        CU_ASSERT(memcmp(&one, &many, sizeof one) == 0);
    }
    for (int slot = 0; slot < MANY; slot += 1249) { /* first and last block; lanes and the rest */
        const double kept = x[0][slot];
        if (!(weight[slot] > 0)) continue;
        x[0][slot] = NAN;
        const Errors none = norm_displacement(&scene, &q, 2, 1, &scratch);
        CU_ASSERT(isnan(none.linf) && isnan(none.l2) && isnan(none.l1));
        x[0][slot] = kept;
    }
    norm_scratch_free(&scratch);
}

/* Two steps, the second after the points have changed their slots: each adds m times the mean of
 * the forces times the displacement. b = t X. */
static void test_work(void)
{
    static BodyLoad before[MANY], other[MANY];
    const Problem problem = {.body = stretch};
    const Scene scene = {.problem = &problem};
    Scratch scratch = {0};
    const Points q = fill();
    double work = 0;
    CU_ASSERT_FATAL(norm_scratch_fit(&scratch, MANY));
    ledger_work(&scene, &q, 1, before, 1, &scratch);
    for (int k = 0; k + 2 < MANY; k += 7) /* the slots of 0 and 1 of every seven change places */
        for (int d = 0; d < DIM; d++) {
            const double at = x[d][k];
            const int id = ids[k];
            const double m = mass[k], was = X[d][k];
            x[d][k] = x[d][k + 1], x[d][k + 1] = at;
            X[d][k] = X[d][k + 1], X[d][k + 1] = was;
            if (d > 0) continue;
            ids[k] = ids[k + 1], ids[k + 1] = id;
            mass[k] = mass[k + 1], mass[k + 1] = m;
        }
    for (int k = 0; k < MANY; k++)
        for (int d = 0; d < DIM; d++) {
            const double step = fixture_random(-1, 1);
            x[d][k] += step;
            work += mass[k] * 0.5 * (1 + 3) * X[d][k] * step;
        }
    memcpy(other, before, sizeof before);
    const double one = ledger_work(&scene, &q, 3, before, 1, &scratch);
    const double four = ledger_work(&scene, &q, 3, other, MOST_THREADS, &scratch);
    CHECK_CLOSE(one, work, 1e-11);
    CU_ASSERT(memcmp(&one, &four, sizeof one) == 0);
    CU_ASSERT(memcmp(before, other, sizeof before) == 0);
    CHECK_CLOSE(ledger_work(&scene, &q, 3, before, 1, &scratch), 0, 0);
    norm_scratch_free(&scratch);
}

static const TestCase tests[] = {
    {"kinetic energy and momentum", test_motion},
    {"error norms", test_norms},
    {"work of body forces", test_work},
    {NULL, NULL},
};
CHECK_SUITE(tests)
