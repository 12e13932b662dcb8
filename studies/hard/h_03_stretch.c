/* h_03_stretch.c: hard case H-3: numerical fracture. A block is pulled apart along x, evenly and to
 * four times its length, by velocities that are imposed: v = rate x.
 *
 * Then F grows to (1 + rate dt)^k if the grid's gradient is right. It is zero where particles are
 * so far apart that each node receives contributions from one particle only: F and stress stop
 * growing, as if the block had broken. The mean of F is the block's volume over the initial one;
 * stress follows from the law of the bar, sigma ~ F - 1/F, and counts as lost at the first stretch,
 * from 1.2 on, at which it is wrong by a tenth.
 *
 * A method may have the right strain in particles that share no node any more. Therefore a second
 * set of runs starts from the fully stretched bar in equilibrium, where nodal forces inside must
 * vanish (as in h_01_translation.c). A force of sigma A F/n, the full contribution of one particle,
 * means that this particle shares no node with its neighbours. */
#include <math.h>
#include <string.h>
#include "studies/runs/run_args.h"
#include "studies/tables/grades.h"

enum { KINDS = 3, VARIANTS = 2, EVERY = 4 };
#define RATE  0.5 /* [c/m] */
#define MOST  4.0 /* stretch */
#define WRONG 0.1

static const struct {
    const char *name;
    const Engine *engine;
    int cells, ppc, per_axis;
} kinds[KINDS] = {{"bar1", &engine_1d, 40, 1, 1},
                  {"bar2", &engine_1d, 40, 2, 2},
                  {"plane", &engine_2d, 16, 4, 2}};
static const struct {
    const char *name, *setting;
} variants[VARIANTS] = {{"usual", ""}, {"undeformed", " --set domain=undeformed"}};

static const char *part_name(const char *method, int kind, int variant)
{
    return phrase("%s.%s.%s", method, kinds[kind].name, variants[variant].name);
}

static const char *force_name(const char *method, int kind)
{
    return phrase("%s.%s.force", method, kinds[kind].name);
}

/* After a step from rest the nodes of a stretched bar have v = f/m dt. */
static void add_forces(Cases *list, const char *method, int kind)
{
    case_add_with(list, "nodes", force_name(method, kind),
                  "run block --method %s --cells %d --ppc %d --integrator usl --set dim=1 --set "
                  "stretch=%g --set box=6 --set offset_x=0.3 --set steps=1 --set allow_unstable=1",
                  method, kinds[kind].cells, kinds[kind].ppc, MOST);
}

static void cases(Cases *list, bool quick)
{
    for (int k = quick ? 1 : 0; k < (quick ? 2 : KINDS); k++)
        EACH_METHOD(m, kinds[k].engine)
            for (int v = 0; v < VARIANTS; v++) {
                const double dt = BLOCK_CFL / (kinds[k].cells * BLOCK_SPEED);
                const double growth = log(1 + RATE * BLOCK_SPEED * dt);
                const char *text =
                    phrase("run block --method %s --cells %d --ppc %d --set dim=%d --set rate=%g "
                           "--set box=6 --t-end %.17g%s",
                           m->name, kinds[k].cells, kinds[k].ppc, kinds[k].engine->dim, RATE,
                           ceil(log(MOST) / growth) * dt, variants[v].setting);
                if (v > 0 &&
                    (!engine_has_grid(kinds[k].engine, m->name) || !run_args_is_run("%s", text)))
                    continue;
                case_add_with(list, "history", part_name(m->name, k, v), "%s", text);
                if (v == 0 && kinds[k].engine->dim == 1) add_forces(list, m->name, k);
            }
}

/* Largest force in the inner half of the bar over sigma A, A = 1 and E = 1e4; NAN if there is none.
 * Forces are those before the step, so that a run that is lost in it (status) has them, too. */
