/* bench.c: what `make bench` measures besides the program itself: the machine's bounds, the
 * textbook code and two bare loops. Prints one number per line, "name value":
 *
 *   bench machine                 fma_gflops, copy_gbs: multiply-adds, and reads + writes in place
 *   bench twin CELLS STEPS        twin_ns: ns per particle-step of GIMP on free_block
 *   bench bare KIND CELLS STEPS   bare_ns: the same of a bare loop, KIND mls or gimp */
#define _GNU_SOURCE
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "common/base/stopwatch.h"
#include "common/run/plan.h"
#include "tests/textbook/textbook.h"
#include "tests/tools/bare_loops.h"

/* 12 independent chains of the widest vectors that the compiler has for Line. */
static double fma_gflops(void)
{
    enum { CHAINS = 12, ROUNDS = 4000000 };
    Line x[CHAINS], a = {0}, b = {0};
    for (int l = 0; l < LANES; l++) a[l] = 0.999999, b[l] = 1e-6;
    for (int k = 0; k < CHAINS; k++) x[k] = b;
    const double start = stopwatch_cpu();
    for (int r = 0; r < ROUNDS; r++)
        for (int k = 0; k < CHAINS; k++) x[k] = x[k] * a + b;
    const double spent = stopwatch_cpu() - start;
    double sum = 0;
    for (int k = 0; k < CHAINS; k++) sum += x[k][0];
    return sum > 0 ? 2e-9 * (double)(LANES * CHAINS) * (double)ROUNDS / spent : 0;
}

/* Every number of a large array read and written in place. */
static double copy_gbs(void)
{
    const size_t n = (size_t)1 << 25;
    double *x = calloc(n, sizeof *x), best = 1e9;
    if (!x) return 0;
    for (int k = 0; k < 5; k++) {
        const double start = stopwatch_cpu();
        for (size_t i = 0; i < n; i++) x[i] = x[i] * 0.5 + 1;
        const double spent = stopwatch_cpu() - start;
        best = k && spent < best ? spent : best;
    }
    const double rate = 2e-9 * sizeof *x * (double)n / best;
    const bool used = x[n / 2] > 0;
    free(x);
    return used ? rate : 0;
}

static int plan(Plan *p, const char *method, int cells)
{
    RunSpec spec = {.problem = "free_block", .cells = cells};
    Fault fault = {0};
    snprintf(spec.method, sizeof spec.method, "%s", method);
    if (plan_make(&spec, p, &fault)) fprintf(stderr, "bench: %s\n", fault.text);
    return fault.code;
}

static int twin(int cells, int steps)
{
    Plan p;
    if (plan(&p, "gimp", cells)) return 2;
    printf("twin_ns %.4g\n", twin_ns(&p.setup, 0.3 * p.scene.cell / p.scene.c, steps));
    return 0;
}

static int bare(const char *kind, int cells, int steps)
{
    double kept = 0;
    const double ns = bare_ns(strcmp(kind, "mls") ? BARE_GIMP : BARE_MLS, cells, steps, &kept);
    printf("bare_ns %.4g\nkept %.10g\n", ns, kept);
    return !(kept > 0.99 && kept < 1.01); /* it spins on, or the loop is wrong */
}

int main(int argc, char **argv)
{
    if (argc == 2 && !strcmp(argv[1], "machine")) {
        printf("fma_gflops %.4g\ncopy_gbs %.4g\n", fma_gflops(), copy_gbs());
        return 0;
    }
    if (argc == 4 && !strcmp(argv[1], "twin")) return twin(atoi(argv[2]), atoi(argv[3]));
    if (argc == 5 && !strcmp(argv[1], "bare")) return bare(argv[2], atoi(argv[3]), atoi(argv[4]));
    fprintf(stderr, "bench: machine | twin CELLS STEPS | bare KIND CELLS STEPS\n");
    return 2;
}
