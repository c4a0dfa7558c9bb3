/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bodies at the ends of the box: at a seam, and on the way out; and what those
 * on springs come upon. */
#include "resolved.h"

#include <gsl/gsl_math.h>
#include <string.h>

#include "facts.h"
#include "resolved/shapes/block_contacts.h"
#include "resolved/body_motion.h"
#include "resolved/shapes/shapes.h"

/* Two spheres and a clump that touch or nearly touch, with spin and weight, in
 * a periodic box that a gradient drives; all moved by so many cells. */
static void three_bodies(struct pool *p, const int cells[3])
{
    enum { N = 12 };
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {N, N, N},
                                   .rho = 1.0,
                                   .mu = 0.05,
                                   .dt = 0.01,
                                   .gradient = {-1.0, 0.5, 0.2},
                                   .virtual_mass = 2.0,
                                   .n = 3,
                                   .dem_steps = 10};
    const double at[3][3] = {
        {0.50, 0.50, 0.50}, {0.784, 0.52, 0.50}, {0.48, 0.24, 0.45}};
    const struct body_ball ball[2] = {{{-0.1, 0.0, 0.0}, 0.12},
                                      {{0.1, 0.02, 0.0}, 0.12}};
    const struct body_shape shape[3] = {
        body_shape_sphere(0.3), body_shape_sphere(0.28),
        body_shape_outline(clump_create(2, ball))};

    int touched = 0;

    pool_create(p, &o);
    p->bodies->options.gravity[1] = -1.0;
    p->bodies->contacts.material = (struct material){
        .stiffness = 30.0, .restitution = 0.8, .friction = 0.3};
    p->bodies->lubrication = (struct squeeze_film){o.mu, 1e-4, 2.0 / N};
    for (int i = 0; i < 3; i++) {
        double x[3];
        for (int k = 0; k < 3; k++)
            x[k] = fmod(at[i][k] + cells[k] / (double)N, 1.0);
        solid_bodies_add(p->bodies, &shape[i], x, 2.0, BODY_FREE);
    }
    p->bodies->ps->wz[0] = 2.0, p->bodies->ps->vx[1] = -0.4;
    ck_assert_int_eq(solid_bodies_begin(p->bodies, p->fluid), 0);
    for (int i = 0; i < 25; i++) {
        pool_run(p, 1);
        touched += p->bodies->dem_report.max_overlap > 0.0;
    }
    ck_assert_int_gt(touched, 0);
}

/* Faces, edges and a corner. The cells are the same ones, so what differs is
 * rounding and what the solver leaves, 1e-10; a neighbour that is not found
 * through the seam would change the velocities by 0.1. */
FACT_FOR_EACH(ew18_2_bodies_at_a_seam_move_as_in_the_middle, 7)
{
    struct pool here, there;

    three_bodies(&here, (const int[3]){0, 0, 0});
    const int to = _i + 1,
              half[3] = {to & 1 ? 6 : 0, to & 2 ? 6 : 0, to & 4 ? 6 : 0};
    three_bodies(&there, half);
    const struct particles *const a = here.bodies->ps, *const b =
                                                           there.bodies->ps;
    for (int i = 0; i < 3; i++) {
        const double v[3] = {a->vx[i], a->vy[i], a->vz[i]},
                     u[3] = {b->vx[i], b->vy[i], b->vz[i]},
                     w[3] = {a->wx[i], a->wy[i], a->wz[i]},
                     s[3] = {b->wx[i], b->wy[i], b->wz[i]};
        for (int k = 0; k < 3; k++) {
            ck_assert_double_eq_tol(u[k], v[k], 1e-7);
            ck_assert_double_eq_tol(s[k], w[k], 1e-6);
        }
    }
    pool_free(&here);
    pool_free(&there);
}

/* The mean flow [m/s] that a gradient drives in a while past n spheres in a row
 * of periods of 1 m, with a gap of less than a cell between them. */
static double flow_past(int n)
{
    enum { N = 12 };
    const struct pool_options o = {.size = {1.0, n, 1.0},
                                   .cells = {N, n * N, N},
                                   .rho = 1.0,
                                   .mu = 1.0,
                                   .dt = 0.01,
                                   .gradient = {-1.0, 0.0, 0.0},
                                   .n = n};
    const struct body_shape sphere = body_shape_sphere(0.9508);
    struct pool p;
    double flow[3];

    pool_create(&p, &o);
    for (int i = 0; i < n; i++)
        solid_bodies_add(p.bodies, &sphere, (double[3]){0.53, i + 0.41, 0.37},
                         1.0, BODY_FIXED);
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    pool_run(&p, 20);
    fluid_mean_flow(p.fluid, flow);
    pool_free(&p);
    return flow[0];
}

