/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Averaging and interpolation in other axes and other units give the same
 * numbers. */
#include "averaging/interpolation.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "facts.h"
#include "cloud.h"
#include "turned.h"

enum { N = 80, M = 4 };

static const struct averaging_region half = {
    {0.35, -9.0, -9.0}, {9.0, 9.0, 0.4}, 0.1};

static const struct {
    const char *method;
    struct averaging_options o;
} ways[] = {{"pcm", {.cap = 0.0}},
            {"pcm", {.cap = 0.004}},
            {"dpvm", {.cap = 0.0}},
            {"cube", {.cap = 0.0}},
            {"two-grid", {.bandwidth = 0.25}},
            {"kernel", {.bandwidth = 0.21}},
            {"gaussian", {.bandwidth = 0.11}},
            {"images", {.bandwidth = 0.06}},
            {"diffusion", {.bandwidth = 0.2}},
            {"diffusion", {.bandwidth = 0.2, .scheme = "series"}},
            {"diffusion", {.bandwidth = 0.2, .scheme = "crank-nicolson"}},
            {"diffusion", {.bandwidth = 0.2, .scheme = "implicit-euler"}},
            {"diffusion", {.bandwidth = 0.2, .scheme = "sdirk2"}},
            {"diffusion", {.bandwidth = 0.2, .vary = "cells"}},
            {"diffusion", {.bandwidth = 0.2, .vary = "grains"}},
            {"diffusion", {.bandwidth = 0.2, .regions = {1, &half}}}};
enum { WAYS = sizeof ways / sizeof *ways };

/* Walls on all sides; a period in one direction, in two. */
static const struct box_spec boxes[] = {
    {{0.7, 1.3, 0.9}, {4, 6, 5}, {1.5, 0.6, 2.0}, {0, 0, 0}},
    {{0.7, 1.3, 0.9}, {4, 6, 5}, {1.0, 3.0, 1.0}, {1, 0, 0}},
    {{0.9, 0.7, 1.1}, {5, 4, 6}, {1.0, 1.0, 0.5}, {1, 1, 0}}};
enum { BOXES = sizeof boxes / sizeof *boxes };

struct scene {
    double L; /* [-] units of length in a metre */
    struct mesh *m;
    struct particles *ps;
    struct averaging *a;
    double field[M * 120], q[M * N];
};

/* The region of the original in the frame. */
static struct averaging_region turned_region(const struct frame *t,
                                             const double size[3], double L)
{
    struct averaging_region to = half;
    to.bandwidth *= L;
    for (int k = 0; k < 3; k++) {
        const int a = t->axis[k], is = t->sign[k] > 0.0;
        to.low[k] = is ? half.low[a] : size[a] - half.high[a];
        to.high[k] = is ? half.high[a] : size[a] - half.low[a];
    }
    turned_scale(L, to.low);
    turned_scale(L, to.high);
    return to;
}

/* Anywhere, but on no face: which cell has a point on a face is a choice. */
static struct particles *scatter(const struct frame *t, const double size[3],
                                 double L)
{
    struct particles *const ps = particles_create(N);
    uint64_t state = 11;

    for (int i = 0; i < N; i++) {
        double x[3];
        for (int k = 0; k < 3; k++)
            x[k] = size[k] * cloud_random(&state);
        turned_place(t, size, x, x);
        turned_scale(L, x);
        particles_add(ps, x, L * (0.02 + 0.03 * cloud_random(&state)), 1000.0);
    }
    return ps;
}

static struct scene *create(const struct frame *t, double L, int way, int shape)
{
    struct scene *const s = calloc(1, sizeof *s);
    struct box_spec spec = turned_box(t, &boxes[shape]);
    const struct averaging_region region =
        turned_region(t, boxes[shape].size, L);
    struct averaging_options o = ways[way].o;

    s->L = L;
    turned_scale(L, spec.size);
    o.bandwidth *= L;
    if (o.regions.n > 0) o.regions.item = &region;
    if (o.tolerance == 0.0) o.tolerance = 1e-12;
    s->m = mesh_create_box(&spec);
    s->ps = scatter(t, boxes[shape].size, L);
    s->a = averaging_create(averaging_method_named(ways[way].method), s->m,
                            s->ps, &o);
    ck_assert_ptr_nonnull(s->a);
    ck_assert_int_eq(averaging_bind(s->a), 0);
    return s;
}

