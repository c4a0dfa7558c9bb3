/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/cohesion/case_cohesion.h"
#include "case/surfaces/case_surfaces.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "case/case_materials.h"
#include "case/checks/materials_check.h"
#include "case/case_mesh.h"
#include "case/models.h"
#include "case/surfaces/case_walls.h"
#include "dem/surfaces/stl.h"

static const char list[] = "particles.surfaces",
                  prescribed[] = "particles.prescribed";
static const char *const directions[] = {"normal", "axis"};

static struct motion case_surfaces_motion_of(const struct settings *s,
                                             const char *of, int i)
{
    struct motion m = {.from = settings_item_real(s, of, i, "from"),
                       .until = settings_item_real_or(s, of, i, "until", 0.0),
                       .frequency = settings_item_real(s, of, i, "frequency")};

    settings_item_vector(s, of, i, "velocity", m.velocity);
    settings_item_vector(s, of, i, "amplitude", m.amplitude);
    if (settings_item_has(s, of, i, "centre"))
        settings_item_vector(s, of, i, "centre", m.centre);
    else if (of == list)
        settings_item_vector(s, of, i, "point", m.centre);
    settings_item_vector(s, of, i, "spin", m.spin);
    return m;
}

static void case_surfaces_direction(const struct settings *s, int i,
                                    const char *key, double n[3])
{
    settings_item_vector(s, list, i, key, n);
    const double length = vector_length(n);
    for (int k = 0; k < 3 && length > 0.0; k++)
        n[k] /= length;
}

static const struct surface_shape *
case_surfaces_shape_of(const struct settings *s, int i)
{
    return surface_shape_named(settings_item_text(s, list, i, "shape"));
}

/* 1 if one of its tables has the key particles.surfaces.NAME. */
static int reads(const struct surface_shape *shape, const char *name)
{
    for (int t = 0; t < KEY_TABLES && shape->keys[t] != NULL; t++)
        for (const struct key *k = shape->keys[t]; k->path != NULL; k++)
            if (strcmp(strrchr(k->path, '.') + 1, name) == 0) return 1;
    return 0;
}

static struct triangles *read_triangles(const struct settings *s, int i,
                                        const double origin[3])
{
    const double scale = settings_item_real(s, list, i, "scale");
    char path[SETTINGS_PATH];
    struct stl stl;

    settings_beside(s, settings_item_text(s, list, i, "file"), path,
                    sizeof path);
    if (stl_read(path, &stl) != 0) return NULL;
    if (stl.dropped > 0)
        fprintf(stderr, "winnow: %s: %d triangles have no area; left out\n",
                path, stl.dropped);
    for (int t = 0; t < 9 * stl.n; t++) {
        double *const x = &stl.corner[t / 9][t / 3 % 3][t % 3];
        *x = origin[t % 3] + scale * *x;
    }
    struct triangles *const made = triangles_create(stl.n, stl.corner);
    stl_release(&stl);
    return made;
}

static int case_surfaces_material_of(const struct settings *s, int i)
{
    if (!settings_item_has(s, list, i, "material")) return 0;
    return case_materials_number(s, settings_item_text(s, list, i, "material"));
}

/* The members of struct surface that the shape reads, and its own numbers. */
static int case_surfaces_fill(const struct settings *s, int i,
                              struct surface *one)
{
    const struct surface_shape *const shape = case_surfaces_shape_of(s, i);
    int n = 0;

    *one = (struct surface){.name = settings_item_text(s, list, i, "name"),
                            .shape = shape,
                            .material = case_surfaces_material_of(s, i),
                            .motion = case_surfaces_motion_of(s, list, i)};
    settings_item_vector(s, list, i, "point", one->point);
    for (int k = 0; k < 2; k++)
        if (reads(shape, directions[k]))
            case_surfaces_direction(s, i, directions[k], one->normal);
    if (reads(shape, "radius"))
        one->radius = settings_item_real(s, list, i, "radius");
    if (reads(shape, "particles"))
        one->inside =
            strcmp(settings_item_text(s, list, i, "particles"), "inside") == 0;
    for (const struct key *k = shape->own_keys; k != NULL && k->path != NULL;
         k++)
        one->own[n++] =
            settings_item_real(s, list, i, strrchr(k->path, '.') + 1);
    if (shape->nearest != NULL) return 0;
    one->triangles = read_triangles(s, i, one->point);
    return one->triangles == NULL;
}

int case_surfaces_count(const struct settings *s)
{
    return settings_length(s, list) + (case_walls_count(s) > 0);
}

int case_surfaces_count_prescribed(const struct settings *s)
{
    return settings_length(s, prescribed);
}

struct surface *case_surfaces_create(const struct settings *s, int *code)
{
    const int n = case_surfaces_count(s), listed = settings_length(s, list);

    *code = 0;
    if (n == 0) return NULL;
    struct surface *const made = alloc_zeroed((size_t)n, sizeof *made);
    for (int i = 0; i < listed && *code == 0; i++)
        if (case_surfaces_fill(s, i, &made[i]) != 0) *code = 2;
    if (listed < n) made[listed] = case_walls_surface(s);
    if (*code == 0) return made;
    case_surfaces_free(made, n);
    return NULL;
}

/* The list owns its triangles, which are constant for dem. */
void case_surfaces_free(struct surface *made, int n)
{
    for (int i = 0; made != NULL && i < n; i++) {
        struct triangles *own;
        memcpy(&own, &made[i].triangles, sizeof own);
        triangles_free(own);
    }
    free(made);
}

