/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cases in which contact codes fail: very unequal sizes, very large forces, e =
 * 0 and e = 1, no particles. Each against a closed form. */
#include <gsl/gsl_math.h>

#include "dem/attraction.h"
#include "dem/fast/neighbours.h"
#include "facts.h"
#include "spheres.h"

/* --- 30 : 1 --------------------------------------------------------------- */

/* 400 spheres of 1 mm lie around one of 30 mm at random, none nearer than
 * touching: the list has exactly the pairs that all 80 200 comparisons find. */
FACT_FOR_EACH(ls_5_15_a_sphere_among_others_of_a_30th_finds_all_of_them, 2)
{
    const double D = 0.03, d = 1e-3, skin = 2e-4;
    const double lo[3] = {-0.02, -0.02, -0.02}, hi[3] = {0.02, 0.02, 0.02};
    const int periodic[3] = {_i, _i, 0};
    const struct box_domain box = box_domain_of(lo, hi, periodic);
    struct particles *const ps = particles_create(401);
    uint64_t seed = 11;
    int expected = 0, found = 0;

    spheres_add(ps, 0.001, -0.002, 0.003, D);
    while (ps->n < 401) {
        double x[3], r2 = 0.0;
        for (int k = 0; k < 3; k++) {
            const double centre[3] = {0.001, -0.002, 0.003};
            x[k] = 0.0194 * spheres_random(&seed);
            r2 += (x[k] - centre[k]) * (x[k] - centre[k]);
        }
        if (r2 > 0.25 * (D + d) * (D + d)) particles_add(ps, x, d, 2000.0);
    }
    struct neighbours *const nb = neighbours_create(ps, &box);
    nb->skin = skin;
    neighbours_begin_run(nb, 1);
    neighbours_load(nb);
    ck_assert_double_gt(neighbours_refresh(nb, 1e-6, 0.0), 0.0);
    for (int i = 0; i < ps->n; i++)
        for (int j = 0; j < i; j++) {
            const double *const x[] = {ps->x, ps->y, ps->z};
            double r2 = 0.0;
            for (int k = 0; k < 3; k++) {
                double dx = x[k][i] - x[k][j];
                if (periodic[k]) dx -= 0.04 * rint(dx / 0.04);
                r2 += dx * dx;
            }
            expected += sqrt(r2) - 0.5 * (ps->d[i] + ps->d[j]) <= skin;
        }
    for (int s = 0; s < nb->n_chunks; s++)
        found += nb->chunks[s].pairs.n;
    ck_assert_int_gt(expected, 10);
    ck_assert_int_eq(found, expected);
    neighbours_free(nb);
    particles_free(ps);
}

/* A grain hits a boulder of 30 times its width, 27 000 times its mass, at an
 * angle: it leaves with e of its normal speed, and the momentum of both stays.
 * 0.5 % is what a 500th of the contact leaves of e. */
FACT_FOR_EACH(ls_4_4_a_grain_rebounds_from_a_boulder, 2)
{
    const double e = 0.7, v = 0.5, d = 1e-3;
    const struct contact_law *const law = contact_laws[_i];
    struct dem_options o = spheres_options(law, 1e-7, 0.1);
    struct particles *const ps = particles_create(2);

    o.material.restitution = e;
    o.material.friction = 0.3;
    spheres_add(ps, 0.0, 0.0, 0.0, 30.0 * d);
    spheres_add(ps, 15.5 * d + 1e-8, 0.0, 0.0, d);
    spheres_throw(ps, 1, -v, 0.3, 0.0);
    const double px = ps->m[1] * ps->vx[1], py = ps->m[1] * ps->vy[1];
    spheres_collide(ps, &o);
    const int i = spheres_place(ps, 0), j = spheres_place(ps, 1);
    ck_assert_double_eq_tol((ps->vx[j] - ps->vx[i]) / (e * v), 1.0, 5e-3);
    ck_assert_double_eq_tol((ps->m[i] * ps->vx[i] + ps->m[j] * ps->vx[j]) / px,
                            1.0, 1e-12);
    ck_assert_double_eq_tol((ps->m[i] * ps->vy[i] + ps->m[j] * ps->vy[j]) / py,
                            1.0, 1e-12);
    particles_free(ps);
}

/* --- a contact of a million newtons --------------------------------------- */

/* Two steel spheres of 0.2 m in a press of 1e6 N come to rest where Hertz says,
 * delta = (3 F/(4 E* sqrt(R*)))^(2/3), or F/k for a spring; e = 0, so that they
 * do come to rest, to 1e-9 of the overlap. */
