/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/averaging.h"

#include <math.h>
#include <stdlib.h>

#include "averaging/cell_of_particle.h"
#include "base/alloc.h"
#include "boxes.h"
#include "facts.h"
#include "cloud.h"

enum { N = 90 };

/* (1 - zeta^2)^4 worked out: (15/16)^4, (3/4)^4, 0.19^4. */
FACT(xs11_3_6_values)
{
    ck_assert(kernel_polynomial(0.0) == 1.0);
    ck_assert_double_eq_tol(kernel_polynomial(0.25), 50625.0 / 65536.0, 1e-16);
    ck_assert_double_eq_tol(kernel_polynomial(-0.5), 81.0 / 256.0, 1e-16);
    ck_assert_double_eq_tol(kernel_polynomial(0.9), 0.00130321, 1e-17);
    ck_assert(kernel_polynomial(1.0) == 0.0);
    ck_assert(kernel_polynomial(1.5) == 0.0 && kernel_polynomial(-7.0) == 0.0);
}

struct scene {
    struct mesh *mesh;
    struct particles *ps;
    struct averaging *a;
    double *field;
    double b;
    int gaussian; /* 1: in the place of the polynomial */
};

static struct scene scene_with(int shape, double b, int gaussian)
{
    const struct averaging_options o = {.bandwidth = b};
    struct scene s = {.mesh = mesh_create_box(&cloud_shapes[shape]),
                      .b = b,
                      .gaussian = gaussian};

    s.ps = cloud_create(s.mesh, N);
    s.a = averaging_create(
        averaging_method_named(gaussian ? "gaussian" : "kernel"), s.mesh, s.ps,
        &o);
    s.field = alloc_doubles(s.mesh->n_cells);
    ck_assert_int_eq(averaging_bind(s.a), 0);
    return s;
}

static struct scene scene_of(int shape, double b)
{
    return scene_with(shape, b, 0);
}

static void scene_free(struct scene *s)
{
    averaging_free(s->a);
    particles_free(s->ps);
    mesh_free(s->mesh);
    free(s->field);
}

/* K V of particle i in cell c over the images of the cell, as (8.7) has it,
 * without stencils. A periodic direction of one cell has no images. */
static double kernel_of(const struct scene *s, int i, int c)
{
    const struct box *const box = &s->mesh->box;
    const double x[3] = {s->ps->x[i], s->ps->y[i], s->ps->z[i]};
    double sum = 0.0;

    for (int image = 0; image < 125; image++) {
        const int turn[3] = {image % 5 - 2, image / 5 % 5 - 2, image / 25 - 2};
        double r2 = 0.0;
        int counts = 1;
        for (int k = 0; k < 3; k++) {
            const double L = box->edge[k][box->n[k]];
            const double r = s->mesh->centre[3 * c + k] + turn[k] * L - x[k];
            counts &= turn[k] == 0 || (box->periodic[k] && box->n[k] > 1);
            r2 += r * r;
        }
        const double zeta = sqrt(r2) / s->b;
        if (counts && s->gaussian)
            sum += zeta < 3.0 ? exp(-zeta * zeta) : 0.0;
        else if (counts)
            sum += kernel_polynomial(zeta);
    }
    return sum * s->mesh->V[c];
}

/* Weights of particle i on all cells, by the book. Returns 0 if there are none
 * and its own cell has the whole particle. */
static int weights_of(const struct scene *s, int i, double *w)
{
    double sum = 0.0;

    for (int c = 0; c < s->mesh->n_cells; c++)
        sum += w[c] = kernel_of(s, i, c);
    for (int c = 0; c < s->mesh->n_cells && sum > 0.0; c++)
        w[c] /= sum;
    if (sum == 0.0) w[averaging_cells(s->a)->cell[i]] = 1.0;
    return sum > 0.0;
}

