/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cylinder.c -- a cylinder without ends.  Chapter "Walls". */
#include "dem/surfaces/surface.h"

#include <math.h>

#include "base/vector.h"

/* Some unit vector across the axis, for a point on it. */
static void cylinder_across(const double axis[3], double e[3])
{
    const double other[3] = {fabs(axis[0]) < 0.5, fabs(axis[0]) >= 0.5, 0.0};

    vector_cross(axis, other, e);
    const double length = vector_length(e);
    for (int k = 0; k < 3; k++)
        e[k] /= length;
}

static struct surface_hit nearest_on_cylinder(const struct surface *s,
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
        cylinder_across(s->normal, h.n);
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
