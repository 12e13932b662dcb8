/* lists.h: lists of values as `sweep` takes them: A,B,C, and among numbers A:B:*R and A:B:+D. */
#ifndef MPMLAB_LISTS_H
#define MPMLAB_LISTS_H

#include <stdbool.h>
#include "common/base/fault.h"

enum { LIST_MAX = 1000 };

typedef struct List {
    int n;
    char **value; /* owned */
} List;

/* Reads text into list; `what` is named if it is refused. A:B:*R goes from A by factors of R,
 * A:B:+D by steps of D, to the last value that is not beyond B. whole: numbers round to the nearest
 * whole one; what comes twice is taken once. 0 or a fault with code 2; lists_free() in any case. */
int lists_read(List *list, const char *what, const char *text, bool whole, Fault *fault);
void lists_free(List *list);

/* Is each value of the list a number? */
bool lists_are_numeric(const List *list);

#endif
