/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rolling friction against a sphere on a plane, in closed form. */
#include <omp.h>
#include <stdlib.h>

#include "dem/fast/neighbours.h"
#include "dem/contact.h"
#include "facts.h"
#include "spheres.h"

static const double R = 0.005, g = 9.81, mu_r = 0.05;

static struct dem_options floor_of(int law)
{
    struct dem_options o = spheres_options(contact_laws[law], 1e-5, 0.5);

    o.material.friction = 0.8;
    o.material.restitution = 0.5;
    o.material.rolling = mu_r;
    return o;
}

/* On the floor, pressed in as far as its weight does, with gravity that leans
 * by `slope` [rad] towards x. */
static struct particles *resting(const struct dem_options *o, double slope)
{
    struct particles *const ps = particles_create(1);
    const double m = 2000.0 * 4.0 / 3.0 * 3.14159265358979 * R * R * R;
    const double E = contact_hertz_modulus(1e7, 0.25, 1e7, 0.25);
    const double N = m * g * cos(slope);
    const double delta = o->law == &contact_linear
                             ? N / o->material.stiffness
                             : pow(0.75 * N / (E * sqrt(R)), 2.0 / 3.0);

    spheres_add(ps, 0.0, -0.5 + R - delta, 0.0, 2.0 * R);
    ps->ex[0] = ps->m[0] * g * sin(slope);
    ps->ey[0] = -ps->m[0] * g * cos(slope);
    return ps;
}

static void run(struct dem *dem, double seconds, const struct dem_options *o)
{
    struct dem_report r;
    ck_assert_int_eq(dem_run(dem, (int)(seconds / o->step + 0.5), &r), 0);
}

/* (7/5) m v' = -M/R with M = mu_r R m g: so v' = -(5/7) mu_r g, and it stops
 * after 0.7 v^2/(mu_r g). 1 % is what the wound spring, 0.1 mm, and the
 * overlap, a share of 0.003 of R, leave. Without the moment of inertia of the
 * rolling, or with R/2 for R*, it would miss by 29 % or 100 %. */
FACT_FOR_EACH(a_rolling_sphere_stops_after_the_distance_that_theory_gives, 2)
{
    const struct dem_options o = floor_of(_i);
    struct particles *const ps = resting(&o, 0.0);
    struct dem *const dem = dem_create(ps, &o);
    const double v = 0.2, far = 0.7 * v * v / (mu_r * g);

    ps->vx[0] = v;
    ps->wz[0] = -v / R;
    run(dem, 1.05 * 2.0 * far / v, &o);
    ck_assert_double_eq_tol(ps->x[0] / far, 1.0, 0.01);
    dem_free(dem);
    particles_free(ps);
}

/* Then it swings on the spring, for a few periods of milliseconds, and rests:
 * a moment of constant size would keep it trembling with mu_r g dt. */
FACT_FOR_EACH(a_sphere_that_has_stopped_is_at_rest, 2)
{
    const struct dem_options o = floor_of(_i);
    struct particles *const ps = resting(&o, 0.0);
    struct dem *const dem = dem_create(ps, &o);
    const double v = 0.2;

    ps->vx[0] = v;
    ps->wz[0] = -v / R;
    run(dem, 1.4 * v / (mu_r * g), &o);
    run(dem, 0.1, &o);
    const double x = ps->x[0];
    for (int k = 0; k < 50; k++) {
        run(dem, 1e-3, &o);
        ck_assert_double_lt(fabs(R * ps->wz[0]), 1e-3 * mu_r * g * o.step);
    }
    ck_assert_double_eq_tol(ps->x[0], x, 1e-9);
    dem_free(dem);
    particles_free(ps);
}

/* The weight turns it with m g R sin a, and mu_r R m g cos a can hold that up
 * to tan a = mu_r: below it stays, above it runs away with what is left. */
FACT_FOR_EACH(a_sphere_stays_on_a_slope_of_less_than_mu_r, 2)
{
    const struct dem_options o = floor_of(_i);

    for (double share = 0.9; share < 1.6; share += 0.6) {
        const double slope = atan(share * mu_r);
        struct particles *const ps = resting(&o, slope);
        struct dem *const dem = dem_create(ps, &o);
        const double a = 5.0 / 7.0 * g * (sin(slope) - mu_r * cos(slope));

        run(dem, 0.3, &o);
        if (share < 1.0)
            ck_assert_double_lt(fabs(ps->x[0]), 0.05 * R);
        else
            ck_assert_double_eq_tol(ps->vx[0] / (a * 0.3), 1.0, 0.02);
        dem_free(dem);
        particles_free(ps);
    }
}

/* Two spheres roll on each other: what one turns less the other turns more,
 * so momentum and angular momentum stay, to rounding. */
