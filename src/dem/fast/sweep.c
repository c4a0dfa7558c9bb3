/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep.c -- the stages of the loop over contacts.
 *
 * A law is one inlined function (contact_respond). The stages are short,
 * because long loops would wait for their own square roots and divisions.
 * Contacts that do not touch are computed and masked, which is cheaper than
 * skipping them. Stages that work on the rows are not inlined, because
 * compilers use `restrict` only for the parameters of a function. */
#include "dem/fast/sweep.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/root.h"
#include "dem/contact_hertz.h"
#include "dem/contact_linear.h"

#define SWEEP_INLINE static inline __attribute__((always_inline))
#define SWEEP_STAGE static __attribute__((noinline))

/* The numbers of a row, for operations that are the same for all: to = a +
 * sign * b, and to += sign * a. */
static inline void sweep_combine(int n, void *restrict row,
                                 const void *restrict row_a,
                                 const double *restrict sign,
                                 const void *restrict row_b)
{
    double *restrict const to = row;
    const double *restrict const a = row_a, *restrict const b = row_b;

#pragma omp simd
    for (int k = 0; k < n; k++)
        to[k] = a[k] + sign[k] * b[k];
}

static inline void sweep_add(struct row_load *restrict row,
                             const double *restrict sign,
                             const struct row_load *restrict row_a)
{
    double *restrict const to = (double *)row;
    const double *restrict const a = (const double *)row_a;

#pragma omp simd
    for (int k = 0; k < 8; k++)
        to[k] += sign[k] * a[k];
}

/* A wall is represented by a sphere of the same radius behind it that touches
 * it, so that even a particle whose centre has passed the wall is pushed back.
 * This sphere has no velocity, and its 1/R and 1/m are 0. */
static inline void sweep_wall_rows(struct sweep_buffers *c, int p,
                                   const struct rows *b, int i, int wall)
{
    const int k = wall / 2, upper = wall % 2;
    const double R = b->place[i].R;
    const double gap = b->place[i].x[k] - (upper ? b->box.hi : b->box.lo)[k];

    c->between[p] = b->motion[i];
    c->separation[p] = (struct row_place){.R = 2.0 * R};
    c->separation[p].x[k] = upper ? gap - R : gap + R;
}

/* Lanes that are left over repeat the first; their loads are not used. */
static inline void sweep_spare_rows(struct sweep_buffers *c, int p)
{
    c->separation[p] = c->separation[0];
    c->between[p] = c->between[0];
}

/* Fills the rows with contacts first ... first + count - 1: positions and
 * velocities are subtracted, R, 1/R, R omega and 1/m are added. */
SWEEP_STAGE void sweep_gather(struct sweep_buffers *restrict c,
                              const struct chunk *s, const struct rows *b,
                              int first, int count)
{
    static const double sign[8] = {-1, -1, -1, 1, 1, 1, 1, 1};
    const int *const i = s->contacts.owner + first;
    const int *const j = s->contacts.partner + first;
    const int pairs = sweep_pairs(s, first, count);

    for (int p = 0; p < pairs; p++) {
        sweep_combine(4, &c->separation[p], &b->place[i[p]], sign,
                      &b->place[j[p]]);
        sweep_combine(8, &c->between[p], &b->motion[i[p]], sign,
                      &b->motion[j[p]]);
    }
    for (int p = pairs; p < count; p++)
        sweep_wall_rows(c, p, b, i[p], j[p]);
    for (int p = count; p < SWEEP_LANES; p++)
        sweep_spare_rows(c, p);
}

SWEEP_STAGE void sweep_into_columns(struct sweep_buffers *restrict c)
{
    const double(*const place)[4] = (void *)c->separation;
    const double(*const row)[8] = (void *)c->between;
    double(*const x)[SWEEP_LANES] = c->x, (*const column)[SWEEP_LANES] = c->v;

#pragma omp simd
    for (int p = 0; p < SWEEP_LANES; p++)
        for (int k = 0; k < 4; k++)
            x[k][p] = place[p][k];
#pragma omp simd
    for (int p = 0; p < SWEEP_LANES; p++)
        for (int k = 0; k < 8; k++)
            column[k][p] = row[p][k];
}

SWEEP_STAGE void sweep_into_rows(struct sweep_buffers *restrict c)
{
    double(*const column)[SWEEP_LANES] = c->F;
    double(*const row)[8] = (void *)c->load;

#pragma omp simd
    for (int p = 0; p < SWEEP_LANES; p++)
        for (int k = 0; k < 8; k++)
            row[p][k] = column[k][p];
}

