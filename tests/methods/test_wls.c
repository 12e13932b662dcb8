/* test_wls.c: the pieces of WLS alone: shapes of cut cells and their quadrature, fits, distances.
 */
#include <stdlib.h>
#include "methods/wls/wls.h"
#include "common/base/polygon.h"
#include "tests/check.h"
#include "wls_check.h"

static double random_in(double lo, double hi)
{
    return lo + (hi - lo) * (double)rand() / RAND_MAX;
}

/* Distances with the signs of a mask. */
static void random_cell(int mask, double d[4])
{
    for (int k = 0; k < 4; k++) d[k] = (mask >> k & 1 ? 1 : -1) * random_in(0.01, 1);
}

enum { MONOMIALS = 6 };

/* 1, x, y, x^2, x y, y^2 over the shape, by its quadrature. */
static void integrate(const double d[4], double sum[MONOMIALS])
{
    double xi[MAX_POINTS][DIM], w[MAX_POINTS];
    const int n = wls_cell_points(d, NULL, QUADRATURE_EXACT, xi, w);
    for (int m = 0; m < MONOMIALS; m++) sum[m] = 0;
    for (int q = 0; q < n; q++) {
        const double x = xi[q][0], y = xi[q][1], f[MONOMIALS] = {1, x, y, x * x, x * y, y * y};
        CU_ASSERT(x >= 0 && x <= 1 && y >= 0 && y <= 1 && w[q] >= 0);
        for (int m = 0; m < MONOMIALS; m++) sum[m] += w[q] * f[m];
    }
}

/* What is in and what is out fill the square, for every mask, both saddles among them. */
static void test_masks_complete(void)
{
    static const double whole[MONOMIALS] = {1, 0.5, 0.5, 1.0 / 3, 0.25, 1.0 / 3};
    srand(1);
    for (int mask = 0; mask < 16; mask++)
        for (int k = 0; k < 200; k++) {
            double d[4], in[MONOMIALS], out[MONOMIALS];
            random_cell(mask, d);
            integrate(d, in);
            for (int c = 0; c < 4; c++) d[c] = -d[c];
            integrate(d, out);
            for (int m = 0; m < MONOMIALS; m++) CHECK_CLOSE(in[m] + out[m], whole[m], 1e-14);
        }
}

/* One point at the centroid has the area and first moments of the exact rule. */
static void test_centroids(void)
{
    srand(2);
    for (int mask = 0; mask < 16; mask++)
        for (int k = 0; k < 200; k++) {
            double d[4], exact[MONOMIALS], sum[3] = {0}, xi[MAX_POINTS][DIM], w[MAX_POINTS];
            random_cell(mask, d);
            integrate(d, exact);
            const int n = wls_cell_points(d, NULL, QUADRATURE_CENTROID, xi, w);
            CU_ASSERT(n <= 2);
            for (int q = 0; q < n; q++) {
                sum[0] += w[q];
                for (int a = 0; a < DIM; a++) sum[1 + a] += w[q] * xi[q][a];
            }
            for (int m = 0; m < 3; m++) CHECK_CLOSE(sum[m], exact[m], 1e-15);
        }
}

/* Fig 2, worked by hand: triangle, quadrilateral, pentagon, square, and the saddle. */
static void test_known_shapes(void)
{
    static const struct {
        double d[4], area, x, y;
        int pieces;
    } known[] = {
        {{-1, -1, -1, -1}, 0, 0, 0, 0},
        {{1, -1, -1, -1}, 0.125, 1.0 / 6, 1.0 / 6, 1},
        {{1, -1, -1, -3}, 0.125, 1.0 / 6, 1.0 / 6, 1},
        {{3, -1, 3, -1}, 0.75, 0.375, 0.5, 1},
        {{-1, 1, 1, 1}, 0.875, 0.5476190476190476, 0.5476190476190476, 1},
        {{1, 1, 1, 1}, 1, 0.5, 0.5, 1},
        {{1, -1, -1, 1}, 0.25, 0.5, 0.5, 2},   /* mean 0: apart */
        {{3, -1, -1, 3}, 0.9375, 0.5, 0.5, 1}, /* mean > 0: joined */
        {{-3, 1, 1, -3}, 0.0625, 0.5, 0.5, 2},
    };
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        Polygon piece[MAX_PIECES];
        double sum[3] = {0}, c[2];
        const int n = polygon_pieces(known[k].d, NULL, piece);
        CU_ASSERT_EQUAL(n, known[k].pieces);
        for (int q = 0; q < n; q++) {
            const double area = polygon_area(&piece[q], c);
            sum[0] += area;
            for (int a = 0; a < 2; a++) sum[1 + a] += area * c[a];
        }
        CHECK_CLOSE(sum[0], known[k].area, 1e-15);
        CHECK_CLOSE(sum[1], known[k].area * known[k].x, 1e-15);
        CHECK_CLOSE(sum[2], known[k].area * known[k].y, 1e-15);
    }
}

