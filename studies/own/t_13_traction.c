/* t_13_traction.c: surface tractions (W11 eq 3): the oscillating ring free of traction as in the
 * paper, and with other coefficients, so that both radii bear a known traction; and a bar pulled at
 * its end. Every method and FEM; largest error over all particles and steps. N cells over the outer
 * radius. */
#include <string.h>
#include "studies/runs/engines.h"
#include "studies/tables/curves.h"

static const int cells[] = {8, 16, 32, 64}, bar_cells[] = {20, 40, 80};
enum { MESHES = 4, BAR_MESHES = 3 };

/* N = 64 is for the methods whose order is judged. */
static int meshes_of(const char *method)
{
    static const char *const judged[] = {"wls2", "fem"};
    for (int k = 0; k < 2; k++)
        if (strcmp(method, judged[k]) == 0) return MESHES;
    return MESHES - 1;
}

static void cases(Cases *list, bool quick)
{
    for (const Info *const *m = engine_2d.methods; *m; m++) {
        const char *method = (*m)->name;
        for (int traction = 0; traction < 2; traction++)
            for (int k = 0; k < (quick ? 1 : meshes_of(method)); k++)
                case_add(list, "run ring --method %s --cells %d --set traction=%d", method,
                         cells[k], traction);
    }
    for (const Info *const *m = engine_1d.methods; *m; m++)
        for (int k = 0; k < (quick ? 1 : BAR_MESHES); k++)
            case_add(list, "run pulled_bar --set dim=1 --method %s --cells %d", (*m)->name,
                     bar_cells[k]);
}

static Curve ring_errors(const Table *t, const char *method, int traction)
{
    Curve c;
    curve_pick(&c, t, "cells", "error_linf", "problem=ring method=%s traction=%d", method,
               traction);
    return c;
}

static Curve bar_errors(const Table *t, const char *method)
{
    Curve c;
    curve_pick(&c, t, "cells", "error_linf", "problem=pulled_bar method=%s", method);
    return c;
}

static Measure ring_order(const Table *t, const char *method, int traction)
{
    const Curve c = ring_errors(t, method, traction);
    const int meshes = meshes_of(method);
    return measure_times(curve_order(&c, cells[0], cells[meshes - 1], meshes), -1);
}

static Measure ring_ratio(const Table *t, const char *method)
{
    const Curve with = ring_errors(t, method, 1), without = ring_errors(t, method, 0);
    return measure_ratio(curve_at(&with, 32), curve_at(&without, 32));
}

static void check_bar(Check *c, const Table *t)
{
    static const struct {
        const char *method, *label;
    } judged[] = {{"gimp", "GIMP"}, {"ge_gimp", "GE-GIMP"}, {"wls2", "WLS2"}, {"ge_wls", "GE-WLS"}};
    for (size_t m = 0; m < sizeof judged / sizeof *judged; m++) {
        const Curve e = bar_errors(t, judged[m].method);
        claim(c, phrase("T-13.bar-%s", judged[m].method),
              phrase("%s: largest error of the pulled bar at h = 1/80 over its final elongation",
                     judged[m].label),
              curve_at(&e, 80), 0, 2e-3);
    }
    const Curve gimp = bar_errors(t, "gimp");
    claim(c, "T-13.bar-order", "GIMP is of first order or better on the pulled bar",
          measure_times(curve_order(&gimp, 20, 80, BAR_MESHES), -1), 1, 2);
}

static void check(Check *c, const Results *r)
{
    const Table *t = r->rows;
    claim(c, "T-13.wls2-order", "WLS2 is of second order on the ring under traction, N = 8 to 64",
          ring_order(t, "wls2", 1), 1.8, 2.3);
    claim(c, "T-13.fem-order", "FEM is of second order on the ring under traction, N = 8 to 64",
          ring_order(t, "fem", 1), 1.9, 2.1);
    claim(c, "T-13.wls2-ratio", "WLS2: largest error at N = 32 with traction over that without",
          ring_ratio(t, "wls2"), 0.5, 2);
    claim(c, "T-13.fem-ratio", "FEM: largest error at N = 32 with traction over that without",
          ring_ratio(t, "fem"), 0.5, 2);
    claim(c, "T-13.gimp-ratio",
          "GIMP on lattice particles: largest error at N = 32 with traction over that without",
          ring_ratio(t, "gimp"), 1, 3);
    check_bar(c, t);
    for (const Info *const *m = engine_2d.methods; *m; m++)
        for (int traction = 0; traction < 2; traction++)
            claim_note(c, phrase("%s_%s", traction ? "loaded" : "free", (*m)->name),
                       ring_order(t, (*m)->name, traction).value);
}

const Study study_t_13_traction = {
    .name = "t_13_traction",
    .figure = "T-13",
    .about = "ring with and without traction on its surface, and a bar pulled at its end",
    .cases = cases,
    .check = check,
    .claims = 10,
};
