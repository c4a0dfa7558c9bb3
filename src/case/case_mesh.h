/* case_mesh.h -- the space that a case describes.
 *
 * A box, a sheared box, or a mesh from files. The last two are made once, when
 * the case is read, and kept in the settings, because the boundary conditions
 * of the case are checked against their patches.
 */
#ifndef CASE_CASE_MESH_H
#define CASE_CASE_MESH_H

#include "mesh/mesh_form.h"
#include "case/settings.h"

/* The plain box that the case gives. */
struct box_spec case_mesh_box(const struct settings *s);

/* The mesh, which the caller releases by mesh_free. */
struct mesh *case_mesh_create(const struct settings *s);

/* The same, but of a box only the outline, which costs nothing. */
struct mesh *case_mesh_outline(const struct settings *s);

/* The cells that the case asks for, before there is a mesh; 0 for one from
 * files. They may be more than an int holds. */
double case_mesh_cells(const struct settings *s);

/* The form of mesh that the case chooses, one from files or one that is made of
 * the box; NULL if it chooses none of that sort. */
const struct mesh_form *case_mesh_form(const struct settings *s,
                                       int from_files);

/* Where particles can be at all: the smallest box around the mesh, or what a
 * period makes one of it; and in which directions it is periodic. */
void case_mesh_ends(const struct settings *s, double lo[3], double hi[3]);
void case_mesh_periodic(const struct settings *s, int periodic[3]);

/* [m^3] of all cells. */
double case_mesh_volume(const struct settings *s);

/* 1 if the point is inside [m]. */
int case_mesh_holds(const struct settings *s, const double x[3]);

#endif
