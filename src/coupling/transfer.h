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

/* Starts the sums over the sub-steps. */
void transfer_begin_substeps(struct simulation *sim);

/* Adds the drag of a sub-step to the external force of each particle, and to
 * the unpaid impulse as far as it is known [XS11 3.18]. The external force so
 * far is the held one; `steps` particle steps follow, then
 * transfer_end_substep. */
void transfer_begin_substep(struct simulation *sim, int steps);
void transfer_end_substep(struct simulation *sim, int steps);

/* --- reaction ------------------------------------------------------------- */

/* The action of the particles on the fluid.
 *
 * transfer.c calls these in two-way coupling only: in one-way coupling the
 * particles do not act on the fluid. All of them work on sim->coupling. */

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

/* --- replacement ---------------------------------------------------------- */

/* Insertion and removal of particles in a coupled run.
 *
 * An inserted particle replaces the same volume of fluid, and fluid replaces a
 * removed particle, immediately and in the same cells: this causes no flow and
 * no change of pressure. (If the fluid had to flow out of the way within one
 * step instead, a grain would cause a jet, and in a closed box there would be
 * no solution.) The unpaid impulse of a removed particle acts on the fluid in
 * the next step, in the cells where the particle was. Therefore
 *
 *   momentum of fluid and particles - unpaid - (inserted - removed)
 *
 * is conserved as in a run without insertion and removal. */

/* Those of sim->population (dem/population/population.h). */
extern const struct population_functions replacement_functions;

/* After particles were removed, or inserted from index `first` on: averages
 * anew, replaces the fluid, and makes the drag terms of the next step. Non-zero
 * if the solid volume of a cell exceeds its volume. */
int replacement_apply(struct simulation *sim, int first);

/* Momentum of inserted minus that of removed particles since the run began,
 * including the fluid that they replaced [N s]. */
void replacement_momentum(const struct simulation *sim, double brought[3]);

#endif
