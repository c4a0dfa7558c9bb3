/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/interpolation.h"

#include <gsl/gsl_math.h>
#include <stdlib.h>
#include <string.h>

#include "averaging/cell_of_particle.h"
#include "base/alloc.h"
#include "facts.h"
#include "cloud.h"

enum { N = 120, M = 3 };

struct scene {
    struct mesh *mesh;
    struct particles *ps;
    struct averaging *a;
    double *field, *boundary, *q;
};

static struct scene scene_of(const struct box_spec *spec, const char *method)
{
    const struct averaging_options o = {.bandwidth = 0.2};
    struct scene s = {.mesh = mesh_create_box(spec)};

    s.ps = cloud_create(s.mesh, N);
    s.a = averaging_create(averaging_method_named(method), s.mesh, s.ps, &o);
    s.field = alloc_doubles(M * s.mesh->n_cells);
    s.boundary = alloc_doubles(M * (s.mesh->n_faces - s.mesh->n_internal));
    s.q = alloc_doubles(M * N);
    ck_assert_int_eq(averaging_bind(s.a), 0);
    return s;
}

static void scene_free(struct scene *s)
{
    averaging_free(s->a);
    particles_free(s->ps);
    mesh_free(s->mesh);
    free(s->field);
    free(s->boundary);
    free(s->q);
}

/* Three linear fields. */
static double plane(int k, const double x[3])
{
    return 0.3 + k + (1.0 + k) * x[0] - 2.0 * x[1] + (0.5 - k) * x[2];
}

static void fill_planes(struct scene *s)
{
    const struct mesh *const m = s->mesh;

    for (int c = 0; c < m->n_cells; c++)
        for (int k = 0; k < M; k++)
            s->field[M * c + k] = plane(k, &m->centre[3 * c]);
    for (int f = m->n_internal; f < m->n_faces; f++) {
        double x[3];
        for (int j = 0; j < 3; j++)
            x[j] = m->centre[3 * m->owner[f] + j] + mesh_d(m, f)[j];
        for (int k = 0; k < M; k++)
            s->boundary[M * (f - m->n_internal) + k] = plane(k, x);
    }
}

static int touches_the_boundary(const struct mesh *m, int c)
{
    return m->cell_face[m->cell_start[c + 1] - 1] >= m->n_internal;
}

/* Rounding of gradients of order 1 on cells of 0.1. Shape 4 is graded. */
FACT(linear_is_exact_for_linear_fields_in_the_interior)
{
    struct scene s = scene_of(&cloud_shapes[4], "pcm");
    int inside = 0;

    fill_planes(&s);
    interpolation_named("linear")->apply(s.a, M, s.field, NULL, s.q);
    for (int i = 0; i < N; i++) {
        const double x[3] = {s.ps->x[i], s.ps->y[i], s.ps->z[i]};
        if (touches_the_boundary(s.mesh, averaging_cells(s.a)->cell[i]))
            continue;
        inside++;
        for (int k = 0; k < M; k++)
            ck_assert_double_eq_tol(s.q[M * i + k], plane(k, x), 1e-13);
    }
    ck_assert_int_gt(inside, 20);
    scene_free(&s);
}

/* All shapes without a period: also one cell, and one direction. */
FACT_FOR_EACH(linear_is_exact_at_boundaries_whose_values_are_given, 3)
{
    static const int closed[] = {0, 1, 4};
    struct scene s = scene_of(&cloud_shapes[closed[_i]], "pcm");

    fill_planes(&s);
    interpolation_named("linear")->apply(s.a, M, s.field, s.boundary, s.q);
    for (int i = 0; i < N; i++) {
        const double x[3] = {s.ps->x[i], s.ps->y[i], s.ps->z[i]};
        for (int k = 0; k < M; k++)
            ck_assert_double_eq_tol(s.q[M * i + k], plane(k, x), 1e-13);
    }
    scene_free(&s);
}

/* Three cells in a row, 1, 2 and 4 wide: a parabola has another slope on either
 * side of the middle one. Weighed by the inverse square of the distances, the
 * fitted slope is the mean of the two; by the distances alone it would be
 * nearer to that of the wide cell. */
FACT(a_fitted_slope_is_the_mean_of_the_slopes_on_both_sides)
{
    const struct box_spec spec = {
        {7.0, 1.0, 1.0}, {3, 1, 1}, {4.0, 1.0, 1.0}, {0, 0, 0}};
    struct mesh *const m = mesh_create_box(&spec);
    struct particles *const ps = particles_create(1);
    const struct averaging_options o = {.cap = 0.0};
    double field[3], seen;
    cloud_place(ps, 2.4, 0.5, 0.5, 0.1);
    struct averaging *const a =
        averaging_create(averaging_method_named("pcm"), m, ps, &o);
    ck_assert_int_eq(averaging_bind(a), 0);
    for (int c = 0; c < 3; c++)
        field[c] = gsl_pow_2(m->centre[3 * c]); /* at 0.5, 2, 5 */
    interpolation_named("linear")->apply(a, 1, field, NULL, &seen);
    ck_assert_double_eq_tol(seen, 4.0 + 0.4 * 0.5 * (2.5 + 7.0), 1e-12);
    averaging_free(a);
    particles_free(ps);
    mesh_free(m);
}

/* Graded, closed, in one and in three directions: without values on the
 * boundary the slope is fitted, and is all of it also in corners. Half of it,
 * as with f_f = f_c on a wall, would be off by 0.1. */
