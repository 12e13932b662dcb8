/* w07_09_squeeze_quadratic_ge.c: the squeeze of fig. 6 with and without gradient enhancement: with
 * it the plateau is reached below one particle per cell. Wallstedt and Guilkey (2007), fig. 9. */
#include "squeeze.h"

static void cases(Cases *list, bool quick)
{
    squeeze_add_quadratic(list, "mpm gimp ge_mpm ge_gimp", quick);
}

static void check(Check *c, const Results *r)
{
    const double plateau = squeeze_plateau();
    Curve ge_mpm, ge_gimp;
    claim_note(c, "plateau", plateau);
    curve_pick(&ge_mpm, r->rows, "ppc", "error_linf", "method=ge_mpm");
    curve_pick(&ge_gimp, r->rows, "ppc", "error_linf", "method=ge_gimp");
    claim(c, "W07-9.ge-gimp-settles",
          "Squeeze, quadratic field: GE-GIMP stays within twice the plateau from this many "
          "particles per cell on",
          curve_settles(&ge_gimp, 2 * plateau, SQUEEZE_POINTS), 0.8, 0.9);
    claim(c, "W07-9.ge-mpm-settles",
          "Squeeze, quadratic field: GE-MPM stays within twice the plateau from this many "
          "particles per cell on",
          curve_settles(&ge_mpm, 2 * plateau, SQUEEZE_POINTS), 0.8, 0.9);
    claim(c, "W07-9.ge-mpm-plateau",
          "Squeeze, quadratic field: GE-MPM has the plateau of fig. 6: error at 10 particles per "
          "cell over h^2/6/(1+h)^2 (1 + 1/200)",
          squeeze_at_ten(&ge_mpm), 0.999, 1.001);
    claim(c, "W07-9.ge-gimp-plateau",
          "Squeeze, quadratic field: GE-GIMP has the plateau of fig. 6: error at 10 particles per "
          "cell over h^2/6/(1+h)^2 (1 + 1/200)",
          squeeze_at_ten(&ge_gimp), 0.999, 1.001);
    claim(c, "W07-9.ge-gimp-spot",
          "Squeeze, quadratic field: GE-GIMP's error with 137 particles, an agreed value to six "
          "digits",
          curve_at(&ge_gimp, 1.37), 2.077904e-5 - 5e-12, 2.077904e-5 + 5e-12);
}

const StudyPage study_w07_09_squeeze_quadratic_ge = {.cases = cases, .check = check, .claims = 5};
