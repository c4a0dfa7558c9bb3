/* energy.h -- the energy budget of the particles.
 * Chapter "Insertion, removal and energy".
 *
 *   kinetic + normal + tangential
 *       + damped_n + damped_t + slid + released + rolled
 *     = work + attracted + walls + added
 *
 * up to the error of the integrator. It is computed only if a case needs it.
 */
#ifndef DEM_ENERGY_H
#define DEM_ENERGY_H

#include "base/state.h"

/* Parts of the loads on a particle that the budget needs by themselves. A load
 * acts in a kick, and its work is its product with the mean of the velocities
 * before and after: then kinetic energy and work agree to rounding, and what is
 * left is the error of the springs' and dashpots' own energy, of second order.
 */
enum {
    ENERGY_DASHPOTS, /* the normal ones; and the moments of rolling friction */
    ENERGY_DASHPOTS_T, /* the tangential ones of contacts that stick */
    ENERGY_FRICTION,   /* tangential springs, or Coulomb's limit */
    ENERGY_ATTRACTIONS,
    ENERGY_PARTS
};

struct energy {
    /* The present energy. */
    double kinetic; /* [J] of translation and rotation, and of the added mass */
    double normal, tangential; /* [J] in the springs of the contacts */
    /* Losses since the first run. */
    double damped_n, damped_t; /* [J] in the dashpots */
    double slid;               /* [J] by friction where it slides */
    double released;           /* [J] by tangential springs, where the contact
                                  turns or ends and where k_t falls with the
                                  overlap; less what they gain as it grows */
    double rolled;             /* [J] against rolling friction */
    /* Gains since then. */
    double work;      /* [J] of the external forces: gravity, the fluid */
    double attracted; /* [J] work of the attractions, returned on separation
                         where the force is conservative */
    double walls;     /* [J] of moving surfaces, and of the forces that keep
                         particles in their prescribed motion */
    double added; /* [J] by particles that were inserted, removed or given other
                     velocities between two runs */
};

/* Visits all terms (state.h). */
void energy_state(struct energy *e, struct state *s);

/* The left side less the right one [J]. */
double energy_residual(const struct energy *e);

#endif
