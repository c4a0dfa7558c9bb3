/* sweep_rolling.h -- rolling friction in the contact loop.
 * Chapter "Materials, rolling and cohesion".
 *
 * One more stage of the loop, for cases with rolling friction (rolling.h); the
 * loops of all others are compiled without it.
 */
#ifndef DEM_FAST_SWEEP_ROLLING_H
#define DEM_FAST_SWEEP_ROLLING_H

#include <math.h>

#include "dem/contact.h"
#include "dem/fast/sweep_buffers.h"
#include "dem/rolling.h"

/* The moment M [N m] of one contact on its owner. */
static inline void sweep_roll_one(const struct sweep_buffers *c, int p,
                                  struct chunk *s, int slot,
                                  const double mine[8], const double other[8],
                                  const double per_mass[2], double M[3],
                                  double mu_r, double dt)
{
    const double R = 1.0 / (mine[3] + other[3]), k_r = c->k_t[p] * R * R;
    const double per_I =
        (per_mass[0] * mine[3] * mine[3] + per_mass[1] * other[3] * other[3]) /
        1.4; /* I + m R^2 = (7/5) m R^2 */
    const double C_r = 2.0 * rolling_damping_ratio * sqrt(k_r / per_I);
    double n[3], w[3], theta[3];

    for (int a = 0; a < 3; a++) {
        n[a] = c->n[a][p];
        w[a] = mine[4 + a] * mine[3] - other[4 + a] * other[3];
        theta[a] = s->contacts.roll_angle[a][slot];
    }
    rolling_moment(M, theta, w, n, k_r, C_r, mu_r * R * fabs(c->F_n[p]), dt);
    for (int a = 0; a < 3; a++)
        s->contacts.roll_angle[a][slot] = theta[a];
}

/* The load of a particle is -T/R (chunk.h), and the two have opposite moments.
 */
static inline void sweep_add_moment(const double M[3], double per_R,
                                    double per_other, double own[8],
                                    double theirs[8])
{
    for (int a = 0; a < 3; a++) {
        own[4 + a] -= M[a] * per_R;
        theirs[4 + a] += M[a] * per_other;
    }
}

/* The moments of contacts first ... first + count - 1, after their forces. A
 * budget counts all work against them: what theta stores is little. */
SWEEP_STAGE void sweep_rolling(const struct sweep_buffers *restrict c,
                               struct chunk *s, const struct bodies *b,
                               const struct contact_constants *k, int first,
                               int count, double dt, int budget)
{
    static const double wall[8] = {0};
    const int pairs = sweep_pairs(s, first, count);
    double unused[8] = {0};

    for (int p = 0; p < count; p++) {
        const int slot = first + p, own = s->contacts.owner[slot];
        const int j = s->contacts.partner[slot], pair = p < pairs;
        const int i = own - s->begin;
        const int at = j < s->begin ? j - s->begin + b->n : j - s->begin;
        const double mu_r = k[c->material_pair[p]].rolling;
        const double *const mine = b->velocity[own];
        const double *const other = pair ? b->velocity[j] : wall;
        double per_mass[2], M[3];

        if (c->delta[p] <= 0.0 || mu_r <= 0.0) {
            for (int a = 0; a < 3; a++)
                s->contacts.roll_angle[a][slot] = 0.0;
            continue;
        }
        sweep_inverse_masses(b, own, pair ? j : -1, per_mass);
        sweep_roll_one(c, p, s, slot, mine, other, per_mass, M, mu_r, dt);
        sweep_add_moment(M, mine[3], other[3], s->load[i],
                         pair ? s->load[at] : unused);
        if (budget)
            sweep_add_moment(M, mine[3], other[3], s->part[i][ENERGY_DASHPOTS],
                             pair ? s->part[at][ENERGY_DASHPOTS] : unused);
    }
}

#endif
