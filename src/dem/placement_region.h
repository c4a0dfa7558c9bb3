/* placement_region.h -- the region where spheres may be placed.
 * Chapter "Walls".
 */
#ifndef DEM_PLACEMENT_REGION_H
#define DEM_PLACEMENT_REGION_H

struct particles;

struct placement_region {
    /* 1 if a sphere of radius R [m] around x [m] overlaps no wall; NULL: the
     * region is the whole box. */
    int (*has_room)(const void *state, const double x[3], double R);
    /* Non-zero after a message if a particle overlaps a wall other than those
     * of the box; NULL: there is no such wall. */
    int (*start_wrong)(const void *state, const struct particles *ps);
    const void *state; /* borrowed */
};

#endif
