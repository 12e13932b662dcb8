/* t_08_shell_cost.c: speed against error in three dimensions: the octant of the shell over one
 * period with particle methods, WLS and FEM with integrated body force. Cost is the CPU time of the
 * step loop (cpu_s of a row); beside it stand particle-steps (FEM: element-steps), which no machine
 * changes. Points and costs at 1e-3: effort.h. */
#include "studies/tables/curves.h"
#include "studies/tables/effort.h"

static const int cells[] = {8, 12, 16, 20, 24};
static const char *const cfls[] = {".3", ".6", ".9"}; /* of the least altitude */
/* WLS takes three to eight times as long as GIMP: one finer mesh for GE-WLS alone, which reaches
 * 1e-3 there. */
static const struct {
    const char *method;
    int meshes;
} runs[] = {{"gimp", 5}, {"ge_gimp", 5}, {"apic", 3}, {"wls", 3}, {"wls2", 3}, {"ge_wls", 4}};
enum { MESHES = 5, METHODS = sizeof runs / sizeof *runs, CFLS = 3 };

static void cases(Cases *list, bool quick)
{
    for (int m = 0; m < METHODS; m++)
        for (int k = 0; k < (quick ? 2 : runs[m].meshes); k++)
            case_add(list, "run shell --method %s --cells %d", runs[m].method, cells[k]);
    for (int c = 0; c < CFLS; c++)
        for (int k = 0; k < (quick ? 2 : MESHES); k++)
            case_add(list, "run shell --method fem --cells %d --cfl %s --set body=elements",
                     cells[k], cfls[c]);
}

static void tables(const Results *r)
{
    effort_tables(r, 1);
}

/* A number of a run with its own CFL number. */
static Measure of(const Results *r, const char *column, const char *method, double cfl, int n)
{
    return select_value(r->rows, column, "method=%s cfl=%g cells=%d", method, cfl, n);
}

static void check(Check *c, const Results *r)
{
    static const char target[] = "problem=shell target=0.001";
    claim(c, "T-8.fem-error",
          "Shell: largest error of FEM with integrated body force at N = 8 over GIMP's at N = 16",
          measure_ratio(of(r, "error_linf", "fem", 0.9, 8), of(r, "error_linf", "gimp", 0.3, 16)),
          0.5, 1);
    claim(c, "T-8.fem-time",
          "Shell: CPU time of GIMP at N = 16 over that of FEM at N = 8, CFL .9, whose error is "
          "smaller",
          measure_ratio(of(r, "cpu_s", "gimp", 0.3, 16), of(r, "cpu_s", "fem", 0.9, 8)), 3, 300);
    claim(c, "T-8.wls2-error", "Shell: largest error of WLS2 at N = 16 over that of GIMP at N = 24",
          measure_ratio(of(r, "error_linf", "wls2", 0.3, 16), of(r, "error_linf", "gimp", 0.3, 24)),
          0.5, 1);
    claim(c, "T-8.wls2-time",
          "Shell: CPU time of GIMP at N = 24 over that of WLS2 at N = 16, whose error is smaller",
          measure_ratio(of(r, "cpu_s", "gimp", 0.3, 24), of(r, "cpu_s", "wls2", 0.3, 16)), 0.5, 4);
    claim(c, "T-8.ge-wls-time", "Shell to 1e-3: CPU time of GE-WLS over FEM's, each at its best",
          effort_ratio(r, target, "seconds", "ge_wls", "fem"), 2, 60);
    claim(c, "T-8.ge-wls-steps",
          "Shell to 1e-3: particle-steps of GE-WLS over element-steps of FEM, each at its best",
          effort_ratio(r, target, "work", "ge_wls", "fem"), 0.1, 3);
}

const StudyPage study_t_08_shell_cost = {
    .cases = cases, .tables = tables, .check = check, .claims = 6, .timed = true};
