/* drawing.h: a figure's drawing as the page holds it: what every reader sees, in fewer bytes. */
#ifndef MPMLAB_DRAWING_H
#define MPMLAB_DRAWING_H

/* The .svg at `path` as the text of a URL in single quotes, to be freed; NULL if it cannot be read.
 * Points of one symbol, size and colour in a row become markers of one path; coordinates are
 * relative and to a tenth of a pixel; titles, empty groups and defaults are left out. */
char *drawing_read(const char *path);

#endif