/* Both sides are sums of the same terms, rounded differently. */
static void check_against_all_cells(struct scene s)
{
    double *const w = alloc_doubles(s.mesh->n_cells);
    double *const expected = alloc_doubles(s.mesh->n_cells);
    double q[N];
    int alone = 0;

    cloud_numbers(9, N, q);
    for (int i = 0; i < N; i++) {
        alone += !weights_of(&s, i, w);
        for (int c = 0; c < s.mesh->n_cells; c++)
            expected[c] += w[c] * q[i] / s.mesh->V[c];
    }
    averaging_spread(s.a, 1, q, s.field);
    for (int c = 0; c < s.mesh->n_cells; c++)
        ck_assert_double_eq_tol(s.field[c], expected[c], 1e-12 / s.mesh->V[c]);
    ck_assert_int_eq(averaging_report(s.a)->unsupported, alone);
    free(w);
    free(expected);
    scene_free(&s);
}

/* 0.16 and 0.3 m on cells of 0.1 m: b of 1.6 to 3 cells. The amounts are any
 * numbers: volumes as well as the forces of [XS11 3.8]. */
FACT_FOR_EACH(xs11_3_5_stencils_give_what_a_sum_over_all_cells_gives,
              3 * CLOUD_SHAPES)
{
    static const double b[] = {0.03, 0.16, 0.3};
    check_against_all_cells(scene_of(_i / 3, b[_i % 3]));
}

/* Cut off at 3 b, which is at most the smallest period of these meshes. */
FACT_FOR_EACH(sx15_6_the_gaussian_weight_falls_as_it_should, 2 * CLOUD_SHAPES)
{
    static const double b[] = {0.011, 0.0971}; /* 3 b between centres */
    check_against_all_cells(scene_with(_i / 2, b[_i % 2], 1));
}

/* The velocity of a cell: two particles weighed by volume and distance, by the
 * book. u = 1 and 3 m/s of volumes 1 and 0.125; the middle cell is nearer to
 * the small one. */
FACT(xs11_3_7_the_velocity_of_a_cell_is_weighed_by_volume_and_distance)
{
    const struct averaging_options o = {.bandwidth = 2.0};
    const double V[2] = {1.0, 0.125}, u[2] = {1.0, 3.0}, x[2] = {0.7, 1.9};
    const double q[4] = {V[0], V[0] * u[0], V[1], V[1] * u[1]};
    struct mesh *const m = closed_box(3.0, 1.0, 1.0, 3, 1, 1);
    struct particles *const ps = particles_create(2);
    double volume[3] = {0.0}, momentum[3] = {0.0}, field[6];

    for (int i = 0; i < 2; i++) {
        double K[3], sum = 0.0;
        cloud_place(ps, x[i], 0.5, 0.5, 0.1);
        for (int c = 0; c < 3; c++)
            sum += K[c] = kernel_polynomial((c + 0.5 - x[i]) / 2.0);
        for (int c = 0; c < 3; c++) {
            volume[c] += K[c] / sum * V[i];
            momentum[c] += K[c] / sum * V[i] * u[i];
        }
    }
    struct averaging *const a =
        averaging_create(averaging_method_named("kernel"), m, ps, &o);
    ck_assert_int_eq(averaging_bind(a), 0);
    averaging_spread(a, 2, q, field);
    for (int c = 0; c < 3; c++)
        ck_assert_double_eq_tol(field[2 * c + 1] / field[2 * c],
                                momentum[c] / volume[c], 1e-14);
    averaging_free(a);
    particles_free(ps);
    mesh_free(m);
}

/* [XS11 3.9]: gathered, the weights sum to one; spread, [XS11 3.4]. */
FACT_FOR_EACH(xs11_3_4_the_weights_of_each_particle_sum_to_one, CLOUD_SHAPES)
{
    struct scene s = scene_of(_i, 0.16);
    double q[N];

    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++)
            q[j] = j == i;
        averaging_spread(s.a, 1, q, s.field);
        double sum = 0.0;
        for (int c = 0; c < s.mesh->n_cells; c++)
            sum += s.mesh->V[c] * s.field[c];
        ck_assert_double_eq_tol(sum, 1.0, 1e-14);
    }
    for (int c = 0; c < s.mesh->n_cells; c++)
        s.field[c] = 1.0;
    averaging_gather(s.a, 1, s.field, q);
    for (int i = 0; i < N; i++)
        ck_assert_double_eq_tol(q[i], 1.0, 1e-14);
    scene_free(&s);
}

