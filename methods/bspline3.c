/* bspline3.c: cubic B-splines with MPM's transfers (Steffen, Kirby & Berzins 2008).
 *
 * C2, four nodes per axis, folded at walls like the quadratic ones (bspline.c): the paper replaces
 * the functions next to a boundary by those of a knot vector that ends there; folding gives the
 * natural spline instead, which keeps sum S = 1 and sum S x_i = x up to the wall. */
#include "methods/parts/shapes.h"
#include "methods/parts/transfers.h"

const Method method_bspline3 = {
    .info = {.name = "bspline3",
             .label = "cubic B-spline",
             .about = "cubic B-splines, folded at walls, mass-weighted projection, FLIP update",
             .source = "Steffen, Kirby & Berzins 2008",
             .formula = "v_i = sum m_p S_ip v_p / sum m_p S_ip; v_p += dt sum S_ip a_i",
             .on_request = true},
    .valid = 1u << CD | 1u << UVF | 1u << MUSL | 1u << USL | 1u << USF,
    .integrator = {[1] = CD, [2] = CD, [3] = CD},
    .smooth = true,
    .width = cubic_width,
    .shape = cubic_shape,
    .payload = mass_payload,
    .update = flip_update,
};
