/* element.c: strain and internal forces of linear triangles with one Gauss point (W11 A3, A4).
 *
 *   F = e B,  e = (x2 - x1, x3 - x1) as columns, B the inverse of the same in the reference,
 *
 * equal to A4's (I - sum u grad phi)^-1, but with gradients that are known once for all, free of
 * its cancellation and its inverse. The forces, with the area A that A3 lacks,
 *
 *   f_i = -A sigma grad phi_i,  sigma = T/J,  f_1 = -f_2 - f_3,
 *   A grad phi_2 = (e3_y, -e3_x)/2,  A grad phi_3 = (-e2_y, e2_x)/2,
 *
 * need current edges only. Every element writes its own slots: no order of summation arises. */
#include <float.h>
#include "fem.h"

/* Edges x2 - x1 and x3 - x1 of a chunk, interleaved as they are fetched. */
typedef double Edges[CHUNK][2][DIM];

static inline void gather_edges(const Fem *f, int start, Edges out)
{
    const int *c1 = f->corner[0] + start, *c2 = f->corner[1] + start, *c3 = f->corner[2] + start;
    const Pair *x = f->now;
    Pair(*edge)[2] = (Pair(*)[2])out;
    for (int e = 0; e < CHUNK; e++) {
        edge[e][0] = x[c2[e]] - x[c1[e]];
        edge[e][1] = x[c3[e]] - x[c1[e]];
    }
}

/* F = e B and J = det F. */
static inline void deform(Edges edge, Field B[NMAT], double *const F[NMAT], Field J)
{
    double *restrict Fxx = F[0], *restrict Fxy = F[1], *restrict Fyx = F[2], *restrict Fyy = F[3];
    for (int e = 0; e < CHUNK; e++) {
        double x2 = edge[e][0][0], y2 = edge[e][0][1], x3 = edge[e][1][0], y3 = edge[e][1][1];
        Fxx[e] = x2 * B[0][e] + x3 * B[2][e];
        Fxy[e] = x2 * B[1][e] + x3 * B[3][e];
        Fyx[e] = y2 * B[0][e] + y3 * B[2][e];
        Fyy[e] = y2 * B[1][e] + y3 * B[3][e];
    }
    for (int e = 0; e < CHUNK; e++) J[e] = Fxx[e] * Fyy[e] - Fxy[e] * Fyx[e];
}

/* Is any of them not a positive number? */
static inline bool any_bad(const Field J)
{
    int bad = 0;
    for (int e = 0; e < CHUNK; e++) bad |= !(J[e] > 0 && J[e] <= DBL_MAX);
    return bad;
}

/* Corner forces of a chunk from T = J sigma. */
static inline void push(Edges edge, Field T[NMAT], const Field J, Pair *force)
{
    double(*out)[CHUNK][DIM] = (double(*)[CHUNK][DIM])force;
    for (int e = 0; e < CHUNK; e++)
        for (int a = 0; a < DIM; a++) {
            double half = 0.5 / J[e], Tx = half * T[a * DIM][e], Ty = half * T[a * DIM + 1][e];
            double f2 = Ty * edge[e][1][0] - Tx * edge[e][1][1];
            double f3 = Tx * edge[e][0][1] - Ty * edge[e][0][0];
            out[0][e][a] = -f2 - f3;
            out[1][e][a] = f2;
            out[2][e][a] = f3;
        }
}

static bool strain_chunk(Fem *f, int start)
{
    Edges edge;
    Field J, T[NMAT];
    double *F[NMAT];
    for (int k = 0; k < NMAT; k++) F[k] = f->F[k] + start;
    gather_edges(f, start, edge);
    deform(edge, f->inverse[start / CHUNK], F, J);
    material_kirchhoff(&f->scene->mat, (const double *const *)F, T);
    push(edge, T, J, f->force + force_at(start, 0));
    return any_bad(J);
}

/* The first element whose J is not a positive number. */
static Status first_culprit(const Fem *f)
{
    for (int e = 0; e < f->elements; e++) {
        double J = f->F[0][e] * f->F[3][e] - f->F[1][e] * f->F[2][e];
        if (J <= 0) return (Status){INVERTED, e, J};
        if (!(J <= DBL_MAX)) return (Status){NOT_A_NUMBER, e, J};
    }
    return (Status){OK, -1, 0};
}

void fem_strain(Fem *f)
{
    int bad = 0;
#pragma omp parallel for schedule(static) num_threads(f->threads) reduction(| : bad)
    for (int start = 0; start < f->slots; start += CHUNK) bad |= strain_chunk(f, start);
    f->status = bad ? first_culprit(f) : (Status){OK, -1, 0};
}