/* b = 1 mm, cells of 10 cm: only a particle in a cell's very middle has a
 * centre within b. Bit for bit, as 1 / V and then summed or divided differ. */
FACT_FOR_EACH(a_kernel_narrower_than_a_cell_is_pcm, CLOUD_SHAPES)
{
    struct scene s = scene_of(_i, 0.001);
    const struct averaging_options o = {.cap = 0.0};
    struct averaging *const pcm =
        averaging_create(averaging_method_named("pcm"), s.mesh, s.ps, &o);
    double *const f = alloc_doubles(s.mesh->n_cells);
    double q[N];

    cloud_numbers(10, N, q);
    ck_assert_int_eq(averaging_bind(pcm), 0);
    averaging_spread(pcm, 1, q, f);
    averaging_spread(s.a, 1, q, s.field);
    ck_assert_mem_eq(f, s.field, sizeof *f * (size_t)s.mesh->n_cells);
    ck_assert_int_ge(averaging_report(s.a)->unsupported, N - 28);
    averaging_free(pcm);
    free(f);
    scene_free(&s);
}

/* The largest distance from 1 of an even bed averaged on n cells, the last four
 * times as wide as the first, at cells beyond the influence of the walls. */
static double unevenness(int n, const char *method, double b, double reach)
{
    enum { EVEN = 8000 };
    const struct box_spec spec = {
        {1.0, 1.0, 1.0}, {n, 1, 1}, {4.0, 1.0, 1.0}, {0, 0, 0}};
    const struct averaging_options o = {.bandwidth = b};
    struct mesh *const m = mesh_create_box(&spec);
    struct particles *const ps = particles_create(EVEN);
    double *const q = alloc_doubles(EVEN), *const field = alloc_doubles(n);
    double worst = 0.0;

    for (int i = 0; i < EVEN; i++) {
        cloud_place(ps, (i + 0.5) / EVEN, 0.5, 0.5, 1e-4);
        q[i] = 1.0 / EVEN;
    }
    struct averaging *const a =
        averaging_create(averaging_method_named(method), m, ps, &o);
    ck_assert_int_eq(averaging_bind(a), 0);
    averaging_spread(a, 1, q, field);
    for (int c = 0; c < n; c++) {
        const double x = m->centre[3 * c];
        if (x < 2.0 * reach || x > 1.0 - 2.0 * reach) continue;
        worst = fmax(worst, fabs(field[c] - 1.0));
    }
    free(field);
    free(q);
    averaging_free(a);
    particles_free(ps);
    mesh_free(m);
    return worst;
}

/* Kernel times volume is the midpoint rule for the integral of the kernel: an
 * even bed is even to second order in the width of a cell, with 1.7e-4 on 32
 * cells. Without the volume it is off by 5e-3 or 7e-3 there, and on any number
 * of them. */
FACT_FOR_EACH(an_even_bed_is_even_on_cells_of_several_sizes, 2)
{
    const char *const method = _i == 0 ? "kernel" : "gaussian";
    const double b = _i == 0 ? 0.2 : 0.08, reach = _i == 0 ? 0.2 : 0.24;
    const double coarse = unevenness(32, method, b, reach);
    const double fine = unevenness(64, method, b, reach);

    ck_assert_double_lt(coarse, 2e-4);
    ck_assert_double_eq_tol(coarse / fine, 4.0, 0.2);
}

/* A kernel that is 1 all over the mesh: each cell gets its part of the volume,
 * and the field is the mean. */
FACT_FOR_EACH(a_very_wide_kernel_gives_the_mean, 2)
{
    struct scene s = scene_with(4, 1e6, _i);
    double q[N], sum = 0.0, all = 0.0;

    cloud_numbers(9, N, q);
    averaging_spread(s.a, 1, q, s.field);
    for (int i = 0; i < N; i++)
        sum += q[i];
    for (int c = 0; c < s.mesh->n_cells; c++)
        all += s.mesh->V[c];
    for (int c = 0; c < s.mesh->n_cells; c++)
        ck_assert_double_eq_tol(s.field[c], sum / all, 1e-10);
    scene_free(&s);
}
