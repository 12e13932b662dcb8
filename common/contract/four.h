/* four.h: four numbers at once, for the ways between fields of a chunk and vectors of an element or
 * particle. */
#ifndef MPMLAB_FOUR_H
#define MPMLAB_FOUR_H

enum { FOUR = 4 };
typedef double Four __attribute__((vector_size(FOUR * sizeof(double)), may_alias));

/* Rows become columns. */
static inline __attribute__((always_inline)) void four_transpose(Four a[FOUR])
{
    const Four lo01 = __builtin_shufflevector(a[0], a[1], 0, 4, 2, 6);
    const Four hi01 = __builtin_shufflevector(a[0], a[1], 1, 5, 3, 7);
    const Four lo23 = __builtin_shufflevector(a[2], a[3], 0, 4, 2, 6);
    const Four hi23 = __builtin_shufflevector(a[2], a[3], 1, 5, 3, 7);
    a[0] = __builtin_shufflevector(lo01, lo23, 0, 1, 4, 5);
    a[1] = __builtin_shufflevector(hi01, hi23, 0, 1, 4, 5);
    a[2] = __builtin_shufflevector(lo01, lo23, 2, 3, 6, 7);
    a[3] = __builtin_shufflevector(hi01, hi23, 2, 3, 6, 7);
}

#endif
