/* energy.h -- where the energy of the particles is, and where it goes.
 * Chapter 15.
 *
 *   kinetic + normal + tangential
 *       + damped_n + damped_t + slid + released + rolled
 *     = work + attracted + walls + brought
 *
 * up to the error of the integrator. Kept only where it is asked for.
 */
#ifndef ENERGY_H
#define ENERGY_H

#include "particles/neighbours.h"

struct energy {
    /* Now there. */
    double kinetic;            /* [J] of translation and rotation, and of
                                  the fluid that is taken along */
    double normal, tangential; /* [J] in the springs of the contacts */
    /* Gone since the first run. */
    double damped_n, damped_t; /* [J] in the dashpots */
    double slid;               /* [J] by friction where it slides */
    double released;           /* [J] by tangential springs that turn, part, or
                                  soften as the overlap shrinks; less what they
                                  gain as it grows */
    double rolled;             /* [J] against rolling friction */
    /* Come since then. */
    double work;      /* [J] of the outside forces: gravity, the fluid */
    double attracted; /* [J] work of the attractions; what they took is given
                         back where they do not change on the way */
    double walls;     /* [J] of surfaces that move, and of what moves the
                         particles that move as prescribed */
    double brought;   /* [J] by what was put in, taken out or given other
                         velocities between two runs */
};

/* The left side less the right one [J]. */
double energy_residual(const struct energy *e);

/* All but `brought`, out of the strips as they are; elastic: the share of
 * force times overlap that a law stores. */
struct energy energy_collect(const struct neighbours *nb, double elastic);

#endif
