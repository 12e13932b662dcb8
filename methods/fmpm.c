/* fmpm.c: full-mass-matrix MPM of order k (Nairn & Hammerquist 2021).
 *
 * The grid momentum p = S^T m V belongs to the full mass matrix M = S^T m S, m the particles'. With
 * the lumped m_i, m_i^-1 M = S+ S = A, so M^-1 p = A^-1 v with v = p/m_i the usual velocity;
 * FMPM(k) cuts the series A^-1 = sum_l (I - A)^l after k terms, which is sum_{l<k} c_l A^l with c_l
 * = (-1)^l C(k, l+1): the filter of XPIC(k), here on the accelerated velocity, and the
 * whole update uses it: v_p = S v(k), x, L. Order 1 is PIC with the lumped matrix. With cd
 * and GIMP's narrow boxes a coarse spinning block loses its corners from order 2 on (8 cells: after
 * 180 steps); with musl, uvf, usf or splines it does not. */
#include "methods/parts/filters.h"

const Method method_fmpm = {
    .info =
        {.name = "fmpm",
         .label = "FMPM",
         .about = "grid velocities of a full mass matrix to order k, PIC update",
         .source = "Nairn & Hammerquist 2021",
         .formula =
             "v_p = S sum_(l<k) (I - S+ S)^l v_i, v_i the accelerated velocity of the lumped mass",
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
    .adapt = choose_shape,
};
