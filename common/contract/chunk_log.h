/* chunk_log.h: natural logarithm of 64 numbers at once, within 1.5 ulp, as one vectorized loop.
 * x = 2^e m with m in [sqrt(1/2), sqrt(2)); log m by the odd series in s = (m-1)/(m+1) whose
 * minimax coefficients are those of Sun's fdlibm (e_log.c). For normal positive numbers; NaN for
 * zero, negative numbers and NaN. Not for subnormal numbers and infinity. */
#ifndef MPMLAB_CHUNK_LOG_H
#define MPMLAB_CHUNK_LOG_H

#include <stdint.h>
#include <string.h>

static inline double log_one(double x)
{
    const double ln2_hi = 6.93147180369123816490e-01, ln2_lo = 1.90821492927058770002e-10;
    int64_t bits, mant;
    memcpy(&bits, &x, sizeof bits);
    uint64_t top = (uint64_t)bits +
                   (0x3ff0000000000000 - 0x3fe6a09e667f3bcd); /* so that m starts at sqrt(1/2) */
    int64_t e = (int64_t)(top >> 52) - 1023;
    mant = (int64_t)((uint64_t)bits - ((uint64_t)e << 52));
    int64_t e_bits =
        e + 0x4338000000000000; /* 2^52 + 2^51 + e: integer to double without AVX-512 */
    double m, k;
    memcpy(&m, &mant, sizeof m);
    memcpy(&k, &e_bits, sizeof k);
    k -= 6755399441055744.0;
    double f = m - 1, s = f / (2 + f), z = s * s, w = z * z;
    double odd = w * (3.999999999940941908e-01 +
                      w * (2.222219843214978396e-01 + w * 1.531383769920937332e-01));
    double even = z * (6.666666666666735130e-01 +
                       w * (2.857142874366239149e-01 +
                            w * (1.818357216161805012e-01 + w * 1.479819860511658591e-01)));
    double half = 0.5 * f * f;
    double y = k * ln2_hi - ((half - (s * (half + odd + even) + k * ln2_lo)) - f);
    return x > 0 ? y : __builtin_nan("");
}

static inline void log_n(int n, const double x[], double y[])
{
    for (int p = 0; p < n; p++) y[p] = log_one(x[p]);
}

#endif
