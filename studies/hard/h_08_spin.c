/* h_08_spin.c: hard cases H-8a and H-8b: large rotation.
 *
 * (a) Ten turns of v = w x r, imposed, without stress. F += dt L F takes F to (I + dt W) F, whose
 * determinant grows by 1 + (w dt)^2 per step: J = exp(2 pi w dt) per turn; so does the area that
 * the particles' positions enclose. At a quarter turn the half width l0 |F_xx| of boxes vanishes.
 *
 * (b) Ten turns of a free elastic block, by each method's usual scheme. Angular momentum is that
 * of the particles' motion about the centre of mass, without what APIC and TPIC keep in L. */
#include <math.h>
#include "studies/runs/run_args.h"
#include "studies/tables/grades.h"

enum { CELLS = 16, TURNS = 10, METHODS = 12 /* that finish the imposed spin */ };
enum { USUAL, STRETCH, EXPONENTIAL, SUBCYCLED, VARIANTS };
#define SPIN       1.0                                /* (a): w [c/m] */
#define PER_STEP   (SPIN * BLOCK_CFL / (double)CELLS) /* (a): w dt */
#define BLOCK_TURN (2 * M_PI / (SPIN * BLOCK_SPEED))  /* (a) [s] */

static const struct {
    const char *name, *domain, *update;
} variants[VARIANTS] = {{"usual", "fxx", "linear"},
                        {"stretch", "stretch", "linear"},
                        {"exponential", "fxx", "exponential"},
                        {"subcycled", "fxx", "subcycled"}};

enum { SPIN_SCENE, QUARTER, FREE, SCENES };
static const struct {
    const char *name, *problem, *settings;
    double turn, turns; /* [s] and how many */
} scenes[SCENES] = {
    {"spin", "block", "--set dim=2 --set box=4 --set spin=1", BLOCK_TURN, TURNS},
    {"quarter", "block", "--set dim=2 --set box=4 --set spin=1", BLOCK_TURN, 0.25},
    {"free", "free_block", "--set dim=2 --set box=2 --set swing=0 --set drift=0", FREE_TURN, TURNS},
};

static const char *part_name(int scene, const char *method, int variant)
{
    return phrase("%s.%s.%s", scenes[scene].name, method, variants[variant].name);
}

/* The option that a variant sets; the usual one sets none. */
static const char *option_of(int variant)
{
    return variant == STRETCH ? phrase("domain=%s", variants[variant].domain)
                              : phrase("strain_update=%s", variants[variant].update);
}

static void add(Cases *list, int scene, const char *method, int variant, bool quick)
{
    const double turns = quick ? fmin(scenes[scene].turns, 0.5) : scenes[scene].turns;
    const char *text =
        phrase("run %s --method %s --cells %d --t-end %.17g %s%s%s", scenes[scene].problem, method,
               CELLS, turns * scenes[scene].turn, scenes[scene].settings, variant ? " --set " : "",
               variant ? option_of(variant) : "");
    if (scene == FREE && variant == SUBCYCLED)
        return; /* its result lies between the usual and the exponential */
    if (variant > 0 && !(engine_has_grid(&engine_2d, method) && run_args_is_run("%s", text)))
        return;
    case_add_with(list, "particles", part_name(scene, method, variant), "%s", text);
}

static void cases(Cases *list, bool quick)
{
    EACH_METHOD(m, &engine_2d)
        for (int s = 0; s < SCENES; s++)
            for (int v = 0; v < (s == QUARTER ? 1 : VARIANTS); v++) add(list, s, m->name, v, quick);
}

/* What a file of particles says: means over volume, angular momentum then and now. */
typedef struct State {
    int n;
    double J, least, most, narrowest, before, now;
} State;

static State state_read(const Results *r, const char *part)
{
    State s = {.least = INFINITY, .most = -INFINITY, .narrowest = INFINITY};
    double mass = 0, x = 0, y = 0, px = 0, py = 0;
    const Table *t = results_ended(r, "%s", part);
    for (int k = 0; k < t->nrow; k++) {
        const double m = select_number(t, k, "mass"), Fxx = select_number(t, k, "Fxx");
        const double J = Fxx * select_number(t, k, "Fyy") -
                         select_number(t, k, "Fxy") * select_number(t, k, "Fyx");
        const double X = select_number(t, k, "X"), Y = select_number(t, k, "Y");
        const double at[] = {select_number(t, k, "x"), select_number(t, k, "y")};
        const double v[] = {select_number(t, k, "vx"), select_number(t, k, "vy")};
        if (!(m > 0)) continue;
        s.n++;
        s.J += m * J;
        s.least = measure_lesser(s.least, J), s.most = measure_worse(s.most, J);
        s.narrowest = measure_lesser(s.narrowest, fabs(Fxx));
        s.before += m * ((X - 1) * (X - 1) + (Y - 1) * (Y - 1)); /* times w: box = 2 */
        s.now += m * (at[0] * v[1] - at[1] * v[0]);
        mass += m;
        x += m * at[0], y += m * at[1], px += m * v[0], py += m * v[1];
    }
    s.J /= mass;
    s.now -= (x * py - y * px) / mass;
    return s;
}

