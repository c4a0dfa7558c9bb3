/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The methods by solid fractions, and what happens in narrow gaps. */
#include "resolved.h"

#include <string.h>

#include "base/vector.h"
#include "facts.h"
#include "resolved/solid_bodies.h"
#include "resolved/body_motion.h"

static const double middle[3] = {0.5, 0.5, 0.5};

/* A cubic array of solid fraction 0.216 with 9 cells in a diameter: drag over
 * that of [ZH82], at nu dt / h^2 = vn. */
static double drag_by(const struct body_method *method, double vn, int steps,
                      struct pool *p)
{
    const double d = cbrt(6.0 * 0.216 / M_PI);
    double flow[3];

    pool_one_sphere_by(p, d, 12, 1.0, vn / 144.0, -1e-6, middle, BODY_FIXED,
                       1.0, method);
    ck_assert_int_eq(solid_bodies_begin(p->bodies, p->fluid), 0);
    pool_run(p, steps);
    fluid_mean_flow(p->fluid, flow);
    return p->bodies->force[0] / (3.0 * M_PI * d * flow[0]) / 7.442;
}

/* What is set after an implicit viscous step is forgotten by diffusion within
 * the next one: 40 % of the drag are left at nu dt / h^2 = 1. */
FACT(ls_5_18_velocity_set_after_the_step_loses_half_of_the_drag)
{
    struct pool p;
    const double short_step =
        drag_by(&fraction_methods_fictitious, 0.1, 300, &p);
    pool_free(&p);
    const double long_step =
        drag_by(&fraction_methods_fictitious, 1.0, 100, &p);
    pool_free(&p);

    ck_assert_double_ge(short_step, 0.75);
    ck_assert_double_le(long_step, 0.5);
}

/* The velocity in the body is that of the body, but for what the projection
 * changes again. */
FACT(ls_5_17_the_fluid_inside_moves_with_the_body)
{
    struct pool p;
    double worst = 0.0, flow[3];

    drag_by(&fraction_methods_fictitious, 0.1, 120, &p);
    fluid_mean_flow(p.fluid, flow);
    for (int j = 0; j < p.bodies->end[0]; j++) {
        const struct hold_link *const l = &p.bodies->link[j];
        if (vector_length(l->r) < 0.25)
            worst = fmax(worst, vector_length(&p.fluid->u[3 * l->cell]));
    }
    ck_assert_double_le(worst, 0.1 * flow[0]);
    pool_free(&p);
}

/* The fluxes after the second projection satisfy continuity as those of PISO
 * do; and the force is what changed the velocity, all that drives the flow. */
FACT(ls_5_20_the_corrected_fluxes_have_no_divergence)
{
    struct pool p;

    drag_by(&fraction_methods_fictitious, 1.0, 100, &p);
    ck_assert_double_le(p.fluid->report.mass_residual, 1e-6);
    ck_assert_double_eq_tol(p.bodies->force[0] / 1e-6, 1.0, 1e-3);
    ck_assert_double_le(p.fluid->report.momentum_residual, 1e-10);
    pool_free(&p);
}

/* [LS 5.19]: without it the velocity set in the bodies would have a divergence
 * at their surface. The velocity of the cells has that of the fluxes within the
 * interpolation. */
FACT(ls_5_19_the_correction_of_the_velocity_follows_the_fluxes)
{
    struct pool p;
    double worst = 0.0, most = 0.0;

    drag_by(&fraction_methods_fictitious, 1.0, 100, &p);
    for (int f = 0; f < p.mesh->n_internal; f++) {
        const double *const S = mesh_S(p.mesh, f);
        const double of_cells =
            0.5 * (vector_dot(&p.fluid->u[3 * p.mesh->owner[f]], S) +
                   vector_dot(&p.fluid->u[3 * p.mesh->neighbour[f]], S));
        worst = fmax(worst, fabs(p.fluid->phi[f] - of_cells));
        most = fmax(most, fabs(p.fluid->phi[f]));
    }
    ck_assert_double_le(worst, 0.1 * most);
    pool_free(&p);
}

