/* surroundings.h -- the flow around a body as the averaged model sees it.
 * Chapter "Resolving the grains".
 *
 * The mean over the fluid in a cube around the centre of the body [EW18 25].
 * From it follow the Reynolds number [EW18 27] and the drag coefficient
 * [EW18 26] that a drag law would be asked for.
 */
#ifndef RESOLVED_AMONG_SURROUNDINGS_H
#define RESOLVED_AMONG_SURROUNDINGS_H

#include "dem/surfaces/surface.h"
#include "resolved/solid_bodies.h"

struct surroundings {
    double eps;  /* [-] fluid fraction of the cube */
    double u[3]; /* [m/s] mean velocity of the fluid in it */
    double Re;   /* [-] [EW18 27] */
    double Cd;   /* [-] [EW18 26], of the force along the slip */
};

/* The means over cubes of this width [m]; fluid and bodies are borrowed. */
struct surroundings_filter;
struct surroundings_filter *surroundings_create(const struct solid_bodies *b,
                                                const struct fluid *fl,
                                                double width);
void surroundings_free(struct surroundings_filter *f);

/* Finds the fluid fraction of each cell; to be called when bodies have moved.
 */
void surroundings_bind(struct surroundings_filter *f);
struct surroundings surroundings_of(struct surroundings_filter *f, int i);

/* The surface of a body as particles touch it.
 *
 */

/* Of body i where it is: a sphere, a cylinder without ends where it reaches
 * through the box, else triangles. */
struct surface body_surface(const struct solid_bodies *b, int i);
void body_surface_release(struct surface *s);

#endif
