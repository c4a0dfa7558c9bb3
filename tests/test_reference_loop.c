/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The motion of the particles once more, as plainly as possible: all pairs, one
 * after the other, without lists, rows, lanes or chunks. The methods of
 * chapters 2, 3 and 18 for speed must not change the result. */
#include <stdlib.h>

#include "dem/materials.h"
#include "facts.h"
#include "spheres.h"

enum { N = 150, WALLS = 6 };

struct plain {
    const struct dem_options *o;
    struct contact_constants k;
    double x[N][3], v[N][3], w[N][3], R[N], m[N], push[N][3];
    double F[N][3], T[N][3];
    double xi[N][N + WALLS][3]; /* [m] of i against j > i, or a wall */
};

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double c[3])
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

/* Normal force [N]; k_t [N/m], eta_t [kg/s]: the two laws as printed. */
static double normal_force(const struct plain *p, double delta, double R_star,
                           double m_star, double v_n, double *k_t,
                           double *eta_t)
{
    const int hertz = p->o->law == &contact_hertz;
    const double E = p->k.normal, root = sqrt(R_star * delta);
    const double slope = hertz ? 2.0 * E * root : p->k.normal;
    const double elastic = hertz ? 4.0 / 3.0 * E * root * delta : slope * delta;
    const double eta = 2.0 * p->k.damping_n * sqrt(slope * m_star) *
                       (hertz ? sqrt(5.0 / 6.0) : 1.0);

    *k_t = hertz ? 8.0 * p->k.tangential * root : p->k.tangential;
    *eta_t = p->k.damping_t * eta;
    return elastic - eta * v_n;
}

/* Spring, dashpot, cap: F_t [N], and the spring as it is afterwards. */
static void friction(double F_t[3], double xi[3], const double v_t[3],
                     const double n[3], double k_t, double eta_t, double most,
                     double dt)
{
    const double out = dot(xi, n);

    for (int a = 0; a < 3; a++) {
        xi[a] += v_t[a] * dt - out * n[a];
        F_t[a] = -k_t * xi[a] - eta_t * v_t[a];
    }
    const double size = sqrt(dot(F_t, F_t));
    if (size <= most) return;
    const int gives = k_t * sqrt(dot(xi, xi)) > most;
    for (int a = 0; a < 3; a++) {
        F_t[a] *= most / size;
        if (gives) xi[a] = -F_t[a] / k_t;
    }
}

/* Sphere i against sphere j, or against a wall (j < 0). r: from the other's
 * centre or mirror image to i's; sum: R_i + R_j. */
static void contact(struct plain *p, int i, int j, const double r[3],
                    double sum, double xi[3], double dt)
{
    const double length = sqrt(dot(r, r)), delta = sum - length;
    const double R_star = j < 0 ? p->R[i] : p->R[i] * p->R[j] / sum;
    const double m_star =
        j < 0 ? p->m[i] : p->m[i] * p->m[j] / (p->m[i] + p->m[j]);
    double n[3], v[3], spin[3], roll[3], F_t[3], T[3], k_t, eta_t;

    if (delta <= 0.0) {
        xi[0] = xi[1] = xi[2] = 0.0;
        return;
    }
    for (int a = 0; a < 3; a++) {
        n[a] = r[a] / length;
        v[a] = p->v[i][a] - (j < 0 ? 0.0 : p->v[j][a]);
        spin[a] = p->R[i] * p->w[i][a] + (j < 0 ? 0.0 : p->R[j] * p->w[j][a]);
    }
    cross(spin, n, roll);
    const double v_n = dot(v, n);
    for (int a = 0; a < 3; a++)
        v[a] -= v_n * n[a] + length / sum * roll[a];
    const double F_n =
        normal_force(p, delta, R_star, m_star, v_n, &k_t, &eta_t);
    friction(F_t, xi, v, n, k_t, eta_t, p->k.friction * fabs(F_n), dt);
    cross(n, F_t, T);
    for (int a = 0; a < 3; a++) {
        const double F = F_n * n[a] + F_t[a];
        p->F[i][a] += F;
        p->T[i][a] -= p->R[i] * length / sum * T[a];
        if (j >= 0) p->F[j][a] -= F;
        if (j >= 0) p->T[j][a] -= p->R[j] * length / sum * T[a];
    }
}

