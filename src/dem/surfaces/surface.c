/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surfaces/surface.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/model.h"
#include "base/vector.h"
#include "dem/surfaces/triangle.h"

/* If the centre lies in the triangle, n is the normal of the triangle. */
static struct surface_hit nearest_on_triangle(const double corner[3][3],
                                              const double y[3])
{
    struct surface_hit h;

    triangle_nearest(corner, y, h.q);
    vector_between(y, h.q, h.n);
    h.r = vector_length(h.n);
    if (h.r > 0.0)
        for (int k = 0; k < 3; k++)
            h.n[k] /= h.r;
    else
        triangle_normal(corner, h.n);
    return h;
}

struct surface_hit surface_nearest(const struct surface *s, int face,
                                   const double y[3])
{
    if (s->shape->nearest != NULL) return s->shape->nearest(s, y);
    return nearest_on_triangle((const double(*)[3])s->triangles->corner[face],
                               y);
}

struct surface_hit surface_nearest_moved(const struct surface *s, int face,
                                         const struct pose *p,
                                         const double x[3])
{
    double y[3], n[3];

    motion_origin(p, x, y);
    struct surface_hit h = surface_nearest(s, face, y);
    memcpy(n, h.n, sizeof n);
    motion_turn(p, n, h.n);
    vector_along(x, -h.r, h.n, h.q);
    return h;
}

int surface_contains(const struct surface *s, const struct pose *p,
                     const double x[3], double R)
{
    if (s->shape->nearest == NULL) return 0;
    return surface_nearest_moved(s, 0, p, x).r < -R;
}

double surface_reach(const struct surface *s, const double lo[3],
                     const double hi[3])
{
    const int own = s->triangles != NULL;
    double far[3];

    if (s->shape->reach != NULL) return s->shape->reach(s);
    for (int k = 0; k < 3; k++) {
        const double from = own ? s->triangles->lo[k] : lo[k];
        const double to = own ? s->triangles->hi[k] : hi[k];
        far[k] = fmax(fabs(from - s->motion.centre[k]),
                      fabs(to - s->motion.centre[k]));
    }
    return vector_length(far);
}

const char *surface_wrong_direction(const struct surface *s)
{
    return fabs(vector_length(s->normal) - 1.0) > 1e-9
               ? "its normal or axis has no direction"
               : NULL;
}

const char *surface_wrong_radius(const struct surface *s)
{
    return s->radius > 0.0 ? NULL : "its radius is not > 0";
}

static const char *without_triangles(const struct surface *s)
{
    return s->triangles == NULL ? "it has no triangles" : NULL;
}

int surface_wrong(const struct surface *s)
{
    const char *const what =
        s->shape->wrong != NULL ? s->shape->wrong(s) : NULL;

    if (what != NULL)
        fprintf(stderr, "winnow: surface \"%s\": %s\n", s->name, what);
    return what != NULL;
}

const struct key surface_point_keys[] = {
    {"particles.surfaces.point", KEY_VECTOR, "m", "", "[0.0, 0.0, 0.0]",
     "a point of the plane or of the axis; where the origin of a file is", "",
     "", .at = KEY_AT(surface_setup, of.point)},
    KEY_END};

const struct key surface_axis_keys[] = {
    {"particles.surfaces.axis", KEY_VECTOR, "-", "", "[0.0, 0.0, 1.0]",
     "direction of the axis, of any length", "", "",
     .at = KEY_AT(surface_setup, axis)},
    KEY_END};

const struct key surface_radius_keys[] = {
    {"particles.surfaces.radius", KEY_REAL, "m", "> 0", KEY_MODEL_REQUIRED,
     "distance of the surface from its axis", "", "",
     .at = KEY_AT(surface_setup, of.radius)},
    {"particles.surfaces.particles", KEY_NAME, "", "inside | outside", "inside",
     "on which side of it they are", "", "",
     .at = KEY_AT(surface_setup, particles)},
    KEY_END};

static const struct key file_keys[] = {
    {"particles.surfaces.file", KEY_FILE, "", "", KEY_MODEL_REQUIRED,
     "STL file, text or binary; beside the case unless it begins with /", "",
     "", .at = KEY_AT(surface_setup, file)},
    {"particles.surfaces.scale", KEY_REAL, "m", "> 0", "1.0",
     "length of the file's unit: 1e-3 for millimetres", "", "",
     .at = KEY_AT(surface_setup, scale)},
    KEY_END};

const struct surface_shape surface_stl = {
    .name = "stl",
    .what = "triangles from a file; a seam, an edge, a vertex count once",
    .equations = "LS section 4.3",
    .function = "surface_contact_points_find",
    .keys = {surface_point_keys, file_keys},
    .wrong = without_triangles,
};

const struct surface_shape *const surface_shapes[] = {
    &surface_plane, &surface_cylinder, &surface_stl, NULL};
