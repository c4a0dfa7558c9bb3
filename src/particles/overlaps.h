/* overlaps.h -- spheres that are in each other before time 0.  Chapter 15.
 *
 * A contact stores k delta^2 / 2, so spheres that are put deep into each other
 * fly apart. Either that is a mistake, or they are to be moved apart first:
 * each overlapping pair along its line of centres, by half of the overlap each,
 * walls and pairs again and again until none is left.
 */
#ifndef OVERLAPS_H
#define OVERLAPS_H

#include "particles/bodies.h"

/* An overlap of more than this part of the mean diameter of the two is too deep
 * for a start [-]. */
#define OVERLAPS_MOST 0.01

struct overlap {
    int i, j;     /* [-] indices; j = -1: none */
    double depth; /* [-] over the mean diameter of the two */
};

/* The deepest of all pairs, nearest images. Looks at every pair. */
struct overlap overlaps_deepest(const struct particles *ps,
                                const struct domain *box);

/* Moves them apart until none is deeper than OVERLAPS_MOST; the rounds that it
 * took, or -1 if so many did not do: there is no room. */
int overlaps_relax(struct particles *ps, const struct domain *box, int most);

#endif
