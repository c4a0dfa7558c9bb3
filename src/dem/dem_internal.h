/* dem_internal.h -- what the files behind dem.h share.
 * Chapter "Particles and contact". */
#ifndef DEM_DEM_INTERNAL_H
#define DEM_DEM_INTERNAL_H

#include "dem/dem.h"
#include "dem/energy.h"
#include "dem/fast/neighbours.h"

struct dem {
    struct dem_options options;
    struct contact_constants *constants; /* of each pair of materials */
    contact_sweep *sweep;
    struct neighbours *neighbours;
    double min_margin;               /* [m] */
    long steps_done;                 /* [-] steps of the run at hand */
    long motion_steps;               /* [-] steps of the surfaces' clock */
    int motion_on;                   /* [-] 1: it runs */
    double max_overlap;              /* [-] largest of the last run */
    double expected, most;           /* [-] overlaps (dem_limit_overlap) */
    struct energy *energy;           /* NULL: no budget is kept */
    struct integrators_start *start; /* NULL: not Heun */
};

/* So many steps, by one thread of the team. */
void dem_move(struct dem *dem, int steps);

#endif
