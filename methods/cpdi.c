/* cpdi.c: convected particle domain interpolation (Sadeghirad, Brannon & Burghardt 2011).
 *
 * A particle's domain is a parallelogram with the half vectors r_k = F r0_k. On it a grid function
 * is replaced by the multilinear one through its values at the corners; S and grad S are the means
 * of that one and of its gradient: w_c = 2^-n, g_c = F^-T s_c/(2^n l0), s_c the sides of corner c.
 * sum S = 1, sum S x_i = x_p, grad S is exact for linear fields.
 *
 * Left open: r0. It is l0 along each axis (GIMP's boxes), also of particles fitted to a body. The
 * 16 (3D: 64) nodes of the corners are not merged: that costs more than it saves. */
#include "common/contract/material.h"
#include "methods/parts/corners.h"
#include "methods/parts/transfers.h"

static void list(const Chunk *c, const Place *grid, const Field x[], NodeList *out)
{
    Field w, y[DIM], g[DIM], inverse[NMAT];
    for (int p = 0; p < CHUNK; p++) {
        Mat F;
        for (int k = 0; k < NMAT; k++) F[k] = c->F[k][p];
        const double scale = 1 / (determinant(F) * (double)CORNERS * grid->half);
        for (int k = 0; k < NMAT; k++) inverse[k][p] = scale * cofactor(F, k / DIM, k % DIM);
        w[p] = 1.0 / (double)CORNERS;
    }
    for (int corner = 0; corner < CORNERS; corner++) {
        for (int d = 0; d < DIM; d++)
            for (int p = 0; p < CHUNK; p++) {
                double r = 0, slope = 0;
                for (int k = 0; k < DIM; k++) {
                    r += corner_side(corner, k) * c->F[d * DIM + k][p];
                    slope += corner_side(corner, k) * inverse[d * DIM + k][p];
                }
                y[d][p] = x[d][p] + corner_within(grid->half * r, grid->reach);
                g[d][p] = slope;
            }
        corner_nodes(grid, corner, (const Field *)y, w, (const Field *)g, out);
    }
}

const Method method_cpdi = {
    .info = {.name = "cpdi",
             .label = "CPDI",
             .about = "weights from the corners of parallelograms that follow F",
             .source = "Sadeghirad, Brannon & Burghardt 2011",
             .formula = "S_ip = 2^-n sum_c N_i(x_p + F r_c), r_c the corners of the box at rest; "
                        "v_p += dt sum S_ip a_i",
             .on_request = true},
    .valid = 1u << CD | 1u << UVF | 1u << MUSL | 1u << USL | 1u << USF,
    .integrator = {[1] = CD, [2] = CD, [3] = CD},
    .smooth = true,
    .width = corner_width,
    .list = list,
    .reach = parallelogram_reach,
    .payload = mass_payload,
    .update = flip_update,
};
