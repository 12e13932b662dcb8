/* solid.h: volume, moments and integration points of the pieces of a polyhedron. */
#ifndef MPMLAB_SOLID_H
#define MPMLAB_SOLID_H

#include "polyhedron.h"

enum { MAX_SOLID_POINTS = 4 * MAX_FACE_SUM };

/* Volume, centroid, and second moments about the centroid xx, xy, xz, yy, yz, zz of a piece. */
typedef struct Solid {
    double volume, centroid[3], second[6];
} Solid;

/* Measures one piece; second moments if asked. The centroid is finite if the volume is positive. */
void solid_measure(const Polyhedron *p, int piece, bool second, Solid *out);

/* The centroid, moved into the cube if a curved surface's piece has it outside; returns the volume.
 */
double solid_centre(const Solid *s, double x[3]);

/* Points inside the cube and weights that integrate quadratic polynomials over a piece exactly:
 * eight of equal weight if such lie inside, else four in each tetrahedron between its faces and
 * the mean of its vertices, in which case those beyond a curved surface's cube are moved to its
 * side. Returns their number. */
int solid_points(const Polyhedron *p, int piece, const Solid *solid, double x[MAX_SOLID_POINTS][3],
                 double weight[MAX_SOLID_POINTS]);

#endif
