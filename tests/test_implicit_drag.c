/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/energy.h"
#include "dem/integrator.h"
#include "dem/surfaces/prescribed_particles.h"
#include "facts.h"
#include "spheres.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>

static const double R = 0.005, push = 2e-3; /* [m], [N] */

/* A sphere in the middle of a large box, pushed along x, with a drag rate of
 * r dt = x in each of its steps and an added mass of so many of its own. */
static struct particles *held_back(double x, double added, double dt)
{
    struct particles *const ps = particles_create(1);

    spheres_add(ps, 0.0, 0.0, 0.0, 2.0 * R);
    spheres_throw(ps, 0, -0.3, 0.2, 0.0);
    particles_add_implicit_drag(ps);
    ps->added_mass[0] = added * ps->m[0];
    ps->drag_coefficient[0] = x * (ps->m[0] + ps->added_mass[0]) / dt;
    ps->ex[0] = push;
    return ps;
}

/* v(t) = v_end + (v_0 - v_end) exp(-k t/(m + m_a)), v_end = F/k, to rounding,
 * however long the step is; in two runs, so that half steps meet; and (m + m_a)
 * times the change of v is the impulse of F and the drag. */
FACT_FOR_EACH(an_added_mass_and_a_drag_are_solved_exactly, 18)
{
    static const double rate[] = {0.0, 1e-9, 0.01, 1.0, 30.0, 1e5};
    static const double added[] = {0.0, 0.5, 10.0};
    const double x = rate[_i % 6], more = added[_i / 6], dt = 1e-4;
    struct particles *const ps = held_back(x, more, dt);
    const double m = ps->m[0] * (1.0 + more), k = ps->drag_coefficient[0],
                 n = 7.0;
    const double decay = exp(-n * x),
                 share = n * dt * implicit_drag_gain(n * x);
    struct dem_options o = spheres_options(&contact_linear, dt, 1.0);
    struct dem_report r;

    struct dem *const dem = dem_create(ps, &o);
    ck_assert_int_eq(dem_run(dem, 3, &r), 0);
    ck_assert_int_eq(dem_run(dem, 4, &r), 0);
    ck_assert_double_eq_tol(ps->vx[0], -0.3 * decay + push / m * share, 1e-14);
    ck_assert_double_eq_tol(ps->vy[0], 0.2 * decay, 1e-15);
    ck_assert_double_eq_tol(push * n * dt + ps->drag_impulse[0],
                            m * (ps->vx[0] + 0.3), 1e-13 * m);
    if (x >= 30.0) ck_assert_double_eq_tol(ps->vx[0], push / k, 1e-14);
    dem_free(dem);
    particles_free(ps);
}

/* A prescribed particle has its prescribed velocity, and the reaction on the
 * fluid is that of the drag alone: -k v dt a step. */
FACT(a_prescribed_particle_acts_on_the_fluid_by_drag_alone)
{
    const struct prescribed_particle one = {
        .id = 0, .motion = {.velocity = {0.1, 0.0, -0.4}}};
    const double dt = 1e-4, x = 0.3;
    struct particles *const ps = held_back(x, 0.5, dt);
    const double k = ps->drag_coefficient[0], n = 7.0;
    struct dem_options o = spheres_options(&contact_linear, dt, 1.0);
    struct dem_report r;

    o.prescribed = &one;
    o.n_prescribed = 1;
    struct dem *const dem = dem_create(ps, &o);
    dem_clock(dem, 0);
    ck_assert_int_eq(dem_run(dem, 3, &r), 0);
    ck_assert_int_eq(dem_run(dem, 4, &r), 0);
    ck_assert_double_eq_tol(ps->vx[0], 0.1, 1e-12);
    ck_assert_double_eq_tol(ps->drag_impulse[0], -k * 0.1 * n * dt, 1e-15);
    ck_assert_double_eq_tol(ps->drag_impulse[1], 0.0, 1e-15);
    ck_assert_double_eq_tol(ps->drag_impulse[2], k * 0.4 * n * dt, 1e-15);
    dem_free(dem);
    particles_free(ps);
}

