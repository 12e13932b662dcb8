/* cpdi2.c: second-order convected particle domain interpolation (Sadeghirad, Brannon & Guilkey
 * 2013).
 *
 * As cpdi.c, but the corners are points that move with the grid, so that domains stay contiguous
 * and become any quadrilateral (3D: hexahedron): w_c and g_c are the means of its multilinear
 * functions and of their gradients, w_c = int N_c J / V, g_c = int J F^-T dN_c / V, F its Jacobian,
 * by two Gauss points per axis, which are exact. sum S = 1 and linear fields have exact gradients;
 * sum S x_i is the domain's centroid, which x_p follows to second order in time.
 *
 * Left open: corners move with the velocities that move particles, with musl with those projected
 * again. They start at x_p + F r_c, from GIMP's boxes. */
#include "common/contract/material.h"
#include "methods/parts/corners.h"
#include "methods/parts/transfers.h"

static void list(const Chunk *chunk, const Place *grid, const Field x[], NodeList *out)
{
    Field w[CORNERS], g[CORNERS][DIM], y[CORNERS][DIM];
    for (int p = 0; p < CHUNK; p++) {
        double r[CORNERS][DIM], V = 0, wV[CORNERS] = {0}, gV[CORNERS][DIM] = {{0}}, s[DIM];
        for (int c = 0; c < CORNERS; c++)
            for (int d = 0; d < DIM; d++) {
                const double at = own_field(chunk, c * DIM + d)[p] * grid->cells - grid->origin[d];
                r[c][d] = corner_within(at - x[d][p], grid->reach);
                y[c][d][p] = x[d][p] + r[c][d];
            }
        for (int q = 0; q < CORNERS; q++) {
            for (int d = 0; d < DIM; d++) s[d] = corner_side(q, d) / sqrt(3);
            add_gauss(r, s, &V, wV, gV);
        }
        for (int c = 0; c < CORNERS; c++) w[c][p] = wV[c] / V;
        for (int c = 0; c < CORNERS; c++)
            for (int d = 0; d < DIM; d++) g[c][d][p] = gV[c][d] / V;
    }
    for (int c = 0; c < CORNERS; c++)
        corner_nodes(grid, c, (const Field *)y[c], w[c], (const Field *)g[c], out);
}

static void update(const Chunk *c, const Field sums[], double dt, unsigned take)
{
    flip_update(c, sums, dt, take);
    for (int k = 0; take & (TAKE_X | MOVE_STASH) && k < CORNERS * DIM; k++)
        for (int p = 0; p < CHUNK; p++) own_field(c, k)[p] += dt * sums[POINT_SUMS + k][p];
}

static const char *const names[] = {CORNER_NAMES, NULL};

const Method method_cpdi2 = {
    .info = {.name = "cpdi2",
             .label = "CPDI2",
             .about = "weights from the corners of quadrilaterals that move with the grid",
             .source = "Sadeghirad, Brannon & Guilkey 2013",
             .formula = "S_ip = sum_c w_c N_i(x_c), w_c the mean of the domain's corner function; "
                        "x_c += dt sum N_i(x_c) v_i; v_p += dt sum S_ip a_i",
             .on_request = true},
    .valid = 1u << CD | 1u << UVF | 1u << MUSL | 1u << USL | 1u << USF,
    .integrator = {[1] = CD, [2] = CD, [3] = CD},
    .smooth = true,
    .width = corner_width,
    .list = list,
    .reach = corner_reach,
    .points = CORNERS,
    .own = names,
    .start = start_corners,
    .payload = mass_payload,
    .update = update,
};
