/* w07_04_squeeze.c: the squeeze test: ever more particles packed evenly into the same cells, so
 * that they meet the grid at every relative position. Wallstedt and Guilkey (2007), fig. 4
 * (eq. 3.2). */
#include "studies/tables/curves.h"

enum { CELLS = 10 };

static void cases(Cases *list, bool quick)
{
    static const int counts[] = {5, 10, 13, 20, 27, 36}; /* 0.5 to 3.6 per cell */
    (void)quick;
    for (int k = 0; k < 6; k++)
        case_add_with(list, "particles", phrase("%d", counts[k]),
                      "run squeeze --method gimp --cells %d --set particles=%d", CELLS, counts[k]);
}

const StudyPage study_w07_04_squeeze = {.cases = cases};