FACT_FOR_EACH(linear_without_boundary_values_is_exact_at_walls_too, 2)
{
    static const int closed[] = {1, 4};
    struct scene s = scene_of(&cloud_shapes[closed[_i]], "pcm");
    const int *const n = s.mesh->box.n;

    fill_planes(&s);
    interpolation_named("linear")->apply(s.a, M, s.field, NULL, s.q);
    for (int i = 0; i < N; i++) {
        const double *const centre =
            &s.mesh->centre[3 * averaging_cells(s.a)->cell[i]];
        const double x[3] = {n[0] > 1 ? s.ps->x[i] : centre[0],
                             n[1] > 1 ? s.ps->y[i] : centre[1],
                             n[2] > 1 ? s.ps->z[i] : centre[2]};
        for (int k = 0; k < M; k++)
            ck_assert_double_eq_tol(s.q[M * i + k], plane(k, x), 1e-13);
    }
    scene_free(&s);
}

/* Largest error of one way for a wave in a box periodic in x and y. */
static double wave_error(const char *way, int n)
{
    const struct box_spec spec = {
        {1.0, 1.0, 0.1}, {n, n, 1}, {1.0, 1.0, 1.0}, {1, 1, 1}};
    struct scene s = scene_of(&spec, "pcm");
    double worst = 0.0;

    for (int c = 0; c < s.mesh->n_cells; c++)
        s.field[c] = sin(2.0 * M_PI * s.mesh->centre[3 * c]) *
                     cos(2.0 * M_PI * s.mesh->centre[3 * c + 1]);
    interpolation_named(way)->apply(s.a, 1, s.field, NULL, s.q);
    for (int i = 0; i < N; i++)
        worst = fmax(worst, fabs(s.q[i] - sin(2.0 * M_PI * s.ps->x[i]) *
                                              cos(2.0 * M_PI * s.ps->y[i])));
    scene_free(&s);
    return worst;
}

/* The particles include those on corners and faces, where the error is at its
 * largest and of a regular size; also across the period. */
FACT(linear_is_of_second_order_and_nearest_of_first)
{
    const double linear = wave_error("linear", 20) / wave_error("linear", 40);
    const double near = wave_error("nearest", 20) / wave_error("nearest", 40);
    ck_assert_double_eq_tol(log2(linear), 2.0, 0.2);
    ck_assert_double_eq_tol(log2(near), 1.0, 0.2);
}

FACT_FOR_EACH(nearest_is_the_value_of_the_particles_cell, CLOUD_SHAPES)
{
    struct scene s = scene_of(&cloud_shapes[_i], "pcm");

    cloud_numbers(12, M * s.mesh->n_cells, s.field);
    interpolation_named("nearest")->apply(s.a, M, s.field, NULL, s.q);
    for (int i = 0; i < N; i++)
        for (int k = 0; k < M; k++)
            ck_assert(s.q[M * i + k] ==
                      s.field[M * averaging_cells(s.a)->cell[i] + k]);
    scene_free(&s);
}

FACT_FOR_EACH(same_is_the_adjoint_of_the_averaging, CLOUD_SHAPES)
{
    struct scene s = scene_of(&cloud_shapes[_i], "kernel");
    double *const g = alloc_doubles(M * N);

    cloud_numbers(13, M * s.mesh->n_cells, s.field);
    interpolation_named("same")->apply(s.a, M, s.field, NULL, s.q);
    averaging_gather(s.a, M, s.field, g);
    ck_assert_mem_eq(g, s.q, sizeof(double) * M * N);
    free(g);
    scene_free(&s);
}

FACT_FOR_EACH(every_interpolation_is_exact_for_constants, CLOUD_SHAPES)
{
    for (int w = 0; interpolations[w] != NULL; w++) {
        struct scene s = scene_of(&cloud_shapes[_i], "diffusion");
        for (int e = 0; e < M * s.mesh->n_cells; e++)
            s.field[e] = 2.5;
        interpolations[w]->apply(s.a, M, s.field, NULL, s.q);
        for (int e = 0; e < M * N; e++)
            ck_assert_double_eq_tol(s.q[e], 2.5, 1e-12);
        scene_free(&s);
    }
}

/* Capped cells too: a slip velocity cut down by the share would be wrong. */
FACT(the_cap_of_pcm_does_not_reduce_the_fluid_velocity_at_particles)
{
    const struct averaging_options o = {.cap = 0.004};
    struct scene s = scene_of(&cloud_shapes[4], "pcm");

    averaging_free(s.a);
    s.a = averaging_create(averaging_method_named("pcm"), s.mesh, s.ps, &o);
    ck_assert_int_eq(averaging_bind(s.a), 0);
    ck_assert_int_gt(averaging_report(s.a)->capped, 3);
    cloud_numbers(15, M * s.mesh->n_cells, s.field);
    interpolation_named("same")->apply(s.a, M, s.field, NULL, s.q);
    for (int i = 0; i < N; i++)
        for (int k = 0; k < M; k++)
            ck_assert_double_eq_tol(
                s.q[M * i + k], s.field[M * averaging_cells(s.a)->cell[i] + k],
                1e-15);
    scene_free(&s);
}

FACT(an_unknown_interpolation_is_not_found)
{
    ck_assert_ptr_null(interpolation_named("cubic"));
    for (int w = 0; interpolations[w] != NULL; w++)
        ck_assert_ptr_eq(interpolation_named(interpolations[w]->name),
                         interpolations[w]);
}
