/* fold.c: symmetry lines by parity: what mirrored particles would have deposited. See wls.h. */
#include "wls.h"

/* Signs of a mirrored particle's moments, quantities and surface sums, for a mirror across `axis`.
 */
typedef struct Parity {
    Line moments, value, skin[2];
} Parity;

static Parity parity_of(int axis)
{
    Parity q;
    for (int l = 0; l < LANES; l++) q.moments[l] = q.value[l] = q.skin[0][l] = q.skin[1][l] = 1;
    q.moments[M_FIRST + axis] = q.value[Q_V + axis] = q.value[Q_FORCE + axis] = -1;
    if (R_RIDES) q.value[Q_R + axis] = -1;
    q.skin[0][K_FIRST + axis] = q.skin[0][K_NORMAL + axis] = -1;
    for (int d = 0; d < DIM; d++) {
        if (d == axis) continue;
        q.moments[M_SECOND + pair(d, axis)] = q.value[Q_SIGMA + pair(d, axis)] = -1;
        q.skin[1][K_RR + pair(d, axis)] = -1;
        q.skin[1][K_RN + d * DIM + axis] = q.skin[1][K_RN + axis * DIM + d] = -1;
    }
    return q;
}

/* A cell's image lies above the node before the image of its own node. The cell above a line's own
 * node is a ghost only if the body lies below. */
static bool find_cell(const Grid *g, const Mirror *m, size_t ghost, size_t *image)
{
    size_t stride = 1;
    for (int d = 0; d < m->axis; d++) stride *= (size_t)g->n[d];
    if (ghost == *image && m->side < 0) return false;
    *image -= stride;
    return true;
}

static void fold_pair(Sim *sim, const Mirror *m, size_t ghost, size_t image, int image_row,
                      void *own)
{
    Wls *w = own;
    const Parity q = parity_of(m->axis);
    (void)image_row;
    if (w->centres && !find_cell(&sim->g, m, ghost, &image)) return;
    w->fit[image][FIT_MOMENTS] += q.moments * w->fit[ghost][FIT_MOMENTS];
    w->fit[image][FIT_VALUE] += q.value * w->fit[ghost][FIT_VALUE];
    for (int d = 0; d < DIM; d++)
        w->fit[image][FIT_SLOPE + d] +=
            (d == m->axis ? -1.0 : 1.0) * q.value * w->fit[ghost][FIT_SLOPE + d];
    for (int k = 0; k < 2 && w->skinned[ghost]; k++)
        wls_skin_of(w, image)[k] += q.skin[k] * w->skin[ghost][k];
    w->most[image] = w->most[ghost] > w->most[image] ? w->most[ghost] : w->most[image];
}

void wls_fold(Sim *sim, Wls *w)
{
    mirror_visit_pairs(sim, false, fold_pair, w);
}
