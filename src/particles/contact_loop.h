/* contact_loop.h -- the loop over touching pairs, for any law.
 *
 * Included by the files of the laws, each of which makes its own loop of it: a
 * law is a function that is known when the loop is compiled, so no call and no
 * choice is left inside.
 */
#ifndef CONTACT_LOOP_H
#define CONTACT_LOOP_H

#include <math.h>

#include "particles/contact.h"
#include "particles/pair_list.h"
#include "particles/particles.h"

typedef void contact_springs(const struct contact_constants *c, double delta,
                             double R, double m, struct springs *s);

/* One contact from both sides. */
struct contact {
    double n[3];     /* [-] from j to i */
    double v[3];     /* [m/s] of surface i relative to surface j */
    double delta;    /* [m] */
    double R, m;     /* [m], [kg] effective */
    double force[3]; /* [N] on i */
    double turn[3];  /* [N] n x F_t */
};

static inline double contact_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void contact_cross(const double a[3], const double b[3],
                                 double c[3])
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

/* The spring is laid into the tangential plane, its length kept, and follows
 * the surfaces for dt. */
static inline void contact_stretch(const struct contact *k, double v_n,
                                   double dt, double s[3])
{
    const double along = contact_dot(s, k->n);
    const double before = contact_dot(s, s);
    const double after = before - along * along;
    const double scale = after > 0.0 ? sqrt(before / after) : 1.0;

    for (int a = 0; a < 3; a++)
        s[a] =
            (s[a] - along * k->n[a]) * scale + (k->v[a] - v_n * k->n[a]) * dt;
}

/* Force and torque from springs and history [LS 4.7, 4.8, 4.10]. */
static inline void contact_force(struct contact *k, const struct springs *p,
                                 double friction, double dt, double s[3])
{
    const double v_n = contact_dot(k->v, k->n);
    const double F_n = p->elastic - p->eta_n * v_n;
    double F_t[3];

    contact_stretch(k, v_n, dt, s);
    for (int a = 0; a < 3; a++)
        F_t[a] = -p->k_t * s[a] - p->eta_t * (k->v[a] - v_n * k->n[a]);
    const double cap = friction * fabs(F_n), size2 = contact_dot(F_t, F_t);
    if (size2 > cap * cap) { /* slides: the spring keeps what the cap allows */
        const double cut = cap / sqrt(size2);
        for (int a = 0; a < 3; a++) {
            F_t[a] *= cut;
            s[a] = -(F_t[a] + p->eta_t * (k->v[a] - v_n * k->n[a])) / p->k_t;
        }
    }
    contact_cross(k->n, F_t, k->turn);
    for (int a = 0; a < 3; a++)
        k->force[a] = F_n * k->n[a] + F_t[a];
}

/* Distance of two centres, round the period if there is one. */
static inline double contact_image(double dx, double period)
{
    return period > 0.0 ? dx - period * rint(dx / period) : dx;
}

/* Geometry of pair i, j whose centres are dx apart, r2 squared. */
static inline void contact_meet(const struct particles *ps, int i, int j,
                                const double dx[3], double r2,
                                struct contact *k)
{
    const double R_i = 0.5 * ps->d[i], R_j = 0.5 * ps->d[j];
    const double r = sqrt(r2), per = 1.0 / r;
    const double w[3] = {R_i * ps->wx[i] + R_j * ps->wx[j],
                         R_i * ps->wy[i] + R_j * ps->wy[j],
                         R_i * ps->wz[i] + R_j * ps->wz[j]};
    double spin[3];

    for (int a = 0; a < 3; a++)
        k->n[a] = dx[a] * per;
    contact_cross(w, k->n, spin);
    k->v[0] = ps->vx[i] - ps->vx[j] - spin[0];
    k->v[1] = ps->vy[i] - ps->vy[j] - spin[1];
    k->v[2] = ps->vz[i] - ps->vz[j] - spin[2];
    k->delta = R_i + R_j - r;
    k->R = R_i * R_j / (R_i + R_j);
    k->m = ps->m[i] * ps->m[j] / (ps->m[i] + ps->m[j]);
}

