/* samples.h: many points in a cell that may be cut (W11 3.4.1), those outside left out. */
#ifndef MPMLAB_SAMPLES_H
#define MPMLAB_SAMPLES_H

#include <stdbool.h>

enum { SAMPLES_AXIS = 4, MOST_SAMPLES = 64 };

/* Of 4 points along each of `axes` axes of the unit cell, Gauss' or evenly spaced, those where the
 * distance, given at the corners (bit d of the number: far side of axis d) and linear along every
 * axis between them, is positive; with their weights. Returns their number. */
int samples_in_cell(int axes, const double distance[], bool gauss, double x[MOST_SAMPLES][3],
                    double weight[MOST_SAMPLES]);

#endif
