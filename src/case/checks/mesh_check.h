/* mesh_check.h -- what a case says of its mesh. All return 0, or 2 after a
 * message. */
#ifndef CASE_CHECKS_MESH_CHECK_H
#define CASE_CHECKS_MESH_CHECK_H

#include "case/settings.h"

/* The keys, before there is a mesh. */
int mesh_check_keys(const struct settings *s);

/* The shape and the size of its cells. */
int mesh_check_cells(const struct settings *s);

/* The patches and their boundary conditions, where the mesh is no plain box. */
int mesh_check_fluid(const struct settings *s);

#endif
