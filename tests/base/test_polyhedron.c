/* test_polyhedron.c: marching cubes without a table: all 256 masks. */
#include <stdlib.h>
#include "common/base/polygon.h"
#include "common/base/solid.h"
#include "tests/check.h"

enum { MASKS = 256, MOMENTS = 10 };

static double random_in(double lo, double hi)
{
    return lo + (hi - lo) * (double)rand() / RAND_MAX;
}

static void random_cube(int mask, double d[8])
{
    for (int k = 0; k < 8; k++) d[k] = (mask >> k & 1 ? 1 : -1) * random_in(0.01, 1);
}

/* 1, x, y, z, xx, xy, xz, yy, yz, zz over the cube's pieces, from their centroids and second
 * moments. */
static void add_moments(const Polyhedron *p, double sum[MOMENTS])
{
    for (int m = 0; m < MOMENTS; m++) sum[m] = 0;
    for (int piece = 0; piece < p->pieces; piece++) {
        Solid s;
        solid_measure(p, piece, true, &s);
        CU_ASSERT(s.volume >= 0);
        sum[0] += s.volume;
        for (int a = 0, m = 4; a < 3; a++) {
            sum[1 + a] += s.volume * s.centroid[a];
            for (int b = a; b < 3; b++, m++)
                sum[m] += s.second[tensor_index(a, b)] + s.volume * s.centroid[a] * s.centroid[b];
        }
    }
}

/* The same by the integration points, all of which lie in the cube. */
static int add_points(const Polyhedron *p, double sum[MOMENTS])
{
    int matched = 0;
    for (int m = 0; m < MOMENTS; m++) sum[m] = 0;
    for (int piece = 0; piece < p->pieces; piece++) {
        double x[MAX_SOLID_POINTS][3], w[MAX_SOLID_POINTS];
        Solid s;
        solid_measure(p, piece, true, &s);
        const int n = solid_points(p, piece, &s, x, w);
        CU_ASSERT_FATAL(n <= MAX_SOLID_POINTS);
        matched += n == 8;
        for (int q = 0; q < n; q++) {
            sum[0] += w[q];
            for (int a = 0, m = 4; a < 3; a++) {
                CU_ASSERT(x[q][a] >= 0 && x[q][a] <= 1);
                sum[1 + a] += w[q] * x[q][a];
                for (int b = a; b < 3; b++, m++) sum[m] += w[q] * x[q][a] * x[q][b];
            }
        }
    }
    return matched;
}

/* What is in and what is out fill the cube; points integrate quadratic polynomials exactly. */
static void test_complete(void)
{
    static const double whole[MOMENTS] = {1,    0.5,  0.5,     0.5,  1.0 / 3,
                                          0.25, 0.25, 1.0 / 3, 0.25, 1.0 / 3};
    int matched = 0;
    srand(1);
    for (int k = 0; k < MASKS * 40; k++) {
        double d[8], in[MOMENTS], out[MOMENTS], points[MOMENTS];
        Polyhedron p;
        random_cube(k % MASKS, d);
        polyhedron_make(d, NULL, &p);
        CU_ASSERT(p.pieces <= 4 && p.faces <= MAX_FACES);
        add_moments(&p, in);
        matched += add_points(&p, points);
        for (int c = 0; c < 8; c++) d[c] = -d[c];
        polyhedron_make(d, NULL, &p);
        add_moments(&p, out);
        CHECK_CLOSE(in[0] + out[0], 1, 1e-15);
        for (int m = 0; m < MOMENTS; m++) {
            CHECK_CLOSE(in[m] + out[m], whole[m], 1e-14);
            CHECK_CLOSE(points[m], in[m], 1e-14);
        }
    }
    CU_ASSERT(matched > MASKS * 20); /* both rules were met */
}

/* The faces of every piece enclose it: their vector areas sum to nothing. Most masks have one face
 * of the surface; eight always have several, some of twelve sides. */
