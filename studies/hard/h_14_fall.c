/* h_14_fall.c: hard case H-14: a block falls freely from rest.
 *
 * No stress, no gradient: x - g t^2/2 must vanish to round-off if velocities live half a step after
 * positions, which the half first step of cd, uvf and musl sees to. usl and usf take whole first
 * steps: x_n = g dt^2 n (n + 1)/2, which is g t dt/2 too much. */
#include <math.h>
#include <string.h>
#include "studies/tables/grades.h"

enum { WHOLE = 3, INTEGRATORS = 5 }; /* from WHOLE on with a whole first step */
static const char *const integrators[INTEGRATORS] = {"cd", "uvf", "musl", "usl", "usf"};
#define GRAVITY 1000 /* [m/s^2] */

static void cases(Cases *list, bool quick)
{
    for (const Engine *const *e = engines; *e && (*e)->dim <= 2; e++)
        EACH_METHOD(m, *e)
            for (int k = 0; k < (engine_has_grid(*e, m->name) ? INTEGRATORS : 1); k++)
                case_add(
                    list,
                    "run block --method %s --integrator %s --set dim=%d --set gravity=%d --set "
                    "offset_x=0.3 --set offset_y=0.2 --set refresh=%d --set allow_unstable=1 "
                    "--set steps=%d",
                    m->name, integrators[k], (*e)->dim, GRAVITY, engine_has_grid(*e, m->name),
                    quick ? 20 : 100);
}

/* The error of a run [m]; or how far it is from g t dt/2, over that. */
static double error_of(const Table *rows, int row, bool whole)
{
    const double dt = select_number(rows, row, "dt"), t = dt * select_number(rows, row, "steps");
    const double e = select_kept(rows, row, "error_linf");
    return whole ? fabs(e / (GRAVITY * t * dt / 2) - 1) : e;
}

/* The largest of them with integrators from .. to - 1 of one method, or (NULL) of all methods and
 * FEM. */
static Measure worst(const Table *rows, const char *method, int from, int to)
{
    Measure most = measure_max_of(0);
    for (const Engine *const *e = engines; *e && (*e)->dim <= 2; e++)
        EACH_METHOD(m, *e)
            for (int k = from; k < to && (k == 0 || engine_has_grid(*e, m->name)); k++)
                most.needs += method ? strcmp(method, m->name) == 0 : !m->on_request;
    for (int row = 0; row < rows->nrow; row++)
        for (int k = from; k < to; k++)
            if ((!method || select_is(rows, row, "method", method)) &&
                select_is(rows, row, "integrator", integrators[k]))
                measure_add_max(&most, error_of(rows, row, from >= WHOLE));
    return most;
}

static void tables(const Results *r)
{
    FILE *f = grades_write(r);
    EACH_METHOD_OF(m, &engine_2d, r->rows) {
        const double e = worst(r->rows, m->name, 0, WHOLE).value;
        grade_add(f, "H-14", m->name, grade_mark_of(e, 1e-12, 1e-3), "off by %.1g m", e);
    }
}

static void check(Check *c, const Results *r)
{
    claim(c, "H-14.half-step",
          "Free fall: x - g t^2/2 vanishes with a half first step (cd, uvf, musl), every method "
          "and FEM: largest [m]",
          worst(r->rows, NULL, 0, WHOLE), 0, 1e-12);
    claim(
        c, "H-14.whole-step",
        "Free fall with a whole first step (usl, usf), every method, is g t dt/2 too far: largest "
        "departure of an error from that, over it",
        worst(r->rows, NULL, WHOLE, INTEGRATORS), 0, 1e-9);
}

const StudyPage study_h_14_fall = {.cases = cases, .tables = tables, .check = check, .claims = 2};
