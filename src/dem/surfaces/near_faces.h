/* near_faces.h -- the faces of surfaces near each particle.
 * Chapter "Walls".
 *
 * As with pairs (chunk.h) there are two lists for the particles of a chunk: the
 * neighbour list, with all faces of gap <= skin, and from it, chosen every few
 * steps, those that could touch meanwhile.
 */
#ifndef DEM_SURFACES_NEAR_FACES_H
#define DEM_SURFACES_NEAR_FACES_H

#include <stddef.h>

#include "dem/fast/bodies.h"
#include "dem/fast/chunk.h"
#include "dem/surfaces/surface.h"

/* The surfaces, where they are now, and the box. Borrowed. */
struct surface_scene {
    const struct surface *surface;
    int n;
    const struct box_domain *box;
};

struct near_face {
    int surface, face;
    double shift[3]; /* [m] from the particle's position at the last rebuild
                        to the image of it that is near */
};

/* A particle and its faces: face[first] ... face[last - 1]. */
struct near_owner {
    int owner, first, last;
};

/* Owners in ascending order; none without a face. */
struct near_faces {
    int n_owners, owner_capacity, n_faces, face_capacity;
    struct near_owner *owner;
    struct near_face *face;
    struct triangle_list found; /* of one search */
};

void near_faces_release(struct near_faces *l);

/* All faces of gap <= skin [m] to the particles of a chunk; pose has the place
 * of each surface. */
void near_faces_find(struct near_faces *l, const struct surface_scene *scene,
                     const struct pose *pose, const struct chunk *s,
                     const struct bodies *b, double skin);

/* Those of `from` with gap < margin [m]. */
void near_faces_choose(struct near_faces *l, const struct near_faces *from,
                       const struct surface_scene *scene,
                       const struct pose *pose, const struct bodies *b,
                       double margin);

/* The image of particle i that the face is near to [m]: a particle may have
 * been brought back into a periodic box since the list was made. */
void near_faces_image(const struct near_face *f, const struct bodies *b, int i,
                      double x[3]);

/* Visits all faces, under this name (state.h), of the particles of a chunk. */
void near_faces_state(struct near_faces *l, const char *name,
                      const struct surface_scene *scene,
                      const struct chunk *chunk, struct state *s);

/* Returns `list` with capacity for one more than n items of this size [bytes].
 */
void *near_faces_room(void *list, int n, int *room, size_t size);

/* --- surface contact points: the contact points of a sphere with surfaces,
 * without duplicates.
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
