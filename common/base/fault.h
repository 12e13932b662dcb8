/* fault.h: a failure as a value: an exit status and one line of text for the user. */
#ifndef MPMLAB_FAULT_H
#define MPMLAB_FAULT_H

enum { FAULT_NONE = 0, FAULT_MACHINE = 1, FAULT_USAGE = 2, FAULT_INTERRUPTED = 130 };

typedef struct Fault {
    int code;       /* FAULT_*: the exit status that goes with it */
    char text[512]; /* one line, names the culprit, no newline */
} Fault;

/* Fills *f (which may be NULL) and returns code: callers write `return fault_set(...)`. */
int fault_set(Fault *f, int code, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* "what: why", why the last system call failed (errno): FAULT_MACHINE. */
int fault_machine(Fault *f, const char *what);

/* Adds "; did you mean 'NAME'?" with the name in `names` (n of them) that is nearest to `got` by
 * edit distance, if one is near; `dashes` stand before it. Returns FAULT_USAGE. */
int fault_did_you_mean(Fault *f, const char *dashes, const char *got, const char *const *names,
                       int n);

#endif
