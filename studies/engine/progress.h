/* progress.h: one line on standard error while a study runs, if that is a terminal. */
#ifndef MPMLAB_PROGRESS_H
#define MPMLAB_PROGRESS_H

typedef struct Progress {
    const char *title;
    int total;           /* 0: draw nothing */
    double start, drawn; /* [s] */
} Progress;

Progress progress_start(const char *title, int total);
void progress_draw(Progress *p, int done); /* at most ten times a second */
void progress_end(const Progress *p);

#endif
