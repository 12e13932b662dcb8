/* polypic.c: polynomial particle-in-cell (Fu, Guo, Gast, Jiang & Teran 2017): quadratic splines and
 * modes of degree 0 to 2 (modes.h), m_i v_i = sum_p m_p S_ip sum_r s_r(x_i - x_p) c_pr and
 *   c_pr = sum_i S_ip s_r v_i / sum_i S_ip s_r^2.
 * Modes are orthogonal under S: momentum is that of v, angular momentum that of v and slopes, with
 * which alone this is APIC.
 *
 * Left open: how many modes. All 3^n lose nothing between grid and particles, but then light nodes
 * at free surfaces keep what they gain (ring, 16 cells: energy grew by .15 with cd, .85 with usl).
 * c_pr stays as it is while x moves and s_r with it. L, for F, is sum_i v_i dS_ip/dx (apic.c). */
#include "methods/parts/modes.h"
#include "methods/parts/shapes.h"
#include "methods/parts/transfers.h"

static void list(const Chunk *c, const Place *grid, const Field x[], NodeList *out)
{
    static const Field none = {0};
    Stencil s[DIM];
    for (int d = 0; d < DIM; d++) folded_shape(&grid->axis[d], 3, x[d], none, &s[d]);
    list_nodes(grid, s, out);
    list_modes(c, out);
}

static void update(const Chunk *c, const Field sums[], double dt, unsigned take)
{
    pic_update(c, sums, dt, take);
    if (take & TAKE_V) take_modes(c, sums);
}

static const char *const names[] = {MODE_NAMES, NULL};

const Method method_polypic = {
    .info = {.name = "polypic",
             .label = "PolyPIC",
             .about = "every particle carries a quadratic polynomial of the grid velocity",
             .source = "Fu et al. 2017",
             .formula = "m_i v_i = sum m_p S_ip sum_r s_r(x_i - x_p) c_pr; c_pr = sum S_ip s_r v_i "
                        "/ sum S_ip s_r^2",
             .on_request = true},
    .valid = 1u << CD | 1u << UVF | 1u << MUSL | 1u << USL | 1u << USF,
    .integrator = {[1] = CD, [2] = CD, [3] = CD},
    .keeps_L = true,
    .linear_exact = true,
    .pic = 1,
    .turns = true,
    .smooth = true,
    .width = spline_width,
    .list = list,
    .reach = reach_of_modes,
    .points = NODES,
    .modes = true,
    .own = names,
    .start = start_modes,
    .payload = mass_payload,
    .update = update,
};
