/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/averaging.h"

#include <gsl/gsl_math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "facts.h"
#include "cloud.h"

enum { N = 150, M = 8 };

/* Known properties of an averaging method. */
enum {
    POSITIVE = 1, /* cannot undershoot, at most by what its tolerance leaves;
                     Crank-Nicolson and SDIRK with 3 steps may here */
    BOUNDED = 2,  /* cannot exceed the fullest cell of pcm either */
    MOVES = 4     /* follows the particles when they move by a cell */
};

/* The region above this x has another bandwidth. */
static const struct averaging_region half = {
    {0.3, -9.0, -9.0}, {9.0, 9.0, 9.0}, 0.1};

/* Every averaging method that a case can choose. A bandwidth of 0.25 makes a
 * second grid that fits none of the meshes, and 0.03 reaches no cell centre. */
static const struct {
    const char *method;
    struct averaging_options o;
    int does;
} ways[] = {
    {"pcm", {.cap = 0.0}, POSITIVE | BOUNDED | MOVES},
    {"pcm", {.cap = 0.004}, POSITIVE | BOUNDED | MOVES},
    {"dpvm", {.cap = 0.0}, POSITIVE | MOVES},
    {"cube", {.cap = 0.0}, POSITIVE | MOVES},
    {"two-grid", {.bandwidth = 0.25}, POSITIVE},
    {"two-grid", {.bandwidth = 0.03}, POSITIVE},
    {"kernel", {.bandwidth = 0.21}, POSITIVE | MOVES},
    {"kernel", {.bandwidth = 0.03}, POSITIVE | MOVES},
    {"gaussian", {.bandwidth = 0.11}, POSITIVE | MOVES},
    {"images", {.bandwidth = 0.06}, POSITIVE | MOVES},
    {"images", {.bandwidth = 0.01}, POSITIVE | MOVES},
    {"diffusion",
     {.bandwidth = 0.2, .tolerance = 1e-9},
     POSITIVE | BOUNDED | MOVES},
    {"diffusion",
     {.bandwidth = 0.2, .scheme = "series", .tolerance = 1e-9},
     POSITIVE | BOUNDED | MOVES},
    {"diffusion",
     {.bandwidth = 0.2, .scheme = "crank-nicolson", .tolerance = 1e-13},
     MOVES},
    {"diffusion",
     {.bandwidth = 0.2, .scheme = "implicit-euler", .tolerance = 1e-13},
     POSITIVE | BOUNDED | MOVES},
    {"diffusion",
     {.bandwidth = 0.2, .scheme = "sdirk2", .tolerance = 1e-13},
     MOVES},
    {"diffusion",
     {.bandwidth = 0.2, .vary = "cells", .tolerance = 1e-9},
     POSITIVE | BOUNDED | MOVES},
    {"diffusion",
     {.bandwidth = 0.2, .vary = "grains", .tolerance = 1e-9},
     POSITIVE | BOUNDED | MOVES},
    {"diffusion",
     {.bandwidth = 0.2, .regions = {1, &half}, .tolerance = 1e-9},
     POSITIVE | BOUNDED},
};
enum { WAYS = sizeof ways / sizeof *ways, ALL = WAYS * CLOUD_SHAPES };

FACT(every_method_is_in_the_table)
{
    for (int i = 0; averaging_methods[i] != NULL; i++) {
        int found = 0;
        for (int k = 0; k < WAYS; k++)
            found += strcmp(ways[k].method, averaging_methods[i]->name) == 0;
        ck_assert_msg(found > 0, "%s", averaging_methods[i]->name);
    }
}

/* A mesh, a cloud in it, an averaging method, and M fields. */
struct scene {
    struct mesh *mesh;
    struct particles *ps;
    struct averaging *a;
    double *q, *field;
};

static struct scene scene_of(int way, int shape, int n)
{
    struct scene s = {.mesh = mesh_create_box(&cloud_shapes[shape])};
    s.ps = cloud_create(s.mesh, n);
    s.a = averaging_create(averaging_method_named(ways[way].method), s.mesh,
                           s.ps, &ways[way].o);
    s.q = alloc_doubles(M * n);
    s.field = alloc_doubles(M * s.mesh->n_cells);
    ck_assert_ptr_nonnull(s.a);
    ck_assert_int_eq(averaging_bind(s.a), 0);
    return s;
}

