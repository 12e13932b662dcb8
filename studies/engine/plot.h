/* plot.h: figures by gnuplot from what a study left on disk. */
#ifndef MPMLAB_PLOT_H
#define MPMLAB_PLOT_H

#include "gnuplot.h"
#include "studies/study.h"

enum { PLOT_NO_GNUPLOT = GNUPLOT_ABSENT };

/* The folder of scripts and page.html, plots or share/mpmlab/plots in the nearest folder above the
 * program that has it; NULL if absent. */
const char *plot_folder(void);

/* Draws dir/NAME.svg and .png with plots/ROOM/NAME.gp if they are older than what they are made
 * from. 0 (also if the study has no script), PLOT_NO_GNUPLOT, 130: a signal asked to stop; or a
 * fault: the script failed. */
int plot_study(const Study *study, const char *dir, Fault *fault);

#endif
