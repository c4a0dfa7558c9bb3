/* surface_contact_points.h -- the contact points of a sphere with surfaces,
 * without duplicates.
 * Chapter "Walls".
 *
 * A sphere that lies over the seam of two triangles overlaps both. There is one
 * contact for each point of the wall. Of the faces in the order of their
 * distance r from the centre one counts unless its nearest point, -r n from the
 * centre, lies behind the plane through that of a nearer face, across n',
 *
 *   r' - r n . n' <= flat R                                           (14.5)
 *
 * since then it lies within the overlap with that face. A seam within a plane,
 * an edge, a vertex and a thin plate are thus counted once, and a corner that
 * contains the sphere is correctly counted twice.
 */
#ifndef DEM_SURFACES_SURFACE_CONTACT_POINTS_H
#define DEM_SURFACES_SURFACE_CONTACT_POINTS_H

#include "dem/surfaces/near_faces.h"

struct surface_contact_point {
    int owner, surface;
    double r;    /* [m] from the face to the centre */
    double n[3]; /* [-] likewise */
    double q[3]; /* [m] its nearest point */
    double v[3]; /* [m/s] of the surface, there */
};

struct surface_contact_points {
    int n, capacity;
    struct surface_contact_point *list;
};

/* All that count, of all owners, in their order and the nearest first. */
void surface_contact_points_find(struct surface_contact_points *t,
                                 const struct near_faces *close,
                                 const struct surface_scene *scene,
                                 const struct pose *pose,
                                 const struct bodies *b);

/* A point less than this fraction of the radius in front of a plane counts as
 * behind it: faces at an angle below 2.6 degrees count as one [-]. */
static const double surface_contact_points_flat = 1e-3;

#endif