static double force_inside(const Results *r, const char *method, int kind, const char **status)
{
    const double dt = BLOCK_CFL / (kinds[kind].cells * BLOCK_SPEED);
    const double stress = 0.5e4 * (MOST - 1 / MOST);
    *status = results_status(r, force_name(method, kind));
    const Table *t = results_ended(r, "%s", force_name(method, kind));
    double most = -INFINITY;
    for (int k = 0; strcmp(*status, "absent") && k < t->nrow; k++) {
        const double f = select_number(t, k, "mass") * select_number(t, k, "vx") / (dt * stress);
        if (fabs(select_number(t, k, "x") - 3) < MOST / 4) most = measure_worse(most, fabs(f));
    }
    return isinf(most) ? NAN : most;
}

static double law(double F)
{
    return F - 1 / F;
}

/* One run: its curve, and where it went wrong. */
static void write_one(FILE *curve, FILE *onset, const Table *t, const char *head,
                      const char *status, double force, const char *force_status)
{
    const double dt = select_number(t, 1, "t"), V0 = select_number(t, 0, "volume");
    double lost = NAN, F = 1, ratio = 1;
    for (int k = 1; k < t->nrow; k++) {
        F = pow(1 + RATE * BLOCK_SPEED * dt, k);
        ratio = law(select_number(t, k, "volume") / V0) / law(F);
        if (isnan(lost) && F > 1.2 && !(fabs(ratio - 1) <= WRONG)) lost = F;
        if (k % EVERY == 0 || k + 1 == t->nrow) fprintf(curve, "%s,%.6g,%.10g\n", head, F, ratio);
    }
    fprintf(onset, "%s,%.6g,", head, F);
    if (!isnan(lost)) fprintf(onset, "%.6g", lost);
    fprintf(onset, ",%.10g,", fabs(ratio - 1));
    if (!isnan(force)) fprintf(onset, "%.10g", force);
    fprintf(onset, ",%s,%s\n", status, force_status);
}

static void write_all(FILE *curve, FILE *onset, const Results *r)
{
    for (int k = 0; k < KINDS; k++)
        EACH_METHOD(m, kinds[k].engine)
            for (int v = 0; v < VARIANTS; v++) {
                const char *part = part_name(m->name, k, v);
                const Table *t = results_ended(r, "%s", part);
                const char *status = "absent";
                const double force = v ? NAN : force_inside(r, m->name, k, &status);
                if (t->nrow > 1)
                    write_one(curve, onset, t,
                              phrase("%s,%s,%s", kinds[k].name, m->name, variants[v].name),
                              results_status(r, part), force, status);
            }
}

static void write_marks(FILE *f, const Table *t)
{
    EACH_METHOD(m, &engine_2d) {
        const double force = fmax(select_ended(t, "force", "method=%s kind=bar1", m->name).value,
                                  select_ended(t, "force", "method=%s kind=bar2", m->name).value);
        double first = INFINITY;
        int ran = 0;
        for (int k = 0; k < KINDS; k++) {
            const char *where = "method=%s kind=%s variant=usual";
            const double at = select_ended(t, "onset", where, m->name, kinds[k].name).value;
            const double end = select_ended(t, "reached", where, m->name, kinds[k].name).value;
            ran += !isnan(end);
            if (end < 0.99 * MOST) first = fmin(first, end);
            if (at < first) first = at;
        }
        if (ran == 0) continue; /* in a quick run */
        grade_add(f, "H-3", m->name,
                  !isinf(first)   ? MARK_LOST
                  : force > WRONG ? MARK_WEAK
                                  : MARK_OK,
                  !isinf(first) ? "stress lost at a stretch of %.2g (worst of three)"
                  : force > WRONG
                      ? "stress is known to four times the length, but not carried: forces "
                        "up to %.2g of sigma A inside"
                      : "carries stress to four times its length",
                  isinf(first) ? force : first);
    }
}

static void tables(const Results *r)
{
    FILE *curve = results_write(r, "curves", "kind,method,variant,stretch,ratio");
    FILE *onset = results_write(
        r, "onset", "kind,method,variant,reached,onset,error,force,status,force_status");
    write_all(curve, onset, r);
    write_marks(grades_write(r), results_part(r, "onset"));
}

static Measure onset(const Table *t, const char *method, int kind, const char *variant)
{
    return select_value(t, "onset", "method=%s kind=%s variant=%s", method, kinds[kind].name,
                        variant);
}

