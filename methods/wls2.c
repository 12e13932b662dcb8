/* wls2.c: WLS with the causes of its first-order tail cured: distance along normals, exact
 * quadrature of cut cells, spurious velocities extrapolated, a higher trigger weight. */
#include "methods/wls/params.h"

static const Param params[] =
    WLS_PARAMS(QUADRATURE_EXACT, DISTANCE_NORMALS, SPURIOUS_EXTRAPOLATE, RETURN_LINEAR,
               AVERAGE_WEIGHTED, MASS_LUMPED, VELOCITY_PLAIN, MOTION_LAGGED, 0, 0.25);

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