static void scene_free(struct scene *s)
{
    averaging_free(s->a);
    particles_free(s->ps);
    mesh_free(s->mesh);
    free(s->q);
    free(s->field);
}

/* A particle near the middle of a box of 24^3 cells, spread with b = 3 cells:
 * the variance along x is that of the Gaussian which the method says, b_G^2 /
 * 2, and a thousandth at most is beyond its reach, if it has one. Of the
 * polynomial b_G is rounded to 0.4 b, 2 % above its own; a cell adds 2 %, the
 * cut-off at 3 b takes none. */
FACT(a_method_has_the_variance_and_the_reach_that_it_says)
{
    static const struct box_spec box = {
        {1.0, 1.0, 1.0}, {24, 24, 24}, {1.0, 1.0, 1.0}, {0, 0, 0}};
    const struct averaging_options o = {.bandwidth = 0.125, .tolerance = 1e-9};
    struct mesh *const m = mesh_create_box(&box);
    struct particles *const ps = particles_create(1);
    double *const field = alloc_doubles(m->n_cells);

    cloud_place(ps, 0.4792, 0.4792, 0.4792, 0.001);
    for (int i = 0; averaging_methods[i] != NULL; i++) {
        const struct averaging_method *const method = averaging_methods[i];
        const double b = method->gaussian * o.bandwidth, one = 1.0;
        double sum = 0.0, second = 0.0, beyond = 0.0;
        if (b == 0.0) continue;
        struct averaging *const a = averaging_create(method, m, ps, &o);
        ck_assert_int_eq(averaging_bind(a), 0);
        averaging_spread(a, 1, &one, field);
        for (int c = 0; c < m->n_cells; c++) {
            const double *const x = &m->centre[3 * c];
            const double r[3] = {x[0] - 0.4792, x[1] - 0.4792, x[2] - 0.4792};
            const double phi = field[c] * m->V[c];
            sum += phi;
            second += phi * r[0] * r[0];
            if (vector_length(r) > method->reach_b * o.bandwidth) beyond += phi;
        }
        ck_assert_msg(fabs(second / sum / (0.5 * b * b) - 1.0) < 0.06,
                      "%s: variance %g", method->name, second / sum);
        ck_assert_msg(method->reach_b == 0.0 || beyond < 1e-3 * sum,
                      "%s: beyond its reach %g", method->name, beyond / sum);
        averaging_free(a);
    }
    free(field);
    particles_free(ps);
    mesh_free(m);
}

/* The three amounts of [SX15 A.1]: volume, momentum over density, a force. */
static void fill_amounts(struct scene *s)
{
    cloud_numbers(3, M * s->ps->n, s->q);
    for (int i = 0; i < s->ps->n; i++) {
        const double d = s->ps->d[i], Vp = M_PI / 6.0 * d * d * d;
        s->q[M * i] = Vp;
        for (int k = 1; k < 4; k++)
            s->q[M * i + k] *= Vp;
    }
}

/* |sum V field - sum q| over sum |q| for number k. */
static double lost_share(const struct scene *s, int k)
{
    double sum = 0.0, size = 0.0;

    for (int c = 0; c < s->mesh->n_cells; c++)
        sum += s->mesh->V[c] * s->field[M * c + k];
    for (int i = 0; i < s->ps->n; i++) {
        sum -= s->q[M * i + k];
        size += fabs(s->q[M * i + k]);
    }
    return fabs(sum) / size;
}

/* Rounding of some hundred terms of mixed sign is below 1e-14 of their sum of
 * sizes; a particle missing at a wall would be 1/150. The capped pcm conserves
 * the sum, too: the caller reduces the volumes if they are to be reduced. */
static void check_conserved(int i, int first, int last)
{
    struct scene s = scene_of(i % WAYS, i / WAYS, N);
    fill_amounts(&s);
    averaging_spread(s.a, M, s.q, s.field);
    for (int k = first; k <= last; k++)
        ck_assert_double_lt(lost_share(&s, k), 2e-14);
    scene_free(&s);
}

