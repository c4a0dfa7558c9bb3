/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/fluid.h"
#include "fluid/inlet_profile.h"
#include "fluid/systems.h"
#include "base/alloc.h"
#include "facts.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double zero = 0.0, one = 1.0;

static struct fluid_options options(const struct boundary *b)
{
    const struct fluid_options o = {.rho = 1.0,
                                    .mu = 0.1,
                                    .dt = 0.02,
                                    .convection =
                                        convection_scheme_named("linear"),
                                    .correctors = 2,
                                    .piso_tolerance = 1e-3,
                                    .tolerance = 1e-11,
                                    .boundaries = b};
    return o;
}

static struct mesh *box(double x, double y, int nx, int ny, int periodic_x,
                        int periodic_z)
{
    const struct box_spec spec = {
        {x, y, 0.1}, {nx, ny, 1}, {1.0, 1.5, 1.0}, {periodic_x, 0, periodic_z}};
    return mesh_create_box(&spec);
}

static void discard(struct fluid *fl)
{
    struct mesh *const m = (struct mesh *)fl->mesh;
    owner_free(fl);
    mesh_free(m);
}

static void run(struct fluid *fl, int steps)
{
    for (int n = 0; n < steps; n++) {
        ck_assert_int_eq(fluid_step(fl), 0);
        ck_assert_double_lt(fl->report.momentum_residual, 1e-12);
    }
}

/* --- walls -------------------------------------------------------------- */

/* Between a wall at rest and one that moves u is linear, and linear is exact:
 * what is left is how far the start has died away, exp(-2000). */
FACT(couette_flow_under_a_moving_wall_is_exact)
{
    const struct boundary b[2] = {
        {.kind = BOUNDARY_NO_SLIP},
        {.kind = BOUNDARY_NO_SLIP, .wall = {0.7, 0.0, -0.3}}};
    struct fluid_options o = options(b);
    o.dt = 1.0;
    o.mu = 10.0;
    struct fluid *const fl = fluid_create(box(1.0, 1.0, 3, 7, 1, 1), &o);
    run(fl, 50);
    for (int c = 0; c < fl->mesh->n_cells; c++) {
        const double y = fl->mesh->centre[3 * c + 1];
        ck_assert_double_eq_tol(fl->u[3 * c], 0.7 * y, 1e-10);
        ck_assert_double_eq_tol(fl->u[3 * c + 1], 0.0, 1e-10);
        ck_assert_double_eq_tol(fl->u[3 * c + 2], -0.3 * y, 1e-10);
    }
    discard(fl);
}

/* The mesh turned as a whole: every vector of it. */
static void turn(struct mesh *m, double angle)
{
    double *const lists[] = {m->centre, m->S, m->d};
    const int counts[] = {m->n_cells, m->n_S, m->n_d};

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < counts[i]; j++) {
            double *const v = &lists[i][3 * j];
            const double x = v[0];
            v[0] = cos(angle) * x - sin(angle) * v[1];
            v[1] = sin(angle) * x + cos(angle) * v[1];
        }
}

/* A step of a flow that turns round in a box with slip walls, its first motion
 * given; the same in a box turned by an angle. */
static void swirl(double angle, double *p, double *u)
{
    struct boundary b[6];
    for (int i = 0; i < 6; i++)
        b[i] = (struct boundary){.kind = BOUNDARY_SLIP};
    struct fluid_options o = options(b);
    o.correctors = 20;
    struct mesh *const m = box(1.0, 1.0, 6, 5, 0, 0);
    double first[60];
    for (int c = 0; c < 30; c++) {
        const double *const x = &m->centre[3 * c];
        first[2 * c] = cos(2.0 * x[0]) * sin(3.0 * x[1]);
        first[2 * c + 1] = x[0] * x[0] - x[1];
    }
    turn(m, angle);
    struct fluid *const fl = fluid_create(m, &o);
    for (int c = 0; c < 30; c++) {
        const double *const v = &first[2 * c];
        fl->u[3 * c] = cos(angle) * v[0] - sin(angle) * v[1];
        fl->u[3 * c + 1] = sin(angle) * v[0] + cos(angle) * v[1];
    }
    run(fl, 10);
    memcpy(p, fl->p, 30 * sizeof *p);
    for (int c = 0; c < 30; c++) {
        const double *const v = &fl->u[3 * c];
        u[2 * c] = cos(angle) * v[0] + sin(angle) * v[1];
        u[2 * c + 1] = -sin(angle) * v[0] + cos(angle) * v[1];
    }
    discard(fl);
}

