/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surfaces/surface_start.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double most = 0.1; /* [-] of the radius */

/* Distance of x from the surface, or R if it is farther [m]. */
static double surface_start_distance_to(const struct surface *s,
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
    const double r = surface_start_distance_to(s, &p, x, R, near);

    if (r >= (1.0 - most) * R) return 0;
    if (r < 0.0)
        fprintf(
            stderr,
            "winnow: %sparticle %d at [%g, %g, %g] m begins %g m deep in the "
            "surface \"%s\"\n",
            where, ps->id[i], x[0], x[1], x[2], -r, s->name);
    else
        fprintf(stderr,
                "winnow: %sparticle %d at [%g, %g, %g] m begins %g m from the "
                "surface \"%s\", less than its radius %g m\n",
                where, ps->id[i], x[0], x[1], x[2], r, s->name, R);
    return 1;
}

double surface_start_distance(const struct surface *s, const double x[3],
                              double R)
{
    const struct pose p = motion_pose(&s->motion, 0.0);
    struct triangle_list near = {0, 0, NULL};
    const double r = surface_start_distance_to(s, &p, x, R, &near);

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
