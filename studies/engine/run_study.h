/* run_study.h: doing a study, as `mpmlab study` asks for it. */
#ifndef MPMLAB_RUN_STUDY_H
#define MPMLAB_RUN_STUDY_H

#include "studies/study.h"

typedef enum StudyAction { STUDY_DO, STUDY_LIST, STUDY_COLLECT } StudyAction;

typedef struct StudyOptions {
    const char *dir;     /* where everything goes, created if need be */
    const char *methods; /* only these ("mpm,gimp"), or NULL: all */
    bool quick;
    bool keep; /* a table of other runs is renamed, not replaced */
    int jobs;
    StudyAction action;
} StudyOptions;

/* 0; PLOT_NO_GNUPLOT: done but for the figure; 130: interrupted; or a fault. */
int run_study(const Study *study, const StudyOptions *options, Fault *fault);

#endif
