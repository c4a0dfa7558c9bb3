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
 *
 * What is left of convection and viscosity once the steps are out, a force per
 * volume t, has no jump. But where the particles take their share of grad p,
 * the slope t / gamma that it gives the pressure has one, and a mean of the two
 * slopes lets a central scheme grow waves at the surface of a bed. So a face
 * has one t, and each side takes it with its own gamma:
 *
 *   p_N - p_O = ... + d t_f ((1 - w) / gamma_O + w / gamma_N)
 *   t_f = (1 - w) t_O + w t_N
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

static void rest_rows(int first, int last, struct fluid *fl)
{
    const struct piso *const ps = fl->piso;

    for (int c = first; c < last; c++) {
        const double V = fl->mesh->V[c];
        const double older =
            ps->storage_older != NULL ? ps->storage_older[c] : 0.0;
        const double own = ps->diag[c] - ps->storage[c] - older - fl->K[c] * V;
        for (int k = 0; k < 3; k++) {
            const int i = 3 * c + k;
            ps->rest[i] =
                (ps->H[i] - ps->inertia[i] - own * fl->u[i]) / V - fl->F[i];
        }
    }
}

void jump_rest(struct fluid *fl)
{
    STRIPS_RUN(fl->mesh->n_cells, 12, rest_rows, fl);
}

/* w (1 - w) d (1 / gamma_O - 1 / gamma_N), over the area [m^-1] */
static double uneven(const struct fluid *fl, int f)
{
    const struct mesh *const m = fl->mesh;
    return m->w[f] * (1.0 - m->w[f]) * fl->piso->Sd[f] / fl->piso->SS[f] *
           (1.0 / piso_gamma(fl, m->owner[f]) -
            1.0 / piso_gamma(fl, m->neighbour[f]));
}

static double along(const struct fluid *fl, int c, int f)
{
    const double *const t = &fl->piso->rest[3 * c];
    const double *const S = &fl->mesh->S[3 * f];
    return t[0] * S[0] + t[1] * S[1] + t[2] * S[2];
}

double jump_of_rest(const struct fluid *fl, int f)
{
    const struct mesh *const m = fl->mesh;
    return uneven(fl, f) *
           (along(fl, m->neighbour[f], f) - along(fl, m->owner[f], f));
}

double jump_rest_at_face(const struct fluid *fl, int f)
{
    const struct mesh *const m = fl->mesh;
    return uneven(fl, f) * ((1.0 - m->w[f]) * along(fl, m->owner[f], f) +
                            m->w[f] * along(fl, m->neighbour[f], f));
}
