/* tlmpm.c: total Lagrangian MPM (de Vaucorbeil, Nguyen & Hutchinson 2020).
 *
 * MPM on the reference grid (frame=total): the weights of a particle stay those of its reference
 * position X, f_i = -sum_p V0 P dS_ip/dX, F_p += dt sum_i v_i dS_ip/dX. Particles cross no cells
 * and cannot separate numerically; bodies that meet, or meet walls later, need another method.
 * Momentum is conserved as sum_i dS_ip/dX = 0.
 *
 * Left open: the update of velocities. The paper blends FLIP and PIC by hand; here it is FLIP. */
#include "methods/parts/shapes.h"
#include "methods/parts/transfers.h"

const Method method_tlmpm = {
    .info = {.name = "tlmpm",
             .label = "TLMPM",
             .about = "MPM whose weights and walls stay on the reference grid",
             .source = "de Vaucorbeil, Nguyen & Hutchinson 2020",
             .formula = "f_i = -sum V0 P dS_ip/dX, F_p += dt sum v_i dS_ip/dX; v_p += dt sum S_ip "
                        "a_i, S_ip at X_p",
             .on_request = true},
    .valid = 1u << CD | 1u << UVF | 1u << MUSL | 1u << USL | 1u << USF,
    .integrator = {[1] = CD, [2] = CD, [3] = CD},
    .frame = FRAME_TOTAL,
    .width = tent_width,
    .shape = tent_shape,
    .payload = mass_payload,
    .update = flip_update,
};
