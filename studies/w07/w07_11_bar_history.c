/* w07_11_bar_history.c: displacement histories at four stations of the suddenly stopped bar,
 * computed and exact. Wallstedt and Guilkey (2007), fig. 11 (eq. 5.1).
 *
 * GIMP, 40 cells, 2.5 particles per cell. One run for every instant of the figure, all with the
 * same time step; tables() gathers the four particles nearest X = L/4, L/2, 3L/4, L. Exact:
 * saw-teeth clipped at v0 X/c, whose period is 4 L/c. */
#include <math.h>
#include "studies/tables/curves.h"

enum { PARTICLES = 101, A_PERIOD = 64, INSTANTS = 80, STATIONS = 4 };
static const double period = 0.04, c = 100; /* [s], [m/s]: L = v0 = 1 */

static void cases(Cases *list, bool quick)
{
    for (int k = quick ? 8 : 1; k <= INSTANTS; k += quick ? 8 : 1)
        case_add_with(list, "particles", phrase("%d", k),
                      "run bar --method gimp --t-end %.17g --set particles=%d",
                      period * k / (double)A_PERIOD, PARTICLES);
    case_add_with(list, "particles", "fine",
                  "run bar --method gimp --cells 160 --t-end %.17g --set particles=%d", period / 4,
                  4 * PARTICLES);
}

/* u(X, t): up and down in half a period, then the same with the other sign. */
static double exact(double X, double t)
{
    double rest = fmod(t, period / 2), sign = fmod(t, period) < period / 2 ? 1 : -1;
    return sign * fmin(fmin(rest, period / 2 - rest), X / c);
}

static void write_instant(FILE *f, const Table *particles, double t, const char *status)
{
    for (int s = 1; s <= STATIONS; s++) {
        int row = (int)ceil(s * PARTICLES / (double)STATIONS) - 1;
        if (row >= particles->nrow) return;
        double X = select_number(particles, row, "X"), x = select_number(particles, row, "x");
        results_print(f, "%d,%.17g,%.17g,%.17g,%.17g,%s\n", s, X, t, x - X, exact(X, t), status);
    }
}

static void tables(const Results *r)
{
    FILE *f = results_write(r, "stations", "station,X,t,u,u_exact,status");
    for (int k = r->quick ? 8 : 1; k <= INSTANTS; k += r->quick ? 8 : 1)
        write_instant(f, results_ended(r, "%d", k), period * k / (double)A_PERIOD,
                      results_status(r, phrase("%d", k)));
}

/* Displacement of the tip at the end of the run on the fine mesh: its largest. */
static Measure fine_tip(const Results *r)
{
    const Table *t = results_run(r, "fine");
    Measure u = measure_sum_of(1);
    if (t->nrow > 0) measure_add(&u, select_last(t, "x") - select_last(t, "X"));
    return u;
}

/* The time of the curve's last passage through zero from below, between two instants. */
static double last_rise(const Curve *u)
{
    for (int k = u->n - 1; k > 0; k--)
        if (u->y[k] >= 0 && u->y[k - 1] < 0)
            return u->x[k] - (u->x[k] - u->x[k - 1]) * u->y[k] / (u->y[k] - u->y[k - 1]);
    return NAN;
}

static void check(Check *check, const Results *r)
{
    Curve tip;
    const Table *stations = results_part(r, "stations");
    curve_pick(&tip, stations, "t", "u", "station=%d", STATIONS);
    const Measure most = curve_max(&tip, INSTANTS);
    claim_differs(
        check, "W07-11.amplitude",
        "Stopped bar: the tip's amplitude is v0 L/c: largest displacement over that, h = 1/40",
        measure_times(most, c), 0.98, 1.02, 0.95, 0.98,
        "GIMP rounds the sharp peak by 3.4 percent on 40 cells, by 1.3 on 160 "
        "(W07-11.amplitude-fine)");
    claim(check, "W07-11.amplitude-fine",
          "Stopped bar: the tip's amplitude with h = 1/160: largest displacement over v0 L/c",
          measure_times(fine_tip(r), c), 0.98, 1.02);
    claim(check, "W07-11.period", "Stopped bar: period of the tip's displacement over 4 L/c",
          measure_with(most, last_rise(&tip) / period), 0.98, 1.02);
}

const StudyPage study_w07_11_bar_history = {
    .cases = cases, .tables = tables, .check = check, .claims = 3};
