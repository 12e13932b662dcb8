/* bare_loops.h: two plain particle loops, timed beside the core by `make bench`. */
#ifndef MPMLAB_BARE_LOOPS_H
#define MPMLAB_BARE_LOOPS_H

typedef enum { BARE_MLS, BARE_GIMP } BareLoop;

/* CPU time of one particle-step [ns], the whole loop included; NAN: out of memory. `kept`: angular
 * momentum of the block after so many steps over that before. */
double bare_ns(BareLoop which, int cells, int steps, double *kept);

#endif
