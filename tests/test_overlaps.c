/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Spheres that are in each other before time 0. */
#include "dem/population/insertion.h"
#include "facts.h"
#include "spheres.h"

static struct box_domain box_of(double half, int periodic)
{
    const double lo[3] = {-half, -half, -half}, hi[3] = {half, half, half};
    const int flags[3] = {periodic, 0, 0};
    return box_domain_of(lo, hi, flags);
}

FACT_FOR_EACH(the_deepest_pair_is_found_also_across_a_seam, 2)
{
    const struct box_domain box = box_of(0.1, _i);
    struct particles *const ps = particles_create(4);

    spheres_add(ps, 0.0, 0, 0, 0.01);
    spheres_add(ps, 0.0095, 0, 0, 0.01); /* 5 % */
    spheres_add(ps, 0.099, 0, 0, 0.01);
    spheres_add(ps, -0.0982, 0, 0, 0.02); /* 81 % of 15 mm across the seam */
    const struct overlap found = overlaps_deepest(ps, &box);
    ck_assert_int_eq(found.i, _i ? 2 : 0);
    ck_assert_int_eq(found.j, _i ? 3 : 1);
    ck_assert_double_eq_tol(found.depth, _i ? 1.0 - 2.8 / 15.0 : 0.05, 1e-12);
    particles_free(ps);
}

/* The pair that comparing each with each finds, also where all are in a plane
 * across an axis, or around a period; among many it is found at once. */
FACT_FOR_EACH(the_deepest_of_many_is_that_of_all_pairs, 6)
{
    const int along = _i % 3, periodic[3] = {_i > 2, _i > 2, _i > 2};
    const double lo[3] = {0.0, 0.0, 0.0}, hi[3] = {1.0, 1.0, 1.0};
    const struct box_domain box = box_domain_of(lo, hi, periodic);
    const int n = 400;
    struct particles *const ps = particles_create(n);
    struct overlap all = {0, -1, 0.0};
    uint64_t seed = 5;

    for (int i = 0; i < n; i++) {
        double x[3];
        for (int k = 0; k < 3; k++)
            x[k] = k == along ? 0.25 : 0.5 + 0.5 * spheres_random(&seed);
        spheres_add(ps, x[0], x[1], x[2], 0.02 + 0.01 * (i % 3));
    }
    for (int i = 0; i < n; i++)
        for (int j = 0; j < i; j++) {
            const double d[3] = {ps->x[i] - ps->x[j], ps->y[i] - ps->y[j],
                                 ps->z[i] - ps->z[j]};
            const double mean = 0.5 * (ps->d[i] + ps->d[j]);
            double r2 = 0.0;
            for (int k = 0; k < 3; k++) {
                const double near = d[k] - periodic[k] * rint(d[k]);
                r2 += near * near;
            }
            const double depth = 1.0 - sqrt(r2) / mean;
            if (depth > all.depth) all = (struct overlap){j, i, depth};
        }
    const struct overlap found = overlaps_deepest(ps, &box);
    ck_assert_int_ge(all.j, 0);
    ck_assert_int_eq(found.i, all.i);
    ck_assert_int_eq(found.j, all.j);
    ck_assert_double_eq(found.depth, all.depth);
    particles_free(ps);
}

FACT(touching_is_not_overlapping)
{
    const struct box_domain box = box_of(0.1, 0);
    struct particles *const ps = particles_create(2);

    ck_assert_int_eq(overlaps_deepest(ps, &box).j, -1);
    spheres_add(ps, 0.0, 0, 0, 0.01);
    ck_assert_int_eq(overlaps_deepest(ps, &box).j, -1);
    spheres_add(ps, 0.01, 0, 0, 0.01);
    ck_assert_double_lt(overlaps_deepest(ps, &box).depth, 1e-14);
    particles_free(ps);
}

/* 100 spheres thrown into a box, 12 % of it, many of them deep in each other
 * and two in one place: none is after, and all are inside. */
FACT_FOR_EACH(spheres_are_moved_apart_and_stay_inside, 2)
{
    const struct box_domain box = box_of(0.02, _i);
    struct particles *const ps = particles_create(102);
    uint64_t seed = 3;

    for (int k = 0; k < 100; k++)
        spheres_add(ps, 0.02 * spheres_random(&seed),
                    0.015 * spheres_random(&seed),
                    0.015 * spheres_random(&seed), 0.005);
    spheres_add(ps, 0.001, 0.002, 0.003, 0.008);
    spheres_add(ps, 0.001, 0.002, 0.003, 0.008);
    ck_assert_double_gt(overlaps_deepest(ps, &box).depth, 0.5);
    ck_assert_int_gt(overlaps_relax(ps, &box, 1000), 0);
    ck_assert_double_le(overlaps_deepest(ps, &box).depth, OVERLAPS_MAX);
    for (int i = 0; i < ps->n; i++)
        ck_assert_double_le(fabs(ps->y[i]) + 0.5 * ps->d[i], 0.02 + 1e-15);
    particles_free(ps);
}

FACT(insertion_without_space_is_reported)
{
    const struct box_domain box = box_of(0.01, 0);
    struct particles *const ps = particles_create(20);

    for (int k = 0; k < 20; k++)
        spheres_add(ps, 1e-4 * k, 0, 0, 0.01);
    ck_assert_int_eq(overlaps_relax(ps, &box, 200), -1);
    particles_free(ps);
}
