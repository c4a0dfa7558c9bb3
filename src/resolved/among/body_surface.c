/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/among/body_surface.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "resolved/shapes/block_triangles.h"

/* Sides of the prism in place of a cylinder: it is thinner by 1.2e-3 of the
 * radius in between. */
enum { SIDES = 64 };

static struct triangles *triangles_of_block(const double centre[3],
                                            const struct body_shape *shape)
{
    const int n = block_triangles_count(shape, SIDES);
    double(*const t)[3][3] = alloc_zeroed((size_t)n, sizeof *t);

    block_triangles_put(shape, SIDES, centre, t);
    struct triangles *const made = triangles_create(n, t);
    free(t);
    return made;
}

static struct triangles *triangles_of_outline(const double centre[3],
                                              const struct body_outline *o)
{
    double(*const t)[3][3] = alloc_zeroed((size_t)o->n_triangles, sizeof *t);

    for (int c = 0; c < 9 * o->n_triangles; c++)
        t[c / 9][c / 3 % 3][c % 3] =
            centre[c % 3] + o->corner[c / 9][c / 3 % 3][c % 3];
    struct triangles *const made = triangles_create(o->n_triangles, t);
    free(t);
    return made;
}

/* 1 if both ends of a cylinder are out of the box. */
static int reaches_through(const struct solid_bodies *b,
                           const struct body_shape *shape)
{
    double across = 0.0;

    for (int k = 0; k < 3; k++)
        across +=
            fabs(shape->axis[k]) * (b->contacts.hi[k] - b->contacts.lo[k]);
    return shape->half[1] >= across;
}

struct surface body_surface(const struct solid_bodies *b, int i)
{
    const struct body_shape *const shape = &b->shape[i];
    struct surface s = {.name = "a body", .shape = &surface_stl};
    const double x[3] = {b->ps->x[i], b->ps->y[i], b->ps->z[i]};

    memcpy(s.point, x, sizeof s.point);
    s.radius = shape->half[0];
    memcpy(s.normal, shape->axis, sizeof s.normal);
    if (shape->kind == BODY_SPHERE)
        s.shape = &surface_sphere;
    else if (shape->kind == BODY_OUTLINE)
        s.triangles = triangles_of_outline(x, shape->outline);
    else if (shape->kind == BODY_CYLINDER && reaches_through(b, shape))
        s.shape = &surface_cylinder;
    else
        s.triangles = triangles_of_block(x, shape);
    return s;
}

void body_surface_release(struct surface *s)
{
    struct triangles *own;

    memcpy(&own, &s->triangles, sizeof own);
    triangles_free(own);
}
