/* contact.h: what the scenes with two bodies share: the parameters of their contact. */
#ifndef MPMLAB_CONTACT_SCENE_H
#define MPMLAB_CONTACT_SCENE_H

#include "common/contract/problem.h"

/* The first parameters of such a scene. */
enum { P_CONTACT, P_MU, CONTACT_PARAMS };

#define CONTACT_PARAM_LIST(mu)                                                                     \
    {"contact",                                                                                    \
     CONTACT_BARDENHAGEN,                                                                          \
     0,                                                                                            \
     1,                                                                                            \
     "",                                                                                           \
     "at shared nodes: Coulomb contact, or one velocity for both bodies, which makes them stick",  \
     "Bardenhagen et al. 2001",                                                                    \
     "bardenhagen|none"},                                                                          \
    {                                                                                              \
        "mu", mu, 0, 1e3, "", "coefficient of friction", "Bardenhagen et al. 2001", NULL           \
    }

static inline void contact_read(Scene *s)
{
    s->contact = (ContactLaw)s->par[P_CONTACT];
    s->friction = s->par[P_MU];
}

#endif