/* One sphere in one period and two in two are the same array: a cell in the gap
 * misses a part of its neighbours on both sides, be they in two bodies or in
 * one and its image. */
FACT(ew18_4_a_sphere_beside_its_image_is_one_beside_another)
{
    const double two = flow_past(2);

    ck_assert_double_eq_tol(flow_past(1) / two, 1.0, 1e-7);
}

/* Two spheres in a stream toward an outlet, one behind the other. */
static void create_stream(struct pool *p, const struct pool_options *o)
{
    const struct body_shape sphere = body_shape_sphere(0.4);

    pool_create(p, o);
    solid_bodies_add(p->bodies, &sphere, (double[3]){0.5, 0.75, 0.5}, 1.5,
                     BODY_FREE);
    solid_bodies_add(p->bodies, &sphere, (double[3]){0.5, 0.3, 0.5}, 1.5,
                     BODY_FREE);
    p->bodies->ps->vy[0] = p->bodies->ps->vy[1] = 0.5;
    ck_assert_int_eq(solid_bodies_begin(p->bodies, p->fluid), 0);
}

/* A sphere on its way out keeps its velocity, and the outlet is no wall to it;
 * what has left touches nothing that follows. The fluid satisfies continuity
 * and the balance of momentum all the time. */
FACT(ew18_2_a_body_leaves_through_an_outlet)
{
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {10, 10, 10},
                                   .walls = {1, 1, 1},
                                   .rho = 1.0,
                                   .mu = 0.02,
                                   .dt = 0.02,
                                   .inlet = 0.5,
                                   .virtual_mass = 2.0,
                                   .n = 2,
                                   .dem_steps = 5};
    struct pool p;
    double leaving = 0.0;
    int steps = 0;

    create_stream(&p, &o);
    const struct body_exit *const e = p.bodies->exit;
    ck_assert_ptr_nonnull(e);
    for (; e->n_gone < 2 && steps < 200; steps++) {
        pool_run(&p, 1);
        ck_assert_double_le(p.fluid->report.mass_residual, 1e-8);
        ck_assert_double_le(p.fluid->report.momentum_residual, 1e-8);
        if (e->gone[1] == 1) {
            if (leaving == 0.0) leaving = p.bodies->ps->vy[1];
            ck_assert_double_eq(p.bodies->ps->vy[1], leaving);
        }
    }
    ck_assert_int_eq(e->n_gone, 2);
    ck_assert_int_ge(steps, 40);
    ck_assert_double_gt(leaving, 0.1);
    ck_assert_double_eq(p.bodies->ps->vy[0], 0.0);
    pool_run(&p, 1);
    ck_assert_int_eq(p.bodies->n_cells, 0);
    pool_free(&p);
}

/* A small box of next to no fluid. */
static void create_void(struct pool *p, int walls)
{
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {10, 10, 10},
                                   .walls = {walls, walls, walls},
                                   .rho = 1e-9,
                                   .mu = 1e-9,
                                   .dt = 1e-3,
                                   .n = 2};

    pool_create(p, &o);
    p->bodies->contacts.material =
        (struct material){.stiffness = 100.0, .restitution = 1.0};
}

/* A free sphere hits one of the same mass on a soft spring, and stops, as it
 * would if that were free. One that could not be pushed would throw it back.
 * Both get the same impulse; the impact has 40 steps, and its end falls within
 * one. */
FACT(a_sphere_on_a_spring_is_pushed_by_one_that_hits_it)
{
    const struct body_shape sphere = body_shape_sphere(0.3);
    struct pool p;

    create_void(&p, 0);
    solid_bodies_add(p.bodies, &sphere, (double[3]){0.3, 0.5, 0.5}, 1.0,
                     BODY_FREE);
    solid_bodies_add(p.bodies, &sphere, (double[3]){0.601, 0.5, 0.5}, 1.0,
                     BODY_FIXED);
    solid_bodies_set_spring(p.bodies, 1, (double[3]){1e-6, 0.0, 0.0});
    const struct particles *const ps = p.bodies->ps;
    ps->vx[0] = 1.0;
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    for (int i = 0; i < 60; i++)
        ck_assert_int_eq(body_motion_advance(p.bodies, p.fluid->options.dt), 0);
    ck_assert_double_eq_tol(ps->vx[0], 0.0, 0.05);
    ck_assert_double_eq_tol(ps->vx[0] + ps->vx[1], 1.0, 1e-5);
    pool_free(&p);
}

