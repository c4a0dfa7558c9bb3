/* plain_contacts.h -- every pair asked, one number after the other.
 *
 * What the contact loop does in lanes, strips and lists is done here in the
 * plainest way: two loops over all particles, a loop over the walls, the
 * formulas of contact.h, sweep_energy.h and sweep_rolling.h as they are
 * printed. Particles are known by their id.
 */
#ifndef PLAIN_CONTACTS_H
#define PLAIN_CONTACTS_H

#include <stdlib.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "particles/energy.h"
#include "spheres.h"

enum { PLAIN_SPRINGS = 48 }; /* that one particle may own */

struct plain_spring {
    int partner, seen; /* -1 - w: wall w; 1: it touched in this sweep */
    double xi[3], theta[3];
};

struct plain_body {
    double x[3], v[3], w[3]; /* [m], [m/s], [rad/s] */
    double R, m;
    double push[3];       /* [N] from outside */
    double F[3], pull[3]; /* [N] of contacts; of attractions */
    double T[3];          /* [N m] */
    struct plain_spring spring[PLAIN_SPRINGS];
    int n_springs;
};

struct plain {
    int n;
    struct plain_body *body;
    const struct dem_options *o;
    struct contact_constants k;
    double deepest; /* [-] */
    int contacts;   /* [-] of the last sweep */
    struct energy e;
    double stored; /* [J] in tangential springs after the last sweep */
};

static inline struct plain plain_of(const struct particles *ps,
                                    const struct dem_options *o)
{
    const struct material_pair same = materials_alone(&o->material);
    struct plain p = {.n = ps->n, .o = o, .k = o->law->constants(&same)};

    p.body = alloc_zeroed((size_t)p.n, sizeof *p.body);
    for (int i = 0; i < p.n; i++)
        p.body[ps->id[i]] =
            (struct plain_body){.x = {ps->x[i], ps->y[i], ps->z[i]},
                                .v = {ps->vx[i], ps->vy[i], ps->vz[i]},
                                .w = {ps->wx[i], ps->wy[i], ps->wz[i]},
                                .R = 0.5 * ps->d[i],
                                .m = ps->m[i],
                                .push = {ps->ex[i], ps->ey[i], ps->ez[i]}};
    return p;
}

/* Two spheres, or a sphere and the one behind a wall, on their way to a
 * force. */
struct plain_meeting {
    double n[3], delta, arm;          /* [-], [m], [-] r / (R_i + R_j) */
    double R_star, m_star, R[2];      /* [m], [kg]; R of a wall is 0 */
    double v[3], surface[3], turn[3]; /* v_i - v_j, R w + R w, w - w */
    double per_I;                     /* [1/(kg m^2)] 1/I_r */
};

static inline double plain_per_I(const struct plain_body *b)
{
    return 1.0 / (1.4 * b->m * b->R * b->R);
}

/* b = NULL: the wall; x points from the other centre to that of a. */
static inline struct plain_meeting plain_meet(const struct plain_body *a,
                                              const struct plain_body *b,
                                              const double x[3])
{
    const double r = vector_length(x), R = b != NULL ? b->R : a->R;
    struct plain_meeting t = {.delta = a->R + R - r,
                              .arm = r / (a->R + R),
                              .R_star = a->R,
                              .m_star = a->m,
                              .R = {a->R, b != NULL ? R : 0.0},
                              .per_I = plain_per_I(a)};

    if (b != NULL) {
        t.R_star = a->R * R / (a->R + R);
        t.m_star = a->m * b->m / (a->m + b->m);
        t.per_I += plain_per_I(b);
    }
    for (int k = 0; k < 3; k++) {
        t.n[k] = x[k] / r;
        t.v[k] = a->v[k] - (b != NULL ? b->v[k] : 0.0);
        t.turn[k] = a->w[k] - (b != NULL ? b->w[k] : 0.0);
        t.surface[k] = a->R * a->w[k] + (b != NULL ? R * b->w[k] : 0.0);
    }
    return t;
}

struct plain_law {
    double elastic, k_t, eta_n, eta_t;
};

static inline struct plain_law plain_respond(const struct plain *p,
                                             const struct plain_meeting *t)
{
    const struct contact_constants *const k = &p->k;
    struct plain_law l;

    if (p->o->law == &contact_hertz) {
        l.elastic = contact_hertz_force(k->normal, t->R_star, t->delta);
        l.k_t = contact_hertz_tangential(k->tangential, t->R_star, t->delta);
        l.eta_n = contact_hertz_damping(
            k->damping_n, contact_hertz_slope(k->normal, t->R_star, t->delta),
            t->m_star);
    } else {
        l.elastic = contact_linear_force(k->normal, t->delta);
        l.k_t = k->tangential;
        l.eta_n = contact_linear_dashpot(k->damping_n, k->normal, t->m_star);
    }
    l.eta_t = k->damping_t * l.eta_n;
    return l;
}

