/* patches.h: the polygons that a run leaves with --patches, corner by corner. */
#ifndef MPMLAB_PATCHES_H
#define MPMLAB_PATCHES_H

#include <stdbool.h>
#include <stdio.h>

/* A file of them, and its present corner. */
typedef struct Patches {
    FILE *f;     /* NULL: there is no file, or no more corner */
    int corners; /* read so far */
    int k;       /* 0, 1, ... in each polygon */
    double x[3]; /* [m]; z = 0 in the plane */
    bool cut;    /* of a cut cell; in space: of the surface */
} Patches;

/* path NULL: none. */
Patches patches_open(const char *path);

/* Reads the next corner; the first call reads the first one. After the last corner it closes the
 * file and returns false. */
bool patches_next(Patches *p);

#endif
