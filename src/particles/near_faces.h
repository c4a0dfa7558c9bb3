/* near_faces.h -- which faces of the surfaces a particle is near.  Chapter 14.
 *
 * As with pairs (strip.h) there are two lists for the particles of a strip: the
 * vicinity, with all faces of gap <= skin, and from it, chosen every few steps,
 * those that could touch meanwhile.
 */
#ifndef NEAR_FACES_H
#define NEAR_FACES_H

#include <stddef.h>

#include "particles/bodies.h"
#include "particles/strip.h"
#include "particles/surface.h"

/* The surfaces, where they are now, and the box. Borrowed. */
struct surface_scene {
    const struct surface *surface;
    int n;
    const struct domain *box;
};

struct near_face {
    int surface, face;
    double shift[3]; /* [m] from the particle's mark to the image of it that
                        is near */
};

/* A particle and its faces: face[first] ... face[last - 1]. */
struct near_owner {
    int owner, first, last;
};

/* Owners in ascending order; none without a face. */
struct near_faces {
    int n_owners, owner_room, n_faces, face_room;
    struct near_owner *owner;
    struct near_face *face;
    struct triangle_list found; /* of one search */
};

void near_faces_release(struct near_faces *l);

/* All faces of gap <= skin [m] to the particles of a strip; pose has the place
 * of each surface. */
void near_faces_find(struct near_faces *l, const struct surface_scene *scene,
                     const struct pose *pose, const struct strip *s,
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

/* `list` with room for one more than n items of this size [bytes]. */
void *near_faces_room(void *list, int n, int *room, size_t size);

#endif
