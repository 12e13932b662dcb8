/* w07_02_shapes.c: the trial functions of MPM and GIMP. Wallstedt and Guilkey (2007), fig. 2.
 *
 * S and G = dS/dx_p of the node at 0, for particles half a cell wide (half width l = h/4), sampled
 * at distances that are whole parts of h, so that sums over neighbouring nodes need no
 * interpolation. Both add up to 1 everywhere; the tent's gradient jumps at every node, that of GIMP
 * nowhere. */
#include <math.h>
#include "studies/tables/curves.h"

static const char *const methods[] = {"mpm", "gimp"};
enum { PARTS = 256, REACH = 3 * PARTS / 2, SAMPLES = 2 * REACH + 1 }; /* of h */
static const double half_width = 0.25;                                /* [h] */

static void tables(const Results *r)
{
    FILE *f = results_write(r, "", "method,r,S,G");
    for (int m = 0; m < 2; m++)
        for (int k = -REACH; k <= REACH; k++) {
            double S = NAN, G = NAN, x = k / (double)PARTS;
            engine_1d.weight(methods[m], x, half_width, &S, &G);
            results_print(f, "%s,%.17g,%.17g,%.17g\n", methods[m], x, S, G);
        }
}

/* Largest |sum over three nodes - 1| for particles within half a cell of the middle one. */
static Measure unity(const Curve *S)
{
    double worst = 0;
    for (int k = PARTS; k + PARTS < S->n; k++)
        worst = measure_worse(worst, fabs(S->y[k - PARTS] + S->y[k] + S->y[k + PARTS] - 1));
    return measure_with(curve_max(S, SAMPLES), worst);
}

/* Largest change between samples h/256 apart. */
static Measure jump(const Curve *G)
{
    double worst = 0;
    for (int k = 1; k < G->n; k++) worst = measure_worse(worst, fabs(G->y[k] - G->y[k - 1]));
    return measure_with(curve_max(G, SAMPLES), worst);
}

/* Most nodes that a particle contributes to, over its places within a cell. */
static Measure most_nodes(const Curve *S)
{
    double most = 0;
    for (int k = 0; k < PARTS; k++) {
        int n = 0;
        for (int at = k; at < S->n; at += PARTS) n += S->y[at] > 0;
        most = measure_worse(most, n);
    }
    return measure_with(curve_max(S, SAMPLES), most);
}

static void check(Check *c, const Results *r)
{
    Curve S[2], G[2];
    for (int m = 0; m < 2; m++) {
        curve_pick(&S[m], r->rows, "r", "S", "method=%s", methods[m]);
        curve_pick(&G[m], r->rows, "r", "G", "method=%s", methods[m]);
    }
    for (int m = 0; m < 2; m++)
        claim(
            c, phrase("W07-2.%s-unity", methods[m]),
            phrase("%s's trial functions add up to 1: largest departure", engine_label(methods[m])),
            unity(&S[m]), 0, 1e-15);
    for (int m = 0; m < 2; m++)
        claim(c, phrase("W07-2.%s-nodes", methods[m]),
              phrase("%s: largest number of nodes that a particle contributes to, 1D",
                     engine_label(methods[m])),
              most_nodes(&S[m]), 2 + m, 2 + m);
    claim(c, "W07-2.mpm-jump", "The tent's gradient jumps by 2/h at its node", jump(&G[0]), 1.999,
          2.001);
    claim(c, "W07-2.gimp-smooth",
          "GIMP is C1: between samples h/256 apart its gradient changes by no more than "
          "(h/256)/(l h)",
          jump(&G[1]), 0, 1.000001 / ((double)PARTS * half_width));
}

const StudyPage study_w07_02_shapes = {.tables = tables, .check = check, .claims = 6};