/* Slip walls of any normal: without the part that couples the components the
 * velocity at the walls is wrong by a tenth. 1e-6: the coupling is taken from
 * the corrector before, of twenty. */
FACT_FOR_EACH(a_turned_box_has_the_turned_flow, 2)
{
    const double angle = M_PI / 180.0 * (_i == 0 ? 30.0 : 45.0);
    double p[2][30], u[2][60];
    swirl(0.0, p[0], u[0]);
    swirl(angle, p[1], u[1]);
    for (int i = 0; i < 60; i++)
        ck_assert_double_eq_tol(u[0][i], u[1][i], 1e-6);
    for (int i = 0; i < 30; i++)
        ck_assert_double_eq_tol(p[0][i], p[1][i], 1e-5);
}

/* --- inlets and outlets ------------------------------------------------- */

/* Against Simpson's rule, which is exact for a parabola. */
FACT(the_pieces_of_a_parabola_have_its_mean)
{
    const double x[] = {0.0, 0.1, 0.35, 0.8, 1.0};
    double sum = 0.0;
    for (int i = 0; i < 4; i++) {
        const double a = x[i], b = x[i + 1], middle = 0.5 * (a + b);
        const double mean =
            (a * (1.0 - a) + 4.0 * middle * (1.0 - middle) + b * (1.0 - b));
        ck_assert_double_eq_tol(inlet_profile_parabola_mean(a, b), mean, 1e-14);
        sum += (b - a) * inlet_profile_parabola_mean(a, b);
    }
    ck_assert_double_eq_tol(sum, 1.0, 1e-14);
}

/* A parabola that enters a channel leaves it as it is, and the pressure falls
 * by 12 mu U / h^2: 2 % off for 12 cells across, a quarter of that for 24. */
FACT(a_parabola_at_the_inlet_is_poiseuille_flow_at_once)
{
    double error[2];
    for (int i = 0; i < 2; i++) {
        const int n = 12 * (i + 1);
        struct mesh *const m = box(4.0, 1.0, 16, n, 0, 0);
        double profile[24];
        for (int j = 0; j < n; j++)
            profile[j] = inlet_profile_parabola_mean(m->box.edge[1][j],
                                                     m->box.edge[1][j + 1]);
        struct boundary b[6] = {{.kind = BOUNDARY_INLET,
                                 .n_points = 1,
                                 .time = &zero,
                                 .velocity = &one,
                                 .profile = profile},
                                {.kind = BOUNDARY_OUTLET},
                                {.kind = BOUNDARY_NO_SLIP},
                                {.kind = BOUNDARY_NO_SLIP},
                                {.kind = BOUNDARY_SLIP},
                                {.kind = BOUNDARY_SLIP}};
        struct fluid_options o = options(b);
        o.piso_tolerance = 1e-6;
        struct fluid *const fl = fluid_create(m, &o);
        run(fl, 300);
        /* away from both ends */
        const int mid = 16 * (n / 2);
        const double slope = (fl->p[mid + 12] - fl->p[mid + 8]) / 1.0;
        error[i] = fabs(slope / -(12.0 * 0.1) - 1.0);
        discard(fl);
    }
    ck_assert_double_lt(error[0], 0.02);
    ck_assert_double_eq_tol(log2(error[0] / error[1]), 2.0, 0.3);
}

/* A pair of vortices is carried through the outlet: fluid flows back in there,
 * which is counted, and the kinetic energy only decreases. */