/* The force is built up until the velocity in every cell that the sphere cuts
 * is that of the sphere: it is too large, at any step. */
FACT(ls_5_21_the_accumulated_force_makes_the_sphere_too_large)
{
    struct pool p;
    const double short_step = drag_by(&fraction_methods_piso_ib, 0.3, 150, &p);
    pool_free(&p);
    const double long_step = drag_by(&fraction_methods_piso_ib, 3.0, 100, &p);
    double worst = 0.0, flow[3];

    fluid_mean_flow(p.fluid, flow);
    for (int j = 0; j < p.bodies->end[0]; j++)
        worst =
            fmax(worst, vector_length(&p.fluid->u[3 * p.bodies->link[j].cell]));
    pool_free(&p);
    ck_assert_double_eq_tol(long_step / short_step, 1.0, 0.02);
    ck_assert_double_ge(short_step, 1.05);
    ck_assert_double_le(worst, 0.02 * flow[0]);
}

/* A sphere begins to move in a closed box, in a fluid at rest. */
static void sphere_in_a_closed_box(struct pool *p,
                                   const struct body_method *method, double lid)
{
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {8, 8, 8},
                                   .walls = {1, 1, 1},
                                   .rho = 1.0,
                                   .mu = 0.05,
                                   .dt = 0.02,
                                   .lid = lid,
                                   .method = method};
    const struct body_shape sphere = body_shape_sphere(0.4);

    pool_create(p, &o);
    p->fluid->options.piso_tolerance = 0.0;
    p->fluid->options.outer_correctors = 2;
    solid_bodies_add(p->bodies, &sphere, middle, 1.0, BODY_PRESCRIBED);
    p->bodies->ps->vx[0] = 0.5;
    ck_assert_int_eq(solid_bodies_begin(p->bodies, p->fluid), 0);
}

/* The second projection changes the velocity beside the walls, after their
 * friction has acted. Without that difference 1e-2 of the sum of all forces is
 * missing; 1e-10 is the tolerance of the equations. */
FACT(ls_5_19_the_balance_of_momentum_knows_when_the_walls_acted)
{
    struct pool p;

    sphere_in_a_closed_box(&p, &fraction_methods_fictitious, 0.3);
    for (int i = 0; i < 5; i++) {
        pool_run(&p, 1);
        ck_assert_double_le(p.fluid->report.momentum_residual, 1e-10);
    }
    pool_free(&p);
}

/* In a fluid at rest the first flux that convects has a divergence beside an
 * inlet. The balance counts the momentum that this moves between cells with the
 * velocity of the equation, not with the one that is set in the body
 * afterwards: the difference is 2e-5 of the sum of all forces. */
FACT(ls_5_18_what_was_convected_is_counted_before_the_body_acts)
{
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {8, 8, 8},
                                   .walls = {1, 1, 1},
                                   .rho = 1.0,
                                   .mu = 0.01,
                                   .dt = 0.02,
                                   .inlet = 0.5,
                                   .method = &fraction_methods_fictitious};
    const struct body_shape sphere = body_shape_sphere(0.4);
    struct pool p;

    pool_create(&p, &o);
    solid_bodies_add(p.bodies, &sphere, (double[3]){0.5, 0.22, 0.5}, 1.0,
                     BODY_FIXED);
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    for (int i = 0; i < 3; i++) {
        pool_run(&p, 1);
        ck_assert_double_le(p.fluid->report.momentum_residual, 1e-10);
    }
    pool_free(&p);
}

/* In the first corrector nothing flows, in the others, or in the second
 * projection, what the body drives. That is solved to the tolerance, 1e-10,
 * with some ten iterations, and not to rounding, 1e-14, or to the last digit of
 * nothing. */
