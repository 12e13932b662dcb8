/* relay.c: the hand-over from one method to the next during a run (loop.h). The ledger goes on: the
 * energy is the particles', the impulse of walls and body forces the sum over both methods. */
#include "loop.h"

static Volumes volumes_now(const Loop *l)
{
    Points p;
    Samples q;
    l->plan->solver->view(l->self, &p, &q);
    return ledger_volumes(&q);
}

/* Is a particle broken? */
static bool is_broken(const Loop *l)
{
    Points p;
    Samples q;
    bool any = false;
    l->plan->solver->view(l->self, &p, &q);
    for (int k = 0; k < q.n; k++) any |= p.id[k] >= 0 && !(q.strength[k] > 0);
    return any;
}

bool relay_is_due(const Loop *l)
{
    const Handover *h = &l->handover;
    if (l->taken_over >= 0) return false;
    if (h->at == AT_RUPTURE) return is_broken(l);
    if (h->at == AT_TIME) return l->t >= h->value * (1 - 1e-12);
    return h->at == AT_J && volumes_now(l).least < h->value;
}

/* The second method's solver in the place of the first one's. */
static bool change_to(Loop *l, void *next)
{
    l->plan->solver->free(l->self);
    loop_close(l);
    l->self = next;
    l->plan = &l->handover.plan;
    if (!loop_fit_scratch(l) || !loop_open(l))
        l->code = fault_set(l->fault, FAULT_MACHINE, "out of memory");
    return !l->code;
}

bool relay_go_on(Loop *l)
{
    const Plan *plan = &l->handover.plan;
    void *next = l->handover.at != AT_NEVER ? plan->solver->make(&plan->setup, l->fault) : NULL;
    return next && change_to(l, next);
}

bool relay_take_over(Loop *l, Side *before)
{
    const Solver *solver = l->plan->solver;
    Vec impulse;
    void *next = solver->take_over(&l->handover.plan.setup, l->self, l->fault);
    if (!next) {
        l->code = l->fault ? l->fault->code : FAULT_MACHINE;
        return false;
    }
    solver->counts(l->self, &l->earlier);
    solver->impulse(l->self, impulse);
    for (int d = 0; d < DIM; d++) l->given[d] += impulse[d];
    l->taken_over = l->done;
    l->taken_at = l->t;
    l->reactions = (Reactions){{0}}; /* what the second method's walls give starts at nothing */
    if (!change_to(l, next)) return false;
    *before = loop_measure_side(l);
    return true;
}

void relay_before_step(Loop *l)
{
    if (l->handover.at != AT_INVERTED || l->taken_over >= 0) return;
    if (!l->undo.f && !(l->undo.f = tmpfile())) return; /* no file: the run ends as INVERTED */
    rewind(l->undo.f);
    l->undo.load = l->undo.bad = false;
    l->plan->solver->stash(l->self, &l->undo);
}

bool relay_rescues(Loop *l, Side *before)
{
    if (l->handover.at != AT_INVERTED || l->taken_over >= 0 || l->status.code != INVERTED ||
        !l->undo.f || l->undo.bad)
        return false;
    rewind(l->undo.f);
    l->undo.load = true;
    l->plan->solver->stash(l->self, &l->undo);
    return !l->undo.bad && relay_take_over(l, before);
}
