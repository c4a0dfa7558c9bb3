/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surfaces/surface.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "dem/surfaces/triangles.h"

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
     "", KEY_AT(surface_setup, of.point)},
    KEY_END};

const struct key surface_axis_keys[] = {{"particles.surfaces.axis", KEY_VECTOR,
                                         "-", "", "[0.0, 0.0, 1.0]",
                                         "direction of the axis, of any length",
                                         "", "", KEY_AT(surface_setup, axis)},
                                        KEY_END};

const struct key surface_radius_keys[] = {
    {"particles.surfaces.radius", KEY_REAL, "m", "> 0", KEY_MODEL_REQUIRED,
     "distance of the surface from its axis", "", "",
     KEY_AT(surface_setup, of.radius)},
    {"particles.surfaces.particles", KEY_NAME, "", "inside | outside", "inside",
     "on which side of it they are", "", "", KEY_AT(surface_setup, particles)},
    KEY_END};

static const struct key file_keys[] = {
    {"particles.surfaces.file", KEY_FILE, "", "", KEY_MODEL_REQUIRED,
     "STL file, text or binary; beside the case unless it begins with /", "",
     "", KEY_AT(surface_setup, file)},
    {"particles.surfaces.scale", KEY_REAL, "m", "> 0", "1.0",
     "length of the file's unit: 1e-3 for millimetres", "", "",
     KEY_AT(surface_setup, scale)},
    KEY_END};

const struct surface_shape surface_stl = {
    .name = "stl",
    .what = "triangles from a file; a place that several share counts once",
    .equations = "LS section 4.3",
    .function = "surface_contact_points_find",
    .keys = {surface_point_keys, file_keys},
    .wrong = without_triangles,
};

const struct surface_shape *const surface_shapes[] = {
    &surface_plane, &surface_cylinder, &surface_stl, NULL};

/* --- plane ---------------------------------------------------------------- */

static struct surface_hit nearest_on_plane(const struct surface *s,
                                           const double y[3])
{
    struct surface_hit h;
    double from[3];

    vector_between(y, s->point, from);
    h.r = vector_dot(from, s->normal);
    memcpy(h.n, s->normal, sizeof h.n);
    vector_along(y, -h.r, h.n, h.q);
    return h;
}

static const struct key plane_keys[] = {
    {"particles.surfaces.normal", KEY_VECTOR, "-", "", "[0.0, 1.0, 0.0]",
     "from the plane to the particles, of any length", "", "",
     KEY_AT(surface_setup, of.normal)},
    KEY_END};

const struct surface_shape surface_plane = {
    .name = "plane",
    .what = "an infinite plane with its solid behind it",
    .equations = "",
    .function = "nearest_on_plane",
    .keys = {surface_point_keys, plane_keys},
    .nearest = nearest_on_plane,
    .wrong = surface_wrong_direction,
};

/* --- cylinder ------------------------------------------------------------- */

static struct surface_hit nearest_on_cylinder(const struct surface *s,
                                              const double y[3])
{
    struct surface_hit h;
    double from[3], out[3], across[3];

    vector_between(y, s->point, from);
    vector_along(from, -vector_dot(from, s->normal), s->normal, out);
    const double rho = vector_length(out), side = s->inside ? -1.0 : 1.0;
    if (rho > 0.0)
        for (int k = 0; k < 3; k++)
            h.n[k] = side * out[k] / rho;
    else
        vectors_across(s->normal, h.n, across); /* any: it is on the axis */
    h.r = side * (rho - s->radius);
    vector_along(y, -h.r, h.n, h.q);
    return h;
}

static const char *cylinder_wrong(const struct surface *s)
{
    const char *const what = surface_wrong_direction(s);
    return what != NULL ? what : surface_wrong_radius(s);
}

const struct surface_shape surface_cylinder = {
    .name = "cylinder",
    .what = "an infinite cylinder, with the particles inside or outside",
    .equations = "",
    .function = "nearest_on_cylinder",
    .keys = {surface_point_keys, surface_axis_keys, surface_radius_keys},
    .nearest = nearest_on_cylinder,
    .wrong = cylinder_wrong,
};

/* --- sphere --------------------------------------------------------------- */

static struct surface_hit nearest_on_sphere(const struct surface *s,
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

static double sphere_reach(const struct surface *s)
{
    return s->radius;
}

const struct surface_shape surface_sphere = {
    .name = "sphere",
    .what = "the particles outside",
    .equations = "",
    .function = "nearest_on_sphere",
    .nearest = nearest_on_sphere,
    .reach = sphere_reach,
    .wrong = surface_wrong_radius,
};

/* --- surface start -------------------------------------------------------- */

static const double most = 0.1; /* [-] of the radius */

/* Distance of x from the surface, or R if it is farther [m]. */
static double surface_distance_from(const struct surface *s,
                                    const struct pose *p, const double x[3],
                                    double R, struct triangle_list *near)
{
    double r = R, y[3];

    if (s->triangles == NULL) return surface_nearest_moved(s, 0, p, x).r;
    motion_origin(p, x, y);
    triangles_near(s->triangles, y, R, near);
    for (int q = 0; q < near->n; q++)
        r = fmin(r, surface_nearest(s, near->number[q], y).r);
    return r;
}

static int starts_wrong(const struct particles *ps, int i,
                        const struct surface *s, struct triangle_list *near,
                        const char *where)
{
    const struct pose p = motion_pose(&s->motion, 0.0);
    const double x[3] = {ps->x[i], ps->y[i], ps->z[i]}, R = 0.5 * ps->d[i];
    const double r = surface_distance_from(s, &p, x, R, near);

    if (r >= (1.0 - most) * R) return 0;
    if (r < 0.0)
        fprintf(stderr,
                "winnow: %sparticle %d at [%g, %g, %g] m begins %g m deep in "
                "the surface \"%s\"\n",
                where, ps->id[i], x[0], x[1], x[2], -r, s->name);
    else
        fprintf(stderr,
                "winnow: %sparticle %d at [%g, %g, %g] m begins %g m from the "
                "surface \"%s\", less than its radius %g m\n",
                where, ps->id[i], x[0], x[1], x[2], r, s->name, R);
    return 1;
}

double surface_distance(const struct surface *s, double t, const double x[3],
                        double R)
{
    const struct pose p = motion_pose(&s->motion, t);
    struct triangle_list near = {0, 0, NULL};
    const double r = surface_distance_from(s, &p, x, R, &near);

    free(near.number);
    return r;
}

int surface_start_wrong(const struct particles *ps, const struct surface *list,
                        int n, const char *where)
{
    struct triangle_list near = {0, 0, NULL};
    int wrong = 0;

    for (int i = 0; i < ps->n && !wrong; i++)
        for (int s = 0; s < n && !wrong; s++)
            wrong = starts_wrong(ps, i, &list[s], &near, where);
    free(near.number);
    return wrong;
}
