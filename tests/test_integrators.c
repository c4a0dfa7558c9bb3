/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Each integrator has its order, on an oscillator with a closed form and on
 * contacts without one. */
#include <gsl/gsl_math.h>
#include <omp.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "dem/energy.h"
#include "dem/integrator.h"
#include "dem/surfaces/surface.h"
#include "facts.h"
#include "spheres.h"

static const char *const names[4] = {"velocity-verlet", "symplectic-euler",
                                     "heun", "adaptive-heun"};

/* Two spheres that overlap and are pushed apart, as long as they touch: with
 * law "linear" half of their distance is a damped oscillator,
 *
 *   x(t) = x_0 e^(-zeta w t) (cos(w_d t) + zeta w/w_d sin(w_d t)).
 *
 * The error of the overlap over its start after a fifth of a period. */
static double error_with(struct dem_options o, double e, int steps)
{
    struct particles *const ps = particles_create(2);
    const double overlap = 1e-4;
    struct dem_report r;

    o.material.restitution = e;
    spheres_add(ps, -0.005 + 0.5 * overlap, 0, 0, 0.01);
    spheres_add(ps, 0.005 - 0.5 * overlap, 0, 0, 0.01);
    const double w = sqrt(2.0 * o.material.stiffness / ps->m[0]);
    const double zeta = contact_damping_ratio(e);
    const double w_d = w * sqrt(1.0 - zeta * zeta), T = 1.2 / w;
    const double exact = overlap * exp(-zeta * w * T) *
                         (cos(w_d * T) + zeta * w / w_d * sin(w_d * T));
    o.step = T / steps;
    struct dem *const dem = dem_create(ps, &o);
    ck_assert_int_eq(dem_run(dem, steps, &r), 0);
    ck_assert_int_eq(r.contacts, 1);
    const double found =
        0.01 - fabs(ps->x[spheres_place(ps, 1)] - ps->x[spheres_place(ps, 0)]);
    dem_free(dem);
    particles_free(ps);
    return fabs(found - exact) / overlap;
}

static double error_of_oscillator(const char *integrator, double e, int steps)
{
    struct dem_options o = spheres_options(&contact_linear, 0.0, 0.1);

    o.integrator = integrator_named(integrator);
    return error_with(o, e, steps);
}

static struct dem_options adaptive_options(double step, double error,
                                           double half)
{
    struct dem_options o = spheres_options(&contact_linear, step, half);

    o.integrator = integrator_named("adaptive-heun");
    o.shortest_step = 5e-7;
    o.step_error = error;
    return o;
}

static double error_of_adaptive(double e, double error)
{
    struct dem_options o = adaptive_options(0.0, error, 0.1);

    o.shortest_step = 1e-8;
    return error_with(o, e, 1);
}

/* 2, 1, 2 without damping; the velocity of half a step before makes it 1, 1, 2
 * with. */
FACT_FOR_EACH(each_integrator_has_its_order, 6)
{
    static const double order[2][3] = {{2.0, 1.0, 2.0}, {1.0, 1.0, 2.0}};
    const int damped = _i / 3, which = _i % 3;
    const double e = damped ? 0.5 : 1.0;
    const double coarse = error_of_oscillator(names[which], e, 40);
    const double fine = error_of_oscillator(names[which], e, 80);

    ck_assert_double_eq_tol(log2(coarse / fine), order[damped][which], 0.1);
    ck_assert_double_lt(fine, order[damped][which] > 1.5 ? 1e-4 : 0.02);
}

/* An oblique impact with friction that never slides: springs, dashpots and
 * rotation together, up to the middle of the contact; against 64 times as many
 * steps. */
