/* patch_schema.h -- the keys of <patch>, for a mesh with its own patches.
 *
 * A box has sides whose names are known; a mesh from files brings names of its
 * own. So each row of <patch> is written out once for each of them. Then a
 * misspelt patch is an unknown key like any other, and finds the nearest.
 */
#ifndef CASE_PATCH_SCHEMA_H
#define CASE_PATCH_SCHEMA_H

#include "base/key.h"
#include "mesh/poly/poly.h"

/* The table with <patch> replaced by the n patches; NULL if the table has no
 * such row. One block: free() it. */
struct key *patch_schema_create(const struct key *table, int n,
                                const struct poly_patch *patch);

/* NULL if a case can name the patch; else why it cannot: no letter first, a
 * sign that no key has, or a key of the fluid's own. */
const char *patch_schema_wrong(const struct key *const *tables,
                               const char *name);

#endif