/* A sphere alone, one beside a free one, whose contacts are of another kind, a
 * box, and a cylinder that reaches through the walls along which it is held:
 * thrown at a wall without losses they come back as fast, to the part of the
 * last of 40 steps in which the overlap ends. */
FACT_FOR_EACH(a_body_on_a_spring_bounces_off_a_wall, 4)
{
    const struct body_shape sphere = body_shape_sphere(0.3),
                            box = body_shape_box((double[3]){0.4, 0.3, 0.4}),
                            tube = body_shape_cylinder(
                                0.3, 2.0, (double[3]){0.0, 0.0, 1.0});
    const struct body_shape *const of[4] = {&sphere, &sphere, &box, &tube};
    struct pool p;

    create_void(&p, 1);
    p.bodies->contacts.material.friction = 0.3;
    solid_bodies_add(p.bodies, of[_i], (double[3]){0.5, 0.2, 0.5}, 1.0,
                     BODY_FIXED);
    solid_bodies_set_spring(p.bodies, 0, (double[3]){1e-6, 1e-6, 0.0});
    if (_i == 1)
        solid_bodies_add(p.bodies, &sphere, (double[3]){0.5, 0.8, 0.5}, 1.0,
                         BODY_FREE);
    const struct particles *const ps = p.bodies->ps;
    ps->vy[0] = -1.0;
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    for (int i = 0; i < 150; i++) {
        ck_assert_int_eq(body_motion_advance(p.bodies, p.fluid->options.dt), 0);
        ck_assert_double_ge(ps->y[0], 0.1);
    }
    ck_assert_double_eq_tol(ps->vy[0], 1.0, 0.05);
    pool_free(&p);
}

/* A box on a spring comes with 1 m/s to a sphere that is fixed or prescribed,
 * and comes back, as nothing is lost in the impact of 40 steps. */
FACT_FOR_EACH(a_box_on_a_spring_bounces_off_a_sphere_that_cannot_be_pushed, 2)
{
    const struct body_shape sphere = body_shape_sphere(0.3),
                            box = body_shape_box((double[3]){0.3, 0.3, 0.3});
    struct pool p;

    create_void(&p, 0);
    solid_bodies_add(p.bodies, &sphere, (double[3]){0.3, 0.5, 0.5}, 1.0,
                     _i ? BODY_PRESCRIBED : BODY_FIXED);
    solid_bodies_add(p.bodies, &box, (double[3]){0.62, 0.5, 0.5}, 1.0,
                     BODY_FIXED);
    solid_bodies_set_spring(p.bodies, 1, (double[3]){1e-6, 0.0, 0.0});
    const struct particles *const ps = p.bodies->ps;
    ps->vx[1] = -1.0;
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    for (int i = 0; i < 150; i++)
        ck_assert_int_eq(body_motion_advance(p.bodies, p.fluid->options.dt), 0);
    ck_assert_double_eq_tol(ps->vx[1], 1.0, 0.05);
    ck_assert_double_eq(ps->x[0], 0.3);
    pool_free(&p);
}

/* Plates along each axis, and a disc: with x = nu dt / R^2 = 16 of half of what
 * they are thick, as heavy as the fluid, each gets 2.5 times 4.5 (16 + 4)/2 and
 * twice its added mass sqrt(6 V / (pi w^3))/2 (24.10); and an overlap is
 * compared with what they are thick. */
FACT_FOR_EACH(ew18_2_virtual_mass_goes_by_the_smallest_width_of_a_block, 4)
{
    const struct body_shape of[4] = {
        body_shape_box((double[3]){0.05, 0.5, 0.5}),
        body_shape_box((double[3]){0.5, 0.05, 0.5}),
        body_shape_box((double[3]){0.5, 0.5, 0.05}),
        body_shape_cylinder(0.5, 0.05, (double[3]){1.0, 0.0, 0.0})};
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {10, 10, 10},
                                   .rho = 1.0,
                                   .mu = 1.0,
                                   .dt = 0.01,
                                   .virtual_mass = 2.0,
                                   .n = 1};
    const struct body_gap point = {.j = -1};
    struct pool p;

    pool_create(&p, &o);
    solid_bodies_add(p.bodies, &of[_i], (double[3]){0.5, 0.5, 0.5}, 1.0,
                     BODY_FIXED);
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    body_motion_set_forces(p.bodies, o.dt);
    ck_assert_double_eq_tol(p.bodies->C_v[0],
                            112.5 + sqrt(_i < 3 ? 600.0 / M_PI : 150.0), 1e-10);
    ck_assert_double_eq_tol(body_gaps_width(p.bodies, &point), 0.05, 1e-15);
    pool_free(&p);
}

