/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/case_mesh.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/file.h"
#include "base/vector.h"
#include "case/schema.h"
#include "case/source.h"
#include "fluid/inlet_profile.h"
#include "mesh/measures.h"
#include "mesh/poly/poly.h"

/* --- the keys of its patches ---------------------------------------------- */

/* The length of all paths with their closing zeros [byte]. */
static size_t text_length(const struct key *table, int n,
                          const struct mesh_patch_name *patch, int *rows)
{
    size_t text = 0;

    *rows = 1;
    for (const struct key *k = table; k->path != NULL; k++) {
        const int is_patch = strstr(k->path, KEY_ANY_PATCH) != NULL;
        *rows += is_patch ? n : 1;
        for (int i = 0; i < n && is_patch; i++)
            text += strlen(k->path) + strlen(patch[i].name) + 1;
    }
    return text;
}

static int is_of_patches(const struct key *table)
{
    for (const struct key *k = table; k->path != NULL; k++)
        if (strstr(k->path, KEY_ANY_PATCH) != NULL) return 1;
    return 0;
}

/* The sides of a box have fixed names; the patches of a mesh from files are
 * named in its files. Each row of <patch> is therefore repeated for each patch,
 * and a misspelt patch is an unknown key like any other, reported with the
 * nearest. The table with <patch> replaced by the n patches; NULL if the table
 * has no such row. One block: free() it. */
static struct key *rows_of_patches(const struct key *table, int n,
                                   const struct mesh_patch_name *patch)
{
    int rows;

    if (!is_of_patches(table)) return NULL;
    const size_t text = text_length(table, n, patch, &rows);
    struct key *const made =
        alloc_zeroed((size_t)rows * sizeof *made + text, 1);
    struct key *next = made;
    char *path = (char *)(made + rows);

    for (const struct key *k = table; k->path != NULL; k++) {
        const char *const at = strstr(k->path, KEY_ANY_PATCH);
        if (at == NULL) *next++ = *k;
        for (int i = 0; i < n && at != NULL; i++, next++) {
            *next = *k;
            next->path = path;
            path += sprintf(path, "%.*s%s%s", (int)(at - k->path), k->path,
                            patch[i].name, at + strlen(KEY_ANY_PATCH)) +
                    1;
            if (next->type == KEY_PATCH)
                next->what = "a patch of the mesh from files";
        }
    }
    *next = (struct key){.path = NULL};
    return made;
}

/* What is wrong with the name of a patch: no letter first, a sign that no key
 * has, or a key of the fluid's own. */
static const char *patch_name_wrong(const struct key *const *tables,
                                    const char *name)
{
    if (!isalpha((unsigned char)name[0]))
        return "its name does not begin with a letter";
    for (const char *c = name; *c != '\0'; c++)
        if (!isalnum((unsigned char)*c) && *c != '_' && *c != '-')
            return "its name has other characters than letters, digits, _ and "
                   "-";
    SCHEMA_EACH (k, tables) {
        const char *const member = schema_member(k, "fluid");
        if (member != NULL && strcmp(member, name) == 0)
            return "the fluid has a key of that name";
    }
    return NULL;
}

static int check_patch_names(const struct key *const *tables,
                             const config_setting_t *at, int n,
                             const struct mesh_patch_name *patch)
{
    for (int i = 0; i < n; i++) {
        const char *const why = patch_name_wrong(tables, patch[i].name);
        if (why != NULL)
            return source_wrong(at,
                                "mesh.polymesh: the patch %s cannot be named "
                                "in a case: %s; rename it in the file boundary",
                                patch[i].name, why);
    }
    return 0;
}

int case_mesh_patches(const struct settings *s, const config_t *tree,
                      const struct key **tables, struct key ***made)
{
    const config_setting_t *const at = config_lookup(tree, "mesh.polymesh");
    struct mesh_patch_name *patch;
    char dir[SETTINGS_PATH];
    size_t n_tables = 0;

    if (at == NULL || config_setting_type(at) != CONFIG_TYPE_STRING) return 0;
    if (config_setting_get_string(at)[0] == '\0')
        return source_wrong(at, "mesh.polymesh: expected the folder of an "
                                "OpenFOAM mesh in quotes, found the text \"\"");
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
    const int n = poly_patches(dir, settings_files(s), &patch);
    if (n < 0) return 2;
    if (check_patch_names(tables, at, n, patch) != 0) {
        free(patch);
        return 2;
    }
    while (tables[n_tables] != NULL)
        n_tables++;
    *made = alloc_zeroed(n_tables, sizeof **made);
    for (size_t i = 0; i < n_tables; i++) {
        (*made)[i] = rows_of_patches(tables[i], n, patch);
        if ((*made)[i] != NULL) tables[i] = (*made)[i];
    }
    free(patch);
    return 0;
}

/* --- making it ------------------------------------------------------------ */

