/* w07_10_squeeze_meshes.c: the plateau of fig. 9 falls with the cell size squared. GE-GIMP,
 * quadratic field, three meshes. Wallstedt and Guilkey (2007), fig. 10. */
#include <math.h>
#include "squeeze.h"

enum { MESHES = 3 };
static const int cells[MESHES] = {50, 100, 200};
static const double printed[MESHES] = {6.440e-5, 1.642e-5, 4.146e-6}; /* at 10 particles per cell */

static void cases(Cases *list, bool quick)
{
    for (int k = 0; k < MESHES; k++)
        squeeze_add(list, "ge_gimp", "quadratic", cells[k], cells[k] / 50, quick);
}

static void check(Check *c, const Results *r)
{
    Curve errors = {0};
    Measure off = measure_max_of(MESHES);
    for (int k = 0; k < MESHES; k++) {
        const Measure error = select_value(r->rows, "error_linf", "cells=%d ppc=10", cells[k]);
        curve_add(&errors, 1.0 / cells[k], error);
        measure_add_max(&off, fabs(error.value / printed[k] - 1));
    }
    claim(c, "W07-10.order",
          "Squeeze, quadratic field: the plateau falls with h^2: order at 10 particles per cell",
          curve_order(&errors, 0, 1, MESHES), 1.97, 1.99);
    claim(c, "W07-10.values",
          "Squeeze, quadratic field: GE-GIMP's plateaus: largest departure from the recorded "
          "6.440e-5, 1.642e-5, 4.146e-6",
          off, 0, 0.001);
}

const StudyPage study_w07_10_squeeze_meshes = {.cases = cases, .check = check, .claims = 2};
