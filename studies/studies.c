/* studies.c: the list of all studies, from studies.def. */
#include "study.h"

#define STUDY(room, name, figure, about) extern const StudyPage study_##name;
#include "studies.def"
#undef STUDY

const Study studies[] = {
#define STUDY(room, name, figure, about) {#name, figure, about, &study_##name, #room, NULL},
#include "studies.def"
#undef STUDY
    {.name = NULL}};
