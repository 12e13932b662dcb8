/* w11_05_ring_stress.c: radial and hoop stress of the oscillating ring at 0, 5 and 10 ms.
 * Wallstedt and Guilkey (2011), fig. 5. At rest at t = 0 the ring is stretched outwards by A, at 5
 * ms it passes through its natural shape, at 10 ms it is drawn in. */
#include <math.h>
#include <stdlib.h>
#include "studies/tables/curves.h"

enum { PARTICLES = 2000 }; /* of some 2400 in the quarter ring at 32 cells */

/* At t = 0 the run takes one step of 1 ns, so that the state is the initial one. */
static const char *const time_ms[] = {"0ms", "5ms", "10ms"}, *const t_end[] = {"1e-9", "0.005",
                                                                               "0.01"};

static void cases(Cases *list, bool quick)
{
    for (int k = 0; k < 3; k++)
        case_add_with(list, "particles", time_ms[k],
                      "run ring --cells %d --set layout=radial --t-end %s", quick ? 8 : 32,
                      t_end[k]);
}

/* The largest stress of one file, over all components, in its absolute value. */
static Measure largest_stress(const Results *r, const char *ms)
{
    const Table *t = results_run(r, "%s", ms);
    Measure most = measure_max_of(PARTICLES);
    for (int k = 0; k < t->nrow; k++)
        measure_add_max(&most, measure_worse(fabs(select_number(t, k, "sxx")),
                                             fabs(select_number(t, k, "syy"))));
    return most;
}

static void check(Check *c, const Results *r)
{
    claim(c, "W11-5.rest",
          "Ring: at 5 ms it passes through its stress-free shape: largest stress there over that "
          "at 0 ms",
          measure_ratio(largest_stress(r, "5ms"), largest_stress(r, "0ms")), 0, 0.1);
}

const StudyPage study_w11_05_ring_stress = {.cases = cases, .check = check, .claims = 1};
