/* vtk_file.h: point clouds and polygons as VTK XML files (.vtp) for ParaView, and collections of
 * them over time (.pvd). Arrays are appended in base64 behind the XML, so that the file is valid
 * XML and exact. Files appear whole or not at all. */
#ifndef MPMLAB_VTK_FILE_H
#define MPMLAB_VTK_FILE_H

#include <stdint.h>
#include "fault.h"

typedef enum { VTK_F64, VTK_I64, VTK_U8 } VtkType;

/* A named array of `components` numbers per point or cell. data NULL: not written. */
typedef struct VtkArray {
    const char *name;
    VtkType type;
    int components; /* 1 scalar, 3 vector, 9 tensor */
    const void *data;
} VtkArray;

/* Nothing here is owned. Without cells every point is drawn as a vertex. */
typedef struct VtkData {
    double t;                 /* [s] */
    int64_t points;           /* number of points */
    const double *x;          /* [points][3] */
    int64_t cells;            /* number of polygons; -1: a cloud of points */
    const int64_t *corner;    /* [end[cells - 1]] points around each polygon, one after the other */
    const int64_t *end;       /* [cells] where the corners of each polygon end */
    const VtkArray *on_point; /* ended by a NULL name, or NULL */
    const VtkArray *on_cell;
} VtkData;

/* 0 or a fault (1: memory, disk). */
int vtk_file_write(const char *path, const VtkData *data, Fault *fault);

/* A collection: n files named STEM_000012.vtp (step[k] = 12) in path's own folder, at times t [s].
 */
int vtk_file_collect(const char *path, const char *stem, int n, const long step[], const double t[],
                     Fault *fault);

#endif
