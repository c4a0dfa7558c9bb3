/* reaction.h -- the action of the particles on the fluid.
 * Chapter "The coupled loop".
 *
 * transfer.c calls these in two-way coupling only: in one-way coupling the
 * particles do not act on the fluid. All of them work on sim->coupling.
 */
#ifndef COUPLING_REACTION_H
#define COUPLING_REACTION_H

#include "coupling/simulation.h"

/* eps_s and eps_s u_s from the particles where they are now [XS11 3.12, SX15
 * 9]; then eps_f at each particle. Non-zero if a cell is full. */
int reaction_average(struct simulation *sim);

/* K and F of the next fluid step, from the k of each particle [XS11 3.15]. */
void reaction_drag_terms(struct simulation *sim);

/* Gathers the new velocity with the weights of the averaging, and subtracts the
 * impulse that the fluid received in its step from the unpaid impulse of each
 * particle. */
void reaction_receive(struct simulation *sim);

/* The share s [-] of the reaction to an added mass that the fluid receives in
 * the same step, for C [-], the added mass over that of the fluid in the place
 * of a particle, `ratio` [-], the particle's mass over that, and the solids
 * fraction eps_s, below 1. With it both roots of (20.10) are the same, and no
 * other share has a smaller largest one; 0 for particles that are too light. */
double reaction_share_in_advance(double C, double ratio, double eps_s);

#endif
