/* active_effect.h -- an effect that a case names, while the case runs.
 * Chapter "The coupled loop".
 */
#ifndef COUPLING_ACTIVE_EFFECT_H
#define COUPLING_ACTIVE_EFFECT_H

struct effect;

/* The forces that an effect has exerted. */
struct effect_tally {
    double sum;     /* [N] of their sizes, over particles and steps */
    double largest; /* [N] on one particle */
    double weight;  /* [-] number of these */
    double seconds; /* [s] wall-clock time in its hooks */
};

/* An active effect: its descriptor and its state. */
struct effect_state {
    const struct effect *effect;
    void *memory; /* released by effect->free; may be NULL */
    struct effect_tally tally;
};

#endif
