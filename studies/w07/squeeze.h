/* squeeze.h: what the squeeze figures of W07 share. */
#ifndef MPMLAB_SQUEEZE_H
#define MPMLAB_SQUEEZE_H

#include "studies/tables/curves.h"

/* The squeeze from 0.5 to 10 particles per cell, `step` particles apart (quick: 25 times that). */
void squeeze_add(Cases *list, const char *method, const char *field, int cells, int step,
                 bool quick);

/* Figs 6 and 9: the quadratic field on 1/100 cells, by these methods ("mpm gimp"), one particle
 * apart; and the error that the grid alone sets there, h^2/6/(1 + h)^2. */
enum { SQUEEZE_CELLS = 100, SQUEEZE_POINTS = 951 };
void squeeze_add_quadratic(Cases *list, const char *methods, bool quick);
double squeeze_plateau(void);

/* Errors against particles per cell: that at ten of them over (1 + 1/200) times the plateau. */
Measure squeeze_at_ten(const Curve *c);

/* Exponent of PPC in what the errors exceed `least` by, from PPC 2 to 10: of the largest in each
 * interval of this width. */
Measure squeeze_exponent(const Curve *c, double width, double least);

#endif
