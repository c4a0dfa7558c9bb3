/* chunk_step.h -- one time step of the chunks of a thread.
 * Chapter "Neighbours".
 *
 * A chunk is processed in blocks of particles: first the contacts that a block
 * owns, then its motion, while the data are still in the cache. Particles that
 * receive loads from chunks of other threads move after all threads have
 * computed their loads. The order of all sums is the same for any number of
 * threads.
 */
#ifndef DEM_FAST_CHUNK_STEP_H
#define DEM_FAST_CHUNK_STEP_H

#include "dem/attraction.h"
#include "dem/fast/neighbours.h"

struct step_parameters {
    const struct contact_constants *constants;
    const struct attraction *attractions;
    int n_attractions;
    int prescribed; /* [-] 1: prescribed particles move */
    double t;       /* [s] time of the positions, for them */
    int budget;     /* [-] 1: of energy (energy.h) */
    double dt; /* [s] step of the tangential displacements; 0: loads alone */
    double kick, drift; /* [s] step of the velocities, and of the positions */
    double from; /* [-] of the kick, from where on the budget counts it */
};

/* Computes loads and motion. Every thread of the team calls it; it ends with a
 * barrier. */
void chunk_step_load_and_move(struct neighbours *nb,
                              const struct step_parameters *by);

/* Computes the motion alone, from the present loads; called by all threads,
 * too. */
void chunk_step_move(struct neighbours *nb, const struct step_parameters *by);

#endif
