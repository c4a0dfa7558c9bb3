/* dem_internal.h -- what dem.h and its methods share.
 * Chapter "Particles and contact". */
#ifndef DEM_DEM_INTERNAL_H
#define DEM_DEM_INTERNAL_H

#include "dem/dem.h"
#include "dem/dem_method.h"
#include "dem/energy.h"

struct dem {
    struct dem_options options;
    struct particles *ps;                /* borrowed */
    struct contact_constants *constants; /* of each pair of materials */
    const struct dem_method *method;
    void *state;                /* of the method */
    long motion_steps;          /* [-] steps of the surfaces' clock */
    int motion_on;              /* [-] 1: it runs */
    double max_overlap;         /* [-] largest of the last run */
    struct dem_overlap deepest; /* of all runs, and its limits */
    struct energy *energy;      /* NULL: no budget is kept */
};

/* 1 if it is time to look for a signal after step k of a run: about every 1e5
 * steps of a particle, which take some ms, and not in each step. A run that
 * ends there has fewer steps than it was asked for, and its state is not whole.
 * Without the clock, as where a bed settles, the caller looks between runs. */
static inline int dem_looks(const struct dem *dem, int k)
{
    return dem->motion_on && k % (2 + 100000 / (dem->ps->n + 1)) == 1;
}

/* Mean diameter of the particles [m]; 0 without any. */
double dem_mean_diameter(const struct particles *ps);

/* The smallest [m]; HUGE_VAL without any. */
double dem_least_diameter(const struct particles *ps);

/* Largest gap [m] at which a force acts. */
double dem_range(const struct dem_options *o);

#endif