FACT_FOR_EACH(sx15_a_1a_volume_is_conserved, ALL)
{
    check_conserved(_i, 0, 0);
}

FACT_FOR_EACH(sx15_a_1b_momentum_is_conserved, ALL)
{
    check_conserved(_i, 1, 3);
}

FACT_FOR_EACH(sx15_a_1c_the_fluid_gets_what_the_particles_get, ALL)
{
    check_conserved(_i, 4, 7);
}

/* Spheres of 2.5 cells, on all the corners, edges, faces; a body reaches over
 * the walls, across a period, and over cells smaller than itself. */
FACT_FOR_EACH(weights_of_large_particles_sum_to_one_too, ALL)
{
    struct scene s = scene_of(_i % WAYS, _i / WAYS, N);

    for (int i = 0; i < N; i++)
        s.ps->d[i] = 0.25;
    ck_assert_int_eq(averaging_bind(s.a), 0); /* they have grown */
    fill_amounts(&s);
    averaging_spread(s.a, M, s.q, s.field);
    for (int k = 0; k < M; k++)
        ck_assert_double_lt(lost_share(&s, k), 2e-14);
    scene_free(&s);
}

/* Half-solved, the fields are wrong in shape but not in sum: the solver starts
 * from the old field and is preconditioned by V. With the diagonal of the
 * matrix instead, this graded mesh would lose 1e-4 and more. */
FACT_FOR_EACH(sx15_a_5_the_sum_is_kept_however_early_the_solver_stops, 2)
{
    static const char *const scheme[] = {"crank-nicolson", "implicit-euler"};
    const struct averaging_options o = {
        .bandwidth = 0.3, .scheme = scheme[_i], .tolerance = 0.03};
    struct scene s = scene_of(0, 4, N);

    averaging_free(s.a);
    s.a =
        averaging_create(averaging_method_named("diffusion"), s.mesh, s.ps, &o);
    fill_amounts(&s);
    ck_assert_int_eq(averaging_bind(s.a), 0);
    averaging_spread(s.a, M, s.q, s.field);
    ck_assert_double_gt(averaging_report(s.a)->worst.after, 1e-4);
    for (int k = 0; k < M; k++)
        ck_assert_double_lt(lost_share(&s, k), 2e-14);
    scene_free(&s);
}

/* For the kernel: the weights of both directions are the same [XS11 3.12].
 * Rounding again; CG adds its tolerance of 1e-13 times the condition. */
FACT_FOR_EACH(gathering_is_the_adjoint_of_spreading, ALL)
{
    struct scene s = scene_of(_i % WAYS, _i / WAYS, N);
    double *const f = alloc_doubles(M * s.mesh->n_cells);
    double *const g = alloc_doubles(M * N);
    double difference = 0.0, size = 0.0;

    cloud_numbers(4, M * N, s.q);
    cloud_numbers(5, M * s.mesh->n_cells, f);
    averaging_spread(s.a, M, s.q, s.field);
    averaging_gather(s.a, M, f, g);
    for (int e = 0; e < M * N; e++) {
        difference += s.q[e] * g[e];
        size += fabs(s.q[e] * g[e]);
    }
    for (int e = 0; e < M * s.mesh->n_cells; e++)
        difference -= s.mesh->V[e / M] * f[e] * s.field[e];
    ck_assert_double_lt(fabs(difference) / size, 1e-12);
    free(f);
    free(g);
    scene_free(&s);
}

/* Weights that sum to one, matrices without row sums. */
FACT_FOR_EACH(constants_are_gathered_as_they_are, ALL)
{
    struct scene s = scene_of(_i % WAYS, _i / WAYS, N);

    for (int e = 0; e < M * s.mesh->n_cells; e++)
        s.field[e] = 0.5 + e % M;
    averaging_gather(s.a, M, s.field, s.q);
    for (int e = 0; e < M * N; e++)
        ck_assert_double_eq_tol(s.q[e] / (0.5 + e % M), 1.0, 1e-13);
    scene_free(&s);
}

