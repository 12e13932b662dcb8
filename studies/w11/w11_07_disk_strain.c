/* w11_07_disk_strain.c: strain energy per volume of the disk at three times, by WLS and by GIMP.
 * Wallstedt and Guilkey (2011), fig. 7.
 *
 * t = 0: free flight. t = 2: after the first impact, on the floor at t ~ .5, the disk vibrates. t =
 * 3: in its second impact, on the right wall, which it meets at t ~ 2.5. */
#include <math.h>
#include "studies/tables/curves.h"

static const char *const methods[] = {"wls", "gimp"};
static const struct {
    const char *time, *t_end;
} shown[] = {{"0", "1e-9"}, {"2", "2"}, {"3", "3"}}; /* one step of 1 ns shows the start */
enum { METHODS = 2, TIMES = 3, PARTICLES = 1000 };

static void cases(Cases *list, bool quick)
{
    for (int m = 0; m < METHODS; m++)
        for (int k = 0; k < TIMES; k++)
            case_add_with(list, "particles", phrase("%s.%s", methods[m], shown[k].time),
                          "run disk_impact --method %s --cells %d --t-end %s", methods[m],
                          quick ? 12 : 48, shown[k].t_end);
}

/* Of one state: largest x, stored energy [J], mean velocity along x. */
typedef struct Look {
    Measure right, energy, vx;
} Look;

static Look look(const Results *r, const char *method, const char *time)
{
    const Table *t = results_run(r, "%s.%s", method, time);
    Look out = {measure_max_of(PARTICLES), measure_sum_of(PARTICLES), measure_sum_of(PARTICLES)};
    double mass = 0;
    for (int k = 0; k < t->nrow; k++) {
        const double m = select_number(t, k, "mass");
        measure_add_max(&out.right, select_number(t, k, "x"));
        measure_add(&out.energy, m / 1000 * select_number(t, k, "energy")); /* V0 = m/rho */
        measure_add(&out.vx, m * select_number(t, k, "vx"));
        mass += m;
    }
    out.vx.value /= mass;
    return out;
}

static void check(Check *c, const Results *r)
{
    const Look start = look(r, "wls", "0"), later = look(r, "wls", "2"), last = look(r, "wls", "3");
    claim(c, "W11-7.flight",
          "Disk, WLS: no strain energy in free flight: at t = 0 over that at t = 3",
          measure_ratio(start.energy, last.energy), 0, 1e-12);
    claim(c, "W11-7.vibration",
          "Disk, WLS: little strain energy is left between two impacts: strain energy at t = 2 "
          "over that at t = 3",
          measure_ratio(later.energy, last.energy), 0, 0.2);
    claim(c, "W11-7.second-impact",
          "Disk, WLS: fig. 7c is the second impact: at t = 3 the disk is at the right wall: "
          "largest x [m]",
          last.right, 0.98, 1.001);
    claim(c, "W11-7.turning",
          "Disk, WLS: at t = 3 the right wall is throwing the disk back: mean vx over that at the "
          "start",
          measure_ratio(last.vx, start.vx), -0.6, -0.1);
}

const StudyPage study_w11_07_disk_strain = {.cases = cases, .check = check, .claims = 4};