struct prescribed_particle *
case_surfaces_create_prescribed(const struct settings *s)
{
    const int n = case_surfaces_count_prescribed(s);

    if (n == 0) return NULL;
    struct prescribed_particle *const made =
        alloc_zeroed((size_t)n, sizeof *made);
    for (int i = 0; i < n; i++) {
        made[i].id = settings_item_int(s, prescribed, i, "id");
        made[i].motion = case_surfaces_motion_of(s, prescribed, i);
    }
    return made;
}

/* --- checks --------------------------------------------------------------- */

static int case_surfaces_check_name(const struct settings *s, int i)
{
    const char *const name = settings_item_text(s, list, i, "name");

    if (name[0] == '\0' || strpbrk(name, ",\"\n") != NULL)
        return settings_wrong(s, list,
                              "the name \"%s\" is empty or has a comma or a "
                              "quote in it",
                              name);
    if (case_walls_count(s) > 0 && strcmp(name, case_walls_name) == 0)
        return settings_wrong(s, list, "the name %s is that of the walls",
                              name);
    for (int k = 0; k < i; k++)
        if (strcmp(name, settings_item_text(s, list, k, "name")) == 0)
            return settings_wrong(s, list, "the name %s is given twice", name);
    if (!settings_item_has(s, list, i, "material")) return 0;
    return materials_check_name(s, list,
                                settings_item_text(s, list, i, "material"));
}

/* Each key belongs to the shapes that read it, and a direction has a length. */
static int case_surfaces_check_shape(const struct settings *s, int i)
{
    const struct surface_shape *const shape = case_surfaces_shape_of(s, i);
    const char *const name = settings_item_text(s, list, i, "name");

    for (int other = 0; surface_shapes[other] != NULL; other++)
        for (int t = 0; surface_shapes[other]->keys[t] != NULL; t++)
            for (const struct key *k = surface_shapes[other]->keys[t];
                 k->path != NULL; k++) {
                const char *const key = strrchr(k->path, '.') + 1;
                if (settings_item_has(s, list, i, key) && !reads(shape, key))
                    return settings_wrong(s, list, "%s is a %s: it has no %s",
                                          name, shape->name, key);
            }
    for (int k = 0; k < 2; k++) {
        double n[3];
        if (!reads(shape, directions[k])) continue;
        settings_item_vector(s, list, i, directions[k], n);
        if (!(vector_length(n) > 0.0))
            return settings_wrong(s, list, "the %s of %s has no direction",
                                  directions[k], name);
    }
    return 0;
}

/* A particle that crosses a periodic end would come back behind the surface. */
static int check_plane(const struct settings *s, int i)
{
    static const char axes[] = "xyz";
    int periodic[3];
    double n[3];

    if (case_surfaces_shape_of(s, i) != &surface_plane) return 0;
    case_mesh_periodic(s, periodic);
    case_surfaces_direction(s, i, "normal", n);
    for (int k = 0; k < 3; k++)
        if (periodic[k] && fabs(n[k]) > 1e-9)
            return settings_wrong(
                s, list,
                "the plane %s is not parallel to %c, which is periodic: "
                "particles would come back behind it; make %c not periodic",
                settings_item_text(s, list, i, "name"), axes[k], axes[k]);
    return 0;
}

static int check_motion(const struct settings *s, const char *of, int i)
{
    const struct motion m = case_surfaces_motion_of(s, of, i);

    if (m.until > 0.0 && m.until <= m.from)
        return settings_wrong(s, of,
                              "number %d moves until %g s, which is not "
                              "after from = %g s",
                              i, m.until, m.from);
    if ((m.frequency > 0.0) != (vector_length(m.amplitude) > 0.0))
        return settings_wrong(
            s, of, "number %d: amplitude and frequency go together", i);
    return 0;
}

static int check_driven(const struct settings *s, int i)
{
    const int id = settings_item_int(s, prescribed, i, "id");

    for (int k = 0; k < i; k++)
        if (settings_item_int(s, prescribed, k, "id") == id)
            return settings_wrong(s, prescribed, "particle %d is given twice",
                                  id);
    const struct motion m = case_surfaces_motion_of(s, prescribed, i);
    if (vector_length(m.spin) > 0.0 &&
        !settings_item_has(s, prescribed, i, "centre"))
        return settings_wrong(s, prescribed,
                              "particle %d has a spin: it needs a centre", id);
    return check_motion(s, prescribed, i);
}

/* Attractions act between particles and the walls of the box only. */
static int check_others(const struct settings *s)
{
    const char *const pull = case_cohesion_of_box(s);

    if (settings_length(s, list) == 0 || pull == NULL) return 0;
    return settings_wrong(s, list,
                          "%s acts between particles and the box, not on "
                          "surfaces: leave one of them out",
                          pull);
}

int case_surfaces_check(const struct settings *s)
{
    int code = check_others(s);

    for (int i = 0; i < settings_length(s, list) && code == 0; i++) {
        code = case_surfaces_check_name(s, i);
        if (code == 0) code = case_surfaces_check_shape(s, i);
        if (code == 0) code = check_plane(s, i);
        if (code == 0) code = check_motion(s, list, i);
    }
    for (int i = 0; i < settings_length(s, prescribed) && code == 0; i++)
        code = check_driven(s, i);
    return code;
}
