/* dim.h: the dimension. The only file that asks which it is; all others loop `for (d < DIM)`.
 *
 * A grid node is one line of LANES doubles (4, 8, 16: half, one, two cache lines):
 *   lane 0            mass                                              weight S
 *   lane 1 .. DIM     momentum                                          weight S
 *   lanes up to FLUX  spare                                             weight S
 *   FLUX + b DIM + a  momentum flux: component a through axis b         weight dS/dx_b  */
#ifndef MPMLAB_DIM_H
#define MPMLAB_DIM_H

#if DIM == 1
enum { LANES = 4 };
#define IN_THIS_DIM(one, two, three) one
#define ENGINE_NAME                  engine_1d
#elif DIM == 2
enum { LANES = 8 };
#define IN_THIS_DIM(one, two, three) two
#define ENGINE_NAME                  engine_2d
#elif DIM == 3
enum { LANES = 16 };
#define IN_THIS_DIM(one, two, three) three
#define ENGINE_NAME                  engine_3d
#else
#error "compile with -DDIM=1, 2 or 3"
#endif

enum {
    NMAT = DIM * DIM,    /* entries of a matrix, row-major: entry (a, b) at a * DIM + b */
    FLUX = LANES - NMAT, /* first lane that is weighted with a gradient */
    CHUNK = 64,          /* particles that one stage handles at a time */
    CACHE_LINE =
        64 /* [bytes]: fields of a chunk start on one, so that vectors never straddle two */
};

/* Axes of arrays of DIM numbers, also where code for more dimensions is compiled for fewer: in 1D
 * AXIS_Y is x, which such code then does not use. */
enum { AXIS_Y = DIM > 1, AXIS_LAST = DIM - 1 };

typedef double Vec[DIM];
typedef double Mat[NMAT];

/* One node, or one particle's lanes, as a vector; LANES doubles. */
typedef double Line __attribute__((vector_size(LANES * sizeof(double))));

/* A field of one chunk: [lane or component][particle]. */
typedef double Field[CHUNK];

#endif
