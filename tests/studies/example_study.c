/* t_90_free_bar.c: convergence of GIMP and GE-GIMP on the free bar. */
#include "studies/tables/curves.h"

static const int cells[] = {10, 20, 40, 80};
enum { MESHES = sizeof cells / sizeof *cells };

static void cases(Cases *list, bool quick)
{
    for (int k = 0; k < (quick ? 2 : MESHES); k++) {
        case_add(list, "run free_bar --method gimp --cells %d", cells[k]);
        case_add(list, "run free_bar --method ge_gimp --cells %d", cells[k]);
    }
}

static void check(Check *c, const Results *r)
{
    Curve gimp, ge;
    curve_pick(&gimp, r->rows, "h", "error_linf", "method=gimp");
    curve_pick(&ge, r->rows, "h", "error_linf", "method=ge_gimp");
    claim(c, "T-90.order", "GIMP converges on the free bar: order over four meshes",
          curve_order(&gimp, 0, 1, MESHES), 0.8, 2.2);
    claim(c, "T-90.ratio", "GE-GIMP's largest error over GIMP's, mean over four meshes",
          curve_mean_ratio(&ge, &gimp, MESHES), 0.2, 1);
}

const StudyPage study_t_90_free_bar = {.cases = cases, .check = check, .claims = 2};
