/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Forces without contact, each against its formula in a motion with a closed
 * form: orbits, falls and spheres hanging on the ceiling. */
#include <gsl/gsl_math.h>
#include <omp.h>
#include <stdlib.h>

#include "dem/attraction.h"
#include "facts.h"
#include "spheres.h"

static const double d = 1e-3;

static struct dem_options with(const struct attraction *a, double step)
{
    struct dem_options o = spheres_options(&contact_linear, step, 0.05);

    o.attractions = a;
    o.n_attractions = 1;
    return o;
}

static void run(struct particles *ps, const struct dem_options *o, int steps)
{
    struct dem *const dem = dem_create(ps, o);
    struct dem_report r;

    ck_assert_ptr_nonnull(dem);
    ck_assert_int_eq(dem_run(dem, steps, &r), 0);
    dem_free(dem);
}

/* Two spheres at rest on a line askew to the axes, a gap apart. */
static struct particles *pair_apart(double gap, double d_i, double d_j)
{
    const double n[3] = {2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0};
    const double l = gap + 0.5 * (d_i + d_j);
    struct particles *const ps = particles_create(2);

    spheres_add(ps, 0.0, 0.0, 0.0, d_i);
    spheres_add(ps, l * n[0], l * n[1], l * n[2], d_j);
    return ps;
}

/* Force [N] on sphere 0 towards sphere 1, and the two forces must be equal and
 * opposite to the bit. */
static double pull_between(const struct attraction *a, double gap, double d_i,
                           double d_j)
{
    const double n[3] = {2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0};
    struct particles *const ps = pair_apart(gap, d_i, d_j);
    const struct dem_options o = with(a, 1e-9);

    run(ps, &o, 1);
    const int i = spheres_place(ps, 0), j = spheres_place(ps, 1);
    ck_assert_double_eq(ps->cfx[i], -ps->cfx[j]);
    ck_assert_double_eq(ps->cfy[i], -ps->cfy[j]);
    ck_assert_double_eq(ps->cfz[i], -ps->cfz[j]);
    const double F = ps->cfx[i] * n[0] + ps->cfy[i] * n[1] + ps->cfz[i] * n[2];
    particles_free(ps);
    return F;
}

/* --- [LS 4.13] ------------------------------------------------------------ */

/* Two charges of 1 nC, 1 cm apart in vacuum: 8.98755e-5 N, from Coulomb's
 * constant 8.98755e9 N m^2/C^2; in a medium of eps_r = 2 half of it. */
FACT(ls_4_13_like_charges_repel_with_coulombs_constant)
{
    const double F = electrostatic_force(1e-9, 1e-9, 1.0, 0.01);

    ck_assert_double_eq_tol(F / 8.9875518e-5, 1.0, 1e-7);
    ck_assert_double_eq_tol(electrostatic_force(1e-9, -1e-9, 2.0, 0.01) / F,
                            -0.5, 1e-14);
}

FACT(ls_4_13_unlike_spheres_are_drawn_together_by_their_materials)
{
    const double charge[] = {1e-10, -3e-10};
    const struct material other = {.stiffness = 1e4, .restitution = 1.0};
    const struct materials all = {2, &other, 0, NULL, 0};
    const struct attraction a = {.law = &electrostatic,
                                 .range = 0.01,
                                 .strength = 1.0,
                                 .charge = charge};
    struct dem_options o = with(&a, 1e-9);

    o.materials = &all;
    for (int of_j = 0; of_j < 2; of_j++) {
        struct particles *const ps = pair_apart(2.0 * d, d, d);
        particles_add_material(ps);
        ps->material[1] = of_j;
        run(ps, &o, 1);
        const double F =
            electrostatic_force(charge[0], charge[of_j], 1.0, 3.0 * d);
        const int i = spheres_place(ps, 0); /* sphere 1 is at larger x */
        ck_assert_double_eq_tol(ps->cfx[i] / (-F * 2.0 / 3.0), 1.0, 1e-9);
        particles_free(ps);
    }
}

/* Unlike charges circle around each other: w^2 = k q^2/(mu r^3) with the
 * reduced mass mu. After one turn of 4000 steps they are back where they were
 * within a 1000th of the distance. With 1/l instead of 1/l^2, or m for mu, they
 * would be far from there. */
