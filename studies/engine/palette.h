/* palette.h: one label, colour and marker per method, the same in all figures. */
#ifndef MPMLAB_PALETTE_H
#define MPMLAB_PALETTE_H

#include <stdio.h>

/* Colour k ("#rrggbb"), all of them different: Okabe and Ito's, then Tol's muted ones, which
 * colour-blind readers can tell apart, then computed ones; and gnuplot's point type k. */
void palette_colour(int k, char out[8]);
int palette_marker(int k);

/* For gnuplot: words that describe all methods of this program in the order of their registry,
 * those on request apart and last: METHODS='mpm gimp'; REQUESTED='cpdi'; LABELS='...';
 * COLOURS='...'; MARKERS='...'; */
void palette_put(FILE *out);

#endif