/* 49 times 1/49 is less than 1 by rounding: such an axis is one of the mesh,
 * and the part of the cylinder beyond the walls has no volume. */
FACT(a_cylinder_is_cut_at_the_walls_whatever_the_length_of_its_axis)
{
    const struct body_shape tube =
        body_shape_cylinder(0.2, 3.0, (double[3]){0.0, 0.0, 49.0});
    struct pool p;

    create_void(&p, 1);
    ck_assert_double_lt(tube.axis[2], 1.0);
    solid_bodies_add(p.bodies, &tube, (double[3]){0.5, 0.5, 0.5}, 1.0,
                     BODY_FIXED);
    ck_assert_double_eq_tol(p.bodies->volume[0], 0.01 * M_PI, 1e-15);
    pool_free(&p);
}

/* Two boxes have no contacts. Prescribed ones may overlap, but one on a spring
 * would go through what should stop it. */
FACT_FOR_EACH(a_box_on_a_spring_does_not_go_through_another_in_silence, 2)
{
    const struct body_shape box = body_shape_box((double[3]){0.3, 0.3, 0.3});
    struct pool p;

    create_void(&p, 0);
    solid_bodies_add(p.bodies, &box, (double[3]){0.3, 0.5, 0.5}, 1.0,
                     BODY_PRESCRIBED);
    solid_bodies_add(p.bodies, &box, (double[3]){0.45, 0.5, 0.5}, 1.0,
                     BODY_FIXED);
    if (_i == 1)
        solid_bodies_set_spring(p.bodies, 1, (double[3]){1.0, 0.0, 0.0});
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    ck_assert_int_eq(fluid_step(p.fluid), 0);
    ck_assert_int_eq(body_motion_advance(p.bodies, p.fluid->options.dt), _i);
    pool_free(&p);
}

/* A cylinder from one wall to the other moves along both, prescribed or, heavy
 * as it is, on a soft spring: no fluid is squeezed out there, and in every cell
 * that is a cell deep in it the fluid moves with it to 1/C of what presses. */
FACT_FOR_EACH(ew18_4_a_body_that_slides_along_walls_is_held_beside_them, 2)
{
    const struct pool_options o = {.size = {1.0, 1.0, 0.25},
                                   .cells = {16, 16, 4},
                                   .walls = {1, 1, 1},
                                   .rho = 1.0,
                                   .mu = 0.02,
                                   .dt = 0.02};
    const struct body_shape tube =
        body_shape_cylinder(0.4, 0.25, (double[3]){0.0, 0.0, 1.0});
    const double x[3] = {0.45, 0.5, 0.125};
    struct pool p;
    int deep = 0;

    pool_create(&p, &o);
    solid_bodies_add(p.bodies, &tube, x, 1e6, BODY_PRESCRIBED);
    if (_i == 1)
        solid_bodies_set_spring(p.bodies, 0, (double[3]){1e-6, 0.0, 0.0});
    const struct particles *const ps = p.bodies->ps;
    ps->vx[0] = 0.3;
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    ck_assert_int_eq(fluid_step(p.fluid), 0);
    for (int c = 0; c < p.mesh->n_cells; c++) {
        const double *const at = &p.mesh->centre[3 * c];
        const double r[3] = {at[0] - x[0], at[1] - x[1], 0.0};
        if (body_shape_distance(&tube, r) > -1.0 / 16.0) continue;
        ck_assert_double_eq_tol(p.fluid->u[3 * c], 0.3, 3e-3);
        deep++;
    }
    ck_assert_int_ge(deep, 4 * 14);
    pool_free(&p);
}

/* The velocity [m/s] of a cylinder from wall to wall across the axis z, 8 cells
 * apart, 20 steps after it was thrown. */
