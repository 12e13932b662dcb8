/* lanes.h: lines as the machine's vectors hold them: whole, or in parts of a vector's width. */
#ifndef MPMLAB_LANES_H
#define MPMLAB_LANES_H

#include "common/contract/four.h"

#define MORE_THAN_FOUR_LANES IN_THIS_DIM(0, 1, 1) /* LANES > 4, for the preprocessor */

/* The widest vectors of this build. */
#if defined(__AVX512F__)
enum { VECTOR_BYTES = 64, REGISTERS = 16 }; /* for sums; the other half holds operands */
#elif defined(__AVX__)
enum { VECTOR_BYTES = 32, REGISTERS = 4 };
#else
enum { VECTOR_BYTES = 16, REGISTERS = 4 };
#endif

enum {
    PART_BYTES = VECTOR_BYTES < (int)sizeof(Line) ? VECTOR_BYTES : (int)sizeof(Line),
    PART_LANES = PART_BYTES / (int)sizeof(double),
    PARTS = LANES / PART_LANES /* 1, 2, 4 or 8 */
};
typedef double Part __attribute__((vector_size(PART_BYTES), may_alias));
typedef long long PartBits __attribute__((vector_size(PART_BYTES)));

/* A part with `own` in the lanes lo .. hi - 1 and S in the others. Optimized builds for AVX use the
 * blend instruction (with clang those for AVX-512 alone): gcc builds a shuffle of two repeated
 * numbers lane by lane. */
#if defined(__AVX512F__) && defined(__OPTIMIZE__) && MORE_THAN_FOUR_LANES
#include <immintrin.h>
static inline __attribute__((always_inline)) Part part_of_two(double S, double own, int lo, int hi)
{
    const int first = lo < 0 ? 0 : lo;
    const __mmask8 mask = (__mmask8)((1 << hi) - (1 << first));
    return (Part)_mm512_mask_blend_pd(mask, _mm512_set1_pd(S), _mm512_set1_pd(own));
}
#elif defined(__AVX__) && defined(__OPTIMIZE__) && !defined(__clang__)
#include <immintrin.h>
static inline __attribute__((always_inline)) Part part_of_two(double S, double own, int lo, int hi)
{
    const int first = lo < 0 ? 0 : lo, last = hi > PART_LANES ? PART_LANES : hi;
    return (Part)_mm256_blend_pd(_mm256_set1_pd(S), _mm256_set1_pd(own),
                                 (1 << last) - (1 << first));
}
#else
static inline __attribute__((always_inline)) Part part_of_two(double S, double own, int lo, int hi)
{
    Part w = S - (Part){0};
    for (int l = 0; l < PART_LANES; l++)
        if (l >= lo && l < hi) w[l] = own;
    return w;
}
#endif

/* Part q of a line whose lanes 0 .. 3 hold the slopes along axis d, lanes 4 d .. 4 d + 3 of B. */
static inline __attribute__((always_inline)) Part slope_part(const Line *B, int d, const int q)
{
    const Four *const of = (const Four *)B + d;
#if defined(__AVX512F__) && MORE_THAN_FOUR_LANES
    (void)q;
    return __builtin_shufflevector(*of, (Four){0}, 0, 1, 2, 3, 4, 5, 6, 7);
#else
    return ((const Part *)of)[q];
#endif
}

/* Weights of part q of a line: S, but G (or R) in the lanes of the flux through axis d. */
static inline __attribute__((always_inline)) Part weight_part(double S, double G, int d,
                                                              const int q)
{
    const int lo = FLUX + d * DIM - q * PART_LANES, hi = lo + DIM;
    if (hi <= 0 || lo >= PART_LANES) return S - (Part){0};
    return part_of_two(S, G, lo, hi);
}

#endif
