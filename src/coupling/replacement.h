/* replacement.h -- insertion and removal of particles in a coupled run.
 * Chapter "The coupled loop".
 *
 * An inserted particle replaces the same volume of fluid, and fluid replaces a
 * removed particle, immediately and in the same cells: this causes no flow and
 * no change of pressure. (If the fluid had
 * to flow out of the way within one step instead, a grain would cause a jet,
 * and in a closed box there would be no solution.) The unpaid impulse of a
 * removed particle acts on the fluid in the next step, in the cells where the
 * particle was. Therefore
 *
 *   momentum of fluid and particles - unpaid - (inserted - removed)
 *
 * is conserved as in a run without insertion and removal.
 */
#ifndef COUPLING_REPLACEMENT_H
#define COUPLING_REPLACEMENT_H

#include "coupling/simulation.h"

struct replacement {
    double *eps_before; /* [-] fluid fraction before insertion and removal */
    double *unpaid_impulse; /* [N s/m^3] impulse of removed particles that has
                               not acted on the fluid yet, 3 a cell */
    double unpaid_sum[3];   /* [N s] its integral; 0 after it has acted */
};

struct replacement *replacement_create(int n_cells);
void replacement_free(struct replacement *r);

/* Called before the marked particles are removed: stores their unpaid impulse.
 */
void replacement_collect_unpaid(struct simulation *sim);

/* After particles were removed, or inserted from index `first` on: averages
 * anew, replaces the fluid, and makes the drag terms of the next step. Non-zero
 * if the solid volume of a cell exceeds its volume. */
int replacement_apply(struct simulation *sim, int first);

/* Subtracts the unpaid impulse from the force F of the fluid's next step, given
 * as rows of 4 a cell (K, F) [N/m^3]. */
void replacement_add_force(const struct replacement *r, int n_cells, double dt,
                           double *field);

/* Called after the step of the fluid: the impulse has acted. */
void replacement_reset(struct replacement *r, int n_cells);

/* Momentum of inserted minus that of removed particles since the run began,
 * including the fluid that they replaced [N s]. */
void replacement_momentum(const struct simulation *sim, double brought[3]);

#endif
