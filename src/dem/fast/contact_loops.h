/* contact_loops.h -- the compiled loops of the contact laws. Chapter "Particles
 * and contact".
 *
 * Hertz's law and the linear one have compiled loops. Any other law runs in a
 * loop that calls its `respond` for each contact, which is slower.
 */
#ifndef DEM_FAST_CONTACT_LOOPS_H
#define DEM_FAST_CONTACT_LOOPS_H

#include "dem/fast/chunk.h"

/* Adds the forces of contacts first ... last - 1 of a chunk of particles to its
 * loads; the springs advance by dt [s]. With several materials k is a table:
 * row a, column b for materials a and b. */
typedef void contact_sweep(struct chunk *s, const struct bodies *b,
                           const struct contact_constants *k, double dt,
                           int first, int last);

/* Options of a contact loop; each law has a compiled loop for every
 * combination, so that unused options cost nothing. */
enum {
    CONTACT_PERIODIC = 1,       /* there are periodic directions */
    CONTACT_MULTI_MATERIAL = 2, /* constants by a table of material pairs */
    CONTACT_ROLLING = 4,        /* rolling friction; only with the table */
    CONTACT_BUDGET = 8,         /* energy budget; only with the table */
    CONTACT_LOOPS = 16
};

/* The loop of a law with these options. */
contact_sweep *contact_loops_of(const struct contact_law *law, int options);

#endif
