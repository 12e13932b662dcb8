/* masses.h: the points with mass in a file that a run has left: particles, or samples (of FEM: its
 * elements). Surface points of WLS have none and are left out. */
#ifndef MPMLAB_MASSES_H
#define MPMLAB_MASSES_H

#include "studies/study.h"

/* NAN: not in the file, or beyond the dimension. */
typedef struct MassPoint {
    double mass;             /* [kg] */
    double X[3], x[3], v[3]; /* reference position, position [m], velocity [m/s] */
    double F[2][2];          /* deformation gradient in the plane */
    double J;                /* its determinant, times F_zz */
    double pressure;         /* [Pa] */
} MassPoint;

typedef struct Masses {
    int n;
    MassPoint *list;
} Masses;

Masses masses_read(const Table *t);
void masses_free(Masses *all);

/* Sums over points in the plane. */
typedef struct MassSums {
    int n;
    double J, least_J, most_J; /* mean over mass, extremes; */
    double least_Fxx;          /*   of |F_xx| */
    double inertia;            /* sum m |X - centre|^2 */
    double angular;            /* momentum about the centre of mass, of motion alone */
} MassSums;

MassSums masses_sum(const Table *t, const double centre[2]);

/* How many times as long a body is that hangs from y = top: mean over the points of its lowest
 * layer; NAN: there are none. */
double masses_hanging_stretch(const Table *t, double top);

/* Mass-weighted rms of p - <p>: <p> is the mass-weighted mean pressure of all points whose X and Y
 * differ by at most spacings s from those of the point, s = sqrt(share m) with the point's own mass
 * m: the side of a square that `share` such points fill at density 1. */
double masses_checkerboard(const Masses *all, int share, double spacings);

#endif
