/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/systems.h"
#include "fluid/piso.h"

#include "base/alloc.h"
#include "facts.h"

#include <math.h>
#include <stdlib.h>

static struct fluid_options options(const struct boundary *b)
{
    return (struct fluid_options){.rho = 1000.0,
                                  .mu = 0.5,
                                  .dt = 1e-2,
                                  .convection =
                                      convection_scheme_named("upwind"),
                                  .continuity = CONTINUITY_VOID_RATE,
                                  .correctors = 2,
                                  .tolerance = 1e-12,
                                  .boundaries = b};
}

/* Cells of 0.2 x 0.1 x 0.05 m. */
static struct mesh *box(int periodic)
{
    const struct box_spec spec = {{1.0, 0.4, 0.15},
                                  {5, 4, 3},
                                  {1.0, 1.0, 1.0},
                                  {periodic, periodic, periodic}};
    return mesh_create_box(&spec);
}

/* Numbers from -1 to 1 without a pattern. */
static double any(int i)
{
    return sin(9.0 * i * i + i);
}

static void assemble(struct fluid *fl)
{
    ddt_begin(fl);
    momentum_assemble(fl);
}

/* Whatever eps and the fluxes are, and with them the residual of continuity:
 * for a uniform velocity the row is the time derivative alone. The terms are of
 * the size 1e3 kg/m^3 times 1e-2 m^3/s. */
FACT_FOR_EACH(a_uniform_velocity_is_neither_convected_nor_sheared, 2)
{
    struct mesh *const m = box(1);
    struct fluid_options o = options(NULL);
    o.coupled = 1;
    o.convection = convection_scheme_named(_i ? "linear" : "upwind");
    struct fluid *const fl = fluid_create(m, &o);
    double *const sum = alloc_doubles(m->n_cells);

    for (int c = 0; c < m->n_cells; c++) {
        fl->eps[c] = fl->eps_n[c] = 0.7 + 0.2 * any(c);
        fl->eps_nm1[c] = 0.7 + 0.2 * any(c + 5);
    }
    for (int f = 0; f < m->n_faces; f++)
        fl->phi[f] = 1e-2 * any(f);
    assemble(fl);
    ldu_row_sums(0, m->n_cells, fl->momentum->matrix, sum);
    for (int c = 0; c < m->n_cells; c++)
        ck_assert_double_eq_tol(fl->momentum->diag[c] + sum[c],
                                o.rho * fl->eps_nm1[c] * m->V[c] / o.dt, 1e-12);
    free(sum);
    owner_free(fl);
    mesh_free(m);
}

FACT(upwind_takes_the_velocity_upstream_and_viscosity_both)
{
    struct mesh *const m = box(1);
    const struct fluid_options o = options(NULL);
    struct fluid *const fl = fluid_create(m, &o);

    for (int f = 0; f < m->n_faces; f++)
        fl->phi[f] = 1e-2 * any(f);
    assemble(fl);
    for (int f = 0; f < m->n_internal; f++) {
        const double *const d = mesh_d(m, f), *const S = mesh_S(m, f);
        const double D = o.mu * hypot(S[0], hypot(S[1], S[2])) /
                         hypot(d[0], hypot(d[1], d[2]));
        const double flow = o.rho * fl->levels->convecting_flux[f];
        const struct ldu *const A = fl->momentum->matrix;
        ck_assert_double_eq_tol(A->upper[f], fmin(flow, 0.0) - D, 1e-14 * D);
        ck_assert_double_eq_tol(A->lower[f], -fmax(flow, 0.0) - D, 1e-14 * D);
    }
    owner_free(fl);
    mesh_free(m);
}

/* The lid at y = 0.4 m moves along x: mu U A / (h / 2), with A = 0.2 x 0.05 m^2
 * and h = 0.1 m; the bottom is at rest, and the others let slip. */
FACT(a_wall_pulls_with_its_velocity_over_half_a_cell)
{
    struct mesh *const m = box(0);
    const double U = 3.0, D = 0.5 * 0.2 * 0.05 / 0.05;
    struct boundary b[6] = {{.kind = BOUNDARY_SLIP}};
    for (int i = 1; i < 6; i++)
        b[i].kind = BOUNDARY_SLIP;
    b[2] = (struct boundary){.kind = BOUNDARY_NO_SLIP};
    b[3] = (struct boundary){.kind = BOUNDARY_NO_SLIP, .wall = {U, 0.0, 0.0}};
    const struct fluid_options o = options(b);
    struct fluid *const fl = fluid_create(m, &o);
    double *const sum = alloc_doubles(m->n_cells);

    assemble(fl);
    ldu_row_sums(0, m->n_cells, fl->momentum->matrix, sum);
    for (int c = 0; c < m->n_cells; c++) {
        const int j = c / 5 % 4;
        const double wall =
            fl->momentum->diag[c] + sum[c] - o.rho * m->V[c] / o.dt;
        ck_assert_double_eq_tol(wall, j == 0 || j == 3 ? D : 0.0, 1e-12);
        ck_assert_double_eq_tol(fl->momentum->b[3 * c], j == 3 ? D * U : 0.0,
                                1e-14);
        ck_assert_double_eq(fl->momentum->b[3 * c + 1], 0.0);
        ck_assert_double_eq(fl->momentum->b[3 * c + 2], 0.0);
        /* slip at x = 0: 2 mu A / h on the normal component alone */
        const int end = c % 5 == 0 || c % 5 == 4;
        ck_assert_double_eq_tol(fl->momentum->diag3[3 * c] -
                                    fl->momentum->diag[c],
                                end ? 0.5 * 0.1 * 0.05 / 0.1 : 0.0, 1e-12);
        ck_assert_double_eq(fl->momentum->diag3[3 * c + 1],
                            fl->momentum->diag[c]);
    }
    free(sum);
    owner_free(fl);
    mesh_free(m);
}