static void test_closed(void)
{
    int several = 0, most = 0;
    srand(2);
    for (int mask = 0; mask < MASKS; mask++) {
        int fewest = 4;
        for (int k = 0; k < 50; k++) {
            double d[8], area[4][3] = {{0}};
            int cuts = 0;
            Polyhedron p;
            random_cube(mask, d);
            polyhedron_make(d, NULL, &p);
            for (const Face *f = p.face; f < p.face + p.faces; f++) {
                cuts += f->cut;
                most = f->sides > most ? f->sides : most;
                for (int j = 0; j < f->sides; j++) {
                    const double *a = p.x[f->vertex[j]], *b = p.x[f->vertex[(j + 1) % f->sides]];
                    for (int c = 0; c < 3; c++)
                        area[f->piece][c] += 0.5 * (a[(c + 1) % 3] * b[(c + 2) % 3] -
                                                    a[(c + 2) % 3] * b[(c + 1) % 3]);
                }
            }
            fewest = cuts < fewest ? cuts : fewest;
            for (int piece = 0; piece < p.pieces; piece++)
                for (int c = 0; c < 3; c++) CHECK_CLOSE(area[piece][c], 0, 1e-14);
        }
        several += fewest > 1;
    }
    CU_ASSERT_EQUAL(several, 8);
    CU_ASSERT_EQUAL(most, 12);
}

