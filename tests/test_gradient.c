/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/systems.h"
#include "base/alloc.h"

#include "facts.h"

#include <math.h>

static const struct boundary slip[6] = {
    {.kind = BOUNDARY_SLIP}, {.kind = BOUNDARY_SLIP}, {.kind = BOUNDARY_SLIP},
    {.kind = BOUNDARY_SLIP}, {.kind = BOUNDARY_SLIP}, {.kind = BOUNDARY_SLIP}};

static struct fluid_options options(void)
{
    return (struct fluid_options){.rho = 1000.0,
                                  .mu = 1e-3,
                                  .dt = 1e-3,
                                  .convection =
                                      convection_scheme_named("linear"),
                                  .tolerance = 1e-10,
                                  .boundaries = slip};
}

static struct mesh *box(int nx, int ny, int nz, double grading, int periodic)
{
    const struct box_spec spec = {{1.0, 0.5, 0.25},
                                  {nx, ny, nz},
                                  {grading, grading, grading},
                                  {periodic, periodic, periodic}};
    return mesh_create_box(&spec);
}

static void update(struct fluid *fl)
{
    gradient_begin(fl);
    gradient_update(fl);
}

/* On graded cells, where a face is not midway. Differences of p lose three
 * digits over a cell. */
FACT(the_gradient_of_a_linear_pressure_is_exact_inside)
{
    static const double G[3] = {3.0, -5.0, 7.0};
    struct mesh *const m = box(6, 5, 4, 3.0, 0);
    const struct fluid_options o = options();
    struct fluid *const fl = fluid_create(m, &o);
    int inside = 0;

    for (int c = 0; c < m->n_cells; c++)
        for (int k = 0; k < 3; k++)
            fl->p[c] += G[k] * m->centre[3 * c + k];
    update(fl);
    for (int c = 0; c < m->n_cells; c++) {
        int walls = 0;
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++)
            walls += m->cell_face[a] >= m->n_internal;
        if (walls) continue;
        inside++;
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq_tol(fl->grad_p[3 * c + k], G[k], 1e-12);
    }
    ck_assert_int_eq(inside, 4 * 3 * 2);
    owner_free(fl);
    mesh_free(m);
}

/* Also at the walls: the surface of each cell is closed. */
FACT(a_constant_pressure_has_no_gradient_anywhere)
{
    struct mesh *const m = box(6, 5, 4, 3.0, 0);
    const struct fluid_options o = options();
    struct fluid *const fl = fluid_create(m, &o);

    for (int c = 0; c < m->n_cells; c++)
        fl->p[c] = 1e5;
    update(fl);
    for (int i = 0; i < 3 * m->n_cells; i++) /* 1e5 / 0.04 m, 16 digits */
        ck_assert_double_eq_tol(fl->grad_p[i], 0.0, 1e-8);
    owner_free(fl);
    mesh_free(m);
}

/* Largest error for a wave of n cells [Pa/m]. */
static double wave_error(int n)
{
    struct mesh *const m = box(n, 1, 1, 1.0, 1);
    const struct fluid_options o = options();
    struct fluid *const fl = fluid_create(m, &o);
    const double k = 2.0 * acos(-1.0);
    double worst = 0.0;

    for (int c = 0; c < n; c++)
        fl->p[c] = sin(k * m->centre[3 * c]);
    update(fl);
    for (int c = 0; c < n; c++)
        worst = fmax(worst,
                     fabs(fl->grad_p[3 * c] - k * cos(k * m->centre[3 * c])));
    owner_free(fl);
    mesh_free(m);
    return worst;
}

/* The next term of the error changes the ratio by (2 pi / 32)^2 / 4 = 1 %. */
FACT(the_gradient_of_a_wave_has_order_two)
{
    ck_assert_double_eq_tol(wave_error(32) / wave_error(64), 4.0, 0.04);
}

/* Gauss: only the boundary counts. */
FACT(the_gradients_of_all_cells_sum_to_the_pressure_on_the_boundary)
{
    struct mesh *const m = box(6, 5, 4, 3.0, 0);
    const struct fluid_options o = options();
    struct fluid *const fl = fluid_create(m, &o);
    double sum[3] = {0.0, 0.0, 0.0}, surface[3] = {0.0, 0.0, 0.0};

    for (int c = 0; c < m->n_cells; c++)
        fl->p[c] = sin(9.0 * c * c + c);
    update(fl);
    for (int c = 0; c < m->n_cells; c++)
        for (int k = 0; k < 3; k++)
            sum[k] += m->V[c] * fl->grad_p[3 * c + k];
    for (int f = m->n_internal; f < m->n_faces; f++)
        for (int k = 0; k < 3; k++)
            surface[k] += fl->p_face[f] * mesh_S(m, f)[k];
    for (int k = 0; k < 3; k++) { /* 120 cells of 0.01 m^2 and 1 Pa */
        ck_assert_double_gt(fabs(surface[k]), 1e-4);
        ck_assert_double_eq_tol(sum[k], surface[k], 1e-15);
    }
    owner_free(fl);
    mesh_free(m);
}

/* A column at rest: the pressure rises from centre to centre as the force of
 * each half demands, and each cell must find its own force, however it jumps,
 * up to the walls. Where the particles take their share of the gradient (_i),
 * the force is over eps. */
FACT_FOR_EACH(forces_that_jump_from_cell_to_cell_are_the_gradient_of_each, 2)
{
    struct mesh *const m = box(12, 1, 1, 4.0, 0);
    struct fluid_options o = options();
    o.coupled = 1;
    o.pressure_shared = _i;
    struct fluid *const fl = fluid_create(m, &o);
    double slope[12];

    for (int c = 0; c < 12; c++) {
        fl->eps[c] = 0.7 + 0.2 * sin(5.0 * c * c);
        fl->F[3 * c] = 100.0 * sin(9.0 * c * c + 1.0);
        slope[c] = fl->F[3 * c] / (_i ? fl->eps[c] : 1.0);
    }
    for (int c = 1; c < 12; c++) /* V is the length times 0.125 m^2 */
        fl->p[c] = fl->p[c - 1] + 0.5 * slope[c - 1] * m->V[c - 1] / 0.125 +
                   0.5 * slope[c] * m->V[c] / 0.125;
    update(fl);
    for (int c = 0; c < 12; c++)
        ck_assert_double_eq_tol(fl->grad_p[3 * c], slope[c], 1e-11);
    owner_free(fl);
    mesh_free(m);
}