static double spin_after(const char *integrator, const struct contact_law *law,
                         double e, int steps)
{
    struct particles *const ps = particles_create(2);
    struct dem_options o = spheres_options(law, 2e-4 / steps, 0.1);
    struct dem_report r;

    o.integrator = integrator_named(integrator);
    o.material.restitution = e;
    o.material.friction = 1e3;
    spheres_throw(ps, spheres_add(ps, -0.0049, 0, 0, 0.01), 0.5, 0.3, 0.0);
    spheres_add(ps, 0.005, 0, 0, 0.012);
    struct dem *const dem = dem_create(ps, &o);
    ck_assert_int_eq(dem_run(dem, steps, &r), 0);
    ck_assert_int_eq(r.contacts, 1);
    const double w = ps->wz[spheres_place(ps, 0)];
    dem_free(dem);
    particles_free(ps);
    return w;
}

FACT_FOR_EACH(heun_is_of_second_order_with_springs_dashpots_and_spin, 2)
{
    const struct contact_law *const law = contact_laws[_i];
    const double exact = spin_after("heun", law, 0.7, 6400);
    const double coarse = fabs(spin_after("heun", law, 0.7, 50) - exact);
    const double fine = fabs(spin_after("heun", law, 0.7, 100) - exact);

    ck_assert_double_eq_tol(log2(coarse / fine), 2.0, 0.25);
    ck_assert_double_lt(fine, 2e-3 * fabs(exact));
}

FACT_FOR_EACH(the_integrators_agree_in_the_end, 2)
{
    const struct contact_law *const law = contact_laws[_i];
    const double exact = spin_after("heun", law, 0.7, 6400);

    for (int k = 0; k < 2; k++)
        ck_assert_double_eq_tol(spin_after(names[k], law, 0.7, 6400) / exact,
                                1.0, 2e-3);
}

/* A sphere that hangs between two others, which it touches always, for 200
 * periods of 25 steps: Verlet and Euler keep the energy for ever, Heun gains
 * (w dt)^4 / 4 of it a step. */
static double energy_after(const char *integrator, int steps)
{
    struct particles *const ps = particles_create(1);
    struct dem_options o = spheres_options(&contact_linear, 0.0, 0.1);
    struct dem_report r;

    o.integrator = integrator_named(integrator);
    o.lo[0] = -0.0049;
    o.hi[0] = 0.0049;
    spheres_throw(ps, spheres_add(ps, 0, 0, 0, 0.01), 0.01, 0, 0);
    const double w = sqrt(2.0 * o.material.stiffness / ps->m[0]);
    o.step = 2.0 * M_PI / w / 25.0;
    struct dem *const dem = dem_create(ps, &o);
    dem_start_energy_budget(dem);
    ck_assert_int_eq(dem_run(dem, steps, &r), 0);
    const struct energy e = *dem_energy(dem);
    dem_free(dem);
    const double rest = 2.0 * 0.5 * 1e4 * 1e-8; /* both walls, in the middle */
    const double gained =
        (e.kinetic + e.normal - rest) / (0.5 * ps->m[0] * 1e-4);
    particles_free(ps);
    return gained;
}

FACT(verlet_and_euler_keep_energy_and_heun_gains_it)
{
    const double w_dt = 2.0 * M_PI / 25.0;
    const double exact = pow(1.0 + 0.25 * gsl_pow_4(w_dt), 5000.0);

    ck_assert_double_eq_tol(energy_after(names[0], 5000), 1.0, 0.02);
    ck_assert_double_eq_tol(energy_after(names[1], 5000), 1.0, 0.3);
    ck_assert_double_eq_tol(energy_after(names[2], 5000) / exact, 1.0, 0.01);
}

/* --- the rest ------------------------------------------------------------- */

/* 1000 spheres in a box that is periodic in one direction; and the same by 2
 * threads, and in pieces. */
static struct particles *moved(const char *integrator, int pieces)
{
    struct particles *const ps = spheres_cloud(13, 0.004, 0.5, 0.0062, 1.0, 8);
    struct dem_options o = spheres_options(&contact_hertz, 5e-6, 0.0405);
    struct dem_report r;