static void spread_and_gather(struct scene *s, int threads, double *f,
                              double *g)
{
    omp_set_num_threads(threads);
    ck_assert_int_eq(averaging_bind(s->a), 0);
    averaging_spread(s->a, M, s->q, f);
    averaging_gather(s->a, M, f, g);
    omp_set_num_threads(1);
}

/* Enough cells and particles for a second thread to be used. */
FACT_FOR_EACH(one_thread_and_two_give_the_same_bits, WAYS)
{
    enum { MANY = 1500 };
    const struct box_spec spec = {
        {1.0, 1.0, 0.5}, {15, 14, 6}, {1.0, 2.0, 1.0}, {1, 0, 0}};
    struct scene s = {.mesh = mesh_create_box(&spec)};
    const size_t f_size = sizeof(double) * M * (size_t)s.mesh->n_cells;
    double *const f = alloc_doubles(M * s.mesh->n_cells);
    double *const g = alloc_doubles(M * MANY);
    double *const g2 = alloc_doubles(M * MANY);
    struct averaging_options o = ways[_i].o;

    o.tolerance = 1e-4; /* bits do not ask for more, and time does */
    s.ps = cloud_create(s.mesh, MANY);
    s.a = averaging_create(averaging_method_named(ways[_i].method), s.mesh,
                           s.ps, &o);
    s.q = alloc_doubles(M * MANY);
    s.field = alloc_doubles(M * s.mesh->n_cells);
    cloud_numbers(6, M * MANY, s.q);
    spread_and_gather(&s, 1, s.field, g);
    spread_and_gather(&s, 2, f, g2);
    ck_assert_mem_eq(f, s.field, f_size);
    ck_assert_mem_eq(g, g2, sizeof(double) * M * MANY);
    free(f);
    free(g);
    free(g2);
    scene_free(&s);
}

/* The first m numbers of each row of M, row after row. */
static void narrow(int rows, int m, const double *wide, double *to)
{
    for (int e = 0; e < rows * m; e++)
        to[e] = wide[M * (e / m) + e % m];
}

static double largest_difference(int rows, int m, const double *wide,
                                 const double *narrow_one)
{
    double worst = 0.0;

    for (int e = 0; e < rows * m; e++)
        worst = fmax(worst, fabs(narrow_one[e] - wide[M * (e / m) + e % m]));
    return worst;
}

/* The number of interleaved fields must not change the results, only the speed.
 * Of order 1 / V = 1000; CG stops when the last field has converged, hence its
 * tolerance. */
FACT_FOR_EACH(fewer_fields_side_by_side_give_the_same, ALL)
{
    struct scene s = scene_of(_i % WAYS, _i / WAYS, N);
    const int n = s.mesh->n_cells;
    double *const f = alloc_doubles(M * n), *const g = alloc_doubles(M * N);
    double *const q = alloc_doubles(M * N), *const field = alloc_doubles(M * n);

    cloud_numbers(7, M * N, s.q);
    averaging_spread(s.a, M, s.q, s.field);
    averaging_gather(s.a, M, s.field, g);
    for (int m = 1; m < M; m++) {
        narrow(N, m, s.q, q);
        averaging_spread(s.a, m, q, f);
        ck_assert_double_lt(largest_difference(n, m, s.field, f), 1e-8);
        narrow(n, m, s.field, field);
        averaging_gather(s.a, m, field, q);
        ck_assert_double_lt(largest_difference(N, m, g, q), 1e-8);
    }
    free(f);
    free(g);
    free(q);
    free(field);
    scene_free(&s);
}

/* Diffusion only averages: no cell has more than the fullest of pcm. Others
 * may: a cell between full ones gets a part of each. None goes below zero. */
