/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plane.c -- a plane with its solid behind it.  Chapter "Walls". */
#include "dem/surfaces/surface.h"

#include <string.h>

#include "base/vector.h"

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
     .at = KEY_AT(surface_setup, of.normal)},
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
