/* omega.h: the highest frequency of a bar on the grid, and the time step that it suggests.
 *
 * With tents and a last particle eps inside a cell (n particles per cell) the far node has
 * m = rho (h/n) eps/h and stiffness E/(n h), so that M^-1 K has omega = c/sqrt(eps h). */
#ifndef MPMLAB_OMEGA_H
#define MPMLAB_OMEGA_H

/* 2/omega_max [h/c], omega^2 the eigenvalues of M^-1 K with lumped masses, of a bar of so many
 * cells with `per_cell` particles in each and a method's weights; its last particle lies `beyond`
 * cells behind a node. */
double omega_step_limit(const char *method, int cells, int per_cell, double beyond);

#endif
