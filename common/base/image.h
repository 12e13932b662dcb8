/* image.h: grey images as arrays of samples, read from PGM or PBM files by libnetpbm. */
#ifndef MPMLAB_IMAGE_H
#define MPMLAB_IMAGE_H

#include <stddef.h>
#include <stdint.h>
#include "fault.h"

enum { GREY_LIGHT = 65535 };

/* Samples from 0 (dark) to GREY_LIGHT, axis 0 (to the right) fastest, then axis 1 (upwards: the
 * last row of a file is row 0 here), then axis 2 (the slices of a stack). */
typedef struct Image {
    int n[3]; /* n[2] is 1 for a single image */
    uint16_t *grey;
    unsigned long checksum; /* CRC-32 of the files' bytes, one after the other */
} Image;

/* An image of samples GREY_LIGHT. 0: no memory. */
int image_new(Image *out, const int n[3]);
void image_free(Image *image);

static inline size_t image_at(const Image *im, int i, int j, int k)
{
    return ((size_t)k * (size_t)im->n[1] + (size_t)j) * (size_t)im->n[0] + (size_t)i;
}

/* Reads the PGM or PBM file `path`; with `stack`, path is a pattern with one %d or %0Nd for the
 * number of the slice, which starts at 0 or 1 and ends before the first file that does not exist.
 * 0 or a fault (2: not such an image; 1: memory), and nothing to be freed then. */
int image_read(Image *out, const char *path, int stack, Fault *fault);

#endif
