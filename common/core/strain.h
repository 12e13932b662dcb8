/* strain.h: how F follows the velocity gradient over a step, where that is not F += dt L F. */
#ifndef MPMLAB_STRAIN_H
#define MPMLAB_STRAIN_H

#include "common/contract/solver.h"

/* exp(A); 1D and plane in closed form, in space by a series of A/2^s, squared s times (Moler & Van
 * Loan 2003). */
void strain_exponential(const Mat A, Mat out);

/* F of a chunk over dt [s] from L, gathered in the lanes FLUX + b DIM + a of sums [1/s]: exp(dt L)
 * F, or (I + dt L/k)^k F with k = setup->subcycles. In the total frame the lanes hold dv/dX, and F
 * += dt dv/dX. */
void strain_chunk(const Setup *setup, const Chunk *c, const Field sums[], double dt);

#endif