/* Distance from a particle [cells] at which its weight, a quadratic spline's, is the trigger
 * weight: (3/2 - d)^2/2 = TW. */
static double good_within(const char *method)
{
    const Param *trigger = info_param_find(engine_method(method)->params, "trigger");
    return trigger->value < 0.5 ? 1.5 - sqrt(2 * trigger->value) : NAN;
}

static void check_wls(Check *c, const Table *t)
{
    const Measure wls2 = onset(t, "wls2", 0, "usual");
    const double d = good_within("wls2");
    claim(c, "H-3.wls",
          "Stretched bar: WLS keeps the stress until no particle is within its trigger weight: "
          "stretch at which stress is lost, over the stretch so predicted",
          measure_times(onset(t, "wls", 0, "usual"), 1 / (2 * good_within("wls"))), 0.9, 1.3);
    claim_differs(
        c, "H-3.wls2",
        "Stretched bar: WLS2 keeps the stress until no particle is within its larger trigger "
        "weight: stretch at which stress is lost, over the stretch so predicted",
        measure_times(wls2, 1 / (2 * d)), 0.9, 1.3, 1.3, 1.6,
        "lost at a stretch of 2.35, not 1.59: it extrapolates to nodes without particles, and so "
        "goes on until its good nodes see one particle only, at 3/2 + d = 2.29");
    claim(c, "H-3.wls2-alone",
          "Stretched bar: WLS2 loses the stress where its good nodes see one particle only: "
          "stretch over 3/2 + d, d cells from a particle its weight is the trigger weight",
          measure_times(wls2, 1 / (1.5 + d)), 0.9, 1.1);
}

static void check(Check *c, const Results *r)
{
    const Table *t = results_part(r, "onset");
    claim(
        c, "H-3.tent-1",
        "Stretched bar, tents, one particle per cell: stress is lost at a stretch between 1 and 2",
        onset(t, "mpm", 0, "usual"), 1, 2);
    claim(
        c, "H-3.tent-2",
        "Stretched bar, tents, two particles per cell: stress is lost at a stretch between 2 and 4",
        onset(t, "mpm", 1, "usual"), 2, 4);
    claim(c, "H-3.tent-plane",
          "Stretched plate, tents, two particles per axis: stress is lost at a stretch between 2 "
          "and 4",
          onset(t, "mpm", 2, "usual"), 2, 4);
    claim(c, "H-3.gimp",
          "Stretched bodies: GIMP with exactly convolved boxes that follow F carries stress to a "
          "stretch of 4: relative error of stress there, worst of three bodies",
          curve_worst(t, "gimp", KINDS, "error", "variant=usual"), 0, WRONG);
    claim(c, "H-3.ugimp",
          "Stretched bar: GIMP with boxes that keep their size loses stress later than tents: its "
          "stretch there over MPM's",
          measure_ratio(onset(t, "gimp", 0, "undeformed"), onset(t, "mpm", 0, "usual")), 1, 2);
    claim(c, "H-3.carried",
          "Stretched bodies: GE-MPM, GE-GIMP, APIC, TPIC, whose particles give the grid their "
          "gradients, keep the stress: largest relative error at a stretch of 4",
          curve_worst(t, "ge_mpm ge_gimp apic tpic", KINDS, "error", "variant=usual"), 0, WRONG);
    /* The force is of a run of its own: the status of the stretched one does not matter. */
    claim(c, "H-3.pieces",
          "Tents leave the stretched bar in pieces even with gradients: force inside at a stretch "
          "of 4 over sigma A F/n, n = 1",
          measure_times(select_ended(t, "force", "method=ge_mpm kind=bar1"), 1 / MOST), 0.99, 1.01);
    claim(c, "H-3.gimp-carries",
          "GIMP and GE-GIMP transmit the force of the bar stretched to 4: largest unbalanced force "
          "inside over sigma A",
          curve_worst(t, "gimp ge_gimp", 1, "force", "kind=bar1 variant=usual force_status=ok"), 0,
          WRONG);
    check_wls(c, t);
}

const StudyPage study_h_03_stretch = {
    .cases = cases, .tables = tables, .check = check, .claims = 11};