/* Adds the load of a pair to both: opposite forces, equal torques over R. An
 * index before the chunk's first stands for one after the last of all n
 * (periodic, slowest direction). */
SWEEP_STAGE void sweep_scatter(const struct sweep_buffers *restrict c,
                               struct chunk *s, int first, int count, int n)
{
    static const double own[8] = {1, 1, 1, 1, 1, 1, 1, 1};
    static const double other[8] = {-1, -1, -1, 1, 1, 1, 1, 1};
    const int *const i = s->contacts.owner + first;
    const int *const j = s->contacts.partner + first;
    const int pairs = sweep_pairs(s, first, count);

    for (int p = 0; p < pairs; p++) {
        const int at = j[p] - s->begin;
        sweep_add(chunk_load(s, i[p] - s->begin), own, &c->load[p]);
        sweep_add(chunk_load(s, at < 0 ? at + n : at), other, &c->load[p]);
    }
    for (int p = pairs; p < count; p++)
        sweep_add(chunk_load(s, i[p] - s->begin), own, &c->load[p]);
}

/* 1 if all lanes are alike, as in a bed of equal spheres: then one division or
 * root is enough for all. */
SWEEP_INLINE int sweep_alike(const double *lane)
{
    int differ = 0;

#pragma omp simd reduction(| : differ)
    for (int p = 0; p < SWEEP_LANES; p++)
        differ |= lane[p] != lane[0];
    return !differ;
}

SWEEP_INLINE void sweep_fill(double *restrict to, double x)
{
#pragma omp simd
    for (int p = 0; p < SWEEP_LANES; p++)
        to[p] = x;
}

/* 1 over each of the lanes; and 1 over its root. */
SWEEP_INLINE void sweep_invert(double *restrict to, const double *restrict from)
{
    if (sweep_alike(from)) {
        sweep_fill(to, 1.0 / from[0]);
        return;
    }
#pragma omp simd
    for (int p = 0; p < SWEEP_LANES; p++)
        to[p] = 1.0 / from[p];
}

SWEEP_INLINE void sweep_invert_root(double *restrict to,
                                    const double *restrict from)
{
    if (sweep_alike(from)) {
        sweep_fill(to, 1.0 / sqrt(from[0]));
        return;
    }
#pragma omp simd
    for (int p = 0; p < SWEEP_LANES; p++)
        to[p] = root_inverse(from[p]);
}

/* n, delta and the lever arms. The forces of a pair act in the plane of
 * contact, at the distance r R_i/(R_i + R_j) from x_i: with these arms, not
 * with R_i [LS 4.16], the angular momentum of the pair is conserved. */
SWEEP_INLINE void sweep_frames(struct sweep_buffers *restrict c,
                               const struct box_domain *box, int periodic)
{
    const double *const L = box->length, *const a = box->inverse;
    double per_reach[SWEEP_LANES]; /* [1/m] */

    sweep_invert(per_reach, c->reach);
#pragma omp simd
    for (int p = 0; p < SWEEP_LANES; p++) {
        double dx = c->x[0][p], dy = c->x[1][p], dz = c->x[2][p];
        if (periodic) { /* the nearest image */
            dx -= L[0] * rint(dx * a[0]);
            dy -= L[1] * rint(dy * a[1]);
            dz -= L[2] * rint(dz * a[2]);
        }
        const double r2 = dx * dx + dy * dy + dz * dz;
        const double per_r = root_inverse(r2), r = r2 * per_r;

        c->n[0][p] = dx * per_r;
        c->n[1][p] = dy * per_r;
        c->n[2][p] = dz * per_r;
        c->delta[p] = c->reach[p] - r;
        c->arm[p] = r * per_reach[p];
    }
}

/* One contact by the law; the two that are compiled in have forms for this
 * loop. */
SWEEP_INLINE struct contact_response
sweep_respond(const struct contact_law *law, const struct contact_constants *k,
              double delta, double R_star, double root_m)
{
    if (law == &contact_hertz)
        return contact_hertz_quick(k, delta, R_star, root_m);
    if (law == &contact_linear)
        return contact_linear_quick(k, delta, R_star, root_m);
    return law->respond(k, delta, R_star, root_m * root_m);
}

