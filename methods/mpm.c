/* mpm.c: the material point method: tent functions, mass-weighted projection (W07 eq 2.1).
 * In 2D its default is the velocity-first scheme: central difference with tents is fragile there.
 */
#include "methods/parts/shapes.h"
#include "methods/parts/transfers.h"

const Method method_mpm = {
    .info = {.name = "mpm",
             .label = "MPM",
             .about = "tent functions, mass-weighted projection, FLIP update",
             .source = "Sulsky, Chen & Schreyer 1994; W07 eq 2.1",
             .formula = "v_i = sum m_p S_ip v_p / sum m_p S_ip; v_p += dt sum S_ip a_i"},
    .valid = 1u << CD | 1u << UVF | 1u << MUSL | 1u << USL | 1u << USF,
    .integrator = {[1] = CD, [2] = UVF, [3] = UVF},
    .width = tent_width,
    .shape = tent_shape,
    .payload = mass_payload,
    .update = flip_update,
};
