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

#include "linear/triples.h"

/* What the cells on either side of a face have of its j. */
FACE_LOOP parts(int f, int o, int n, const struct fluid *fl)
{
    const struct piso *const ps = fl->piso;
    const double s = ps->share[f];
    const double j = fl->options.rho * ps->carry[f] * ps->carry[f] / ps->SS[f] *
                     (1.0 / fl->eps[o] - 1.0 / fl->eps[n]);

    ps->jump_owner[f] = (1.0 - s) * j;
    ps->jump_neighbour[f] = s * j;
}

static void face_parts(int first, int last, const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;

    LINKS_RUN(fl->piso->runs, first, last, m->owner, m->neighbour, parts, fl);
}

/* The forces of the jumps on the cells, part times S. */
static void inertia_rows(int first, int last, const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const struct piso *const ps = fl->piso;
    struct piece p = {0};

    for (int i = 3 * first; i < 3 * last; i++)
        ps->inertia[i] = 0.0;
    while (ps->runs != NULL && runs_next_of_cells(ps->runs, first, last, &p) &&
           p.link < m->n_internal) {
        const double *const part =
            p.out > 0.0 ? ps->jump_owner : ps->jump_neighbour;
        triples_add(p.n, 1.0, part + p.link, m->S + 3L * p.link,
                    ps->inertia + 3L * p.cell);
    }
    for (int c = first; c < last && ps->runs == NULL; c++)
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
            const int f = m->cell_face[a];
            if (f >= m->n_internal) continue;
            const double part =
                m->owner[f] == c ? ps->jump_owner[f] : ps->jump_neighbour[f];
            for (int k = 0; k < 3; k++)
                ps->inertia[3 * c + k] += part * m->S[3 * f + k];
        }
}

void jump_update(struct fluid *fl)
{
    STRIPS_RUN(fl->mesh->n_internal, 8, face_parts, fl);
    STRIPS_RUN(fl->mesh->n_cells, 12, inertia_rows, fl);
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