FACT(ls_4_13_unlike_charges_circle_as_keplers_planets)
{
    const double charge[] = {1e-10, -1e-10}, l = 5.0 * d;
    const struct material other = {.stiffness = 1e4, .restitution = 1.0};
    const struct materials all = {2, &other, 0, NULL, 0};
    const struct attraction a = {.law = &electrostatic,
                                 .range = 0.02,
                                 .strength = 1.0,
                                 .charge = charge};
    struct particles *const ps = particles_create(2);

    particles_add_material(ps);
    for (int k = 0; k < 2; k++) {
        spheres_add(ps, k == 0 ? -0.5 * l : 0.5 * l, 0.0, 0.0, d);
        ps->material[k] = k;
    }
    const double F = electrostatic_force(1e-10, 1e-10, 1.0, l);
    const double v = sqrt(0.5 * F * l / ps->m[0]); /* m v^2/(l/2) = F */
    struct dem_options o = with(&a, 2.0 * M_PI * (0.5 * l / v) / 4000);
    o.materials = &all;
    spheres_throw(ps, 0, 0.0, -v, 0.0);
    spheres_throw(ps, 1, 0.0, v, 0.0);
    run(ps, &o, 4000);
    const int i = spheres_place(ps, 0);
    ck_assert_double_eq_tol(ps->x[i] / l, -0.5, 1e-3);
    ck_assert_double_eq_tol(ps->y[i] / l, 0.0, 1e-3);
    particles_free(ps);
}

/* --- [LS 4.14] ------------------------------------------------------------ */

/* A = 1e-19 J, 1 mm spheres, 1 nm: 1e-19/(12e-18) 0.5e-3 = 4.1667e-6 N. */
FACT(ls_4_14_van_der_waals_by_hand)
{
    const double D = van_der_waals_diameter(1e-3, 1e-3);

    ck_assert_double_eq(D, 0.5e-3);
    ck_assert_double_eq_tol(van_der_waals_force(1e-19, D, 1e-9) / 4.1666667e-6,
                            1.0, 1e-7);
    ck_assert_double_eq_tol(van_der_waals_force(1e-19, D, 2e-9) /
                                van_der_waals_force(1e-19, D, 1e-9),
                            0.25, 1e-14);
}

static const struct attraction sticky = {
    .law = &van_der_waals, .range = 1e-4, .strength = 1e-12, .closest = 1e-6};

/* The force attracts, ends at its range, and is constant below the closest gap,
 * also where the spheres overlap. */
FACT(ls_4_14_the_force_grows_to_the_closest_gap_and_no_further)
{
    const double D = van_der_waals_diameter(d, 3.0 * d);
    const double F = van_der_waals_force(1e-12, D, 1e-6);
    const struct attraction soft = sticky;

    ck_assert_double_eq_tol(pull_between(&soft, 2e-5, d, 3.0 * d) / F,
                            1.0 / 400.0, 1e-9);
    ck_assert_double_eq_tol(pull_between(&soft, 5e-7, d, 3.0 * d) / F, 1.0,
                            1e-9);
    const double pushed = 1e4 * 1e-8; /* k delta of the contact, elastic */
    ck_assert_double_eq_tol(
        (pull_between(&soft, -1e-8, d, 3.0 * d) + pushed) / F, 1.0, 1e-5);
    ck_assert_double_eq(pull_between(&soft, 1.01e-4, d, 3.0 * d), 0.0);
    ck_assert_double_gt(pull_between(&soft, 0.99e-4, d, 3.0 * d), 0.0);
}

/* The energy of two spheres is -A D/(12 l): from rest at a gap of 20 um they
 * have at 10 um what the difference leaves them. 0.2 % is for the step in
 * which they pass 10 um. */
FACT(ls_4_14_two_spheres_fall_together_with_the_energy_of_their_well)
{
    struct particles *const ps = pair_apart(2e-5, d, d);
    const struct dem_options o = with(&sticky, 1e-6);
    const double D = van_der_waals_diameter(d, d);
    struct dem *const dem = dem_create(ps, &o);
    struct dem_report r;
    double gap = 2e-5;

    for (int k = 0; k < 100000 && gap > 1e-5; k++) {
        ck_assert_int_eq(dem_run(dem, 1, &r), 0);
        const double dx = ps->x[1] - ps->x[0], dy = ps->y[1] - ps->y[0];
        const double dz = ps->z[1] - ps->z[0];
        gap = sqrt(dx * dx + dy * dy + dz * dz) - d;
    }
    const double won = 1e-12 * D / 12.0 * (1.0 / gap - 1.0 / 2e-5);
    ck_assert_double_eq_tol(r.translation / won, 1.0, 2e-3);
    dem_free(dem);
    particles_free(ps);
}

/* A sphere of infinite radius is a wall, D_i D_j/(D_i + D_j) -> D_i; and all
 * six walls pull outward. */