FACT(xs11_3_14_drag_adds_its_force_to_the_right_and_its_friction_to_the_left)
{
    struct mesh *const m = box(1);
    struct fluid_options o = options(NULL);
    o.coupled = 1;
    struct fluid *const fl = fluid_create(m, &o);
    struct fluid *const without = fluid_create(m, &o);

    for (int c = 0; c < m->n_cells; c++) {
        fl->K[c] = 1e4 * (1.0 + any(c));
        for (int k = 0; k < 3; k++)
            fl->F[3 * c + k] = 100.0 * any(3 * c + k);
    }
    assemble(fl);
    assemble(without);
    for (int c = 0; c < m->n_cells; c++) { /* diag is about 100 kg/s */
        ck_assert_double_eq_tol(fl->momentum->diag[c] -
                                    without->momentum->diag[c],
                                fl->K[c] * m->V[c], 1e-12);
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq(fl->momentum->b[3 * c + k],
                                fl->F[3 * c + k] * m->V[c]);
    }
    owner_free(fl);
    owner_free(without);
    mesh_free(m);
}

/* --- the account of momentum in the void-rate form ------------------------ */

/* A stream through a box without walls, driven by forces; eps moves, and its
 * mean stays. */
static struct fluid *stirred(const struct mesh *m, const char *time, int outer)
{
    struct fluid_options o = options(NULL);
    o.coupled = 1;
    o.time = time_scheme_named(time);
    o.outer_correctors = outer;
    struct fluid *const fl = fluid_create(m, &o);

    for (int c = 0; c < m->n_cells; c++)
        for (int k = 0; k < 3; k++)
            fl->F[3 * c + k] = 1e4 * (0.5 + any(3 * c + k));
    return fl;
}

static void step(struct fluid *fl, int i, double dt)
{
    const double turn = 2.0 * acos(-1.0);

    fl->options.dt = dt;
    for (int c = 0; c < fl->mesh->n_cells; c++)
        fl->eps[c] = 0.7 + 0.1 * sin(turn * fl->mesh->centre[3 * c] + 0.7 * i);
    if (i == 0) fluid_reset_eps_history(fl);
    ck_assert_int_eq(fluid_step(fl), 0);
}

/* Impulse of the forces in x after these steps [N s]. */
static double impulse(const struct fluid *fl, double time)
{
    double sum = 0.0;

    for (int c = 0; c < fl->mesh->n_cells; c++)
        sum += time * fl->mesh->V[c] * fl->F[3 * c];
    return sum;
}

/* Euler with a constant step, and any scheme with outer iterations, whose flux
 * and masses are those of the new time: to the tolerance of the pressure. */
static const struct {
    const char *time;
    int outer;
    double ratio; /* of each step to the one before the last */
} exact[] = {
    {"euler", 0, 1.0}, {"euler", 1, 0.3}, {"bdf2", 1, 1.0}, {"bdf2", 2, 0.3}};

FACT_FOR_EACH(void_rate_with_matching_flux_and_masses_relabels_no_momentum, 4)
{
    struct mesh *const m = box(1);
    struct fluid *const fl = stirred(m, exact[_i].time, exact[_i].outer);
    double time = 0.0;

    for (int i = 0; i < 8; i++) {
        const double dt = i % 2 ? 1e-2 * exact[_i].ratio : 1e-2;
        step(fl, i, dt);
        time += dt;
    }
    ck_assert_double_lt(fabs(fl->relabelled[0]), 1e-8 * impulse(fl, time));
    owner_free(fl);
    mesh_free(m);
}

/* Without outer iterations the flux is that of the last step. If the step has
 * changed since, the mass that it brings in dt is not the change of eps over
 * the last step, and the rest is relabelled: rho u V d(eps) (1 - dt /
 * dt_older).
 */
FACT(a_changed_step_relabels_the_change_of_eps_times_that_of_the_step)
{
    struct mesh *const m = box(1);
    struct fluid *const fl = stirred(m, "euler", 0);
    double expected = 0.0;

    for (int i = 0; i < 5; i++)
        step(fl, i, 1e-2);
    const double before = fl->relabelled[0];
    double *const change = alloc_doubles(m->n_cells);
    for (int c = 0; c < m->n_cells; c++)
        change[c] = fl->eps_n[c] - fl->eps_nm1[c];
    step(fl, 5, 4e-3);
    for (int c = 0; c < m->n_cells; c++)
        expected += 1000.0 * fl->u[3 * c] * m->V[c] * change[c] * (1.0 - 0.4);
    ck_assert_double_gt(fabs(expected), 1e-3 * impulse(fl, 4e-3));
    ck_assert_double_eq_tol(fl->relabelled[0] - before, expected,
                            1e-7 * fabs(expected));
    ck_assert_double_lt(fl->report.momentum_residual, 1e-9); /* it is counted */
    free(change);
    owner_free(fl);
    mesh_free(m);
}

/* By which a step is known to have failed, whatever the solvers report. */
FACT_FOR_EACH(a_velocity_that_is_no_number_leaves_no_balance, 3)
{
    struct mesh *const m = box(1);
    const struct fluid_options o = options(NULL);
    struct fluid *const fl = fluid_create(m, &o);
    const double zero[3] = {0.0, 0.0, 0.0};

    ck_assert_double_eq(momentum_balance_residual(fl, zero, zero), 0.0);
    fl->u[3 * 7 + _i] = NAN;
    ck_assert(!isfinite(momentum_balance_residual(fl, zero, zero)));
    ck_assert_int_ne(fluid_step(fl), 0);
    owner_free(fl);
    mesh_free(m);
}
