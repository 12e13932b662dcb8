/* apic.c: affine particle-in-cell (Jiang, Schroeder, Selle, Teran & Stomakhin 2015).
 *
 * To the grid: m_i v_i = sum_p S_ip m_p (v_p + B_p D_p^-1 (x_i - x_p)); back: v_p = sum_i S_ip v_i,
 * B_p = sum_i S_ip v_i (x_i - x_p)^T. D_p = sum_i S_ip (x_i - x_p)(x_i - x_p)^T is diagonal for
 * products of one weight per axis: h^2/4 for the quadratic spline; with GIMP it varies with the
 * position in the cell and the box width. Therefore particles keep B (in the array of L), and the
 * deposit divides it by the current D: then
 *   sum_i x_i x m_i v_i = sum_p m_p (x_p x v_p + eps : B_p),
 * whatever D is, and the return conserves it, because x moves with v: angular momentum is
 * conserved. Next to a wall the folded spline is a tent, whose D fades with the distance, as B
 * does. */
#include "methods/parts/shapes.h"
#include "methods/parts/transfers.h"

static void update(const Chunk *c, const Field sums[], double dt, unsigned take)
{
    const Field *moment = sums + LANES + FLUX; /* b DIM + a: sum_i S v_a (x_i - x_p)_b */
    pic_update(c, sums, dt, take);
    if (take & TAKE_V)
        for (int a = 0; a < DIM; a++)
            for (int b = 0; b < DIM; b++)
                for (int p = 0; p < CHUNK; p++) c->L[a * DIM + b][p] = moment[b * DIM + a][p];
}

static const Param params[] = {SHAPE_PARAM(BY_SPLINE), {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

const Method method_apic = {
    .info = {.name = "apic",
             .label = "APIC",
             .about = "affine velocity of every particle from moments of the grid velocity",
             .source = "Jiang et al. 2015",
             .formula = "v_i = sum m_p S_ip (v_p + B_p D_p^-1 (x_i - x_p)) / sum m_p S_ip; v_p = "
                        "sum S_ip v_i, B_p = sum S_ip v_i (x_i - x_p)^T",
             .params = params},
    .valid = 1u << CD | 1u << UVF | 1u << MUSL | 1u << USL | 1u << USF,
    .integrator = {[1] = CD, [2] = CD, [3] = CD},
    .keeps_L = true,
    .affine = true,
    .moments = true,
    .linear_exact = true,
    .pic = 1,
    .turns = true,
    .smooth = true,
    .width = spline_width,
    .shape = folded_shape,
    .payload = gradient_payload,
    .update = update,
    .adapt = choose_shape,
};