FACT(ls_4_14_a_wall_is_a_sphere_of_infinite_radius)
{
    const double F = van_der_waals_force(1e-12, d, 1e-5);

    ck_assert_double_eq_tol(van_der_waals_diameter(d, 1e6) / d, 1.0, 1e-8);
    for (int wall = 0; wall < 6; wall++) {
        const struct dem_options o = with(&sticky, 1e-9);
        struct particles *const ps = particles_create(1);
        double x[3] = {0.0, 0.0, 0.0};
        const double side = wall % 2 ? 1.0 : -1.0;

        x[wall / 2] = side * (0.05 - 0.5 * d - 1e-5);
        particles_add(ps, x, d, 2000.0);
        run(ps, &o, 1);
        const double *const f[] = {ps->cfx, ps->cfy, ps->cfz};
        ck_assert_double_eq_tol(f[wall / 2][0] / (side * F), 1.0, 1e-6);
        ck_assert_double_eq(f[(wall / 2 + 1) % 3][0], 0.0);
        particles_free(ps);
    }
}

/* --- [LS 4.15] ------------------------------------------------------------ */

/* Water, 0.072 N/m, on spheres of 1 mm: 2 pi 0.5e-3 0.072 = 2.2619e-4 N, that
 * is 22 times the weight of a grain of sand of that size. */
FACT(ls_4_15_a_bridge_of_water_by_hand)
{
    const double R = capillary_mean(0.5e-3, 0.5e-3);

    ck_assert_double_eq_tol(capillary_force(0.072, R) / -2.2619467e-4, 1.0,
                            1e-7);
    ck_assert_double_eq(R, capillary_harmonic_mean(0.5e-3, 0.5e-3));
}

/* [LS 4.15]'s mean grows with the larger sphere for ever; Derjaguin's tends to
 * twice the smaller radius, as for a wall. */
FACT(ls_4_15_unequal_spheres_tell_the_two_means_apart)
{
    ck_assert_double_eq_tol(capillary_mean(1.0, 30.0), 15.5, 1e-14);
    ck_assert_double_eq_tol(capillary_harmonic_mean(1.0, 30.0), 60.0 / 31.0,
                            1e-14);
    ck_assert_double_eq_tol(capillary_harmonic_mean(1.0, 1e9), 2.0, 1e-8);

    struct attraction a = {.law = &capillary, .range = 1e-4, .strength = 0.05};
    const double F = 2.0 * M_PI * 0.05 * d;
    ck_assert_double_eq_tol(pull_between(&a, 5e-5, d, 3.0 * d) / F, 1.0, 1e-9);
    a.harmonic = 1;
    ck_assert_double_eq_tol(pull_between(&a, 5e-5, d, 3.0 * d) / F, 0.75, 1e-9);
}

/* A wet grain hangs under the ceiling: the contact force there is the pull of
 * the bridge less the weight of the grain. A drier one falls. */
FACT(ls_4_15_a_wet_grain_hangs_under_the_ceiling)
{
    for (int wet = 0; wet < 2; wet++) {
        const double weight = 2000.0 * M_PI / 6.0 * d * d * d * 9.81;
        const double F = weight * (wet ? 2.0 : 0.99);
        const struct attraction a = {.law = &capillary,
                                     .strength = F / (2.0 * M_PI * d)};
        struct dem_options o = with(&a, 1e-6);
        struct particles *const ps = particles_create(1);

        o.material.restitution = 0.3;
        spheres_add(ps, 0.0, 0.05 - 0.5 * d + 1e-12, 0.0, d);
        ps->ey[0] = -weight;
        run(ps, &o, 100000);
        const double delta = ps->y[0] + 0.5 * d - 0.05;
        if (wet)
            ck_assert_double_eq_tol(delta * 1e4 / weight, 1.0, 1e-3);
        else
            ck_assert_double_lt(delta, -d);
        particles_free(ps);
    }
}

/* To part, two grains must climb out of a well of depth F times the range: a
 * little slower and they return, a little faster and they separate. */
FACT(ls_4_15_two_wet_grains_part_with_the_work_of_the_bridge)
{
    const double range = 2e-4;
    const struct attraction a = {
        .law = &capillary, .range = range, .strength = 0.01};
    const double F = 2.0 * M_PI * 0.5 * d * 0.01;

    for (int fast = 0; fast < 2; fast++) {
        struct particles *const ps = particles_create(2);
        const struct dem_options o = with(&a, 1e-6);

        spheres_add(ps, 0.0, 0.0, 0.0, d);
        spheres_add(ps, d, 0.0, 0.0, d);
        const double v = sqrt(4.0 * F * range / ps->m[0]); /* m* v^2/2 = F l */
        spheres_throw(ps, 1, (fast ? 1.02 : 0.98) * v, 0.0, 0.0);
        run(ps, &o, (int)(1.5 * range / (0.5 * v * 1e-6)));
        const double apart = fabs(ps->x[1] - ps->x[0]) - d;
        if (fast)
            ck_assert_double_gt(apart, range);
        else
            ck_assert_double_lt(apart, range);
        particles_free(ps);
    }
}

