/* t_13_traction.c: surface tractions (W11 eq 3): the oscillating ring free of traction as in the
 * paper, and with other coefficients, so that both radii bear a known traction; and a bar pulled at
 * its end. Every method and FEM; largest error over all particles and steps. N cells over the outer
 * radius. */
#include "studies/tables/curves.h"

static const int cells[] = {8, 16, 32, 64}, bar_cells[] = {20, 40, 80};
enum { MESHES = 4, BAR_MESHES = 3 };

/* N = 64 is for the methods whose order is judged. */
static int meshes_of(const char *method)
{
    return select_is_word("wls2 fem", method) ? MESHES : MESHES - 1;
}

static void cases(Cases *list, bool quick)
{
    EACH_METHOD(m, &engine_2d) {
        const char *method = m->name;
        for (int traction = 0; traction < 2; traction++)
            for (int k = 0; k < (quick ? 1 : meshes_of(method)); k++)
                case_add(list, "run ring --method %s --cells %d --set traction=%d", method,
                         cells[k], traction);
    }
    EACH_METHOD(m, &engine_1d)
        for (int k = 0; k < (quick ? 1 : BAR_MESHES); k++)
            case_add(list, "run pulled_bar --set dim=1 --method %s --cells %d", m->name,
                     bar_cells[k]);
}

static Measure ring_order(const Table *t, const char *method, int traction)
{
    const int meshes = meshes_of(method);
    return curve_order_in_h(t, "error_linf", cells[0], cells[meshes - 1], meshes,
                            "problem=ring method=%s traction=%d", method, traction);
}

static Measure ring_ratio(const Table *t, const char *method)
{
    static const char where[] = "problem=ring method=%s cells=32 traction=%d";
    return measure_ratio(select_value(t, "error_linf", where, method, 1),
                         select_value(t, "error_linf", where, method, 0));
}

static void check_bar(Check *c, const Table *t)
{
    EACH_WORD(m, "gimp ge_gimp wls2 ge_wls")
        claim(c, phrase("T-13.bar-%s", m),
              phrase("%s: largest error of the pulled bar at h = 1/80 over its final elongation",
                     engine_label(m)),
              select_value(t, "error_linf", "problem=pulled_bar method=%s cells=80", m), 0, 2e-3);
    claim(c, "T-13.bar-order", "GIMP is of first order or better on the pulled bar",
          curve_order_in_h(t, "error_linf", 20, 80, BAR_MESHES, "problem=pulled_bar method=gimp"),
          1, 2);
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
    EACH_METHOD(m, &engine_2d)
        for (int traction = 0; traction < 2; traction++)
            claim_note(c, phrase("%s_%s", traction ? "loaded" : "free", m->name),
                       ring_order(t, m->name, traction).value);
}

const StudyPage study_t_13_traction = {.cases = cases, .check = check, .claims = 10};
