/* case_mesh.h -- the space that a case describes.
 *
 * A box, a sheared box, or a mesh from files. The last two are made once, when
 * the case is read, and kept in the settings, because the boundary conditions
 * of the case are checked against their patches.
 */
#ifndef CASE_CASE_MESH_H
#define CASE_CASE_MESH_H

#include "mesh/mesh.h"
#include "case/settings.h"

/* The mesh, which the caller releases by mesh_free. */
struct mesh *case_mesh_create(const struct settings *s);

/* The same; of a box only the outline is made, which costs nothing. */
struct mesh *case_mesh_outline(const struct settings *s);

/* The ends of the box of the particles [m]: the smallest box around the mesh,
 * in periodic directions one period; and the directions that are periodic. */
void case_mesh_ends(const struct settings *s, double lo[3], double hi[3]);
void case_mesh_periodic(const struct settings *s, int periodic[3]);

#endif
