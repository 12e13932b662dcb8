/* element.c: strain and internal forces of linear triangles, in 3D tetrahedra, with one Gauss point
 * (W11 A3, A4).
 *
 *   F = e B,  e = (x2 - x1, x3 - x1, ...) as columns, B the inverse of the same in the reference,
 *
 * equal to A4's (I - sum u grad phi)^-1, but with gradients that are known once for all, free of
 * its cancellation and its inverse. The forces, with the volume V that A3 lacks (areas in 2D),
 *
 *   f_k = -V sigma grad phi_k,  sigma = T/J,  f_1 = -f_2 - f_3 - ...,
 *   V grad phi_k = (column k - 1 of the cofactors of e)/DIM!
 *
 * need current edges only. Every element writes its own slots: no order of summation arises. */
#include <float.h>
#include "fem.h"

/* Edges x2 - x1, x3 - x1, ... of a chunk: [edge][component]. */
typedef Field Edges[DIM][DIM];

static inline void gather_edges(const Fem *f, int start, Edges edge)
{
    for (int e = 0; e < CHUNK; e++) {
        const Packed first = f->now[f->corner[0][start + e]];
        for (int k = 0; k < DIM; k++) {
            const Packed along = f->now[f->corner[k + 1][start + e]] - first;
            for (int a = 0; a < DIM; a++) edge[k][a][e] = along[a];
        }
    }
}

/* F = e B and J = det F. */
static inline void deform(Edges edge, Field B[NMAT], double *const F[NMAT], Field J)
{
    for (int e = 0; e < CHUNK; e++) {
        Mat now;
        for (int c = 0; c < NMAT; c++) {
            now[c] = 0;
            for (int k = 0; k < DIM; k++) now[c] += edge[k][c / DIM][e] * B[k * DIM + c % DIM][e];
        }
        for (int c = 0; c < NMAT; c++) F[c][e] = now[c];
        J[e] = determinant(now);
    }
}

/* Is any of them not a positive number? */
static inline bool any_bad(const Field J)
{
    int bad = 0;
    for (int e = 0; e < CHUNK; e++) bad |= !(J[e] > 0 && J[e] <= DBL_MAX);
    return bad;
}

/* Corner forces of a chunk from T = J sigma. */
static inline void push(Edges edge, Field T[NMAT], const Field J, Packed *force)
{
    Field out[CORNERS][DIM];
    for (int e = 0; e < CHUNK; e++) {
        const double share = 1 / (FACTORIAL * J[e]);
        Mat now;
        for (int c = 0; c < NMAT; c++) now[c] = edge[c % DIM][c / DIM][e];
        for (int a = 0; a < DIM; a++) {
            out[0][a][e] = 0;
            for (int k = 0; k < DIM; k++) {
                double sum = 0;
                for (int b = 0; b < DIM; b++) sum -= T[a * DIM + b][e] * cofactor(now, b, k);
                out[k + 1][a][e] = share * sum;
                out[0][a][e] -= share * sum;
            }
        }
    }
    for (int c = 0; c < CORNERS; c++)
        for (int e = 0; e < CHUNK; e++) {
            Packed own = {0};
            for (int a = 0; a < DIM; a++) own[a] = out[c][a][e];
            force[c * CHUNK + e] = own;
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

double fem_jacobian(const Fem *f, int e)
{
    Mat F;
    for (int k = 0; k < NMAT; k++) F[k] = f->F[k][e];
    return determinant(F);
}

/* The first element whose J is not a positive number. */
static Status first_culprit(const Fem *f)
{
    for (int e = 0; e < f->elements; e++) {
        const double J = fem_jacobian(f, e);
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
