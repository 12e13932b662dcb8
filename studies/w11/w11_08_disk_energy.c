/* w11_08_disk_energy.c: kinetic, strain and total energy of the disk through two impacts, every
 * method. Wallstedt and Guilkey (2011), fig. 8. And a moving picture of one of them.
 *
 * The disk flies at 45 degrees: kinetic energy is halved when it is at rest against the floor at
 * t ~ .93; the energy after the rebound is taken at t = 2.3, before it meets the right wall. */
#include <math.h>
#include "studies/tables/bounce.h"
#include "studies/tables/curves.h"

enum { INSTANTS = 200 }; /* of a history, at least */
enum { FRAMES = 60, STEPS = 474 /* of the default run; frames are some of them */ };
static const char *const unilateral[] = {"wls", "wls2", "gimp"};

static void cases(Cases *list, bool quick)
{
    const int cells = quick ? 12 : 48;
    EACH_METHOD(m, &engine_2d)
        case_add_with(list, "history", m->name, "run disk_impact --method %s --cells %d", m->name,
                      cells);
    for (int k = 0; k < 3; k++)
        case_add_with(list, "history", phrase("%s_unilateral", unilateral[k]),
                      "run disk_impact --method %s --cells %d --set wall=unilateral", unilateral[k],
                      cells);
    for (int k = 0; k < FRAMES; k++)
        case_add_with(list, "particles", phrase("frame.%d", k),
                      "run disk_impact --method wls2 --cells %d --set steps=%d", cells,
                      1 + k * (STEPS - 1) / (FRAMES - 1) / (quick ? 4 : 1));
}

/* Which instant each frame shows: the runs that were to stop early, in their order. */
static void tables(const Results *r)
{
    FILE *f = results_write(r, "frames", "frame,t");
    const Table *rows = r->rows;
    int frame = 0;
    for (int row = 0; row < rows->nrow; row++)
        if (select_number(rows, row, "set.steps") > 0)
            results_print(f, "%d,%.17g\n", frame++,
                          select_number(rows, row, "steps") * select_number(rows, row, "dt"));
}

static Bounce bounce(const Results *r, const char *part)
{
    return bounce_read(results_run(r, "%s", part), (BounceNeeds){INSTANTS, INSTANTS, INSTANTS});
}

static void check_one(Check *c, const Results *r, const char *method, const char *label, double low,
                      double high)
{
    const Bounce b = bounce(r, method);
    claim(c, phrase("W11-8.half-%s", method),
          phrase("Disk, %s: kinetic energy falls by half: least of it over E0", label), b.least,
          0.46, 0.54);
    claim(c, phrase("W11-8.when-%s", method),
          phrase("Disk, %s: time of the least kinetic energy [s]", label),
          measure_with(b.least, b.at), 0.90, 0.96);
    claim(c, phrase("W11-8.back-%s", method),
          phrase("Disk, %s: total energy over E0 at t = 2.3, after the rebound", label),
          measure_with(b.over, b.back), low, high);
}

/* Momentum over its start where the kinetic energy is least, before t = 1.6. */
static Measure momentum_left(const Results *r, const char *part, const char *component)
{
    const Table *t = results_run(r, "%s", part);
    double least = INFINITY, left = NAN;
    Measure rows = measure_sum_of(INSTANTS);
    for (int k = 0; k < t->nrow; k++) {
        const double kinetic = select_number(t, k, "kinetic");
        measure_add(&rows, kinetic);
        if (select_number(t, k, "t") >= 1.6 || !(kinetic < least)) continue;
        least = kinetic;
        left = select_number(t, k, component) / select_number(t, 0, component);
    }
    return measure_with(rows, left);
}

static void check(Check *c, const Results *r)
{
    check_one(c, r, "wls", "WLS", 0.994, 1.006);
    check_one(c, r, "wls2", "WLS2", 0.994, 1.006);
    check_one(c, r, "gimp", "GIMP", 0.970, 1.006);
    claim(c, "W11-8.towards-wls",
          "Disk, WLS: the velocity towards the wall vanishes in the impact: its momentum over the "
          "start's when the kinetic energy is least",
          momentum_left(r, "wls", "py"), -0.15, 0.15);
    claim(c, "W11-8.along-wls",
          "Disk, WLS: the velocity along the wall stays: its momentum over the start's when the "
          "kinetic energy is least",
          momentum_left(r, "wls", "px"), 0.97, 1.03);
    claim(c, "W11-8.smooth-wls",
          "Disk, WLS: no jumps: largest change of the total energy in one step over E0",
          bounce(r, "wls").jump, 0, 0.003);
    claim(c, "W11-8.smooth-gimp",
          "Disk, GIMP: no jumps: largest change of the total energy in one step over E0",
          bounce(r, "gimp").jump, 0, 0.003);
    claim(
        c, "W11-8.unilateral",
        "Disk: a unilateral wall halves WLS's overshoot of energy: ratio of largest total less E0",
        measure_ratio(bounce(r, "wls_unilateral").over, bounce(r, "wls").over), 0, 0.65);
    EACH_METHOD(m, &engine_2d) {
        const Bounce b = bounce(r, m->name);
        claim_note(c, phrase("back_%s", m->name), b.back);
        claim_note(c, phrase("start_%s", m->name), b.start);
    }
}

const StudyPage study_w11_08_disk_energy = {
    .cases = cases, .tables = tables, .check = check, .claims = 14};
