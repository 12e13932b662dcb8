/* polygon.h: marching squares: the part of a unit square where a distance is positive. */
#ifndef MPMLAB_POLYGON_H
#define MPMLAB_POLYGON_H

#include <stdbool.h>

enum { MAX_SIDES = 6, MAX_PIECES = 2, MAX_SQUARE_POINTS = 3 * MAX_SIDES };

typedef struct Polygon {
    int n;
    bool bent;              /* corner 0 stands for the bulge of a curved side, and may be reflex */
    double x[MAX_SIDES][2]; /* counter-clockwise */
} Polygon;

/* The curved boundary near each corner: its curvature [1/side], > 0 where the shape is convex, 0 if
 * not known, and its outward normal. */
typedef struct Curved {
    double kappa[4], normal[4][2];
} Curved;

/* Where an edge of length 1 leaves the shape, from the distances of its ends inside and outside: t
 * in [0, 1] of (1 - t) in + t out + bulge t (1 - t) = 0. */
double polygon_cut(double in, double out, double bulge);

/* The shape from the distances at corners (0,0), (1,0), (0,1), (1,1): in where > 0, edges cut by
 * linear interpolation (W11 eq 18). A saddle is one hexagon if the mean distance is positive, else
 * two triangles. With `curved` (or NULL) edges are cut where the curve crosses them, and the chord
 * of a piece gets one corner more, so that the area is that of the circular segment. Returns the
 * number of pieces. */
int polygon_pieces(const double distance[4], const Curved *curved, Polygon piece[MAX_PIECES]);

/* Area of a polygon, and its centroid if the area is positive. */
double polygon_area(const Polygon *p, double centroid[2]);

/* Points and weights that integrate quadratic polynomials over it exactly: three per
 * triangle (of a fan from corner 0 if bent: weights may be negative). Returns their number. */
int polygon_points(const Polygon *p, double x[MAX_SQUARE_POINTS][2],
                   double weight[MAX_SQUARE_POINTS]);

#endif
