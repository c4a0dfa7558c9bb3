/* read_mesh.h -- reads or makes a mesh that is no plain box. */
#ifndef CASE_READ_MESH_H
#define CASE_READ_MESH_H

#include "mesh/mesh_form.h"
#include "case/settings.h"

/* The form of mesh that the case chooses, one from files or one that is made of
 * the box; NULL if it chooses none of that sort. */
const struct mesh_form *read_mesh_form(const struct settings *s,
                                       int from_files);

/* The mesh is kept in the settings. 0, or 2 after a message. */
int read_mesh(struct settings *s);

#endif
