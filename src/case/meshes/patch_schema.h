/* patch_schema.h -- the keys of <patch>, for a mesh with its own patches.
 *
 * The sides of a box have fixed names; the patches of a mesh from files are
 * named in its files. Each row of <patch> is therefore repeated for each patch,
 * and a misspelt patch is an unknown key like any other, reported with the
 * nearest.
 */
#ifndef CASE_MESHES_PATCH_SCHEMA_H
#define CASE_MESHES_PATCH_SCHEMA_H

#include "base/key.h"
#include "mesh/poly/poly.h"

#include <libconfig.h>

/* The table with <patch> replaced by the n patches; NULL if the table has no
 * such row. One block: free() it. */
struct key *patch_schema_create(const struct key *table, int n,
                                const struct mesh_patch_name *patch);

/* 0 if a case can name the patches; else 2 after a message: no letter first, a
 * sign that no key has, or a key of the fluid's own. */
int patch_schema_check(const struct key *const *tables,
                       const config_setting_t *at, int n,
                       const struct mesh_patch_name *patch);

#endif
