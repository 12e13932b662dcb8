/* raster.h: particles and surface points from a grey image (W11 3.3). */
#ifndef MPMLAB_RASTER_H
#define MPMLAB_RASTER_H

#include "common/base/image.h"
#include "layout.h"

/* An image laid over the box from the origin, n pixel wide along every axis. A place is in the body
 * where the grey, linear between the samples, is below the threshold. Outside the image all is
 * light, or beyond a low side that is a plane of symmetry, mirrored. */
typedef struct Raster {
    const Image *image;
    double pixel;     /* [m] */
    double threshold; /* of grey, from 0 (dark) to 1 */
    bool halfway;     /* samples are dark or light, so that surfaces lie halfway between them */
    unsigned mirrors; /* bit d: x_d = 0 is a plane of symmetry */
} Raster;

/* Is the place x [m] in the body? */
bool raster_is_in(const Raster *r, const Vec x);

/* Add particles at the places (i + 1/2) spacing that are in the body; surface points where lines of
 * a lattice cross its surface, about layout_surface_spacing apart, with normals from the
 * gradient of the grey within the larger of that spacing and three pixels. */
void raster_add_particles(const Raster *r, double spacing, Layout *out);
void raster_add_surface(const Raster *r, double spacing, Layout *out);

#endif
