/* impm.c: improved material point method (Sulsky & Gong 2016).
 *
 * Velocity and stress are least-squares planes fitted to the particles: v_i is the value of a plane
 * at node i, sigma_c that of a plane at the middle of cell c, where one point integrates the
 * internal force of the cell: f_i = -sum_c V_c sigma_c G_i(x_c). As sum_i G_i = 0, momentum is
 * conserved. Uniform stress causes no force inside the body, wherever its particles lie in their
 * cells, and forces do not jump when particles cross cells.
 *
 * The paper leaves open, and this file chooses: the weights of the fits are quadratic splines,
 * those of WLS (the paper leaves their radius to the user). Masses and body forces are sums over
 * particles, m_i = sum m_p S_ip. V_c of a cell that the body fills in part: centres.c. S, for m_i
 * and from nodes to particles, is the quadratic spline folded at walls: with tents some nodes of
 * partly filled cells would receive forces but no mass. Nodes and cells whose largest weight is
 * below `trigger` take a mean in place of a plane, as in W11 3.5: with planes there (trigger=0)
 * free surfaces are unstable, the ring with 32 cells is lost in four steps; in 2D a block with one
 * particle per cell is unstable at trigger=.25, too. Because of the mean, a linear velocity is
 * projected exactly inside, but not at the outermost nodes. */
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
