/* ge_wls.c: gradient-enhanced WLS: the velocity gradient of W07 as a second equation of W11's least
 * squares (with its weight 1000 a node's slope is the mean gradient of its particles),
 * accelerations and velocities corrected by the consistent mass matrix (wls/inertia.c,
 * wls/velocity.c), cut cells with a curved side (polygon.c), and v, a and L returned through the
 * spline W. */
#include "methods/wls/params.h"

static const Param params[] = WLS_PARAMS(
    QUADRATURE_EXACT, DISTANCE_CURVED, SPURIOUS_EXTRAPOLATE, RETURN_SPLINE, AVERAGE_FOLDED,
    MASS_CORRECTED, VELOCITY_CORRECTED, MOTION_CONSISTENT, 1000, IN_THIS_DIM(0.25, 0.25, 0.125));

const Method method_ge_wls = {
    .info = {.name = "ge_wls",
             .label = "GE-WLS",
             .about =
                 "WLS2 with gradients in the fit, corrected mass and velocity, curved cut cells",
             .source = "W07 section 4 in W11's least squares",
             .formula =
                 "v_i = c0 of min sum W_ip [(c0 + c.(x_p - x_i) - v_p)^2 + (g h)^2 |c - "
                 "L_p|^2], g = hermite, then corrected by the mass matrix; v_p += dt sum W_ip a_i",
             .params = params},
    .linear_exact = true,
    WLS_STAGES,
};
