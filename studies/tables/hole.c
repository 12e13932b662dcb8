/* hole.c: see hole.h. */
#include "hole.h"

#include <math.h>
#include <stdlib.h>
#include "studies/runs/must.h"
#include "studies/select.h"

static const double radius = 0.5; /* [m], of the hole; the plate is 1 m wide */

/* FEM's mesh of the plate (problems/hole_plate.c). Elements 2 q and 2 q + 1 make quad q, which
 * count across first. */
int hole_reference_read(HoleReference *r, const Table *t, int cells)
{
    *r = (HoleReference){.ni = (int)ceil(0.6 * cells - 1e-9),
                         .nj = 2 * (int)ceil(M_PI / 4 * 0.7 * cells - 1e-9)};
    const int quads = r->ni * r->nj;
    if (t->nrow != 2 * quads || r->ni < 2) return -1;
    r->stress = must(malloc(sizeof(double) * (size_t)quads));
    for (int q = 0; q < quads; q++)
        r->stress[q] = 0.5e-9 * (select_number(t, 2 * q, "von_mises") +
                                 select_number(t, 2 * q + 1, "von_mises"));
    return 0;
}

void hole_reference_free(HoleReference *r)
{
    free(r->stress);
    *r = (HoleReference){0};
}

/* The interval of `count` middles that x (in steps, from the edge) lies in or is nearest to. */
static int interval(double x, int count, double *part)
{
    int k = (int)floor(x - 0.5);
    if (k < 0) k = 0;
    if (k > count - 2) k = count - 2;
    *part = x - 0.5 - k;
    return k;
}

double hole_reference_at(const HoleReference *r, double X, double Y)
{
    double a, b;
    const double angle = atan2(Y, X), edge = 1 / fmax(cos(angle), sin(angle));
    const int i = interval((hypot(X, Y) - radius) / (edge - radius) * r->ni, r->ni, &a);
    const int j = interval(angle / (M_PI / 2) * r->nj, r->nj, &b);
    const double *near = r->stress + j * r->ni + i, *far = near + r->ni;
    return (1 - b) * ((1 - a) * near[0] + a * near[1]) + b * ((1 - a) * far[0] + a * far[1]);
}

static int by_angle(const void *a, const void *b)
{
    const RimPoint *x = a, *y = b;
    return (x->angle > y->angle) - (x->angle < y->angle);
}

void hole_sort(Rim *rim)
{
    qsort(rim->point, (size_t)rim->n, sizeof *rim->point, by_angle);
}

/* Mean of the column over the `members` rows from k on. */
static double mean_of(const Table *t, int k, int members, const char *column)
{
    double sum = 0;
    for (int i = k; i < k + members; i++) sum += select_number(t, i, column);
    return sum / members;
}

static bool is_near(const Table *t, int k, int members, int cells)
{
    for (int i = k; i < k + members; i++)
        if (hypot(select_number(t, i, "X"), select_number(t, i, "Y")) - radius <=
            0.35 / cells + 1e-12)
            return true;
    return false;
}

Rim hole_room(int most)
{
    return (Rim){.point = must(malloc(sizeof(RimPoint) * ((size_t)most + 1)))};
}

Rim hole_read(const Table *t, int cells, const HoleReference *r, bool quads)
{
    const int members = quads ? 2 : 1;
    Rim rim = hole_room(t->nrow);
    for (int k = 0; k + members <= t->nrow; k += members) {
        const double X = mean_of(t, k, members, "X"), Y = mean_of(t, k, members, "Y");
        if (select_number(t, k, "surface") > 0) continue;
        rim.moved = measure_worse(
            rim.moved, hypot(mean_of(t, k, members, "x") - X, mean_of(t, k, members, "y") - Y));
        if (!is_near(t, k, members, cells)) continue;
        rim.point[rim.n++] =
            (RimPoint){atan2(Y, X) * 180 / M_PI, 1e-9 * mean_of(t, k, members, "von_mises"),
                       hole_reference_at(r, X, Y)};
    }
    hole_sort(&rim);
    return rim;
}

void hole_free(Rim *rim)
{
    free(rim->point);
    *rim = (Rim){0};
}

static double off(const Rim *rim, int k)
{
    return rim->point[k].stress - rim->point[k].reference;
}

double hole_rms(const Rim *rim)
{
    double sum = 0;
    for (int k = 0; k < rim->n; k++) sum += off(rim, k) * off(rim, k);
    return sqrt(sum / rim->n);
}

double hole_scatter(const Rim *rim)
{
    double sum = 0;
    for (int k = 0; k < rim->n; k++) {
        const int from = k > 3 ? k - 3 : 0, to = k + 4 < rim->n ? k + 4 : rim->n;
        double mean = 0;
        for (int j = from; j < to; j++) mean += off(rim, j) / (to - from);
        sum += (off(rim, k) - mean) * (off(rim, k) - mean);
    }
    return sqrt(sum / rim->n);
}

void hole_measure(const Table *reference, int fine, const Table *run, int cells, Measure *rms,
                  Measure *scatter)
{
    HoleReference r;
    if (!run->nrow || hole_reference_read(&r, reference, fine)) return;
    Rim rim = hole_read(run, cells, &r, false);
    *rms = measure(hole_rms(&rim), rim.n, rms->needs);
    *scatter = measure(hole_scatter(&rim), rim.n, scatter->needs);
    hole_free(&rim);
    hole_reference_free(&r);
}
