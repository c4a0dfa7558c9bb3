/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gaps of about a cell and less: what the mesh and the film do together; and
 * what virtual mass does where they close. */
#include "brenner.h"
#include "facts.h"
#include "narrow_gap.h"
#include "resolved/body_numbers.h"

/* Far from everything it is Stokes' force, at a small gap R/z, twice as much as
 * between two; in between his table, where the distance is cosh 1, 2, 3 R. */
START_TEST(brenner61_the_exact_force_has_its_limits)
{
    ck_assert_double_eq_tol(brenner_force(1e3, 0), 1.0, 2e-3);
    ck_assert_double_eq_tol(brenner_force(cosh(1.0) - 1.0, 0), 3.0361, 1e-4);
    ck_assert_double_eq_tol(brenner_force(cosh(2.0) - 1.0, 0), 1.4129, 1e-4);
    ck_assert_double_eq_tol(brenner_force(cosh(3.0) - 1.0, 0), 1.1252, 1e-4);
    ck_assert_double_eq_tol(brenner_force(1e-3, 0) / 1e3, 1.0, 4e-3);
    ck_assert_double_eq_tol(brenner_force(1e-3, 1) / 500.0, 1.0, 1e-2);
}
END_TEST

/* One sphere above a floor, or two, with z/h between: the force of mesh and
 * film over the exact one. */
static double force_over_exact(double z_over_h, int of_two)
{
    const double h = narrow_gap_h, z = z_over_h * h;
    const double of_mesh = narrow_gap_force(z, of_two, of_two ? 0.25 * h : 0.03,
                                            of_two ? 0.01 : 0.0);
    const double film = narrow_gap_film(z, of_two, squeeze_film_cells * h);

    return (of_mesh + film) / brenner_force(z / narrow_gap_R, of_two);
}

/* Gaps of 1, 1/2, 1/4, 1/8 of a cell. The mesh alone has 0.9, 0.7, 0.4 and 0.24
 * of the force. A film that began at two cells would make it 1.3 of it. */
START_TEST(cox67_mesh_and_film_have_the_force_of_a_sphere_at_a_wall)
{
    ck_assert_double_eq_tol(force_over_exact(exp2(-_i), 0), 1.0, 0.12);
}
END_TEST

/* Likewise, with the gap across the cells. */
START_TEST(cox67_mesh_and_film_have_the_force_of_two_spheres)
{
    ck_assert_double_eq_tol(force_over_exact(exp2(-2 * _i), 1), 1.0, 0.15);
}
END_TEST

/* Speed after an impact on a wall that lasts 8 steps, over that before it, of a
 * dry sphere without losses, 8 times as heavy as a thin fluid. */
static double rebound(double C_v)
{
    enum { N = 16 };
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {N, N, N},
                                   .walls = {0, 1, 0},
                                   .rho = 1.0,
                                   .mu = 1e-5,
                                   .dt = 0.005,
                                   .virtual_mass = C_v,
                                   .dem_steps = 8,
                                   .tolerance = 1e-6,
                                   .n = 1};
    const double d = 6.0 / N, V = M_PI / 6.0 * d * d * d, rho_r = 8.0,
                 t = 8.0 * o.dt, x[3] = {0.5, 0.55 * d, 0.5};
    const struct body_shape sphere = body_shape_sphere(d);
    double before = 0.0;
    struct pool p;

    pool_create(&p, &o);
    p.bodies->contacts.material = (struct material){
        .stiffness = (rho_r + C_v) * V * M_PI * M_PI / (t * t),
        .restitution = 1.0};
    const int i = solid_bodies_add(p.bodies, &sphere, x, rho_r, BODY_FREE);
    const struct particles *const ps = p.bodies->ps;
    ps->vy[i] = -d;
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    while (ps->vy[i] < 0.0 || ps->y[i] < 0.5 * d) {
        if (ps->y[i] > 0.5 * d) before = -ps->vy[i];
        pool_run(&p, 1);
    }
    const double after = ps->vy[i];
    pool_free(&p);
    return after / before;
}

/* With C_v = 1/2 nothing is gained, and the fluid takes 2 to 3 %. Measured with
 * 2 is 1.08 times as much, the bound of (24.15) is 1.13; without the delay it
 * would be 1. */
START_TEST(ew18_2_virtual_mass_adds_less_to_an_impact_than_its_bound)
{
    const double none = rebound(0.5), some = rebound(2.0) / none,
                 bound = body_numbers_impact_gain(8.0, 2.0, 8.0);

    ck_assert_double_eq(body_numbers_impact_gain(8.0, 0.5, 8.0), 1.0);
    ck_assert_double_eq_tol(none, 0.98, 0.02);
    ck_assert_double_eq_tol(bound, 1.125, 1e-3);
    ck_assert_double_gt(some, 0.5 * (1.0 + bound));
    ck_assert_double_lt(some, bound);
}
END_TEST

FACTS("body_gaps")
{
    FACT(brenner61_the_exact_force_has_its_limits);
    FACT_FOR_EACH(cox67_mesh_and_film_have_the_force_of_a_sphere_at_a_wall, 4);
    FACT_FOR_EACH(cox67_mesh_and_film_have_the_force_of_two_spheres, 2);
    FACT(ew18_2_virtual_mass_adds_less_to_an_impact_than_its_bound);
}
