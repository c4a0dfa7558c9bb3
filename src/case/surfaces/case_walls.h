/* case_walls.h -- the walls for particles in a mesh that is not a box.
 *
 * The boundary faces. Those that lie in a side of the smallest box around the
 * mesh are left to the walls of that box, which cost least; all others become
 * triangles, one surface called "mesh" with the material of the walls. A side
 * of the box that no face lies in is moved away: it could touch a grain only
 * where the mesh has a wall of its own.
 */
#ifndef CASE_SURFACES_CASE_WALLS_H
#define CASE_SURFACES_CASE_WALLS_H

#include "dem/surfaces/surface.h"
#include "case/settings.h"

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
