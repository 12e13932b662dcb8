/* run_files.h: the options of a run that name files to be written, each of them another file. */
#ifndef MPMLAB_RUN_FILES_H
#define MPMLAB_RUN_FILES_H

#include "run_args.h"

/* Takes the path of --option: 0, or a fault if another option has it. -1: no such option. */
int run_files_take(RunArgs *args, const char *option, const char *got, Fault *fault);

/* After all are taken: is none of them one that a run writes besides, FILE.1 of --checkpoint or a
 * snapshot of --vtk? 0 or a fault. */
int run_files_check(const RunArgs *args, Fault *fault);

#endif
