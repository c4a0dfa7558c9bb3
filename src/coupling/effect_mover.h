/* effect_mover.h -- what an effect moves that is neither fluid nor particle.
 * Chapter "The coupled loop".
 */
#ifndef COUPLING_EFFECT_MOVER_H
#define COUPLING_EFFECT_MOVER_H

struct simulation;

struct effect_mover {
    /* Moves it by a step, after fluid and particles; non-zero if the
     * computation broke down. failure: how it did, or NULL if it did not. */
    int (*move)(void *memory, struct simulation *sim);
    const char *(*failure)(const void *memory);
    /* Moves the particles by so many steps, and itself with them, in place of
     * dem_run; `move` then has nothing left to do. Non-zero as dem_run. NULL:
     * it does not move with the particles. */
    int (*move_particles)(void *memory, struct simulation *sim, int steps);
    /* Adds its momentum [N s] to the sum that is conserved in a closed box. */
    void (*momentum)(const void *memory, double total[3]);
};

#endif
