/* transfer.h -- the moves of the coupled step.  Chapter 10.
 *
 * For coupling.c, which puts them in order. All work on sim->coupling.
 */
#ifndef TRANSFER_H
#define TRANSFER_H

#include "exchange/simulation.h"

/* eps_s and eps_s u_s from the particles where they are now [XS11 3.12, SX15
 * 9]; then eps_f at each particle. Non-zero if a particle is outside. */
int transfer_average(struct simulation *sim);

/* Makes sure of eps_s u_s after a step: in the void-rate form nothing in the
 * loop asks for it, and it is averaged for those who look. */
void transfer_solids_velocity(const struct simulation *sim);

/* k of each particle for the present slip, and from it what the next fluid
 * step needs: K and F [XS11 3.15]. */
void transfer_drag_terms(struct simulation *sim);

/* The fluid's velocity at each particle [XS11 3.9]; and what the fluid paid in
 * its step, for each particle, is taken off what it owed. */
void transfer_fluid(struct simulation *sim);

/* The fluid's velocity [m/s] at each particle by the chosen interpolation, into
 * u_f, 3 a particle. */
void transfer_velocity(struct simulation *sim, double *u_f);

/* Starts the sums over the sub-steps. */
void transfer_open_account(struct simulation *sim);

/* Adds the drag of a sub-step to the outside force of each particle, and to
 * what is owed as far as it is known [XS11 3.18]. The outside force so far is
 * the held one; `steps` particle steps follow, then transfer_collect_drag. */
void transfer_apply_drag(struct simulation *sim, int steps);
void transfer_collect_drag(struct simulation *sim, int steps);

#endif
