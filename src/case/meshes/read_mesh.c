/* SPDX-License-Identifier: GPL-3.0-or-later */
/* read_mesh.c -- reads or makes a mesh that is no plain box, and knows its
 * patches before the case is checked. */
#include "case/mesh_reader.h"

#include <stdlib.h>

#include "base/alloc.h"
#include "base/tables/input.h"
#include "mesh/mesh_form.h"
#include "case/case_mesh.h"
#include "case/extent/case_extent.h"
#include "case/meshes/patch_schema.h"
#include "case/source.h"

/* Where the mesh comes from files, its patches take the place of the sides. */
static int take_patches(const struct settings *s, const config_t *tree,
                        const struct key **tables, struct key ***made)
{
    const config_setting_t *at;
    const struct mesh_form *const form = patch_schema_form(tree, &at);
    struct mesh_patch_name *patch;
    char dir[SETTINGS_PATH];
    size_t n_tables = 0;

    if (form == NULL) return 0;
    settings_beside(s, config_setting_get_string(at), dir, sizeof dir);
    if (input_wrong(dir) == NULL)
        return source_wrong(at,
                            "%s: expected the folder of an OpenFOAM mesh, "
                            "found the file %s; gmshToFoam makes one of a .msh "
                            "that Gmsh saved in format 2.2",
                            form->keys[0].path, dir);
    if (!form->is_there(dir))
        return source_wrong(at, "%s: there is no mesh in the folder %s: %s",
                            form->keys[0].path, dir, form->looked_for);
    const int n = form->patches(dir, &patch);
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

static struct mesh *read_files(const struct settings *s,
                               const struct mesh_form *form)
{
    char dir[SETTINGS_PATH];

    settings_beside(s, settings_text(s, form->keys[0].path), dir, sizeof dir);
    return form->read(dir);
}

static struct mesh *make_of_box(const struct settings *s,
                                const struct mesh_form *form)
{
    const struct box_spec spec = case_mesh_box(s);
    double v[3];

    settings_vector(s, form->keys[0].path, v);
    return form->of_box(&spec, v);
}

static int read(struct settings *s)
{
    const struct mesh_form *const files = case_extent_form(s, 1);
    const struct mesh_form *const made = case_extent_form(s, 0);

    if (files == NULL && made == NULL) return 0;
    struct mesh *const m =
        files != NULL ? read_files(s, files) : make_of_box(s, made);
    settings_keep_mesh(s, m);
    return m == NULL ? 2 : 0;
}

const struct mesh_reader read_mesh = {.patches = take_patches, .read = read};
