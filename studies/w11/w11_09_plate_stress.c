/* w11_09_plate_stress.c: von Mises stress of the plate with a hole at 0, 464 and 696 us, by WLS2
 * and by GIMP. Wallstedt and Guilkey (2011), fig. 9. */
#include <math.h>
#include "studies/tables/curves.h"

static const char *const methods[] = {"wls2", "gimp"};
static const struct {
    const char *time, *t_end;
} shown[] = {{"0", "1e-12"}, {"464", "464e-6"}, {"696", "696e-6"}};
enum { METHODS = 2, TIMES = 3, PARTICLES = 3000 };

static void cases(Cases *list, bool quick)
{
    for (int m = 0; m < METHODS; m++)
        for (int k = 0; k < TIMES; k++)
            case_add_with(list, "particles", phrase("%s.%s", methods[m], shown[k].time),
                          "run hole_plate --method %s --cells %d --t-end %s", methods[m],
                          quick ? 8 : 32, shown[k].t_end);
}

/* Largest von Mises stress of one state [GPa]. */
static Measure largest_mises(const Results *r, const char *method, const char *time)
{
    const Table *t = results_run(r, "%s.%s", method, time);
    const Measure most = select_max(t, "von_mises", PARTICLES, " ");
    return measure_with(most, most.value / 1e9);
}

static void check(Check *c, const Results *r)
{
    claim(c, "W11-9.rest",
          "Plate with a hole, WLS2: free of stress at 0 us: largest von Mises stress [GPa]",
          largest_mises(r, "wls2", "0"), 0, 1e-6);
    claim(c, "W11-9.growth",
          "Plate with a hole, WLS2: largest von Mises stress at 464 us over that at 696 us",
          measure_ratio(largest_mises(r, "wls2", "464"), largest_mises(r, "wls2", "696")), 0.5, 1);
}

const StudyPage study_w11_09_plate_stress = {.cases = cases, .check = check, .claims = 2};
