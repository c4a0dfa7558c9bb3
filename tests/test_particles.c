/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The structure of arrays: every array follows when particles change places. */
#include <check.h>
#include <gsl/gsl_math.h>

#include "particles/particles.h"

enum { N = 7 };

static struct particles *seven(void)
{
    struct particles *const ps = particles_create(N);

    for (int i = 0; i < N; i++) {
        particles_add(ps, (const double[3]){0.1 * i, 0.2 * i, 0.3 * i},
                      1e-3 * (i + 1), 1000.0);
        ps->wy[i] = 7.0 * i;
        ps->cfz[i] = -1.0 * i;
    }
    return ps;
}

START_TEST(sphere_has_the_mass_of_its_volume)
{
    struct particles *const ps = seven();
    ck_assert_double_eq_tol(particles_volume(ps, 1) / (M_PI / 6.0 * 8e-9), 1.0,
                            1e-15);
    ck_assert_double_eq_tol(ps->m[1] / (M_PI / 6.0 * 8e-6), 1.0, 1e-15);
    particles_free(ps);
}
END_TEST

START_TEST(everything_follows_a_permutation)
{
    static const int order[N] = {3, 0, 6, 2, 1, 5, 4};
    struct particles *const ps = seven();
    double eight[8 * N];

    for (int i = 0; i < 8 * N; i++)
        eight[i] = i;
    particles_attach(ps, eight, 8);
    particles_permute(ps, order);
    for (int i = 0; i < N; i++) {
        const int was = order[i];
        ck_assert_int_eq(ps->id[i], was);
        ck_assert_double_eq(ps->x[i], 0.1 * was);
        ck_assert_double_eq(ps->z[i], 0.3 * was);
        ck_assert_double_eq(ps->d[i], 1e-3 * (was + 1));
        ck_assert_double_eq(ps->wy[i], 7.0 * was);
        ck_assert_double_eq(ps->cfz[i], -1.0 * was);
        for (int k = 0; k < 8; k++)
            ck_assert_double_eq(eight[8 * i + k], 8 * was + k);
    }
    particles_free(ps);
}
END_TEST

START_TEST(detached_array_stays_as_it_is)
{
    static const int order[N] = {1, 0, 2, 3, 4, 5, 6};
    struct particles *const ps = seven();
    double a[N] = {0, 1, 2}, b[N] = {0, 1, 2};

    particles_attach(ps, a, 1);
    particles_attach(ps, b, 1);
    particles_detach(ps, a);
    particles_permute(ps, order);
    ck_assert_double_eq(a[0], 0.0);
    ck_assert_double_eq(b[0], 1.0);
    particles_free(ps);
}
END_TEST

START_TEST(no_particles_are_fine)
{
    struct particles *const ps = particles_create(0);
    particles_permute(ps, NULL);
    particles_free(ps);
    particles_free(NULL);
}
END_TEST

int main(void)
{
    Suite *const s = suite_create("particles");
    TCase *const t = tcase_create("core");

    suite_add_tcase(s, t);
    tcase_set_timeout(t, 60);
    tcase_add_test(t, sphere_has_the_mass_of_its_volume);
    tcase_add_test(t, everything_follows_a_permutation);
    tcase_add_test(t, detached_array_stays_as_it_is);
    tcase_add_test(t, no_particles_are_fine);
    SRunner *const r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    const int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed != 0;
}
