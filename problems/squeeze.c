/* squeeze.c: projection of a known velocity field from particles to nodes (W07 sections 3 and 5.1).
 *
 * Any number of particles is squeezed into [0, 1]; each carries v(x_p) and the exact L, and the
 * error is that of the projected node velocities. The degenerate arrangements are those of W07
 * fig 3. */
#include <math.h>
#include <string.h>
#include "common/contract/layout.h"
#include "common/contract/problem.h"

enum { FIELD, ARRANGEMENT };
enum { FIELD_LINEAR, FIELD_QUADRATIC };
enum { EVEN, CENTRED, SHIFTED, UNEQUAL, CLUSTERED };

static const Param params[] = {{"field", FIELD_LINEAR, 0, 1, "", "v = 1 + x or v = (1 + x)^2",
                                "W07 section 3", "linear|quadratic"},
                               {"arrangement", EVEN, 0, 4, "",
                                "particles: evenly squeezed; or two per cell, centred, or in every "
                                "second cell shifted, of unequal mass, clustered",
                                "W07 figs 3, 4", "even|centred|shifted|unequal|clustered"},
                               {NULL, 0, 0, 0, NULL, NULL, NULL, NULL}};

static int init(Scene *s, char why[128])
{
    (void)why;
    s->mat = material_make(NEO_HOOKEAN, 1, 0, 1);
    for (int d = 0; d < DIM; d++) s->hi[d] = s->body_hi[d] = 1;
    s->c = 1;
    s->error_scale = 1;
    return 0;
}

/* Two particles in every cell, at `at` of its width, with the given shares of its mass: in every
 * second cell as asked for, centred in the others. An arrangement that repeats in every cell would
 * be exact for tents, whatever it is: a particle at the fraction a of the cell gives the nodes
 * beside it a (a - 1) + (1 - a) a = 0. */
static bool place(const Scene *s, double spacing, bool fitted, Layout *out)
{
    static const struct {
        double at[2], share[2];
    } cell[] = {[CENTRED] = {{0.25, 0.75}, {0.5, 0.5}},
                [SHIFTED] = {{0.10, 0.60}, {0.5, 0.5}},
                [UNEQUAL] = {{0.40, 0.90}, {0.8, 0.2}},
                [CLUSTERED] = {{0.75, 0.95}, {0.5, 0.5}}};
    const int kind = (int)s->par[ARRANGEMENT];
    (void)spacing;
    if (kind == EVEN || fitted) return false;
    const int cells = (int)lround(1 / s->cell);
    for (int k = 0; k < 2 * cells; k++) {
        const int c = k / 2 % 2 ? kind : CENTRED;
        Vec X = {(k / 2 + cell[c].at[k % 2]) * s->cell};
        layout_add(out, X, cell[c].share[k % 2] * s->cell, NULL);
    }
    return true;
}

static void exact(const Scene *s, int n, ConstFields X, double t, Fields v)
{
    const bool quadratic = (int)s->par[FIELD] == FIELD_QUADRATIC;
    (void)t;
    for (int p = 0; p < n; p++) v[0][p] = (1 + X[0][p]) * (quadratic ? 1 + X[0][p] : 1);
}

static void start(const Scene *s, int n, ConstFields X, Fields u, Fields v, Fields F, Fields L)
{
    const bool quadratic = (int)s->par[FIELD] == FIELD_QUADRATIC;
    (void)u, (void)F;
    exact(s, n, X, 0, v);
    for (int p = 0; p < n; p++) L[0][p] = quadratic ? 2 * (1 + X[0][p]) : 1;
}

const Problem problem_squeeze = {
    .info = {.name = "squeeze",
             .label = "squeeze test",
             .about = "projection of a linear or quadratic velocity field, no time",
             .source = "W07 sections 3, 5.1",
             .formula = "v = 1 + x or (1 + x)^2, projected to the nodes",
             .scale = "|v(x_i)| of each node",
             .params = params},
    .cells = 100,
    .ppc = 2,
    .projection = true,
    .init = init,
    .place = place,
    .start = start,
    .exact = exact,
};
