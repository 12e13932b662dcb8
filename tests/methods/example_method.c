/* example_method.c: rigid particle-in-cell (Jiang, Schroeder, Selle, Teran & Stomakhin 2015).
 *
 * Every particle deposits v_p + W_p (x_i - x_p), W the skew part of its velocity gradient: it acts
 * as a small rigid body. Back: v_p = sum_i S v_i and W from the same grid velocity. PIC's averaging
 * keeps rotation and damps every other motion of the size of a cell. Momentum is conserved because
 * sum_i S_ip x_i = x_p. */
#include "methods/parts/shapes.h"
#include "methods/parts/transfers.h"

static void update(const Chunk *c, const Field sums[], double dt, unsigned take)
{
    pic_update(c, sums, dt, take); /* v, L, x, F */
    if (!(take & TAKE_V)) return;
    for (int a = 0; a < DIM; a++)
        for (int b = 0; b <= a; b++)
            for (int p = 0; p < CHUNK; p++) {
                const double W = 0.5 * (c->L[a * DIM + b][p] - c->L[b * DIM + a][p]);
                c->L[a * DIM + b][p] = W;
                c->L[b * DIM + a][p] = -W;
            }
}

const Method method_rpic = {
    .info = {.name = "rpic",
             .label = "RPIC",
             .about = "particles as small rigid bodies: PIC that keeps rotation",
             .formula =
                 "v_i = sum m_p S_ip (v_p + W_p (x_i - x_p)) / sum m_p S_ip; v_p = sum S_ip v_i",
             .source = "Jiang et al. 2015"},
    .valid = 1u << CD | 1u << UVF | 1u << MUSL | 1u << USL | 1u << USF,
    .integrator = {[1] = CD, [2] = CD, [3] = CD},
    .keeps_L = true,
    .affine = true,
    .pic = 1,
    .smooth = true,
    .width = gimp_width,
    .shape = gimp_shape,
    .payload = gradient_payload,
    .update = update,
};
