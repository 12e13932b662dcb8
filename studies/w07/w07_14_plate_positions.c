/* w07_14_plate_positions.c: the vibrating plate at the start and half a period later. Wallstedt and
 * Guilkey (2007), fig. 14. The figure exaggerates displacements. */
#include <math.h>
#include "studies/tables/curves.h"

static const double exaggeration = 20;
enum { PARTICLES = 8 * 8 * 4 };

/* One step of a run that ends at once leaves the particles where they start. */
static void cases(Cases *list, bool quick)
{
    (void)quick;
    case_add_with(list, "particles", "start",
                  "run plate_vibration --method ge_gimp --cells 8 --t-end 1e-9");
    case_add_with(list, "particles", "half",
                  "run plate_vibration --method ge_gimp --cells 8 --t-end .0360555127546399");
}

/* Largest difference between a particle's displacement at the start and its negative later, over A.
 */
static Measure asymmetry(const Table *start, const Table *half)
{
    Measure worst = measure_max_of(PARTICLES);
    for (int p = 0; p < start->nrow && p < half->nrow; p++) {
        double dx = select_number(start, p, "x") + select_number(half, p, "x") -
                    2 * select_number(start, p, "X");
        double dy = select_number(start, p, "y") + select_number(half, p, "y") -
                    2 * select_number(start, p, "Y");
        measure_add_max(&worst, hypot(dx, dy) / 0.004);
    }
    return worst;
}

static void check(Check *c, const Results *r)
{
    claim_note(c, "exaggeration", exaggeration);
    claim(c, "W07-14.mirrored",
          "Plate, GE-GIMP, h = 1/8: half a period later displacements have changed sign: largest "
          "departure over A",
          asymmetry(results_run(r, "start"), results_run(r, "half")), 0, 0.1);
}

const StudyPage study_w07_14_plate_positions = {.cases = cases, .check = check, .claims = 1};
