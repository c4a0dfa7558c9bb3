/* smoothing.h -- averaging over the cells of all ranks.
 * Chapter "Past one machine".
 *
 * A particle counts in the cell of its centre, which may be one of the layers:
 * the sums of the layers go to their owners. The diffusion is the series of
 * exp(-T L) (linear/chebyshev.h), for it needs no sum over all cells: each
 * product with L reads one layer of neighbours.
 */
#ifndef DISTRIBUTED_RANKS_SMOOTHING_H
#define DISTRIBUTED_RANKS_SMOOTHING_H

#include "averaging/averaging.h"
#include "distributed/ranks/partition.h"

/* The context of the method, which averaging_options.parts is. */
struct smoothing {
    struct halo *h;
    const struct mesh *mesh;
    double bandwidth; /* [m] 0: no diffusion */
    double tolerance; /* [-] of the series */
};

extern const struct averaging_method smoothing_method;

#endif
