/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sphere.c -- the outside of a sphere, for bodies in a fluid: a case cannot
 * choose it.  Chapter "Walls".
 */
#include "dem/surfaces/surface.h"

#include "base/vector.h"

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
