/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/averaging.h"

#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <stdlib.h>

#include "averaging/diffusion.h"
#include "base/alloc.h"
#include "boxes.h"
#include "facts.h"
#include "cloud.h"

FACT(ew18_20_half_the_height_is_at_half_of_delta)
{
    const double sigma = averaging_sigma(1.2e-3);
    ck_assert_double_eq_tol(
        images_kernel(0.6e-3, sigma) / images_kernel(0.0, sigma), 0.5, 1e-14);
}

static double shell(double r, void *sigma)
{
    return 4.0 * M_PI * r * r * images_kernel(r, *(double *)sigma);
}

FACT(ew18_19_encloses_one)
{
    double sigma = 0.3, sum, error;
    gsl_integration_workspace *const w = gsl_integration_workspace_alloc(100);
    gsl_function f = {shell, &sigma};

    gsl_integration_qagiu(&f, 0.0, 1e-10, 1e-10, 100, w, &sum, &error);
    ck_assert_double_eq_tol(sum, 1.0, 1e-9);
    gsl_integration_workspace_free(w);
}

/* EW18 and SX15 write one kernel in two ways. */
FACT(ew18_19_is_sx15_6_of_that_bandwidth)
{
    const double delta = 0.7;
    for (double r = 0.0; r < 2.0; r += 0.3)
        ck_assert_double_eq_tol(
            images_kernel(r, averaging_sigma(delta)) /
                diffusion_kernel(r, averaging_bandwidth(delta)),
            1.0, 1e-13);
}

/* Integral of a Gaussian of width b around x over direction k of cell c, and
 * over 9 images to each side. */
static double along(const struct mesh *m, int k, int c, double x, double b)
{
    const int nx = m->box.n[0], ny = m->box.n[1];
    const int at[3] = {c % nx, c / nx % ny, c / nx / ny};
    const double *const e = m->box.edge[k];
    const double L = e[m->box.n[k]];
    double sum = 0.0;

    for (int t = -9; t <= 9; t++)
        for (int mirror = 0; mirror < 2; mirror++) {
            const double there = m->box.periodic[k] ? x + t * L
                                 : mirror           ? 2.0 * t * L - x
                                                    : 2.0 * t * L + x;
            if (m->box.periodic[k] && mirror) continue;
            sum += 0.5 * (erf((e[at[k] + 1] - there) / b) -
                          erf((e[at[k]] - there) / b));
        }
    return sum;
}

/* All meshes, also graded, with periods and of one cell, particles on all
 * walls and corners; no stencils, and nothing cut off. What a Gaussian has
 * beyond 3 b, which the method shares out, is 4.4e-4 of it. */
FACT_FOR_EACH(ew18_21_it_is_the_gaussian_with_all_its_images, CLOUD_SHAPES)
{
    struct mesh *const m = mesh_create_box(&cloud_shapes[_i]);
    struct particles *const ps = cloud_create(m, 60);
    double *const field = alloc_doubles(m->n_cells);
    const double b = 0.15;
    double highest = 0.0;

    cloud_spread_ones(m, ps, b, "images", field);
    for (int c = 0; c < m->n_cells; c++)
        highest = fmax(highest, field[c]);
    for (int c = 0; c < m->n_cells; c++) {
        double sum = 0.0;
        for (int i = 0; i < 60; i++)
            sum += along(m, 0, c, ps->x[i], b) * along(m, 1, c, ps->y[i], b) *
                   along(m, 2, c, ps->z[i], b);
        ck_assert_double_eq_tol(field[c], sum / m->V[c], 1e-3 * highest);
    }
    free(field);
    particles_free(ps);
    mesh_free(m);
}

/* An even bed, 8 particles a cell, b of 2 cells, in a closed box. With
 * images it is even up to the walls and into the corners, to what is cut off;
 * without them the cell in the corner has six tenths of the right value. */
FACT(ew18_21_an_even_bed_is_even_up_to_the_walls)
{
    struct mesh *const m = closed_box(8.0, 8.0, 8.0, 8, 8, 8);
    struct particles *const ps = particles_create(4096);
    double *const field = alloc_doubles(m->n_cells);

    for (int i = 0; i < 4096; i++)
        cloud_place(ps, 0.5 * (i % 16 + 0.5), 0.5 * (i / 16 % 16 + 0.5),
                    0.5 * (i / 256 + 0.5), 0.1);
    cloud_spread_ones(m, ps, 2.0, "images", field);
    for (int c = 0; c < m->n_cells; c++)
        ck_assert_double_eq_tol(field[c] / 8.0, 1.0, 1e-3);
    cloud_spread_ones(m, ps, 2.0, "gaussian", field);
    ck_assert_double_lt(field[0] / 8.0, 0.65);
    free(field);
    particles_free(ps);
    mesh_free(m);
}

/* cos(pi x / L) is even about both walls, so the Gaussian with its images only
 * damps it, by exp(-(k b / 2)^2). 40 cells: their steps are 1e-3, what is cut
 * off beyond 3 b is 4e-4. Without images the ends would have half of it. */
FACT(ew18_17_a_wave_comes_back_damped_and_nothing_else)
{
    const double b = 0.15, damped = exp(-0.25 * M_PI * M_PI * b * b);
    const struct averaging_options o = {.bandwidth = b};
    struct mesh *const m = closed_box(1.0, 0.1, 0.1, 40, 1, 1);
    struct particles *const ps = particles_create(50);
    double wave[40], seen[50];

    for (int i = 0; i < 50; i++)
        cloud_place(ps, i / 49.0, 0.05, 0.05, 0.01);
    for (int c = 0; c < 40; c++)
        wave[c] = cos(M_PI * m->centre[3 * c]);
    struct averaging *const a =
        averaging_create(averaging_method_named("images"), m, ps, &o);
    ck_assert_int_eq(averaging_bind(a), 0);
    averaging_gather(a, 1, wave, seen);
    for (int i = 0; i < 50; i++)
        ck_assert_double_eq_tol(seen[i], damped * cos(M_PI * ps->x[i]), 1.5e-3);
    averaging_free(a);
    particles_free(ps);
    mesh_free(m);
}

/* Bandwidths below a thousandth of a cell: the integrals are 0 and 1, or 1/2
 * for a particle on a face; no particle is on one. */
FACT(ew18_18_a_narrow_gaussian_is_pcm)
{
    struct mesh *const m = mesh_create_box(&cloud_shapes[4]);
    struct particles *const ps = cloud_create(m, 100);
    double *const f = alloc_doubles(m->n_cells);
    double *const g = alloc_doubles(m->n_cells);
    uint64_t state = 21;

    for (int i = 0; i < 100; i++) {
        ps->x[i] = 0.6 * cloud_random(&state);
        ps->y[i] = 0.7 * cloud_random(&state);
        ps->z[i] = 0.5 * cloud_random(&state);
    }
    cloud_spread_ones(m, ps, 1e-6, "images", f);
    cloud_spread_ones(m, ps, 1e-6, "pcm", g);
    for (int c = 0; c < m->n_cells; c++)
        ck_assert_double_eq_tol(f[c], g[c], 1e-12 * (1.0 + g[c]));
    free(f);
    free(g);
    particles_free(ps);
    mesh_free(m);
}