/* Moments and loads of random samples of linear fields; returns the largest weight. */
static void sample(Line fit[FIT], int samples, bool in_line, double field[QUANTITIES][1 + DIM])
{
    for (int k = 0; k < FIT; k++) fit[k] = (Line){0};
    for (int s = 0; s < samples; s++) {
        double r[DIM];
        const double W = random_in(0.1, 0.5);
        Line f = {0};
        for (int d = 0; d < DIM; d++) r[d] = d && in_line ? 0.3 * r[0] : random_in(-1, 1);
        for (int q = 0; q < QUANTITIES; q++) {
            f[q] = field[q][0];
            for (int d = 0; d < DIM; d++) f[q] += field[q][1 + d] * r[d];
        }
        fit[FIT_MOMENTS][M_ONE] += W;
        fit[FIT_VALUE] += W * f;
        for (int d = 0; d < DIM; d++) {
            fit[FIT_MOMENTS][M_FIRST + d] += W * r[d];
            fit[FIT_SLOPE + d] += W * r[d] * f;
            for (int e = d; e < DIM; e++)
                fit[FIT_MOMENTS][M_SECOND + pair(d, e)] += W * r[d] * r[e];
        }
    }
}

/* Three or more samples off a line give linear fields back; fewer, or a line of them, the mean. */
static void test_fits(void)
{
    double field[QUANTITIES][1 + DIM];
    Line fit[FIT];
    srand(3);
    for (int trial = 0; trial < 300; trial++) {
        const int samples = trial % 12;
        const bool in_line = trial % 5 == 0;
        for (int q = 0; q < QUANTITIES; q++)
            for (int d = 0; d <= DIM; d++) field[q][d] = random_in(-1, 1);
        sample(fit, samples, in_line, field);
        const bool fits = samples > DIM && !in_line;
        CU_ASSERT_EQUAL(wls_solve(fit, true, 0, 1e-10), fits);
        for (int q = 0; q < QUANTITIES; q++)
            for (int d = 0; d <= DIM; d++) {
                CU_ASSERT(isfinite(fit[FIT_VALUE + d][q]));
                if (fits) CHECK_CLOSE(fit[FIT_VALUE + d][q], field[q][d], 1e-9);
                if (!fits && d) CHECK_CLOSE(fit[FIT_VALUE + d][q], 0, 0);
            }
        sample(fit, 8, false, field);
        CU_ASSERT(!wls_solve(fit, false, 0, 1e-10)); /* no particle near */
    }
}

/* Largest error of the distances near the surface [h], and of the area of all cells. */
static void surface_errors(int cells, const char *distance, double *error, double *area)
{
    Trial t;
    char set[64];
    snprintf(set, sizeof set, "distance=%s", distance);
    trial_open(&t, "ring", "wls2", cells, set, 1);
    wls_assemble(t.sim, 0, true);
    const Grid *g = &t.sim->g;
    const Wls *w = wls_of(t.sim);
    *error = *area = 0;
    for (int row = 0; row + 1 < g->rows; row++)
        for (int i = g->lo[row]; i < g->hi[row]; i++) {
            const size_t at = (size_t)row * (size_t)g->n[0] + (size_t)i, up = at + (size_t)g->n[0];
            const int index[DIM] = {i, row};
            const double d[4] = {w->distance[at], w->distance[at + 1], w->distance[up],
                                 w->distance[up + 1]};
            double xi[MAX_POINTS][DIM], weight[MAX_POINTS];
            Bend bend[4];
            if (i < -g->origin[0] || row < -g->origin[1]) continue; /* beyond a symmetry line */
            if (w->skinned[at] && w->skin[at][0][K_ONE] > 0)
                *error = fmax(*error, fabs(d[0] - sim_distance(t.sim, index, 0)));
            if (i + 1 >= g->hi[row] || i < g->lo[row + 1] || i + 1 >= g->hi[row + 1]) continue;
            for (int k = 0; k < 4 && w->bend; k++)
                bend[k] = w->bend[(k > 1 ? up : at) + (size_t)(k & 1)];
            const int n = wls_cell_points(d, w->bend ? bend : NULL, QUADRATURE_EXACT, xi, weight);
            for (int q = 0; q < n; q++) *area += weight[q] / cells / cells;
        }
    const double R = 0.5 + trial_displacement(&t, 0.5), Ro = 1 + trial_displacement(&t, 1);
    *area = fabs(*area / (M_PI / 4 * (Ro * Ro - R * R)) - 1);
    trial_close(&t);
}

/* On the ring at t = 0, distance=normals: distances within .2 h at N = 16 and of second order, the
 * area of all cells within 3e-5 and of second order; curved: distances as good, the area of third.
 */
