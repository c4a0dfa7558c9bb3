/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep_more.c -- the stages of the contact loop that few cases have.
 * Chapters "Insertion, removal and energy" and "Materials, rolling and
 * cohesion". */
#include "dem/fast/sweep.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <string.h>

#include "dem/clumps.h"
#include "dem/contact.h"

/* --- what the two of a contact are ---------------------------------------- */

void sweep_prescribed(struct sweep_buffers *c, const struct chunk *s,
                      const struct rows *b, int first, int count)
{
    const int pairs = sweep_pairs(s, first, count);
    double per_mass[2];

    for (int p = 0; p < count; p++) {
        sweep_inverse_masses(b, s->contacts.owner[first + p],
                             p < pairs ? s->contacts.partner[first + p] : -1,
                             per_mass);
        c->between[p].per_m = per_mass[0] + per_mass[1];
    }
}

/* The materials of contacts first ... first + count - 1. A wall has its own. */
void sweep_material_pairs(struct sweep_buffers *c, const struct chunk *s,
                          const struct rows *b, int first, int count)
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

/* 1/m_eff of the balls of clumps: for the ball's 1/m stands what its clump has
 * in the direction of n, 1/M + w . I^-1 w with w = arm x n. */
void sweep_clumps(struct sweep_buffers *c, const struct chunk *s,
                  const struct rows *b, int first, int count)
{
    const int pairs = sweep_pairs(s, first, count);

    for (int p = 0; p < count; p++) {
        const double n[3] = {c->n[0][p], c->n[1][p], c->n[2][p]};
        const int both[2] = {s->contacts.owner[first + p],
                             s->contacts.partner[first + p]};
        if (c->delta[p] <= 0.0) continue;
        for (int k = 0; k < 1 + (p < pairs); k++) {
            const struct row_ball *const ball = &b->ball[both[k]];
            if (ball->of < 0) continue;
            const struct row_clump *const of = &b->clump[ball->of];
            c->per_m[p] += of->per_m - b->motion[both[k]].per_m +
                           clumps_turning(of->per_I, ball->arm, n);
        }
    }
}

/* --- the energy budget of the contacts ------------------------------------
 *
 * Between springs and loads, for a run that keeps an energy budget. In a step
 * dt a contact with the slip v_t and the approach -v_n
 *
 *   stores       what the law says (contact_response) and k_t xi^2 / 2
 *   slides off   where Coulomb's cap cuts force and spring: the work of the
 * mean of the spring's force before and F_t after, and what the spring loses
 *
 * The dashpots' forces, and those of friction, are kept apart from the others:
 * their work is known after the kick (chunk_step.c). What goes into friction
 * and is neither stored nor slides off is released by the spring, as it softens
 * (hertz), turns or parts.
 */

/* Friction in one contact. */
struct sweep_slip {
    double friction[3]; /* [N] of the spring, or of the cap */
    double dashpot[3];  /* [N] of F_t, the other part */
    double slid;        /* [J] */
    double left2;       /* [m^2] of the spring that sweep_loads leaves */
};

/* v_t as in sweep_springs. */
static inline void sweep_slip_velocity(const struct sweep_buffers *c, int p,
                                       double v_n, double v_t[3])
{
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const double turn = c->s[i][p] * c->n[j][p] - c->s[j][p] * c->n[i][p];
        v_t[k] = c->v[k][p] - v_n * c->n[k][p] - c->arm[p] * turn;
    }
}

/* Limits force and spring as sweep_loads does afterwards; most = mu |F_n|. */
static inline struct sweep_slip sweep_slip(const struct sweep_buffers *c, int p,
                                           const double xi[3],
                                           const double v_t[3], double most,
                                           double dt)
{
    const double k_t = c->k_t[p];
    double F2 = 0.0, xi2 = 0.0, old2 = 0.0, work = 0.0;
    struct sweep_slip s;

    for (int k = 0; k < 3; k++) {
        F2 += c->F_t[k][p] * c->F_t[k][p];
        xi2 += xi[k] * xi[k];
    }
    const int slides = F2 > most * most;
    const double cut = slides ? most / sqrt(F2) : 1.0;
    s.left2 = slides ? fmin(xi2, gsl_pow_2(most / k_t)) : xi2;
    for (int k = 0; k < 3; k++) {
        const double old = xi[k] - v_t[k] * dt, F = cut * c->F_t[k][p];
        s.friction[k] = slides ? F : -k_t * xi[k];
        s.dashpot[k] = F - s.friction[k];
        work += 0.5 * (k_t * old - F) * v_t[k] * dt;
        old2 += old * old;
    }
    s.slid = slides ? work + 0.5 * k_t * (old2 - s.left2) : 0.0;
    return s;
}

/* Adds a force in the plane of contact, or along n with the arm 0, as
 * sweep_scatter; theirs is NULL at a wall. */
static inline void sweep_add_part(const struct sweep_buffers *c, int p,
                                  const double F[3], double arm,
                                  struct row_load *own, struct row_load *theirs)
{
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const double turn = arm * (c->n[i][p] * F[j] - c->n[j][p] * F[i]);
        own->F[k] += F[k];
        own->turn[k] += turn;
        if (theirs == NULL) continue;
        theirs->F[k] -= F[k];
        theirs->turn[k] += turn;
    }
}

