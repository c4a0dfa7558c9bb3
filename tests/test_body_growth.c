/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The force of the fluid comes a step late: what keeps the velocity of a body
 * from growing with the other sign in each step, without a virtual mass that is
 * asked for. */
#include "resolved.h"

#include "facts.h"
#include "resolved/body_numbers.h"
#include "resolved/shapes/shapes.h"

/* Exact added masses of a sphere, and across a disc that is thin: 8/3 rho R^3
 * [Lamb32], which is 0.85 R/t of the volume. One estimate for all shapes is
 * not less, and less than half as much again. */
FACT(ew18_2_an_estimate_of_the_added_mass_is_on_the_safe_side)
{
    const double R = 0.5, t = 0.05, V = M_PI * R * R * t;
    const double disc = 8.0 / 3.0 * R * R * R / V;

    ck_assert_double_eq_tol(body_numbers_added_mass(M_PI / 6.0 * 8.0, 2.0), 0.5,
                            1e-15);
    ck_assert_double_gt(body_numbers_added_mass(V, t), disc);
    ck_assert_double_lt(body_numbers_added_mass(V, t), 1.5 * disc);
}

static struct body_shape block(const struct body_shape *shape)
{
    return body_shape_outline(
        block_outline_create(shape, (double[3]){0.0, 0.0, 0.0}));
}

static const double kick = 0.1; /* [m/s] */

enum { THIN_FLUID, THICK_FLUID, PLATE, TWO_PLATES, CLUMP, SCENES };

/* Bodies of 4 cells and more, as heavy as the fluid or up to three times. */
static void fill(struct pool *p, int scene)
{
    const struct body_shape sphere = body_shape_sphere(0.4),
                            box = body_shape_box((double[3]){0.5, 0.21, 0.5});
    const struct body_ball ball[2] = {{{-0.15, 0.0, 0.0}, 0.15},
                                      {{0.15, 0.0, 0.0}, 0.15}};

    for (int i = 0; i <= (scene == TWO_PLATES); i++) {
        const struct body_shape shape =
            scene == PLATE || scene == TWO_PLATES ? block(&box)
            : scene == CLUMP ? body_shape_outline(clump_create(2, ball))
                             : sphere;
        const double side = i == 0 ? -1.0 : 1.0,
                     y = scene == TWO_PLATES ? 0.5 + 0.14 * side : 0.5;
        solid_bodies_add(p->bodies, &shape, (double[3]){0.5, y, 0.5},
                         scene == TWO_PLATES ? 3.0 : 1.0, BODY_FREE);
        p->bodies->ps->vy[i] = kick * side;
        p->bodies->ps->wz[i] = scene == PLATE || scene == CLUMP ? 1.0 : 0.0;
    }
}

/* What is left of a kick changes slowly after 30 steps. With the other sign in
 * each step it would be in the second difference, which is 4 times as large as
 * it; where a clump turns into other cells that is up to 0.02 of the kick. */
FACT_FOR_EACH(ew18_2_no_body_swings_from_step_to_step, SCENES)
{
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {14, 14, 14},
                                   .walls = {1, 1, 1},
                                   .rho = 1.0,
                                   .mu = _i == THICK_FLUID ? 1.0 : 1e-4,
                                   .dt = 0.02,
                                   .n = 2,
                                   .tolerance = 1e-6,
                                   .piso_tolerance = 1e-5};
    double v[4];
    struct pool p;

    pool_create(&p, &o);
    fill(&p, _i);
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    pool_run(&p, 30);
    for (int i = 0; i < 4; i++) {
        pool_run(&p, 1);
        v[i] = p.bodies->ps->vy[0];
    }
    ck_assert_double_lt(fabs(v[2] - 2.0 * v[1] + v[0]), 0.03 * kick);
    ck_assert_double_lt(fabs(v[3] - 2.0 * v[2] + v[1]), 0.03 * kick);
    pool_free(&p);
}

/* What turns with the sphere are the cells inside. Were the share of viscosity
 * in those around it taken for more of them, the sphere, which is a tenth of
 * that, would turn at 200 rad/s and the other way after as long as this. */
FACT(ew18_3_a_light_sphere_in_a_thick_fluid_does_not_spin_up)
{
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {12, 12, 12},
                                   .rho = 1.0,
                                   .mu = 1.0,
                                   .dt = 0.01,
                                   .time = "euler",
                                   .n = 1};
    const struct body_shape sphere = body_shape_sphere(0.4);
    struct pool p;

    pool_create(&p, &o);
    solid_bodies_add(p.bodies, &sphere, (double[3]){0.5, 0.5, 0.5}, 0.1,
                     BODY_FREE);
    p.bodies->ps->wz[0] = 2.0;
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    pool_run(&p, 60);
    ck_assert_double_lt(fabs(p.bodies->ps->wz[0]), 0.02);
    pool_free(&p);
}

