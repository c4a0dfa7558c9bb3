/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mesh/poly/poly.h"
#include "averaging/averaging.h"

#include <gsl/gsl_math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "facts.h"
#include "cloud.h"
#include "warped.h"

enum { N = 200, M = 4 };

static const char *const meshes[] = {"box",  "sheared", "shuffled",
                                     "dual", "cyclic",  "warped"};
static const struct averaging_region half = {
    {0.3, -9.0, -9.0}, {9.0, 9.0, 9.0}, 0.1};
static const struct {
    const char *method;
    struct averaging_options o;
    int positive; /* 1: a field of particles' volumes cannot be negative */
} ways[] = {
    {"pcm", {.cap = 0.0}, 1},
    {"dpvm", {.cap = 0.0}, 1},
    {"cube", {.cap = 0.0}, 1},
    {"two-grid", {.bandwidth = 0.3}, 1},
    {"two-grid", {.bandwidth = 0.07}, 1},
    {"kernel", {.bandwidth = 0.4}, 1},
    {"kernel", {.bandwidth = 0.02}, 1}, /* reaches no centre */
    {"gaussian", {.bandwidth = 0.2}, 1},
    {"images", {.bandwidth = 0.2}, 1},
    {"images", {.bandwidth = 0.02}, 1}, /* narrower than a cell */
    {"diffusion", {.bandwidth = 0.3, .tolerance = 1e-9}, 1},
    {"diffusion", {.bandwidth = 0.3, .scheme = "series"}, 1},
    {"diffusion",
     {.bandwidth = 0.3, .scheme = "sdirk2", .tolerance = 1e-13},
     0},
    {"diffusion",
     {.bandwidth = 0.3, .scheme = "crank-nicolson", .tolerance = 1e-13},
     0},
    {"diffusion",
     {.bandwidth = 0.3, .scheme = "implicit-euler", .tolerance = 1e-13},
     1},
    {"diffusion", {.bandwidth = 0.3, .vary = "cells", .tolerance = 1e-9}, 1},
    {"diffusion", {.bandwidth = 0.3, .vary = "grains", .tolerance = 1e-9}, 1},
    {"diffusion", {.bandwidth = 0.3, .regions = {1, &half}}, 1}};
enum { MESHES = 6, WAYS = sizeof ways / sizeof *ways };

static struct mesh *mesh_named(const char *name)
{
    char dir[128];

    if (strcmp(name, "warped") == 0) return warped();
    snprintf(dir, sizeof dir, "tests/data/poly/%s", name);
    struct mesh *const m = poly_read(dir, NULL);
    ck_assert_ptr_nonnull(m);
    return m;
}

/* N particles where it is hard: on the corners of the mesh, on the middles of
 * faces, those of walls among them, near centres, and almost at a corner. From
 * a tenth of a cell's width to three of them. */
static struct particles *everywhere(const struct mesh *m)
{
    struct particles *const ps = particles_create(N);
    const struct mesh_shape *const s = m->shape;
    uint64_t state = 17;

    for (int i = 0; i < N; i++) {
        const int c = i % m->n_cells, p = 7 * i % s->n_points;
        const int corner = s->corner[s->start[s->polygon[s->cell_start[c]]]];
        const double *const centre = &m->centre[3 * c];
        const double width = cbrt(m->V[c]);
        double x[3];
        for (int k = 0; k < 3; k++)
            x[k] = i % 4 == 0   ? s->point[3 * p + k]
                   : i % 4 == 1 ? m->face_centre[3 * (11 * i % m->n_faces) + k]
                   : i % 4 == 2
                       ? centre[k] + 0.1 * width * (cloud_random(&state) - 0.5)
                       : 0.01 * centre[k] + 0.99 * s->point[3 * corner + k];
        cloud_place(ps, x[0], x[1], x[2],
                    width * (0.1 + 2.9 * cloud_random(&state)));
    }
    return ps;
}

/* Cells of any shape: nothing is lost by any method [SX15 A.1a-A.1c], the way
 * back is the adjoint, and gives a constant back. Rounding of some hundred
 * terms, times a hundred. */
