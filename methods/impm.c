/* impm.c: improved material point method (Sulsky & Gong 2016).
 *
 * The fields of velocity and stress are least-squares planes through the particles: v_i is that at
 * node i, sigma_c that at the middle of cell c, and one point integrates the internal force of a
 * cell, f_i = -sum_c V_c sigma_c G_i(x_c). As sum_i G_i = 0, momentum is kept. Uniform stress makes
 * no force inside, at any place of the particles, and none jumps where they cross cells.
 *
 * Left open, and read so: weights are quadratic splines, those of WLS (the paper lets the radius
 * be chosen). Masses and body forces are the particles' own, m_i = sum m_p S_ip. Cells that the
 * body fills in part have the share of centres.c. S, from nodes to particles and for m_i, is the
 * quadratic spline folded at walls: with tents nodes of such cells would have forces and no mass.
 * Nodes (cells) with no particle nearer than the trigger weight have a mean, as in W11 3.5: with
 * planes of their own, trigger=0, free surfaces are unstable (ring, 32 cells: lost in four steps).
 * (With 1/4 in the plane a block of one particle per cell is.) So a linear velocity is exact
 * inside, and not at the outermost nodes. */
#include "methods/wls/params.h"

static const Param params[] = {{"trigger", IN_THIS_DIM(0.25, 0.4, 0.3), 0, 0.5625, "",
                                "nodes and cells whose largest weight is less have a mean", "",
                                NULL},
                               {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

const Method method_impm = {
    .info = {.name = "impm",
             .label = "IMPM",
             .about = "least-squares velocities at nodes and stresses at the centres of cells",
             .source = "Sulsky & Gong 2016",
             .formula = "v_i = c0 of min sum W_ip (c0 + c.(x_p - x_i) - v_p)^2; f_i = -sum_c V_c "
                        "sigma_c G_i(x_c), sigma_c fitted likewise; v_p += dt sum S_ip a_i",
             .params = params,
             .on_request = true},
    .valid = 1u << CD | 1u << USL,
    .integrator = {[1] = CD, [2] = CD, [3] = CD},
    .smooth = true,
    .width = spline_width,
    .shape = folded_shape,
    .payload = mass_payload,
    .update = flip_update,
    .node_bytes = CENTRES_BYTES,
    .integrate = wls_integrate_centres,
    .repair = wls_repair_centres,
    .make = wls_make_centres,
    .free = wls_free_centres,
};
