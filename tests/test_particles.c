/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <gsl/gsl_math.h>
#include <stdlib.h>

#include "facts.h"
#include "spheres.h"

enum { N = 5 };

static struct particles *row_of_five(void)
{
    struct particles *const ps = particles_create(N);

    for (int i = 0; i < N; i++)
        particles_add(ps, (double[3]){i, 10.0 + i, 20.0 + i}, 1.0 + i, 3.0);
    return ps;
}

FACT(a_particle_has_the_mass_of_its_sphere_and_is_at_rest)
{
    struct particles *const ps = row_of_five();

    ck_assert_int_eq(ps->n, N);
    for (int i = 0; i < N; i++) {
        const double R = 0.5 * (1.0 + i);
        const double V = 4.0 / 3.0 * M_PI * R * R * R;
        ck_assert_int_eq(ps->id[i], i);
        ck_assert_double_eq_tol(particles_volume(ps, i), V, 1e-13 * V);
        ck_assert_double_eq_tol(ps->m[i], 3.0 * V, 1e-12 * V);
        ck_assert_double_eq(ps->vx[i], 0.0);
        ck_assert_double_eq(ps->wz[i], 0.0);
        ck_assert_double_eq(ps->ey[i], 0.0);
    }
    particles_free(ps);
}

static const int order[N] = {3, 0, 4, 2, 1};

FACT(a_permutation_takes_every_array_along)
{
    struct particles *const ps = row_of_five();
    double *const own[] = {ps->vx, ps->vy, ps->vz, ps->wx,  ps->wy,  ps->wz,
                           ps->ex, ps->ey, ps->ez, ps->cfx, ps->cfy, ps->cfz};
    const int n_own = sizeof own / sizeof *own;

    for (int a = 0; a < n_own; a++)
        for (int i = 0; i < N; i++)
            own[a][i] = 100.0 * a + i;
    particles_permute(ps, order);
    for (int i = 0; i < N; i++) {
        ck_assert_int_eq(ps->id[i], order[i]);
        ck_assert_double_eq(ps->x[i], order[i]);
        ck_assert_double_eq(ps->y[i], 10.0 + order[i]);
        ck_assert_double_eq(ps->z[i], 20.0 + order[i]);
        ck_assert_double_eq(ps->d[i], 1.0 + order[i]);
        ck_assert_double_eq_tol(ps->m[i], 3.0 * particles_volume(ps, i), 1e-12);
        for (int a = 0; a < n_own; a++)
            ck_assert_double_eq(own[a][i], 100.0 * a + order[i]);
    }
    particles_free(ps);
}

FACT(an_attached_array_follows_until_it_is_detached)
{
    struct particles *const ps = row_of_five();
    double one[N], three[3 * N];

    for (int i = 0; i < N; i++) {
        one[i] = i;
        for (int k = 0; k < 3; k++)
            three[3 * i + k] = 10.0 * i + k;
    }
    particles_attach(ps, "one", "-", one, 1);
    particles_attach(ps, "three", "-", three, 3);
    particles_permute(ps, order);
    particles_detach(ps, one);
    for (int i = 0; i < N; i++) {
        ck_assert_double_eq(one[i], order[i]);
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq(three[3 * i + k], 10.0 * order[i] + k);
    }
    particles_permute(ps, order);
    for (int i = 0; i < N; i++) {
        ck_assert_double_eq(one[i], order[i]); /* stays behind */
        ck_assert_double_eq(three[3 * i], 10.0 * order[order[i]]);
    }
    particles_free(ps);
}

FACT(no_particles_can_be_freed)
{
    particles_free(NULL);
    particles_free(particles_create(0));
}