static double between_walls(const struct body_shape *shape,
                            enum body_motion motion)
{
    const struct pool_options o = {.size = {1.0, 1.0, 0.5},
                                   .cells = {16, 16, 8},
                                   .walls = {1, 1, 1},
                                   .rho = 1.0,
                                   .mu = 1e-2,
                                   .dt = 0.01,
                                   .virtual_mass = 2.0,
                                   .dem_steps = 5,
                                   .n = 1};
    struct pool p;

    pool_create(&p, &o);
    solid_bodies_add(p.bodies, shape, (double[3]){0.5, 0.6, 0.25}, 1.5, motion);
    if (motion == BODY_SPRING)
        solid_bodies_set_spring(p.bodies, 0, (double[3]){1e-9, 1e-9, 0.0});
    p.bodies->ps->vy[0] = -1.0;
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    pool_run(&p, 20);
    const double v = p.bodies->ps->vy[0];
    pool_free(&p);
    return v;
}

/* One on soft springs, which cannot move along z, holds the fluid in the cells
 * beside the two walls as well. So does a free one, be it a little shorter;
 * without those cells it is half as fast again. Its forces act in halves of
 * particle steps, which is 0.01 here. */
FACT_FOR_EACH(ew18_2_a_free_cylinder_from_wall_to_wall_is_held_beside_them, 2)
{
    const double axis[3] = {0.0, 0.0, 1.0};
    const struct body_shape shape = body_shape_cylinder(0.4, 0.5, axis),
                            shorter = body_shape_cylinder(0.4, 0.48, axis),
                            free = body_shape_outline(block_outline_create(
                                _i == 0 ? &shape : &shorter,
                                (double[3]){0.0, 0.0, 0.0}));
    const double v = between_walls(&shape, BODY_SPRING);

    ck_assert_double_eq_tol(between_walls(&free, BODY_FREE), v,
                            (_i == 0 ? 0.02 : 0.05) * fabs(v));
}

/* A fixed box in a channel of 16 cells a side with an inlet below and an outlet
 * above, `gap` [m] from each of its four walls, all told of it. */
static void create_plug(struct pool *p, const struct pool_options *o,
                        double gap)
{
    const double side = 1.0 - 2.0 * gap;
    const struct body_shape box = body_shape_box((double[3]){side, 0.4, side});

    pool_create(p, o);
    solid_bodies_add(p->bodies, &box, (double[3]){0.5, 0.7, 0.5}, 1.0,
                     BODY_FIXED);
    ck_assert_int_eq(solid_bodies_begin(p->bodies, p->fluid), 0);
}

/* The largest velocity upward [m/s] at half of the height of the box: in its
 * cells, but for the layer at the surface, or beside it. */
static double fastest(const struct pool *p, int inside)
{
    double most = 0.0;

    for (int c = 0; c < p->mesh->n_cells; c++) {
        const double *const at = &p->mesh->centre[3 * c];
        const int in = fabs(at[0] - 0.5) < 0.4 && fabs(at[2] - 0.5) < 0.4;
        if (fabs(at[1] - 0.7) < 0.05 && in == inside)
            most = fmax(most, fabs(p->fluid->u[3 * c + 1]));
    }
    return most;
}

/* Where less than a cell is left the body holds all of them, in the corners
 * too, and what comes in could only go through it: that is told, and the bodies
 * do not move on. Where a cell or more is left the flow goes through the gap:
 * inside the box it has less than 1 % of the velocity in the gap. */
FACT_FOR_EACH(a_body_that_cuts_an_inlet_off_is_told_and_never_leaks, 5)
{
    const struct pool_options o = {.size = {1.0, 1.6, 1.0},
                                   .cells = {16, 26, 16},
                                   .walls = {1, 1, 1},
                                   .rho = 1.0,
                                   .mu = 0.01,
                                   .dt = 0.02,
                                   .inlet = 0.3};
    const double gap[] = {0.4, 0.56, 0.95, 1.05, 1.6};
    const int told = gap[_i] < 1.0;
    struct pool p;

    create_plug(&p, &o, gap[_i] / 16.0);
    ck_assert_int_eq(p.bodies->seal.inlet, told);
    ck_assert_int_eq(p.bodies->seal.closed.beside, told);
    ck_assert_int_eq(p.bodies->seal.open.beside, 0);
    if (told) {
        ck_assert_double_eq_tol(p.bodies->seal.closed.width, gap[_i], 1e-9);
        ck_assert_int_ne(body_motion_run(p.bodies, 1, o.dt), 0);
    } else {
        pool_run(&p, 5);
        ck_assert_double_gt(fastest(&p, 0), 0.5);
        ck_assert_double_lt(fastest(&p, 1), 0.01 * fastest(&p, 0));
    }
    pool_free(&p);
}

