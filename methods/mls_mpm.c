/* mls_mpm.c: moving least squares MPM (Hu, Fang, Ge, Qu, Zhu, Pradhana & Jiang 2018).
 *
 * APIC's affine matrix C_p = D^-1 sum_i S_ip v_i (x_i - x_p)^T is the slope of the least-squares
 * plane through the grid velocities, and serves as the velocity gradient; the internal force is its
 * transpose, f_i = -sum_p V0 D^-1 tau S_ip (x_i - x_p), D = h^2/4 (cubic: h^2/3). No derivative of
 * S is used: these are the transfers of tpic with the slopes S (x_i - x_p)/D in the place of dS/dx.
 * Angular momentum sum m (x x v + eps : C D) is conserved, as by APIC.
 *
 * Left open: walls. The weights are folded there as for apic and bspline, and D is the sum of S
 * (x_i - x_p)^2 as it is then. */
#include "methods/parts/shapes.h"
#include "methods/parts/transfers.h"

static void quadratic(const Axis *axis, int width, const Field x, const Field b, Stencil *out)
{
    folded_shape(axis, width, x, b, out);
    fit_slopes(3, x, out);
}

static void cubic(const Axis *axis, int width, const Field x, const Field b, Stencil *out)
{
    cubic_shape(axis, width, x, b, out);
    fit_slopes(4, x, out);
}

static void adapt(const double par[], Method *own)
{
    own->width = par[0] > 0 ? cubic_width : spline_width;
    own->shape = par[0] > 0 ? cubic : quadratic;
}

static const Param params[] = {
    {"shape", 0, 0, 1, "", "weights: quadratic or cubic spline", "", "spline|cubic"},
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

const Method method_mls_mpm = {
    .info = {.name = "mls_mpm",
             .label = "MLS-MPM",
             .about = "APIC whose affine matrix is the velocity gradient, and gives the force",
             .source = "Hu et al. 2018",
             .formula = "C_p = D^-1 sum S_ip v_i (x_i - x_p)^T, f_i = -sum V0 D^-1 tau S_ip (x_i - "
                        "x_p), D = h^2/4",
             .params = params,
             .on_request = true},
    .valid = 1u << CD | 1u << UVF | 1u << MUSL | 1u << USL | 1u << USF,
    .integrator = {[1] = CD, [2] = CD, [3] = CD},
    .keeps_L = true,
    .affine = true,
    .linear_exact = true,
    .pic = 1,
    .turns = true,
    .slopes_fitted = true,
    .smooth = true,
    .width = spline_width,
    .shape = quadratic,
    .payload = gradient_payload,
    .update = pic_update,
    .adapt = adapt,
};
