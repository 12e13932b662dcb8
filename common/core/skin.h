/* skin.h: the loaded part of the surface (W11 eq 3, int w.tau dGamma): points that carry shares of
 * its area, and the traction on them. */
#ifndef MPMLAB_SKIN_H
#define MPMLAB_SKIN_H

#include "common/base/stash.h"
#include "common/contract/problem.h"

struct Sim;
typedef struct Skin Skin;

/* Makes the points of a scene with traction; *out stays NULL in one without. false: no memory. */
bool skin_new(Skin **out, const struct Sim *sim, double spacing);
void skin_free(Skin *skin);

/* Adds the forces of time t to the grid's, after a deposit with forces. */
void skin_deposit(struct Sim *sim, double t);

/* Moves the points with the grid velocity of the step from t to t + dt and adds up their work. */
void skin_move(struct Sim *sim, double t, double dt);

/* What steps change of it, for a checkpoint. */
void skin_stash(Skin *skin, Stash *s);

/* The points of one made for the same scene, as they are, for a hand-over. */
void skin_take_over(Skin *to, const Skin *from);

/* [J] work of the traction so far. */
double skin_work(const Skin *skin);

#endif
