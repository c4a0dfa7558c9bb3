/* integrators.h -- time integrators of the particles. Chapter 15.
 *
 * With a(x, v) the acceleration by all forces:
 *
 *   velocity Verlet   v += a dt/2,  x += v dt,  v += a dt/2
 *   symplectic Euler  v += a dt,    x += v dt
 *   Heun              x*, v* = x + v dt, v + a dt
 *                     x += (v + v*) dt/2,  v += (a + a*) dt/2
 *
 * The second is the first with another first and another last kick: in between
 * both go kick, drift, kick, drift. Heun (LS section 4.2: HADES) needs the
 * forces twice, and a third time for the rates of tangential springs.
 */
#ifndef DEM_INTEGRATORS_H
#define DEM_INTEGRATORS_H

#include "base/key.h"
#include "dem/fast/chunk.h"

struct integrator {
    const char *name;                   /* as a case spells it */
    const char *what;                   /* one line */
    const char *equations;              /* keys in chapters/references.md */
    const char *function;               /* the one that computes it */
    const struct key *keys[KEY_TABLES]; /* tables of the keys it reads */
    double first, last; /* [-] of a step that the first and last kick take */
    int predicts;       /* [-] 1: Heun */
};

/* All of them, ended by NULL, the default first; NULL for an unknown name. */
extern const struct integrator *const integrators[];
const struct integrator *integrators_named(const char *name);

/* The state at the beginning of a step of Heun's method. */
struct integrators_start {
    double (*position_radius)[4]; /* [m] */
    double (*velocity)[8];        /* as in bodies.h */
    double (*load)[8];            /* [N] as in chunk.h */
};

struct integrators_start *integrators_start_create(int capacity);
void integrators_start_free(struct integrators_start *h);

/* integrators_save_start saves the state, integrators_predict moves to x*, v*,
 * and integrators_correct moves from there, with the loads at x*, v*, to the
 * end of the step. The largest speeds of the chunk are then bounds of both. */
void integrators_save_start(struct integrators_start *h, const struct chunk *s,
                            const struct bodies *b);
void integrators_predict(const struct integrators_start *h,
                         const struct chunk *s, struct bodies *b, double dt);
void integrators_correct(const struct integrators_start *h, struct chunk *s,
                         struct bodies *b, double dt);

#endif
