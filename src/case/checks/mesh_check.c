/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/checks/mesh_check.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/vector.h"
#include "case/case_mesh.h"
#include "fluid/inlet_profile.h"
#include "mesh/measures.h"

/* --- its keys ------------------------------------------------------------- */

/* A mesh from files has no key of a box. */
static int check_files(const struct settings *s)
{
    const struct mesh_options *const m = &s->mesh;
    const char *const of_box = m->box.size[0] > 0.0  ? KEY_OF(s, mesh.box.size)
                               : m->box.cells[0] > 0 ? KEY_OF(s, mesh.box.cells)
                               : m->has_grading  ? KEY_OF(s, mesh.box.grading)
                               : m->has_periodic ? KEY_OF(s, mesh.box.periodic)
                               : m->has_shear    ? KEY_OF(s, mesh.shear)
                                                 : NULL;

    if (of_box == NULL) return 0;
    return settings_wrong(s, of_box,
                          "the mesh comes from files; leave this key or "
                          "mesh.polymesh out");
}

static int check_box(const struct settings *s)
{
    const struct box_spec *const b = &s->mesh.box;
    const char *const missing = !(b->size[0] > 0.0) ? "size"
                                : b->cells[0] == 0  ? "cells"
                                                    : NULL;

    if (missing == NULL) return 0;
    return settings_wrong(s, "mesh",
                          "mesh.%s is missing: a box needs mesh.size, three "
                          "numbers [m], and mesh.cells; or give mesh.polymesh",
                          missing);
}

/* A box of more faces than can be numbered. */
static int check_numbers(const struct settings *s)
{
    const double faces = mesh_box_faces(&s->mesh.box);

    if (faces <= MESH_MOST_FACES) return 0;
    return settings_wrong(s, KEY_OF(s, mesh.box.cells),
                          "%.4g cells with %.3g faces; no more than %d faces "
                          "can be numbered",
                          case_mesh_cells(s), faces, MESH_MOST_FACES);
}

int mesh_check_keys(const struct settings *s)
{
    if (s->mesh.polymesh != NULL) return check_files(s);
    const int code = check_box(s);
    return code != 0 ? code : check_numbers(s);
}

/* --- its cells ------------------------------------------------------------ */

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
static int mesh_check_shape(const struct settings *s, const struct mesh *m)
{
    const double most_uneven = 1e6, tiny = 1e-60, huge = 1e60; /* [-], [m^3] */
    const char *const key = s->mesh.polymesh != NULL ? KEY_OF(s, mesh.polymesh)
                                                     : KEY_OF(s, mesh.box.size);
    double least, most, mean;

    for (int k = 0; k < 3 && m->face_centre == NULL; k++)
        if (!(unevenness(&m->box, k) <= most_uneven))
            return settings_wrong(s, KEY_OF(s, mesh.box.grading),
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

int mesh_check_cells(const struct settings *s)
{
    struct mesh *const m = case_mesh_outline(s);
    const int code = mesh_check_shape(s, m);

    mesh_free(m);
    return code;
}

/* --- its patches ---------------------------------------------------------- */

/* The area of a patch [m^2]. */
static double mesh_check_area_of(const struct mesh *m, const struct patch *p)
{
    double area = 0.0;

    for (int f = p->first; f < p->first + p->n; f++)
        area += vector_length(&m->S[3 * f]);
    return area;
}

static int check_patch(const struct settings *s, const struct mesh *m,
                       const struct patch *p)
{
    const struct boundary_options *const o = settings_side(s, p->name);
    char path[128];

    if (o == NULL && (p->is_symmetry || p->n == 0 || s->poly == NULL)) return 0;
    if (o == NULL)
        return settings_wrong(s, "fluid",
                              "the patch %s, %d faces with %.3g m^2, has no "
                              "boundary condition: give fluid.%s",
                              p->name, p->n, mesh_check_area_of(m, p), p->name);
    if (o->profile != &inlet_profile_parabola) return 0;
    snprintf(path, sizeof path, "%s.profile", o->key);
    return settings_wrong(s, path,
                          "only the inlet of a plain box can have a parabola; "
                          "expected uniform, formula, table or file");
}

int mesh_check_fluid(const struct settings *s)
{
    const struct mesh *const m = s->poly;
    int code = 0;

    for (int i = 0; m != NULL && i < m->n_patches && code == 0; i++)
        code = check_patch(s, m, &m->patches[i]);
    return code;
}
