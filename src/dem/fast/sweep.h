/* sweep.h -- the loop over the contacts of a chunk.
 * Chapter "Particles and contact".
 *
 * The input of a contact is the difference of the rows of its two particles
 * (rows.h). For SWEEP_LANES contacts at a time, these rows are transposed
 * into columns, one array for each quantity, for vector loops; the loads are
 * computed as columns and transposed into rows, which are added to the
 * particles. The buffers stay in the first-level cache.
 *
 * Hertz's law and the linear one are compiled into the loop. Any other law is
 * called for each contact, which is slower.
 */
#ifndef DEM_FAST_SWEEP_H
#define DEM_FAST_SWEEP_H

#include "dem/fast/chunk.h"

enum { SWEEP_LANES = 32 };

/* Options of the loop, `sweep_options` of the rows. Each stage asks for them
 * once for all lanes, so that unused options cost nothing. */
enum {
    SWEEP_PERIODIC = 1,       /* there are periodic directions */
    SWEEP_MULTI_MATERIAL = 2, /* constants by a table of material pairs */
    SWEEP_ROLLING = 4,        /* rolling friction; only with the table */
    SWEEP_BUDGET = 8          /* energy budget; only with the table */
};

/* Adds the forces of contacts first ... last - 1 of a chunk of particles, all
 * pairs or all walls, to its loads; the springs advance by dt [s]. With several
 * materials k is a table: row a, column b for materials a and b. */
void sweep_contacts(struct chunk *s, const struct rows *b,
                    const struct contact_constants *k, double dt, int first,
                    int last);

struct sweep_buffers {
    struct row_place separation[SWEEP_LANES]; /* x_i - x_j, R_i + R_j */
    union {
        /* In: v_i - v_j, 1/R*, R_i omega_i + R_j omega_j, 1/m*. */
        struct row_motion between[SWEEP_LANES];
        struct row_load load[SWEEP_LANES]; /* out */
    };
    /* The columns of separation, */
    double x[3][SWEEP_LANES], reach[SWEEP_LANES]; /* [m] */
    union {
        struct { /* of between, */
            double v[3][SWEEP_LANES], per_R[SWEEP_LANES];
            double s[3][SWEEP_LANES], per_m[SWEEP_LANES];
        };
        struct { /* and of load */
            double F[3][SWEEP_LANES], zero[SWEEP_LANES];
            double turn[3][SWEEP_LANES], zero_too[SWEEP_LANES];
        };
    };
    double n[3][SWEEP_LANES];    /* [-] from j to i */
    double delta[SWEEP_LANES];   /* [m] overlap */
    double arm[SWEEP_LANES];     /* [-] r / (R_i + R_j) */
    double elastic[SWEEP_LANES]; /* [N] */
    double stored[SWEEP_LANES];  /* [J] set in loops with an energy budget */
    double F_n[SWEEP_LANES];     /* [N] along n */
    double k_t[SWEEP_LANES];     /* [N/m] */
    double eta_n[SWEEP_LANES], eta_t[SWEEP_LANES]; /* [kg/s] */
    double F_t[3][SWEEP_LANES];     /* [N] before Coulomb's cap */
    double deepest[SWEEP_LANES];    /* [-] largest delta / (R_i + R_j) */
    int material_pair[SWEEP_LANES]; /* [-] place of the pair of materials in
                              their table; where there are several */
};

/* Of contacts first ... first + count - 1, how many are pairs. */
static inline int sweep_pairs(const struct chunk *s, int first, int count)
{
    const int left = s->contacts.n_pairs - first;
    return left < 0 ? 0 : left < count ? left : count;
}

/* 1/m of both spheres of a contact, for its dashpots; of a wall, j = -1, it is
 * 0. Where both move as prescribed, or one touches a wall, no mass is free to
 * move: the dashpots are those of spheres that are. */
static inline void sweep_inverse_masses(const struct rows *b, int i, int j,
                                        double per_mass[2])
{
    const double *const own = b->own_inverse_mass;
    const int fixed = own != NULL && own[i] > 0.0 && (j < 0 || own[j] > 0.0);

    per_mass[0] = fixed ? own[i] : b->motion[i].per_m;
    per_mass[1] = j < 0 ? 0.0 : fixed ? own[j] : b->motion[j].per_m;
}

/* The stages of prescribed particles, of several materials and of clumps
 * (sweep_more.c). */
void sweep_prescribed(struct sweep_buffers *c, const struct chunk *s,
                      const struct rows *b, int first, int count);
void sweep_material_pairs(struct sweep_buffers *c, const struct chunk *s,
                          const struct rows *b, int first, int count);
void sweep_clumps(struct sweep_buffers *c, const struct chunk *s,
                  const struct rows *b, int first, int count);

/* The stages of the budget and of rolling friction (sweep_more.c): contacts
 * first ... first + count - 1, before and after their loads are limited. */
void sweep_budget(struct chunk *s, const struct sweep_buffers *c,
                  const double *const xi[3], const struct contact_constants *k,
                  int first, int count, double dt, int n);
void sweep_rolling(const struct sweep_buffers *c, struct chunk *s,
                   const struct rows *b, const struct contact_constants *k,
                   int first, int count, double dt);

#endif
