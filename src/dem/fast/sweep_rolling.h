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

/* One contact; gives the power of the moment [W]. The load of a particle is
 * -T/R (chunk.h), and the two have opposite moments. */
static inline double sweep_roll_one(const struct sweep_buffers *c, int p,
                                    struct chunk *s, int slot,
                                    const double mine[8], const double other[8],
                                    const double per_mass[2], double own[8],
                                    double theirs[8], double mu_r, double dt)
{
    const double R = 1.0 / (mine[3] + other[3]), k_r = c->k_t[p] * R * R;
    const double per_I =
        (per_mass[0] * mine[3] * mine[3] + per_mass[1] * other[3] * other[3]) /
        1.4; /* I + m R^2 = (7/5) m R^2 */
    const double C_r = 2.0 * rolling_damping_ratio * sqrt(k_r / per_I);
    double n[3], w[3], theta[3], M[3];

    for (int a = 0; a < 3; a++) {
        n[a] = c->n[a][p];
        w[a] = mine[4 + a] * mine[3] - other[4 + a] * other[3];
        theta[a] = s->contacts.roll_angle[a][slot];
    }
    rolling_moment(M, theta, w, n, k_r, C_r, mu_r * R * fabs(c->F_n[p]), dt);
    for (int a = 0; a < 3; a++) {
        own[4 + a] -= M[a] * mine[3];
        theirs[4 + a] += M[a] * other[3];
        s->contacts.roll_angle[a][slot] = theta[a];
    }
    return M[0] * w[0] + M[1] * w[1] + M[2] * w[2];
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
        const int slot = first + p, i = s->contacts.owner[slot];
        const int j = s->contacts.partner[slot], pair = p < pairs;
        const int at = j - s->begin;
        const double mu_r = k[c->material_pair[p]].rolling;

        if (c->delta[p] <= 0.0 || mu_r <= 0.0) {
            for (int a = 0; a < 3; a++)
                s->contacts.roll_angle[a][slot] = 0.0;
            continue;
        }
        double per_mass[2];
        sweep_inverse_masses(b, i, pair ? j : -1, per_mass);
        const double power = sweep_roll_one(
            c, p, s, slot, b->velocity[i], pair ? b->velocity[j] : wall,
            per_mass, s->load[i - s->begin],
            pair ? s->load[at < 0 ? at + b->n : at] : unused, mu_r, dt);
        if (budget) s->energy.rolled -= power * dt;
    }
}

#endif
