/* progress.c: a bar, done/total and the time left. */
#include "progress.h"

#include <stdio.h>
#include <unistd.h>
#include "common/base/stopwatch.h"

Progress progress_start(const char *title, int total)
{
    return (Progress){title, isatty(STDERR_FILENO) ? total : 0, stopwatch_wall(), 0};
}

void progress_draw(Progress *p, int done)
{
    static const char full[] = "##############################";
    enum { WIDTH = sizeof full - 1 };
    double time = stopwatch_wall();
    if (p->total == 0 || time - p->drawn < 0.1) return;
    p->drawn = time;
    int filled = (int)((long)done * WIDTH / p->total);
    double left = done ? (time - p->start) * (p->total - done) / done : 0;
    fprintf(stderr, "\r\033[K%s [%.*s%*s] %d/%d", p->title, filled, full, WIDTH - filled, "", done,
            p->total);
    if (done) fprintf(stderr, "  %d:%02d left", (int)left / 60, (int)left % 60);
    fflush(stderr);
}

void progress_end(const Progress *p)
{
    if (p->total) fprintf(stderr, "\r\033[K");
}