/* A wall with the gap g [cells] to the floor, 1 m each, which a gradient drives
 * the fluid through, or which slides over it. Sets what flows through the gap
 * over what Poiseuille says, g^3/12, and the force of the floor on all that
 * slides over that of Couette, 1/g. */
static void wall_over_floor(double g, double gradient, double speed,
                            double *flow, double *force)
{
    const struct pool_options o = {.size = {4.0, 16.0, 4.0},
                                   .cells = {4, 16, 4},
                                   .walls = {0, 1, 0},
                                   .rho = 1.0,
                                   .mu = 1.0,
                                   .gradient = {-gradient, 0.0, 0.0},
                                   .time = "euler",
                                   .dt = 1.0};
    const struct body_shape wall = body_shape_box((double[3]){20.0, 4.0, 20.0});
    struct pool p;

    pool_create(&p, &o);
    solid_bodies_add(p.bodies, &wall, (double[3]){2.0, g + 2.0, 2.0}, 1.0,
                     speed > 0.0 ? BODY_PRESCRIBED : BODY_FIXED);
    p.bodies->ps->vx[0] = speed;
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    pool_run(&p, 60);
    *flow = 0.0;
    for (int c = 0; c < p.mesh->n_cells; c++)
        if (p.mesh->centre[3 * c + 1] < g + 1.0)
            *flow += 12.0 / (g * g * g) * p.fluid->u[3 * c] / 16.0;
    *force = g * 2.0 * p.fluid->u[0];
    ck_assert_double_le(p.fluid->report.momentum_residual, 1e-9);
    pool_free(&p);
}

/* With less than a cell at most a ninth of the exact flow, where an open gap
 * would have three times of it and more, as one of a cell has: 1 + 2/g^2. What
 * slides has the exact force in both. */
FACT_FOR_EACH(ew18_4_a_gap_of_less_than_a_cell_is_closed_and_slides_as_before,
              7)
{
    const double gap[] = {0.55, 0.7, 0.95, 1.0, 1.05, 1.5, 2.0}, g = gap[_i];
    double flow, force, other;

    wall_over_floor(g, 1.0, 0.0, &flow, &other);
    wall_over_floor(g, 0.0, 1.0, &other, &force);
    ck_assert_double_gt(flow, g < 1.0 ? 0.0 : 1.0);
    ck_assert_double_lt(flow, g < 1.0 ? 1.0 / 9.0 : 3.1);
    ck_assert_double_eq_tol(force, 1.0, 1e-3); /* 1/C */
}

/* 0.7 cells over the floor or over another body, with and without the centre of
 * a cell in between: fixed ones and those that move
 * along close the gap, one that is free or comes down must press the fluid out
 * of it. Both are told. */
FACT_FOR_EACH(a_gap_that_may_change_stays_open_and_is_told, 48)
{
    const struct {
        enum body_motion motion;
        double v[3];
        int closes;
    } how[] = {{BODY_FIXED, {0.0, 0.0, 0.0}, 1},
               {BODY_PRESCRIBED, {1.0, 0.0, 0.0}, 1},
               {BODY_PRESCRIBED, {0.0, -1.0, 0.0}, 0},
               {BODY_FREE, {0.0, 0.0, 0.0}, 0}};
    const struct pool_options o = {.size = {16.0, 24.0, 16.0},
                                   .cells = {16, 24, 16},
                                   .walls = {1, 1, 1},
                                   .rho = 1.0,
                                   .mu = 1.0,
                                   .dt = 0.01,
                                   .n = 2};
    const int kind = _i / 12, by = _i / 3 % 4, two = _i % 3;
    const struct body_ball ball[2] = {{{-1.0, 0.0, 0.0}, 3.0},
                                      {{1.0, 0.0, 0.0}, 3.0}};
    const struct body_shape box = body_shape_box((double[3]){6.0, 6.0, 6.0}),
                            of[] = {body_shape_sphere(6.0), box,
                                    body_shape_cylinder(
                                        6.0, 6.0, (double[3]){1.0, 0.0, 0.0}),
                                    body_shape_outline(clump_create(2, ball))};
    struct pool p;

    pool_create(&p, &o);
    solid_bodies_add(p.bodies, &of[kind],
                     (double[3]){8.0, two > 0 ? 13.3 - 0.1 * two : 3.7, 8.0},
                     2.0, how[by].motion);
    p.bodies->ps->vx[0] = how[by].v[0], p.bodies->ps->vy[0] = how[by].v[1];
    if (two)
        solid_bodies_add(p.bodies, &box, (double[3]){8.0, 6.6 - 0.1 * two, 8.0},
                         2.0, BODY_FIXED);
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    const int closes = how[by].closes && (two == 0 || by == 0);
    const struct body_seal_gap *const g =
        closes ? &p.bodies->seal.closed : &p.bodies->seal.open;
    ck_assert_int_eq(p.bodies->seal.closed.beside > 0, closes);
    ck_assert_int_eq(p.bodies->seal.open.beside > 0, !closes);
    ck_assert_int_eq(g->beside + g->across, two ? 3 : 1);
    ck_assert_double_ge(g->width, 0.7 - 1e-9);
    ck_assert_double_lt(g->width, 1.0);
    if (kind != 3) body_outline_free(of[3].outline);
    pool_free(&p);
}

