/* gnuplot.c: starts it, waits for it, ends it when it takes too long or the user wants to stop. */
#define _GNU_SOURCE /* memfd_create */
#include "gnuplot.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include "signals.h"
#include "common/base/stopwatch.h"

enum { LIMIT = 120 /* [s] */, NOT_FOUND = 127, KILLED = 256, TOO_LATE, STOPPED };

static _Noreturn void become(const char *set, const char *script, int out, int log,
                             const Signals *signals)
{
    char *const argv[] = {"gnuplot", "-e", (char *)set, (char *)script, NULL};
    int nothing = open("/dev/null", O_RDONLY);
    setpgid(0, 0);                    /* ended with all that it starts */
    prctl(PR_SET_PDEATHSIG, SIGKILL); /* and with us */
    dup2(nothing, STDIN_FILENO);
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    fcntl(out, F_SETFD, 0);
    signals_release(signals);
    execvp(argv[0], argv);
    _exit(errno == ENOENT ? NOT_FOUND : NOT_FOUND - 1);
}

/* Its exit status, or why it has none. */
static int wait_for(pid_t pid, const Signals *signals)
{
    int status, why = TOO_LATE;
    for (double left = LIMIT, end = stopwatch_wall() + left; left > 0;
         left = end - stopwatch_wall()) {
        if (waitpid(pid, &status, WNOHANG) == pid)
            return WIFEXITED(status) ? WEXITSTATUS(status) : KILLED;
        if (!signals_wait(signals, left < 0.1 ? left : 0.1)) continue;
        why = STOPPED;
        break;
    }
    kill(-pid, SIGKILL);
    kill(pid, SIGKILL);
    waitpid(pid, &status, 0);
    return why;
}

/* The last line that gnuplot wrote: what went wrong. */
static void last_line(int log, char line[256])
{
    char text[4096];
    off_t size = lseek(log, 0, SEEK_END), most = sizeof text - 1;
    ssize_t n = pread(log, text, sizeof text - 1, size > most ? size - most : 0);
    text[n > 0 ? n : 0] = '\0';
    while (n > 0 && strchr(" \t\r\n", text[n - 1])) text[--n] = '\0';
    const char *last = strrchr(text, '\n');
    snprintf(line, 256, "%.255s", last ? last + 1 + strspn(last + 1, " \t") : text);
}

static int say(int status, const char *script, const char *line, Fault *fault)
{
    if (status == 0) return 0;
    if (status == NOT_FOUND) return GNUPLOT_ABSENT;
    if (status == STOPPED)
        return fault_set(fault, FAULT_INTERRUPTED, "interrupted; a re-run continues from here");
    if (status == TOO_LATE)
        return fault_set(fault, FAULT_MACHINE, "%.200s: gnuplot did not end within %d s", script,
                         LIMIT);
    return fault_set(fault, FAULT_MACHINE, "%.200s: %s", script, *line ? line : "gnuplot failed");
}

int gnuplot_run(const char *set, const char *script, int out, Fault *fault)
{
    Signals signals;
    char line[256] = "";
    int log = memfd_create("gnuplot", MFD_CLOEXEC);
    signals_hold(&signals);
    pid_t pid = fork();
    if (pid == 0) become(set, script, out, log, &signals);
    int status = pid > 0 ? wait_for(pid, &signals) : KILLED;
    if (status != 0 && status < TOO_LATE && signals_wait(&signals, 0)) status = STOPPED;
    signals_release(&signals);
    last_line(log, line);
    close(log);
    return say(status, script, line, fault);
}