SWEEP_INLINE void sweep_law(struct sweep_buffers *restrict c,
                            const struct contact_constants *k,
                            const struct contact_law *law, int many, int budget)
{
    double R_star[SWEEP_LANES], root_m[SWEEP_LANES]; /* [m], [kg^1/2] */

    sweep_invert(R_star, c->per_R);
    sweep_invert_root(root_m, c->per_m);
#pragma omp simd
    for (int p = 0; p < SWEEP_LANES; p++) {
        const struct contact_response a =
            sweep_respond(law, many ? &k[c->material_pair[p]] : k, c->delta[p],
                          R_star[p], root_m[p]);

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
        const double vx = c->v[0][p], vy = c->v[1][p], vz = c->v[2][p];
        const double sx = c->s[0][p], sy = c->s[1][p], sz = c->s[2][p];
        const double a = c->arm[p];
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

/* Sends for the rows that the next block reaches for the first time, a few with
 * each group of lanes: all at once would wait for the memory. */
static inline void sweep_fetch(struct chunk *s, const struct rows *b)
{
    for (int k = 0; k < SWEEP_LANES / 2 && s->fetched < s->reached; k++) {
        const int i = (s->begin + s->fetched++) % b->n;
        __builtin_prefetch(&b->place[i]);
        __builtin_prefetch(&b->motion[i]);
    }
}

/* Lanes that ask together whether one of them slides. */
enum { SLIDE_LANES = 8 };

/* 1 for lanes that slide: the squares of the forces say so without a root. */
SWEEP_INLINE void sweep_slides(const struct sweep_buffers *restrict c,
                               const struct contact_constants *k, int many,
                               unsigned char *restrict slides)
{
    const double mu = k->friction;

#pragma omp simd
    for (int p = 0; p < SWEEP_LANES; p++) {
        const double tx = c->F_t[0][p], ty = c->F_t[1][p], tz = c->F_t[2][p];
        const double most =
            (many ? k[c->material_pair[p]].friction : mu) * c->F_n[p];

        slides[p] =
            (tx * tx + ty * ty + tz * tz > most * most) & (c->delta[p] > 0.0);
    }
}

/* Coulomb's limit [LS 4.8]. Where the surfaces slide, xi is reduced until the
 * spring force is no larger than the limit. It is never increased by the limit,
 * because the spring would return energy that no slip stored in it. Then the
 * loads; zero where the pair does not touch. Where no lane slides, nothing is
 * to be limited: `sliding` is 0. */
SWEEP_INLINE void sweep_cap(struct sweep_buffers *restrict c,
                            double *restrict xi_x, double *restrict xi_y,
                            double *restrict xi_z,
                            const struct contact_constants *k, int many,
                            int first, int sliding)
{
    const double mu = k->friction;

#pragma omp simd
    for (int p = first; p < first + SLIDE_LANES; p++) {
        const double tx = c->F_t[0][p], ty = c->F_t[1][p], tz = c->F_t[2][p];
        const double nx = c->n[0][p], ny = c->n[1][p], nz = c->n[2][p];
        const double F_n = c->F_n[p], a = c->arm[p];
        const int touch = c->delta[p] > 0.0;
        double Fx = tx, Fy = ty, Fz = tz;
        double x = xi_x[p], y = xi_y[p], z = xi_z[p];

        if (sliding) {
            const double F_t2 = tx * tx + ty * ty + tz * tz;
            const double most =
                (many ? k[c->material_pair[p]].friction : mu) * fabs(F_n);
            const double k_t = c->k_t[p];
            const int slides = F_t2 > most * most;
            const double cut = slides ? most / sqrt(F_t2) : 1.0;
            const double xi2 = x * x + y * y + z * z;
            const int gives = slides & (k_t * k_t * xi2 > most * most);
            const double per_k = -1.0 / k_t;

            Fx = cut * tx, Fy = cut * ty, Fz = cut * tz;
            x = gives ? per_k * Fx : x;
            y = gives ? per_k * Fy : y;
            z = gives ? per_k * Fz : z;
        }
        xi_x[p] = touch ? x : 0.0;
        xi_y[p] = touch ? y : 0.0;
        xi_z[p] = touch ? z : 0.0;
        c->F[0][p] = touch ? F_n * nx + Fx : 0.0;
        c->F[1][p] = touch ? F_n * ny + Fy : 0.0;
        c->F[2][p] = touch ? F_n * nz + Fz : 0.0;
        c->zero[p] = 0.0;
        c->turn[0][p] = touch ? a * (ny * Fz - nz * Fy) : 0.0;
        c->turn[1][p] = touch ? a * (nz * Fx - nx * Fz) : 0.0;
        c->turn[2][p] = touch ? a * (nx * Fy - ny * Fx) : 0.0;
        c->zero_too[p] = 0.0;
        c->deepest[p] = 1.0 - a > c->deepest[p] ? 1.0 - a : c->deepest[p];
    }
}

SWEEP_INLINE void sweep_limit(struct sweep_buffers *restrict c,
                              double *restrict xi_x, double *restrict xi_y,
                              double *restrict xi_z,
                              const struct contact_constants *k, int many)
{
    unsigned char slides[SWEEP_LANES];
    uint64_t any;

    _Static_assert(sizeof any == SLIDE_LANES, "eight lanes at a time");
    sweep_slides(c, k, many, slides);
    for (int p = 0; p < SWEEP_LANES; p += SLIDE_LANES) {
        memcpy(&any, slides + p, sizeof any);
        if (any != 0)
            sweep_cap(c, xi_x, xi_y, xi_z, k, many, p, 1);
        else
            sweep_cap(c, xi_x, xi_y, xi_z, k, many, p, 0);
    }
}

SWEEP_STAGE void sweep_loads(struct sweep_buffers *restrict c,
                             double *restrict xi_x, double *restrict xi_y,
                             double *restrict xi_z,
                             const struct contact_constants *k)
{
    sweep_limit(c, xi_x, xi_y, xi_z, k, 0);
}

SWEEP_STAGE void sweep_loads_multi_material(struct sweep_buffers *restrict c,
                                            double *restrict xi_x,
                                            double *restrict xi_y,
                                            double *restrict xi_z,
                                            const struct contact_constants *k)
{
    sweep_limit(c, xi_x, xi_y, xi_z, k, 1);
}

static inline void sweep_copy(double *to, const double *from, int n)
{
    memcpy(to, from, (size_t)n * sizeof *to);
}

/* The stages of one group of lanes. */
SWEEP_INLINE void sweep_stages(struct sweep_buffers *c, struct chunk *s,
                               const struct rows *b,
                               const struct contact_constants *k, double dt,
                               int first, int count, double *const xi[3],
                               const struct contact_law *law)
{
    const int loop = b->sweep_options;
    const int many = loop & SWEEP_MULTI_MATERIAL, budget = loop & SWEEP_BUDGET;

    sweep_fetch(s, b);
    sweep_gather(c, s, b, first, count);
    if (b->own_inverse_mass != NULL) sweep_prescribed(c, s, b, first, count);
    sweep_into_columns(c);
    if (loop & SWEEP_PERIODIC)
        sweep_frames(c, &b->box, 1);
    else
        sweep_frames(c, &b->box, 0);
    if (b->ball != NULL) sweep_clumps(c, s, b, first, count);
    if (many) sweep_material_pairs(c, s, b, first, count);
    if (!many)
        sweep_law(c, k, law, 0, 0);
    else if (!budget)
        sweep_law(c, k, law, 1, 0);
    else
        sweep_law(c, k, law, 1, 1);
    sweep_springs(c, xi[0], xi[1], xi[2], dt);
    if (budget)
        sweep_budget(s, c, (const double *const *)xi, k, first, count, dt,
                     b->n);
    (many ? sweep_loads_multi_material : sweep_loads)(c, xi[0], xi[1], xi[2],
                                                      k);
    sweep_into_rows(c);
    sweep_scatter(c, s, first, count, b->n);
    if (loop & SWEEP_ROLLING) sweep_rolling(c, s, b, k, first, count, dt);
}

/* Where lanes are left over at the end, the springs are copied: those behind
 * them belong to other contacts. */
SWEEP_INLINE void sweep_with(struct chunk *s, const struct rows *b,
                             const struct contact_constants *k, double dt,
                             int first, int last, const struct contact_law *law)
{
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
        sweep_stages(&c, s, b, k, dt, first, count, xi, law);
        for (int a = 0; short_of && a < 3; a++)
            sweep_copy(s->contacts.xi[a] + first, xi[a], count);
    }
    for (int p = 0; p < SWEEP_LANES; p++)
        s->max_overlap =
            c.deepest[p] > s->max_overlap ? c.deepest[p] : s->max_overlap;
}

void sweep_contacts(struct chunk *s, const struct rows *b,
                    const struct contact_constants *k, double dt, int first,
                    int last)
{
    if (b->law == &contact_hertz)
        sweep_with(s, b, k, dt, first, last, &contact_hertz);
    else if (b->law == &contact_linear)
        sweep_with(s, b, k, dt, first, last, &contact_linear);
    else
        sweep_with(s, b, k, dt, first, last, b->law);
}
