/* contact_sweep.h -- the loop over the contacts of a strip.  Chapter 2.
 *
 * The contacts are taken SWEEP_LANES at a time through small buffers that stay
 * in the first-level cache, in short loops that the compiler turns into vector
 * code: rows of differences, normals and overlaps, the law, the tangential
 * spring, the loads. A law is one inlined function (`respond`), and whether
 * there are periodic directions is a constant, so that each law has loops of
 * its own without a question in them. Contacts that do not touch are computed
 * too and masked: cheaper than leaving them out.
 */
#ifndef CONTACT_SWEEP_H
#define CONTACT_SWEEP_H

#include <math.h>
#include <string.h>

#include "particles/contact.h"
#include "particles/strip.h"

#define SWEEP_INLINE static inline __attribute__((always_inline))

enum { SWEEP_LANES = 64 };

/* What a law answers for one contact (contact.h). */
struct sweep_response {
    double elastic;      /* [N] */
    double eta_n, eta_t; /* [kg/s] */
    double k_t;          /* [N/m] */
};

typedef struct sweep_response sweep_respond(const struct contact_constants *k,
                                            double delta, double inverse_R,
                                            double inverse_m);

struct sweep_buffers {
    double place[SWEEP_LANES][4];  /* [m] x_i - x_j, R_i + R_j */
    double motion[SWEEP_LANES][8]; /* v_i - v_j [m/s], 1/R* [1/m], R_i omega_i
                                      + R_j omega_j [m/s], 1/m* [1/kg] */
    double nx[SWEEP_LANES], ny[SWEEP_LANES], nz[SWEEP_LANES]; /* [-] */
    double delta[SWEEP_LANES];                                /* [m] */
    double arm[SWEEP_LANES];                       /* [-] r / (R_i + R_j) */
    double elastic[SWEEP_LANES];                   /* [N] */
    double eta_n[SWEEP_LANES], eta_t[SWEEP_LANES]; /* [kg/s] */
    double k_t[SWEEP_LANES];                       /* [N/m] */
    double F_n[SWEEP_LANES];                       /* [N] along n */
    double vx[SWEEP_LANES], vy[SWEEP_LANES], vz[SWEEP_LANES]; /* [m/s] v_t */
    double Fx[SWEEP_LANES], Fy[SWEEP_LANES], Fz[SWEEP_LANES]; /* [N] F_t */
    double load[SWEEP_LANES][8]; /* [N] as struct strip has it */
    double deepest[SWEEP_LANES]; /* [-] largest delta / (R_i + R_j) so far */
};

/* Particle j against i: differences of what points, sums of what does not. */
SWEEP_INLINE void sweep_pair_rows(struct sweep_buffers *c, int p,
                                  const struct bodies *b, int i, int j)
{
    static const double sign_x[4] = {-1, -1, -1, 1};
    static const double sign_v[8] = {-1, -1, -1, 1, 1, 1, 1, 1};

    for (int k = 0; k < 4; k++)
        c->place[p][k] = b->place[i][k] + sign_x[k] * b->place[j][k];
    for (int k = 0; k < 8; k++)
        c->motion[p][k] = b->motion[i][k] + sign_v[k] * b->motion[j][k];
}

/* Behind the wall lies a sphere of the same radius that touches it: so even a
 * centre that passes the wall is still pushed back. It has no motion, and
 * neither 1/R nor 1/m, as a wall should. */
SWEEP_INLINE void sweep_wall_rows(struct sweep_buffers *c, int p,
                                  const struct bodies *b, int i, int wall)
{
    const int k = wall / 2, upper = wall % 2;
    const double R = b->place[i][3];
    const double gap = b->place[i][k] - (upper ? b->box.hi : b->box.lo)[k];

    memcpy(c->motion[p], b->motion[i], sizeof c->motion[p]);
    memset(c->place[p], 0, sizeof c->place[p]);
    c->place[p][k] = upper ? gap - R : gap + R;
    c->place[p][3] = 2.0 * R;
}

/* Fills the lanes with contacts first ... first + count - 1, and those that
 * are left over with two unit spheres that are a unit apart. */
