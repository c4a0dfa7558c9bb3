/* neighbours.h -- makes the lists of pairs, and makes them anew.  Chapter 2. */
#ifndef NEIGHBOURS_H
#define NEIGHBOURS_H

#include "particles/bins.h"
#include "particles/pair_list.h"
#include "particles/particles.h"

struct neighbours {
    double skin; /* [m] */
    int periodic[3];
    struct pair_list pairs, walls;
    struct bins *bins;
    int *row;             /* [-] capacity + 1; first pair of particle i */
    int *place;           /* [-] where the sort has put a particle */
    struct pair_list old; /* touching contacts carried over */
    double *x0, *y0, *z0; /* [m] where the particles were then */
};

/* Lists for spheres up to diameter d_max [m] in the box low .. high. */
struct neighbours *neighbours_create(const struct particles *ps,
                                     const double low[3], const double high[3],
                                     const int periodic[3], double skin,
                                     double d_max);
void neighbours_free(struct neighbours *nb);

/* Wraps the particles into periodic directions, sorts them, and lists all
 * pairs closer than touching plus skin. Touching pairs keep their springs. */
void neighbours_rebuild(struct neighbours *nb, struct particles *ps);

/* How far a particle has moved at most since then [m]. */
double neighbours_moved(const struct neighbours *nb,
                        const struct particles *ps);

#endif
