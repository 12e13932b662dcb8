/* w11_04_particles.c: the two ways to fill the quarter ring with particles: on the grid's own
 * lattice and fitted to the body. Wallstedt and Guilkey (2011), fig. 4. */
#include "studies/study.h"

static void cases(Cases *list, bool quick)
{
    (void)quick;
    case_add_with(list, "particles", "cartesian",
                  "run ring --cells 16 --set layout=cartesian --set steps=1");
    case_add_with(list, "particles", "radial",
                  "run ring --cells 16 --set layout=radial --set steps=1");
}

const StudyPage study_w11_04_particles = {.cases = cases};
