/* transfer.h -- the parts of the coupled step.
 * Chapter "The coupled loop".
 *
 * coupling.c calls them in order. All of them work on sim->coupling.
 */
#ifndef COUPLING_TRANSFER_H
#define COUPLING_TRANSFER_H

#include "coupling/simulation.h"

/* [-] number of particles above which a second thread is faster */
enum { TRANSFER_MANY = 1000 };

/* eps_s and eps_s u_s from the particles where they are now [XS11 3.12, SX15
 * 9]; then eps_f at each particle. Non-zero if a particle is outside the mesh,
 * or if a cell is full. */
int transfer_average(struct simulation *sim);

/* Computes eps_s u_s after a step for output: in the void-rate form the loop
 * itself does not need it. */
void transfer_solids_velocity(const struct simulation *sim);

/* k of each particle for the present slip, and from it what the next fluid
 * step needs: K and F [XS11 3.15]. */
void transfer_drag_terms(struct simulation *sim);

/* Interpolates the fluid velocity to each particle [XS11 3.9], and subtracts
 * the impulse that the fluid received in its step from the unpaid impulse of
 * each particle. */
void transfer_fluid(struct simulation *sim);

/* The fluid's velocity [m/s] at each particle by the chosen interpolation, into
 * u_f, 3 a particle. */
void transfer_velocity(struct simulation *sim, double *u_f);

/* The size of the drag on particle i after transfer_drag_terms [N]. */
double transfer_drag(const struct simulation *sim, int i);

/* The mean velocity of the particles from index `first` on is their own. */
void transfer_start_velocity(struct simulation *sim, int first);

/* Starts the sums over the sub-steps. */
void transfer_begin_substeps(struct simulation *sim);

/* Adds the drag of a sub-step to the external force of each particle, and to
 * the unpaid impulse as far as it is known [XS11 3.18]. The external force so
 * far is the held one; `steps` particle steps follow, then
 * transfer_end_substep. */
void transfer_begin_substep(struct simulation *sim, int steps);
void transfer_end_substep(struct simulation *sim, int steps);

#endif
