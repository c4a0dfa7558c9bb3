/* sweep_rolling.h -- rolling friction in the contact loop.
 * Chapter "Materials, rolling and cohesion".
 *
 * The elastic-plastic model with a dashpot, type C of [Ai11]: a spring theta
 * that is wound up by the relative rotation of the two, and slips like the
 * tangential one where its moment is more than mu_r R* |F_n|:
 *
 *   M = -k_r theta - C_r w_t,   |M| <= mu_r R* |F_n|
 *   k_r = k_t R*^2,   C_r = 2 zeta_r sqrt(I_r k_r),
 *   1/I_r = 1/(I_i + m_i R_i^2) + 1/(I_j + m_j R_j^2)
 *
 * w_t is omega_i - omega_j without its part along n. Both spheres turn with the
 * frame, so w_t and M are the same in a turning one. Where it slips, the spring
 * is reduced until its moment is no more than the limit, as with sliding
 * friction; in [Ai11] the dashpot is dropped there. A constant moment against
 * w_t would need no theta, but a sphere would never come to rest: the moment
 * would change its sign in every step.
 */
#ifndef DEM_FAST_SWEEP_ROLLING_H
#define DEM_FAST_SWEEP_ROLLING_H

#include <math.h>

#include "dem/contact.h"
#include "dem/fast/sweep_buffers.h"

/* [-] zeta_r: the oscillation ends after a few periods; with three times this
 * ratio the dashpots of six neighbours would reverse the rotation of a sphere
 * within a step. */
static const double sweep_rolling_damping_ratio = 0.3;

/* The moment [N m] on particle i; theta is moved on by dt [s] and cut back
 * where it slips. w: omega_i - omega_j [rad/s]; most: mu_r R* |F_n| [N m]. */
static inline void sweep_roll(double M[3], double theta[3], const double w[3],
                              const double n[3], double k_r, double C_r,
                              double most, double dt)
{
    const double spin = w[0] * n[0] + w[1] * n[1] + w[2] * n[2];
    const double out = theta[0] * n[0] + theta[1] * n[1] + theta[2] * n[2];
    double size = 0.0, wound2 = 0.0;

    for (int a = 0; a < 3; a++) {
        const double w_t = w[a] - spin * n[a];
        theta[a] += w_t * dt - out * n[a];
        M[a] = -k_r * theta[a] - C_r * w_t;
        size += M[a] * M[a];
        wound2 += k_r * theta[a] * k_r * theta[a];
    }
    size = sqrt(size);
    if (size <= most) return;
    for (int a = 0; a < 3; a++) {
        M[a] *= most / size;
        if (wound2 > most * most) theta[a] = -M[a] / k_r;
    }
}

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
    const double C_r = 2.0 * sweep_rolling_damping_ratio * sqrt(k_r / per_I);
    double n[3], w[3], theta[3], M[3];

    for (int a = 0; a < 3; a++) {
        n[a] = c->n[a][p];
        w[a] = mine[4 + a] * mine[3] - other[4 + a] * other[3];
        theta[a] = s->contacts.roll_angle[a][slot];
    }
    sweep_roll(M, theta, w, n, k_r, C_r, mu_r * R * fabs(c->F_n[p]), dt);
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
    double nobody[8] = {0};

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
            pair ? s->load[at < 0 ? at + b->n : at] : nobody, mu_r, dt);
        if (budget) s->energy.rolled -= power * dt;
    }
}

#endif