/* Writes one line per run. growth: that of J per turn over exp(2 pi w dt); loss: that of angular
 * momentum per turn. */
static void write_one(FILE *f, const Results *r, int row, int scene, int variant)
{
    const Table *rows = r->rows;
    const char *method = select_text(rows, row, "method");
    const double steps = select_number(rows, row, "steps"), dt = select_number(rows, row, "dt");
    const double turns = steps * dt / scenes[scene].turn, w = 2 * M_PI / FREE_TURN;
    const State s = state_read(r, part_name(scene, method, variant));
    if (s.n == 0) return;
    fprintf(f, "%s,%s,%s,%s,%.6g,%.10g,%.10g,%.10g,%.10g,", scenes[scene].name, method,
            variants[variant].name,
            select_is_lost(rows, row) ? select_text(rows, row, "status") : "ok", turns, s.J,
            s.least, s.most, s.narrowest);
    if (scene == FREE)
        fprintf(f, ",%.10g\n", 1 - pow(measure_worse(s.now / (w * s.before), 0), 1 / turns));
    else
        fprintf(f, "%.10g,\n", pow(s.J, 1 / turns) / exp(2 * M_PI * PER_STEP));
}

/* Grade in one scene. Weak: J is off by the growth of the update rule, or angular momentum by a
 * hundredth per turn. */
static Mark mark_of(const Table *t, int scene, const char *method, const char *variant)
{
    static const char *const where = "method=%s scene=%s variant=%s status=ok";
    const char *name = scenes[scene].name;
    if (!select_value(t, "turns", where, method, name, variant).rows) return MARK_LOST;
    const char *column = scene == FREE ? "loss" : "J";
    const double x = select_value(t, column, where, method, name, variant).value;
    return scene == FREE ? grade_mark_of(fabs(x), 0.002, 1)
                         : grade_mark_of(fabs(x - 1), 0.01, INFINITY);
}

/* Angular momentum lost a turn as usual and with this variant. */
static const char *loss_note(const Table *t, const char *method, const char *variant)
{
    static const char *const where = "method=%s scene=free variant=%s";
    const double usual = fabs(select_value(t, "loss", where, method, "usual").value);
    const double loss = fabs(select_value(t, "loss", where, method, variant).value);
    if (isnan(loss)) return "lost";
    if (isnan(usual)) return phrase("lost -> %.2g of it lost a turn", loss);
    return phrase("%.2g -> %.2g of it lost a turn", usual, loss);
}

static void write_marks(FILE *f, FILE *g, const Table *t)
{
    EACH_METHOD(m, &engine_2d) {
        const char *method = m->name;
        const double turned =
            select_ended(t, "turns", "method=%s scene=free variant=usual", method).value;
        const Mark spin = mark_of(t, SPIN_SCENE, method, "usual"),
                   motion = mark_of(t, FREE, method, "usual");
        if (isnan(turned)) continue;
        grade_add(f, "H-8a", method, spin, "area %.3g times the right one after %d imposed turns",
                  select_ended(t, "J", "method=%s scene=spin variant=usual", method).value, TURNS);
        if (motion == MARK_LOST)
            grade_add(f, "H-8b", method, motion, "lost after %.2g turns", turned);
        else
            grade_add(
                f, "H-8b", method, motion, "angular momentum changes by %.2g %% a turn",
                -100 * select_value(t, "loss", "method=%s scene=free variant=usual", method).value);
        for (int v = 1; v < VARIANTS; v++) {
            const char *option = option_of(v);
            const char *where = "method=%s scene=%s variant=%s";
            if (select_ended(t, "turns", where, method, "spin", variants[v].name).rows)
                grade_remedy_add(g, "H-8a", method, option, spin,
                                 mark_of(t, SPIN_SCENE, method, variants[v].name), "");
            if (select_ended(t, "turns", where, method, "free", variants[v].name).rows)
                grade_remedy_add(g, "H-8b", method, option, motion,
                                 mark_of(t, FREE, method, variants[v].name),
                                 loss_note(t, method, variants[v].name));
        }
    }
}

/* The scene of a row: durations tell whole turns from a quarter, with --quick half a turn. */
static int scene_of(const Table *rows, int row)
{
    const bool whole = select_number(rows, row, "t_end") > scenes[SPIN_SCENE].turn * 0.4;
    if (select_is(rows, row, "problem", scenes[FREE].problem)) return FREE;
    return whole ? SPIN_SCENE : QUARTER;
}

static void write_turns(FILE *f, const Results *r)
{
    for (int row = 0; row < r->rows->nrow; row++)
        for (int v = 0; v < VARIANTS; v++) {
            const char *domain = variants[v].domain, *update = variants[v].update;
            if (select_meets(r->rows, row, "domain=%s strain_update=%s", domain, update))
                write_one(f, r, row, scene_of(r->rows, row), v);
        }
}

