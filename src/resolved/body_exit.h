/* body_exit.h -- bodies that leave the box through an outlet.
 * Chapter "Resolving the grains".
 *
 * An outlet is no wall to a body. What acts on the part of it that is outside
 * is not known: so, while it passes, it goes on with the velocity and spin that
 * it came with. Once it is wholly outside it has left: it is at rest, and
 * touches nothing. One that only turns out of it is moved by what is inside.
 */
#ifndef RESOLVED_BODY_EXIT_H
#define RESOLVED_BODY_EXIT_H

#include "resolved/solid_bodies.h"

struct body_exit {
    int open[6];         /* [-] sides 2 k, 2 k + 1: 1 for an outlet */
    double lo[3], hi[3]; /* [m] of the fluid */
    double way;          /* [m] from an outlet to where bodies end */
    int *gone, n_gone;   /* [-] 1: on its way out, 2: it has left; how many */
};

/* NULL if there is no outlet, or all bodies are held; then also nothing of the
 * contacts' box changes, which else reaches beyond the outlets. */
struct body_exit *body_exit_create(struct solid_bodies *b,
                                   const struct fluid *fl);
void body_exit_free(struct body_exit *e);
void body_exit_state(struct solid_bodies *b, struct state *s);

/* Takes out those that are wholly outside. */
void body_exit_look(struct solid_bodies *b);

/* 1 if the face of the box with the area S is an outlet; e may be NULL. */
int body_exit_is_open(const struct body_exit *e, const double S[3]);

#endif
