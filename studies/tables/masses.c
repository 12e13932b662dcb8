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
    const double across = p.F[0][1] * p.F[1][0], Fzz = number(t, row, "Fzz");
    p.J = (p.F[0][0] * p.F[1][1] - across) * (isnan(Fzz) ? 1 : Fzz);
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

MassSums masses_sum(const Table *t, const double centre[2])
{
    Masses all = masses_read(t);
    MassSums s = {.n = all.n, .least_J = INFINITY, .most_J = -INFINITY, .least_Fxx = INFINITY};
    double mass = 0, x = 0, y = 0, px = 0, py = 0;
    for (const MassPoint *p = all.list; p < all.list + all.n; p++) {
        const double m = p->mass, X = p->X[0] - centre[0], Y = p->X[1] - centre[1];
        s.J += m * p->J;
        s.least_J = measure_lesser(s.least_J, p->J);
        s.most_J = measure_worse(s.most_J, p->J);
        s.least_Fxx = measure_lesser(s.least_Fxx, fabs(p->F[0][0]));
        s.inertia += m * (X * X + Y * Y);
        s.angular += m * (p->x[0] * p->v[1] - p->x[1] * p->v[0]);
        mass += m;
        x += m * p->x[0], y += m * p->x[1];
        px += m * p->v[0], py += m * p->v[1];
    }
    masses_free(&all);
    s.J /= mass;
    s.angular -= (x * py - y * px) / mass;
    return s;
}

double masses_hanging_stretch(const Table *t, double top)
{
    Masses all = masses_read(t);
    double lowest = INFINITY, total = 0;
    int n = 0;
    for (int k = 0; k < all.n; k++) lowest = measure_lesser(lowest, all.list[k].X[1]);
    for (int k = 0; k < all.n; k++) {
        const double Y = all.list[k].X[1], y = all.list[k].x[1];
        if (Y > lowest + 1e-9) continue;
        total += (top - y) / (top - Y);
        n++;
    }
    masses_free(&all);
    return n ? total / n : NAN;
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
