/* hole.h: stress along the hole of the plate: a fine FEM solution as reference, and how far points
 * near the hole are from it and from each other (W11 fig. 10). Stresses in GPa, angles
 * in degrees from the x axis. */
#ifndef MPMLAB_HOLE_H
#define MPMLAB_HOLE_H

#include "studies/study.h"

/* The reference: von Mises stress of the quads of FEM's mesh, ni across times nj around. */
typedef struct HoleReference {
    int ni, nj;
    double *stress; /* [nj][ni] */
} HoleReference;

/* From the samples of FEM on a mesh of `cells` per unit length. 0, or -1 if these are not there or
 * of another mesh. */
int hole_reference_read(HoleReference *r, const Table *samples, int cells);
void hole_reference_free(HoleReference *r);

/* At reference position (X, Y): bilinear between the quads' middles in xi (0 on the hole, 1 on the
 * outer edge, along rays) and angle; linear beyond the outermost. */
double hole_reference_at(const HoleReference *r, double X, double Y);

typedef struct RimPoint {
    double angle, stress, reference;
} RimPoint;

/* Points initially within .35 h of the hole, by angle. */
typedef struct Rim {
    int n;
    RimPoint *point;
    double moved; /* [m] largest displacement of any point of the file */
} Rim;

/* From a file of particles or samples, h = 1/cells. quads: the samples of FEM, of which two in a
 * row make a quad; they are averaged as in the reference, at the quad's middle, if one of them is
 * near enough. */
Rim hole_read(const Table *points, int cells, const HoleReference *r, bool quads);
void hole_free(Rim *rim);

/* An empty Rim with room for `most` points; and sorts the points of one by angle. */
Rim hole_room(int most);
void hole_sort(Rim *rim);

double hole_rms(const Rim *rim);     /* of stress less reference */
double hole_scatter(const Rim *rim); /* rms of that about its mean of seven neighbours in angle */

/* Both of a run of `cells` against the reference of `fine`, into measures that know how many points
 * they need. */
void hole_measure(const Table *reference, int fine, const Table *run, int cells, Measure *rms,
                  Measure *scatter);

#endif