/* The part of a across n. */
static inline void plain_across(const double a[3], const double n[3],
                                double out[3])
{
    vector_along(a, -vector_dot(a, n), n, out);
}

/* Friction: F_t, and what the budget says of it. */
static inline void plain_slide(struct plain *p, const struct plain_meeting *t,
                               const struct plain_law *l, double F_n,
                               struct plain_spring *s, double dt, double F_t[3])
{
    const double most = p->k.friction * fabs(F_n);
    double v_t[3], old[3], roll[3], cut = 1.0;

    vector_cross(t->surface, t->n, roll);
    plain_across(t->v, t->n, v_t);
    vector_along(v_t, -t->arm, roll, v_t);
    plain_across(s->xi, t->n, old);
    vector_along(old, dt, v_t, s->xi);
    for (int k = 0; k < 3; k++)
        F_t[k] = -l->k_t * s->xi[k] - l->eta_t * v_t[k];
    const int slides = vector_length(F_t) > most;
    if (slides) cut = most / vector_length(F_t);
    for (int k = 0; k < 3; k++)
        F_t[k] *= cut;
    if (slides && l->k_t * vector_length(s->xi) > most)
        for (int k = 0; k < 3; k++)
            s->xi[k] = -F_t[k] / l->k_t;
    const double before = 0.5 * l->k_t * vector_dot(old, old);
    const double left = 0.5 * l->k_t * vector_dot(s->xi, s->xi);
    p->e.tangential += left;
    p->e.released -= before;
    if (slides)
        p->e.slid += before - left - dt * vector_dot(F_t, v_t);
    else
        p->e.damped_t += dt * l->eta_t * vector_dot(v_t, v_t);
}

/* Rolling friction, the moment M on the first of the two. */
static inline void plain_roll(struct plain *p, const struct plain_meeting *t,
                              double k_t, double F_n, struct plain_spring *s,
                              double dt, double M[3])
{
    const double k_r = k_t * t->R_star * t->R_star;
    const double C_r = 2.0 * 0.3 * sqrt(k_r / t->per_I);
    const double most = p->k.rolling * t->R_star * fabs(F_n);
    double w_t[3];

    plain_across(t->turn, t->n, w_t);
    plain_across(s->theta, t->n, s->theta);
    vector_along(s->theta, dt, w_t, s->theta);
    for (int k = 0; k < 3; k++)
        M[k] = -k_r * s->theta[k] - C_r * w_t[k];
    const double size = vector_length(M);
    if (size > most) {
        for (int k = 0; k < 3; k++)
            M[k] *= most / size;
        if (k_r * vector_length(s->theta) > most)
            for (int k = 0; k < 3; k++)
                s->theta[k] = -M[k] / k_r;
    }
    p->e.rolled -= dt * vector_dot(M, t->turn);
}

static inline struct plain_spring *plain_spring(struct plain_body *a, int other)
{
    int q = 0;

    while (q < a->n_springs && a->spring[q].partner != other)
        q++;
    if (q == a->n_springs) {
        ck_assert_int_lt(q, PLAIN_SPRINGS);
        a->spring[a->n_springs++] = (struct plain_spring){.partner = other};
    }
    a->spring[q].seen = 1;
    return &a->spring[q];
}

static inline void plain_touch(struct plain *p, struct plain_body *a,
                               struct plain_body *b, int other,
                               const double x[3], double dt)
{
    const struct plain_meeting t = plain_meet(a, b, x);
    double F_t[3], M[3] = {0.0, 0.0, 0.0}, lever[3];

    if (t.delta <= 0.0) return;
    const struct plain_law l = plain_respond(p, &t);
    const double v_n = vector_dot(t.v, t.n), F_n = l.elastic - l.eta_n * v_n;
    struct plain_spring *const s = plain_spring(a, other);
    plain_slide(p, &t, &l, F_n, s, dt, F_t);
    if (p->k.rolling > 0.0) plain_roll(p, &t, l.k_t, F_n, s, dt, M);
    p->contacts++;
    p->deepest = fmax(p->deepest, 1.0 - t.arm);
    p->e.normal += p->o->law->stored * l.elastic * t.delta;
    p->e.damped_n += dt * l.eta_n * v_n * v_n;
    vector_cross(t.n, F_t, lever);
    for (int k = 0; k < 3; k++) {
        const double F = F_n * t.n[k] + F_t[k];
        a->F[k] += F;
        a->T[k] += M[k] - t.arm * t.R[0] * lever[k];
        if (b == NULL) continue;
        b->F[k] -= F;
        b->T[k] -= M[k] + t.arm * t.R[1] * lever[k];
    }
}

#endif
