/* variants.h: a method as it is, and with an option that changes what it does in a hard case. */
#ifndef MPMLAB_VARIANTS_H
#define MPMLAB_VARIANTS_H

#include "studies/study.h"

typedef struct Variant {
    const char *name;    /* in tables, and in names of files */
    const char *setting; /* "domain=stretch"; "": the method as it is */
} Variant;

/* The run ("run block --method %s ...") with that setting, or as it is; NULL if the method does not
 * take the setting, or has no grid on which it could act. */
const char *variant_run(const Variant *variant, const char *run, ...)
    __attribute__((format(printf, 2, 3)));

/* The variant of n that a row of a run has: the last whose setting it meets, else the first. */
int variant_of_row(const Variant variants[], int n, const Table *rows, int row);

#endif
