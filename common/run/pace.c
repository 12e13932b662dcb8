/* pace.c: the time step of a run, constant or anew for every step (loop.h). */
#include <math.h>
#include "loop.h"

void pace_choose(Loop *l)
{
    const Plan *plan = l->plan;
    const double unit =
        plan->solver->unit_dt ? plan->solver->unit_dt(l->self) : plan->scene.cell / plan->scene.c;
    const double n = fmax(ceil(plan->t_end / (plan->cfl * unit) - 1e-9), 1);
    l->unit_dt = unit;
    l->dt = plan->t_end / n;
    l->n = plan->steps > 0 && (double)plan->steps < n ? plan->steps : (long)n;
}

/* W11 eq 34: CFL h/(v_max + max |v_p|), but at least a thousandth of the step of a body at rest:
 * else a run that diverges would take ever smaller steps and never end. */
static double longest_step(const Loop *l)
{
    Points p;
    Samples q;
    double speed;
    const Plan *plan = l->plan;
    const double c = material_wave_speed_bound(&plan->scene.mat),
                 length = l->unit_dt * plan->scene.c;
    plan->solver->view(l->self, &p, &q);
    ledger_fastest_point(&p, &speed);
    return plan->cfl * length / (c + fmin(fmax(speed, 0), 999 * c));
}

void pace_adapt(Loop *l)
{
    const double left = l->plan->t_end - l->t, longest = longest_step(l);
    l->dt_before = l->done > 0 ? l->dt : 0;
    l->dt = left <= 0 ? longest : left <= longest ? left : fmin(longest, 0.5 * left);
}

bool pace_is_over(const Loop *l)
{
    if (!l->plan->adaptive) return l->done >= l->n;
    return l->t >= l->plan->t_end || (l->plan->steps > 0 && l->done >= l->plan->steps);
}

double pace_end_of_step(const Loop *l)
{
    if (!l->plan->adaptive) return (double)(l->done + 1) * l->dt;
    return l->dt >= l->plan->t_end - l->t ? l->plan->t_end : l->t + l->dt;
}

double pace_share_after(const Loop *l)
{
    return l->dt_before > 0 ? l->dt_before / (l->dt_before + l->dt) : 0.5;
}
