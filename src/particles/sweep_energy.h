/* sweep_energy.h -- where the energy of the contacts goes.  Chapter 15.
 *
 * One more stage of the contact loop, between springs and loads, for a run that
 * keeps an energy budget; the loops of all others are compiled without it. In
 * a step dt a contact with the slip v_t and the approach -v_n
 *
 *   stores       elastic(delta) delta, times the law's share, and k_t xi^2 / 2
 *   damps        eta_n v_n^2 dt and, unless it slides, eta_t v_t^2 dt
 *   slides off   -F_t . v_t dt and what its spring loses, where Coulomb's cap
 *                cuts both
 *
 * and what the spring itself loses as it softens (hertz), turns or parts is the
 * difference between what was stored and what the next step finds.
 */
#ifndef SWEEP_ENERGY_H
#define SWEEP_ENERGY_H

#include <math.h>

#include "particles/sweep_buffers.h"

/* The sums of one contact, before its spring is cut. */
struct sweep_slip {
    double F2;    /* [N^2] tangential force before Coulomb's cap */
    double v2;    /* [m^2/s^2] slip */
    double old2;  /* [m^2] xi before this step's v_t dt */
    double left2; /* [m^2] xi' */
    double power; /* [W] -F_t . v_t, with F_t cut */
};

static inline struct sweep_slip sweep_slip(const struct sweep_buffers *c, int p,
                                           const double xi[3], double most,
                                           double dt)
{
    struct sweep_slip s = {0.0, 0.0, 0.0, 0.0, 0.0};

    for (int k = 0; k < 3; k++)
        s.F2 += c->F_t[k][p] * c->F_t[k][p];
    const int slides = s.F2 > most * most;
    for (int k = 0; k < 3; k++) {
        const double v = c->v_t[k][p], F = c->F_t[k][p];
        const double cut = slides ? most / sqrt(s.F2) * F : F;
        const double left =
            slides ? -(cut + c->eta_t[p] * v) / c->k_t[p] : xi[k];
        const double old = xi[k] - v * dt;
        s.v2 += v * v;
        s.left2 += left * left;
        s.old2 += old * old;
        s.power -= cut * v;
    }
    return s;
}

/* Adds the contacts that touch to the sums of the strip. */
SWEEP_STAGE void sweep_budget(struct strip_energy *e,
                              const struct sweep_buffers *c,
                              const double *const xi[3],
                              const struct contact_constants *k, double dt)
{
    for (int p = 0; p < SWEEP_LANES; p++) {
        if (!(c->delta[p] > 0.0)) continue;
        const double most = k[c->kind[p]].friction * fabs(c->F_n[p]);
        const double own[3] = {xi[0][p], xi[1][p], xi[2][p]};
        const struct sweep_slip s = sweep_slip(c, p, own, most, dt);
        const double drag = c->eta_t[p] * s.v2 * dt;
        double v_n = 0.0;

        for (int a = 0; a < 3; a++)
            v_n += c->column[a][p] * c->n[a][p];
        e->normal += c->elastic[p] * c->delta[p];
        e->tangential += 0.5 * c->k_t[p] * s.left2;
        e->found += 0.5 * c->k_t[p] * s.old2;
        e->damped_n += c->eta_n[p] * v_n * v_n * dt;
        if (s.F2 > most * most)
            e->slid += s.power * dt + 0.5 * c->k_t[p] * (s.old2 - s.left2);
        else
            e->damped_t += drag;
    }
}

/* Around all contacts of a strip. Springs wander between strips when the lists
 * are made anew: `released` of one strip may be anything, the sum over all is
 * right. A sweep that takes no time only looks. */
static inline void sweep_open_budget(struct strip_energy *e)
{
    e->stored = e->tangential;
    e->normal = e->tangential = e->found = 0.0;
}

static inline void sweep_close_budget(struct strip_energy *e, double dt)
{
    if (dt > 0.0) e->released += e->stored - e->found;
}

#endif