FACT_FOR_EACH(a_vortex_leaves_through_an_outlet, 4)
{
    struct boundary b[6] = {{.kind = BOUNDARY_INLET,
                             .n_points = 1,
                             .time = &zero,
                             .velocity = &one},
                            {.kind = BOUNDARY_OUTLET},
                            {.kind = BOUNDARY_SLIP},
                            {.kind = BOUNDARY_SLIP},
                            {.kind = BOUNDARY_SLIP},
                            {.kind = BOUNDARY_SLIP}};
    struct fluid_options o = options(b);
    struct mesh *const m = box(4.0, 2.0, 40, 20, 0, 0);
    o.mu = 1e-3;
    o.dt = 0.02;
    o.time = time_scheme_named(_i % 2 ? "bdf2" : "euler");
    o.convection = convection_scheme_named(_i / 2 ? "second-upwind" : "linear");
    struct fluid *const fl = fluid_create(m, &o);
    for (int c = 0; c < m->n_cells; c++) { /* turns with up to 3 m/s at r 0.4 */
        const double x = m->centre[3 * c] - 3.0, y = m->centre[3 * c + 1] - 1.0;
        const double turn_rate = 12.0 * exp(-(x * x + y * y) / 0.16);
        fl->u[3 * c] = 1.0 - turn_rate * y;
        fl->u[3 * c + 1] = turn_rate * x;
    }
    for (int f = 0; f < m->n_faces; f++) { /* and so do the fluxes */
        const int P = m->owner[f];
        const double *const v =
            &fl->u[3 * (f < m->n_internal ? m->neighbour[f] : P)];
        for (int k = 0; k < 3; k++)
            fl->phi[f] += 0.5 * mesh_S(m, f)[k] * (fl->u[3 * P + k] + v[k]);
    }
    double before = fluid_kinetic_energy(fl);
    int most = 0;
    for (int n = 0; n < 150; n++) {
        ck_assert_int_eq(fluid_step(fl), 0);
        if (fl->report.backflow_faces > most) most = fl->report.backflow_faces;
        if (n % 10 == 9) {
            const double now = fluid_kinetic_energy(fl);
            ck_assert_double_lt(now, 1.02 * before);
            before = now;
        }
    }
    ck_assert_int_gt(most, 2);
    ck_assert_int_eq(fl->report.backflow_faces, 0);
    ck_assert_double_eq_tol(before / (0.5 * 4.0 * 2.0 * 0.1), 1.0, 0.05);
    discard(fl);
}

/* --- a flow round a periodic box ---------------------------------------- */

/* u = G y (y - h) / (2 mu): in the mean -G h^2 / (12 mu). A prescribed mean
 * flow is reached in every step; its gradient is the same. */
FACT(a_mean_gradient_and_the_mean_flow_that_is_kept_agree)
{
    const struct boundary b[2] = {{.kind = BOUNDARY_NO_SLIP},
                                  {.kind = BOUNDARY_NO_SLIP}};
    struct fluid_options o = options(b);
    double flow[3], kept[3];
    o.mean_gradient[0] = -1.2;
    struct fluid *fl = fluid_create(box(1.0, 1.0, 4, 16, 1, 1), &o);
    run(fl, 2000);
    fluid_mean_flow(fl, flow);
    ck_assert_double_eq_tol(flow[0], 1.2 / 12.0 / 0.1, 0.01);
    discard(fl);
    o.mean_gradient[0] = 0.0;
    o.mean_flow[0] = flow[0];
    o.keeps_flow[0] = o.keeps_flow[2] = 1;
    fl = fluid_create(box(1.0, 1.0, 4, 16, 1, 1), &o);
    for (int n = 0; n < 1000; n++) {
        run(fl, 1);
        fluid_mean_flow(fl, kept);
        ck_assert_double_eq_tol(kept[0] / flow[0], 1.0, 1e-9);
    }
    ck_assert_double_eq_tol(fl->mean_gradient[0], -1.2, 1e-8);
    ck_assert_double_eq_tol(fl->mean_gradient[2], 0.0, 1e-12);
    discard(fl);
}

/* --- steps -------------------------------------------------------------- */

/* An inlet switched on at once and one that ramps up: the step is divided so
 * that no part has a larger Courant number; a fixed step is one part. */
FACT_FOR_EACH(ls_5_9_a_step_is_divided_where_its_courant_number_is_too_large, 2)
{
    const double t[] = {0.0, 0.2}, U[] = {_i ? 0.0 : 2.0, 2.0};
    struct boundary b[6] = {
        {.kind = BOUNDARY_INLET, .n_points = 2, .time = t, .velocity = U},
        {.kind = BOUNDARY_OUTLET},
        {.kind = BOUNDARY_SLIP},
        {.kind = BOUNDARY_SLIP},
        {.kind = BOUNDARY_SLIP},
        {.kind = BOUNDARY_SLIP}};
    struct fluid_options o = options(b);
    o.cfl = 0.55;
    o.time = time_scheme_named("bdf2");
    struct fluid *const fl = fluid_create(box(1.0, 0.2, 20, 4, 0, 0), &o);
    for (int n = 1; n <= 8; n++) {
        ck_assert_int_eq(fluid_advance(fl, 0.05), 0);
        ck_assert_double_eq_tol(fl->t, 0.05 * n, 1e-12);
        ck_assert_double_lt(fl->report.cfl, 0.55 * (_i ? 1.35 : 1.01));
    }
    ck_assert_int_eq(fl->report.flow_substeps,
                     4); /* 2 m/s * 0.05 s / 0.05 m / 0.55 */
    fl->options.cfl = 0.0;
    ck_assert_int_eq(fluid_advance(fl, 0.05), 0);
    ck_assert_int_eq(fl->report.flow_substeps, 1);
    ck_assert_double_eq_tol(fl->report.cfl, 2.0, 1e-3);
    discard(fl);
}

