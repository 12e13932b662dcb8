/* t_18_places.c: whole shells in three dimensions, anywhere on the grid and turned: does a run with
 * WLS depend on where its body lies? Offsets and turns are random (gsl_rng_mt19937, fixed seed). In
 * a whole shell each cut cell is another one; the octant at offset 0 has few kinds of them.
 *
 * Six places at N = 8 over one period; and four periods of the octant. Error: largest over all
 * particles and steps. */
#include <gsl/gsl_rng.h>
#include <math.h>
#include "studies/tables/curves.h"

enum { PLACES = 6, CELLS = 8, METHODS = 3, PERIODS = 4 };
static const char *const methods[METHODS] = {"wls", "wls2", "ge_wls"};

/* Offsets along x, y, z [h], turn [degrees]. */
static void places(double out[PLACES][4])
{
    gsl_rng *r = gsl_rng_alloc(gsl_rng_mt19937);
    for (int k = 0; r && k < PLACES; k++)
        for (int a = 0; a < 4; a++)
            out[k][a] = floor(1e6 * gsl_rng_uniform(r)) / 1e6 * (a < 3 ? 1 : 360);
    gsl_rng_free(r);
}

static void cases(Cases *list, bool quick)
{
    double at[PLACES][4];
    places(at);
    for (int m = 0; m < METHODS; m++) {
        for (int k = 0; k < (quick ? 1 : PLACES); k++)
            case_add(list,
                     "run shell --method %s --cells %d --set sector=full --set offset_x=%.6f --set "
                     "offset_y=%.6f --set offset_z=%.6f --set angle=%.4f",
                     methods[m], CELLS, at[k][0], at[k][1], at[k][2], at[k][3]);
        case_add(list, "run shell --method %s --cells %d --t-end %g", methods[m], CELLS,
                 quick ? 0.02 : 0.02 * (double)PERIODS);
    }
}

static const char *whole(const char *method)
{
    return phrase("sector=full method=%s", method);
}

/* Largest error over the least of the places. */
static Measure spread(const Table *t, const char *method)
{
    return measure_ratio(select_max(t, "error_linf", PLACES, "%s", whole(method)),
                         select_min(t, "error_linf", PLACES, "%s", whole(method)));
}

static Measure octant(const Table *t, const char *method)
{
    return select_value(t, "error_linf", "sector=octant method=%s", method);
}

static void check(Check *c, const Results *r)
{
    static const struct {
        double spread, low, high;
    } known[METHODS] = {{1.05, 0.017, 0.021}, {1.08, 0.011, 0.0135}, {1.12, 0.008, 0.0105}};
    const Table *t = r->rows;
    Measure lost = measure_sum_of(0);
    for (int m = 0; m < METHODS; m++) {
        lost = measure_sum(lost, select_count_lost(t, PLACES, whole(methods[m])));
        claim(c, phrase("T-18d.place-%s", methods[m]),
              phrase("Whole shell, %s, N = 8: largest error over the least of six random offsets "
                     "and turns",
                     engine_label(methods[m])),
              spread(t, methods[m]), 1, known[m].spread);
        claim(c, phrase("T-18d.periods-%s", methods[m]),
              phrase("Octant of the shell, %s, N = 8: largest error in four periods [m]",
                     engine_label(methods[m])),
              octant(t, methods[m]), known[m].low, known[m].high);
    }
    claim(c, "T-18d.lost", "Whole shells at random offsets and turns, WLS, WLS2, GE-WLS: runs lost",
          lost, 0, 0);
}

const StudyPage study_t_18_places = {.cases = cases, .check = check, .claims = 1 + 2 * METHODS};
