/* sizes_internal.h -- what the distributions of diameters share. */
#ifndef DEM_POPULATION_SIZES_INTERNAL_H
#define DEM_POPULATION_SIZES_INTERNAL_H

#include "dem/population/sizes.h"

/* Diameters from a to b, spread with a density that goes as d^-falling; all of
 * one size where a is b. */
struct piece {
    double a, b;  /* [m] */
    double below; /* [-] share of the particles in the pieces before it */
    double share; /* [-] of the particles, in this one */
};

struct sizes {
    const struct sizes_law *law;
    double min, max;           /* [m] */
    double own[MODEL_NUMBERS]; /* of the keys that the law alone reads */
    /* normal, of d [m]; lognormal, of ln(d / 1 m) [-] */
    double mu, sigma;
    double low, high; /* [-] shares of the whole bell below the cut-offs */
    /* uniform, discrete, table */
    int n, falling;
    struct piece *piece;
};

/* Keys that several distributions read: min and max; and by. */
extern const struct key sizes_range_keys[];
extern const struct key sizes_by_keys[];

extern const struct sizes_law sizes_uniform, sizes_normal, sizes_lognormal,
    sizes_discrete, sizes_table;

#endif