/* --- a layer of cells between slip walls ---------------------------------- */

/* The flow between an inlet and an outlet past a wall that moves with `across`
 * [m/s] along z, also. */
static struct fluid *layer_of_cells(struct boundary b[6], double across,
                                    int undisturbed)
{
    static const double U = 1.0;

    for (int i = 0; i < 6; i++)
        b[i] = (struct boundary){.kind = BOUNDARY_SLIP};
    b[0] = (struct boundary){
        .kind = BOUNDARY_INLET, .n_points = 1, .time = &zero, .velocity = &U};
    b[1].kind = BOUNDARY_OUTLET;
    b[2].kind = BOUNDARY_NO_SLIP;
    b[3] =
        (struct boundary){.kind = BOUNDARY_NO_SLIP, .wall = {2.0, 0, across}};
    struct fluid_options o = options(b);
    o.undisturbed = undisturbed;
    return fluid_create(box(1.0, 1.0, 20, 12, 0, 0), &o);
}

/* The walls before and behind it are left out, to the same bits. */
FACT(slip_walls_around_a_layer_of_cells_do_nothing)
{
    struct boundary b[6];
    struct fluid *const all = layer_of_cells(b, 0.0, 0), *const less =
                                                             layer_of_cells(
                                                                 b, 0.0, 1);
    const struct mesh *const m = all->mesh;
    const size_t n = (size_t)m->n_cells;
    double *const u[2] = {alloc_doubles(3 * m->n_faces),
                          alloc_doubles(3 * m->n_faces)};

    ck_assert_int_eq(all->faces->n, m->n_faces);
    ck_assert_int_eq(less->faces->n, m->n_faces - 2 * m->n_cells);
    ck_assert_ptr_null(less->momentum->diag3);
    run(all, 10);
    run(less, 10);
    ck_assert_mem_eq(all->u, less->u, 3 * n * sizeof *all->u);
    ck_assert_mem_eq(all->p, less->p, n * sizeof *all->p);
    ck_assert_mem_eq(all->phi, less->phi,
                     (size_t)m->n_faces * sizeof *all->phi);
    for (int i = 0; i < m->n_patches; i++)
        ck_assert_double_eq(fluid_patch_pressure(all, &m->patches[i]),
                            fluid_patch_pressure(less, &m->patches[i]));
    fluid_boundary_velocity(all, u[0]);
    fluid_boundary_velocity(less, u[1]);
    for (int i = 0; i < 3 * (m->n_faces - m->n_internal); i++)
        ck_assert_double_eq(u[0][i], u[1][i]);
    free(u[0]);
    free(u[1]);
    discard(all);
    discard(less);
}

/* But not where the fluid moves across the layer, or may. */
FACT(slip_walls_hold_what_moves_across_a_layer_of_cells)
{
    struct boundary b[6];
    struct fluid *const moved = layer_of_cells(b, 0.1, 1);

    ck_assert_int_eq(moved->faces->n, moved->mesh->n_faces);
    discard(moved);
    struct mesh *const two = mesh_create_box(
        &(struct box_spec){{1, 1, 1}, {9, 9, 2}, {1, 1, 1}, {0}});
    for (int i = 0; i < 6; i++)
        b[i] = (struct boundary){.kind = BOUNDARY_SLIP};
    struct fluid_options o = options(b);
    o.undisturbed = 1;
    struct fluid *const thick = fluid_create(two, &o);
    ck_assert_int_eq(thick->faces->n, two->n_faces);
    discard(thick);
    /* With a periodic third direction the last slip walls are along it. */
    struct mesh *const around = mesh_create_box(
        &(struct box_spec){{1, 1, 1}, {9, 9, 1}, {1, 1, 1}, {0, 0, 1}});
    struct fluid *const endless = fluid_create(around, &o);
    ck_assert_int_eq(endless->faces->n, around->n_faces);
    discard(endless);
}
