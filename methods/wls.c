/* wls.c: weighted least squares on the nodes, integrals over cut cells: the reading of W11
 * that runs (its tail of first order included). */
#include "shapes.h"
#include "transfers.h"
#include "wls.h"

static const Param params[] = {
    [P_STRESS] = {"stress", STRESS_LINEAR, 0, 1, "",
                  "values at a point from the nodes' linear functions, or their values only",
                  "W11 eqs 19-21", "linear|c0"},
    [P_QUADRATURE] = {"quadrature", QUADRATURE_CENTROID, 0, 1, "",
                      "cut cells: one point at the centroid, or exact for bilinear functions",
                      "W11 3.4.2", "centroid|exact"},
    [P_DISTANCE] =
        {"distance", DISTANCE_WEIGHTED_MEAN, 0, 2, "",
         "of nodes: to the mean of surface points, along their normals, or the scene's own",
         "W11 eqs 15-17", "weighted_mean|normals|exact"},
    [P_SPURIOUS] = {"spurious_velocity", SPURIOUS_CONSTANT, 0, 1, "",
                    "velocity of spurious nodes: their mean, or extrapolated from good neighbours",
                    "W11 3.5", "constant|extrapolate"},
    [P_RETURN] = {"return", RETURN_LINEAR, 0, 1, "", "what takes v, a and L back to particles",
                  "W11 eqs 5, 6", "linear|spline"},
    [P_AVERAGE] = {"average", AVERAGE_WEIGHTED, 0, 1, "",
                   "force of spurious nodes: by mass, or the plain mean as printed (blows up)",
                   "W11 4.5", "weighted|literal"},
    [P_TRIGGER] = {"trigger", 0.12, 0, 0.5625, "",
                   "nodes whose largest weight is less are spurious", "W11 3.5", NULL},
    [P_SURFACE_PER_CELL] = {"surface_per_cell", 0, 0, 64, "",
                            "surface points per cell; 0: as dense as particles", "W11 3.3", NULL},
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

const Method method_wls = {
    .info = {.name = "wls",
             .label = "WLS",
             .about = "weighted least squares on nodes, integrals over full and cut cells",
             .source = "W11 sections 3, 4",
             .params = params},
    .valid = 1u << CD | 1u << USL,
    .integrator = {[1] = CD, [2] = CD, [3] = CD},
    .surface = true,
    .about_node = true,
    .width = tent_width,
    .shape = inner_tent_shape,
    .update = flip_update,
    .assemble = wls_assemble,
    .repair = wls_repair,
    .patches = wls_patches,
    .make = wls_make,
    .free = wls_free,
    .adapt = wls_adapt,
};
