/* time_scheme.h -- schemes for the time derivative of momentum.
 * Chapter "The flow, verified".
 *
 *   dt d(eps u)/dt = now (eps u)^(n+1) - old (eps u)^n + older (eps u)^(n-1)
 *
 * The weights satisfy now - old + older = 0, so that a constant has no
 * derivative. A scheme also gives the factor of extrapolation for quantities
 * that lag by a step, such as the convecting flux: x + ahead (x - x_older).
 */
#ifndef FLUID_TIME_SCHEME_H
#define FLUID_TIME_SCHEME_H

#include "base/model.h"

struct time_weights {
    double now, old, older; /* [-] */
    double ahead;           /* [-] */
};

struct time_scheme {
    MODEL_MEMBERS;   /* base/model.h */
    int time_levels; /* [-] number of old time levels: 1 or 2 */
    /* [-] of a gain of 1 in a step, what the steps after it add, all as long,
     * without a force: the sum of (older / now)^n. */
    double pending;
    /* r: this step over the one before it; 0 where there is none. */
    struct time_weights (*weights)(double r /* [-] */);
};

/* All schemes, ended by NULL, the default first; NULL for an unknown name. */
extern const struct time_scheme time_scheme_euler, time_scheme_bdf2;
extern const struct time_scheme *const time_schemes[];
const struct time_scheme *time_scheme_named(const char *name);

#endif