SWEEP_INLINE void sweep_gather(struct sweep_buffers *c, const struct strip *s,
                               const struct bodies *b, int first, int count)
{
    static const double apart[4] = {2, 0, 0, 1};
    static const double still[8] = {0, 0, 0, 1, 0, 0, 0, 1};
    const int *const i = s->contacts.owner + first;
    const int *const j = s->contacts.partner + first;
    const int left = s->contacts.n_pairs - first;
    const int pairs = left < 0 ? 0 : left < count ? left : count;

    for (int p = 0; p < pairs; p++)
        sweep_pair_rows(c, p, b, i[p], j[p]);
    for (int p = pairs; p < count; p++)
        sweep_wall_rows(c, p, b, i[p], j[p]);
    for (int p = count; p < SWEEP_LANES; p++) {
        memcpy(c->place[p], apart, sizeof apart);
        memcpy(c->motion[p], still, sizeof still);
    }
}

/* n, delta and the lever arms. A pair meets in the plane of contact, which is
 * r R_i/(R_i + R_j) from x_i: with these arms, not with R_i [LS 4.16], the
 * angular momentum of the pair stays what it was. */
SWEEP_INLINE void sweep_frames(struct sweep_buffers *restrict c,
                               const struct domain *box, int periodic)
{
    const double Lx = box->length[0], ax = box->inverse[0];
    const double Ly = box->length[1], ay = box->inverse[1];
    const double Lz = box->length[2], az = box->inverse[2];

#pragma omp simd
    for (int p = 0; p < SWEEP_LANES; p++) {
        double dx = c->place[p][0], dy = c->place[p][1], dz = c->place[p][2];
        if (periodic) { /* the nearest image */
            dx -= Lx * rint(dx * ax);
            dy -= Ly * rint(dy * ay);
            dz -= Lz * rint(dz * az);
        }
        const double r = sqrt(dx * dx + dy * dy + dz * dz);
        const double per_r = 1.0 / r, sum = c->place[p][3];

        c->nx[p] = dx * per_r;
        c->ny[p] = dy * per_r;
        c->nz[p] = dz * per_r;
        c->delta[p] = sum - r;
        c->arm[p] = r / sum;
    }
}

SWEEP_INLINE void sweep_law(struct sweep_buffers *restrict c,
                            const struct contact_constants *k,
                            sweep_respond respond)
{
#pragma omp simd
    for (int p = 0; p < SWEEP_LANES; p++) {
        const struct sweep_response a =
            respond(k, c->delta[p], c->motion[p][3], c->motion[p][7]);

        c->elastic[p] = a.elastic;
        c->eta_n[p] = a.eta_n;
        c->k_t[p] = a.k_t;
        c->eta_t[p] = a.eta_t;
    }
}

/* Velocities, the spring turned into the plane of contact and drawn on, and
 * the tangential force before Coulomb's cap. Turning is a projection: its
 * error is of second order in the angle of one step. */
SWEEP_INLINE void sweep_springs(struct sweep_buffers *restrict c,
                                double *restrict xi_x, double *restrict xi_y,
                                double *restrict xi_z, double dt)
{
#pragma omp simd
    for (int p = 0; p < SWEEP_LANES; p++) {
        const double *const v = c->motion[p];
        const double nx = c->nx[p], ny = c->ny[p], nz = c->nz[p];
        const double v_n = v[0] * nx + v[1] * ny + v[2] * nz;
        const double a = c->arm[p];
        /* v_t = v - v_n n + (l_i omega_i + l_j omega_j) x -n */
        const double vx = v[0] - v_n * nx - a * (v[5] * nz - v[6] * ny);
        const double vy = v[1] - v_n * ny - a * (v[6] * nx - v[4] * nz);
        const double vz = v[2] - v_n * nz - a * (v[4] * ny - v[5] * nx);
        const double out = xi_x[p] * nx + xi_y[p] * ny + xi_z[p] * nz;

        c->F_n[p] = c->elastic[p] - c->eta_n[p] * v_n; /* [LS 4.4, 4.7] */
        xi_x[p] += vx * dt - out * nx;
        xi_y[p] += vy * dt - out * ny;
        xi_z[p] += vz * dt - out * nz;
        c->vx[p] = vx;
        c->vy[p] = vy;
        c->vz[p] = vz;
        c->Fx[p] = -c->k_t[p] * xi_x[p] - c->eta_t[p] * vx; /* [LS 4.8] */
        c->Fy[p] = -c->k_t[p] * xi_y[p] - c->eta_t[p] * vy;
        c->Fz[p] = -c->k_t[p] * xi_z[p] - c->eta_t[p] * vz;
    }
}

/* Coulomb's cap [LS 4.8]: where it cuts the force it cuts the spring as well,
 * to what gives that force. Then the loads, and nothing where none touch. */