    o.integrator = integrator != NULL ? integrator_named(integrator) : NULL;
    o.shortest_step = 2e-6;
    o.step_error = 1e-4;
    o.material.friction = 0.3;
    o.material.restitution = 0.8;
    o.periodic[2] = 1;
    struct dem *const dem = dem_create(ps, &o);
    for (int k = 0; k < pieces; k++)
        ck_assert_int_eq(dem_run(dem, 240 / pieces, &r), 0);
    ck_assert_int_gt(r.contacts, 50);
    dem_free(dem);
    return ps;
}

FACT_FOR_EACH(no_integrator_depends_on_the_number_of_threads, 4)
{
    omp_set_num_threads(1);
    struct particles *const one = moved(names[_i], 1);
    omp_set_num_threads(2);
    struct particles *const two = moved(names[_i], 1);
    const size_t size = (size_t)one->n * sizeof(double);

    ck_assert_mem_eq(one->x, two->x, size);
    ck_assert_mem_eq(one->wz, two->wz, size);
    particles_free(one);
    particles_free(two);
}

FACT(velocity_verlet_is_the_default_to_the_bit)
{
    struct particles *const named = moved("velocity-verlet", 1);
    struct particles *const none = moved(NULL, 1);

    ck_assert_mem_eq(named->x, none->x, (size_t)none->n * sizeof(double));
    particles_free(named);
    particles_free(none);
}

/* A run in pieces is the same run: each begins where the last one ended. */
FACT_FOR_EACH(a_run_in_pieces_is_one_run, 4)
{
    struct particles *const whole = moved(names[_i], 1);
    struct particles *const pieces = moved(names[_i], 8);
    double worst = 0.0;

    for (int id = 0; id < whole->n; id++)
        worst = fmax(worst, fabs(whole->vx[spheres_place(whole, id)] -
                                 pieces->vx[spheres_place(pieces, id)]));
    ck_assert_double_lt(worst, 1e-9);
    particles_free(whole);
    particles_free(pieces);
}

FACT(energy_closes_by_heun_to_second_order)
{
    double share[2];

    for (int k = 0; k < 2; k++) {
        struct particles *const ps = particles_create(2);
        struct dem_options o =
            spheres_options(&contact_hertz, k == 0 ? 4e-6 : 2e-6, 0.1);
        struct dem_report r;
        o.integrator = integrator_named("heun");
        o.material.restitution = 0.7;
        o.material.friction = 1e3;
        spheres_throw(ps, spheres_add(ps, -0.0049, 0, 0, 0.01), 0.5, 0.3, 0.0);
        ps->ex[0] = 10.0 * ps->m[0];
        spheres_add(ps, 0.005, 0, 0, 0.012);
        struct dem *const dem = dem_create(ps, &o);
        dem_start_energy_budget(dem);
        ck_assert_int_eq(dem_run(dem, k == 0 ? 50 : 100, &r), 0);
        const struct energy *const e = dem_energy(dem);
        share[k] = fabs(energy_residual(e)) / e->added;
        ck_assert_double_gt(e->damped_n, 0.05 * e->added);
        dem_free(dem);
        particles_free(ps);
    }
    ck_assert_double_gt(log2(share[0] / share[1]), 1.8);
    ck_assert_double_lt(share[1], 1e-4);
}

/* --- steps that adapt ----------------------------------------------------- */

static const double g = 9.81; /* [m/s^2] */

/* One step of 1.2/w in parts: the error falls with that of a part, which is of
 * second order in its length, with damping and without. */
FACT_FOR_EACH(the_error_of_steps_that_adapt_falls_as_they_are_told, 2)
{
    const double e = _i ? 0.5 : 1.0;
    const double coarse = error_of_adaptive(e, 4e-4);
    const double fine = error_of_adaptive(e, 4e-4 / 64.0);

    ck_assert_double_eq_tol(log2(coarse / fine) / 6.0, 1.0, 0.1);
    ck_assert_double_lt(fine, 1e-4);
}

/* The height [m] of a sphere that falls from 1 m, after `end` [s]: parabolas
 * and damped oscillations, joined. */
