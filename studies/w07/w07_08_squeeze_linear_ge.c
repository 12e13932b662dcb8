/* w07_08_squeeze_linear_ge.c: the squeeze of fig. 5 with gradient-enhanced particles: exact for
 * every number of particles, with tents and with GIMP. Wallstedt and Guilkey (2007), fig. 8
 * (eq. 4.2).
 *
 * The table's errors are those of interior nodes. Nodes on the boundary, where the plain projection
 * is wrong by about h/3 whatever the particles, are checked for a few numbers of particles. */
#include <math.h>
#include "squeeze.h"

enum { METHODS = 2, SAMPLES = 4 };
static const char *const methods[METHODS] = {"ge_mpm", "ge_gimp"};
static const int samples[SAMPLES] = {137, 250, 333, 777};

static void cases(Cases *list, bool quick)
{
    for (int m = 0; m < METHODS; m++) {
        squeeze_add(list, methods[m], "linear", SQUEEZE_CELLS, 1, quick);
        for (int k = 0; k < SAMPLES; k++)
            case_add_with(list, "nodes", phrase("%s.%d", methods[m], samples[k]),
                          "run squeeze --method %s --cells %d --set particles=%d", methods[m],
                          SQUEEZE_CELLS, samples[k]);
    }
}

/* Largest |v_i/(1 + x_i) - 1| over all nodes of a run, those on the boundary included. */
static void add_nodes(Measure *worst, const Results *r, const char *method, int particles)
{
    const Table *nodes = results_run(r, "%s.%d", method, particles);
    for (int i = 0; i < nodes->nrow; i++)
        measure_add_max(
            worst, fabs(select_number(nodes, i, "vx") / (1 + select_number(nodes, i, "x")) - 1));
}

static void check(Check *c, const Results *r)
{
    static const char *const ids[METHODS] = {"W07-8.ge-mpm", "W07-8.ge-gimp"};
    Measure worst = measure_max_of(METHODS * SAMPLES * (SQUEEZE_CELLS + 1));
    Curve curve;
    for (int m = 0; m < METHODS; m++) {
        curve_pick(&curve, r->rows, "ppc", "error_linf", "method=%s", methods[m]);
        claim(c, ids[m],
              phrase("Squeeze, linear field: %s is exact: largest error over 50 to 1000 particles",
                     engine_label(methods[m])),
              curve_max(&curve, SQUEEZE_POINTS + SAMPLES), 0, 1e-13);
        for (int k = 0; k < SAMPLES; k++) add_nodes(&worst, r, methods[m], samples[k]);
    }
    claim(c, "W07-8.boundary",
          "Squeeze, linear field: GE-MPM and GE-GIMP are exact at boundary nodes, too: largest "
          "error with 137, 250, 333, 777 particles",
          worst, 0, 1e-13);
}

const StudyPage study_w07_08_squeeze_linear_ge = {.cases = cases, .check = check, .claims = 3};
