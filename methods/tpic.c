/* tpic.c: Taylor particle-in-cell transfer (Nakamura, Matsumura & Mizutani 2023).
 *
 * To the grid: m_i v_i = sum_p S_ip m_p (v_p + L_p (x_i - x_p)), the gradient-enhanced deposit.
 * Back: v_p = sum_i S_ip v_i (PIC) and L_p = sum_i v_i dS_ip/dx, both of one grid velocity. The
 * slope returns what PIC's averaging takes from every linear field. Momentum is conserved because
 * sum_i S_ip x_i = x_p. L and v are taken together, so that re-projecting integrators see no stale
 * gradient (unlike the FLIP update of ge_gimp). */
#include "methods/parts/shapes.h"
#include "methods/parts/transfers.h"

static const Param params[] = {SHAPE_PARAM(BY_SPLINE), {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

const Method method_tpic = {
    .info = {.name = "tpic",
             .label = "TPIC",
             .about = "gradient-enhanced deposit, PIC update of velocity and gradient",
             .source = "Nakamura, Matsumura & Mizutani 2023",
             .formula = "v_i = sum m_p S_ip (v_p + L_p (x_i - x_p)) / sum m_p S_ip; v_p = sum S_ip "
                        "v_i, L_p = sum v_i dS_ip/dx",
             .params = params},
    .valid = 1u << CD | 1u << UVF | 1u << MUSL | 1u << USL | 1u << USF,
    .integrator = {[1] = CD, [2] = CD, [3] = CD},
    .keeps_L = true,
    .affine = true,
    .linear_exact = true,
    .pic = 1,
    .smooth = true,
    .width = spline_width,
    .shape = folded_shape,
    .payload = gradient_payload,
    .update = pic_update,
    .adapt = choose_shape,
};