FACT_FOR_EACH(solids_stay_between_zero_and_the_fullest_cell, ALL)
{
    struct scene s = scene_of(_i % WAYS, _i / WAYS, N);
    struct averaging *const pcm = averaging_create(
        averaging_method_named("pcm"), s.mesh, s.ps, &ways[0].o);
    const struct averaging_report *const r = averaging_report(s.a);

    fill_amounts(&s);
    ck_assert_int_eq(averaging_bind(pcm), 0);
    averaging_spread(pcm, M, s.q, s.field);
    const double fullest = averaging_report(pcm)->highest;
    averaging_spread(s.a, M, s.q, s.field);
    if (ways[_i % WAYS].does & POSITIVE) {
        ck_assert_double_ge(r->lowest, -1e-8 * fullest);
        ck_assert_double_lt(r->negative, 1e-6);
    }
    if (ways[_i % WAYS].does & BOUNDED)
        ck_assert_double_le(r->highest, fullest * (1.0 + 1e-8));
    ck_assert(r->worst.converged);
    averaging_free(pcm);
    scene_free(&s);
}

/* All but diffusion, to the last bit. */
FACT_FOR_EACH(normalised_weights_are_not_negative, ALL)
{
    struct scene s = scene_of(_i % WAYS, _i / WAYS, N);

    fill_amounts(&s);
    averaging_spread(s.a, M, s.q, s.field);
    if (strcmp(ways[_i % WAYS].method, "diffusion") != 0) {
        ck_assert_double_ge(averaging_report(s.a)->lowest, 0.0);
        ck_assert(averaging_report(s.a)->negative == 0.0);
    }
    scene_free(&s);
}

/* Graded cells, so that a count of cells is no share of the volume. */
FACT(the_report_gives_the_negative_fraction_of_the_first_field)
{
    struct scene s = scene_of(0, 4, N);
    double below = 0.0, all = 0.0, lowest = 0.0, highest = 0.0;

    cloud_numbers(14, M * N, s.q);
    averaging_spread(s.a, M, s.q, s.field);
    for (int c = 0; c < s.mesh->n_cells; c++) {
        const double f = s.field[M * c];
        all += fabs(f) * s.mesh->V[c];
        if (f < 0.0) below -= f * s.mesh->V[c];
        lowest = fmin(lowest, f);
        highest = fmax(highest, f);
    }
    const struct averaging_report *const r = averaging_report(s.a);
    ck_assert_double_eq_tol(r->negative, below / all, 1e-14);
    ck_assert(r->lowest == lowest && r->highest == highest);
    scene_free(&s);
}

FACT_FOR_EACH(no_particles_make_a_field_of_zeros, ALL)
{
    struct scene s = scene_of(_i % WAYS, _i / WAYS, 0);

    cloud_numbers(8, M * s.mesh->n_cells, s.field);
    averaging_spread(s.a, M, s.q, s.field);
    for (int e = 0; e < M * s.mesh->n_cells; e++)
        ck_assert(s.field[e] == 0.0);
    averaging_gather(s.a, M, s.field, s.q);
    ck_assert_int_eq(averaging_report(s.a)->capped, 0);
    ck_assert(averaging_report(s.a)->worst.converged);
    scene_free(&s);
}

/* Shape 5 is periodic all round with equal cells. The particles move by one
 * cell in x, also over the end; the field must follow. Different coordinates
 * round differently, which 1e-11 of the highest allows for. Only random
 * particles: those on faces may fall on either side. A second grid stays where
 * it is, and what it makes of the particles changes. */
FACT_FOR_EACH(particles_moved_by_a_cell_move_the_field_by_a_cell, WAYS)
{
    struct scene s = scene_of(_i, 5, N);
    const int nx = s.mesh->box.n[0];
    double *const moved = alloc_doubles(M * s.mesh->n_cells);
    uint64_t state = 11;

    for (int i = 0; i < N; i++) {
        s.ps->x[i] = 0.6 * cloud_random(&state);
        s.ps->y[i] = 0.8 * cloud_random(&state);
        s.ps->z[i] = 0.7 * cloud_random(&state);
    }
    fill_amounts(&s);
    ck_assert_int_eq(averaging_bind(s.a), 0);
    averaging_spread(s.a, M, s.q, s.field);
    for (int i = 0; i < N; i++)
        s.ps->x[i] += 0.6 / nx;
    ck_assert_int_eq(averaging_bind(s.a), 0);
    averaging_spread(s.a, M, s.q, moved);
    const double tol = 1e-11 * averaging_report(s.a)->highest;
    for (int c = 0; c < s.mesh->n_cells && ways[_i].does & MOVES; c++) {
        const int next = c % nx == nx - 1 ? c - nx + 1 : c + 1;
        ck_assert_double_eq_tol(moved[M * next], s.field[M * c], tol);
    }
    free(moved);
    scene_free(&s);
}

