/* forty_percent.h: one yardstick for W07's "about forty percent" in figs 12, 13 and 15: GE-GIMP's
 * error over GIMP's, mean over all meshes, must be .6 within .1. */
#ifndef MPMLAB_FORTY_PERCENT_H
#define MPMLAB_FORTY_PERCENT_H

#define FORTY_PERCENT_LOW  0.5
#define FORTY_PERCENT_HIGH 0.7

#endif