static void test_distances(void)
{
    double error, area, mean, unused;
    for (int cells = 16; cells <= 128; cells *= 2) {
        surface_errors(cells, "normals", &error, &area);
        CU_ASSERT(error < 0.2 * 16 / cells);
        CU_ASSERT(area < 3e-5 * (16.0 / cells) * (16.0 / cells));
        surface_errors(cells, "curved", &unused, &mean);
        CU_ASSERT(unused <= error && mean < 3.4e-7 * pow(32.0 / cells, 3));
        surface_errors(cells, "weighted_mean", &mean, &unused);
        CU_ASSERT(mean > 1.5 * error);
        surface_errors(cells, "exact", &error, &unused);
        CHECK_CLOSE(error, 0, 2e-9); /* a node on the surface is inside */
    }
}

/* 16 points of a whole cell: Gauss' are exact for x^7 y^7, even ones for 1, x, y; of a half, those
 * in it. */
static void test_sixteen_points(void)
{
    const double whole[4] = {1, 1, 1, 1}, half[4] = {0.5, -0.5, 0.5, -0.5};
    for (int gauss = 0; gauss < 2; gauss++) {
        double xi[MAX_POINTS][DIM], w[MAX_POINTS], sum = 0, x1 = 0, y7 = 0;
        const int rule = gauss ? QUADRATURE_GAUSS16 : QUADRATURE_SAMPLES16;
        CU_ASSERT_EQUAL(wls_cell_points(whole, NULL, rule, xi, w), 16);
        for (int q = 0; q < 16; q++) {
            sum += w[q];
            x1 += w[q] * xi[q][0];
            y7 += w[q] * pow(xi[q][0], 7) * pow(xi[q][1], 7);
        }
        CHECK_CLOSE(sum, 1, 1e-14);
        CHECK_CLOSE(x1, 0.5, 1e-14);
        CU_ASSERT((fabs(y7 - 1.0 / 64) < 1e-14) == gauss);
        CU_ASSERT_EQUAL(wls_cell_points(half, NULL, rule, xi, w), 8);
        for (int q = 0; q < 8; q++) CU_ASSERT(xi[q][0] < 0.5);
    }
}

/* What a node has of all particles and of their images beyond both symmetry lines: how many, the
 * largest weight, and the determinant of their moments over M_00^3. */
static void look_at_node(const Sim *sim, const double at[2], int *count, double *most, double *det)
{
    double m[6] = {0};
    *count = 0;
    *most = 0;
    for (int k = 0; k < 4 * sim->p.n; k++) {
        const int p = k / 4;
        double r[2], W = sim->p.id[p] >= 0 ? 1 : 0;
        for (int d = 0; d < 2; d++) {
            const double x = sim->p.field[AT_X + d][p] * sim->g.cells;
            r[d] = (k >> d & 1 ? -x : x) - at[d];
            const double a = fabs(r[d]);
            W *= a < 0.5 ? 0.75 - a * a : a < 1.5 ? 0.5 * (1.5 - a) * (1.5 - a) : 0;
        }
        const double f[6] = {1, r[0], r[1], r[0] * r[0], r[0] * r[1], r[1] * r[1]};
        for (int q = 0; q < 6; q++) m[q] += W * f[q];
        *count += W > 0;
        *most = fmax(*most, W);
    }
    *det = m[0] * (m[3] * m[5] - m[4] * m[4]) - m[1] * (m[1] * m[5] - m[4] * m[2]) +
           m[2] * (m[1] * m[4] - m[3] * m[2]);
    *det /= pow(m[0], 3);
}

/* Nodes are spurious by the test that the run names. */
static void test_conditions(void)
{
    static const char *const sets[] = {"condition=weight", "condition=determinant",
                                       "condition=count"};
    int spurious[3] = {0};
    for (int c = 0; c < 3; c++) {
        Trial t;
        trial_open(&t, "ring", "wls2", 8, sets[c], 1);
        wls_assemble(t.sim, 0, true);
        const Grid *g = &t.sim->g;
        for (int row = -g->origin[1]; row < g->rows; row++)
            for (int i = g->lo[row]; i < g->hi[row]; i++) {
                const double at[] = {i + g->origin[0], row + g->origin[1]};
                int count;
                double most, det;
                look_at_node(t.sim, at, &count, &most, &det);
                if (at[0] < 0 || count == 0) continue;
                const bool good = c == 0 ? most > 0.25 : c == 1 ? det > 1e-10 : count > 2;
                const bool is = wls_of(t.sim)->good[(size_t)row * (size_t)g->n[0] + (size_t)i];
                if (c < 2 || !good || det > 1e-12) CU_ASSERT_EQUAL(is, good);
                spurious[c] += !is;
            }
        trial_close(&t);
    }
    CU_ASSERT(spurious[0] > spurious[1] && spurious[1] >= spurious[2]);
}

static const TestCase tests[] = {
    {"what is in and what is out fill the square, all 16 masks", test_masks_complete},
    {"centroids have the area and first moments", test_centroids},
    {"triangle, quadrilateral, pentagon, square, saddle", test_known_shapes},
    {"fits give linear fields back, or the mean", test_fits},
    {"16 points of a cell", test_sixteen_points},
    {"spurious nodes by weight, determinant, count", test_conditions},
    {"distances are of second order, areas right", test_distances},
    {NULL, NULL},
};
CHECK_SUITE(tests)
