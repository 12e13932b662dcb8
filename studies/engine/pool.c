/* pool.c: workers fork once, then take cases from a shared counter: a case costs no fork. */
#define _GNU_SOURCE
#include "pool.h"

#include <errno.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include "studies/runs/must.h"
#include "progress.h"
#include "signals.h"

enum { MOST_JOBS = 1024, IDLE = -1 };

/* In memory that all processes share. */
typedef struct Shared {
    atomic_int next, done, failed, stop;
    atomic_int running[MOST_JOBS]; /* index into todo, or IDLE */
    Fault first;                   /* written by whoever makes `failed` 1 */
} Shared;

typedef struct Pool {
    const Cases *cases;
    const int *todo;
    int n, jobs, fd;
    const char *path;
    Shared *shared;
    pid_t pid[MOST_JOBS];
    Signals signals;
} Pool;

static void report(Shared *s, const char *what, const char *why)
{
    if (atomic_fetch_add(&s->failed, 1) == 0)
        fault_set(&s->first, FAULT_MACHINE, "%.200s: %.250s", what, why);
}

static void run_one(const Pool *p, const Case *c)
{
    Row row = row_empty();
    Fault fault = {0};
    char text[ROW_TEXT];
    if (c->engine->run(&c->spec, &row, &fault)) {
        report(p->shared, c->command, fault.text);
        return;
    }
    row_print(&row, text);
    int error = journal_append(p->fd, c->key, text);
    if (!error) return;
    report(p->shared, p->path, strerror(error));
    p->shared->stop = 1;
}

static _Noreturn void work(const Pool *p, int worker, pid_t parent)
{
    Shared *s = p->shared;
    prctl(PR_SET_PDEATHSIG, SIGKILL); /* the journal's lock must not outlive the study */
    signal(SIGINT, SIG_IGN);          /* from a terminal: the parent decides */
    signal(SIGHUP, SIG_IGN);
    signal(SIGTERM, SIG_DFL);
    signals_release(&p->signals);
    while (!s->stop && getppid() == parent) {
        int k = atomic_fetch_add(&s->next, 1);
        if (k >= p->n) break;
        s->running[worker] = k;
        run_one(p, &p->cases->list[p->todo[k]]);
        s->running[worker] = IDLE;
        atomic_fetch_add(&s->done, 1);
    }
    _exit(0);
}

static int start(Pool *p, int worker)
{
    pid_t parent = getpid();
    p->shared->running[worker] = IDLE;
    p->pid[worker] = fork();
    if (p->pid[worker] == 0) work(p, worker, parent);
    if (p->pid[worker] < 0) report(p->shared, "fork", strerror(errno));
    return p->pid[worker] > 0;
}

/* Collects workers that ended; reports and replaces one that crashed. How many are left. */
static int reap(Pool *p)
{
    int left = 0, status;
    for (int w = 0; w < p->jobs; w++) {
        if (p->pid[w] <= 0) continue;
        if (waitpid(p->pid[w], &status, WNOHANG) != p->pid[w]) {
            left++;
            continue;
        }
        p->pid[w] = 0;
        int k = p->shared->running[w];
        if (k == IDLE || p->shared->stop) continue;
        char why[64];
        if (WIFSIGNALED(status))
            snprintf(why, sizeof why, "died of signal %d", WTERMSIG(status));
        else
            snprintf(why, sizeof why, "ended with status %d", WEXITSTATUS(status));
        report(p->shared, p->cases->list[p->todo[k]].command, why);
        atomic_fetch_add(&p->shared->done, 1);
        left += start(p, w);
    }
    return left;
}

static void stop_workers(Pool *p)
{
    p->shared->stop = 1;
    for (int w = 0; w < p->jobs; w++)
        if (p->pid[w] > 0) kill(p->pid[w], SIGTERM);
    for (int w = 0; w < p->jobs; w++)
        if (p->pid[w] > 0) waitpid(p->pid[w], NULL, 0);
}

/* Sleeps until a worker ends, a signal comes, or it is time to draw. 130 if asked to stop. */
static int watch(Pool *p, Progress *progress)
{
    while (reap(p) > 0) {
        bool stop = signals_wait(&p->signals, 0.1);
        progress_draw(progress, p->shared->done);
        if (!stop) continue;
        stop_workers(p);
        return FAULT_INTERRUPTED;
    }
    return 0;
}

static int outcome(const Shared *s, Fault *fault)
{
    char more[64] = "";
    if (!s->failed) return 0;
    if (s->failed > 1) snprintf(more, sizeof more, " (and %d more)", s->failed - 1);
    return fault_set(fault, FAULT_MACHINE, "%.440s%s", s->first.text, more);
}

int pool_run(const Cases *cases, const int *todo, int n, int jobs, const Journal *journal,
             const char *path, const char *title, Fault *fault)
{
    Shared *shared =
        mmap(NULL, sizeof *shared, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (n == 0) jobs = 0;
    if (shared == MAP_FAILED) return fault_set(fault, FAULT_MACHINE, "no shared memory");
    Pool p = {.cases = cases,
              .todo = todo,
              .n = n,
              .jobs = jobs < n ? jobs : n,
              .fd = journal->fd,
              .path = path,
              .shared = shared};
    Progress progress = progress_start(title, n);
    signals_hold(&p.signals);
    for (int w = 0; w < p.jobs; w++) start(&p, w);
    int code = watch(&p, &progress);
    signals_release(&p.signals);
    progress_end(&progress);
    if (code)
        fault_set(fault, code, "interrupted; a re-run continues from here");
    else
        code = outcome(shared, fault);
    munmap(shared, sizeof *shared);
    return code;
}
