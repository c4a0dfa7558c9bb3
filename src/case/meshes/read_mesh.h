/* read_mesh.h -- meshes that are no plain box. */
#ifndef CASE_MESHES_READ_MESH_H
#define CASE_MESHES_READ_MESH_H

#include "case/settings.h"

#include <libconfig.h>

/* Is called before a case is checked. Where the mesh comes from files, the
 * tables that have keys of the sides of the box are replaced by tables with the
 * patches of the mesh. *made has the new tables at their places in the list;
 * each is released with free(), and so is the list; NULL: none. 0, or 2 after a
 * message. */
int read_mesh_patches(const struct settings *s, const config_t *tree,
                      const struct key **tables, struct key ***made);

/* Reads or makes the mesh, which is kept in the settings; nothing for a plain
 * box. 0, or 2 after a message. */
int read_mesh(struct settings *s);

#endif
