/* SPDX-License-Identifier: GPL-3.0-or-later */
/* jump.c -- inertia where the void fraction jumps.
 *
 * A stream of phi / A through a face has the velocity phi / (eps A) on either
 * side. If eps jumps there, momentum does too, by
 *
 *   j = rho (phi / A)^2 (1 / eps_O - 1 / eps_N)       [Pa]
 *
 * and the pressure must jump with it (Bernoulli at the surface of a bed). The
 * convection scheme gives the cell O the share 1 - s of this force and N the
 * share s. Left in the cells it would be smeared over their whole length, and
 * the velocity would ring over several cells; so the flux and the pressure of
 * the face take it as what it is, a step at the face.
 */
#include "fluid/piso.h"

#include <math.h>
#include <string.h>

void jump_update(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct piso *const ps = fl->piso;

    memset(ps->inertia, 0, 3 * (size_t)m->n_cells * sizeof *ps->inertia);
    for (int f = 0; f < m->n_internal; f++) {
        const int o = m->owner[f], n = m->neighbour[f];
        const double *const S = &m->S[3 * f];
        const double SS = S[0] * S[0] + S[1] * S[1] + S[2] * S[2];
        const double s = ps->share[f];
        ps->jump[f] = fl->options.rho * ps->carry[f] * ps->carry[f] / SS *
                      (1.0 / fl->eps[o] - 1.0 / fl->eps[n]);
        for (int k = 0; k < 3; k++) {
            ps->inertia[3 * o + k] += (1.0 - s) * ps->jump[f] * S[k];
            ps->inertia[3 * n + k] += s * ps->jump[f] * S[k];
        }
    }
}

double jump_above_owner(const struct fluid *fl, int f)
{
    const struct piso *const ps = fl->piso;
    return (1.0 - ps->share[f]) * ps->jump[f] /
           piso_gamma(fl, fl->mesh->owner[f]);
}

double jump_pressure(const struct fluid *fl, int f)
{
    const struct piso *const ps = fl->piso;
    return jump_above_owner(fl, f) +
           ps->share[f] * ps->jump[f] / piso_gamma(fl, fl->mesh->neighbour[f]);
}
