/* t_15_cut_cells.c: four ways to integrate over cut cells (W11 3.4): one point at the centroid,
 * points that are exact, and 16 Gauss or evenly spaced points of which those outside count nothing
 * (3.4.1). WLS2 on the ring with each; and a circle of radius 4 cells that slides through one cell:
 * how far the integral of the far corner's shape function, x y, jumps in a step of 10^-5 cells. */
#include <math.h>
#include "common/base/polygon.h"
#include "common/base/samples.h"
#include "studies/tables/curves.h"

static const char *const rules[] = {"centroid", "exact", "gauss16", "samples16"};
static const int cells[] = {8, 11, 16, 23, 32, 45, 64};
enum { RULES = 4, MESHES = 7, STEPS = 300000 /* of the slide, over 3 cells */, SHOWN = 300 };

static void cases(Cases *list, bool quick)
{
    for (int r = 0; r < RULES; r++)
        for (int k = 0; k < (quick ? 3 : MESHES); k++)
            case_add(list, "run ring --method wls2 --cells %d --set quadrature=%s", cells[k],
                     rules[r]);
}

/* Distances of the corners from a circle whose nearest point to the cell's first corner has come
 * `way` cells along the diagonal. */
static void corner_distances(double way, double d[4])
{
    const double radius = 4, centre = (way - radius) / sqrt(2);
    for (int k = 0; k < 4; k++) d[k] = radius - hypot((k & 1) - centre, (k >> 1) - centre);
}

/* Integral of x y over the part of the cell inside the circle. */
static double integral(int rule, const double d[4])
{
    double x[MOST_SAMPLES][3], flat[18][2], weight[MOST_SAMPLES], sum = 0;
    Polygon piece[MAX_PIECES];
    if (rule > 1) {
        const int n = samples_in_cell(2, d, rule == 2, x, weight);
        for (int q = 0; q < n; q++) sum += weight[q] * x[q][0] * x[q][1];
        return sum;
    }
    const int pieces = polygon_pieces(d, NULL, piece);
    for (int k = 0; k < pieces; k++) {
        double centre[2];
        const double area = polygon_area(&piece[k], centre);
        const int n = rule == 1 && area > 0 ? polygon_points(&piece[k], flat, weight) : 0;
        if (rule == 0 && area > 0) sum += area * centre[0] * centre[1];
        for (int q = 0; q < n; q++) sum += weight[q] * flat[q][0] * flat[q][1];
    }
    return sum;
}

static void tables(const Results *r)
{
    FILE *f = results_write(r, "slide", "way,centroid,exact,gauss16,samples16");
    double jump[RULES] = {0}, last[RULES] = {0}, d[4];
    for (int step = 0; step <= STEPS; step++) {
        const double way = -0.5 + 3.0 * step / (double)STEPS;
        corner_distances(way, d);
        if (step % (STEPS / SHOWN) == 0) results_print(f, "%.17g", way);
        for (int rule = 0; rule < RULES; rule++) {
            const double now = integral(rule, d);
            if (step > 0) jump[rule] = fmax(jump[rule], fabs(now - last[rule]));
            last[rule] = now;
            if (step % (STEPS / SHOWN) == 0) results_print(f, ",%.17g", now);
        }
        if (step % (STEPS / SHOWN) == 0) fputc('\n', f);
    }
    f = results_write(r, "jumps", "rule,jump");
    for (int rule = 0; rule < RULES; rule++)
        results_print(f, "%s,%.17g\n", rules[rule], jump[rule]);
}

static void check(Check *c, const Results *r)
{
    static const char *const labels[] = {"one point at the centroid", "exact points",
                                         "16 Gauss points", "16 evenly spaced points"};
    static const struct {
        double order_low, order_high, jump_low, jump_high;
    } seen[RULES] = {
        {1.4, 2.1, 0, 1e-4}, {1.8, 2.2, 0, 1e-4}, {-0.2, 1, 0.02, 0.2}, {0.2, 1.3, 0.02, 0.2}};
    const Table *jumps = results_part(r, "jumps");
    for (int k = 0; k < RULES; k++) {
        claim(
            c, phrase("T-15.order-%s", rules[k]),
            phrase("WLS2 on the ring, cut cells by %s: order of the largest error, N = 16 to 64",
                   labels[k]),
            curve_order_in_h(r->rows, "error_linf", 16, 64, MESHES - 2, "quadrature=%s", rules[k]),
            seen[k].order_low, seen[k].order_high);
        claim(
            c, phrase("T-15.jump-%s", rules[k]),
            phrase("Circle sliding through a cell, %s: largest change of the integral of x y in a "
                   "step of 1e-5 cells",
                   labels[k]),
            select_value(jumps, "jump", "rule=%s", rules[k]), seen[k].jump_low, seen[k].jump_high);
    }
    claim(
        c, "T-15.gauss16-64",
        "WLS2 on the ring, N = 64: largest error with 16 Gauss points in cut cells over that with "
        "exact points",
        measure_ratio(select_value(r->rows, "error_linf", "cells=64 quadrature=gauss16"),
                      select_value(r->rows, "error_linf", "cells=64 quadrature=exact")),
        5, 20);
}

const StudyPage study_t_15_cut_cells = {
    .cases = cases, .tables = tables, .check = check, .claims = 9};
