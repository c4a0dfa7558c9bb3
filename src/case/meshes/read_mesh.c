/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/read_mesh.h"

#include "mesh/mesh_form.h"
#include "case/case_mesh.h"

const struct mesh_form *read_mesh_form(const struct settings *s, int from_files)
{
    for (int i = 0; mesh_forms[i] != NULL; i++)
        if ((mesh_forms[i]->read != NULL) == from_files &&
            settings_has(s, mesh_forms[i]->keys[0].path))
            return mesh_forms[i];
    return NULL;
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

int read_mesh(struct settings *s)
{
    const struct mesh_form *const files = read_mesh_form(s, 1);
    const struct mesh_form *const made = read_mesh_form(s, 0);

    if (files == NULL && made == NULL) return 0;
    struct mesh *const m =
        files != NULL ? read_files(s, files) : make_of_box(s, made);
    settings_keep_mesh(s, m);
    return m == NULL ? 2 : 0;
}