FACT_FOR_EACH(ls_4_7_a_press_of_a_million_newtons_finds_its_equilibrium, 2)
{
    const int hertz = contact_laws[_i] == &contact_hertz;
    const double F = 1e6, d = 0.2, E = 208e9, nu = 0.3;
    struct dem_options o = spheres_options(contact_laws[_i], 2e-6, 1.0);
    struct particles *const ps = particles_create(2);
    struct dem_report r;

    o.material = (struct material){
        .young = E, .poisson = nu, .stiffness = 1e9, .friction = 0.5};
    for (int k = 0; k < 2; k++) {
        particles_add(ps, (double[3]){k == 0 ? -0.0999 : 0.0999, 0.0, 0.0}, d,
                      7800.0);
        ps->ex[k] = k == 0 ? F : -F;
    }
    const double E_star = E / (2.0 * (1.0 - nu * nu));
    const double delta =
        hertz ? pow(3.0 * F / (4.0 * E_star * sqrt(0.05)), 2.0 / 3.0) : F / 1e9;
    struct dem *const dem = dem_create(ps, &o);
    ck_assert_int_eq(dem_run(dem, 40000, &r), 0);
    ck_assert_int_eq(dem_run(dem, 1, &r), 0);
    ck_assert_double_eq_tol(r.max_overlap * d / delta, 1.0, 1e-9);
    ck_assert_double_eq_tol(fabs(ps->cfx[0]) / F, 1.0, 1e-9);
    ck_assert_double_lt(r.max_speed, 1e-10);
    dem_free(dem);
    particles_free(ps);
}

/* --- e = 1 and e = 0 ------------------------------------------------------ */

/* e = 1, mu = 0: in a closed box one sphere has the speed that it had, after
 * hundreds of impacts. Each leaves an error of its own sign in the second order
 * of the step, 1e-5 here, and they do not add up. */
FACT_FOR_EACH(ls_4_4_a_perfectly_elastic_sphere_keeps_its_energy, 2)
{
    struct dem_options o = spheres_options(contact_laws[_i], 5e-6, 0.02);
    struct particles *const ps = particles_create(1);
    struct dem_report r;
    double low = 1e9, high = 0.0;

    spheres_add(ps, 0.001, 0.002, 0.003, 0.01);
    spheres_throw(ps, 0, 1.0, 1.3, -0.7);
    const double v = sqrt(1.0 + 1.69 + 0.49);
    struct dem *const dem = dem_create(ps, &o);
    for (int k = 0; k < 400; k++) {
        ck_assert_int_eq(dem_run(dem, 2500, &r), 0);
        if (r.contacts > 0) continue; /* part of it is in the spring */
        low = fmin(low, r.max_speed);
        high = fmax(high, r.max_speed);
    }
    ck_assert_double_eq_tol(high / v, 1.0, 1e-3);
    ck_assert_double_eq_tol(low / v, 1.0, 1e-3);
    dem_free(dem);
    particles_free(ps);
}

/* e = 0: a column of spheres falls on the floor and lies there, each bearing
 * those above it, at the height of the closed form. */
FACT(ls_4_11_a_column_that_gives_nothing_back_lies_still)
{
    const double d = 0.01, k = 1e4, g = 9.81;
    struct dem_options o = spheres_options(&contact_linear, 1e-5, 0.05);
    struct particles *const ps = particles_create(5);
    struct dem_report r;
    double y = -0.05 - 0.5 * d;

    o.material.restitution = 0.0;
    for (int i = 0; i < 5; i++) {
        spheres_add(ps, 0.0, -0.05 + (i + 0.6) * 1.05 * d, 0.0, d);
        ps->ey[i] = -ps->m[i] * g;
    }
    const double sag = ps->m[0] * g / k;
    struct dem *const dem = dem_create(ps, &o);
    ck_assert_int_eq(dem_run(dem, 100000, &r), 0);
    ck_assert_int_eq(r.contacts, 5);
    ck_assert_double_lt(r.max_speed, 1e-9);
    for (int i = 0; i < 5; i++) {
        y += d - (5 - i) * sag;
        ck_assert_double_eq_tol(ps->y[spheres_place(ps, i)], y, 1e-9);
    }
    dem_free(dem);
    particles_free(ps);
}

/* --- no particles --------------------------------------------------------- */

/* With every option at once: several materials that roll, and an attraction. */
FACT_FOR_EACH(no_particle_or_one_is_no_trouble_with_everything_on, 2)
{
    const struct material other = {.young = 1e6,
                                   .poisson = 0.2,
                                   .stiffness = 1e3,
                                   .restitution = 0.5,
                                   .friction = 0.1,
                                   .rolling = 0.2};
    const struct materials all = {2, &other, 0, NULL, 1};
    const struct attraction wet = {
        .law = &capillary, .range = 1e-4, .strength = 0.07};

    for (int n = 0; n < 2; n++) {
        struct dem_options o = spheres_options(contact_laws[_i], 1e-6, 0.05);
        struct particles *const ps = particles_create(n);
        struct dem_report r;

        o.material.rolling = 0.1;
        o.materials = &all;
        o.attractions = &wet;
        o.n_attractions = 1;
        particles_add_material(ps);
        for (int i = 0; i < n; i++) {
            spheres_add(ps, 0.0, 0.0, 0.0, 0.01);
            spheres_throw(ps, i, 1.0, 2.0, 3.0);
        }
        struct dem *const dem = dem_create(ps, &o);
        ck_assert_int_eq(dem_run(dem, 1000, &r), 0);
        ck_assert_int_eq(r.lost, 0);
        ck_assert_int_eq(r.contacts, 0);
        if (n == 1) ck_assert_double_eq_tol(ps->y[0], 2e-3, 1e-15);
        dem_free(dem);
        particles_free(ps);
    }
}
