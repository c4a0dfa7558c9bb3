/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/read_mesh.h"

#include <math.h>

#include "mesh/mesh_form.h"
#include "case/case_memory.h"
#include "case/case_mesh.h"

/* The form that the case chooses, one from files or one that is made of the
 * box; NULL if it chooses none of that sort. */
static const struct mesh_form *form_of(const struct settings *s, int from_files)
{
    for (int i = 0; mesh_forms[i] != NULL; i++)
        if ((mesh_forms[i]->read != NULL) == from_files &&
            settings_has(s, mesh_forms[i]->keys[0].path))
            return mesh_forms[i];
    return NULL;
}

/* A mesh from files has no key of a box. */
static int check_files(const struct settings *s, const char *files)
{
    const struct mesh_form *const other = form_of(s, 0);
    const char *const of_box[] = {"mesh.size", "mesh.cells", "mesh.grading",
                                  "mesh.periodic",
                                  other != NULL ? other->keys[0].path : NULL};

    for (int i = 0; i < 5 && of_box[i] != NULL; i++)
        if (settings_has(s, of_box[i]))
            return settings_wrong(
                s, of_box[i],
                "the mesh comes from files; leave this key or %s out", files);
    return 0;
}

static int check_box(const struct settings *s)
{
    static const char *const asked[] = {"mesh.size", "mesh.cells"};
    const char *files = NULL;

    for (int i = 0; mesh_forms[i] != NULL && files == NULL; i++)
        if (mesh_forms[i]->read != NULL) files = mesh_forms[i]->keys[0].path;
    for (int i = 0; i < 2; i++)
        if (!settings_has(s, asked[i]))
            return settings_wrong(s, "mesh",
                                  "%s is missing: a box needs mesh.size, three "
                                  "numbers [m], and mesh.cells%s%s",
                                  asked[i], files != NULL ? "; or give " : "",
                                  files != NULL ? files : "");
    return 0;
}

/* A box of more faces than can be numbered. */
static int check_numbers(const struct settings *s)
{
    const struct box_spec spec = case_mesh_box(s);
    const double faces = mesh_box_faces(&spec);

    if (faces <= MESH_MOST_FACES) return 0;
    return settings_wrong(s, "mesh.cells",
                          "%.4g cells with %.3g faces; no more than %d faces "
                          "can be numbered",
                          case_mesh_cells(s), faces, MESH_MOST_FACES);
}

/* The widest slab of a direction over the narrowest; without bound where the
 * narrowest has no width left. */
static double unevenness(const struct box *b, int k)
{
    const double *const e = b->edge[k];
    double narrow = HUGE_VAL, wide = 0.0;

    for (int i = 0; i < b->n[k]; i++) {
        narrow = fmin(narrow, e[i + 1] - e[i]);
        wide = fmax(wide, e[i + 1] - e[i]);
    }
    return narrow > 0.0 ? wide / narrow : HUGE_VAL;
}

/* Beyond these no solver comes to an end, and squares of areas leave the range
 * of a double. */
static int check_shape(const struct settings *s, const struct mesh *m)
{
    const double most_uneven = 1e6, tiny = 1e-60, huge = 1e60; /* [-], [m^3] */
    const char *const key =
        settings_has(s, "mesh.polymesh") ? "mesh.polymesh" : "mesh.size";
    double least, most, mean;

    for (int k = 0; k < 3 && m->face_centre == NULL; k++)
        if (!(unevenness(&m->box, k) <= most_uneven))
            return settings_wrong(s, "mesh.grading",
                                  "the widest cell is %.3g times the "
                                  "narrowest in %c; at most %g",
                                  unevenness(&m->box, k), 'x' + k, most_uneven);
    mesh_volumes(m, &least, &most, &mean);
    if (least >= tiny && most <= huge) return 0;
    return settings_wrong(s, key,
                          "the cells have %g to %g m^3; expected between %g "
                          "and %g m^3",
                          least, most, tiny, huge);
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

static int read_or_make(struct settings *s)
{
    const struct mesh_form *const files = form_of(s, 1);
    const struct mesh_form *const made = form_of(s, 0);
    int code =
        files != NULL ? check_files(s, files->keys[0].path) : check_box(s);

    if (code == 0 && files == NULL) code = check_numbers(s);
    if (code == 0) code = case_memory_check(s, 0.0);
    if (code != 0 || (files == NULL && made == NULL)) return code;
    struct mesh *const m =
        files != NULL ? read_files(s, files) : make_of_box(s, made);
    settings_keep_mesh(s, m);
    return m == NULL ? 2 : 0;
}

int read_mesh(struct settings *s)
{
    if (read_or_make(s) != 0) return 2;
    struct mesh *const m = case_mesh_outline(s);
    const int code = check_shape(s, m);

    mesh_free(m);
    return code;
}