FACT_FOR_EACH(all_methods_conserve_on_any_mesh, MESHES *WAYS)
{
    struct mesh *const m = mesh_named(meshes[_i / WAYS]);
    struct particles *const ps = everywhere(m);
    struct averaging *const a =
        averaging_create(averaging_method_named(ways[_i % WAYS].method), m, ps,
                         &ways[_i % WAYS].o);
    double *const field = alloc_doubles(M * m->n_cells);
    double *const f = alloc_doubles(M * m->n_cells);
    double q[M * N], g[M * N], off[M] = {0.0}, size[M] = {0.0};
    double work = 0.0, gross = 0.0;

    cloud_numbers(3, M * N, q);
    cloud_numbers(4, M * m->n_cells, f);
    for (int i = 0; i < N; i++)
        q[M * i] = particles_volume(ps, i);
    for (int c = 0; c < m->n_cells; c++)
        f[M * c + 1] = 1.0;
    ck_assert_int_eq(averaging_bind(a), 0);
    averaging_spread(a, M, q, field);
    if (ways[_i % WAYS].positive)
        ck_assert_double_lt(averaging_report(a)->negative, 1e-6);
    averaging_gather(a, M, f, g);
    for (int i = 0; i < M * N; i++) {
        off[i % M] -= q[i];
        size[i % M] += fabs(q[i]);
        work -= q[i] * g[i];
        gross += fabs(q[i] * g[i]);
        if (i % M == 1) ck_assert_double_eq_tol(g[i], 1.0, 1e-12);
    }
    for (int e = 0; e < M * m->n_cells; e++) {
        off[e % M] += m->V[e / M] * field[e];
        work += m->V[e / M] * field[e] * f[e];
    }
    for (int k = 0; k < M; k++)
        ck_assert_double_lt(fabs(off[k]) / size[k], 1e-13);
    ck_assert_double_lt(fabs(work) / gross, 1e-11);
    free(field);
    free(f);
    averaging_free(a);
    particles_free(ps);
    mesh_free(m);
}

/* What the diffusion leaves out on links that are not normal to their faces:
 * the second moment of a grain's share is b^2 / 2 times D of (4.7), and not the
 * unit. To the tolerance of the series, and what the far walls reflect. */
FACT(a_sheared_box_smears_along_its_diagonal)
{
    const double s = 0.3, b = 3.0;
    const struct box_spec spec = {
        {41.0, 41.0, 1.0}, {41, 41, 1}, {1.0, 1.0, 1.0}, {0, 0, 0}};
    struct mesh *const m =
        mesh_create_sheared(&spec, (const double[3]){s, 0.0, 0.0});
    struct particles *const ps = particles_create(1);
    const double at[3] = {20.5 + s * 20.5, 20.5, 0.5};
    const struct averaging_options o = {.bandwidth = b, .tolerance = 1e-10};
    double *const field = alloc_doubles(m->n_cells);
    double moment[3] = {0.0}; /* xx, xy, yy */
    const double one = 1.0;

    cloud_place(ps, at[0], at[1], at[2], 0.3);
    struct averaging *const a =
        averaging_create(averaging_method_named("diffusion"), m, ps, &o);
    ck_assert_int_eq(averaging_bind(a), 0);
    averaging_spread(a, 1, &one, field);
    for (int c = 0; c < m->n_cells; c++) {
        const double x = m->centre[3 * c] - at[0];
        const double y = m->centre[3 * c + 1] - at[1];
        const double share = field[c] * m->V[c] * 2.0 / (b * b);
        moment[0] += share * x * x;
        moment[1] += share * x * y;
        moment[2] += share * y * y;
    }
    ck_assert_double_eq_tol(moment[0], 1.0 + 2.0 * s * s, 1e-6);
    ck_assert_double_eq_tol(moment[1], s, 1e-6);
    ck_assert_double_eq_tol(moment[2], 1.0, 1e-6);
    free(field);
    averaging_free(a);
    particles_free(ps);
    mesh_free(m);
}

/* A kernel that is 1 all over the mesh gives each cell its part of the volume:
 * cells of all sizes, and the mean in all of them. Not round a period, where
 * there is no end to the mesh. */
FACT_FOR_EACH(a_very_wide_kernel_gives_the_mean_on_any_mesh, 10)
{
    static const char *const closed[] = {"box", "sheared", "shuffled", "dual",
                                         "warped"};
    const struct averaging_options o = {.bandwidth = 1e6};
    struct mesh *const m = mesh_named(closed[_i / 2]);
    struct particles *const ps = everywhere(m);
    struct averaging *const a = averaging_create(
        averaging_method_named(_i % 2 ? "kernel" : "gaussian"), m, ps, &o);
    double *const field = alloc_doubles(m->n_cells);
    double q[N], all = 0.0;

    for (int i = 0; i < N; i++)
        q[i] = 1.0;
    for (int c = 0; c < m->n_cells; c++)
        all += m->V[c];
    ck_assert_int_eq(averaging_bind(a), 0);
    averaging_spread(a, 1, q, field);
    for (int c = 0; c < m->n_cells; c++)
        ck_assert_double_eq_tol(field[c] * all / N, 1.0, 1e-10);
    free(field);
    averaging_free(a);
    particles_free(ps);
    mesh_free(m);
}
