/* wls_squares.h: marching squares: the part of a unit square where a distance is positive. */
#ifndef MPMLAB_WLS_SQUARES_H
#define MPMLAB_WLS_SQUARES_H

enum { MAX_SIDES = 6, MAX_PIECES = 2, MAX_SQUARE_POINTS = 3 * MAX_SIDES };

typedef struct Polygon {
    int n;
    double x[MAX_SIDES][2]; /* counter-clockwise */
} Polygon;

/* The shape from the distances at corners (0,0), (1,0), (0,1), (1,1): in where > 0, edges cut by
 * linear interpolation (W11 eq 18). A saddle is one hexagon if the mean distance is positive, else
 * two triangles. Returns the number of pieces. */
int square_pieces(const double distance[4], Polygon piece[MAX_PIECES]);

/* Area of a polygon, and its centroid if the area is positive. */
double polygon_area(const Polygon *p, double centroid[2]);

/* Points and weights that integrate quadratic polynomials over it exactly: three a triangle.
 * Returns their number. */
int polygon_points(const Polygon *p, double x[MAX_SQUARE_POINTS][2],
                   double weight[MAX_SQUARE_POINTS]);

#endif
