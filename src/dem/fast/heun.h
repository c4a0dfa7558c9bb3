/* heun.h -- Heun's method on the chunks of the fast loop. Chapter "Insertion,
 * removal and energy".
 *
 *   x*, v* = x + v dt, v + a dt
 *   x += (v + v*) dt/2,  v += (a + a*) dt/2
 */
#ifndef DEM_FAST_HEUN_H
#define DEM_FAST_HEUN_H

#include "dem/fast/chunk.h"

/* The state at the beginning of a step of Heun's method. */
struct heun {
    double (*position_radius)[4];    /* [m] */
    double (*velocity)[8];           /* as in bodies.h */
    double (*load)[8];               /* [N] as in chunk.h */
    double (*part)[ENERGY_PARTS][8]; /* likewise; NULL without a budget */
};

struct heun *heun_create(int capacity);
void heun_free(struct heun *h);

/* heun_save_start saves the state, heun_predict moves to x*, v*,
 * and heun_correct moves from there, with the loads at x*, v*, to the
 * end of the step. The largest speeds of the chunk are then bounds of both. */
void heun_save_start(struct heun *h, const struct chunk *s,
                     const struct bodies *b);
void heun_predict(const struct heun *h, const struct chunk *s, struct bodies *b,
                  double dt);
void heun_correct(const struct heun *h, struct chunk *s, struct bodies *b,
                  double dt);

#endif
