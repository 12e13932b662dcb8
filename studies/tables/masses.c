/* masses.c: see masses.h. */
#include "masses.h"

#include <math.h>
#include <stdlib.h>
#include "studies/runs/must.h"
#include "studies/select.h"

static double number(const Table *t, int row, const char *name)
{
    return table_column(t, name) < 0 ? NAN : select_number(t, row, name);
}

static MassPoint point_of(const Table *t, int row)
{
    static const char *const X[] = {"X", "Y", "Z"}, *const x[] = {"x", "y", "z"};
    static const char *const v[] = {"vx", "vy", "vz"}, *const stress[] = {"sxx", "syy", "szz"};
    static const char *const F[2][2] = {{"Fxx", "Fxy"}, {"Fyx", "Fyy"}};
    MassPoint p = {.mass = number(t, row, "mass")};
    double trace = 0;
    for (int a = 0; a < 3; a++) {
        p.X[a] = number(t, row, X[a]);
        p.x[a] = number(t, row, x[a]);
        p.v[a] = number(t, row, v[a]);
        trace += number(t, row, stress[a]);
    }
    for (int k = 0; k < 4; k++) p.F[k / 2][k % 2] = number(t, row, F[k / 2][k % 2]);
    p.J = p.F[0][0] * p.F[1][1] - p.F[0][1] * p.F[1][0];
    p.pressure = -trace / 3;
    return p;
}

Masses masses_read(const Table *t)
{
    Masses out = {.list = must(malloc(((size_t)t->nrow + 1) * sizeof *out.list))};
    for (int row = 0; row < t->nrow; row++)
        if (number(t, row, "mass") > 0) out.list[out.n++] = point_of(t, row);
    return out;
}

void masses_free(Masses *all)
{
    free(all->list);
    *all = (Masses){0};
}

static bool is_near(const MassPoint *a, const MassPoint *b, double reach)
{
    return fabs(b->X[0] - a->X[0]) <= reach && fabs(b->X[1] - a->X[1]) <= reach;
}

double masses_checkerboard(const Masses *all, int share, double spacings)
{
    double square = 0, mass = 0;
    for (const MassPoint *p = all->list, *end = p + all->n; p < end; p++) {
        const double reach = spacings * sqrt(share * p->mass);
        double sum = 0, weight = 0;
        for (const MassPoint *q = all->list; q < end; q++) {
            if (!is_near(p, q, reach)) continue;
            sum += q->mass * q->pressure;
            weight += q->mass;
        }
        square += p->mass * pow(p->pressure - sum / weight, 2);
        mass += p->mass;
    }
    return sqrt(square / mass);
}