static inline void contact_note(struct strip_forces *f, double overlap)
{
    f->contacts++;
    if (overlap > f->max_overlap) f->max_overlap = overlap;
}

static inline void contact_add(double *const to[6], int i, double sign,
                               double R, const struct contact *k)
{
    to[0][i] += sign * k->force[0];
    to[1][i] += sign * k->force[1];
    to[2][i] += sign * k->force[2];
    to[3][i] -= R * k->turn[0];
    to[4][i] -= R * k->turn[1];
    to[5][i] -= R * k->turn[2];
}

/* All pairs of a strip. A pair that has parted forgets. */
__attribute__((always_inline)) static inline void
contact_pairs(contact_springs *law, int periodic,
              const struct contact_constants *c, double dt,
              const struct particles *ps, struct pair_list *list, int strip,
              struct strip_forces *f)
{
    const int end = list->particle_start[strip + 1];

    for (int e = list->start[strip]; e < list->start[strip + 1]; e++) {
        const int i = list->i[e], j = list->j[e];
        double dx[3] = {ps->x[i] - ps->x[j], ps->y[i] - ps->y[j],
                        ps->z[i] - ps->z[j]};
        for (int a = 0; a < 3 && periodic; a++)
            dx[a] = contact_image(dx[a], list->period[a]);
        const double reach = 0.5 * (ps->d[i] + ps->d[j]);
        const double r2 = contact_dot(dx, dx);
        if (r2 >= reach * reach) {
            pair_list_forget(list, e);
            continue;
        }
        struct contact k;
        struct springs springs;
        contact_meet(ps, i, j, dx, r2, &k);
        law(c, k.delta, k.R, k.m, &springs);
        contact_force(&k, &springs, c->friction, dt, &list->s[3 * e]);
        list->touching[e] = 1;
        contact_note(f, k.delta / reach);
        contact_add(f->own, i, 1.0, 0.5 * ps->d[i], &k);
        contact_add(j < end ? f->own : f->spill, j, -1.0, 0.5 * ps->d[j], &k);
    }
}

/* All particles near walls in a strip; j is the wall: 2 a + (0 low, 1 high)
 * across direction a. */
__attribute__((always_inline)) static inline void
contact_walls(contact_springs *law, const struct contact_constants *c,
              double dt, const struct particles *ps, struct pair_list *list,
              int strip, struct strip_forces *f)
{
    for (int e = list->start[strip]; e < list->start[strip + 1]; e++) {
        const int i = list->i[e], a = list->j[e] / 2, high = list->j[e] % 2;
        const double R = 0.5 * ps->d[i];
        const double x[3] = {ps->x[i], ps->y[i], ps->z[i]};
        struct contact k = {.n = {0.0, 0.0, 0.0}, .R = R, .m = ps->m[i]};
        struct springs springs;
        k.delta = high ? x[a] + R - list->high[a] : list->low[a] - x[a] + R;
        if (k.delta <= 0.0) {
            pair_list_forget(list, e);
            continue;
        }
        const double w[3] = {R * ps->wx[i], R * ps->wy[i], R * ps->wz[i]};
        double spin[3];
        k.n[a] = high ? -1.0 : 1.0;
        contact_cross(w, k.n, spin);
        k.v[0] = ps->vx[i] - spin[0];
        k.v[1] = ps->vy[i] - spin[1];
        k.v[2] = ps->vz[i] - spin[2];
        law(c, k.delta, k.R, k.m, &springs);
        contact_force(&k, &springs, c->friction, dt, &list->s[3 * e]);
        list->touching[e] = 1;
        contact_note(f, k.delta / (2.0 * R));
        contact_add(f->own, i, 1.0, R, &k);
    }
}

#endif