static double exact_height(double end, double k, double eta, double m)
{
    double t = 0.0, y = 1.0, v = 0.0;

    for (;;) {
        const double fall = (v + sqrt(v * v + 2.0 * g * y)) / g;
        const double left = end - t;
        if (fall > left) return y + v * left - 0.5 * g * left * left;
        t += fall, v -= g * fall;
        /* m y'' = -k y - eta y' - m g until y = 0 again */
        const double a = 0.5 * eta / m, w = sqrt(k / m - a * a);
        const double A = m * g / k, B = (v + a * A) / w;
        double lo = 0.5 * M_PI / w, hi = 1.5 * M_PI / w;
        for (int q = 0; q < 100; q++) {
            const double s = 0.5 * (lo + hi);
            const double at =
                -A + exp(-a * s) * (A * cos(w * s) + B * sin(w * s));
            *(at < 0.0 ? &lo : &hi) = s;
        }
        v = exp(-a * lo) *
            ((w * B - a * A) * cos(w * lo) - (w * A + a * B) * sin(w * lo));
        t += lo, y = 0.0;
    }
}

/* Three rebounds with e = 0.9 in 2.9 s, each in 1 ms: 2191 parts of the steps
 * of 5 ms, where Verlet takes 58,000 steps of a twentieth of a contact. */
FACT(a_sphere_falls_in_long_steps_and_bounces_in_short_ones)
{
    struct particles *const ps = particles_create(1);
    struct dem_options o = adaptive_options(5e-3, 1e-4, 3.0);
    struct dem_report r;

    o.skin = 0.1;
    o.material.restitution = 0.9;
    spheres_add(ps, 0.0, -3.0 + 1.01, 0.0, 0.02);
    ps->ey[0] = -g * ps->m[0];
    const double zeta = contact_damping_ratio(0.9), m = ps->m[0];
    o.material.stiffness = m * M_PI * M_PI / 1e-6 / (1.0 - zeta * zeta);
    const double eta = 2.0 * zeta * sqrt(m * o.material.stiffness);
    struct dem *const dem = dem_create(ps, &o);
    ck_assert_int_eq(dem_run(dem, 580, &r), 0);
    const double exact = exact_height(2.9, o.material.stiffness, eta, m);
    ck_assert_double_eq_tol(ps->y[0] + 2.99, exact, 1e-4);
    ck_assert_int_lt((int)r.parts, 2500);
    dem_free(dem);
    particles_free(ps);
}

/* 25 diameters a step: against another sphere, a wall, and a sheet. */
FACT_FOR_EACH(no_step_that_adapts_passes_over_a_contact, 3)
{
    double corner[1][3][3] = {
        {{0.2, -0.5, -0.5}, {0.2, 0.5, -0.5}, {0.2, 0.0, 0.9}}};
    const struct surface sheet = {.name = "sheet",
                                  .shape = &surface_stl,
                                  .triangles = triangles_create(1, corner)};
    struct particles *const ps = particles_create(2);
    struct dem_options o = adaptive_options(5e-3, 1e-5, 0.5);
    struct dem_report r;
    double kinetic = 0.0;

    o.surfaces = &sheet;
    o.n_surfaces = _i == 2;
    o.material.stiffness = 1e6;
    spheres_throw(ps, spheres_add(ps, -0.3, 0.0, 0.0, 0.01), 50.0, 0.0, 0.0);
    const double start = 0.5 * ps->m[0] * 2500.0;
    if (_i == 0) spheres_add(ps, 0.1, 0.0, 0.0, 0.01);
    struct dem *const dem = dem_create(ps, &o);
    ck_assert_int_eq(dem_run(dem, _i ? 4 : 2, &r), 0);
    for (int i = 0; i < ps->n; i++)
        kinetic += 0.5 * ps->m[i] * ps->vx[i] * ps->vx[i];
    const int first = spheres_place(ps, 0);
    ck_assert_double_eq_tol(ps->vx[first], _i ? -50.0 : 0.0, 0.05);
    ck_assert_double_eq_tol(kinetic / start, 1.0, 1e-3);
    dem_free(dem);
    particles_free(ps);
    owner_free((struct triangles *)(uintptr_t)sheet.triangles);
}
