/* contact_sweep.h -- the loop over the contacts of a chunk.
 * Chapter "Particles and contact".
 *
 * A law is one inlined function (contact_respond), and the options of a case
 * (CONTACT_PERIODIC and so on) are constants, so that each law has its own
 * loops without branches. The loops are short, because long ones would wait for
 * their own square roots and divisions. Contacts that do not touch are computed
 * and masked, which is cheaper than skipping them.
 */
#ifndef DEM_FAST_CONTACT_SWEEP_H
#define DEM_FAST_CONTACT_SWEEP_H

#include <math.h>

#include "dem/contact.h"
#include "dem/fast/contact_loops.h"
#include "dem/fast/sweep_buffers.h"
#include "dem/fast/sweep_energy.h"
#include "dem/fast/sweep_rolling.h"

#define SWEEP_INLINE static inline __attribute__((always_inline, unused))

/* n, delta and the lever arms. The forces of a pair act in the plane of
 * contact, at the distance r R_i/(R_i + R_j) from x_i: with these arms, not
 * with R_i [LS 4.16], the angular momentum of the pair is conserved. */
SWEEP_INLINE void sweep_frames(struct sweep_buffers *restrict c,
                               const struct box_domain *box, int periodic)
{
    const double *const L = box->length, *const a = box->inverse;

#pragma omp simd
    for (int p = 0; p < SWEEP_LANES; p++) {
        double dx = c->x[0][p], dy = c->x[1][p], dz = c->x[2][p];
        if (periodic) { /* the nearest image */
            dx -= L[0] * rint(dx * a[0]);
            dy -= L[1] * rint(dy * a[1]);
            dz -= L[2] * rint(dz * a[2]);
        }
        const double r = sqrt(dx * dx + dy * dy + dz * dz);
        const double per_r = 1.0 / r, sum = c->x[3][p];

        c->n[0][p] = dx * per_r;
        c->n[1][p] = dy * per_r;
        c->n[2][p] = dz * per_r;
        c->delta[p] = sum - r;
        c->arm[p] = r / sum;
    }
}

SWEEP_INLINE void sweep_law(struct sweep_buffers *restrict c,
                            const struct contact_constants *k,
                            contact_respond respond, int many, int budget)
{
#pragma omp simd
    for (int p = 0; p < SWEEP_LANES; p++) {
        const struct contact_response a =
            respond(many ? &k[c->material_pair[p]] : k, c->delta[p],
                    1.0 / c->column[3][p], 1.0 / c->column[7][p]);

        c->elastic[p] = a.elastic;
        if (budget) c->stored[p] = a.stored;
        c->eta_n[p] = a.eta_n;
        c->k_t[p] = a.k_t;
        c->eta_t[p] = a.eta_t;
    }
}

/* Computes the velocities, projects the tangential displacement xi into the
 * plane of contact, advances it, and computes the tangential force before
 * Coulomb's limit. The error of the projection is of second order in the
 * rotation in one step. */
SWEEP_STAGE void sweep_springs(struct sweep_buffers *restrict c,
                               double *restrict xi_x, double *restrict xi_y,
                               double *restrict xi_z, double dt)
{
#pragma omp simd
    for (int p = 0; p < SWEEP_LANES; p++) {
        const double nx = c->n[0][p], ny = c->n[1][p], nz = c->n[2][p];
        const double vx = c->column[0][p], vy = c->column[1][p];
        const double vz = c->column[2][p], a = c->arm[p];
        const double sx = c->column[4][p], sy = c->column[5][p];
        const double sz = c->column[6][p];
        const double v_n = vx * nx + vy * ny + vz * nz;
        /* v_t = v - v_n n + (l_i omega_i + l_j omega_j) x (-n) */
        const double tx = vx - v_n * nx - a * (sy * nz - sz * ny);
        const double ty = vy - v_n * ny - a * (sz * nx - sx * nz);
        const double tz = vz - v_n * nz - a * (sx * ny - sy * nx);
        const double out = xi_x[p] * nx + xi_y[p] * ny + xi_z[p] * nz;
        const double k_t = c->k_t[p], eta_t = c->eta_t[p];

        c->F_n[p] = c->elastic[p] - c->eta_n[p] * v_n; /* [LS 4.4, 4.7] */
        xi_x[p] += tx * dt - out * nx;
        xi_y[p] += ty * dt - out * ny;
        xi_z[p] += tz * dt - out * nz;
        c->F_t[0][p] = -k_t * xi_x[p] - eta_t * tx; /* [LS 4.8] */
        c->F_t[1][p] = -k_t * xi_y[p] - eta_t * ty;
        c->F_t[2][p] = -k_t * xi_z[p] - eta_t * tz;
    }
}

/* Coulomb's limit [LS 4.8]. Where the surfaces slide, xi is reduced until the
 * spring force is no larger than the limit. It is never increased by the limit,
 * because the spring would return energy that no slip stored in it. Then the
 * loads; zero where the pair does not touch. */
