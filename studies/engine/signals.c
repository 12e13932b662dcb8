/* signals.c: see signals.h. */
#include "signals.h"
#include <fcntl.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
#include "common/base/fault.h"

void signals_hold(Signals *s)
{
    sigemptyset(&s->waited);
    sigaddset(&s->waited, SIGCHLD);
    sigaddset(&s->waited, SIGINT);
    sigaddset(&s->waited, SIGTERM);
    sigaddset(&s->waited, SIGHUP);
    sigprocmask(SIG_BLOCK, &s->waited, &s->before);
}

void signals_release(const Signals *s)
{
    sigprocmask(SIG_SETMASK, &s->before, NULL);
}

bool signals_wait(const Signals *s, double seconds)
{
    const struct timespec time = {.tv_sec = (time_t)seconds,
                                  .tv_nsec = (long)(1e9 * (seconds - (double)(time_t)seconds))};
    int got = sigtimedwait(&s->waited, NULL, &time);
    return got == SIGINT || got == SIGTERM || got == SIGHUP;
}

/* Files appear whole, so there is nothing to clean up. */
static void interrupted(int number)
{
    static const char line[] = "mpmlab: interrupted\n";
    (void)number;
    ssize_t n = write(STDERR_FILENO, line, sizeof line - 1);
    (void)n;
    _exit(FAULT_INTERRUPTED);
}

static volatile sig_atomic_t noted;

static void note(int number)
{
    (void)number;
    noted = 1;
    signal(SIGINT, interrupted);
    signal(SIGTERM, interrupted);
    signal(SIGHUP, interrupted);
}

const volatile sig_atomic_t *signals_note(void)
{
    signal(SIGINT, note);
    signal(SIGTERM, note);
    if (signal(SIGHUP, note) == SIG_IGN) signal(SIGHUP, SIG_IGN); /* nohup */
    return &noted;
}

void signals_start(void)
{
    /* A closed stream's number must not become that of a table; writing there is an error. */
    while (fcntl(STDIN_FILENO, F_GETFD) < 0 || fcntl(STDOUT_FILENO, F_GETFD) < 0 ||
           fcntl(STDERR_FILENO, F_GETFD) < 0)
        if (open("/dev/null", O_RDONLY) < 0) break;
    signal(SIGINT, interrupted);
    signal(SIGTERM, interrupted);
    if (signal(SIGHUP, interrupted) == SIG_IGN) signal(SIGHUP, SIG_IGN); /* nohup */
    signal(SIGCHLD, SIG_DFL); /* ignored, children could not be waited for */
    signal(SIGXFSZ, SIG_IGN); /* a file at its size limit is a full disk, said as such */
}
