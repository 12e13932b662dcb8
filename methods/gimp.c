/* gimp.c: contiguous-particle GIMP: exact convolution, half widths follow F (W07 section 2). */
#include "methods/parts/shapes.h"
#include "methods/parts/transfers.h"

const Method method_gimp = {
    .info = {.name = "gimp",
             .label = "GIMP",
             .about =
                 "tent convolved with the particle's box, mass-weighted projection, FLIP update",
             .source = "Bardenhagen & Kober 2004; W07 eq 2.1",
             .formula = "v_i = sum m_p S_ip v_p / sum m_p S_ip; v_p += dt sum S_ip a_i"},
    .valid = 1u << CD | 1u << UVF | 1u << MUSL | 1u << USL | 1u << USF,
    .integrator = {[1] = CD, [2] = CD, [3] = CD},
    .smooth = true,
    .width = gimp_width,
    .shape = gimp_shape,
    .payload = mass_payload,
    .update = flip_update,
};
