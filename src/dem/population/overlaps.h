/* overlaps.h -- spheres that overlap before time 0.
 * Chapter "Insertion, removal and energy".
 *
 * A contact stores k delta^2 / 2, so spheres that overlap strongly at the start
 * separate at high speed. Such a case is either refused, or the spheres are
 * moved apart first: each overlapping pair along its line of centres, each
 * sphere by half of the overlap, repeatedly for all pairs and walls until no
 * overlap is left.
 */
#ifndef DEM_POPULATION_OVERLAPS_H
#define DEM_POPULATION_OVERLAPS_H

#include "dem/box_domain.h"
#include "dem/particles.h"

/* An overlap of more than this part of the mean diameter of the two is too deep
 * for a start [-]. */
#define OVERLAPS_MAX 0.01

struct overlap {
    int i, j;     /* [-] indices; j = -1: none */
    double depth; /* [-] over the mean diameter of the two */
};

/* The deepest of all pairs, nearest images. */
struct overlap overlaps_deepest(const struct particles *ps,
                                const struct box_domain *box);

/* Moves spheres apart until no overlap is deeper than OVERLAPS_MAX. Returns
 * the number of rounds, or -1 if `most` rounds were not sufficient. */
int overlaps_relax(struct particles *ps, const struct box_domain *box,
                   int most);

#endif
