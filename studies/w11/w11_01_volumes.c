/* w11_01_volumes.c: how the material's volume is divided: triangles of FEM, boxes of GIMP's
 * particles, full and cut cells of WLS. Wallstedt and Guilkey (2011), fig. 1. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "studies/tables/curves.h"
#include "studies/tables/patches.h"

enum { CELLS = 8, FINE = 2000 /* samples per metre */, CORNERS = 200, BOXES = 100 };
static const double late_inner = 0.375, late_outer = 0.9; /* of the exact solution at 10 ms */

static const char *const methods[] = {"wls", "wls2"};

static void cases(Cases *list, bool quick)
{
    (void)quick;
    case_add_with(list, "patches", "fem", "run ring --method fem --cells %d --t-end .01", CELLS);
    case_add_with(list, "particles", "gimp", "run ring --method gimp --cells %d --t-end .01",
                  CELLS);
    case_add_with(list, "patches", "wls", "run ring --method wls --cells %d --t-end .01", CELLS);
    for (int n = 16; n <= 32; n *= 2)
        for (int m = 0; m < 2; m++)
            case_add_with(list, "patches", phrase("%s.%d", methods[m], n),
                          "run ring --method %s --cells %d --set steps=1", methods[m], n);
    case_add_with(list, "patches", "corners",
                  "run block --method wls --cells %d --set dim=2 --set steps=1 --set offset_x=.3 "
                  "--set offset_y=.3",
                  CELLS);
}

/* Sum of the areas of all polygons in a file of patches, over the area there should be. */
static Measure area_of(const Results *r, const char *part, double right)
{
    Patches p = patches_open(results_path(r, part));
    double twice = 0, first[2] = {0}, last[2] = {0};
    while (patches_next(&p)) {
        if (p.k == 0) memcpy(first, p.x, sizeof first);
        /* a fan about the first corner */
        twice +=
            (last[0] - first[0]) * (p.x[1] - first[1]) - (p.x[0] - first[0]) * (last[1] - first[1]);
        memcpy(last, p.x, sizeof last);
    }
    return measure(p.corners ? twice / 2 / right : NAN, p.corners, CORNERS);
}

/* Lays GIMP's boxes (half width h/4 times Fxx, Fyy) onto samples of the plane. */
static void lay_boxes(const Table *t, unsigned char *times)
{
    const double fine = FINE, l = 0.25 / (double)CELLS;
    for (int row = 0; row < t->nrow; row++) {
        const double x = select_number(t, row, "x"), y = select_number(t, row, "y");
        const double a = l * select_number(t, row, "Fxx"), b = l * select_number(t, row, "Fyy");
        const int i0 = (int)fmax(0, ceil((x - a) * fine - 0.5));
        const int j0 = (int)fmax(0, ceil((y - b) * fine - 0.5));
        for (int j = j0; j < FINE && j + 0.5 < (y + b) * fine; j++)
            for (int i = i0; i < FINE && i + 0.5 < (x + a) * fine; i++) times[j * FINE + i]++;
    }
}

/* Gaps and overlaps of the boxes as parts of the exact area. */
static void count_boxes(const unsigned char *times, double *gaps, double *overlaps)
{
    long in = 0, empty = 0, twice = 0;
    for (int j = 0; j < FINE; j++)
        for (int i = 0; i < FINE; i++) {
            const double r = hypot(i + 0.5, j + 0.5) / (double)FINE;
            const bool inside = r > late_inner && r < late_outer;
            in += inside;
            empty += inside && !times[j * FINE + i];
            twice += times[j * FINE + i] > 1 ? times[j * FINE + i] - 1 : 0;
        }
    *gaps = (double)empty / (double)in;
    *overlaps = (double)twice / (double)in;
}

static int measure_boxes(const Results *r, double *gaps, double *overlaps)
{
    const Table *t = results_run(r, "gimp");
    unsigned char *times = calloc((size_t)FINE * FINE, 1);
    *gaps = *overlaps = NAN;
    if (t->nrow && times) {
        lay_boxes(t, times);
        count_boxes(times, gaps, overlaps);
    }
    free(times);
    return t->nrow;
}

/* At the start, where the radii are known. */
static void check_areas(Check *c, const Results *r, double ring)
{
    static const double most[2][2] = {{4e-4, 1.2e-4}, {3e-5, 1e-5}};
    for (int m = 0; m < 2; m++)
        for (int k = 0; k < 2; k++) {
            const int n = 16 << k;
            const Measure area = area_of(r, phrase("%s.%d", methods[m], n), ring);
            claim(c, phrase("W11-1.%s-%d", methods[m], n),
                  phrase("%s's cells cover the ring: error of their area, N = %d",
                         m ? "WLS2" : "WLS", n),
                  measure_with(area, fabs(area.value - 1)), 0, most[m][k]);
        }
    const Measure block = area_of(r, "corners", 1);
    claim(c, "W11-1.corners",
          "WLS rounds corners: area missing from a square block, .3 cells off the grid's lines "
          "[cells]",
          measure_with(block, (1 - block.value) * (double)CELLS * (double)CELLS), 0.5, 3);
}

static void check(Check *c, const Results *r)
{
    static const double ring = M_PI / 4 * (1.1 * 1.1 - 0.625 * 0.625); /* at the start */
    const double late = M_PI / 4 * (late_outer * late_outer - late_inner * late_inner);
    double gaps, overlaps;
    check_areas(c, r, ring);
    const int boxes = measure_boxes(r, &gaps, &overlaps);
    claim(c, "W11-1.gimp-gaps", "GIMP's boxes leave gaps: part of the ring at 10 ms, N = 8",
          measure(gaps, boxes, BOXES), 0.01, 0.04);
    claim(c, "W11-1.gimp-overlaps",
          "GIMP's boxes overlap: part of the ring at 10 ms covered more than once, N = 8",
          measure(overlaps, boxes, BOXES), 0.003, 0.02);
    const Measure drawn = area_of(r, "wls", late);
    claim(c, "W11-1.late",
          "WLS divides the body better than GIMP at 10 ms, N = 8: error of its area over GIMP's "
          "gaps and overlaps",
          measure(fabs(drawn.value - 1) / (gaps + overlaps), drawn.rows, CORNERS / 2), 0, 0.5);
    claim_note(c, "cells", CELLS);
    claim_note(c, "gaps", gaps);
    claim_note(c, "overlaps", overlaps);
    claim_note(c, "error_fem", area_of(r, "fem", late).value - 1);
    claim_note(c, "error_wls", drawn.value - 1);
}

const StudyPage study_w11_01_volumes = {.cases = cases, .check = check, .claims = 8};
