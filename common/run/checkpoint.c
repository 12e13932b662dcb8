/* checkpoint.c: the state of a run on disk (loop.h). What a state consists of: stash_loop. */
#include "loop.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include "common/base/stopwatch.h"
#include "common/base/saved.h"
#include "common/base/table.h"

/* All numbers of the loop that go on from step to step. */
static void stash_numbers(Loop *l, Stash *s)
{
    STASH(s, l->dt);
    STASH(s, l->dt_before);
    STASH(s, l->t);
    STASH(s, l->n);
    STASH(s, l->done);
    STASH(s, l->steps.cpu);
    STASH(s, l->steps.wall);
    STASH(s, l->worst);
    STASH(s, l->start);
    STASH(s, l->now);
    STASH(s, l->largest);
    STASH(s, l->base);
    STASH(s, l->most);
    STASH(s, l->counted);
    STASH(s, l->noise);
    STASH(s, l->instants);
    STASH(s, l->bodies);
    STASH(s, l->work);
    STASH(s, l->p0);
    STASH(s, l->drift);
    STASH(s, l->momentum);
    STASH(s, l->growth_step);
    STASH(s, l->growth_t);
    STASH(s, l->fastest);
    STASH(s, l->speed);
    STASH(s, l->earlier);
    STASH(s, l->given);
    STASH(s, l->taken_at);
    STASH(s, l->reactions);
}

/* Positions and body forces by id, where work is recorded. */
static void stash_loads(Loop *l, Stash *s)
{
    Points p;
    Samples q;
    long n = 0;
    l->plan->solver->view(l->self, &p, &q);
    for (int k = 0; k < p.n; k++) n += p.id[k] >= 0;
    if (stash_same(s, l->loads ? n : 0) && l->loads)
        stash_bytes(s, l->loads, sizeof *l->loads * (size_t)n);
}

/* A history goes on with the columns that it has. */
static void stash_probes(const Loop *l, Stash *s)
{
    Probes p = l->probes;
    STASH(s, p.n);
    STASH(s, p.id);
    if (!s->load || !l->history || s->bad) return;
    s->bad = p.n != l->probes.n || memcmp(p.id, l->probes.id, sizeof p.id) != 0;
    if (s->bad) s->why = "other points of --probe";
}

/* The history so far is part of the state, since its file appears at the end only. */
static void stash_history(Loop *l, Stash *s)
{
    long n = 0;
    if (!s->load && l->history && (fflush(l->history) != 0 || (n = ftell(l->history)) < 0))
        s->bad = true;
    STASH(s, n);
    if (!s->bad && s->load && l->history && n == 0) s->why = "no --history";
    char *text = s->bad || s->why || n < 0 ? NULL : malloc((size_t)n + 1);
    s->bad = s->bad || !text;
    if (!s->bad && !s->load && n > 0) {
        rewind(l->history);
        s->bad = fread(text, 1, (size_t)n, l->history) != (size_t)n;
        fseek(l->history, n, SEEK_SET);
    }
    if (!s->bad) stash_bytes(s, text, (size_t)n);
    if (!s->bad && s->load && l->history)
        s->bad = fwrite(text, 1, (size_t)n, l->history) != (size_t)n;
    free(text);
}

static void stash_time(Loop *l, Stash *s)
{
    double spent = l->save.spent + stopwatch_wall() - l->save.began;
    STASH(s, spent);
    if (s->load) l->save.spent = spent;
}

static void stash_loop(Loop *l, Moment *m, Side *before, Stash *s)
{
    long taken_over = l->taken_over;
    STASH(s, taken_over);
    if (s->load && taken_over >= 0 && !s->bad) s->bad = !relay_go_on(l);
    l->taken_over = taken_over;
    if (s->bad) return;
    stash_time(l, s);
    stash_numbers(l, s);
    STASH(s, *m);
    STASH(s, *before);
    l->plan->solver->stash(l->self, s);
    if (!s->bad) stash_loads(l, s);
    if (!s->bad) snapshot_stash(&l->shots, s);
    if (!s->bad) stash_history(l, s);
    if (!s->bad) stash_probes(l, s);
}

void checkpoint_write(Loop *l, Moment *m, Side *before, bool now)
{
    const double t = stopwatch_wall();
    if (!l->save.path || l->code || (!now && t - l->save.last < l->save.every_s)) return;
    const SavedKey key = {l->save.command, l->save.program};
    stopwatch_read(&l->steps);
    errno = 0;
    Stash s = {.f = saved_begin(l->save.path, &key, l->fault)};
    l->code = s.f ? 0 : FAULT_MACHINE;
    if (l->code) return;
    stash_loop(l, m, before, &s);
    if (s.bad) {
        l->code = fault_set(l->fault, FAULT_MACHINE, "%s: %s", l->save.path,
                            strerror(errno ? errno : EIO));
        file_abandon(s.f, l->save.path);
    } else {
        l->code = saved_commit(s.f, l->save.path, l->fault);
    }
    l->save.last = stopwatch_wall();
}

int checkpoint_read(Loop *l, Moment *m, Side *before)
{
    const SavedKey key = {l->save.command, l->save.program};
    Stash s = {.f = saved_open(l->save.resume, &key, NULL, l->fault), .load = true};
    if (!s.f) return FAULT_USAGE;
    errno = 0;
    stash_loop(l, m, before, &s);
    fclose(s.f);
    m->nprobe = l->probes.n;
    if (!s.bad) return snapshot_go_on(&l->shots, l->fault);
    if (s.why)
        return fault_set(l->fault, FAULT_USAGE, "--resume: got '%s', a checkpoint of a run with %s",
                         l->save.resume, s.why);
    return fault_set(l->fault, FAULT_MACHINE, "%s: %s", l->save.resume,
                     strerror(errno ? errno : EIO));
}