/* A sphere in the middle of a closed one of the radius R_2, whose velocity
 * potential is that of a dipole in a uniform flow, has the added mass (R_2^3 +
 * 2 R^3)/(R_2^3 - R^3) times 1/2 [Lamb32]. */
FACT(lamb32_neighbours_multiply_the_added_mass)
{
    const double R = 0.3, R_2 = 0.4, phi = pow(R / R_2, 3.0);
    /* u_r = -U cos(theta) (a + b/r^3) is U cos(theta) at R, 0 at R_2 */
    const double a = 1.0 / (pow(R_2 / R, 3.0) - 1.0), b = -a * pow(R_2, 3.0);
    const double potential = a * R - 0.5 * b / (R * R); /* over U cos(theta) */

    ck_assert_double_eq_tol(-(a + b / pow(R, 3.0)), 1.0, 1e-14);
    ck_assert_double_eq_tol(0.5 * body_numbers_crowding(phi), potential / R,
                            1e-14);
    ck_assert_double_eq(body_numbers_crowding(0.0), 1.0);
}

/* 32 spheres in a periodic cube, face-centred, a seventh of the diameter apart,
 * of a twentieth of the fluid's density, every other one the other way. By the
 * bound for two bodies C_v would be 1.6, and after forty steps they would be
 * seven times as fast as at first. */
FACT(ew18_2_a_crowd_of_light_spheres_loses_its_agitation)
{
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {18, 18, 18},
                                   .rho = 1.0,
                                   .mu = 1e-3,
                                   .dt = 0.02,
                                   .n = 32,
                                   .tolerance = 1e-5,
                                   .piso_tolerance = 1e-3};
    const struct body_shape sphere = body_shape_sphere(0.31);
    struct pool p;

    pool_create(&p, &o);
    for (int i = 0; i < 32; i++) {
        const double x[3] = {
            0.5 * (i / 4 % 2) + (i % 4 == 1 || i % 4 == 2 ? 0.25 : 0.0),
            0.5 * (i / 8 % 2) + (i % 4 == 1 || i % 4 == 3 ? 0.25 : 0.0),
            0.5 * (i / 16 % 2) + (i % 4 == 2 || i % 4 == 3 ? 0.25 : 0.0)};
        solid_bodies_add(p.bodies, &sphere, x, 0.05, BODY_FREE);
        p.bodies->ps->vx[i] = i * 7 % 4 < 2 ? -kick : kick;
        p.bodies->ps->vy[i] = i * 5 % 8 < 4 ? -kick : kick;
    }
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    pool_run(&p, 60);
    for (int i = 0; i < 32; i++) {
        ck_assert_double_lt(fabs(p.bodies->ps->vx[i]), 0.5 * kick);
        ck_assert_double_lt(fabs(p.bodies->ps->vy[i]), 0.5 * kick);
    }
    pool_free(&p);
}

/* Six cells, nu dt / h^2 = 3, and an impact of four steps. Beside the floor
 * viscosity takes more of a velocity than far from it; with what it takes there
 * the sphere would be thrown off again, at the hundredfold of the 0.08 m/s that
 * it came down with. */
FACT(ew18_2_a_sphere_comes_to_rest_on_a_floor_in_a_thick_fluid)
{
    const struct pool_options o = {.size = {2.0, 2.0, 2.0},
                                   .cells = {12, 12, 12},
                                   .walls = {1, 1, 1},
                                   .rho = 1.0,
                                   .mu = 0.5,
                                   .dt = 1.0 / 6.0,
                                   .virtual_mass = 2.0,
                                   .dem_steps = 8,
                                   .tolerance = 1e-7,
                                   .piso_tolerance = 1e-4};
    const struct body_shape sphere = body_shape_sphere(1.0);
    struct pool p;

    pool_create(&p, &o);
    p.bodies->options.gravity[1] = -10.0;
    p.bodies->contacts.material =
        (struct material){.stiffness = 20.0, .restitution = 0.97};
    p.bodies->lubrication = (struct squeeze_film){o.mu, 5e-4, 0.125};
    solid_bodies_add(p.bodies, &sphere, (double[3]){1.0, 0.6, 1.0}, 1.17,
                     BODY_FREE);
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    pool_run(&p, 110);
    for (int i = 0; i < 6; i++) {
        pool_run(&p, 1);
        ck_assert_double_lt(fabs(p.bodies->ps->vy[0]), 1e-3);
    }
    ck_assert_double_lt(p.bodies->ps->y[0], 0.5);
    pool_free(&p);
}
