/* among_grains.h -- bodies in a bed of particles that are not resolved.
 * Chapter "Resolving the grains" [LS section 5.5].
 *
 * For the particles a body is a moving wall (dem/surfaces), which goes on with
 * its velocity for a few particle steps. What they pushed meanwhile moves it,
 * together with the force of the fluid, which is spread evenly over the step:
 *
 *   fluid; particles and bodies in turn; averaging; the next step
 *
 * The fluid fraction is that of the particles alone, and 1 in a body, whose
 * surface is a wall to the averaging (mirrors.h).
 */
#ifndef RESOLVED_AMONG_AMONG_GRAINS_H
#define RESOLVED_AMONG_AMONG_GRAINS_H

#include "averaging/averaging.h"
#include "coupling/simulation.h"
#include "dem/surfaces/surface.h"
#include "dem/surfaces/surfaces.h"
#include "resolved/solid_bodies.h"

/* --- surroundings --------------------------------------------------------- */

/* The flow around a body as the averaged model sees it. Chapter "Resolving the
 * grains".
 *
 * The mean over the fluid in a cube around the centre of the body [EW18 25].
 * From it follow the Reynolds number [EW18 27] and the drag coefficient [EW18
 * 26] that a drag law would be asked for. */

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

/* Finds the fluid fraction of each cell; to be called when bodies have moved.
 */
void surroundings_bind(struct surroundings_filter *f);
struct surroundings surroundings_of(struct surroundings_filter *f, int i);

/* The surface of a body as particles touch it. */

/* Of body i where it is: a sphere, a cylinder without ends where it reaches
 * through the box, else triangles, which belong to the owner (base/alloc.h). */
struct surface body_surface(void *owner, const struct solid_bodies *b, int i);

/* --- among grains --------------------------------------------------------- */

struct among_grains {
    struct carrier *carrier; /* one a body */
    struct surface *surface; /* one a body */
    int first;               /* [-] number of the first one in the dem */
    double (*impulse)[3];    /* [N s] on each since the run began, so far */
    double (*angular)[3];    /* [N m s] */
    double (*pushed)[3];     /* [N] mean force of the grains in the last step */
    double *held;            /* [N] that of fluid and weight in it, 3 a body */
    const struct dem *grains;  /* borrowed, once they are there */
    struct mirrors *mirrors;   /* NULL: nothing is averaged */
    struct averaging *average; /* borrowed */
};

/* Their surfaces, before there are particles; `first`: the number of other
 * surfaces. Called once all bodies have been added. */
void among_grains_create(struct solid_bodies *b, int first);

/* The particles, the fluid and the averaging are there. */
void among_grains_begin(struct solid_bodies *b, struct simulation *sim);

/* The hooks of the effect, with its memory, the bodies: before the particles
 * move, while they do, and afterwards. */
void among_grains_set_forces(void *bodies, struct simulation *sim);
int among_grains_run(void *bodies, struct simulation *sim, int steps);
void among_grains_end(void *bodies, struct simulation *sim);
void among_grains_state(struct solid_bodies *b, struct state *s);
void among_grains_free(struct among_grains *g);

/* Adds what the last kick of the particles has not yet got of their loads
 * [N s]. */
void among_grains_add_momentum(const struct solid_bodies *b, double total[3]);

/* 1 if a sphere of radius R [m] around x [m] overlaps no body. */
int among_grains_has_room(const struct solid_bodies *b, const double x[3],
                          double R);

/* Cells whose contents have nowhere to go, because no open one is near [-]. */
int mirrors_stuck(const struct mirrors *m);

#endif
