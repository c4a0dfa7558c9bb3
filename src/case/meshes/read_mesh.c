/* SPDX-License-Identifier: GPL-3.0-or-later */
/* read_mesh.c -- reads or makes a mesh that is no plain box, and knows its
 * patches before the case is checked. */
#include "case/meshes/read_mesh.h"

#include <stdlib.h>

#include "base/alloc.h"
#include "base/tables/input.h"
#include "mesh/poly/poly.h"
#include "case/case_mesh.h"
#include "case/meshes/patch_schema.h"
#include "case/source.h"

int read_mesh_patches(const struct settings *s, const config_t *tree,
                      const struct key **tables, struct key ***made)
{
    const config_setting_t *const at = config_lookup(tree, "mesh.polymesh");
    struct mesh_patch_name *patch;
    char dir[SETTINGS_PATH];
    size_t n_tables = 0;

    if (at == NULL || config_setting_type(at) != CONFIG_TYPE_STRING) return 0;
    settings_beside(s, config_setting_get_string(at), dir, sizeof dir);
    if (input_wrong(dir) == NULL)
        return source_wrong(at,
                            "mesh.polymesh: expected the folder of an OpenFOAM "
                            "mesh, found the file %s; gmshToFoam makes one of "
                            "a .msh that Gmsh saved in format 2.2",
                            dir);
    if (!poly_is(dir))
        return source_wrong(at,
                            "mesh.polymesh: there is no mesh in the folder "
                            "%s: " POLY_LOOKED_FOR,
                            dir);
    const int n = poly_patches(dir, &patch);
    if (n < 0) return 2;
    if (patch_schema_check(tables, at, n, patch) != 0) {
        free(patch);
        return 2;
    }
    while (tables[n_tables] != NULL)
        n_tables++;
    *made = alloc_zeroed(n_tables, sizeof **made);
    for (size_t i = 0; i < n_tables; i++) {
        (*made)[i] = patch_schema_create(tables[i], n, patch);
        if ((*made)[i] != NULL) tables[i] = (*made)[i];
    }
    free(patch);
    return 0;
}

static struct mesh *read_files(const struct settings *s)
{
    char dir[SETTINGS_PATH];

    settings_beside(s, s->mesh.polymesh, dir, sizeof dir);
    return poly_read(dir);
}

int read_mesh(struct settings *s)
{
    const struct mesh_options *const o = &s->mesh;

    if (o->polymesh == NULL && !o->has_shear) return 0;
    struct mesh *const m = o->polymesh != NULL
                               ? read_files(s)
                               : mesh_create_sheared(&o->box, o->shear);
    settings_keep_mesh(s, m);
    return m == NULL ? 2 : 0;
}