/* A sphere without drag and added mass moves as with rows_advance, with spin,
 * wall and friction. Tolerance: a rounding a step, doubled by each of two
 * bounces. */
FACT(implicit_drag_of_zero_changes_nothing)
{
    double end[2][4];

    for (int i = 0; i < 2; i++) {
        struct particles *const ps = particles_create(1);
        struct dem_options o = spheres_options(&contact_linear, 1e-5, 0.01);
        struct dem_report r;
        o.material.friction = 0.3;
        spheres_add(ps, 0.0, -0.004, 0.0, 2.0 * R);
        spheres_throw(ps, 0, 0.2, -0.4, 0.1);
        if (i == 1) particles_add_implicit_drag(ps);
        struct dem *const dem = dem_create(ps, &o);
        ck_assert_int_eq(dem_run(dem, 3000, &r), 0);
        end[i][0] = ps->x[0];
        end[i][1] = ps->y[0];
        end[i][2] = ps->vy[0];
        end[i][3] = R * ps->wz[0];
        dem_free(dem);
        particles_free(ps);
    }
    for (int k = 0; k < 4; k++)
        ck_assert_double_eq_tol(end[1][k], end[0][k], 1e-11);
}

/* Pressed on the floor in honey, r dt = 50: it sinks in until F = k delta,
 * without overshoot. */
FACT(a_sphere_in_honey_creeps_to_its_balance)
{
    const double dt = 1e-4;
    struct particles *const ps = held_back(50.0, 0.0, dt);
    struct dem_options o = spheres_options(&contact_linear, dt, 0.02);
    struct dem_report r;
    double least = 1.0;

    ps->x[0] = -0.02 + R;
    ps->ex[0] = -push;
    ps->vx[0] = ps->vy[0] = 0.0;
    struct dem *const dem = dem_create(ps, &o);
    const double balance = push / o.material.stiffness;
    for (int n = 0; n < 200; n++) {
        ck_assert_int_eq(dem_run(dem, 100, &r), 0);
        least = fmin(least, ps->x[0]);
    }
    ck_assert_double_eq_tol((-0.02 + R - ps->x[0]) / balance, 1.0, 1e-6);
    ck_assert_double_ge(least, -0.02 + R - balance * (1.0 + 1e-9));
    dem_free(dem);
    particles_free(ps);
}

/* The added mass is part of the kinetic energy, (m + m_a) v^2 / 2, which equals
 * the work of force and drag: that of the force to rounding, the drag to the
 * square of its rate, 1e-4 of the energy; without m_a three quarters of it
 * would be missing. */
FACT_FOR_EACH(the_added_mass_is_part_of_the_energy, 2)
{
    const double dt = 1e-4;
    struct particles *const ps = held_back(_i ? 0.01 : 0.0, 3.0, dt);
    const double m = 4.0 * ps->m[0], brought = 0.5 * m * 0.13;
    struct dem_options o = spheres_options(&contact_linear, dt, 1.0);
    struct dem_report r;

    struct dem *const dem = dem_create(ps, &o);
    dem_start_energy_budget(dem);
    ck_assert_int_eq(dem_run(dem, 100, &r), 0);
    const struct energy *const e = dem_energy(dem);
    const double v2 = gsl_pow_2(ps->vx[0]) + gsl_pow_2(ps->vy[0]);
    ck_assert_double_eq_tol(e->kinetic / (0.5 * m * v2), 1.0, 1e-12);
    ck_assert_double_eq_tol(e->added / brought, 1.0, 1e-12);
    ck_assert_double_eq_tol(energy_residual(e) / e->kinetic, 0.0,
                            _i ? 1e-3 : 1e-12);
    dem_free(dem);
    particles_free(ps);
}

FACT(the_gain_is_one_at_rest_and_falls_like_one_over_x)
{
    ck_assert_double_eq(implicit_drag_gain(0.0), 1.0);
    ck_assert_double_eq_tol(implicit_drag_gain(1e-12), 1.0 - 5e-13, 1e-15);
    ck_assert_double_eq_tol(implicit_drag_gain(1.0), 1.0 - exp(-1.0), 1e-15);
    ck_assert_double_eq(implicit_drag_gain(1e6), 1e-6);
}
