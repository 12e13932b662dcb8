/* forty_percent.h: one range for W07's "about forty percent" in figs 12, 13 and 15: GE-GIMP's error
 * over GIMP's must lie in .5 ... .7. Fig. 12: ratio of medians over PPC; figs 13 and 15: mean ratio
 * over all meshes. */
#ifndef MPMLAB_FORTY_PERCENT_H
#define MPMLAB_FORTY_PERCENT_H

#define FORTY_PERCENT_LOW  0.5
#define FORTY_PERCENT_HIGH 0.7

#endif
