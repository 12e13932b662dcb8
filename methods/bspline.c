/* bspline.c: quadratic B-splines, their weights folded at walls, with MPM's transfers.
 *
 * The spline is the tent convolved with a box of one whole cell, so C1: no force jumps where a
 * particle crosses a cell. Every particle has three nodes per axis whatever its size, as GIMP has
 * with half width h/2. Steffen, Kirby & Berzins 2008 change the functions next to a boundary;
 * folding the outer weight 2:-1 into the two nodes inside gives theirs: it leaves a tent in the
 * last half cell. */
#include "methods/parts/shapes.h"
#include "methods/parts/transfers.h"

const Method method_bspline = {
    .info = {.name = "bspline",
             .label = "B-spline",
             .about = "quadratic B-splines, folded at walls, mass-weighted projection, FLIP update",
             .source = "Steffen, Kirby & Berzins 2008",
             .formula = "v_i = sum m_p S_ip v_p / sum m_p S_ip; v_p += dt sum S_ip a_i"},
    .valid = 1u << CD | 1u << UVF | 1u << MUSL | 1u << USL | 1u << USF,
    .integrator = {[1] = CD, [2] = CD, [3] = CD},
    .smooth = true,
    .width = spline_width,
    .shape = folded_shape,
    .payload = mass_payload,
    .update = flip_update,
};
