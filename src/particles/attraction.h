/* attraction.h -- forces between particles that need no touching. Chapter 17.
 *
 * Beside the contact act, along the line of centres, forces that reach as far
 * as a gap `range`: each law one file, each scene the ones it names. They are
 * added to the loads after the contacts, pair by pair of the vicinity, which
 * is made wider by the longest range; without any there is neither a longer
 * list nor a loop. Coulomb's cap knows only the contact force [LS 4.8]: where
 * cohesion pulls two spheres together the contact pushes back by as much, and
 * so the cap grows by mu times the cohesion all the same.
 */
#ifndef ATTRACTION_H
#define ATTRACTION_H

struct bodies;
struct strip;
struct attraction_law;

/* A law at work. What a law does not use is 0. */
struct attraction {
    const struct attraction_law *law;
    double range;         /* [m] longest gap at which it acts */
    double strength;      /* eps_r [-]; A [J]; gamma cos theta [N/m] */
    double closest;       /* [m] gap below which van der Waals' force stays */
    int harmonic;         /* [-] 1: R* of a capillary is the harmonic mean */
    const double *charge; /* [C] of a sphere, by material; borrowed */
};

/* Adds the forces on and by the particles of a strip to its loads. */
typedef void attraction_sweep(struct strip *s, const struct bodies *b,
                              const struct attraction *a);

struct attraction_law {
    const char *name; /* as a case spells it in `effects` */
    attraction_sweep *sweep;
};

#endif
