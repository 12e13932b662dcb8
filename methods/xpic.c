/* xpic.c: extended particle-in-cell of order k (Hammerquist & Nairn 2017).
 *
 * S+ takes particle velocities V to nodes by mass, S takes them back. The part of V in the null
 * space of S+ is noise. PIC takes V to S S+ V, which damps far more; XPIC(k) to [I - (I - S S+)^k]
 * V + dt S a, whose filter tends to the projection that removes the null space alone. In terms of
 * the grid velocity v = S+ V, with A = S+ S: S sum_{l<k} c_l A^l v, c_l = (-1)^l C(k, l+1).
 * Positions and gradient use the plain grid velocity. Order 1 is PIC. */
#include "methods/parts/filters.h"

const Method method_xpic = {
    .info = {.name = "xpic",
             .label = "XPIC",
             .about = "PIC update of velocities that were filtered of the null space, order k",
             .source = "Hammerquist & Nairn 2017",
             .formula = "v_p = [I - (I - S S+)^k] v_p + dt S a, S+ the projection to nodes",
             .params = filter_params},
    .valid = 1u << CD | 1u << UVF | 1u << MUSL | 1u << USL | 1u << USF,
    .integrator = {[1] = CD, [2] = CD, [3] = CD},
    .pic = 1,
    .smooth = true,
    .width = gimp_width,
    .shape = gimp_shape,
    .payload = mass_payload,
    .update = filtered_update,
    .filter = filter_of_order,
    .filter_first = true,
    .adapt = choose_shape,
};
