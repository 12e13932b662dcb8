/* bounce.c: see bounce.h. */
#include "bounce.h"

#include <math.h>
#include "studies/select.h"

Bounce bounce_read(const Table *t, BounceNeeds needs)
{
    const double E0 = t->nrow ? select_number(t, 0, "total") : NAN;
    Bounce b = {E0,  measure_min_of(needs.fall), NAN, measure_max_of(needs.back),
                NAN, measure_max_of(needs.whole)};
    double before = NAN, when = NAN;
    for (int k = 0; k < t->nrow; k++) {
        const double now = select_number(t, k, "t"), kinetic = select_number(t, k, "kinetic") / E0;
        const double total = select_number(t, k, "total");
        if (now < 1.6 && kinetic < b.least.value) b.at = now;
        if (now < 1.6) measure_add_min(&b.least, kinetic);
        if (now <= 2.3) measure_add_max(&b.over, total / E0 - 1);
        if (now >= 2.3 && isnan(b.back))
            b.back = before / E0 + (total / E0 - before / E0) * (2.3 - when) / (now - when);
        if (k > 0) measure_add_max(&b.jump, fabs(total - before) / E0);
        before = total;
        when = now;
    }
    return b;
}