/* One from files, or sheared, is shared: nobody changes it. */
struct mesh *case_mesh_create(const struct settings *s)
{
    return s->poly != NULL ? mesh_retain(s->poly)
                           : mesh_create_box(&s->mesh.box);
}

struct mesh *case_mesh_outline(const struct settings *s)
{
    return s->poly != NULL ? mesh_retain(s->poly)
                           : mesh_outline_box(&s->mesh.box);
}

static struct mesh *read_files(const struct settings *s)
{
    char dir[SETTINGS_PATH];

    settings_beside(s, s->mesh.polymesh, dir, sizeof dir);
    return poly_read(dir, settings_files(s));
}

int case_mesh_read(struct settings *s)
{
    const struct mesh_options *const o = &s->mesh;

    if (o->polymesh == NULL && !o->has_shear) return 0;
    struct mesh *const m = o->polymesh != NULL
                               ? read_files(s)
                               : mesh_create_sheared(&o->box, o->shear);
    s->poly = m;
    return m == NULL ? 2 : 0;
}

/* --- where it is ---------------------------------------------------------- */

void case_mesh_ends(const struct settings *s, double lo[3], double hi[3])
{
    const struct mesh *const m = s->poly;

    for (int k = 0; k < 3; k++) {
        lo[k] = m == NULL ? 0.0 : m->lo[k];
        hi[k] = s->mesh.box.size[k];
        if (m == NULL) continue;
        const double period = mesh_period(m, k);
        hi[k] = period > 0.0 ? lo[k] + period : m->hi[k];
    }
}

/* 1 for each direction in which the mesh is periodic, else 0. */
void case_mesh_periodic(const struct settings *s, int periodic[3])
{
    const struct mesh *const m = s->poly;

    for (int k = 0; k < 3; k++)
        periodic[k] =
            m == NULL ? s->mesh.box.periodic[k] : mesh_period(m, k) > 0.0;
}

double case_mesh_cells(const struct settings *s)
{
    const struct mesh *const kept = s->poly;
    const int *const n = s->mesh.box.cells;

    return kept != NULL ? kept->n_cells : (double)n[0] * n[1] * n[2];
}

/* Of a box the product of its sides. */
double case_mesh_volume(const struct settings *s)
{
    const struct mesh *const m = s->poly;
    const double *const size = s->mesh.box.size;
    double sum = 0.0;

    for (int c = 0; m != NULL && c < m->n_cells; c++)
        sum += m->V[c];
    if (m != NULL) return sum;
    return size[0] * size[1] * size[2];
}

int case_mesh_holds(const struct settings *s, const double x[3])
{
    const struct mesh *const m = s->poly;
    double lo[3], hi[3], offset[3];

    if (m != NULL) return mesh_cell_and_offset(m, x, offset) >= 0;
    case_mesh_ends(s, lo, hi);
    for (int k = 0; k < 3; k++)
        if (!(x[k] >= lo[k] && x[k] <= hi[k])) return 0;
    return 1;
}

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
    return settings_wrong(
        s, of_box,
        "the mesh comes from files; leave this key or mesh.polymesh out");
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
    return settings_wrong(
        s, KEY_OF(s, mesh.box.cells),
        "%.4g cells with %.3g faces; no more than %d faces can be numbered",
        case_mesh_cells(s), faces, MESH_MOST_FACES);
}

int case_mesh_check_keys(const struct settings *s)
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
            return settings_wrong(
                s, KEY_OF(s, mesh.box.grading),
                "the widest cell is %.3g times the narrowest in %c; at most %g",
                unevenness(&m->box, k), 'x' + k, most_uneven);
    mesh_volumes(m, &least, &most, &mean);
    if (least >= tiny && most <= huge) return 0;
    return settings_wrong(
        s, key, "the cells have %g to %g m^3; expected between %g and %g m^3",
        least, most, tiny, huge);
}

int case_mesh_check_cells(const struct settings *s)
{
    struct mesh *const m = case_mesh_outline(s);
    const int code = mesh_check_shape(s, m);

    mesh_free(m);
    return code;
}

/* --- its patches ---------------------------------------------------------- */

double case_mesh_area(const struct mesh *m, const struct patch *p)
{
    double area = 0.0;

    for (int f = p->first; f < p->first + p->n; f++)
        area += vector_length(mesh_S(m, f));
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
                              p->name, p->n, case_mesh_area(m, p), p->name);
    if (o->profile != &inlet_profile_parabola) return 0;
    snprintf(path, sizeof path, "%s.profile", o->key);
    return settings_wrong(s, path,
                          "only the inlet of a plain box can have a parabola; "
                          "expected uniform, formula, table or file");
}

int case_mesh_check_fluid(const struct settings *s)
{
    const struct mesh *const m = s->poly;
    int code = 0;

    for (int i = 0; m != NULL && i < m->n_patches && code == 0; i++)
        code = check_patch(s, m, &m->patches[i]);
    return code;
}
