/* SPDX-License-Identifier: GPL-3.0-or-later */
/* outlines.c -- clumps, closed surfaces and blocks for display: each
 * ball of a clump as a point in body_clumps.pvd, triangles in
 * body_surfaces.pvd. */
#include "record/recorder_part.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "output/series.h"
#include "resolved/solid_bodies.h"

struct outlines {
    const struct solid_bodies *bodies;
    struct series *clumps, *surfaces; /* NULL: there are none */
    int n_balls, n_triangles;
    double *x[3], *d;           /* [m] of the balls */
    double *corner;             /* [m] of the triangles, 9 each */
    int *of_ball, *of_triangle; /* [-] the body of each */
    int *number, *end;          /* [-] points of the triangles */
};

static void outlines_release(void *record)
{
    struct outlines *const r = record;

    series_free(r->clumps);
    series_free(r->surfaces);
    for (int k = 0; k < 3; k++)
        free(r->x[k]);
    free(r->d);
    free(r->corner);
    free(r->of_ball);
    free(r->of_triangle);
    free(r->number);
    free(r->end);
    free(r);
}

/* Balls are shown of what consists of them, not the points of a surface. */
static int balls_of(const struct body_outline *o)
{
    return o->n_triangles == 0 ? o->n_balls : 0;
}

static void outlines_count(struct outlines *r)
{
    for (int i = 0; i < r->bodies->ps->n; i++) {
        const struct body_outline *const o = r->bodies->shape[i].outline;
        if (o == NULL) continue;
        r->n_balls += balls_of(o);
        r->n_triangles += o->n_triangles;
    }
}

static void outlines_make_room(struct outlines *r)
{
    for (int k = 0; k < 3; k++)
        r->x[k] = alloc_doubles(r->n_balls);
    r->d = alloc_doubles(r->n_balls);
    r->of_ball = alloc_ints(r->n_balls);
    r->corner = alloc_doubles(9 * r->n_triangles);
    r->of_triangle = alloc_ints(r->n_triangles);
    r->number = alloc_ints(3 * r->n_triangles);
    r->end = alloc_ints(r->n_triangles);
    for (int c = 0; c < 3 * r->n_triangles; c++)
        r->number[c] = c;
    for (int t = 0; t < r->n_triangles; t++)
        r->end[t] = 3 * (t + 1);
}

static void *outlines_create(const struct recorder_view *v, int *failed)
{
    const struct solid_bodies *const b = recorder_bodies_of(v->sim);
    if (b == NULL || b->turn == NULL) return NULL;
    struct outlines *const r = alloc_zeroed(1, sizeof *r);
    r->bodies = b;
    outlines_count(r);
    outlines_make_room(r);
    if (r->n_balls > 0) r->clumps = series_in(v->folder, "body_clumps", "vtp");
    if (r->n_triangles > 0)
        r->surfaces = series_in(v->folder, "body_surfaces", "vtp");
    if ((r->n_balls == 0 || r->clumps != NULL) &&
        (r->n_triangles == 0 || r->surfaces != NULL))
        return r;
    *failed = 1;
    outlines_release(r);
    return NULL;
}

/* Where the balls and the triangles are now. */
static void outlines_place(struct outlines *r)
{
    const struct particles *const ps = r->bodies->ps;
    int ball = 0, triangle = 0;

    for (int i = 0; i < ps->n; i++) {
        const struct body_shape *const shape = &r->bodies->shape[i];
        const double at[3] = {ps->x[i], ps->y[i], ps->z[i]};
        if (shape->outline == NULL) continue;
        for (int k = 0; k < balls_of(shape->outline); k++, ball++) {
            const struct body_ball b = body_shape_ball(shape, k);
            for (int e = 0; e < 3; e++)
                r->x[e][ball] = at[e] + b.at[e];
            r->d[ball] = 2.0 * b.R;
            r->of_ball[ball] = i;
        }
        for (int t = 0; t < shape->outline->n_triangles; t++, triangle++) {
            for (int c = 0; c < 9; c++)
                r->corner[9 * triangle + c] =
                    at[c % 3] + vector_dot(shape->turn[c % 3],
                                           shape->outline->corner[t][c / 3]);
            r->of_triangle[triangle] = i;
        }
    }
}

static int add_clumps(struct outlines *r, double t)
{
    const struct vtk_array arrays[] = {
        {.name = "diameter", .components = 1, .values = r->d, .single = 1},
        {.name = "body", .components = 1, .ints = r->of_ball}};
    const double *const x[3] = {r->x[0], r->x[1], r->x[2]};
    return series_add_particles(r->clumps, r->n_balls, x, t, 2, arrays);
}

static int outlines_add_surfaces(struct outlines *r, double t)
{
    const struct vtk_polygons shape = {3 * r->n_triangles, r->n_triangles,
                                       r->corner, r->number, r->end};
    const struct vtk_array of = {
        .name = "body", .components = 1, .ints = r->of_triangle};

    return series_add_polygons(r->surfaces, &shape, t, 1, &of);
}

static int outlines_add(void *record, double t)
{
    struct outlines *const r = record;

    outlines_place(r);
    return (r->clumps != NULL && add_clumps(r, t) != 0) ||
           (r->surfaces != NULL && outlines_add_surfaces(r, t) != 0);
}

static void outlines_visit(void *record, struct state *s)
{
    struct outlines *const r = record;

    state_begin(s, "outlines_record");
    if (r->clumps != NULL) series_state(r->clumps, s);
    if (r->surfaces != NULL) series_state(r->surfaces, s);
    state_end(s);
}

const struct recorder_part recorder_outlines = {.create = outlines_create,
                                                .free = outlines_release,
                                                .fields = outlines_add,
                                                .state = outlines_visit};
