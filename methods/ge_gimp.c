/* ge_gimp.c: gradient-enhanced projection on GIMP functions (W07 section 4). */
#include "methods/parts/shapes.h"
#include "methods/parts/transfers.h"

const Method method_ge_gimp = {
    .info =
        {.name = "ge_gimp",
         .label = "GE-GIMP",
         .about = "GIMP with the gradient-enhanced projection: exact for linear fields",
         .source = "W07 eqs 4.1-4.3",
         .formula =
             "v_i = sum m_p S_ip (v_p + L_p (x_i - x_p)) / sum m_p S_ip; v_p += dt sum S_ip a_i"},
    .valid = 1u << CD | 1u << USL,
    .valid_fresh = 1u << UVF | 1u << MUSL,
    .integrator = {[1] = CD, [2] = CD, [3] = CD},
    .keeps_L = true,
    .affine = true,
    .linear_exact = true,
    .smooth = true,
    .width = gimp_width,
    .shape = gimp_shape,
    .payload = gradient_payload,
    .update = flip_update,
};
