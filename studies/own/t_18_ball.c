/* t_18_ball.c: energy of a ball through its impact on the floor: W11 fig. 8 in three dimensions. It
 * flies at 45 degrees: kinetic energy is halved when the ball is at rest against the floor; the
 * energy after the rebound is taken at t = 2.3, before it meets the right wall. */
#include "studies/tables/bounce.h"
#include "studies/tables/curves.h"

enum { INSTANTS = 100 /* of a history, at least */, CELLS = 24, METHODS = 5 };
static const char *const methods[METHODS] = {"gimp", "wls", "wls2", "ge_wls", "fem"};

static void cases(Cases *list, bool quick)
{
    const int cells = quick ? 12 : CELLS;
    for (int m = 0; m < METHODS; m++)
        case_add_with(list, "history", methods[m], "run ball_impact --method %s --cells %d",
                      methods[m], cells);
    case_add_with(list, "history", "wls_unilateral",
                  "run ball_impact --method wls --cells %d --set wall=unilateral", cells);
}

static Bounce bounce(const Results *r, const char *part)
{
    return bounce_read(results_run(r, "%s", part),
                       (BounceNeeds){INSTANTS / 3, INSTANTS / 2, INSTANTS});
}

/* By how many cells the particle methods stop before FEM does: time from the latest least kinetic
 * energy of theirs to that of FEM, times the ball's speed over h. */
static Measure early(const Results *r)
{
    const Bounce mesh = bounce(r, "fem");
    Measure latest = measure_max_of(0);
    for (int m = 0; m < METHODS - 1; m++) {
        const Bounce b = bounce(r, methods[m]);
        latest = measure_max(latest, measure_with(b.least, b.at));
    }
    return measure_with(measure_sum(latest, mesh.least),
                        (mesh.at - latest.value) * 0.2 * (double)CELLS);
}

static void check(Check *c, const Results *r)
{
    static const struct {
        const char *method, *label;
        double least, most, low, high;
    } known[METHODS] = {{"gimp", "GIMP", 0.5, 0.52, 0.953, 0.973},
                        {"wls", "WLS", 0.508, 0.528, 1.02, 1.045},
                        {"wls2", "WLS2", 0.509, 0.529, 1.01, 1.034},
                        {"ge_wls", "GE-WLS", 0.504, 0.524, 0.98, 0.996},
                        {"fem", "FEM", 0.5, 0.52, 0.988, 0.998}};
    for (int m = 0; m < METHODS; m++) {
        const Bounce b = bounce(r, known[m].method);
        claim(c, phrase("T-18c.half-%s", known[m].method),
              phrase("Ball, %s: kinetic energy falls by half: least of it over E0", known[m].label),
              b.least, known[m].least, known[m].most);
        claim(
            c, phrase("T-18c.back-%s", known[m].method),
            phrase("Ball, %s: total energy over E0 at t = 2.3, after the rebound", known[m].label),
            measure_with(b.over, b.back), known[m].low, known[m].high);
        claim_note(c, phrase("back_%s", known[m].method), b.back);
    }
    claim(c, "T-18c.over-wls", "Ball, WLS: largest total energy before t = 2.3 over E0, less 1",
          bounce(r, "wls").over, 0.045, 0.07);
    claim_differs(c, "T-18c.smooth-wls",
                  "Ball, WLS: no jumps, as of the disk: largest change of the total energy in one "
                  "step over E0",
                  bounce(r, "wls").jump, 0, 0.003, 0.003, 0.007,
                  ".0047 at N = 24; GE-WLS stays below .003");
    claim(c, "T-18c.smooth-ge_wls",
          "Ball, GE-WLS: no jumps: largest change of the total energy in one step over E0",
          bounce(r, "ge_wls").jump, 0, 0.003);
    claim(c, "T-18c.unilateral",
          "Ball: a unilateral wall halves WLS's overshoot of energy: ratio of largest total less "
          "E0",
          measure_ratio(bounce(r, "wls_unilateral").over, bounce(r, "wls").over), 0, 0.65);
    claim(c, "T-18c.early",
          "Ball: on a grid it meets the floor half a cell early: time of the least kinetic energy, "
          "FEM's less the latest of the others, times the speed over h",
          early(r), 0.3, 0.7);
}

const StudyPage study_t_18_ball = {.cases = cases, .check = check, .claims = 5 + 2 * METHODS};
