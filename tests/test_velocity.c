/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/systems.h"
#include "fluid/piso.h"

#include "base/alloc.h"
#include "facts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Numbers from -1 to 1 without a pattern. */
static double any(int i)
{
    return sin(9.0 * i * i + i);
}

/* A momentum equation with all its terms, in a box between no-slip walls, and
 * any velocity and pressure gradient. */
static struct fluid *equation(const struct mesh *m, const struct boundary *b)
{
    const struct fluid_options o = {.rho = 1000.0,
                                    .mu = 0.5,
                                    .dt = 1e-2,
                                    .convection =
                                        convection_scheme_named("upwind"),
                                    .tolerance = 1e-14,
                                    .coupled = 1,
                                    .pressure_shared = 1,
                                    .boundaries = b};
    struct fluid *const fl = fluid_create(m, &o);

    for (int c = 0; c < m->n_cells; c++) {
        fl->eps[c] = fl->eps_n[c] = fl->eps_nm1[c] = 0.7 + 0.2 * any(c);
        fl->K[c] = 1e4 * (1.0 + any(c));
        for (int k = 0; k < 3; k++) {
            fl->u[3 * c + k] = any(3 * c + k);
            fl->F[3 * c + k] = 100.0 * any(5 * c + k);
            fl->grad_p[3 * c + k] = 300.0 * any(7 * c + k);
        }
    }
    for (int f = 0; f < m->n_internal; f++)
        fl->phi[f] = 1e-3 * any(f);
    ddt_begin(fl);
    momentum_assemble(fl);
    return fl;
}

static struct mesh *box(void)
{
    const struct box_spec spec = {
        {1.0, 0.4, 0.15}, {5, 4, 3}, {2.0, 1.0, 1.0}, {0, 0, 0}};
    return mesh_create_box(&spec);
}

static const struct boundary walls[6] = {
    {.kind = BOUNDARY_NO_SLIP}, {.kind = BOUNDARY_NO_SLIP},
    {.kind = BOUNDARY_NO_SLIP}, {.kind = BOUNDARY_NO_SLIP},
    {.kind = BOUNDARY_NO_SLIP}, {.kind = BOUNDARY_NO_SLIP}};

/* b - sum a_N u_N of all cells, face by face. */
static double *neighbour_sum(const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const struct ldu *const A = fl->momentum->matrix;
    double *const H = alloc_doubles(3 * m->n_cells);

    memcpy(H, fl->momentum->b, 3 * (size_t)m->n_cells * sizeof *H);
    for (int f = 0; f < m->n_internal; f++)
        for (int k = 0; k < 3; k++) {
            const int o = m->owner[f], n = m->neighbour[f];
            H[3 * o + k] -= A->upper[f] * fl->u[3 * n + k];
            H[3 * n + k] -= A->lower[f] * fl->u[3 * o + k];
        }
    return H;
}

/* H, of the size of 10 N, in another order of its seven terms. */
FACT(h_is_the_right_side_minus_the_neighbours)
{
    struct mesh *const m = box();
    struct fluid *const fl = equation(m, walls);
    double *const H = neighbour_sum(fl);

    velocity_neighbour_sum(fl);
    for (int i = 0; i < 3 * m->n_cells; i++)
        ck_assert_double_eq_tol(fl->momentum->H[i], H[i], 1e-13);
    free(H);
    owner_free(fl);
    mesh_free(m);
}

FACT(the_corrected_velocity_balances_each_cell_with_given_neighbours)
{
    struct mesh *const m = box();
    struct fluid *const fl = equation(m, walls);
    double *const H = neighbour_sum(fl);

    velocity_neighbour_sum(fl);
    velocity_correct(fl);
    for (int c = 0; c < m->n_cells; c++)
        for (int k = 0; k < 3; k++) {
            const int i = 3 * c + k;
            const double right = H[i] + fl->levels->old_time_source[i] -
                                 fl->eps[c] * m->V[c] * fl->grad_p[i];
            ck_assert_double_eq_tol(fl->u[i] * fl->momentum->diag[c], right,
                                    1e-12);
        }
    free(H);
    owner_free(fl);
    mesh_free(m);
}

/* The predictor solves the equation; a velocity that is 1 m/s off in one cell
 * leaves a_P there and a_N in the neighbours. */
FACT(the_residual_is_that_of_the_equation_with_the_present_velocity)
{
    struct mesh *const m = box();
    struct fluid *const fl = equation(m, walls);
    const int off = 27;
    const struct solve_report r = velocity_predict(fl);

    ck_assert_int_eq(r.converged, 1);
    ck_assert_double_lt(velocity_residual(fl), 1e-12);
    fl->u[3 * off + 1] += 1.0;
    ck_assert_double_gt(velocity_residual(fl), 1e-3);
    ck_assert_double_eq_tol(fl->momentum->residual[3 * off + 1],
                            -fl->momentum->diag[off], 1e-9);
    ck_assert_double_eq_tol(fl->momentum->residual[3 * off], 0.0, 1e-9);
    for (int f = 0; f < m->n_internal; f++) {
        const struct ldu *const A = fl->momentum->matrix;
        if (m->neighbour[f] == off)
            ck_assert_double_eq_tol(fl->momentum->residual[3 * m->owner[f] + 1],
                                    -A->upper[f], 1e-9);
        if (m->owner[f] == off)
            ck_assert_double_eq_tol(
                fl->momentum->residual[3 * m->neighbour[f] + 1], -A->lower[f],
                1e-9);
    }
    owner_free(fl);
    mesh_free(m);
}

/* The predictor's own residual stands for a product with the matrix. */
FACT(h_after_the_prediction_is_that_of_the_predicted_velocity)
{
    struct mesh *const m = box();
    struct fluid *const fl = equation(m, walls);

    velocity_predict(fl);
    double *const H = neighbour_sum(fl);
    velocity_predicted_sum(fl);
    for (int i = 0; i < 3 * m->n_cells; i++)
        ck_assert_double_eq_tol(fl->momentum->H[i], H[i], 1e-11);
    free(H);
    owner_free(fl);
    mesh_free(m);
}
