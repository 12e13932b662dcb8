/* flip_pic.c: blend of the FLIP and the PIC update (Zhu & Bridson 2005; Stomakhin et al. 2013):
 *   v_p = alpha (v_p + dt sum_i S_ip a_i) + (1 - alpha) sum_i S_ip v_i,  v_i accelerated by a_i.
 * alpha = 1 is FLIP (gimp), 0 is PIC. Momentum is conserved for every alpha. Velocities in the null
 * space of the projection are multiplied by alpha in each step. */
#include "methods/parts/shapes.h"
#include "methods/parts/transfers.h"

static void update(const Chunk *c, const Field sums[], double dt, unsigned take)
{
    const double alpha = c->par[0];
    for (int a = 0; take & TAKE_V && a < DIM; a++)
        for (int p = 0; p < CHUNK; p++)
            c->v[a][p] = alpha * (c->v[a][p] + dt * sums[DIM + a][p]) + (1 - alpha) * sums[a][p];
    flip_update(c, sums, dt, take & ~(unsigned)TAKE_V);
}

static void adapt(const double par[], Method *own)
{
    own->pic = 1 - par[0];
}

static const Param params[] = {{"alpha", 0.99, 0, 1, "", "1: FLIP; 0: PIC", "", NULL},
                               {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

const Method method_flip_pic = {
    .info = {.name = "flip_pic",
             .label = "FLIP/PIC",
             .about = "GIMP with a blend of the FLIP and the PIC update",
             .formula = "v_p = alpha (v_p + dt sum S_ip a_i) + (1 - alpha) sum S_ip v_i",
             .source = "Zhu & Bridson 2005; Stomakhin et al. 2013",
             .params = params},
    .valid = 1u << CD | 1u << UVF | 1u << MUSL | 1u << USL | 1u << USF,
    .integrator = {[1] = CD, [2] = CD, [3] = CD},
    .smooth = true,
    .width = gimp_width,
    .shape = gimp_shape,
    .payload = mass_payload,
    .update = update,
    .adapt = adapt,
};
