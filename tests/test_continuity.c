/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/fluid.h"
#include "base/alloc.h"
#include "boxes.h"
#include "facts.h"

#include <math.h>

/* A column of 12 cells: an inlet of U below, an outlet above. No drag: what
 * is tested is volume. */
enum { N = 12 };
static const double U = 0.3, h = 0.01, A = 1e-4, dt = 1e-3, zero = 0.0;

static struct fluid *column(struct boundary b[6], enum continuity form)
{
    for (int i = 0; i < 6; i++)
        b[i] = (struct boundary){.kind = BOUNDARY_SLIP};
    b[2] = (struct boundary){
        .kind = BOUNDARY_INLET, .n_points = 1, .time = &zero, .velocity = &U};
    b[3] = (struct boundary){.kind = BOUNDARY_OUTLET};
    const struct fluid_options o = {.rho = 1.0,
                                    .mu = 1e-5,
                                    .dt = dt,
                                    .convection =
                                        convection_scheme_named("upwind"),
                                    .continuity = form,
                                    .correctors = 2,
                                    .tolerance = 1e-12,
                                    .coupled = 1,
                                    .boundaries = b};
    struct fluid *const fl = fluid_create(closed_box(h, N * h, h, 1, N, 1), &o);
    for (int c = 0; c < N; c++)
        fl->u[3 * c + 1] = U;
    for (int f = 0; f < fl->mesh->n_faces; f++)
        fl->phi[f] = U * mesh_S(fl->mesh, f)[1];
    return fl;
}

static void discard(struct fluid *fl)
{
    struct mesh *const m = (struct mesh *)fl->mesh;
    owner_free(fl);
    mesh_free(m);
}

/* Of a column the inner faces are numbered upward: face i is above cell i. The
 * last is that of the outlet. */
static double flux_above(const struct fluid *fl, int i)
{
    return i < N - 1 ? fl->phi[i] : fl->phi[mesh_patch(fl->mesh, "top")->first];
}

/* The flux upward is the flux that enters below, less the rate at which the
 * cells in between fill. The solver leaves 1e-12 of the flux; taking eps at
 * another time, or the sign wrong, would change it by parts of ten. */
FACT(xs11_2_3_the_fluid_that_a_cell_does_not_keep_flows_on)
{
    struct boundary b[6];
    struct fluid *const fl = column(b, CONTINUITY_VOID_RATE);
    double kept[2][N] = {{0.0}};
    for (int n = 0; n < 2; n++) {
        for (int c = 0; c < N; c++) {
            const double eps = 0.6 + 0.02 * sin(3.0 * c + 2.0 * n);
            kept[n][c] = n == 0 ? 0.0 : (eps - fl->eps[c]) * h * A / dt;
            fl->eps[c] = eps;
        }
        if (n == 0) fluid_reset_eps_history(fl);
        ck_assert_int_eq(fluid_step(fl), 0);
        double flux = U * A;
        for (int c = 0; c < N; c++) {
            flux -= kept[n][c];
            ck_assert_double_eq_tol(flux_above(fl, c) / (U * A), flux / (U * A),
                                    1e-9);
        }
    }
    discard(fl);
}

/* The volume of fluid and of solids through a face is U A everywhere. Solids do
 * not pass the outlet: there all of the flux is fluid. */
FACT(xs11_2_7_both_phases_together_have_the_flux_of_the_inlet)
{
    struct boundary b[6];
    struct fluid *const fl = column(b, CONTINUITY_MIXTURE);
    for (int c = 0; c < N; c++) {
        fl->eps[c] = 0.6;
        fl->eps_us[3 * c + 1] = 0.1 * sin(2.0 * c);
    }
    fluid_reset_eps_history(fl);
    ck_assert_int_eq(fluid_step(fl), 0);
    for (int c = 0; c < N; c++) {
        const double solids =
            c < N - 1
                ? 0.5 * A * (fl->eps_us[3 * c + 1] + fl->eps_us[3 * c + 4])
                : 0.0;
        ck_assert_double_eq_tol((flux_above(fl, c) + solids) / (U * A), 1.0,
                                1e-9);
    }
    discard(fl);
}

/* A grain of a twentieth of a cell rises from one cell to the next, counted in
 * the cell that holds it. In both forms the face between lets pass less fluid
 * by just the grain's volume, in one step or little by little. */
FACT_FOR_EACH(both_forms_of_continuity_pass_the_volume_of_a_grain, 2)
{
    const double volume = 0.05 * h * A, speed = 0.1;
    struct boundary b[6];
    struct fluid *const fl =
        column(b, _i ? CONTINUITY_VOID_RATE : CONTINUITY_MIXTURE);
    double missing = 0.0, most = 0.0;
    for (int n = 0; n <= 300; n++) { /* from the middle of cell 4 to cell 7 */
        const int host = (int)(4.5 + speed * dt * n / h + 1e-9);
        for (int c = 0; c < N; c++) {
            fl->eps[c] = 1.0 - (c == host) * volume / (h * A);
            fl->eps_us[3 * c + 1] = (1.0 - fl->eps[c]) * speed;
        }
        if (n == 0) fluid_reset_eps_history(fl);
        ck_assert_int_eq(fluid_step(fl), 0);
        const double less = U * A - flux_above(fl, 5);
        missing += less * dt;
        most = fmax(most, less);
    }
    ck_assert_double_eq_tol(missing / volume, 1.0, 1e-7);
    /* at once, or as the flux of solids, half of which is counted at a face */
    ck_assert_double_eq_tol(
        most / (_i ? volume / dt : 0.5 * volume * speed / h), 1.0, 1e-7);
    discard(fl);
}

/* A uniform stream through cells of dx, dy, dz: dt times the sum of u / dx; a
 * smaller eps has the same flux pass faster. */
FACT_FOR_EACH(ls_5_9_courant_number_of_a_uniform_stream, 2)
{
    const double eps[] = {1.0, 0.4}, u[3] = {0.3, -0.2, 0.1};
    struct mesh *const m = periodic_box(0.05, 0.04, 0.06, 5, 2, 4);
    const struct fluid_options o = {.rho = 1.0,
                                    .dt = dt,
                                    .convection =
                                        convection_scheme_named("upwind"),
                                    .correctors = 1,
                                    .tolerance = 1e-12,
                                    .coupled = 1};
    struct fluid *const fl = fluid_create(m, &o);
    for (int c = 0; c < m->n_cells; c++) {
        fl->eps[c] = eps[_i];
        for (int k = 0; k < 3; k++)
            fl->u[3 * c + k] = u[k] / eps[_i];
    }
    fluid_reset_eps_history(fl);
    for (int f = 0; f < m->n_faces; f++)
        for (int k = 0; k < 3; k++)
            fl->phi[f] += u[k] * mesh_S(m, f)[k];
    ck_assert_int_eq(fluid_step(fl), 0);
    const double cfl = dt * (0.3 / 0.01 + 0.2 / 0.02 + 0.1 / 0.015) / eps[_i];
    ck_assert_double_eq_tol(fl->report.cfl / cfl, 1.0, 1e-9);
    discard(fl);
}
