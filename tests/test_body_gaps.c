/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gaps of about a cell and less: what the mesh and the film do together. */
#include "brenner.h"
#include "resolved.h"

#include "facts.h"
#include "resolved/squeeze_film.h"

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

enum { N = 8 }; /* cells in the diameter, 1 m */

/* One sphere above a floor, or two, with z/h between: the force of fluid and
 * film over the exact one. The fluid is at rest but for them, and inertia is
 * none. */
static double force_over_exact(double z_over_h, int of_two)
{
    static const double R = 0.5, h = 1.0 / N, U = 1e-6, mu = 1.0;
    const struct pool_options o = {
        .size = {of_two ? 4.0 : 3.0, 3.0, 3.0},
        .cells = {(of_two ? 4 : 3) * N, 3 * N, 3 * N},
        .walls = {0, !of_two, 0},
        .rho = 1.0,
        .mu = mu,
        .dt = h * h,
        .virtual_mass = 2.0,
        .tolerance = 1e-6,
        .n = 2};
    const struct body_shape sphere = body_shape_sphere(2.0 * R);
    const double z = z_over_h * h, x = 2.0 + 0.25 * h;
    struct pool p;

    pool_create(&p, &o);
    for (int i = 0; i < 1 + of_two; i++) {
        const double sign = i == 0 ? -1.0 : 1.0;
        const double two[3] = {x + sign * (R + 0.5 * z), 1.51, 1.5},
                     one[3] = {1.53, R + z, 1.5};
        solid_bodies_add(p.bodies, &sphere, of_two ? two : one, 1.0,
                         BODY_PRESCRIBED);
        p.bodies->ps->vx[i] = of_two ? -sign * U : 0.0;
        p.bodies->ps->vy[i] = of_two ? 0.0 : -U;
    }
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    pool_run(&p, 25);
    const double *const F = p.bodies->force;
    const double of_mesh = of_two ? -F[0] : F[1], speed = of_two ? 2.0 * U : U;
    const double film =
        speed * squeeze_film_coefficient(mu, of_two ? 0.5 * R : R, z, 1e-3 * R,
                                         squeeze_film_cells * h);
    pool_free(&p);
    return (of_mesh + film) /
           (6.0 * M_PI * mu * R * U * brenner_force(z / R, of_two));
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

FACTS("body_gaps")
{
    FACT(brenner61_the_exact_force_has_its_limits);
    FACT_FOR_EACH(cox67_mesh_and_film_have_the_force_of_a_sphere_at_a_wall, 4);
    FACT_FOR_EACH(cox67_mesh_and_film_have_the_force_of_two_spheres, 2);
}
