/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/averaging.h"

#include <gsl/gsl_math.h>
#include <stdlib.h>

#include "boxes.h"
#include "facts.h"
#include "cloud.h"

/* 2 x 1 x 1 cells of 1 x 2 x 1 m: two particles in the left one, one in the
 * right one. q: volume and momentum over density. */
struct scene {
    struct mesh *mesh;
    struct particles *ps;
    struct averaging *a;
    double q[6], field[4];
};

static struct scene scene_of(double cap)
{
    const struct averaging_options o = {.cap = cap};
    struct scene s = {.mesh = closed_box(2.0, 2.0, 1.0, 2, 1, 1)};

    s.ps = particles_create(3);
    cloud_place(s.ps, 0.1, 0.5, 0.5, 1.0);
    cloud_place(s.ps, 1.9, 0.5, 0.5, 0.9);
    cloud_place(s.ps, 0.9, 0.1, 0.2, 0.8);
    for (int i = 0; i < 3; i++) {
        s.q[2 * i] = M_PI / 6.0 * gsl_pow_3(s.ps->d[i]);
        s.q[2 * i + 1] = (i + 1.0) * s.q[2 * i];
    }
    s.a = averaging_create(averaging_method_named("pcm"), s.mesh, s.ps, &o);
    ck_assert_int_eq(averaging_bind(s.a), 0);
    averaging_apply_cap(s.a, 2, s.q);
    averaging_spread(s.a, 2, s.q, s.field);
    return s;
}

static void scene_free(struct scene *s)
{
    averaging_free(s->a);
    particles_free(s->ps);
    mesh_free(s->mesh);
}

/* By hand: pi/6 (1 + 0.512) and pi/6 0.729, in 2 m^3 [XS11 3.1, SX15 4]. */
FACT(xs11_3_1_a_cell_has_the_sum_of_what_is_in_it)
{
    struct scene s = scene_of(0.0);
    ck_assert_double_eq_tol(s.field[0], 0.39584067435231391, 1e-15);
    ck_assert_double_eq_tol(s.field[2], 0.19085175370557991, 1e-15);
    ck_assert_int_eq(averaging_report(s.a)->capped, 0);
    scene_free(&s);
}

/* u = 1 and 3 of masses 1 and 0.512: (1 + 3 * 0.512) / 1.512. */
FACT(sx15_7_the_velocity_of_a_cell_is_weighed_by_mass)
{
    struct scene s = scene_of(0.0);
    ck_assert_double_eq_tol(s.field[1] / s.field[0], 1.6772486772486772, 1e-15);
    scene_free(&s);
}

FACT(a_capped_cell_is_counted_and_its_loss_reported)
{
    struct scene s = scene_of(0.35);
    ck_assert_double_eq_tol(s.field[0], 0.35, 1e-15);
    ck_assert_double_eq_tol(s.field[2], 0.19085175370557991, 1e-15);
    ck_assert_int_eq(averaging_report(s.a)->capped, 1);
    ck_assert_double_eq_tol(averaging_report(s.a)->lost_volume,
                            0.09168134870462782, 1e-15);
    scene_free(&s);
}

/* Momentum is scaled as volume is. */
FACT(the_cap_leaves_the_velocity_as_it_is)
{
    struct scene s = scene_of(0.35);
    ck_assert_double_eq_tol(s.field[1] / s.field[0], 1.6772486772486772, 1e-15);
    scene_free(&s);
}

/* 1 + 4 N on the left, whose cell has less volume than its spheres: amounts
 * that are not reduced are spread wholly. */
FACT(amounts_not_proportional_to_volume_are_spread_wholly_in_a_capped_cell)
{
    struct scene s = scene_of(0.35);
    const double f[3] = {1.0, 2.0, 4.0};

    averaging_spread(s.a, 1, f, s.field);
    ck_assert_double_eq_tol(s.field[0], 2.5, 1e-15);
    ck_assert_double_eq_tol(averaging_capped_fraction(s.a, 0),
                            0.35 / 0.39584067435231391, 1e-15);
    ck_assert(averaging_capped_fraction(s.a, 1) == 1.0);
    scene_free(&s);
}

/* Counts are of this bind: the second one starts from zero. */
FACT(a_bind_counts_afresh)
{
    struct scene s = scene_of(0.35);
    ck_assert_int_eq(averaging_bind(s.a), 0);
    ck_assert_int_eq(averaging_report(s.a)->capped, 1);
    s.ps->x[0] = 1.5;
    s.ps->d[1] = 0.1;
    ck_assert_int_eq(averaging_bind(s.a), 0);
    ck_assert_int_eq(averaging_report(s.a)->capped, 0);
    ck_assert(averaging_report(s.a)->lost_volume == 0.0);
    scene_free(&s);
}
