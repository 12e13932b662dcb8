/* row.h: the result of one run: the columns every table of the testbed starts with.
 * A number that means nothing for a run is NAN and is printed as an empty cell. */
#ifndef MPMLAB_ROW_H
#define MPMLAB_ROW_H

#include <stddef.h>

enum { ROW_TEXT = 2048 };

typedef struct Row {
    char problem[32], method[32], integrator[16];
    double cells, h, ppc, cfl, particles, nodes, steps, t_end;
    double error_linf, error_l2, error_l1, energy_drift, momentum_drift;
    char status[16];
    double cpu_s, wall_s, ns_per_particle_step;
    double dt;
    char layout[16], params[512], reason[192];
    double surface_particles, elements, fallbacks;
    double ppc_asked;  /* of a layout whose real `ppc` came out otherwise; repeats the run */
    double wall_run_s; /* of the whole run: set-up, norms, ledger and files included */
    double particle_bytes, node_bytes; /* memory of a particle, of a live node (not FEM) */
} Row;

/* A row with every number NAN and every text empty. */
Row row_empty(void);

/* One line of comma-separated text without newline; numbers as the shortest decimal that reads
 * back. Returns its length. */
int row_header(char out[ROW_TEXT]);
int row_print(const Row *row, char out[ROW_TEXT]);

/* Number of columns, and their names in order; timing columns differ from run to run. */
int row_columns(void);
const char *row_column_name(int k);
int row_column_is_timing(int k);

/* One cell as row_print writes it; with this the tests compare rows cell by cell. Returns its
 * length. */
int row_cell(const Row *row, int k, char out[ROW_TEXT]);

#endif
