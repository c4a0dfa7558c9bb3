/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Particles that do not meet: particles.list = "none". */
#include <omp.h>
#include <stdlib.h>

#include "dem/dem_method.h"
#include "dem/energy.h"
#include "facts.h"
#include "spheres.h"

static struct dem_options apart(double step, double half)
{
    struct dem_options o = spheres_options(&contact_linear, step, half);

    o.method = dem_method_named("none");
    return o;
}

/* Where a sphere is that is pulled down and held back by a drag and an added
 * mass, after 300 steps. */
static struct particles *pulled(const struct dem_options *o)
{
    struct particles *const ps = particles_create(1);
    struct dem_report r;

    particles_add_implicit_drag(ps);
    spheres_add(ps, 0.1, 0.2, 0.3, 0.01);
    spheres_throw(ps, 0, 0.4, -0.5, 0.6);
    struct dem *const dem = dem_create(ps, o);
    ps->ey[0] = -9.81 * ps->m[0];
    ps->drag_coefficient[0] = 20.0 * ps->m[0];
    ps->added_mass[0] = 0.3 * ps->m[0];
    for (int k = 0; k < 3; k++)
        ck_assert_int_eq(dem_run(dem, 100, &r), 0);
    ck_assert_int_eq(r.steps, 100);
    dem_free(dem);
    return ps;
}

/* The same steps as of the other loops, in another order: rounding only. */
FACT_FOR_EACH(ls_4_1_alone_a_particle_moves_as_with_a_list, 2)
{
    struct dem_options o = apart(1e-3, 1.0);
    o.integrator =
        integrator_named(_i ? "symplectic-euler" : "velocity-verlet");
    struct particles *const own = pulled(&o);
    o.method = dem_method_named("verlet");
    struct particles *const listed = pulled(&o);

    ck_assert_double_eq_tol(own->x[0], listed->x[0], 1e-14);
    ck_assert_double_eq_tol(own->y[0], listed->y[0], 1e-14);
    ck_assert_double_eq_tol(own->vz[0], listed->vz[0], 1e-14);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(own->drag_impulse[k], listed->drag_impulse[k],
                                1e-13 * own->m[0]);
    particles_free(own);
    particles_free(listed);
}

/* A ball falls from h and rises to e^2 h, whatever the step: here an impact
 * would last 0.1 ms, and a step is 1 ms. The budget holds up to the work of the
 * weight in the step of the impact, m g v dt. */
FACT(ls_4_4_a_wall_gives_back_the_square_of_e)
{
    const double h = 1.0, g = 9.81, e = 0.7, dt = 1e-3;
    struct particles *const ps = particles_create(1);
    struct dem_options o = apart(dt, 1.0);
    struct dem_report r;
    double top = -1.0;

    o.material.restitution = e;
    spheres_add(ps, 0.0, h - 0.99, 0.0, 0.02); /* h above the floor */
    struct dem *const dem = dem_create(ps, &o);
    ps->ey[0] = -g * ps->m[0];
    dem_start_energy_budget(dem);
    const double fall = sqrt(2.0 * h / g);
    for (int k = 0; k * dt < fall * (1.0 + 1.8 * e); k++) {
        ck_assert_int_eq(dem_run(dem, 1, &r), 0);
        if (k * dt > fall) top = fmax(top, ps->y[0] + 0.99);
    }
    /* the impact is found up to a step late, at g dt more or less speed */
    ck_assert_double_eq_tol(top, e * e * h,
                            2.0 * g * dt * sqrt(2.0 * g * h) / g);
    ck_assert_double_gt(dem_energy(dem)->damped_n, 0.0);
    ck_assert_double_le(fabs(energy_residual(dem_energy(dem))),
                        ps->m[0] * g * sqrt(2.0 * g * h) * dt);
    ck_assert_int_eq(r.contacts, 0);
    dem_free(dem);
    particles_free(ps);
}

/* Head-on: each goes on as if the other were not there, to the bit. */
FACT(two_that_do_not_meet_pass_through_each_other)
{
    const struct dem_options o = apart(1e-4, 1.0);
    double alone = 0.0;

    for (int n = 1; n <= 2; n++) {
        struct particles *const ps = particles_create(n);
        struct dem_report r;
        spheres_add(ps, -0.1, 0.0, 0.0, 0.1);
        spheres_throw(ps, 0, 1.0, 0.0, 0.0);
        if (n == 2) spheres_add(ps, 0.1, 0.0, 0.0, 0.1);
        if (n == 2) spheres_throw(ps, 1, -1.0, 0.0, 0.0);
        struct dem *const dem = dem_create(ps, &o);
        ck_assert_int_eq(dem_run(dem, 3000, &r), 0);
        ck_assert_int_eq(r.contacts, 0);
        if (n == 1) alone = ps->x[0];
        ck_assert_double_eq(ps->x[0], alone);
        ck_assert_double_eq_tol(ps->x[0], 0.2, 1e-12);
        dem_free(dem);
        particles_free(ps);
    }
}

/* Periodic directions lead round, walls hold; two threads do what one does. */
FACT(a_cloud_stays_in_its_box_with_the_same_bits_for_any_threads)
{
    double sum[2] = {0.0, 0.0};

    for (int threads = 1; threads <= 2; threads++) {
        struct dem_options o = apart(1e-3, 0.5);
        struct particles *const ps = spheres_cloud(11, 0.01, 0.5, 0.05, 3.0, 7);
        struct dem_report r;
        o.periodic[0] = 1;
        omp_set_num_threads(threads);
        struct dem *const dem = dem_create(ps, &o);
        ck_assert_int_eq(dem_run(dem, 1000, &r), 0);
        ck_assert_int_eq(r.lost, 0);
        for (int i = 0; i < ps->n; i++) {
            ck_assert_double_le(fabs(ps->x[i]), 0.5);
            ck_assert_double_le(fabs(ps->y[i]), 0.5 - 0.5 * ps->d[i]);
            sum[threads - 1] += (i + 1) * (ps->x[i] + ps->vz[i]);
        }
        dem_free(dem);
        particles_free(ps);
    }
    ck_assert_double_eq(sum[0], sum[1]);
}

FACT(one_that_is_not_finite_is_lost_and_named)
{
    const struct dem_options o = apart(1e-3, 1.0);
    struct particles *const ps = particles_create(2);
    struct dem_report r;

    spheres_add(ps, 0.0, 0.0, 0.0, 0.1);
    spheres_add(ps, 0.3, 0.0, 0.0, 0.1);
    ps->ex[1] = NAN;
    struct dem *const dem = dem_create(ps, &o);
    ck_assert_int_ne(dem_run(dem, 1, &r), 0);
    ck_assert_int_eq(r.lost, 1);
    ck_assert_int_eq(r.lost_id, 1);
    dem_free(dem);
    particles_free(ps);
}
