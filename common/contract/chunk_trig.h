/* chunk_trig.h: sine and cosine as plain arithmetic. The error is at most 1 ulp of the result or
 * 1e-16 |x|, whichever is larger. Loops over points that call it are vectorized, and give the same
 * bits whatever the length of the loop.
 *
 * x = n pi/2 + r, |r| <= pi/4, with pi/2 in two parts, of which the first times n is exact; sin r
 * and cos r by the polynomials whose minimax coefficients are those of Sun's fdlibm (k_sin.c,
 * k_cos.c). |x| < 1e5; NaN for NaN. */
#ifndef MPMLAB_CHUNK_TRIG_H
#define MPMLAB_CHUNK_TRIG_H

#include <stdint.h>
#include <string.h>

/* sin(r + tail) and cos(r + tail), |r| <= pi/4. */
static inline double trig_sin_near_0(double r, double tail)
{
    const double z = r * r, v = z * r;
    const double odd =
        8.33333333332248946124e-03 +
        z * (-1.98412698298579493134e-04 +
             z * (2.75573137070700676789e-06 +
                  z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)));
    return r - ((z * (0.5 * tail - v * odd) - tail) + v * 1.66666666666666324348e-01);
}

static inline double trig_cos_near_0(double r, double tail)
{
    const double z = r * r, half = 0.5 * z, w = 1 - half;
    const double even =
        z * (4.16666666666666019037e-02 +
             z * (-1.38888888888741095749e-03 +
                  z * (2.48015872894767294178e-05 +
                       z * (-2.75573143513906633035e-07 +
                            z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)))));
    return w + (((1 - w) - half) + (z * even - r * tail));
}

static inline double trig_with_sign(double x, uint64_t negative)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    bits ^= negative << 63;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static inline void trig_sin_cos(double x, double *sine, double *cosine)
{
    const double two_over_pi = 6.36619772367581382433e-01;
    const double half_pi_hi = 1.57079632673412561417e+00, half_pi_lo = 6.07710050650619224932e-11;
    const double whole =
        6755399441055744.0; /* 2^52 + 2^51: what is added to it becomes an integer */
    const double shifted = x * two_over_pi + whole, n = shifted - whole;
    const double high = x - n * half_pi_hi, low = n * half_pi_lo;
    const double r = high - low, tail = (high - r) - low;
    const double s = trig_sin_near_0(r, tail), c = trig_cos_near_0(r, tail);
    uint64_t turns; /* n modulo 4 in the last two bits */
    memcpy(&turns, &shifted, sizeof turns);
    const int swapped = (int)(turns & 1);
    *sine = trig_with_sign(swapped ? c : s, turns >> 1 & 1);
    *cosine = trig_with_sign(swapped ? s : c, (turns >> 1 ^ turns) & 1);
}

static inline double trig_sin(double x)
{
    double s, c;
    trig_sin_cos(x, &s, &c);
    return s;
}

static inline double trig_cos(double x)
{
    double s, c;
    trig_sin_cos(x, &s, &c);
    return c;
}

#endif
