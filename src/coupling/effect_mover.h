/* effect_mover.h -- what an effect moves that is neither fluid nor particle.
 * Chapter "The coupled loop".
 */
#ifndef COUPLING_EFFECT_MOVER_H
#define COUPLING_EFFECT_MOVER_H

struct simulation;

struct effect_mover {
    /* Moves it by a step, after fluid and particles; non-zero if it broke down,
     * and trouble then says how, else NULL. */
    int (*move)(void *memory, struct simulation *sim);
    const char *(*trouble)(const void *memory);
    /* NULL, or what moves the particles by so many steps, and itself along with
     * them; then `move` has nothing left to do. Non-zero as of dem_run. */
    int (*along)(void *memory, struct simulation *sim, int steps);
    /* Adds its momentum [N s] to the sum that a closed box keeps. */
    void (*momentum)(const void *memory, double total[3]);
};

#endif
