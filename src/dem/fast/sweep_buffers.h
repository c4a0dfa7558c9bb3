/* sweep_buffers.h -- buffers that transpose contacts for vector loops.
 * Chapter "Particles and contact".
 *
 * The input of a contact is the difference of the rows of its two particles
 * (bodies.h). For SWEEP_LANES contacts at a time, these rows are transposed
 * into columns, one array for each quantity, for vector loops; the loads are
 * computed as columns and transposed into rows, which are added to the
 * particles. The buffers stay in the first-level cache.
 *
 * Each stage is a separate function that is not inlined, because compilers use
 * `restrict` only for the parameters of a function.
 */
#ifndef DEM_FAST_SWEEP_BUFFERS_H
#define DEM_FAST_SWEEP_BUFFERS_H

#include <string.h>

#include "dem/fast/chunk.h"

#define SWEEP_STAGE static __attribute__((noinline, unused))

enum { SWEEP_LANES = 64 };

struct sweep_buffers {
    double separation[SWEEP_LANES][4]; /* [m] x_i - x_j, R_i + R_j */
    double row[SWEEP_LANES]
              [8]; /* in: v_i - v_j [m/s], 1/R* [1/m], R_i omega_i + R_j omega_j
                      [m/s], 1/m* [1/kg]; out: as the loads of struct chunk */
    double x[4][SWEEP_LANES];      /* the columns of separation */
    double column[8][SWEEP_LANES]; /* and of row, in and out */
    double n[3][SWEEP_LANES];      /* [-] from j to i */
    double delta[SWEEP_LANES];     /* [m] overlap */
    double arm[SWEEP_LANES];       /* [-] r / (R_i + R_j) */
    double elastic[SWEEP_LANES];   /* [N] */
    double stored[SWEEP_LANES];    /* [J] set in loops with an energy budget */
    double F_n[SWEEP_LANES];       /* [N] along n */
    double k_t[SWEEP_LANES];       /* [N/m] */
    double eta_n[SWEEP_LANES], eta_t[SWEEP_LANES]; /* [kg/s] */
    double F_t[3][SWEEP_LANES];     /* [N] before Coulomb's cap */
    double deepest[SWEEP_LANES];    /* [-] largest delta / (R_i + R_j) */
    int material_pair[SWEEP_LANES]; /* [-] place of the pair of materials in
                              their table; where there are several */
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

/* A wall is represented by a sphere of the same radius behind it that touches
 * it, so that even a particle whose centre has passed the wall is pushed back.
 * This sphere has no velocity, and its 1/R and 1/m are 0. */
static inline void sweep_wall_rows(struct sweep_buffers *c, int p,
                                   const struct bodies *b, int i, int wall)
{
    const int k = wall / 2, upper = wall % 2;
    const double R = b->position_radius[i][3];
    const double gap =
        b->position_radius[i][k] - (upper ? b->box.hi : b->box.lo)[k];

    memcpy(c->row[p], b->velocity[i], sizeof c->row[p]);
    memset(c->separation[p], 0, sizeof c->separation[p]);
    c->separation[p][k] = upper ? gap - R : gap + R;
    c->separation[p][3] = 2.0 * R;
}

/* Of contacts first ... first + count - 1, how many are pairs. */
static inline int sweep_pairs(const struct chunk *s, int first, int count)
{
    const int left = s->contacts.n_pairs - first;
    return left < 0 ? 0 : left < count ? left : count;
}

/* Lanes that are left over have two spheres with a gap as wide as the sum of
 * their radii. In a box that is periodic in x their centres are a quarter of it
 * apart, so that the nearest image is the sphere itself. */
static inline void sweep_spare_rows(struct sweep_buffers *c, int p,
                                    const struct box_domain *box)
{
    static const double still[8] = {0, 0, 0, 1, 0, 0, 0, 1};
    const double apart = box->periodic[0] ? 0.25 * box->length[0] : 2.0;
    const double place[4] = {apart, 0.0, 0.0, 0.5 * apart};

    memcpy(c->separation[p], place, sizeof place);
    memcpy(c->row[p], still, sizeof still);
}

/* Fills the rows with contacts first ... first + count - 1: positions and
 * velocities are subtracted, R, 1/R, R omega and 1/m are added. */
SWEEP_STAGE void sweep_gather(struct sweep_buffers *restrict c,
                              const struct chunk *s, const struct bodies *b,
                              int first, int count)
{
    static const double sign[8] = {-1, -1, -1, 1, 1, 1, 1, 1};
    const int *const i = s->contacts.owner + first;
    const int *const j = s->contacts.partner + first;
    const int pairs = sweep_pairs(s, first, count);

    for (int p = 0; p < pairs; p++) {
        sweep_combine(4, c->separation[p], b->position_radius[i[p]], sign,
                      b->position_radius[j[p]]);
        sweep_combine(8, c->row[p], b->velocity[i[p]], sign, b->velocity[j[p]]);
    }
    for (int p = pairs; p < count; p++)
        sweep_wall_rows(c, p, b, i[p], j[p]);
    for (int p = count; p < SWEEP_LANES; p++)
        sweep_spare_rows(c, p, &b->box);
}

/* 1/m of both spheres of a contact, for its dashpots; of a wall, j = -1, it is
 * 0. Where both move as prescribed, or one touches a wall, no mass is free to
 * move: the dashpots are those of spheres that are. */
static inline void sweep_inverse_masses(const struct bodies *b, int i, int j,
                                        double per_mass[2])
{
    const double *const own = b->own_inverse_mass;
    const int fixed = own != NULL && own[i] > 0.0 && (j < 0 || own[j] > 0.0);

    per_mass[0] = fixed ? own[i] : b->velocity[i][7];
    per_mass[1] = j < 0 ? 0.0 : fixed ? own[j] : b->velocity[j][7];
}

SWEEP_STAGE void sweep_prescribed(struct sweep_buffers *restrict c,
                                  const struct chunk *s, const struct bodies *b,
                                  int first, int count)
{
    const int pairs = sweep_pairs(s, first, count);
    double per_mass[2];

    for (int p = 0; p < count; p++) {
        sweep_inverse_masses(b, s->contacts.owner[first + p],
                             p < pairs ? s->contacts.partner[first + p] : -1,
                             per_mass);
        c->row[p][7] = per_mass[0] + per_mass[1];
    }
}

SWEEP_STAGE void sweep_into_columns(struct sweep_buffers *restrict c)
{
#pragma omp simd
    for (int p = 0; p < SWEEP_LANES; p++)
        for (int k = 0; k < 4; k++)
            c->x[k][p] = c->separation[p][k];
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
        sweep_add(s->load[i[p] - s->begin], own, c->row[p]);
        sweep_add(s->load[at < 0 ? at + n : at], other, c->row[p]);
    }
    for (int p = pairs; p < count; p++)
        sweep_add(s->load[i[p] - s->begin], own, c->row[p]);
}

/* The materials of contacts first ... first + count - 1. A wall has its own. */
SWEEP_STAGE void sweep_material_pairs(struct sweep_buffers *restrict c,
                                      const struct chunk *s,
                                      const struct bodies *b, int first,
                                      int count)
{
    const int *const i = s->contacts.owner + first;
    const int *const j = s->contacts.partner + first;
    const int *const material = b->material;
    const int pairs = sweep_pairs(s, first, count), n = b->n_materials;

    memset(c->material_pair, 0, sizeof c->material_pair);
    for (int p = pairs; p < count; p++)
        c->material_pair[p] = b->wall_material;
    if (material == NULL) return; /* all are of material 0 */
    for (int p = 0; p < pairs; p++)
        c->material_pair[p] = material[i[p]] * n + material[j[p]];
    for (int p = pairs; p < count; p++)
        c->material_pair[p] += material[i[p]] * n;
}

#endif