static void discard(struct scene *s)
{
    averaging_free(s->a);
    particles_free(s->ps);
    mesh_free(s->m);
    free(s);
}

/* Amounts of the particles, the first of them their volumes. */
static void spread(struct scene *s)
{
    for (int i = 0; i < N; i++)
        for (int k = 0; k < M; k++)
            s->q[M * i + k] =
                k == 0 ? particles_volume(s->ps, i)
                       : 1e-3 * sin(3.0 * i + 5.0 * k) * s->L * s->L * s->L;
    averaging_apply_cap(s->a, M, s->q);
    averaging_spread(s->a, M, s->q, s->field);
}

/* 1e-10: the tolerance of the diffusion, 1e-12, and its steps; the sums of
 * particles come in another order. */
static void assert_fields(const struct scene *a, const struct scene *b,
                          const struct frame *t)
{
    double most = 0.0;
    for (int c = 0; c < M * a->m->n_cells; c++)
        most = fmax(most, fabs(a->field[c]));
    for (int c = 0; c < a->m->n_cells; c++) {
        const int to = turned_cell(t, a->m, b->m, c);
        for (int k = 0; k < M; k++)
            ck_assert_double_eq_tol(a->field[M * c + k], b->field[M * to + k],
                                    1e-10 * most);
    }
}

/* The fields interpolated to the particles, by the adjoint and by each
 * interpolation. */
static void assert_seen(struct scene *a, struct scene *b, const struct frame *t)
{
    for (int c = 0; c < a->m->n_cells; c++) {
        const int to = turned_cell(t, a->m, b->m, c);
        for (int k = 0; k < M; k++)
            a->field[M * c + k] = b->field[M * to + k] =
                sin(2.0 * c + 7.0 * k + 0.1 * c * c);
    }
    averaging_gather(a->a, M, a->field, a->q);
    averaging_gather(b->a, M, b->field, b->q);
    for (int i = 0; i < M * N; i++)
        ck_assert_double_eq_tol(a->q[i], b->q[i], 1e-11);
    for (int w = 0; interpolations[w] != NULL; w++) {
        interpolations[w]->apply(a->a, M, a->field, NULL, a->q);
        interpolations[w]->apply(b->a, M, b->field, NULL, b->q);
        for (int i = 0; i < M * N; i++)
            ck_assert_double_eq_tol(a->q[i], b->q[i], 1e-11);
    }
}

FACT_FOR_EACH(averages_do_not_depend_on_the_axes, WAYS *BOXES)
{
    const int way = _i % WAYS, shape = _i / WAYS;
    const int frame = shape == 0 ? 4 : 5; /* turned, and mirrored, too */
    struct scene *const a = create(&turned_frames[0], 1.0, way, shape);

    spread(a);
    struct scene *const b = create(&turned_frames[frame], 1.0, way, shape);
    spread(b);
    assert_fields(a, b, &turned_frames[frame]);
    assert_seen(a, b, &turned_frames[frame]);
    discard(b);
    discard(a);
}

/* To the last bit: the unit is a power of two. */
FACT_FOR_EACH(averages_do_not_depend_on_the_unit_of_length, WAYS *BOXES)
{
    const int way = _i % WAYS, shape = _i / WAYS;
    struct scene *const a = create(&turned_frames[0], 1.0, way, shape);
    struct scene *const b =
        create(&turned_frames[0], turned_units.L, way, shape);
    spread(a);
    spread(b);
    for (int i = 0; i < M * a->m->n_cells; i++)
        ck_assert_double_eq(a->field[i], b->field[i]);
    averaging_gather(a->a, M, a->field, a->q);
    averaging_gather(b->a, M, b->field, b->q);
    for (int i = 0; i < M * N; i++)
        ck_assert_double_eq(a->q[i], b->q[i]);
    for (int w = 0; interpolations[w] != NULL; w++) {
        interpolations[w]->apply(a->a, M, a->field, NULL, a->q);
        interpolations[w]->apply(b->a, M, b->field, NULL, b->q);
        for (int i = 0; i < M * N; i++)
            ck_assert_double_eq(a->q[i], b->q[i]);
    }
    discard(a);
    discard(b);
}
