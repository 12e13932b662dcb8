/* wls2.c: WLS with the causes of its first-order tail cured: distance along normals, exact
 * quadrature of cut cells, spurious velocities extrapolated, a higher trigger weight: that of a
 * particle half a cell away on every axis, (1/2)^2, in 3D (1/2)^3. With 1/4 in 3D nodes at edges
 * and corners of a body may have no good neighbour to extrapolate from. */
#include "methods/wls/params.h"

static const Param params[] = WLS_PARAMS(
    QUADRATURE_EXACT, DISTANCE_NORMALS, SPURIOUS_EXTRAPOLATE, RETURN_LINEAR, AVERAGE_WEIGHTED,
    MASS_LUMPED, VELOCITY_PLAIN, MOTION_LAGGED, 0, IN_THIS_DIM(0.25, 0.25, 0.125));

const Method method_wls2 = {
    .info = {.name = "wls2",
             .label = "WLS2",
             .about = "WLS with second-order surfaces, exact cut cells, extrapolated velocities",
             .source = "after W11",
             .formula = "as wls: fit on nodes, integrals over cells; v_p += dt sum S_ip a_i",
             .params = params},
    .linear_exact = true,
    WLS_STAGES,
};