FACT_FOR_EACH(rolling_friction_keeps_the_angular_momentum_of_a_pair, 2)
{
    struct dem_options o = floor_of(_i);
    struct particles *const ps = particles_create(2);
    double L[2] = {0.0, 0.0}, w[2];

    spheres_add(ps, -0.00499, 0.0, 0.0, 0.010);
    spheres_add(ps, 0.00699, 0.0, 0.0, 0.014);
    spheres_spin(ps, 0, 0.0, 20.0, 5.0);
    spheres_spin(ps, 1, 3.0, -4.0, -30.0);
    struct dem *const dem = dem_create(ps, &o);
    for (int k = 0; k < 2; k++) {
        w[k] = 0.0;
        for (int id = 0; id < 2; id++) {
            const int i = spheres_place(ps, id);
            const double I = 0.1 * ps->m[i] * ps->d[i] * ps->d[i];
            L[k] += I * ps->wz[i] +
                    ps->m[i] * (ps->x[i] * ps->vy[i] - ps->y[i] * ps->vx[i]);
            w[k] += fabs(ps->wz[i]);
        }
        if (k == 0) run(dem, 1e-3, &o);
    }
    ck_assert_double_gt(fabs(w[1] - w[0]), 1.0); /* the spheres did turn */
    ck_assert_double_eq_tol(L[1] / L[0], 1.0, 1e-12);
    dem_free(dem);
    particles_free(ps);
}

/* A bed in motion, the same bits on one thread and two, and with the springs
 * of rolling taken out and put back half way. */
static struct particles *stirred(int threads, int halves)
{
    struct particles *const ps = spheres_cloud(14, 0.01, 0.3, 0.0135, 0.5, 3);
    struct dem_options o = floor_of(1);
    struct dem_report r;

    o.step = 2e-5;
    for (int k = 0; k < 3; k++)
        o.lo[k] = -0.1, o.hi[k] = 0.1;
    omp_set_num_threads(threads);
    struct dem *dem = dem_create(ps, &o);
    ck_assert_int_eq(dem_run(dem, 500, &r), 0);
    if (halves) {
        int n;
        struct dem_history *const springs = dem_histories(dem, &n);
        dem_free(dem);
        dem = dem_create(ps, &o);
        dem_restore_histories(dem, springs, n);
        free(springs);
    } else
        dem_changed(dem); /* both begin the second half with new lists */
    ck_assert_int_eq(dem_run(dem, 500, &r), 0);
    dem_free(dem);
    omp_set_num_threads(1);
    return ps;
}

FACT(rolling_springs_survive_threads_sorting_and_restoring_bit_for_bit)
{
    struct particles *const a = stirred(1, 0), *const b = stirred(2, 1);
    const size_t size = (size_t)a->n * sizeof(double);

    ck_assert_int_eq(memcmp(a->x, b->x, size), 0);
    ck_assert_int_eq(memcmp(a->wz, b->wz, size), 0);
    particles_free(a);
    particles_free(b);
}

FACT(without_rolling_friction_there_is_no_array_for_it)
{
    struct particles *const ps = particles_create(2);
    const double half[3] = {1.0, 1.0, 1.0}, minus[3] = {-1.0, -1.0, -1.0};
    const int walls[3] = {0, 0, 0};
    const struct box_domain box = box_domain_of(minus, half, walls);

    for (int k = 0; k < 2; k++)
        spheres_add(ps, 0.009 * k, 0.0, 0.0, 0.01);
    for (int rolls = 0; rolls < 2; rolls++) {
        struct neighbours *const nb = neighbours_create(ps, &box);
        if (rolls) neighbours_add_rolling(nb);
        nb->skin = 1e-3;
        neighbours_begin_run(nb, 1);
        neighbours_load(nb);
        ck_assert_double_gt(neighbours_refresh(nb, 1e-5, 0.0), 0.0);
        ck_assert_int_eq(nb->chunks[0].contacts.n_pairs, 1);
        ck_assert_int_eq(nb->chunks[0].contacts.roll_angle[0] != NULL, rolls);
        neighbours_free(nb);
    }
    particles_free(ps);
}

/* A roll so fast that the dashpot alone is at the cap winds the spring by what
 * was rolled, no farther; and a displacement beyond the cap is reduced to
 * it. */
FACT(a_rolling_spring_is_wound_by_rolling_alone)
{
    const double n[3] = {0.0, 1.0, 0.0}, w[3] = {0.0, 3.0, 100.0};
    const double k_r = 2.0, C_r = 0.1, most = 0.01, dt = 1e-5;
    double M[3], theta[3] = {0.0, 0.0, 0.0};

    rolling_moment(M, theta, w, n, k_r, C_r, most, dt);
    ck_assert_double_eq_tol(M[2], -most, 1e-16);
    ck_assert_double_eq_tol(theta[2], 100.0 * dt, 1e-16);
    for (int k = 0; k < 100; k++)
        rolling_moment(M, theta, w, n, k_r, C_r, most, dt);
    ck_assert_double_eq_tol(M[2], -most, 1e-16);
    ck_assert_double_eq_tol(theta[2], most / k_r, 1e-16);
}
