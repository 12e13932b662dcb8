/* wls.c: weighted least squares on the nodes, integrals over cut cells: the reading of W11
 * that runs (its tail of first order included). */
#include "methods/wls/params.h"

static const Param params[] =
    WLS_PARAMS(QUADRATURE_CENTROID, DISTANCE_WEIGHTED_MEAN, SPURIOUS_CONSTANT, RETURN_LINEAR,
               AVERAGE_WEIGHTED, MASS_LUMPED, VELOCITY_PLAIN, MOTION_LAGGED, 0, 0.12);

const Method method_wls = {
    .info = {.name = "wls",
             .label = "WLS",
             .about = "weighted least squares on nodes, integrals over full and cut cells",
             .source = "W11 sections 3, 4",
             .params = params},
    WLS_STAGES,
};