/* A wall of 1 m by 1 m that moves across a closed box of the same size pushes
 * the fluid into a part without a way out; one that leaves two cells free or
 * that stands still does not, nor one that has the box to itself and turns. */
FACT_FOR_EACH(a_piston_that_fits_its_closed_box_is_told, 5)
{
    const struct pool_options o = {.size = {1.6, 1.0, 1.0},
                                   .cells = {16, 10, 10},
                                   .walls = {1, 1, 1},
                                   .rho = 1.0,
                                   .mu = 0.01,
                                   .dt = 0.02};
    const struct {
        double side, v, w;
        int told;
    } piston[] = {{1.0, 0.3, 0.0, 1},
                  {0.97, 0.3, 0.0, 1},
                  {0.6, 0.3, 0.0, 0},
                  {1.0, 0.0, 0.0, 0},
                  {0.4, 0.3, 5.0, 0}};
    const double side = piston[_i].side;
    const struct body_shape box = body_shape_box((double[3]){0.4, side, side});
    struct pool p;

    pool_create(&p, &o);
    solid_bodies_add(p.bodies, &box, (double[3]){0.73, 0.5, 0.5}, 1.0,
                     BODY_PRESCRIBED);
    p.bodies->ps->vx[0] = piston[_i].v;
    p.bodies->ps->wx[0] = piston[_i].w;
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    ck_assert_int_eq(p.bodies->seal.pushes, piston[_i].told);
    pool_free(&p);
}

/* A pocket of fluid in a hollow ball that moves and turns is pushed by all of
 * its shell, and has its way with it. */
FACT(a_pocket_that_moves_with_its_body_needs_no_outlet)
{
    enum { N = 200 };
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {16, 16, 16},
                                   .walls = {1, 1, 1},
                                   .rho = 1.0,
                                   .mu = 0.01,
                                   .dt = 0.02};
    struct body_ball ball[N];
    struct pool p;

    for (int k = 0; k < N; k++) { /* a spiral from pole to pole */
        const double z = 1.0 - (2.0 * k + 1.0) / N, turn = 2.4 * k,
                     r = sqrt(1.0 - z * z);
        ball[k] = (struct body_ball){
            {0.3 * r * cos(turn), 0.3 * r * sin(turn), 0.3 * z}, 0.09};
    }
    const struct body_shape shell = body_shape_outline(clump_create(N, ball));
    pool_create(&p, &o);
    solid_bodies_add(p.bodies, &shell, (double[3]){0.48, 0.5, 0.51}, 1.0,
                     BODY_PRESCRIBED);
    p.bodies->ps->vx[0] = 0.3, p.bodies->ps->wy[0] = 1.0;
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    ck_assert_int_eq(p.bodies->seal.pushes, 0);
    ck_assert_double_lt(body_shape_distance(&shell, (double[3]){0.3}), -0.05);
    ck_assert_double_gt(body_shape_distance(&shell, (double[3]){0.0}), 0.2);
    pool_free(&p);
}

/* Two fixed spheres that lie in each other: their springs give them no more
 * than what rounding leaves of 1/1e60 kg. They displace nothing, and theirs is
 * not an overlap that a step could have avoided. */
