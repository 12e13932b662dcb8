/* w11_02_squares.c: the shapes of a cut cell: triangle, quadrilateral, pentagon, square, saddle.
 * Wallstedt and Guilkey (2011), fig. 2; eq 18. */
#include <math.h>
#include "common/base/polygon.h"
#include "studies/tables/curves.h"

enum { SHAPES = 6, MASKS = 16 };

/* Distances at corners (0,0), (1,0), (0,1), (1,1). */
static const double shapes[SHAPES][4] = {
    {0.7, -0.5, -0.3, -1.2}, {0.4, 0.7, -0.6, -0.3}, {0.9, 0.5, 0.4, -0.4},
    {0.8, 0.6, 0.9, 0.7},    {0.7, -0.4, -0.5, 0.6}, {0.5, -0.6, -0.7, 0.4},
};

static void tables(const Results *r)
{
    FILE *f = results_write(r, "", "shape,piece,k,x,y,d00,d10,d01,d11");
    for (int s = 0; s < SHAPES; s++) {
        Polygon piece[MAX_PIECES];
        const double *d = shapes[s];
        const int n = polygon_pieces(d, NULL, piece);
        for (int p = 0; p < n; p++)
            for (int k = 0; k <= piece[p].n; k++) { /* closed */
                const double *x = piece[p].x[k % piece[p].n];
                results_print(f, "%d,%d,%d,%.17g,%.17g,%g,%g,%g,%g\n", s, p, k, x[0], x[1], d[0],
                              d[1], d[2], d[3]);
            }
    }
}

/* Area and first moments of the triangle that a corner's own cuts leave: legs a and b along the
 * two edges, from the corner (x, y), which point into the square by sx and sy. */
static void add_corner(const double d[4], int k, double sign, double sum[3])
{
    const double x = k & 1, y = k >> 1, sx = 1 - 2 * x, sy = 1 - 2 * y;
    const double a = d[k] / (d[k] - d[k ^ 1]), b = d[k] / (d[k] - d[k ^ 2]),
                 area = sign * a * b / 2;
    sum[0] += area;
    sum[1] += area * (x + sx * a / 3);
    sum[2] += area * (y + sy * b / 3);
}

/* Two corners of one edge inside: a trapezoid of heights p at `k` and q at its neighbour. */
static void add_edge(const double d[4], int k, int along, double sum[3])
{
    const int other = k ^ along, up = 3 - along;
    const double p = d[k] / (d[k] - d[k ^ up]), q = d[other] / (d[other] - d[other ^ up]);
    const double area = (p + q) / 2, first = (p + 2 * q) / 6, height = (p * p + p * q + q * q) / 6;
    const double base = (k & up) ? 1 : 0, into = base > 0 ? -1 : 1;
    const double m_up = base * area + into * height; /* k is the lower end along the edge */
    sum[0] = area;
    sum[along] = first;
    sum[up] = m_up;
}

/* Area and first moments of the shape by hand: corners alone, edges, or what is left of a square.
 */
static void by_hand(const double d[4], double sum[3])
{
    int mask = 0, n = 0;
    for (int k = 0; k < 4; k++) mask |= (d[k] > 0) << k, n += d[k] > 0;
    const bool saddle = mask == 9 || mask == 6;
    const bool full = n > 2 || (saddle && d[0] + d[1] + d[2] + d[3] > 0);
    for (int m = 0; m < 3; m++) sum[m] = full ? (m ? 0.5 : 1) : 0;
    if (n == 2 && !saddle)
        add_edge(d, mask == 12 ? 2 : mask == 10 ? 1 : 0, mask == 3 || mask == 12 ? 1 : 2, sum);
    else
        for (int k = 0; k < 4; k++)
            if ((d[k] > 0) != full) add_corner(d, k, full ? -1 : 1, sum);
}

/* Departure of area and centroid times area from those by hand. */
static double departure(const double d[4])
{
    double sum[3], own[3] = {0, 0, 0}, worst = 0;
    Polygon piece[MAX_PIECES];
    const int n = polygon_pieces(d, NULL, piece);
    by_hand(d, sum);
    for (int p = 0; p < n; p++) {
        double centre[2] = {0, 0};
        const double area = polygon_area(&piece[p], centre);
        own[0] += area;
        own[1] += area * centre[0];
        own[2] += area * centre[1];
    }
    for (int m = 0; m < 3; m++) worst = measure_worse(worst, fabs(own[m] - sum[m]));
    return worst;
}

/* Over all masks, each with many sizes of the distances (saddles get both signs of the mean). */
static double worst_departure(int *masks)
{
    enum { TRIES = 1000 };
    unsigned long state = 1;
    double worst = 0;
    for (*masks = 0; *masks < MASKS; ++*masks)
        for (int k = 0; k < TRIES; k++) {
            double d[4];
            for (int corner = 0; corner < 4; corner++) {
                state = (state * 1103515245 + 12345) % 2147483648;
                const double size = 0.01 + (double)state / 2147483648;
                d[corner] = *masks >> corner & 1 ? size : -size;
            }
            worst = measure_worse(worst, departure(d));
        }
    return worst;
}

/* A straight boundary passes through the cell: largest change of the area inside per length that it
 * moves, which is its own length in the cell, at most sqrt(2). */
static double fastest_change(void)
{
    enum { ANGLES = 90, STEPS = 2000 };
    const double step = 3.0 / (double)STEPS;
    double most = 0;
    for (int a = 0; a < ANGLES; a++) {
        const double nx = cos(2 * M_PI * a / (double)ANGLES),
                     ny = sin(2 * M_PI * a / (double)ANGLES);
        double before = 0;
        for (int k = 0; k < STEPS; k++) {
            double d[4], area = 0;
            Polygon piece[MAX_PIECES];
            for (int corner = 0; corner < 4; corner++) {
                const double x = (corner & 1) - 0.5, y = (corner >> 1) - 0.5;
                d[corner] = k * step - 1.5 + nx * x + ny * y;
            }
            const int n = polygon_pieces(d, NULL, piece);
            for (int p = 0; p < n; p++) area += polygon_area(&piece[p], (double[2]){0, 0});
            if (k) most = measure_worse(most, fabs(area - before) / step);
            before = area;
        }
    }
    return most;
}

static void check(Check *c, const Results *r)
{
    int masks;
    (void)r;
    const double worst = worst_departure(&masks);
    claim(c, "W11-2.masks",
          "Cut cell, all 16 patterns of corners inside, a thousand distances each: area and first "
          "moments of the shape against formulas by hand, largest departure",
          measure_formula(worst), 0, 1e-12);
    claim_note(c, "masks", masks);
    claim(c, "W11-2.smooth",
          "Cut cell: the area inside varies smoothly as a boundary passes: largest change per "
          "length moved, in cell sides (a jump of the whole cell would give 667)",
          measure_formula(fastest_change()), 1, 1.001 * M_SQRT2);
}

const StudyPage study_w11_02_squares = {.tables = tables, .check = check, .claims = 2};
