/* placement_region.h -- the region where spheres may be placed. */
#ifndef DEM_PLACEMENT_REGION_H
#define DEM_PLACEMENT_REGION_H

/* holds: 1 if a sphere of radius R [m] around x [m] overlaps no wall; NULL: the
 * whole box. */
struct placement_region {
    int (*has_room)(const void *where, const double x[3], double R);
    const void *state; /* borrowed */
};

#endif
