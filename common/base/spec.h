/* spec.h: what one run is asked to do, as typed; and the same with every default filled. */
#ifndef MPMLAB_SPEC_H
#define MPMLAB_SPEC_H

#include <signal.h>
#include "fault.h"

enum { SPEC_SETS = 32, SPEC_TEXT = 6144, SETTING_TEXT = 128, SPEC_PROBES = 16, PROBE_COLUMNS = 9 };

/* A place in the reference body [m], with as many coordinates as were typed. */
typedef struct Probe {
    double X[3];
    int axes;
    const char *text; /* as typed; not owned */
} Probe;

typedef struct Setting {
    char name[32], value[SETTING_TEXT];
} Setting;

/* Zeroed fields ("" or 0) mean: not given, take the default. All run inputs are finite and
 * positive. */
typedef struct RunSpec {
    char problem[32], method[32], integrator[16];
    double cells; /* per unit length, whole */
    double ppc;   /* particles per cell */
    double cfl;
    double t_end;                            /* [s] */
    int threads;                             /* 0: one */
    int nset;                                /* settings from --set, in the order given; */
    Setting set[SPEC_SETS];                  /*   problem, method and run parameters */
    const char *history, *particles, *nodes; /* output files of this run, or NULL; not owned */
    const char *samples;                     /* what carries strain: elements, or particles */
    const char *errors;                      /* every point's error at the end, or NULL */
    const char *patches;                     /* polygons of cells or elements, or NULL */
    const char *checkpoint, *resume;         /* files of the run's state: out, in; or NULL */
    double save_s;                           /* [s] between two states; 0: 60 */
    unsigned long program;                   /* that a state belongs to */
    const char *vtk;                         /* folder for snapshots, or NULL */
    int every;                               /* steps between snapshots; */
    double every_s;                          /*   or time between them [s] */
    const volatile sig_atomic_t *stop; /* not 0: the run ends with the step under way; or NULL */
    int nprobe;                        /* points whose motion the history follows */
    Probe probe[SPEC_PROBES];
} RunSpec;

/* Adds NAME=VALUE to the settings (replacing an earlier NAME). 0, or a fault with code 2. */
int spec_set(RunSpec *spec, const char *name_value, Fault *fault);

/* The value of a setting as text, or NULL. */
const char *spec_get(const RunSpec *spec, const char *name);

/* The command-line arguments that make this run ("run bar --method gimp ..."), only what is given,
 * settings sorted by name, threads only if several, no output files: equal inputs give equal text,
 * which is a run's key. */
void spec_command(const RunSpec *spec, char out[SPEC_TEXT]);

/* Can each output file of the run be written, for all that can be told without doing it? 0, or a
 * fault that names the first one that cannot. */
int spec_files_check(const RunSpec *spec, Fault *fault);

#endif
