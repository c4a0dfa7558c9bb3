/* case_surfaces.h -- the walls of a case besides its box, and prescribed
 * particles.  Chapter "Walls". */
#ifndef CASE_PARTICLES_CASE_SURFACES_H
#define CASE_PARTICLES_CASE_SURFACES_H

#include "case/settings.h"
#include "coupling/simulation.h"
#include "dem/surfaces/surface.h"

/* Reads the files of the surfaces and of prescribed particles, which the
 * settings keep, and looks whether these particles exist: 0, or 2 after one
 * message. */
int case_surfaces_read(struct settings *s);
void case_surfaces_release(struct settings *s);

struct case_scales;

/* Completes them but for their files. 0, or 2 after a message about what the
 * case says of them. */
int case_surfaces_check(struct settings *s);

/* Prints its lines for `winnow check`. */
void case_surfaces_print(const struct settings *s, const struct case_scales *k);

/* The box of the particles and the numbers of surfaces, before anything is
 * created. */
void case_surfaces_dem_options(const struct settings *s, struct dem_options *o);

/* Creates surfaces before there are particles. */
void case_surfaces_complete(const struct settings *s, struct simulation *sim,
                            struct dem_options *o);
void case_surfaces_free(struct simulation *sim);

/* 1 if a sphere of radius R [m] at x overlaps no surface of the simulation
 * `state` where they are now, and is where its region has room. */
int case_surfaces_are_apart(const void *state, const double x[3], double R);

/* Whether particles can start where they were placed. 0, or 2 after a message.
 */
int case_surfaces_place(const struct settings *s, struct particles *ps,
                        const struct dem_options *o);

/* A note if a fluid does not see them. */
void case_surfaces_tell_unseen(const struct settings *s);

/* --- case_walls.c --------------------------------------------------------- *
 * The boundary faces. Those that lie in a side of the smallest box around the
 * mesh are left to the walls of that box, which cost least; all others become
 * triangles, one surface called "mesh" with the material of the walls. A side
 * of the box that no face lies in is moved away: it could touch a grain only
 * where the mesh has a wall of its own.
 */
extern const char case_walls_name[]; /* of the surface: "mesh" */

/* How many triangles it takes: 0 of a box. */
int case_walls_count(const struct settings *s);

/* The surface; its triangles are the caller's. */
struct surface case_walls_surface(const struct settings *s);

/* Where the walls of the box are: the ends of the mesh, some moved away. */
void case_walls_ends(const struct settings *s, double lo[3], double hi[3]);

/* Whether particles can be in such a mesh: 0, or 2 after a message. */
int case_walls_check(const struct settings *s);

/* The mesh, which is held until case_walls_free, and its surface above,
 * borrowed, or NULL where there is none. NULL for a box. */
struct case_walls;
struct case_walls *case_walls_create(const struct settings *s,
                                     const struct surface *walls);
void case_walls_free(struct case_walls *w);

/* 1 if a sphere of radius R [m] around x [m] is within the mesh. */
int case_walls_has_room(const struct case_walls *w, const double x[3],
                        double R);

#endif
