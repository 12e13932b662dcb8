/* gnuplot.h: runs gnuplot without a shell, for a limited time. */
#ifndef MPMLAB_GNUPLOT_H
#define MPMLAB_GNUPLOT_H

#include "common/base/fault.h"

enum { GNUPLOT_ABSENT = -1 };

/* Runs `gnuplot -e set script`, which may write to the open file `out`. 0; GNUPLOT_ABSENT; 130: a
 * signal asked to stop; or a fault with gnuplot's last message. Nothing of it is left running. */
int gnuplot_run(const char *set, const char *script, int out, Fault *fault);

#endif
