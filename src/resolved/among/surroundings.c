/* SPDX-License-Identifier: GPL-3.0-or-later */
/* surroundings.c -- a body as the particles touch it, and as the averaged model
 * sees the flow around it. */
#include "resolved/among/among_grains.h"

#include "base/alloc.h"
#include "base/statistics.h"
#include "base/vector.h"
#include "coupling/drag.h"
#include "resolved/body_cells.h"
#include "resolved/mark.h"
#include "resolved/shapes/shapes.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- body surface --------------------------------------------------------- */

static struct triangles *triangles_of_body(void *owner,
                                           const struct body_shape *shape,
                                           const double centre[3])
{
    const struct body_outline *const o = shape->outline;
    const int n = o != NULL ? o->n_triangles : block_triangles_count(shape);
    double(*const t)[3][3] = alloc_zeroed((size_t)n, sizeof *t);

    for (int c = 0; c < 9 * n && o != NULL; c++)
        t[c / 9][c / 3 % 3][c % 3] =
            centre[c % 3] + o->corner[c / 9][c / 3 % 3][c % 3];
    if (o == NULL) block_triangles_put(shape, centre, t);
    struct triangles *const made = owner_join(owner, triangles_create(n, t));
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

struct surface body_surface(void *owner, const struct solid_bodies *b, int i)
{
    const struct body_shape *const shape = &b->shape[i];
    struct surface s = {.name = "a body", .shape = &surface_stl};
    const double x[3] = {b->ps->x[i], b->ps->y[i], b->ps->z[i]};

    memcpy(s.point, x, sizeof s.point);
    s.radius = shape->half[0];
    memcpy(s.normal, shape->axis, sizeof s.normal);
    if (shape->kind == BODY_SPHERE)
        s.shape = &surface_sphere;
    else if (shape->kind == BODY_CYLINDER && reaches_through(b, shape))
        s.shape = &surface_cylinder;
    else
        s.triangles = triangles_of_body(owner, shape, x);
    return s;
}

/* --- surroundings --------------------------------------------------------- */

struct surroundings_filter {
    const struct solid_bodies *b;
    const struct fluid *fl;
    double width; /* [m] */
    double *chi;  /* [-] fluid fraction of each cell of the mesh */
    /* Of the cells in a cube: */
    double *V, *share, *u; /* [m^3], chi, [m/s] 3 */
    int *box;              /* 0: all are in the one box */
};

struct surroundings_filter *surroundings_create(const struct solid_bodies *b,
                                                const struct fluid *fl,
                                                double width)
{
    struct surroundings_filter *const f = owner_create(sizeof *f);
    const int cells = fl->mesh->n_cells;

    f->b = b;
    f->fl = fl;
    f->width = width;
    f->chi = owner_doubles(f, cells);
    f->V = owner_doubles(f, cells);
    f->share = owner_doubles(f, cells);
    f->u = owner_doubles(f, 3 * cells);
    f->box = owner_ints(f, cells);
    return f;
}

static void take_solid(void *by, int i, int c, const double r[3], double s)
{
    struct surroundings_filter *const f = by;

    (void)i, (void)r;
    f->chi[c] = fmax(f->chi[c] - mark_fraction(f->fl->mesh, c, s), 0.0);
}

void surroundings_bind(struct surroundings_filter *f)
{
    for (int c = 0; c < f->fl->mesh->n_cells; c++)
        f->chi[c] = 1.0;
    for (int i = 0; i < f->b->ps->n; i++)
        body_cells_each(f->b, f->fl->mesh, i, HUGE_VAL, take_solid, f);
}

/* Copies the cells whose centres are in the cube around x; returns how many. */
static int collect(struct surroundings_filter *f, const double x[3])
{
    const double half = 0.5 * f->width, extent[3] = {half, half, half};
    const struct mesh *const m = f->fl->mesh;
    const struct cell_window w = cell_window_around(m, x, extent);
    double r[3];
    int at[3], n = 0;

    CELL_WINDOW_EACH (at, w) {
        const int c = cell_window_cell(m, at, x, r);
        if (fabs(r[0]) > half || fabs(r[1]) > half || fabs(r[2]) > half)
            continue;
        f->V[n] = m->V[c];
        f->share[n] = f->chi[c];
        memcpy(&f->u[3 * n++], &f->fl->u[3 * c], 3 * sizeof *f->u);
    }
    return n;
}

struct surroundings surroundings_of(struct surroundings_filter *f, int i)
{
    const struct particles *const ps = f->b->ps;
    const double x[3] = {ps->x[i], ps->y[i], ps->z[i]};
    const double d = cbrt(6.0 * f->b->volume[i] / M_PI);
    struct surroundings s = {.eps = 1.0};

    filter_boxes(collect(f, x), f->V, f->share, f->box, 3, f->u, 1, s.u,
                 &s.eps);
    const double slip[3] = {s.u[0] - ps->vx[i], s.u[1] - ps->vy[i],
                            s.u[2] - ps->vz[i]};
    const double w = vector_length(slip);

    if (w > 0.0) /* mu may be 0 */
        s.Re = coefficient_reynolds(s.eps, f->b->rho, f->fl->options.mu, d, w);
    if (w > 0.0 && s.eps > 0.0)
        s.Cd = coefficient_of_force(vector_dot(&f->b->force[3 * i], slip) / w,
                                    f->b->rho, d, s.eps, w);
    return s;
}
