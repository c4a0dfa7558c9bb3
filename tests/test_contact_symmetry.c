/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The quantities that an oblique collision of two spinning spheres conserves,
 * and the frames in which it is the same. */

#include "facts.h"
#include "spheres.h"

static struct particles *oblique_pair(int first, double d0, double d1)
{
    struct particles *const ps = particles_create(2);

    for (int k = 0; k < 2; k++) {
        const int one = (k == 0) == (first == 0); /* else the other */
        const int i = one ? spheres_add(ps, -0.006, 0.001, 0.0, d0)
                          : spheres_add(ps, 0.006, -0.001, 0.0, d1);
        const double sign = one ? 1.0 : -1.0;
        spheres_throw(ps, i, sign * 0.5, sign * 0.2, sign * -0.1);
        spheres_spin(ps, i, 5.0, 20.0, -30.0);
    }
    return ps;
}

static struct dem_options rough_options(const struct contact_law *law)
{
    struct dem_options o = spheres_options(law, 5e-6, 0.1);

    o.material.friction = 0.3;
    o.material.restitution = 0.8;
    return o;
}

static void assert_same_bits(const double *a, int i, const double *b, int j)
{
    ck_assert_mem_eq(&a[i], &b[j], sizeof *a);
}

FACT_FOR_EACH(the_order_within_a_pair_does_not_change_a_bit, 2)
{
    const struct dem_options o = rough_options(contact_laws[_i]);
    struct particles *const a = oblique_pair(0, 0.01, 0.013);
    struct particles *const b = oblique_pair(1, 0.01, 0.013);

    spheres_collide(a, &o);
    spheres_collide(b, &o);
    for (int id = 0; id < 2; id++) {
        const int i = spheres_place(a, id), j = spheres_place(b, 1 - id);
        assert_same_bits(a->x, i, b->x, j);
        assert_same_bits(a->y, i, b->y, j);
        assert_same_bits(a->vx, i, b->vx, j);
        assert_same_bits(a->vz, i, b->vz, j);
        assert_same_bits(a->wx, i, b->wx, j);
        assert_same_bits(a->wz, i, b->wz, j);
    }
    particles_free(a);
    particles_free(b);
}

FACT_FOR_EACH(ls_4_16_equal_spheres_leave_with_opposite_velocities_bit_for_bit,
              2)
{
    const struct dem_options o = rough_options(contact_laws[_i]);
    struct particles *const ps = oblique_pair(0, 0.01, 0.01);

    spheres_collide(ps, &o);
    ck_assert_double_gt(fabs(ps->vy[0] - 0.2), 0.01); /* they did collide */
    ck_assert_double_eq(ps->vx[0], -ps->vx[1]);
    ck_assert_double_eq(ps->vy[0], -ps->vy[1]);
    ck_assert_double_eq(ps->vz[0], -ps->vz[1]);
    ck_assert_double_eq(ps->wx[0], ps->wx[1]);
    particles_free(ps);
}

FACT_FOR_EACH(a_collision_keeps_momentum_to_rounding, 2)
{
    const struct dem_options o = rough_options(contact_laws[_i]);
    struct particles *const ps = oblique_pair(0, 0.01, 0.013);
    double p[2][3];

    for (int when = 0; when < 2; when++) {
        const double *const v[3] = {ps->vx, ps->vy, ps->vz};
        for (int a = 0; a < 3; a++)
            p[when][a] = ps->m[0] * v[a][0] + ps->m[1] * v[a][1];
        if (when == 0) spheres_collide(ps, &o);
    }
    /* Some 200 steps, each rounding velocities of 0.5 m/s to 1e-16. */
    for (int a = 0; a < 3; a++)
        ck_assert_double_eq_tol(p[1][a], p[0][a], 1e-14 * ps->m[1]);
    particles_free(ps);
}

/* Angular momentum about the origin, of the centres and of the spins [kg
 * m^2/s], along direction k. */
static double turning(const struct particles *ps, int k)
{
    const double *const x[3] = {ps->x, ps->y, ps->z};
    const double *const v[3] = {ps->vx, ps->vy, ps->vz};
    const double *const w[3] = {ps->wx, ps->wy, ps->wz};
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    double L = 0.0;

    for (int i = 0; i < ps->n; i++)
        L += ps->m[i] * (x[a][i] * v[b][i] - x[b][i] * v[a][i] +
                         0.1 * ps->d[i] * ps->d[i] * w[k][i]);
    return L;
}

/* The levers reach to the plane of contact and add up to the distance of the
 * centres. With R_i and R_j instead [LS 4.16], a hundredth would be missing. */
FACT_FOR_EACH(ls_4_16_a_collision_keeps_angular_momentum_to_rounding, 2)
{
    const struct dem_options o = rough_options(contact_laws[_i]);
    struct particles *const ps = oblique_pair(0, 0.01, 0.013);
    double L[3];

    for (int k = 0; k < 3; k++)
        L[k] = turning(ps, k);
    spheres_collide(ps, &o);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(turning(ps, k), L[k],
                                1e-14 * ps->m[1] * 0.0065);
    ck_assert_double_gt(fabs(ps->wz[0] + 30.0), 1.0); /* spins have changed */
    particles_free(ps);
}

/* q turned by the rotation that takes x to (2 1 2)/3, y to (-2 2 1)/3, z to
 * (-1 -2 2)/3. */
static void turn(double *x, double *y, double *z)
{
    const double a = *x, b = *y, c = *z;

    *x = (2.0 * a - 2.0 * b - c) / 3.0;
    *y = (a + 2.0 * b - 2.0 * c) / 3.0;
    *z = (2.0 * a + b + 2.0 * c) / 3.0;
}

static void turn_all(struct particles *ps)
{
    for (int i = 0; i < ps->n; i++) {
        turn(&ps->x[i], &ps->y[i], &ps->z[i]);
        turn(&ps->vx[i], &ps->vy[i], &ps->vz[i]);
        turn(&ps->wx[i], &ps->wy[i], &ps->wz[i]);
    }
}

/* Rounding differs, and the collision hardly amplifies it. A component left
 * out, or a spring not turned with n, would show in the third digit. */
FACT_FOR_EACH(ls_4_8_a_collision_is_the_same_in_a_turned_and_moving_frame, 2)
{
    const struct dem_options o = rough_options(contact_laws[_i]);
    struct particles *const here = oblique_pair(0, 0.01, 0.013);
    struct particles *const there = oblique_pair(0, 0.01, 0.013);

    turn_all(there);
    for (int i = 0; i < 2; i++)
        there->vx[i] += 1.0;
    spheres_collide(here, &o);
    spheres_collide(there, &o);
    turn_all(here);
    for (int id = 0; id < 2; id++) {
        const int i = spheres_place(here, id), j = spheres_place(there, id);
        ck_assert_double_eq_tol(here->vx[i] + 1.0, there->vx[j], 1e-11);
        ck_assert_double_eq_tol(here->vy[i], there->vy[j], 1e-11);
        ck_assert_double_eq_tol(here->vz[i], there->vz[j], 1e-11);
        ck_assert_double_eq_tol(here->wx[i], there->wx[j], 1e-8);
        ck_assert_double_eq_tol(here->wy[i], there->wy[j], 1e-8);
        ck_assert_double_eq_tol(here->wz[i], there->wz[j], 1e-8);
    }
    particles_free(here);
    particles_free(there);
}
