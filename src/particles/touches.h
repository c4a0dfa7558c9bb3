/* touches.h -- where a sphere touches the surfaces, each place once.
 * Chapter 14.
 *
 * A sphere that lies over the seam of two triangles overlaps both. One contact
 * stands for what is one place of the wall. Of the faces in the order of their
 * distance r from the centre one counts unless its nearest point, -r n from the
 * centre, lies behind the plane through that of a nearer face, across n',
 *
 *   r' - r n . n' <= flat R                                           (14.5)
 *
 * since then it lies within the overlap with that face. So are counted once a
 * seam within a plane, an edge, a vertex, a thin plate; and twice, as it should
 * be, a corner that the sphere lies in.
 */
#ifndef TOUCHES_H
#define TOUCHES_H

#include "particles/near_faces.h"

struct touch {
    int owner, surface;
    double r;    /* [m] from the face to the centre */
    double n[3]; /* [-] likewise */
    double q[3]; /* [m] its nearest point */
    double v[3]; /* [m/s] of the surface, there */
};

struct touches {
    int n, room;
    struct touch *list;
};

/* All that count, of all owners, in their order and the nearest first. */
void touches_find(struct touches *t, const struct near_faces *close,
                  const struct surface_scene *scene, const struct pose *pose,
                  const struct bodies *b);

/* Less than this share of the radius in front is behind: faces that meet at
 * less than 2.6 degrees are one [-]. */
static const double touches_flat = 1e-3;

#endif