FACT_FOR_EACH(ls_5_21_a_body_begins_to_move_in_a_fluid_at_rest, 2)
{
    struct pool p;
    const struct body_method *const method =
        _i == 0 ? &fraction_methods_piso_ib : &fraction_methods_fictitious;

    sphere_in_a_closed_box(&p, method, 0.0);
    pool_run(&p, 1);
    ck_assert_int_le(p.fluid->report.pressure.iterations, 30);
    ck_assert_double_le(p.fluid->report.mass_residual, 1e-8);
    ck_assert_double_ge(p.fluid->report.mass_residual, 1e-13);
    pool_free(&p);
}

/* --- shapes -----------------------------------------------------------------
 */

static double distance_at(const struct body_shape *s, double x, double y,
                          double z)
{
    return body_shape_distance(s, (double[3]){x, y, z});
}

/* Beside a face, an edge and a corner, and inside. */
FACT(distance_from_a_box)
{
    const struct body_shape box = body_shape_box((double[3]){2.0, 4.0, 6.0});
    double e[3];

    ck_assert_double_eq_tol(distance_at(&box, 1.5, 0.3, 0.1), 0.5, 1e-15);
    ck_assert_double_eq_tol(distance_at(&box, -4.0, 6.0, 0.0), 5.0, 1e-15);
    ck_assert_double_eq_tol(distance_at(&box, 2.0, 4.0, -5.0), 3.0, 1e-15);
    ck_assert_double_eq_tol(distance_at(&box, 0.9, 0.0, 0.0), -0.1, 1e-15);
    body_shape_extent(&box, e);
    ck_assert_double_eq(e[2], 3.0);
    ck_assert_double_eq_tol(body_shape_volume(&box), 48.0, 1e-12);
}

/* Its axis along (1, 1, 0), radius 1, length 4. */
FACT(distance_from_a_cylinder)
{
    const double r = sqrt(0.5);
    const struct body_shape c =
        body_shape_cylinder(2.0, 4.0, (double[3]){3.0, 3.0, 0.0});
    double e[3];

    ck_assert_double_eq_tol(distance_at(&c, 0.0, 0.0, 1.5), 0.5, 1e-14);
    ck_assert_double_eq_tol(distance_at(&c, 5.0 * r, 5.0 * r, 0.0), 3.0, 1e-14);
    ck_assert_double_eq_tol(distance_at(&c, 5.0 * r, 5.0 * r, 5.0), 5.0, 1e-14);
    ck_assert_double_eq_tol(distance_at(&c, 0.5 * r, 0.5 * r, 0.2), -0.8,
                            1e-14);
    body_shape_extent(&c, e);
    ck_assert_double_eq_tol(e[0], 3.0 * r, 1e-14);
    ck_assert_double_eq_tol(e[2], 1.0, 1e-14);
    ck_assert_double_eq_tol(body_shape_volume(&c), 4.0 * M_PI, 1e-12);
}

/* --- gaps ------------------------------------------------------------------
 */

FACT(squeeze_film_begins_where_the_mesh_ends)
{
    const double mu = 2.0, R = 0.5, reach = 0.1, z_min = 1e-3;
    const double near = squeeze_film_coefficient(mu, R, 1e-2, z_min, reach);

    ck_assert_double_eq(squeeze_film_coefficient(mu, R, 0.1, z_min, reach),
                        0.0);
    ck_assert_double_eq(squeeze_film_coefficient(mu, R, -0.1, z_min, reach),
                        0.0);
    ck_assert_double_eq_tol(near, 6.0 * M_PI * mu * R * R * 90.0, 1e-9);
    ck_assert_double_eq(squeeze_film_coefficient(mu, R, 1e-5, z_min, reach),
                        squeeze_film_coefficient(mu, R, 1e-3, z_min, reach));
}

/* m dg/dt = -k(z) g has the integral m (g - g_0) = -6 pi mu R^2 (ln z -
 * z/reach) between the ends: the speed lost depends on the way alone. Each part
 * of the way changes z by a fifth, which leaves 3 % of the loss. */
