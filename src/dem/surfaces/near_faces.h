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

#endif