/* One contact that touches. */
static inline void sweep_count(struct chunk *s, const struct sweep_buffers *c,
                               int p, const double xi[3], double mu, double dt,
                               struct row_load own[ENERGY_PARTS],
                               struct row_load theirs[ENERGY_PARTS])
{
    static const int part[3] = {ENERGY_DASHPOTS, ENERGY_DASHPOTS_T,
                                ENERGY_FRICTION};
    double v_n = 0.0, v_t[3], normal[3];

    for (int a = 0; a < 3; a++)
        v_n += c->v[a][p] * c->n[a][p];
    for (int a = 0; a < 3; a++)
        normal[a] = -c->eta_n[p] * v_n * c->n[a][p];
    sweep_slip_velocity(c, p, v_n, v_t);
    const struct sweep_slip slip =
        sweep_slip(c, p, xi, v_t, mu * fabs(c->F_n[p]), dt);
    const double *const F[3] = {normal, slip.dashpot, slip.friction};
    for (int a = 0; a < 3; a++)
        sweep_add_part(c, p, F[a], a == 0 ? 0.0 : c->arm[p], &own[part[a]],
                       theirs != NULL ? &theirs[part[a]] : NULL);
    s->energy.normal += c->stored[p];
    s->energy.tangential += 0.5 * c->k_t[p] * slip.left2;
    s->energy.slid += slip.slid;
    s->energy.released -= slip.slid;
}

/* Adds those of contacts first ... first + count - 1 that touch to the sums and
 * the parts of the chunk; n particles in all. */
void sweep_budget(struct chunk *s, const struct sweep_buffers *c,
                  const double *const xi[3], const struct contact_constants *k,
                  int first, int count, double dt, int n)
{
    const int pairs = sweep_pairs(s, first, count);

    for (int p = 0; p < count; p++) {
        const double own[3] = {xi[0][p], xi[1][p], xi[2][p]};
        const int at = s->contacts.partner[first + p] - s->begin;

        if (!(c->delta[p] > 0.0)) continue;
        sweep_count(s, c, p, own, k[c->material_pair[p]].friction, dt,
                    s->part[s->contacts.owner[first + p] - s->begin],
                    p < pairs ? s->part[at < 0 ? at + n : at] : NULL);
    }
}

/* --- rolling friction (contact.h) ------------------------------------------
 */

/* The moment M [N m] of one contact on its owner. */
static inline void
sweep_roll_one(const struct sweep_buffers *c, int p, struct chunk *s, int slot,
               const struct row_motion *mine, const struct row_motion *other,
               const double per_mass[2], double M[3], double mu_r, double dt)
{
    const double per_R = mine->per_R, per_other = other->per_R;
    const double R = 1.0 / (per_R + per_other), k_r = c->k_t[p] * R * R;
    const double per_I =
        (per_mass[0] * per_R * per_R + per_mass[1] * per_other * per_other) /
        1.4; /* I + m R^2 = (7/5) m R^2 */
    const double C_r = 2.0 * rolling_damping_ratio * sqrt(k_r / per_I);
    double n[3], w[3], theta[3];

    for (int a = 0; a < 3; a++) {
        n[a] = c->n[a][p];
        w[a] = mine->s[a] * per_R - other->s[a] * per_other;
        theta[a] = s->contacts.roll_angle[a][slot];
    }
    rolling_moment(M, theta, w, n, k_r, C_r, mu_r * R * fabs(c->F_n[p]), dt);
    for (int a = 0; a < 3; a++)
        s->contacts.roll_angle[a][slot] = theta[a];
}

/* The load of a particle is -T/R (chunk.h), and the two have opposite moments.
 */
static inline void sweep_add_moment(const double M[3], double per_R,
                                    double per_other, struct row_load *own,
                                    struct row_load *theirs)
{
    for (int a = 0; a < 3; a++) {
        own->turn[a] -= M[a] * per_R;
        theirs->turn[a] += M[a] * per_other;
    }
}

/* The moments of contacts first ... first + count - 1, after their forces. A
 * budget counts all work against them: what theta stores is little. */
void sweep_rolling(const struct sweep_buffers *c, struct chunk *s,
                   const struct rows *b, const struct contact_constants *k,
                   int first, int count, double dt)
{
    static const struct row_motion wall = {.per_R = 0.0};
    const int pairs = sweep_pairs(s, first, count);
    struct row_load unused = {.F = {0.0}};

    for (int p = 0; p < count; p++) {
        const int slot = first + p, own = s->contacts.owner[slot];
        const int j = s->contacts.partner[slot], pair = p < pairs;
        const int i = own - s->begin;
        const int at = j < s->begin ? j - s->begin + b->n : j - s->begin;
        const double mu_r = k[c->material_pair[p]].rolling;
        const struct row_motion *const mine = &b->motion[own];
        const struct row_motion *const other = pair ? &b->motion[j] : &wall;
        double per_mass[2], M[3];

        if (c->delta[p] <= 0.0 || mu_r <= 0.0) {
            for (int a = 0; a < 3; a++)
                s->contacts.roll_angle[a][slot] = 0.0;
            continue;
        }
        sweep_inverse_masses(b, own, pair ? j : -1, per_mass);
        sweep_roll_one(c, p, s, slot, mine, other, per_mass, M, mu_r, dt);
        sweep_add_moment(M, mine->per_R, other->per_R, chunk_load(s, i),
                         pair ? chunk_load(s, at) : &unused);
        if (b->sweep_options & SWEEP_BUDGET)
            sweep_add_moment(M, mine->per_R, other->per_R,
                             &s->part[i][ENERGY_DASHPOTS],
                             pair ? &s->part[at][ENERGY_DASHPOTS] : &unused);
    }
}
