/* points.c: where the part of a cell inside the body is integrated (W11 3.4): one point at the
 * centroid of each piece; points that are exact for quadratic polynomials; or those of 16 points
 * (4 per axis) that lie inside, which the paper discusses and drops (3.4.1). See wls.h. */
#include <math.h>
#include <string.h>
#include "wls.h"
#include "common/base/polygon.h"
#include "common/base/samples.h"
#include "common/base/solid.h"

_Static_assert(DIM < 3 || (int)MAX_POINTS >= (int)MAX_SOLID_POINTS, "points of a cell");

/* The part of a line where the distance is positive: one point, or two of Gauss. */
static int line_points(const double d[2], bool exact, double x[][2], double weight[])
{
    if (!(d[0] > 0) && !(d[1] > 0)) return 0;
    const double cut = d[0] / (d[0] - d[1]);
    const double from = d[0] > 0 ? 0 : cut, to = d[1] > 0 ? 1 : cut;
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from) / sqrt(3);
    const int n = exact ? 2 : 1;
    for (int q = 0; q < n; q++) {
        x[q][0] = middle + (exact ? (2 * q - 1) * half : 0);
        weight[q] = (to - from) / n;
    }
    return n;
}

static int square_points(const double d[4], const Curved *curved, bool exact, double x[][2],
                         double weight[])
{
    Polygon piece[MAX_PIECES];
    int n = 0;
    const int pieces = polygon_pieces(d, curved, piece);
    for (int k = 0; k < pieces; k++) {
        const double area = polygon_area(&piece[k], x[n]);
        if (!(area > 0)) continue;
        weight[n] = area;
        n += exact ? polygon_points(&piece[k], x + n, weight + n) : 1;
    }
    return n;
}

/* Points of a line or a square. */
static int flat_points(const double distance[CORNERS], const Bend *bend, bool exact,
                       double xi[MAX_POINTS][DIM], double weight[MAX_POINTS])
{
    double x[MAX_POINTS][2] = {{0}}, d[4] = {-1, -1, -1, -1};
    Curved curved = {{0}, {{0}}};
    for (int k = 0; k < 4 && k < CORNERS; k++) {
        d[k] = distance[k];
        if (bend) curved.kappa[k] = bend[k].kappa[0];
        for (int a = 0; a < 2 && bend; a++) curved.normal[k][a] = bend[k].normal[a % DIM];
    }
    const int n = DIM == 1 ? line_points(d, exact, x, weight)
                           : square_points(d, bend ? &curved : NULL, exact, x, weight);
    for (int q = 0; q < n; q++)
        for (int a = 0; a < DIM; a++) xi[q][a] = x[q][a % 2];
    return n;
}

void wls_cell_shape(const double distance[CORNERS], const Bend *bend, Polyhedron *out)
{
    CurvatureTensor K[8];
    double d[8];
    for (int k = 0; k < 8; k++) {
        d[k] = distance[k % CORNERS];
        for (int j = 0; j < 6 && bend; j++) K[k][j] = bend[k % CORNERS].kappa[j % BENDS];
    }
    polyhedron_make(d, bend ? (const CurvatureTensor *)K : NULL, out);
}

static int cube_points(const double distance[CORNERS], const Bend *bend, bool exact,
                       double xi[MAX_POINTS][DIM], double weight[MAX_POINTS])
{
    Polyhedron shape;
    int n = 0;
    wls_cell_shape(distance, bend, &shape);
    for (int piece = 0; piece < shape.pieces; piece++) {
        double x[MAX_SOLID_POINTS][3];
        Solid solid;
        solid_measure(&shape, piece, exact, &solid);
        if (!(solid.volume > 0)) continue;
        const int own = exact ? solid_points(&shape, piece, &solid, x, weight + n) : 1;
        if (!exact) weight[n] = solid_centre(&solid, x[0]);
        for (int q = 0; q < own; q++, n++)
            for (int a = 0; a < DIM; a++) xi[n][a] = x[q][a];
    }
    return n;
}

/* Straight surfaces alone: with curved ones, too, the chord decides what is inside. */
static int sample_points(const double distance[CORNERS], bool gauss, double xi[MAX_POINTS][DIM],
                         double weight[MAX_POINTS])
{
    double x[MOST_SAMPLES][3], share[MOST_SAMPLES];
    const int n = samples_in_cell(DIM, distance, gauss, x, share);
    for (int q = 0; q < n; q++) {
        for (int a = 0; a < DIM; a++) xi[q][a] = x[q][a];
        weight[q] = share[q];
    }
    return n;
}

int wls_cell_points(const double distance[CORNERS], const Bend *bend, int quadrature,
                    double xi[MAX_POINTS][DIM], double weight[MAX_POINTS])
{
    const bool exact = quadrature == QUADRATURE_EXACT;
    if (quadrature >= QUADRATURE_GAUSS16)
        return sample_points(distance, quadrature == QUADRATURE_GAUSS16, xi, weight);
    return DIM < 3 ? flat_points(distance, bend, exact, xi, weight)
                   : cube_points(distance, bend, exact, xi, weight);
}
