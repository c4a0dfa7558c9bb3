/* case_mesh.h -- the space that a case describes.
 *
 * A box, a sheared box, or a mesh from files. The last two are made once, when
 * the case is read, and kept in the settings, because the boundary conditions
 * of the case are checked against their patches.
 */
#ifndef CASE_CASE_MESH_H
#define CASE_CASE_MESH_H

#include <libconfig.h>

#include "case/settings.h"
#include "mesh/mesh.h"

/* Is called before a case is checked. Where the mesh comes from files, the
 * tables that have keys of the sides of the box are replaced by tables with the
 * patches of the mesh. *made has the new tables at their places in the list;
 * each is released with free(), and so is the list; NULL: none. 0, or 2 after a
 * message. */
int case_mesh_patches(const struct settings *s, const config_t *tree,
                      const struct key **tables, struct key ***made);

/* Reads or makes the mesh, which is kept in the settings; nothing for a plain
 * box. 0, or 2 after a message. */
int case_mesh_read(struct settings *s);

/* The mesh, which the caller releases by mesh_free. */
struct mesh *case_mesh_create(const struct settings *s);

/* The same; of a box only the outline is made, which costs nothing. */
struct mesh *case_mesh_outline(const struct settings *s);

/* The ends of the box of the particles [m]: the smallest box around the mesh,
 * in periodic directions one period; and the directions that are periodic. */
void case_mesh_ends(const struct settings *s, double lo[3], double hi[3]);
void case_mesh_periodic(const struct settings *s, int periodic[3]);

/* The cells that the case asks for, before there is a mesh; 0 for one from
 * files. They may be more than an int holds. [m^3] of all cells; 1 if the point
 * is inside [m]. */
double case_mesh_cells(const struct settings *s);
double case_mesh_volume(const struct settings *s);
double case_mesh_area(const struct mesh *m, const struct patch *p); /* [m^2] */
int case_mesh_holds(const struct settings *s, const double x[3]);

/* What a case says of its mesh. All return 0, or 2 after a message. */

/* The keys, before there is a mesh. */
int case_mesh_check_keys(const struct settings *s);

/* The shape and the size of its cells. */
int case_mesh_check_cells(const struct settings *s);

/* The patches and their boundary conditions, where the mesh is no plain box. */
int case_mesh_check_fluid(const struct settings *s);

#endif