SWEEP_INLINE void sweep_cap(struct sweep_buffers *restrict c,
                            double *restrict xi_x, double *restrict xi_y,
                            double *restrict xi_z,
                            const struct contact_constants *k, int many)
{
    const double mu = k->friction;

#pragma omp simd
    for (int p = 0; p < SWEEP_LANES; p++) {
        const double tx = c->F_t[0][p], ty = c->F_t[1][p], tz = c->F_t[2][p];
        const double nx = c->n[0][p], ny = c->n[1][p], nz = c->n[2][p];
        const double F_n = c->F_n[p], a = c->arm[p];
        const double F_t = sqrt(tx * tx + ty * ty + tz * tz);
        const double most =
            (many ? k[c->material_pair[p]].friction : mu) * fabs(F_n);
        const double k_t = c->k_t[p];
        const int slides = F_t > most, touch = c->delta[p] > 0.0;
        const double cut = slides ? most / F_t : 1.0;
        const double Fx = cut * tx, Fy = cut * ty, Fz = cut * tz;
        const double xi2 =
            xi_x[p] * xi_x[p] + xi_y[p] * xi_y[p] + xi_z[p] * xi_z[p];
        const int gives = slides & (k_t * k_t * xi2 > most * most);
        const double per_k = -1.0 / k_t;
        const double x = gives ? per_k * Fx : xi_x[p];
        const double y = gives ? per_k * Fy : xi_y[p];
        const double z = gives ? per_k * Fz : xi_z[p];

        xi_x[p] = touch ? x : 0.0;
        xi_y[p] = touch ? y : 0.0;
        xi_z[p] = touch ? z : 0.0;
        c->column[0][p] = touch ? F_n * nx + Fx : 0.0;
        c->column[1][p] = touch ? F_n * ny + Fy : 0.0;
        c->column[2][p] = touch ? F_n * nz + Fz : 0.0;
        c->column[3][p] = 0.0;
        c->column[4][p] = touch ? a * (ny * Fz - nz * Fy) : 0.0;
        c->column[5][p] = touch ? a * (nz * Fx - nx * Fz) : 0.0;
        c->column[6][p] = touch ? a * (nx * Fy - ny * Fx) : 0.0;
        c->column[7][p] = 0.0;
        c->deepest[p] = 1.0 - a > c->deepest[p] ? 1.0 - a : c->deepest[p];
    }
}

SWEEP_STAGE void sweep_loads(struct sweep_buffers *restrict c,
                             double *restrict xi_x, double *restrict xi_y,
                             double *restrict xi_z,
                             const struct contact_constants *k)
{
    sweep_cap(c, xi_x, xi_y, xi_z, k, 0);
}

SWEEP_STAGE void sweep_loads_multi_material(struct sweep_buffers *restrict c,
                                            double *restrict xi_x,
                                            double *restrict xi_y,
                                            double *restrict xi_z,
                                            const struct contact_constants *k)
{
    sweep_cap(c, xi_x, xi_y, xi_z, k, 1);
}

static inline void sweep_copy(double *to, const double *from, int n)
{
    memcpy(to, from, (size_t)n * sizeof *to);
}

/* The contacts first ... last - 1 of a chunk, all pairs or all walls. Where
 * lanes are left over at the end, the springs are copied: those behind them
 * belong to other contacts. */
SWEEP_INLINE void sweep_contacts(struct chunk *s, const struct bodies *b,
                                 const struct contact_constants *k, double dt,
                                 int first, int last, contact_respond respond,
                                 int loop)
{
    const int many = (loop & CONTACT_MULTI_MATERIAL) != 0;
    double spare[3][SWEEP_LANES] = {{0.0}};
    struct sweep_buffers c;

    memset(c.deepest, 0, sizeof c.deepest);
    for (; first < last; first += SWEEP_LANES) {
        const int left = last - first, short_of = left < SWEEP_LANES;
        const int count = short_of ? left : SWEEP_LANES;
        double *xi[3];

        for (int a = 0; a < 3; a++) {
            xi[a] = short_of ? spare[a] : s->contacts.xi[a] + first;
            if (short_of) sweep_copy(xi[a], s->contacts.xi[a] + first, count);
        }
        sweep_gather(&c, s, b, first, count);
        if (b->own_inverse_mass != NULL)
            sweep_prescribed(&c, s, b, first, count);
        sweep_into_columns(&c);
        sweep_frames(&c, &b->box, loop & CONTACT_PERIODIC);
        if (many) sweep_material_pairs(&c, s, b, first, count);
        sweep_law(&c, k, respond, many, loop & CONTACT_BUDGET);
        sweep_springs(&c, xi[0], xi[1], xi[2], dt);
        if (loop & CONTACT_BUDGET)
            sweep_budget(s, &c, (const double *const *)xi, k, first, count, dt,
                         b->n);
        (many ? sweep_loads_multi_material : sweep_loads)(&c, xi[0], xi[1],
                                                          xi[2], k);
        sweep_into_rows(&c);
        sweep_scatter(&c, s, first, count, b->n);
        if (loop & CONTACT_ROLLING)
            sweep_rolling(&c, s, b, k, first, count, dt, loop & CONTACT_BUDGET);
        for (int a = 0; short_of && a < 3; a++)
            sweep_copy(s->contacts.xi[a] + first, xi[a], count);
    }
    for (int p = 0; p < SWEEP_LANES; p++)
        s->max_overlap =
            c.deepest[p] > s->max_overlap ? c.deepest[p] : s->max_overlap;
}

#endif
