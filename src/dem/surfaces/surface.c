/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surfaces/surface.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/vector.h"
#include "dem/surfaces/triangle.h"

static struct surface_hit meet_plane(const struct surface *s, const double y[3])
{
    struct surface_hit h;
    double from[3];

    vector_between(y, s->point, from);
    h.r = vector_dot(from, s->normal);
    memcpy(h.n, s->normal, sizeof h.n);
    vector_along(y, -h.r, h.n, h.q);
    return h;
}

/* Some unit vector across the axis, for a point on it. */
static void across(const double axis[3], double e[3])
{
    const double other[3] = {fabs(axis[0]) < 0.5, fabs(axis[0]) >= 0.5, 0.0};

    vector_cross(axis, other, e);
    const double length = vector_length(e);
    for (int k = 0; k < 3; k++)
        e[k] /= length;
}

static struct surface_hit meet_cylinder(const struct surface *s,
                                        const double y[3])
{
    struct surface_hit h;
    double from[3], out[3];

    vector_between(y, s->point, from);
    vector_along(from, -vector_dot(from, s->normal), s->normal, out);
    const double rho = vector_length(out), side = s->inside ? -1.0 : 1.0;
    if (rho > 0.0)
        for (int k = 0; k < 3; k++)
            h.n[k] = side * out[k] / rho;
    else
        across(s->normal, h.n);
    h.r = side * (rho - s->radius);
    vector_along(y, -h.r, h.n, h.q);
    return h;
}

static struct surface_hit meet_sphere(const struct surface *s,
                                      const double y[3])
{
    static const double any[3] = {0.0, 1.0, 0.0};
    struct surface_hit h;
    double out[3];

    vector_between(y, s->point, out);
    const double r = vector_length(out);
    for (int k = 0; k < 3; k++)
        h.n[k] = r > 0.0 ? out[k] / r : any[k];
    h.r = r - s->radius;
    vector_along(y, -h.r, h.n, h.q);
    return h;
}

/* A centre in the triangle itself has no side: it is given one. */
static struct surface_hit meet_triangle(const double corner[3][3],
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
    switch (s->shape) {
    case SURFACE_PLANE:
        return meet_plane(s, y);
    case SURFACE_CYLINDER:
        return meet_cylinder(s, y);
    case SURFACE_SPHERE:
        return meet_sphere(s, y);
    default:
        return meet_triangle((const double(*)[3])s->triangles->corner[face], y);
    }
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
    if (s->shape == SURFACE_TRIANGLES) return 0;
    return surface_nearest_moved(s, 0, p, x).r < -R;
}

double surface_reach(const struct surface *s, const double lo[3],
                     const double hi[3])
{
    const int own = s->shape == SURFACE_TRIANGLES;
    double far[3];

    if (s->shape == SURFACE_SPHERE) return s->radius;
    for (int k = 0; k < 3; k++) {
        const double from = own ? s->triangles->lo[k] : lo[k];
        const double to = own ? s->triangles->hi[k] : hi[k];
        far[k] = fmax(fabs(from - s->motion.centre[k]),
                      fabs(to - s->motion.centre[k]));
    }
    return vector_length(far);
}

int surface_wrong(const struct surface *s)
{
    const char *what = NULL;

    if (s->shape == SURFACE_TRIANGLES)
        what = s->triangles == NULL ? "it has no triangles" : NULL;
    else if (s->shape != SURFACE_SPHERE &&
             fabs(vector_length(s->normal) - 1.0) > 1e-9)
        what = "its normal or axis has no direction";
    else if (s->shape != SURFACE_PLANE && !(s->radius > 0.0))
        what = "its radius is not > 0";
    if (what != NULL)
        fprintf(stderr, "winnow: surface \"%s\": %s\n", s->name, what);
    return what != NULL;
}

static const struct key point_keys[] = {
    {"particles.surfaces.point", KEY_VECTOR, "m", "", "[0.0, 0.0, 0.0]",
     "a point of the plane or of the axis; where the origin of a file is", "",
     ""},
    KEY_END};

static const struct key plane_keys[] = {
    {"particles.surfaces.normal", KEY_VECTOR, "-", "", "[0.0, 1.0, 0.0]",
     "from the plane to the particles, of any length", "", ""},
    KEY_END};

static const struct key cylinder_keys[] = {
    {"particles.surfaces.axis", KEY_VECTOR, "-", "", "[0.0, 0.0, 1.0]",
     "direction of the cylinder, of any length", "", ""},
    {"particles.surfaces.radius", KEY_REAL, "m", "> 0", KEY_OPTIONAL,
     "of the cylinder; asked for by it", "", ""},
    {"particles.surfaces.particles", KEY_NAME, "", "inside | outside", "inside",
     "where they are, of a cylinder", "", ""},
    KEY_END};

static const struct key file_keys[] = {
    {"particles.surfaces.file", KEY_FILE, "", "", KEY_OPTIONAL,
     "STL file, text or binary; beside the case unless it begins with /", "",
     ""},
    {"particles.surfaces.scale", KEY_REAL, "m", "> 0", "1.0",
     "length of the file's unit: 1e-3 for millimetres", "", ""},
    KEY_END};

const struct model surface_plane = {
    .name = "plane",
    .what = "its solid behind it, no end",
    .equations = "",
    .function = "surface_nearest",
    .keys = {point_keys, plane_keys},
    .value = SURFACE_PLANE,
};

const struct model surface_cylinder = {
    .name = "cylinder",
    .what = "the particles inside or outside, no ends",
    .equations = "",
    .function = "surface_nearest",
    .keys = {point_keys, cylinder_keys},
    .value = SURFACE_CYLINDER,
};

const struct model surface_stl = {
    .name = "stl",
    .what = "triangles from a file; a seam, an edge, a vertex count once",
    .equations = "LS section 4.3",
    .function = "surface_contact_points_find",
    .keys = {point_keys, file_keys},
    .value = SURFACE_TRIANGLES,
};
