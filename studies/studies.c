/* studies.c: the list of all studies, from studies.def. */
#include "study.h"

#define STUDY(room, name) extern const Study study_##name;
#include "studies.def"
#undef STUDY

const Study *const studies[] = {
#define STUDY(room, name) &study_##name,
#include "studies.def"
#undef STUDY
    NULL};

static const char *const rooms[] = {
#define STUDY(room, name) #room,
#include "studies.def"
#undef STUDY
};

const char *study_room(const Study *study)
{
    for (size_t k = 0; studies[k]; k++)
        if (studies[k] == study) return rooms[k];
    return ".";
}
