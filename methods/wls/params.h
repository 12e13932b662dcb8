/* params.h: wls, wls2 and ge_wls: one list of parameters and one set of stages; the methods
 * differ by their defaults alone. */
#ifndef MPMLAB_WLS_PARAMS_H
#define MPMLAB_WLS_PARAMS_H

#include "methods/parts/shapes.h"
#include "methods/parts/transfers.h"
#include "wls.h"

#define WLS_CHOICE(at, name, value, last, about, source, values)                                   \
    [at] = {name, value, 0, last, "", about, source, values}
#define WLS_NUMBER(at, name, value, most, about, source)                                           \
    [at] = {name, value, 0, most, "", about, source, NULL}

#define WLS_PARAMS(quadrature, distance, spurious, back, average, mass, velocity, motion, hermite, \
                   trigger)                                                                        \
    {                                                                                              \
        WLS_CHOICE(P_STRESS, "stress", STRESS_LINEAR, 1,                                           \
                   "values at a point from the nodes' linear functions, or their values only",     \
                   "W11 eqs 19-21", "linear|c0"),                                                  \
            WLS_CHOICE(P_QUADRATURE, "quadrature", quadrature, 3,                                  \
                       "cut cells: one point at the centroid; exact for bilinear functions; of "   \
                       "16 Gauss points, or evenly spaced ones (4 per axis), those inside",        \
                       "W11 3.4", "centroid|exact|gauss16|samples16"),                             \
            WLS_CHOICE(                                                                            \
                P_DISTANCE, "distance", distance, 3,                                               \
                "of nodes: to the mean of surface points, along their normals, along them on a "   \
                "curved surface, or the scene's own",                                              \
                "W11 eqs 15-17", "weighted_mean|normals|curved|exact"),                            \
            WLS_CHOICE(                                                                            \
                P_SPURIOUS, "spurious_velocity", spurious, 1,                                      \
                "velocity of spurious nodes: their mean, or extrapolated from good neighbours",    \
                "W11 3.5", "constant|extrapolate"),                                                \
            WLS_CHOICE(P_RETURN, "return", back, 1, "what takes v, a and L back to particles",     \
                       "W11 eqs 5, 6", "linear|spline"),                                           \
            WLS_CHOICE(                                                                            \
                P_AVERAGE, "average", average, 2,                                                  \
                "force of spurious nodes: by mass; the plain mean as printed (blows up); by "      \
                "mass, and their own goes to their good neighbours",                               \
                "W11 4.5", "weighted|literal|folded"),                                             \
            WLS_CHOICE(                                                                            \
                P_MASS, "mass", mass, 1,                                                           \
                "accelerations by row sums of the mass matrix, or corrected towards the matrix",   \
                "", "lumped|corrected"),                                                           \
            WLS_CHOICE(P_VELOCITY, "velocity", velocity, 1,                                        \
                       "node velocities: as fitted, or corrected for fit and return", "",          \
                       "plain|corrected"),                                                         \
            WLS_CHOICE(                                                                            \
                P_MOTION, "motion", motion, 1,                                                     \
                "with corrected mass nodes move particles with v + dt a of the lumped mass, or "   \
                "of the corrected one",                                                            \
                "", "lagged|consistent"),                                                          \
            WLS_NUMBER(P_HERMITE, "hermite", hermite, 1e6,                                         \
                       "weight of the particles' velocity gradients in the fit of v; 0: none",     \
                       "W07 4"),                                                                   \
            WLS_NUMBER(P_TRIGGER, "trigger", trigger, 0.5625,                                      \
                       "nodes whose largest weight is less are spurious", "W11 3.5"),              \
            WLS_NUMBER(P_SURFACE_PER_CELL, "surface_per_cell", 0, 64,                              \
                       "surface points per cell; 0: as dense as particles", "W11 3.3"),            \
            WLS_CHOICE(                                                                            \
                P_CONDITION, "condition", CONDITION_WEIGHT, 2,                                     \
                "spurious nodes: no particle within the trigger weight; the moments' determinant " \
                "vanishes; or fewer particles than a plane needs",                                 \
                "W11 3.5", "weight|determinant|count"),                                            \
        {                                                                                          \
            NULL, 0, 0, 0, NULL, NULL, NULL, NULL                                                  \
        }                                                                                          \
    }

#define WLS_STAGES                                                                                 \
    .valid = 1u << CD | 1u << USL, .integrator = {[1] = CD, [2] = CD, [3] = CD}, .surface = true,  \
    .about_node = true, .width = tent_width, .shape = inner_tent_shape, .update = flip_update,     \
    .assemble = wls_assemble, .repair = wls_repair, .patches = wls_patches, .normal = wls_normal,  \
    .make = wls_make, .free = wls_free, .adapt = wls_adapt

#endif
