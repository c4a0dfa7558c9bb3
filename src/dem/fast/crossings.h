/* crossings.h -- finds two particles that have passed through each other.
 * Chapter "Time steps". */
#ifndef DEM_FAST_CROSSINGS_H
#define DEM_FAST_CROSSINGS_H

#include "dem/crossing.h"
#include "dem/fast/neighbours.h"

/* The first pair that crossed in the last drift of dt (crossing.h). The lists
 * do not know it: each that is fast is compared with all. */
struct dem_crossing crossings_find(const struct neighbours *nb, double dt);

#endif
