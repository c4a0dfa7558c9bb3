/* bins.h -- particles sorted into boxes a little larger than they reach.
 * Chapter 2.
 *
 * Bins are numbered slowest along the longest side of the box, so that
 * particles sorted by bin lie in layers across it.
 */
#ifndef BINS_H
#define BINS_H

#include "particles/particles.h"

struct bins {
    int n[3];      /* [-] bins per direction */
    int stride[3]; /* [-] in the number of a bin */
    int periodic[3];
    double low[3]; /* [m] */
    double per[3]; /* [1/m] bins per length */
    int total;
    int *start; /* [-] total + 1; first particle of a bin, once sorted */
    int *bin;   /* [-] of each particle */
    int *order; /* [-] the sort: place i takes particle order[i] */
};

/* Bins at least `reach` wide in the box low .. high; never more than a few per
 * particle. */
struct bins *bins_create(const double low[3], const double high[3],
                         const int periodic[3], double reach, int capacity);
void bins_free(struct bins *b);

/* Finds the bin of each particle and the order that sorts them. */
void bins_sort(struct bins *b, const struct particles *ps);

/* The bins around bin c, itself among them, each once; returns how many. */
int bins_around(const struct bins *b, int c, int around[27]);

#endif