static void forces(struct plain *p, double dt)
{
    memset(p->F, 0, sizeof p->F);
    memset(p->T, 0, sizeof p->T);
    for (int i = 0; i < N; i++) {
        for (int j = i + 1; j < N; j++) {
            const double r[3] = {p->x[i][0] - p->x[j][0],
                                 p->x[i][1] - p->x[j][1],
                                 p->x[i][2] - p->x[j][2]};
            contact(p, i, j, r, p->R[i] + p->R[j], p->xi[i][j], dt);
        }
        for (int wall = 0; wall < WALLS; wall++) {
            const int a = wall / 2, upper = wall % 2;
            double r[3] = {0.0, 0.0, 0.0};
            r[a] = p->x[i][a] - (upper ? p->o->hi : p->o->lo)[a] +
                   (upper ? -p->R[i] : p->R[i]);
            contact(p, i, -1, r, 2.0 * p->R[i], p->xi[i][N + wall], dt);
        }
    }
}

static void move(struct plain *p, double kick, double drift)
{
    for (int i = 0; i < N; i++)
        for (int a = 0; a < 3; a++) {
            p->v[i][a] += kick * (p->F[i][a] / p->m[i] + p->push[i][a]);
            p->w[i][a] +=
                kick * p->T[i][a] / (0.4 * p->m[i] * p->R[i] * p->R[i]);
            p->x[i][a] += drift * p->v[i][a];
        }
}

static void run(struct plain *p, int steps)
{
    const double dt = p->o->step;

    forces(p, 0.0);
    move(p, 0.5 * dt, dt);
    for (int k = 1; k <= steps; k++) {
        forces(p, dt);
        move(p, k < steps ? dt : 0.5 * dt, k < steps ? dt : 0.0);
    }
}

static struct plain *copied(const struct dem_options *o,
                            const struct particles *ps)
{
    const struct material_pair pair = materials_same(&o->material);
    struct plain *const p = calloc(1, sizeof *p);

    p->o = o;
    p->k = o->law->constants(&pair);
    for (int i = 0; i < N; i++) {
        const double row[9] = {ps->x[i],  ps->y[i],  ps->z[i],
                               ps->vx[i], ps->vy[i], ps->vz[i],
                               ps->wx[i], ps->wy[i], ps->wz[i]};
        memcpy(p->x[i], row, sizeof p->x[i]);
        memcpy(p->v[i], row + 3, sizeof p->v[i]);
        memcpy(p->w[i], row + 6, sizeof p->w[i]);
        p->R[i] = 0.5 * ps->d[i];
        p->m[i] = ps->m[i];
        p->push[i][1] = ps->ey[i] / ps->m[i];
    }
    return p;
}

/* Two sizes, thrown together in a small box with friction and gravity: some
 * hundred contacts at a time. Rounding grows by a factor at every impact; after
 * 2000 steps it is some 1e-11 of a diameter. Any contact that is missed, done
 * twice, or with the wrong spring is 1e-3. */
START_TEST(the_fast_loop_agrees_with_the_reference_loop)
{
    struct dem_options o = spheres_options(contact_laws[_i], 4e-6, 0.0);
    struct particles *const ps = particles_create(N);
    struct dem_report r;
    uint64_t seed = 3;

    o.material.friction = 0.3;
    o.material.restitution = 0.5;
    for (int a = 0; a < 3; a++) {
        o.lo[a] = 0.0;
        o.hi[a] = 14e-3;
    }
    for (int i = 0; i < N; i++) {
        const double x[3] = {2.3e-3 * (i % 6 + 0.55), 2.3e-3 * (i / 36 + 0.55),
                             2.3e-3 * (i / 6 % 6 + 0.55)};
        particles_add(ps, x, i % 2 ? 2e-3 : 2.28e-3, 2000.0);
        ps->ey[i] = -200.0 * ps->m[i];
        spheres_throw(ps, i, 0.3 * spheres_random(&seed),
                      -0.5 + 0.3 * spheres_random(&seed),
                      0.3 * spheres_random(&seed));
        spheres_spin(ps, i, 50.0 * spheres_random(&seed), 0.0, 0.0);
    }
    struct plain *const p = copied(&o, ps);
    struct dem *const dem = dem_create(ps, &o);
    run(p, 2000);
    ck_assert_int_eq(dem_run(dem, 2000, &r), 0);
    ck_assert_int_gt(r.contacts, 60);
    for (int i = 0; i < N; i++) {
        const int at = spheres_place(ps, i);
        ck_assert_double_eq_tol(ps->x[at], p->x[i][0], 1e-10);
        ck_assert_double_eq_tol(ps->y[at], p->x[i][1], 1e-10);
        ck_assert_double_eq_tol(ps->z[at], p->x[i][2], 1e-10);
        ck_assert_double_eq_tol(ps->wx[at], p->w[i][0], 1e-4);
    }
    dem_free(dem);
    particles_free(ps);
    free(p);
}
END_TEST

FACTS("plain")
{
    FACT_FOR_EACH(the_fast_loop_agrees_with_the_reference_loop, 2);
}
