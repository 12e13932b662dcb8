/* four.h: four numbers at once: conversion between fields of a chunk and vectors of an element or
 * particle. */
#ifndef MPMLAB_FOUR_H
#define MPMLAB_FOUR_H

#include "dim.h"

enum { FOUR = 4 };
typedef double Four __attribute__((vector_size(FOUR * sizeof(double)), may_alias));

/* Four numbers of a Field, which is aligned as a double only. */
typedef double FourOfField
    __attribute__((vector_size(FOUR * sizeof(double)), may_alias, aligned(sizeof(double))));

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

/* Fields to their lanes of a chunk's lines, four by four. */
static inline void four_lines_from_fields(Field field[LANES], Line line[CHUNK])
{
    for (int l = 0; l < LANES; l += FOUR)
        for (int p = 0; p < CHUNK; p += FOUR) {
            Four a[FOUR];
            for (int k = 0; k < FOUR; k++) a[k] = *(const FourOfField *)&field[l + k][p];
            four_transpose(a);
            for (int k = 0; k < FOUR; k++) *(Four *)((double *)&line[p + k] + l) = a[k];
        }
}

/* A chunk's lines to fields, four by four; lanes from FLUX on are multiplied by `scale`. */
static inline void four_fields_from_lines(const Line line[CHUNK], double scale, Field field[LANES])
{
    for (int l = 0; l < LANES; l += FOUR)
        for (int p = 0; p < CHUNK; p += FOUR) {
            Four a[FOUR];
            for (int k = 0; k < FOUR; k++) a[k] = *(const Four *)((const double *)&line[p + k] + l);
            four_transpose(a);
            for (int k = 0; k < FOUR; k++) {
                if (l + k >= FLUX) a[k] *= scale;
                *(FourOfField *)&field[l + k][p] = a[k];
            }
        }
}

/* Sets lanes 4 group .. 4 group + 3 of each line to 0 and the DIM fields times `scale`, as mass and
 * momentum stand in a payload. */
static inline void four_momentum_lanes(Field field[DIM], double scale, Line line[CHUNK], int group)
{
    for (int p = 0; p < CHUNK; p += FOUR) {
        Four a[FOUR] = {{0}};
        for (int k = 0; k < DIM; k++) a[1 + k] = *(const FourOfField *)&field[k][p] * scale;
        four_transpose(a);
        for (int k = 0; k < FOUR; k++) ((Four *)&line[p + k])[group] = a[k];
    }
}

#endif
