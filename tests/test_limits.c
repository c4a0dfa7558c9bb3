/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The limits of the step, and the accuracy of the suggested one. */
#include <gsl/gsl_math.h>

#include "dem/contact.h"
#include "facts.h"
#include "spheres.h"

/* E 1.2e5 Pa, nu 0.33, rho 1000, d 1.2 mm [SX15 Table 1]; worked out apart. */
FACT(ls_5_11_rayleigh_time_of_the_mueller_bed)
{
    const double G = 1.2e5 / (2.0 * 1.33);
    ck_assert_double_eq_tol(
        limits_rayleigh(6e-4, 1000.0, G, 0.33) / 3.016274626753e-4, 1.0, 1e-12);
}

FACT(linear_contact_time_does_not_depend_on_the_speed)
{
    const struct contact_law *const law = contact_law_named("linear");
    const struct material m = {.stiffness = 1000.0, .restitution = 1.0};
    const double mass = 1000.0 * M_PI / 6.0 * 1e-9;
    const double t = limits_contact_time(law, &m, 1e-3, 1000.0, 1.0);

    ck_assert_double_eq_tol(t / (M_PI * sqrt(0.5 * mass / 1000.0)), 1.0, 1e-14);
    ck_assert_double_eq(t, limits_contact_time(law, &m, 1e-3, 1000.0, 0.1));
}

/* t_c goes as v^(-1/5), and very slow impacts are bounded by Rayleigh. */
FACT(hertz_step_grows_with_slowness_up_to_rayleigh)
{
    const struct contact_law *const law = contact_law_named("hertz");
    const struct material m = {
        .young = 1.2e5, .poisson = 0.33, .restitution = 0.9};
    const double fast = limits_contact_time(law, &m, 1.2e-3, 1000.0, 3.2);
    const double slow = limits_contact_time(law, &m, 1.2e-3, 1000.0, 0.1);
    ck_assert_double_eq_tol(slow / fast, 2.0, 1e-12);
    ck_assert_double_eq_tol(
        limits_step(law, &m, 1.2e-3, 1000.0, 1.0),
        limits_contact_time(law, &m, 1.2e-3, 1000.0, 1.0) / 25.0, 1e-18);
    ck_assert_double_eq_tol(limits_step(law, &m, 1.2e-3, 1000.0, 1e-6),
                            3.016274626753e-5, 1e-15);
}

/* The restitution with `part` of the suggested step, if the contact begins at
 * that phase of a step. */
static double rebound(const struct contact_law *law, double e, double part,
                      double phase)
{
    const double v = 0.7;
    struct dem_options o = spheres_options(law, 0.0, 1.0);
    struct particles *const ps = particles_create(2);

    o.material.restitution = e;
    o.step = part * limits_step(law, &o.material, 0.01, 2000.0, v);
    const double x = 0.005 + 0.5 * phase * v * o.step;
    spheres_throw(ps, spheres_add(ps, -x, 0.0, 0.0, 0.01), 0.5 * v, 0, 0);
    spheres_throw(ps, spheres_add(ps, x, 0.0, 0.0, 0.01), -0.5 * v, 0, 0);
    spheres_collide(ps, &o);
    const double kept = fabs(ps->vx[1] - ps->vx[0]) / v;
    particles_free(ps);
    return kept;
}

/* The error that contact.h states: the largest of twenty phases and of ten
 * steps, since it matters where within steps a contact begins and ends. Five
 * thirds of the step break it for either law. */
FACT_FOR_EACH(suggested_step_keeps_restitution, 20)
{
    const struct contact_law *const law = contact_laws[_i / 10];
    const double e = 0.1 * (_i % 10 + 1);
    const double stated = law == &contact_hertz ? 0.013
                          : e > 0.65            ? 0.021
                                                : 0.037;
    double worst = 0.0;

    for (int k = 0; k < 200; k++) {
        const double kept =
            rebound(law, e, 1.0 - 0.004 * (k % 10), 0.05 * (k / 10));
        worst = fmax(worst, fabs(kept - e));
    }
    ck_assert_double_le(worst, stated);
}

/* An infinite contact time must not give an infinite step: at e = 0 there is no
 * rebound within three undamped contact times; with 1/25 of the contact time at
 * e = 1e-6 the spheres would shoot apart. */
FACT(ls_4_11_suggested_step_resolves_critical_damping)
{
    for (int law = 0; law < 2; law++)
        for (int k = 0; k < 2; k++) {
            struct dem_options o = spheres_options(contact_laws[law], 0.0, 1.0);
            struct particles *const ps = particles_create(2);
            const double v = 0.7;
            struct dem_report r;

            o.material.restitution = k == 0 ? 0.0 : 1e-6;
            o.step = limits_step(o.law, &o.material, 0.01, 2000.0, v);
            spheres_throw(ps, spheres_add(ps, -0.005, 0, 0, 0.01), v, 0, 0);
            spheres_add(ps, 0.005, 0.0, 0.0, 0.01);
            struct dem *const dem = dem_create(ps, &o);
            for (int step = 0; step < 45; step++) {
                ck_assert_int_eq(dem_run(dem, 1, &r), 0);
                ck_assert_double_gt(ps->vx[0] - ps->vx[1], -0.25 * v);
            }
            ck_assert_double_eq_tol(ps->vx[0] - ps->vx[1], 0.0, 0.05 * v);
            dem_free(dem);
            particles_free(ps);
        }
}

/* Soft and fast: the contact lasts, but a longer step would miss it. */
FACT(in_a_safe_step_nobody_moves_by_more_than_its_radius)
{
    const struct contact_law *const law = contact_law_named("linear");
    const struct material m = {.stiffness = 100.0, .restitution = 0.9};

    ck_assert_double_eq(limits_longest_step(law, &m, 1e-3, 1000.0, 300.0),
                        0.5 * 1e-3 / 300.0);
    ck_assert_double_eq_tol(limits_step(law, &m, 1e-3, 1000.0, 300.0) / 1e-6,
                            1.0, 1e-14);
}