SWEEP_INLINE void sweep_loads(struct sweep_buffers *restrict c,
                              double *restrict xi_x, double *restrict xi_y,
                              double *restrict xi_z, double mu)
{
#pragma omp simd
    for (int p = 0; p < SWEEP_LANES; p++) {
        const double F2 =
            c->Fx[p] * c->Fx[p] + c->Fy[p] * c->Fy[p] + c->Fz[p] * c->Fz[p];
        const double F_t = sqrt(F2), most = mu * fabs(c->F_n[p]);
        const int slides = F_t > most, touch = c->delta[p] > 0.0;
        const double cut = slides ? most / F_t : 1.0;
        const double Fx = cut * c->Fx[p], Fy = cut * c->Fy[p];
        const double Fz = cut * c->Fz[p], F_n = c->F_n[p];
        const double per_k = -1.0 / c->k_t[p], eta = c->eta_t[p];
        const double nx = c->nx[p], ny = c->ny[p], nz = c->nz[p];
        const double a = c->arm[p];
        const double x = slides ? per_k * (Fx + eta * c->vx[p]) : xi_x[p];
        const double y = slides ? per_k * (Fy + eta * c->vy[p]) : xi_y[p];
        const double z = slides ? per_k * (Fz + eta * c->vz[p]) : xi_z[p];

        xi_x[p] = touch ? x : 0.0;
        xi_y[p] = touch ? y : 0.0;
        xi_z[p] = touch ? z : 0.0;
        c->load[p][0] = touch ? F_n * nx + Fx : 0.0;
        c->load[p][1] = touch ? F_n * ny + Fy : 0.0;
        c->load[p][2] = touch ? F_n * nz + Fz : 0.0;
        c->load[p][3] = 0.0;
        c->load[p][4] = touch ? a * (ny * Fz - nz * Fy) : 0.0;
        c->load[p][5] = touch ? a * (nz * Fx - nx * Fz) : 0.0;
        c->load[p][6] = touch ? a * (nx * Fy - ny * Fx) : 0.0;
        c->load[p][7] = 0.0;
        c->deepest[p] = 1.0 - a > c->deepest[p] ? 1.0 - a : c->deepest[p];
    }
}

/* Both of a pair have their load: equal and opposite forces, equal torques
 * over R. `n` turns an index before the strip's first into one after the last
 * (periodic, slowest direction). */
SWEEP_INLINE void sweep_scatter(const struct sweep_buffers *c, struct strip *s,
                                int first, int count, int n)
{
    static const double sign[8] = {-1, -1, -1, 1, 1, 1, 1, 1};
    const int *const i = s->contacts.owner + first;
    const int *const j = s->contacts.partner + first;
    const int pairs = s->contacts.n_pairs - first;

    for (int p = 0; p < count; p++) {
        double *const own = s->load[i[p] - s->begin];
        for (int k = 0; k < 8; k++)
            own[k] += c->load[p][k];
        if (p >= pairs) continue;
        const int at = j[p] - s->begin;
        double *const other = s->load[at < 0 ? at + n : at];
        for (int k = 0; k < 8; k++)
            other[k] += sign[k] * c->load[p][k];
    }
}

SWEEP_INLINE void sweep_contacts(struct strip *s, const struct bodies *b,
                                 const struct contact_constants *k, double dt,
                                 sweep_respond respond, int periodic)
{
    const int n = s->contacts.n_pairs + s->contacts.n_walls;
    struct sweep_buffers c;

    memset(c.deepest, 0, sizeof c.deepest);
    memset(s->load, 0, (size_t)s->window * sizeof *s->load);
    for (int first = 0; first < n; first += SWEEP_LANES) {
        const int left = n - first;
        const int count = left < SWEEP_LANES ? left : SWEEP_LANES;
        double *const xi_x = s->contacts.spring[0] + first;
        double *const xi_y = s->contacts.spring[1] + first;
        double *const xi_z = s->contacts.spring[2] + first;

        sweep_gather(&c, s, b, first, count);
        sweep_frames(&c, &b->box, periodic);
        sweep_law(&c, k, respond);
        sweep_springs(&c, xi_x, xi_y, xi_z, dt);
        sweep_loads(&c, xi_x, xi_y, xi_z, k->friction);
        sweep_scatter(&c, s, first, count, b->n);
    }
    for (int p = 0; p < SWEEP_LANES; p++)
        s->deepest = c.deepest[p] > s->deepest ? c.deepest[p] : s->deepest;
}

#endif