static void tables(const Results *r)
{
    write_turns(results_write(r, "turns",
                              "scene,method,variant,status,turns,J,least,most,narrowest,growth,"
                              "loss"),
                r);
    write_marks(grades_write(r), grades_write_remedies(r), results_part(r, "turns"));
}

/* Largest |growth - 1| of the imposed spin, of those methods or of all that finish ("", of which
 * there must be so many). */
static Measure off_growth(const Table *t, const char *methods, int many)
{
    Measure worst = measure_max_of(many);
    EACH_ROW(row, t, "scene=spin variant=usual") {
        bool counts = !methods[0] && !select_is_lost(t, row);
        EACH_WORD(m, methods) counts |= select_is(t, row, "method", m);
        if (counts) measure_add_max(&worst, fabs(select_kept(t, row, "growth") - 1));
    }
    return worst;
}

/* How many of four methods were lost in the free spin with boxes that follow the stretch. */
static Measure lost_stretched(const Table *t)
{
    Measure lost = measure_sum_of(4);
    EACH_WORD(m, "gimp ge_gimp xpic fmpm")
        EACH_ROW(row, t, "scene=free variant=stretch method=%s", m)
            measure_add(&lost, !select_is(t, row, "status", "ok"));
    return lost;
}

/* Claims about options that change the result. */
static void check_remedies(Check *c, const Table *t)
{
    const char *linear = "ge_mpm ge_gimp apic tpic wls2";
    const double quarter = exp(TURNS * 2 * M_PI * PER_STEP / 4);
    const Measure J = curve_worst(t, linear, 1, "J", "scene=spin variant=exponential");
    claim(c, "H-8a.exponential", "Imposed spin with F = exp(dt L) F: J after ten turns, less 1",
          measure_with(J, J.value - 1), -1e-6, 1e-6);
    claim(
        c, "H-8a.subcycled",
        "Imposed spin with F updated in four parts: J after ten turns over exp(2 pi w dt/4) a turn",
        measure_times(curve_worst(t, linear, 1, "J", "scene=spin variant=subcycled"), 1 / quarter),
        0.99, 1.01);
    claim(c, "H-8b.stretch",
          "Free spin, boxes of width l0 U_dd: runs lost of GIMP, GE-GIMP, XPIC, FMPM",
          lost_stretched(t), 0, 0);
    claim(
        c, "H-8b.exponential",
        "Free spin: F = exp(dt L) F does not fit x += dt v, and GIMP is lost: after how many turns",
        select_ended(t, "turns", "method=gimp scene=free variant=exponential"), 0, 9.9);
}

static void check(Check *c, const Results *r)
{
    const Table *t = results_part(r, "turns");
    claim(c, "H-8a.growth",
          "Imposed spin: J grows by exp(2 pi w dt) a turn with GE-MPM, GE-GIMP, APIC, TPIC, WLS, "
          "WLS2 and FEM: largest relative deviation",
          off_growth(t, "ge_mpm ge_gimp apic tpic wls wls2 fem", 7), 0, 0.01);
    claim_differs(
        c, "H-8a.growth-all",
        "Imposed spin: J grows by exp(2 pi w dt) a turn with every method that finishes: "
        "largest relative deviation",
        off_growth(t, "", METHODS), 0, 0.01, 0.01, 0.1,
        "a turn GIMP and XPIC gain 3.9 % less, FMPM 2.1, B-splines 1.3, MPM 1.1: mass-weighted "
        "projection underestimates rotation at edges");
    claim(c, "H-8a.extent",
          "Imposed spin: after a quarter turn particle boxes have no width left: least |F_xx| of "
          "GIMP",
          select_value(t, "narrowest", "scene=quarter variant=usual method=gimp"), 0, 0.02);
    claim_differs(
        c, "H-8b.J",
        "Free spin with cd: J stays within 1.5 % of 1: largest mean J of GIMP, GE-GIMP, APIC, FEM",
        curve_worst(t, "gimp ge_gimp apic fem", 1, "J", "scene=free variant=usual"), 1, 1.015,
        1.015, 1.03,
        "it is bounded by 1.022 (FEM), 1.015 (GE-GIMP), 1.012 (APIC), 1.007 (GIMP): the block "
        "starts without the strain of its spin and breathes");
    claim(c, "H-8b.gimp", "Free spin: GIMP loses 1.7 % of its angular momentum a turn",
          select_value(t, "loss", "scene=free variant=usual method=gimp"), 0.012, 0.022);
    claim_differs(c, "H-8b.ge-gimp",
                  "Free spin: GE-GIMP loses a tenth of a per cent of its angular momentum a turn",
                  select_value(t, "loss", "scene=free variant=usual method=ge_gimp"), 0.0005, 0.002,
                  0, 0.0005,
                  "it loses .024 % a turn, a quarter of that, on this mesh of 16 cells a side");
    check_remedies(c, t);
}

const StudyPage study_h_08_spin = {.cases = cases, .tables = tables, .check = check, .claims = 10};