/* --- all of them ---------------------------------------------------------- */

/* A cloud with both kinds of cohesion; `skin` 0 is the usual one. */
static struct particles *cloud(int threads, double skin, int periodic)
{
    static const double charge[] = {2e-12};
    const struct attraction all[] = {
        {.law = &capillary, .range = 2e-4, .strength = 0.005},
        {.law = &electrostatic,
         .range = 1e-3,
         .strength = 1.0,
         .charge = charge}};
    struct particles *const ps = spheres_cloud(14, d, 0.5, 1.55e-3, 0.5, 5);
    struct dem_options o = spheres_options(&contact_linear, 5e-6, 0.0112);
    struct dem_report r;

    o.attractions = all;
    o.n_attractions = 2;
    o.skin = skin;
    o.material.stiffness = 1e3;
    o.material.restitution = 0.5;
    for (int k = 0; k < 3; k++)
        o.periodic[k] = periodic;
    omp_set_num_threads(threads);
    struct dem *const dem = dem_create(ps, &o);
    ck_assert_int_eq(dem_run(dem, 300, &r), 0);
    ck_assert_int_gt(r.contacts, 100);
    dem_free(dem);
    omp_set_num_threads(1);
    return ps;
}

FACT(attractions_have_the_same_bits_for_any_number_of_threads)
{
    struct particles *const a = cloud(1, 0.0, 0), *const b = cloud(2, 0.0, 0);
    const size_t size = (size_t)a->n * sizeof(double);

    ck_assert_int_eq(memcmp(a->x, b->x, size), 0);
    ck_assert_int_eq(memcmp(a->vz, b->vz, size), 0);
    particles_free(a);
    particles_free(b);
}

/* A longer list must give the same pairs: only the order of sums differs. Pairs
 * within the range that the list lacks would change positions by 1e-6 m. */
FACT(attractions_do_not_depend_on_the_skin)
{
    struct particles *const a = cloud(1, 0.0, 0), *const b = cloud(1, 5e-4, 0);

    for (int id = 0; id < a->n; id++) {
        const int i = spheres_place(a, id), j = spheres_place(b, id);
        ck_assert_double_eq_tol(a->x[i], b->x[j], 1e-10);
        ck_assert_double_eq_tol(a->y[i], b->y[j], 1e-10);
    }
    particles_free(a);
    particles_free(b);
}

/* A pair across a periodic end has the same force as in the middle of the box,
 * up to the rounding of positions. */
FACT(attractions_reach_through_the_seam)
{
    double F[2];

    for (int k = 0; k < 2; k++) {
        struct particles *const ps = particles_create(2);
        struct dem_options o = with(&sticky, 1e-9);
        const double x = k == 0 ? 0.0 : -0.05 + 0.25 * d;
        o.periodic[0] = 1;
        spheres_add(ps, x, 0.0, 0.0, d);
        spheres_add(ps, k == 0 ? -d - 2e-5 : x + 0.1 - d - 2e-5, 0.0, 0.0, d);
        run(ps, &o, 1);
        F[k] = ps->cfx[spheres_place(ps, 0)];
        particles_free(ps);
    }
    ck_assert_double_lt(F[0], 0.0);
    ck_assert_double_eq_tol(F[1] / F[0], 1.0, 1e-10);
}

/* Equal and opposite, through all seams: the sum of the momenta is that of the
 * start, to rounding of the 2744 of them. */
FACT(attractions_keep_the_momentum_of_a_periodic_box)
{
    struct particles *const a = spheres_cloud(14, d, 0.5, 1.55e-3, 0.5, 5);
    struct particles *const b = cloud(1, 0.0, 1);
    double before = 0.0, after = 0.0, scale = 0.0;

    for (int i = 0; i < a->n; i++) {
        before += a->m[i] * a->vx[i];
        after += b->m[i] * b->vx[i];
        scale += a->m[i] * fabs(a->vx[i]);
    }
    ck_assert_double_eq_tol(after / scale, before / scale, 1e-12);
    particles_free(a);
    particles_free(b);
}
