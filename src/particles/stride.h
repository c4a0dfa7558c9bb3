/* stride.h -- one time step of a thread's strips.  Chapter 3.
 *
 * A strip is worked through in blocks of particles: the contacts that a block
 * owns, then its motion, while all of it is still in the cache. Particles on
 * which strips of other threads lay loads move when every thread has laid its
 * loads. The order of all sums is the same for any number of threads.
 */
#ifndef STRIDE_H
#define STRIDE_H

#include "particles/attraction.h"
#include "particles/contact.h"
#include "particles/neighbours.h"

struct stride {
    contact_sweep *sweep;
    const struct contact_constants *constants;
    const struct attraction *attractions;
    int n_attractions;
    int driven;         /* [-] 1: driven particles go where they should */
    double t;           /* [s] time that the places are of, for them */
    int budget;         /* [-] 1: of energy (energy.h) */
    double dt;          /* [s] the springs move on; 0: loads alone */
    double kick, drift; /* [s] the velocities do, and the places */
};

/* Loads and motion; every thread of the team calls it. All meet in the end. */
void stride_take(struct neighbours *nb, const struct stride *by);

/* Motion alone, from the loads that there are. The same. */
void stride_move(struct neighbours *nb, const struct stride *by);

#endif