FACT_FOR_EACH(a_particle_outside_the_mesh_is_named, WAYS)
{
    struct scene s = scene_of(_i, 4, N);

    s.ps->y[40] = 0.71;
    s.ps->x[90] = NAN;
    ck_assert_int_ne(averaging_bind(s.a), 0);
    ck_assert_int_eq(averaging_report(s.a)->lost, 2);
    ck_assert_int_eq(averaging_report(s.a)->lost_id, 1040);
    s.ps->y[40] = 0.69;
    s.ps->x[90] = 0.1;
    ck_assert_int_eq(averaging_bind(s.a), 0);
    ck_assert_int_eq(averaging_report(s.a)->lost, 0);
    fill_amounts(&s);
    averaging_spread(s.a, M, s.q, s.field);
    scene_free(&s);
}

FACT_FOR_EACH(wrong_options_are_refused, 8)
{
    const struct averaging_options wrong[] = {
        {.cap = 1.5},
        {.cap = -0.1},
        {.bandwidth = 0.0},
        {.bandwidth = -1.0},
        {.bandwidth = NAN},
        {.bandwidth = 0.1, .scheme = "leapfrog"},
        {.bandwidth = 0.1, .steps = -1},
        {.bandwidth = 0.1, .vary = "time"}};
    static const char *const method[] = {"pcm",       "pcm",       "kernel",
                                         "kernel",    "diffusion", "diffusion",
                                         "diffusion", "diffusion"};
    struct scene s = scene_of(0, 4, 0);

    ck_assert_ptr_null(averaging_create(averaging_method_named(method[_i]),
                                        s.mesh, s.ps, &wrong[_i]));
    ck_assert_ptr_null(averaging_method_named("no such"));
    scene_free(&s);
}

/* x, y and z are alike: with the mesh and the particles turned by a third about
 * the diagonal the field is turned and nothing else. To what the tolerances
 * leave. */
FACT_FOR_EACH(rotated_particles_give_a_rotated_field, ALL)
{
    const int way = _i % WAYS;
    if (ways[way].o.regions.n > 0) return; /* these stay where they are */
    struct scene s = scene_of(way, _i / WAYS, N);
    const int *const n = s.mesh->box.n;
    struct box_spec spec = cloud_shapes[_i / WAYS];
    const struct box_spec old = spec;

    fill_amounts(&s);
    averaging_spread(s.a, M, s.q, s.field);
    for (int k = 0; k < 3; k++) {
        const int from = (k + 1) % 3;
        spec.size[k] = old.size[from];
        spec.cells[k] = old.cells[from];
        spec.grading[k] = old.grading[from];
        spec.periodic[k] = old.periodic[from];
    }
    struct mesh *const m = mesh_create_box(&spec);
    for (int i = 0; i < N; i++) {
        const double x = s.ps->x[i];
        s.ps->x[i] = s.ps->y[i];
        s.ps->y[i] = s.ps->z[i];
        s.ps->z[i] = x;
    }
    struct averaging *const a = averaging_create(
        averaging_method_named(ways[way].method), m, s.ps, &ways[way].o);
    double *const field = alloc_doubles(M * m->n_cells);
    ck_assert_int_eq(averaging_bind(a), 0);
    averaging_spread(a, M, s.q, field);
    for (int c = 0; c < m->n_cells; c++) {
        const int y = c % n[1], z = c / n[1] % n[2], x = c / n[1] / n[2];
        const int before = x + n[0] * (y + n[1] * z);
        ck_assert_double_eq_tol(field[M * c], s.field[M * before],
                                1e-8 * averaging_report(a)->highest);
    }
    free(field);
    averaging_free(a);
    mesh_free(m);
    scene_free(&s);
}

FACTS
{
    setenv("CK_FORK", "no", 1); /* hundreds of small tests */
}
