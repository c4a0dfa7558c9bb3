/* dem_inside.h -- what the files behind dem.h share.  Chapter 2. */
#ifndef DEM_INSIDE_H
#define DEM_INSIDE_H

#include "particles/dem.h"
#include "particles/energy.h"
#include "particles/neighbours.h"

struct dem {
    struct dem_options options;
    struct contact_constants *constants; /* of each pair of materials */
    contact_sweep *sweep;
    struct neighbours *neighbours;
    double least_margin;             /* [m] */
    long done;                       /* [-] steps of the run at hand */
    long tick;                       /* [-] steps of the surfaces' clock */
    int ticking;                     /* [-] 1: it runs */
    double overlap;                  /* [-] largest of the last run */
    double expected, most;           /* [-] overlaps (dem_limit_overlap) */
    struct energy *energy;           /* NULL: no budget is kept */
    struct integrators_start *start; /* NULL: not Heun */
};

/* So many steps, by one thread of the team. */
void dem_move(struct dem *dem, int steps);

#endif
