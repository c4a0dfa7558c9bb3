/* same_motion.h -- two runs of the same particles, compared by id. */
#ifndef SAME_MOTION_H
#define SAME_MOTION_H

#include <math.h>

#include "spheres.h"

/* Largest component of x, y, z. */
static inline double same_largest(const double *x, const double *y,
                                  const double *z, int n)
{
    double most = 1e-300;

    for (int i = 0; i < n; i++)
        most = fmax(most, fmax(fabs(x[i]), fmax(fabs(y[i]), fabs(z[i]))));
    return most;
}

static inline void same_vector(const double *const got[3], int i,
                               const double *const want[3], int j, double scale)
{
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(got[k][i], want[k][j], scale);
}

/* Velocities, spins and forces to `tolerance` of the largest of their kind, and
 * positions to that part of L [m], which is also the period of direction k
 * where bit k of `periodic` is set. */
static inline void same_motion(const struct particles *got,
                               const struct particles *want, double L,
                               int periodic, double tolerance)
{
    const double *const v[2][3] = {{got->vx, got->vy, got->vz},
                                   {want->vx, want->vy, want->vz}};
    const double *const w[2][3] = {{got->wx, got->wy, got->wz},
                                   {want->wx, want->wy, want->wz}};
    const double *const F[2][3] = {{got->cfx, got->cfy, got->cfz},
                                   {want->cfx, want->cfy, want->cfz}};
    const double *const x[2][3] = {{got->x, got->y, got->z},
                                   {want->x, want->y, want->z}};
    const int n = want->n;
    const double most[3] = {same_largest(v[1][0], v[1][1], v[1][2], n),
                            same_largest(w[1][0], w[1][1], w[1][2], n),
                            same_largest(F[1][0], F[1][1], F[1][2], n)};

    ck_assert_int_eq(got->n, n);
    for (int i = 0; i < n; i++) {
        const int j = spheres_place(want, got->id[i]);
        ck_assert_int_ge(j, 0);
        same_vector(v[0], i, v[1], j, tolerance * most[0]);
        same_vector(w[0], i, w[1], j, tolerance * most[1]);
        same_vector(F[0], i, F[1], j, tolerance * most[2]);
        for (int k = 0; k < 3; k++) {
            double dx = x[0][k][i] - x[1][k][j];
            if (periodic >> k & 1) dx -= L * rint(dx / L);
            ck_assert_double_eq_tol(dx, 0.0, tolerance * L);
        }
    }
}

static inline void same_report(const struct dem_report *got,
                               const struct dem_report *want, double tolerance)
{
    const double kinetic = want->translation + want->rotation;

    ck_assert_int_eq((int)got->steps, (int)want->steps);
    ck_assert_int_eq(got->contacts, want->contacts);
    ck_assert_int_eq(got->lost, want->lost);
    ck_assert_double_eq_tol(got->max_overlap, want->max_overlap, tolerance);
    ck_assert_double_eq_tol(got->max_speed, want->max_speed,
                            tolerance * want->max_speed);
    ck_assert_double_eq_tol(got->translation + got->rotation, kinetic,
                            tolerance * kinetic);
}

#endif
