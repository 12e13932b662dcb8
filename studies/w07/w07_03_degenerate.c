/* w07_03_degenerate.c: a linear velocity field that most arrangements of particles fail to report.
 * Wallstedt and Guilkey (2007), fig. 3 (eq. 2.1); with the enhancement of eqs 4.1, 4.2.
 *
 * Two particles in each of four cells: centred; shifted together; of unequal mass; clustered.
 * Errors cancel by symmetry in the first only. With gradient enhancement the error is zero in all
 * four. */
#include "studies/tables/curves.h"

enum { CELLS = 4, METHODS = 4, ARRANGEMENTS = 4 };
static const char *const methods[METHODS] = {"mpm", "gimp", "ge_mpm", "ge_gimp"};
static const char *const arrangements[ARRANGEMENTS] = {"centred", "shifted", "unequal",
                                                       "clustered"};

/* The figure shows MPM's nodes; the particles are the same for all methods. */
static void cases(Cases *list, bool quick)
{
    static const char *const kinds[METHODS] = {"nodes", "particles", "nodes", "nodes"};
    (void)quick;
    for (int a = 0; a < ARRANGEMENTS; a++)
        for (int m = 0; m < METHODS; m++)
            case_add_with(list, kinds[m], phrase("%s.%s", arrangements[a], methods[m]),
                          "run squeeze --method %s --cells %d --set arrangement=%s", methods[m],
                          CELLS, arrangements[a]);
}

static Measure error(const Table *rows, int method, int arrangement)
{
    return select_value(rows, "error_linf", "method=%s arrangement=%s", methods[method],
                        arrangements[arrangement]);
}

/* Least of a method in the three arrangements that are not centred. */
static Measure least_of_others(const Table *rows, int method)
{
    Measure out = measure_min_of(ARRANGEMENTS - 1);
    for (int a = 1; a < ARRANGEMENTS; a++) measure_add_min(&out, error(rows, method, a).value);
    return out;
}

static void check(Check *c, const Results *r)
{
    for (int a = 0; a < ARRANGEMENTS; a++)
        claim_note(c, arrangements[a], error(r->rows, 0, a).value);
    claim(c, "W07-3.centred",
          "Linear field in four cells: MPM's error is zero for perfectly centred particles",
          error(r->rows, 0, 0), 0, 1e-14);
    claim(c, "W07-3.mpm-others",
          "Linear field in four cells: MPM's error is not zero in the three arrangements that are "
          "not centred: the least of them",
          least_of_others(r->rows, 0), 0.001, 1);
    claim(c, "W07-3.sizes",
          "Linear field in four cells: particles of unequal mass are projected with an error: the "
          "lesser of MPM's and GIMP's",
          measure_min(error(r->rows, 0, 2), error(r->rows, 1, 2)), 0.003, 0.007);
    claim(c, "W07-3.gimp-others",
          "Linear field in four cells: GIMP's error is not zero in the three arrangements that are "
          "not centred: the least of them",
          least_of_others(r->rows, 1), 0.001, 1);
    claim(c, "W07-3.ge-zero",
          "Linear field in four cells: GE-MPM and GE-GIMP: the error is zero in all four "
          "arrangements: largest",
          curve_worst(r->rows, "ge_mpm ge_gimp", ARRANGEMENTS, "error_linf", ""), 0, 1e-13);
}

const StudyPage study_w07_03_degenerate = {.cases = cases, .check = check, .claims = 5};
