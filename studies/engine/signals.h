/* signals.h: waiting for a child, a time or a request to stop, without a race. */
#ifndef MPMLAB_SIGNALS_H
#define MPMLAB_SIGNALS_H

#include <signal.h>
#include <stdbool.h>

typedef struct Signals {
    sigset_t waited, before;
} Signals;

/* Holds back SIGINT, SIGTERM, SIGHUP and SIGCHLD, so that they can be waited for. */
void signals_hold(Signals *s);
void signals_release(const Signals *s);

/* Waits until one comes, at most `seconds`. Was it a request to stop? */
bool signals_wait(const Signals *s, double seconds);

/* From now on the first SIGINT, SIGTERM or SIGHUP only makes the result different from 0; the next
 * one ends the program. */
const volatile sig_atomic_t *signals_note(void);

/* The program's start: what the parent process left ignored or closed must not reach a file. */
void signals_start(void);

#endif
