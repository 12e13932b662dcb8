/* ge_mpm.c: gradient-enhanced projection on tents (W07 section 4). The gradients of tents jump at
 * cell borders: most runs of W07's stopped bar are lost or wrong by 20 % (W07-12). */
#include "methods/parts/shapes.h"
#include "methods/parts/transfers.h"

const Method method_ge_mpm = {
    .info =
        {.name = "ge_mpm",
         .label = "GE-MPM",
         .about = "MPM with the gradient-enhanced projection; tents give it poor gradients",
         .source = "W07 eqs 4.1-4.3",
         .formula =
             "v_i = sum m_p S_ip (v_p + L_p (x_i - x_p)) / sum m_p S_ip; v_p += dt sum S_ip a_i"},
    .valid = 1u << CD | 1u << USL,
    .valid_fresh = 1u << UVF | 1u << MUSL,
    .integrator = {[1] = CD, [2] = CD, [3] = CD},
    .keeps_L = true,
    .affine = true,
    .linear_exact = true,
    .width = tent_width,
    .shape = tent_shape,
    .payload = gradient_payload,
    .update = flip_update,
};
