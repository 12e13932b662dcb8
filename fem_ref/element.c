/* element.c: strain and internal forces of linear triangles with one Gauss point (W11 A3, A4).
 *
 *   F = e B,  e = (x2 - x1, x3 - x1) as columns, B the inverse of the same in the reference.
 * Equal to A4's (I - sum u grad phi)^-1, but with gradients that are known once for all, and free of
 * the cancellation and the inverse. The forces, with the area A that A3 lacks,
 *   f_i = -A sigma grad phi_i,  sigma = T/J,
 *   A grad phi_2 = (e3_y, -e3_x)/2,  A grad phi_3 = (-e2_y, e2_x)/2,  f_1 = -f_2 - f_3
 * need current edges only. Every element writes its own slots: no order of summation arises here. */
#include <float.h>
#include "fem.h"

typedef struct Edges {
    Field e2[DIM], e3[DIM];
} Edges;

static inline void gather_edges(const Fem *f, int start, Edges *out)
{
    const int *c1 = f->corner[0] + start, *c2 = f->corner[1] + start, *c3 = f->corner[2] + start;
    for (int d = 0; d < DIM; d++) {
        const double *x = f->x[d];
        for (int e = 0; e < CHUNK; e++) {
            double x1 = x[c1[e]];
            out->e2[d][e] = x[c2[e]] - x1;
            out->e3[d][e] = x[c3[e]] - x1;
        }
    }
}

/* F = e B */
static inline void deform(const Edges *edges, double *const B[NMAT], int start, double *const F[NMAT])
{
    for (int a = 0; a < DIM; a++)
        for (int b = 0; b < DIM; b++) {
            const double *B2 = B[b] + start, *B3 = B[DIM + b] + start;
            double *out = F[a * DIM + b] + start;
            for (int e = 0; e < CHUNK; e++)
                out[e] = edges->e2[a][e] * B2[e] + edges->e3[a][e] * B3[e];
        }
}

/* Corner forces of a chunk from T = J sigma. */
static inline void push(const Edges *edges, const Field T[NMAT], const Field J, double *force)
{
    double(*out)[DIM][CHUNK] = (double(*)[DIM][CHUNK])force;
    for (int a = 0; a < DIM; a++)
        for (int e = 0; e < CHUNK; e++) {
            double half = 0.5 / J[e], Tx = half * T[a * DIM][e], Ty = half * T[a * DIM + 1][e];
            double f2 = Ty * edges->e3[0][e] - Tx * edges->e3[1][e];
            double f3 = Tx * edges->e2[1][e] - Ty * edges->e2[0][e];
            out[0][a][e] = -f2 - f3;
            out[1][a][e] = f2;
            out[2][a][e] = f3;
        }
}

/* J of a chunk; is any of them not a positive number? */
static inline bool volume_change(const double *const F[NMAT], Field J)
{
    int bad = 0;
    for (int e = 0; e < CHUNK; e++) {
        J[e] = F[0][e] * F[3][e] - F[1][e] * F[2][e];
        bad |= !(J[e] > 0 && J[e] <= DBL_MAX);
    }
    return bad;
}

static bool strain_chunk(Fem *f, int start)
{
    Edges edges;
    Field J, T[NMAT];
    const double *F[NMAT];
    for (int k = 0; k < NMAT; k++) F[k] = f->F[k] + start;
    gather_edges(f, start, &edges);
    deform(&edges, f->inverse, start, f->F);
    kirchhoff(&f->scene->mat, F, T);
    bool bad = volume_change(F, J);
    push(&edges, (const Field *)T, J, f->force + force_at(start, 0));
    return bad;
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
#pragma omp parallel for schedule(static) num_threads(f->threads) if (f->threads > 1) reduction(| : bad)
    for (int start = 0; start < f->slots; start += CHUNK) bad |= strain_chunk(f, start);
    f->status = bad ? first_culprit(f) : (Status){OK, -1, 0};
}