FACT(squeeze_film_takes_the_speed_that_its_integral_says)
{
    const struct squeeze_film l = {.mu = 1e-2, .z_min = 1e-5, .reach = 0.1};
    const double R = 0.1, m = 1.0, g = -1.0, dt = 0.06,
                 scale = 6.0 * M_PI * l.mu * R * R;
    const double after = squeeze_film_velocity(&l, R, m, 0.08, g, dt);
    /* the loss is small, so the way is g dt to first order */
    const double z = 0.08 + g * dt;
    const double lost = scale / m * (log(0.08 / z) - (0.08 - z) / l.reach);

    ck_assert_double_eq_tol((after - g) / lost, 1.0, 0.03);
}

/* At a gap far below z_min the damping time is far below the step. */
FACT(squeeze_film_never_turns_a_body_round)
{
    const struct squeeze_film l = {.mu = 1e3, .z_min = 1e-6, .reach = 0.1};
    const double after = squeeze_film_velocity(&l, 0.1, 1.0, 1e-3, -1.0, 0.1);

    ck_assert_double_le(after, 0.0);
    ck_assert_double_ge(after, -1e-6);
}

/* Between a sphere that comes down and the floor less than a cell is left. Were
 * it held there, the fluid could not get out, and the pressure would throw the
 * sphere back with sixty times the speed that it came with. */
FACT(ew18_4_a_sphere_is_not_thrown_back_by_a_gap_of_less_than_a_cell)
{
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {12, 12, 12},
                                   .walls = {1, 1, 1},
                                   .rho = 1.0,
                                   .mu = 1e-3,
                                   .dt = 0.02,
                                   .virtual_mass = 2.0};
    const struct body_shape sphere = body_shape_sphere(0.4);
    const double x[3] = {0.5, 0.28, 0.5};
    struct pool p;
    double fastest = 0.0;

    pool_create(&p, &o);
    solid_bodies_add(p.bodies, &sphere, x, 2.0, BODY_FREE);
    p.bodies->ps->vy[0] = -0.5;
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    for (int i = 0; i < 60; i++) { /* to the floor and back */
        pool_run(&p, 1);
        fastest = fmax(fastest, p.bodies->ps->vy[0]);
    }
    ck_assert_double_ge(fastest, 0.05);
    ck_assert_double_le(fastest, 0.5);
    pool_free(&p);
}

/* A sphere falls on a box and comes to rest on its top, where the spring
 * carries the weight less that of the fluid. */
FACT(ls_4_4_a_sphere_comes_to_rest_on_a_box)
{
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {12, 12, 12},
                                   .walls = {0, 1, 0},
                                   .rho = 1.0,
                                   .mu = 0.1,
                                   .dt = 0.01,
                                   .virtual_mass = 2.0,
                                   .n = 2,
                                   .dem_steps = 10,
                                   .tolerance = 1e-8};
    const double size[3] = {0.8, 0.4, 0.8}, at[3] = {0.5, 0.2, 0.5};
    const double x[3] = {0.52, 0.60, 0.5}, d = 0.3, k = 20.0;
    const struct body_shape box = body_shape_box(size),
                            sphere = body_shape_sphere(d);
    const double weight = (3.0 - 1.0) * M_PI / 6.0 * d * d * d;
    struct pool p;

    pool_create(&p, &o);
    p.bodies->options.gravity[1] = -1.0;
    p.bodies->contacts.material.stiffness = k;
    solid_bodies_add(p.bodies, &box, at, 1.0, BODY_FIXED);
    solid_bodies_add(p.bodies, &sphere, x, 3.0, BODY_FREE);
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    pool_run(&p, 400);
    ck_assert_double_eq_tol(p.bodies->ps->y[1], 0.4 + 0.5 * d - weight / k,
                            0.2 * weight / k); /* it trembles a little */
    ck_assert_double_eq(p.bodies->ps->y[0], 0.2);
    pool_free(&p);
}
