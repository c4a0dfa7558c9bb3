/* sweep_buffers.h -- contacts on their way to vector loops and back. Chapter 2.
 *
 * What a contact needs to know of its two particles is one difference of two
 * rows (bodies.h). SWEEP_LANES contacts at a time, the rows are turned into
 * columns, one number of all contacts after the other, as vector units want
 * them; the loads come back as columns and are turned into rows, which are
 * added to the particles. The buffers stay in the first-level cache.
 *
 * Each step is a function of its own, never inlined, because compilers take
 * `restrict` seriously only at the border of a function.
 */
#ifndef SWEEP_BUFFERS_H
#define SWEEP_BUFFERS_H

#include <string.h>

#include "particles/strip.h"

#define SWEEP_STAGE static __attribute__((noinline, unused))

enum { SWEEP_LANES = 64 };

struct sweep_buffers {
    double place[SWEEP_LANES][4];  /* [m] x_i - x_j, R_i + R_j */
    double row[SWEEP_LANES][8];    /* in: v_i - v_j [m/s], 1/R* [1/m], R_i
                                      omega_i + R_j omega_j [m/s], 1/m* [1/kg];
                                      out: as the loads of struct strip */
    double x[4][SWEEP_LANES];      /* the columns of place */
    double column[8][SWEEP_LANES]; /* and of row, in and out */
    double n[3][SWEEP_LANES];      /* [-] from j to i */
    double delta[SWEEP_LANES];     /* [m] overlap */
    double arm[SWEEP_LANES];       /* [-] r / (R_i + R_j) */
    double elastic[SWEEP_LANES];   /* [N] */
    double F_n[SWEEP_LANES];       /* [N] along n */
    double k_t[SWEEP_LANES];       /* [N/m] */
    double eta_n[SWEEP_LANES], eta_t[SWEEP_LANES]; /* [kg/s] */
    double F_t[3][SWEEP_LANES];  /* [N] before Coulomb's cap */
    double deepest[SWEEP_LANES]; /* [-] largest delta / (R_i + R_j) */
    int kind[SWEEP_LANES];       /* [-] place of the pair of materials in their
                                    table; where there are several */
};

/* to = a + sign * b, and to += sign * a, row by row. */
static inline void sweep_combine(int n, double *restrict to,
                                 const double *restrict a,
                                 const double *restrict sign,
                                 const double *restrict b)
{
#pragma omp simd
    for (int k = 0; k < n; k++)
        to[k] = a[k] + sign[k] * b[k];
}

static inline void sweep_add(double *restrict to, const double *restrict sign,
                             const double *restrict a)
{
#pragma omp simd
    for (int k = 0; k < 8; k++)
        to[k] += sign[k] * a[k];
}

/* Behind the wall lies a sphere of the same radius that touches it: so even a
 * centre that passes the wall is still pushed back. It has no motion, and
 * neither 1/R nor 1/m, as a wall should. */
static inline void sweep_wall_rows(struct sweep_buffers *c, int p,
                                   const struct bodies *b, int i, int wall)
{
    const int k = wall / 2, upper = wall % 2;
    const double R = b->place[i][3];
    const double gap = b->place[i][k] - (upper ? b->box.hi : b->box.lo)[k];

    memcpy(c->row[p], b->motion[i], sizeof c->row[p]);
    memset(c->place[p], 0, sizeof c->place[p]);
    c->place[p][k] = upper ? gap - R : gap + R;
    c->place[p][3] = 2.0 * R;
}

/* Of contacts first ... first + count - 1, how many are pairs. */
static inline int sweep_pairs(const struct strip *s, int first, int count)
{
    const int left = s->contacts.n_pairs - first;
    return left < 0 ? 0 : left < count ? left : count;
}

/* Lanes that are left over have two spheres with a gap as wide as the sum of
 * their radii. In a box that is periodic in x their centres are a quarter of it
 * apart, so that the nearest image is the sphere itself. */