FACT(fixed_bodies_in_each_other_displace_nothing)
{
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {16, 16, 16},
                                   .walls = {1, 1, 1},
                                   .rho = 1.0,
                                   .mu = 0.01,
                                   .dt = 0.02,
                                   .n = 3};
    const struct body_shape sphere = body_shape_sphere(0.3);
    struct pool p;

    pool_create(&p, &o);
    for (int i = 0; i < 3; i++)
        solid_bodies_add(p.bodies, &sphere,
                         (double[3]){0.4 + 0.05 * i, i == 2 ? 0.2 : 0.7, 0.5},
                         2.0, i == 2 ? BODY_FREE : BODY_FIXED);
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    pool_run(&p, 3);
    ck_assert_double_eq(p.bodies->deepest, 0.0);
    pool_free(&p);
}

/* A step on the floor that is `deep` m of a block, of which the rest is beyond
 * the wall, and a sphere that is free or moves on as it does. */
static void step_at_wall(struct pool *p, double deep, enum body_motion motion)
{
    const struct pool_options o = {.size = {1.0, 1.0, 0.5},
                                   .cells = {20, 20, 10},
                                   .walls = {0, 1, 0},
                                   .rho = 1.0,
                                   .mu = 0.05,
                                   .dt = 0.01,
                                   .gradient = {-1.0, 0.0, 0.0},
                                   .n = 2};
    const double size[3] = {0.4, deep, 0.5};
    const struct body_shape sphere = body_shape_sphere(0.2),
                            block = body_shape_box(size);

    pool_create(p, &o);
    solid_bodies_add(p->bodies, &block,
                     (double[3]){0.5, 0.2 - 0.5 * deep, 0.25}, 1.0, BODY_FIXED);
    solid_bodies_add(p->bodies, &sphere, (double[3]){0.3, 0.7, 0.25}, 2.0,
                     motion);
    p->bodies->ps->vx[1] = 0.1;
    ck_assert_int_eq(solid_bodies_begin(p->bodies, p->fluid), 0);
    pool_run(p, 5);
    ck_assert_int_eq(p->bodies->dem_report.lost, 0);
}

/* The centre of a fixed body may be beyond a wall. */
FACT_FOR_EACH(a_body_half_outside_is_one_that_ends_at_the_wall, 2)
{
    const enum body_motion motion = _i == 0 ? BODY_FREE : BODY_PRESCRIBED;
    struct pool half, whole;

    step_at_wall(&half, 0.6, motion);
    step_at_wall(&whole, 0.2, motion);
    ck_assert_double_gt(whole.bodies->force[0], 0.01);
    for (int e = 0; e < 6; e++) /* but for what the solver leaves */
        ck_assert_double_eq_tol(half.bodies->force[e], whole.bodies->force[e],
                                1e-8 * whole.bodies->force[0]);
    ck_assert_double_eq_tol(half.bodies->ps->vx[1], whole.bodies->ps->vx[1],
                            1e-8);
    pool_free(&half);
    pool_free(&whole);
}

/* A rod turns beside an outlet until an end of it is outside, while its weight
 * draws it in: it is moved by what acts on it, and does not stay there. */
FACT(ew18_2_a_body_that_only_turns_out_of_an_outlet_comes_back)
{
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {12, 12, 12},
                                   .walls = {1, 1, 1},
                                   .rho = 1.0,
                                   .mu = 0.02,
                                   .dt = 0.02,
                                   .inlet = 1e-6,
                                   .virtual_mass = 2.0,
                                   .dem_steps = 5};
    const struct body_ball ball[2] = {{{-0.2, 0.0, 0.0}, 0.15},
                                      {{0.2, 0.0, 0.0}, 0.15}};
    const struct body_shape rod = body_shape_outline(clump_create(2, ball));
    struct pool p;
    double highest = 0.0;

    pool_create(&p, &o);
    p.bodies->options.gravity[1] = -1.0;
    p.bodies->contacts.material =
        (struct material){.stiffness = 300.0, .restitution = 0.9};
    solid_bodies_add(p.bodies, &rod, (double[3]){0.5, 0.82, 0.5}, 3.0,
                     BODY_FREE);
    p.bodies->ps->wz[0] = 6.0;
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    for (int i = 0; i < 50; i++) {
        double extent[3];
        pool_run(&p, 1);
        body_shape_extent(&p.bodies->shape[0], extent);
        highest = fmax(highest, p.bodies->ps->y[0] + extent[1]);
    }
    ck_assert_double_gt(highest, 1.02);
    ck_assert_double_lt(p.bodies->ps->vy[0], -0.1);
    pool_free(&p);
}
