/* strain.c: see strain.h. With L constant over the step F' = L F has the solution exp(dt L) F,
 * whose J is exp(dt tr L) J: a spin keeps it. F += dt L F multiplies J by 1 + (w dt)^2 instead.
 *
 * Where v belongs to half a step after x, L is that of the secant from x to x + dt v, and I +
 * dt L its exact gradient: the linear rule is the consistent one there, and exp(dt L) shrinks a
 * spinning body by (w dt)^2/2 per step along each axis. */
#include "strain.h"
#include <math.h>

/* out = A B; out is neither of them. */
static void multiply(const Mat A, const Mat B, Mat out)
{
    for (int a = 0; a < DIM; a++)
        for (int b = 0; b < DIM; b++) {
            out[a * DIM + b] = 0;
            for (int k = 0; k < DIM; k++) out[a * DIM + b] += A[a * DIM + k] * B[k * DIM + b];
        }
}

static void copy(const Mat A, Mat out)
{
    for (int k = 0; k < NMAT; k++) out[k] = A[k];
}

/* A = m I + D with tr D = 0 has D^2 = q I, so that exp A = e^m (cosh r I + sinh r/r D), r = sqrt q;
 * cos and sin for q < 0. */
static void exponential_plane(const Mat A, Mat out)
{
    enum { XX = 0, XY = 1 % NMAT, YX = DIM % NMAT, YY = NMAT - 1 };
    const double m = 0.5 * (A[XX] + A[YY]), d = 0.5 * (A[XX] - A[YY]), q = d * d + A[XY] * A[YX];
    const double r = sqrt(fabs(q)), e = exp(m);
    const double even = q > 0 ? cosh(r) : cos(r);
    const double odd = r < 1e-4 ? 1 + q / 6 : (q > 0 ? sinh(r) : sin(r)) / r;
    out[XX] = e * (even + odd * d);
    out[XY] = e * odd * A[XY];
    out[YX] = e * odd * A[YX];
    out[YY] = e * (even - odd * d);
}

static void exponential_space(const Mat A, Mat out)
{
    enum { TERMS = 14, MOST_SQUARINGS = 64 };
    double size = 0;
    int squarings = 0;
    Mat small, term, next;
    for (int k = 0; k < NMAT; k++) size = fmax(size, fabs(A[k]));
    for (; DIM * size > 0.25 && squarings < MOST_SQUARINGS; squarings++) size *= 0.5;
    for (int k = 0; k < NMAT; k++) {
        small[k] = ldexp(A[k], -squarings);
        out[k] = term[k] = k % (DIM + 1) == 0;
    }
    for (int n = 1; n <= TERMS; n++) {
        multiply(term, small, next);
        for (int k = 0; k < NMAT; k++) out[k] += term[k] = next[k] / n;
    }
    for (; squarings > 0; squarings--) {
        multiply(out, out, next);
        copy(next, out);
    }
}

void strain_exponential(const Mat A, Mat out)
{
    if (DIM == 1)
        out[0] = exp(A[0]);
    else if (DIM == 2)
        exponential_plane(A, out);
    else
        exponential_space(A, out);
}

/* F += dt dv/dX */
static void strain_reference(const Chunk *c, const Field sums[], double dt)
{
    for (int a = 0; a < DIM; a++)
        for (int b = 0; b < DIM; b++)
            for (int p = 0; p < CHUNK; p++)
                c->F[a * DIM + b][p] += dt * sums[FLUX + b * DIM + a][p];
}

void strain_chunk(const Setup *setup, const Chunk *c, const Field sums[], double dt)
{
    if (setup->frame == FRAME_TOTAL) {
        strain_reference(c, sums, dt);
        return;
    }
    const bool whole = setup->strain == STRAIN_EXPONENTIAL;
    const int rounds = whole ? 1 : setup->subcycles;
    for (int p = 0; p < CHUNK; p++) {
        Mat A, growth, F, next;
        for (int k = 0; k < NMAT; k++) {
            A[k] = dt / rounds * sums[FLUX + k % DIM * DIM + k / DIM][p];
            growth[k] = (k % (DIM + 1) == 0) + A[k];
            F[k] = c->F[k][p];
        }
        if (whole) strain_exponential(A, growth);
        for (int round = 0; round < rounds; round++) {
            multiply(growth, F, next);
            copy(next, F);
        }
        for (int k = 0; k < NMAT; k++) c->F[k][p] = F[k];
    }
}