static inline void sweep_spare_rows(struct sweep_buffers *c, int p,
                                    const struct domain *box)
{
    static const double still[8] = {0, 0, 0, 1, 0, 0, 0, 1};
    const double apart = box->periodic[0] ? 0.25 * box->length[0] : 2.0;
    const double place[4] = {apart, 0.0, 0.0, 0.5 * apart};

    memcpy(c->place[p], place, sizeof place);
    memcpy(c->row[p], still, sizeof still);
}

/* Fills the rows with contacts first ... first + count - 1: differences of what
 * points, sums of what does not. */
SWEEP_STAGE void sweep_gather(struct sweep_buffers *restrict c,
                              const struct strip *s, const struct bodies *b,
                              int first, int count)
{
    static const double sign[8] = {-1, -1, -1, 1, 1, 1, 1, 1};
    const int *const i = s->contacts.owner + first;
    const int *const j = s->contacts.partner + first;
    const int pairs = sweep_pairs(s, first, count);

    for (int p = 0; p < pairs; p++) {
        sweep_combine(4, c->place[p], b->place[i[p]], sign, b->place[j[p]]);
        sweep_combine(8, c->row[p], b->motion[i[p]], sign, b->motion[j[p]]);
    }
    for (int p = pairs; p < count; p++)
        sweep_wall_rows(c, p, b, i[p], j[p]);
    for (int p = count; p < SWEEP_LANES; p++)
        sweep_spare_rows(c, p, &b->box);
}

SWEEP_STAGE void sweep_into_columns(struct sweep_buffers *restrict c)
{
#pragma omp simd
    for (int p = 0; p < SWEEP_LANES; p++)
        for (int k = 0; k < 4; k++)
            c->x[k][p] = c->place[p][k];
#pragma omp simd
    for (int p = 0; p < SWEEP_LANES; p++)
        for (int k = 0; k < 8; k++)
            c->column[k][p] = c->row[p][k];
}

SWEEP_STAGE void sweep_into_rows(struct sweep_buffers *restrict c)
{
#pragma omp simd
    for (int p = 0; p < SWEEP_LANES; p++)
        for (int k = 0; k < 8; k++)
            c->row[p][k] = c->column[k][p];
}

/* Both of a pair have their load: opposite forces, equal torques over R. An
 * index before the strip's first stands for one after the last of all n
 * (periodic, slowest direction). */
SWEEP_STAGE void sweep_scatter(const struct sweep_buffers *restrict c,
                               struct strip *s, int first, int count, int n)
{
    static const double own[8] = {1, 1, 1, 1, 1, 1, 1, 1};
    static const double other[8] = {-1, -1, -1, 1, 1, 1, 1, 1};
    const int *const i = s->contacts.owner + first;
    const int *const j = s->contacts.partner + first;
    const int pairs = sweep_pairs(s, first, count);

    for (int p = 0; p < pairs; p++) {
        const int at = j[p] - s->begin;
        sweep_add(s->load[i[p] - s->begin], own, c->row[p]);
        sweep_add(s->load[at < 0 ? at + n : at], other, c->row[p]);
    }
    for (int p = pairs; p < count; p++)
        sweep_add(s->load[i[p] - s->begin], own, c->row[p]);
}

/* The materials of contacts first ... first + count - 1. A wall has its own. */
SWEEP_STAGE void sweep_kinds(struct sweep_buffers *restrict c,
                             const struct strip *s, const struct bodies *b,
                             int first, int count)
{
    const int *const i = s->contacts.owner + first;
    const int *const j = s->contacts.partner + first;
    const int *const material = b->material;
    const int pairs = sweep_pairs(s, first, count), n = b->n_materials;

    memset(c->kind, 0, sizeof c->kind);
    for (int p = pairs; p < count; p++)
        c->kind[p] = b->wall_material;
    if (material == NULL) return; /* all are of material 0 */
    for (int p = 0; p < pairs; p++)
        c->kind[p] = material[i[p]] * n + material[j[p]];
    for (int p = pairs; p < count; p++)
        c->kind[p] += material[i[p]] * n;
}

#endif
