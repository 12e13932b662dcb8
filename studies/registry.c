/* registry.c: the list of all studies, from studies.def. */
#include "study.h"

#define STUDY(name) extern const Study study_##name;
#include "studies.def"
#undef STUDY

const Study *const studies[] = {
#define STUDY(name) &study_##name,
#include "studies.def"
#undef STUDY
    NULL};
