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
 *
 * Nor may j be fed by itself. Where cells lie side by side, a flux that is a
 * little too large makes j larger, and j the flux, while the cells around it,
 * whose convection is to undo this, know nothing yet. A scheme that damps makes
 * nothing of it; one that does not grows waves along the surface of a bed. For
 * such a scheme the flux carries the jump of the cells' velocities,
 *
 *   j = rho (phi / A) q (1 / eps_O - 1 / eps_N)
 *   q = w eps_O u_O + (1 - w) eps_N u_N
 *
 * and what is left of the difference across the face is carried upstream's way,
 * by the part 2 |eps_O - eps_N| / (eps_O + eps_N), which where eps is smooth is
 * of the order of a cell, and the error of the second. Bernoulli's pressure
 * stays; waves of a purely central scheme still ring, but come to an end.
 */
#include "fluid/piso.h"

#include <math.h>

#include "linear/triples.h"

void jump_lean(int first, int last, struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const double *const carry = fl->piso->carry;
    double *const share = fl->piso->share;

    for (int f = first; f < last; f++) {
        const double a = fl->eps[m->owner[f]], b = fl->eps[m->neighbour[f]];
        const double lean = fmin(1.0, 2.0 * fabs(a - b) / (a + b));
        fl->piso->upstream[f] =
            lean * ((carry[f] >= 0.0 ? 1.0 : 0.0) - share[f]);
        share[f] += fl->piso->upstream[f];
    }
}

/* What the cells on either side of a face have of its j, of a flux phi that
 * carries the velocity of a flux q [m^3/s]; s is the neighbour's part. */
static inline void divide(const struct fluid *fl, int f, int o, int n, double s,
                          double q)
{
    const struct piso *const ps = fl->piso;
    const double j = fl->options.rho * ps->carry[f] * q / ps->SS[f] *
                     (1.0 / fl->eps[o] - 1.0 / fl->eps[n]);

    ps->jump_owner[f] = (1.0 - s) * j;
    ps->jump_neighbour[f] = s * j;
}

FACE_LOOP parts_by_cells(int f, int o, int n, const struct fluid *fl)
{
    const double w = fl->mesh->w[f], *const S = &fl->mesh->S[3 * f];
    const double *const u = &fl->u[3 * o], *const v = &fl->u[3 * n];
    const double q =
        w * fl->eps[o] * (u[0] * S[0] + u[1] * S[1] + u[2] * S[2]) +
        (1.0 - w) * fl->eps[n] * (v[0] * S[0] + v[1] * S[1] + v[2] * S[2]);

    divide(fl, f, o, n, fl->piso->share[f] - fl->piso->upstream[f], q);
}

FACE_LOOP parts(int f, int o, int n, const struct fluid *fl)
{
    divide(fl, f, o, n, fl->piso->share[f], fl->piso->carry[f]);
}

static void face_parts(int first, int last, const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;

    if (piso_rings(fl))
        LINKS_RUN(fl->piso->runs, first, last, m->owner, m->neighbour,
                  parts_by_cells, fl);
    else
        LINKS_RUN(fl->piso->runs, first, last, m->owner, m->neighbour, parts,
                  fl);
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

/* The jump itself stays where the scheme had it: what leaning took from the
 * neighbour is put back. */
static void put_back(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const struct piso *const ps = fl->piso;

    for (int f = 0; f < m->n_internal; f++) {
        const double j = ps->jump_owner[f] + ps->jump_neighbour[f];
        for (int k = 0; k < 3; k++) {
            const double force = ps->upstream[f] * j * m->S[3 * f + k];
            ps->b[3 * m->owner[f] + k] += force;
            ps->b[3 * m->neighbour[f] + k] -= force;
        }
    }
}

void jump_update(struct fluid *fl)
{
    STRIPS_RUN(fl->mesh->n_internal, 8, face_parts, fl);
    STRIPS_RUN(fl->mesh->n_cells, 12, inertia_rows, fl);
    if (piso_rings(fl)) put_back(fl);
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
