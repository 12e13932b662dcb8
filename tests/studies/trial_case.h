/* trial_case.h: what rows and files of a trial have in common. */
#ifndef MPMLAB_TRIAL_CASE_H
#define MPMLAB_TRIAL_CASE_H

#include <math.h>
#include <string.h>
#include "studies/engine/cases.h"

/* Numbers from 0 to 1, even and the same for ever. */
static inline double spread(int k)
{
    return fmod(k * 0.6180339887, 1);
}

static inline bool is_fem(const Case *c)
{
    return strcmp(c->spec.method, "fem") == 0;
}

#endif
