/* grain_series.h -- the drag coefficients of all grains, in time.
 * Chapter "Agitation". */
#ifndef RECORD_GRAIN_SERIES_H
#define RECORD_GRAIN_SERIES_H

#include "base/state.h"
#include "coupling/simulation.h"

struct grain_series {
    int capacity;        /* [-] of grains */
    int n, rows, n_rows; /* [-] grains, room, samples so far */
    int changed;         /* [-] 1: grains came or went after the first sample,
                            and there are no more */
    double *Cd;          /* [-] rows of each grain, by its id: n * rows */
    double *Re, *eps;    /* [-] the same at the last sample, n each */
};

struct grain_series *grain_series_create(int capacity, int rows);
void grain_series_free(struct grain_series *g);

/* C_d [EW18 26] of the whole force, the drag over eps, with the coefficient
 * that the fluid is charged with, and Re_p [EW18 27]. The grains are those of
 * the first sample, with the numbers 0, 1, ...: when one has been inserted or
 * removed there are no more samples. */
void grain_series_add(struct grain_series *g, const struct simulation *sim);
void grain_series_state(struct grain_series *g, struct state *s);

#endif
