/* contact_sweep.h -- the loop over the contacts of a strip.  Chapter 2.
 *
 * A law is one inlined function (`respond`), and what there is in a case
 * (CONTACT_PERIODIC and so on) is a constant, so that each law has loops of its
 * own without a question in them. The loops are short, as long ones would wait
 * for their own roots and divisions. Contacts that do not touch are computed
 * too and masked: cheaper than leaving them out.
 */
#ifndef CONTACT_SWEEP_H
#define CONTACT_SWEEP_H

#include <math.h>

#include "particles/contact.h"
#include "particles/sweep_buffers.h"
#include "particles/sweep_energy.h"
#include "particles/sweep_rolling.h"

#define SWEEP_INLINE static inline __attribute__((always_inline, unused))

/* What a law answers for one contact (contact.h). */
struct sweep_response {
    double elastic;      /* [N] */
    double eta_n, eta_t; /* [kg/s] */
    double k_t;          /* [N/m] */
};

typedef struct sweep_response sweep_respond(const struct contact_constants *k,
                                            double delta, double inverse_R,
                                            double inverse_m);

/* n, delta and the lever arms. A pair meets in the plane of contact, which is
 * r R_i/(R_i + R_j) from x_i: with these arms, not with R_i [LS 4.16], the
 * angular momentum of the pair stays what it was. */
SWEEP_INLINE void sweep_frames(struct sweep_buffers *restrict c,
                               const struct domain *box, int periodic)
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
                            sweep_respond respond, int many)
{
#pragma omp simd
    for (int p = 0; p < SWEEP_LANES; p++) {
        const struct sweep_response a =
            respond(many ? &k[c->kind[p]] : k, c->delta[p], c->column[3][p],
                    c->column[7][p]);

        c->elastic[p] = a.elastic;
        c->eta_n[p] = a.eta_n;
        c->k_t[p] = a.k_t;
        c->eta_t[p] = a.eta_t;
    }
}

/* Velocities, the spring xi turned into the plane of contact and drawn on, and
 * the tangential force before Coulomb's cap. Turning is a projection: its
 * error is of second order in the angle of one step. */
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

/* Coulomb's cap [LS 4.8]. Where the surfaces slide, the spring gives way as
 * well, until it bears no more than the cap. It is never drawn by the cap: it
 * would give back what no slip gave it. Then the loads; nothing where none
 * touch. */
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
        const double most = (many ? k[c->kind[p]].friction : mu) * fabs(F_n);
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

SWEEP_STAGE void sweep_loads_many(struct sweep_buffers *restrict c,
                                  double *restrict xi_x, double *restrict xi_y,
                                  double *restrict xi_z,
                                  const struct contact_constants *k)
{
    sweep_cap(c, xi_x, xi_y, xi_z, k, 1);
}

static inline void sweep_copy(double *to, const double *from, int n)
{
    memcpy(to, from, (size_t)n * sizeof *to);
}

/* The contacts first ... last - 1 of a strip, all pairs or all walls. Where
 * lanes are left over at the end, the springs are copied: those behind them
 * belong to other contacts. */
SWEEP_INLINE void sweep_contacts(struct strip *s, const struct bodies *b,
                                 const struct contact_constants *k, double dt,
                                 int first, int last, sweep_respond respond,
                                 int loop)
{
    const int many = (loop & CONTACT_MANY) != 0;
    double spare[3][SWEEP_LANES] = {{0.0}};
    struct sweep_buffers c;

    memset(c.deepest, 0, sizeof c.deepest);
    for (; first < last; first += SWEEP_LANES) {
        const int left = last - first, short_of = left < SWEEP_LANES;
        const int count = short_of ? left : SWEEP_LANES;
        double *xi[3];

        for (int a = 0; a < 3; a++) {
            xi[a] = short_of ? spare[a] : s->contacts.spring[a] + first;
            if (short_of)
                sweep_copy(xi[a], s->contacts.spring[a] + first, count);
        }
        sweep_gather(&c, s, b, first, count);
        sweep_into_columns(&c);
        sweep_frames(&c, &b->box, loop & CONTACT_PERIODIC);
        if (many) sweep_kinds(&c, s, b, first, count);
        sweep_law(&c, k, respond, many);
        sweep_springs(&c, xi[0], xi[1], xi[2], dt);
        if (loop & CONTACT_BUDGET)
            sweep_budget(&s->energy, &c, (const double *const *)xi, k, count,
                         dt);
        (many ? sweep_loads_many : sweep_loads)(&c, xi[0], xi[1], xi[2], k);
        sweep_into_rows(&c);
        sweep_scatter(&c, s, first, count, b->n);
        if (loop & CONTACT_ROLLING)
            sweep_rolling(&c, s, b, k, first, count, dt, loop & CONTACT_BUDGET);
        for (int a = 0; short_of && a < 3; a++)
            sweep_copy(s->contacts.spring[a] + first, xi[a], count);
    }
    for (int p = 0; p < SWEEP_LANES; p++)
        s->deepest = c.deepest[p] > s->deepest ? c.deepest[p] : s->deepest;
}

/* The loops of a law. */
#define SWEEP_LOOP(number, respond)                                            \
    static void sweep_##number(struct strip *s, const struct bodies *b,        \
                               const struct contact_constants *k, double dt,   \
                               int first, int last)                            \
    {                                                                          \
        sweep_contacts(s, b, k, dt, first, last, respond, number);             \
    }
#define SWEEP_LOOPS(respond)                                                   \
    SWEEP_LOOP(0, respond)                                                     \
    SWEEP_LOOP(1, respond)                                                     \
    SWEEP_LOOP(2, respond)                                                     \
    SWEEP_LOOP(3, respond)                                                     \
    SWEEP_LOOP(6, respond)                                                     \
    SWEEP_LOOP(7, respond)                                                     \
    SWEEP_LOOP(10, respond)                                                    \
    SWEEP_LOOP(11, respond)                                                    \
    SWEEP_LOOP(14, respond)                                                    \
    SWEEP_LOOP(15, respond)
#define SWEEP_LOOPS_TABLE                                                      \
    {                                                                          \
        sweep_0, sweep_1, sweep_2, sweep_3, NULL, NULL, sweep_6, sweep_7,      \
            NULL, NULL, sweep_10, sweep_11, NULL, NULL, sweep_14, sweep_15     \
    }

#endif
