/* wls.c: weighted least squares on the nodes, integrals over cut cells: W11 as published, where the
 * text is ambiguous in the variant that is stable. It loses second order on fine meshes. */
#include "methods/wls/params.h"

static const Param params[] =
    WLS_PARAMS(QUADRATURE_CENTROID, DISTANCE_WEIGHTED_MEAN, SPURIOUS_CONSTANT, RETURN_LINEAR,
               AVERAGE_WEIGHTED, MASS_LUMPED, VELOCITY_PLAIN, MOTION_LAGGED, 0, 0.12);

const Method method_wls = {
    .info = {.name = "wls",
             .label = "WLS",
             .about = "weighted least squares on nodes, integrals over full and cut cells",
             .source = "W11 sections 3, 4",
             .formula = "v_i = c0 of min sum W_ip (c0 + c.(x_p - x_i) - v_p)^2; f_i = -sum_q "
                        "sigma_q G_iq V_q over cells q; v_p += dt sum S_ip a_i",
             .params = params},
    WLS_STAGES,
};
