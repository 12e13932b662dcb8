/* handover.h: a run that goes on with another method on the same particles: --then METHOD --at
 * WHEN, --then-set NAME=VALUE. In a spec these are settings: then, at, then_NAME, so that a row's
 * parameters make the run again. */
#ifndef MPMLAB_HANDOVER_H
#define MPMLAB_HANDOVER_H

#include "plan.h"

typedef enum { AT_NEVER, AT_TIME, AT_INVERTED, AT_J } HandoverAt;

typedef struct Handover {
    HandoverAt at;
    double value; /* [s], or J */
    Plan plan;    /* of the second method */
} Handover;

/* Is a setting of this name part of a hand-over? */
bool handover_is_setting(const char *name);

/* The hand-over of a resolved first plan, and its settings printed as they are read. at is AT_NEVER
 * without --then. 0 or a fault: what makes no sense together. */
int handover_plan(RunSpec *spec, const Plan *first, Handover *out, Fault *fault);

#endif
