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
#include "common/contract/four.h"
#include "fem.h"
#include "common/base/team.h"

/* Edges x2 - x1, x3 - x1, ... of a chunk: [edge][component]. */
typedef Field Edges[DIM][DIM];

/* The edges of four elements at a time (3D). */
static inline void gather_four(const Fem *f, int start, int e, Edges edge)
{
    Four first[FOUR], along[FOUR];
    for (int i = 0; i < FOUR; i++) first[i] = *(const Four *)&f->now[f->corner[0][start + e + i]];
    for (int k = 0; k < DIM; k++) {
        const int *corner = f->corner[k + 1] + start + e;
        for (int i = 0; i < FOUR; i++) along[i] = *(const Four *)&f->now[corner[i]] - first[i];
        four_transpose(along);
        for (int a = 0; a < DIM; a++) *(FourOfField *)&edge[k][a][e] = along[a];
    }
}

static inline void gather_edges(const Fem *f, int start, Edges edge)
{
    for (int e = 0; DIM == 3 && e < CHUNK; e += FOUR) gather_four(f, start, e, edge);
    for (int e = 0; DIM < 3 && e < CHUNK; e++) {
        const Packed first = f->now[f->corner[0][start + e]];
        for (int k = 0; k < DIM; k++) {
            const Packed along = f->now[f->corner[k + 1][start + e]] - first;
            for (int a = 0; a < DIM; a++) edge[k][a][e] = along[a];
        }
    }
}

/* One component of F = e B. */
static inline void product(Edges edge, Field B[NMAT], int c, double *restrict out)
{
    for (int e = 0; e < CHUNK; e++) {
        double sum = edge[0][c / DIM][e] * B[c % DIM][e];
        for (int k = 1; k < DIM; k++) sum += edge[k][c / DIM][e] * B[k * DIM + c % DIM][e];
        out[e] = sum;
    }
}

/* F = e B and J = det F. */
static inline void deform(Edges edge, Field B[NMAT], double *const F[NMAT], Field J)
{
    for (int c = 0; c < NMAT; c++) product(edge, B, c, F[c]);
    for (int e = 0; e < CHUNK; e++) {
        Mat now;
        for (int c = 0; c < NMAT; c++) now[c] = F[c][e];
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

/* Corner forces from fields to vectors, of four elements at a time. */
static inline void pack(Field out[CORNERS][DIM], Packed *force)
{
    for (int c = 0; c < CORNERS; c++)
        for (int e = 0; e < CHUNK; e += FOUR) {
            Four own[FOUR] = {{0}};
            Four *to = (Four *)&force[c * CHUNK + e];
            for (int a = 0; a < DIM; a++) own[a] = *(const FourOfField *)&out[c][a][e];
            if (DIM == 2) {
                to[0] = __builtin_shufflevector(own[0], own[1], 0, 4, 1, 5);
                to[1] = __builtin_shufflevector(own[0], own[1], 2, 6, 3, 7);
                continue;
            }
            if (DIM == 3) four_transpose(own);
            for (int i = 0; i < IN_THIS_DIM(1, 2, 4); i++) to[i] = own[i];
        }
}

/* Corner forces of a chunk from T = J sigma. */
static inline void push(Edges edge, Field T[NMAT], const Field J, Packed *force)
{
    Field out[CORNERS][DIM];
    for (int e = 0; e < CHUNK; e++) {
        const double share = 1 / ((double)FACTORIAL * J[e]);
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
    pack(out, force);
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

typedef struct Strain {
    Fem *f;
    int bad; /* not 0: some element is inverted or not finite */
} Strain;

static void strain_chunks(void *own, int first, int last)
{
    Strain *s = own;
    int bad = 0;
    for (int k = first; k < last; k++) bad |= strain_chunk(s->f, k * CHUNK);
#pragma omp atomic /* by any thread of the team: team.h */
    s->bad |= bad;
}

void fem_strain(Fem *f)
{
    Strain all = {f, 0};
    team_share(f->threads, f->slots / CHUNK, strain_chunks, &all);
    f->status = all.bad ? first_culprit(f) : (Status){OK, -1, 0};
}
