/* sweep_energy.h -- the energy budget of the contacts.
 * Chapter "Insertion, removal and energy".
 *
 * One more stage of the contact loop, between springs and loads, for a run that
 * keeps an energy budget; the loops of all others are compiled without it. In
 * a step dt a contact with the slip v_t and the approach -v_n
 *
 *   stores       what the law says (contact_response) and k_t xi^2 / 2
 *   damps        eta_n v_n^2 dt and, unless it slides, eta_t v_t^2 dt
 *   slides off   -F_t . v_t dt and what its spring loses, where Coulomb's cap
 *                cuts both
 *
 * and what the spring itself loses as it softens (hertz), turns or parts is the
 * difference between what was stored and what the next step finds.
 */
#ifndef DEM_FAST_SWEEP_ENERGY_H
#define DEM_FAST_SWEEP_ENERGY_H

#include <gsl/gsl_math.h>
#include <math.h>

#include "dem/contact.h"
#include "dem/fast/sweep_buffers.h"

/* Friction in one contact. */
struct sweep_slip {
    int slides;
    double v2;    /* [m^2/s^2] slip */
    double power; /* [W] -F_t . v_t */
    double old2;  /* [m^2] of the spring before this step's v_t dt */
    double left2; /* [m^2] of the spring that sweep_loads leaves */
};

/* v_t as in sweep_springs. */
static inline void sweep_slip_velocity(const struct sweep_buffers *c, int p,
                                       double v_n, double v_t[3])
{
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const double turn =
            c->column[4 + i][p] * c->n[j][p] - c->column[4 + j][p] * c->n[i][p];
        v_t[k] = c->column[k][p] - v_n * c->n[k][p] - c->arm[p] * turn;
    }
}

/* Limits force and spring as sweep_loads does afterwards; most = mu |F_n|. */
static inline struct sweep_slip sweep_slip(const struct sweep_buffers *c, int p,
                                           const double xi[3],
                                           const double v_t[3], double most,
                                           double dt)
{
    struct sweep_slip s = {0, 0.0, 0.0, 0.0, 0.0};
    double F2 = 0.0, xi2 = 0.0;

    for (int k = 0; k < 3; k++) {
        const double old = xi[k] - v_t[k] * dt;
        F2 += c->F_t[k][p] * c->F_t[k][p];
        xi2 += xi[k] * xi[k];
        s.v2 += v_t[k] * v_t[k];
        s.power -= c->F_t[k][p] * v_t[k];
        s.old2 += old * old;
    }
    s.slides = F2 > most * most;
    if (s.slides) s.power *= most / sqrt(F2);
    s.left2 = s.slides ? fmin(xi2, gsl_pow_2(most / c->k_t[p])) : xi2;
    return s;
}

/* Adds those of the first `count` contacts that touch to the sums of the chunk.
 */
SWEEP_STAGE void sweep_budget(struct chunk_energy *e,
                              const struct sweep_buffers *c,
                              const double *const xi[3],
                              const struct contact_constants *k, int count,
                              double dt)
{
    for (int p = 0; p < count; p++) {
        const double own[3] = {xi[0][p], xi[1][p], xi[2][p]};
        const double most = k[c->material_pair[p]].friction * fabs(c->F_n[p]);
        double v_n = 0.0, v_t[3];

        if (!(c->delta[p] > 0.0)) continue;
        for (int a = 0; a < 3; a++)
            v_n += c->column[a][p] * c->n[a][p];
        sweep_slip_velocity(c, p, v_n, v_t);
        const struct sweep_slip s = sweep_slip(c, p, own, v_t, most, dt);
        const double k_t = c->k_t[p];
        e->normal += c->stored[p];
        e->tangential += 0.5 * k_t * s.left2;
        e->found += 0.5 * k_t * s.old2;
        e->damped_n += c->eta_n[p] * v_n * v_n * dt;
        if (s.slides)
            e->slid += s.power * dt + 0.5 * k_t * (s.old2 - s.left2);
        else
            e->damped_t += c->eta_t[p] * s.v2 * dt;
    }
}

#endif