/* Corner k under one of the 48 symmetries of the cube: axes exchanged, then mirrored. */
static int image_of(int k, int symmetry)
{
    static const int axes[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                   {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    int out = symmetry & 7;
    for (int a = 0; a < 3; a++) out ^= (k >> a & 1) << axes[symmetry >> 3][a];
    return out;
}

static bool is_rotation(int symmetry)
{
    const int flips = (symmetry & 1) + (symmetry >> 1 & 1) + (symmetry >> 2 & 1);
    return flips % 2 == (symmetry >> 3 > 2);
}

static int image_mask(int mask, int symmetry)
{
    int out = 0;
    for (int k = 0; k < 8; k++) out |= (mask >> k & 1) << image_of(k, symmetry);
    return out;
}

/* The shape moves with its distances, for all symmetries; so does its volume. */
static void test_symmetries(void)
{
    srand(3);
    for (int k = 0; k < MASKS * 48; k++) {
        double d[8], e[8], a[MOMENTS], b[MOMENTS];
        Polyhedron p;
        random_cube(k % MASKS, d);
        for (int c = 0; c < 8; c++) e[image_of(c, k / MASKS)] = d[c];
        polyhedron_make(d, NULL, &p);
        add_moments(&p, a);
        polyhedron_make(e, NULL, &p);
        add_moments(&p, b);
        CHECK_CLOSE(a[0], b[0], 1e-15);
        CHECK_CLOSE(a[4] + a[7] + a[9] - a[1] - a[2] - a[3],
                    b[4] + b[7] + b[9] - b[1] - b[2] - b[3],
                    1e-14); /* integral of x (x - 1) + ... */
    }
}

/* Masks that no symmetry of a group turns into each other. */
static int classes(bool reflections, bool complements)
{
    int count = 0;
    for (int mask = 0; mask < MASKS; mask++) {
        int least = mask;
        for (int s = 0; s < 48; s++) {
            const int image = image_mask(mask, s), other = MASKS - 1 - image;
            if (!reflections && !is_rotation(s)) continue;
            least = image < least ? image : least;
            least = complements && other < least ? other : least;
        }
        count += least == mask;
    }
    return count;
}

static void test_classes(void)
{
    CU_ASSERT_EQUAL(classes(false, true), 15); /* W11 3.4 */
    CU_ASSERT_EQUAL(classes(false, false), 23);
    CU_ASSERT_EQUAL(classes(true, false), 22);
    CU_ASSERT_EQUAL(classes(true, true), 14);
}

/* Area of the part of side x = `at` that is in, and the number of its corners. */
static double side_area(const Polyhedron *p, double at, int *corners)
{
    double area = 0;
    *corners = 0;
    for (const Face *f = p->face; f < p->face + p->faces; f++) {
        double own = 0, off = 0;
        for (int j = 0; j < f->sides; j++) {
            const double *a = p->x[f->vertex[j]], *b = p->x[f->vertex[(j + 1) % f->sides]];
            own += 0.5 * (a[1] * b[2] - a[2] * b[1]);
            off = fmax(off, fabs(a[0] - at));
        }
        if (f->cut || off > 0) continue;
        area += fabs(own);
        *corners += f->sides;
    }
    return area;
}

/* Two cubes side by side cut the side between them alike; as polygon.h cuts that square. */
static void test_neighbours(void)
{
    srand(4);
    for (int k = 0; k < 20000; k++) {
        double d[8], e[8], square[4], flat = 0, centre[2];
        int own, other;
        Polyhedron p, q;
        Polygon piece[MAX_PIECES];
        random_cube(rand() % MASKS, d);
        random_cube(rand() % MASKS, e);
        for (int c = 0; c < 8; c += 2) e[c] = square[c / 2] = d[c + 1];
        polyhedron_make(d, NULL, &p);
        polyhedron_make(e, NULL, &q);
        const double area = side_area(&p, 1, &own), area2 = side_area(&q, 0, &other);
        const int pieces = polygon_pieces(square, NULL, piece);
        for (int j = 0; j < pieces; j++) flat += polygon_area(&piece[j], centre);
        CHECK_CLOSE(area, area2, 1e-15);
        CHECK_CLOSE(area, flat, 1e-15);
        CU_ASSERT_EQUAL(own, other);
    }
}

/* Relative error of the volume of an eighth of the unit ball on N cells, with exact distances and,
 * if asked for, exact curvature. */
static double ball_error(int N, bool curved)
{
    double volume = 0;
    for (int cell = 0; cell < N * N * N; cell++) {
        double d[8];
        CurvatureTensor K[8];
        Polyhedron p;
        for (int k = 0; k < 8; k++) {
            const double x[3] = {cell % N + (k & 1), cell / N % N + (k >> 1 & 1),
                                 cell / N / N + (k >> 2 & 1)};
            const double r = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
            d[k] = N - r;
            for (int a = 0; a < 3; a++)
                for (int b = a; b < 3; b++)
                    K[k][tensor_index(a, b)] = ((a == b) - (r > 0 ? x[a] * x[b] / r / r : 0)) / N;
        }
        polyhedron_make(d, curved ? (const CurvatureTensor *)K : NULL, &p);
        for (int piece = 0; piece < p.pieces; piece++) {
            Solid s;
            solid_measure(&p, piece, true, &s);
            volume += s.volume;
        }
    }
    return volume / (M_PI / 6 * N * N * N) - 1;
}

/* Of second order, -.597/N^2; with curvature of fourth. */
static void test_ball(void)
{
    const double coarse = ball_error(16, false), fine = ball_error(32, false);
    CHECK_CLOSE(log2(coarse / fine), 2, 0.02);
    CHECK_CLOSE(fine * 32 * 32, -0.597, 0.005);
    CU_ASSERT(log2(ball_error(16, true) / ball_error(32, true)) > 3.8);
    CU_ASSERT(fabs(ball_error(32, true)) < 1e-6);
}

static const TestCase tests[] = {
    {"what is in and what is out fill the cube, all 256 masks", test_complete},
    {"faces enclose every piece", test_closed},
    {"48 symmetries", test_symmetries},
    {"classes of masks", test_classes},
    {"neighbours agree", test_neighbours},
    {"volume of a ball: second order, fourth with curvature", test_ball},
    {NULL, NULL},
};
CHECK_SUITE(tests)
