/* SPDX-License-Identifier: GPL-3.0-or-later */
/* gradient.c -- the pressure gradient of the cells by Gauss' theorem.
 *
 * grad p = (1/V) sum p_f S. Where drag jumps from cell to cell, so does the
 * gradient of p: the gradients on the two sides of a face differ by the
 * difference of the drag forces, each computed with the velocity that the flux
 * through the face has in that cell. p_f is the value at the face that is
 * consistent with both gradients. With equal forces it is the linear mean. A
 * pressure jump by inertia is added.
 */
#include "fluid/piso.h"

#include "linear/fast/vec3.h"

/* The gradient of p along S that balances the drag in cell c at face f, times
 * the area, is drag_explicit_part - drag_implicit_part phi: [N/m] and [kg/(m^3
 * s)]. */
static inline double drag_explicit_part(const struct fluid *fl, int c, int f)
{
    const double *const S = &fl->mesh->S[3 * f], *const F = &fl->F[3 * c];
    return (F[0] * S[0] + F[1] * S[1] + F[2] * S[2]) / piso_gamma(fl, c);
}

static inline double drag_implicit_part(const struct fluid *fl, int c)
{
    return fl->K[c] / (fl->eps[c] * piso_gamma(fl, c));
}

/* p_f minus the linear mean: offset - (pressure per flux) phi. */
FACE_KERNEL face_offset(int f, int o, int n, const struct fluid *fl)
{
    const struct piso *const ps = fl->piso;
    const double w = fl->mesh->w[f];
    const double reach = w * (1.0 - w) / ps->face_coefficient[f]; /* [1/m] */

    ps->face_pressure_offset[f] =
        reach * (drag_explicit_part(fl, o, f) - drag_explicit_part(fl, n, f)) +
        piso_jump_above(fl, f, o) - (1.0 - w) * piso_jump(fl, f, o, n);
    ps->face_pressure_per_flux[f] =
        reach * (drag_implicit_part(fl, o) - drag_implicit_part(fl, n));
}

static void face_offsets(int first, int last, const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;

    FOR_EACH_FACE(fl->piso->contiguous, first, last, m->owner, m->neighbour,
                  face_offset, fl);
}

void gradient_begin(struct fluid *fl)
{
    if (fl->options.coupled)
        PARALLEL_RANGES(fl->mesh->n_internal, 8, face_offsets, fl);
}

FACE_KERNEL linear_pressure(int f, int o, int n, const double *w,
                            const double *p, double *p_face)
{
    p_face[f] = w[f] * p[o] + (1.0 - w[f]) * p[n];
}

static void linear_pressures(int first, int last, struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;

    FOR_EACH_FACE(fl->piso->contiguous, first, last, m->owner, m->neighbour,
                  linear_pressure, m->w, fl->p, fl->p_face);
}

static void inner_pressures(int first, int last, struct fluid *fl)
{
    const double *restrict face_offset = fl->piso->face_pressure_offset,
                           *restrict phi = fl->phi;
    const double *restrict lean = fl->piso->face_pressure_per_flux;
    double *restrict p_face = fl->p_face;

    linear_pressures(first, last, fl);
    if (!fl->options.coupled) return;
    for (int f = first; f < last; f++)
        p_face[f] += face_offset[f] - lean[f] * phi[f];
    for (int f = first; f < last && fl->piso->smooth_force; f++)
        p_face[f] += face_jump_gamma_at_face(fl, f);
}

static void boundary_pressures(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;

    for (int i = 0; i < m->n_patches; i++) {
        const struct boundary *const b = &fl->options.boundaries[i];
        const struct patch *const p = &m->patches[i];
        for (int f = p->first; f < p->first + p->n; f++) {
            const int o = m->owner[f];
            fl->p_face[f] = fl->p[o];
            if (b->kind == BOUNDARY_OUTLET)
                fl->p_face[f] = b->pressure;
            else if (fl->options.coupled)
                fl->p_face[f] += (drag_explicit_part(fl, o, f) -
                                  drag_implicit_part(fl, o) * fl->phi[f]) /
                                 fl->piso->face_coefficient[f];
        }
    }
}

/* sum = the sum of p_f S over the faces of cells first .. last - 1. */
static void add_faces(int first, int last, const struct fluid *fl, double *sum)
{
    const struct mesh *const m = fl->mesh;
    const struct contiguous_faces *const r = fl->piso->contiguous;
    struct contiguous_piece next = {0};

    for (int i = 3 * first; i < 3 * last && r != NULL; i++)
        sum[i] = 0.0;
    while (r != NULL && contiguous_faces_next_of_cells(r, first, last, &next))
        vec3_add(next.n, next.out, fl->p_face + next.link,
                 m->S + 3L * next.link, sum + 3L * next.cell);
    for (int c = first; c < last && r == NULL; c++) {
        double x = 0.0, y = 0.0, z = 0.0;
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
            const double *const S = &m->S[3 * m->cell_face[a]];
            const double p = m->out[a] * fl->p_face[m->cell_face[a]];
            x += p * S[0];
            y += p * S[1];
            z += p * S[2];
        }
        sum[3 * c] = x;
        sum[3 * c + 1] = y;
        sum[3 * c + 2] = z;
    }
}

static void gradient_rows(int first, int last, struct fluid *fl)
{
    const double *const V = fl->mesh->V, *const G = fl->mean_gradient;
    double *restrict grad_p = fl->grad_p;

    add_faces(first, last, fl, grad_p);
    for (int c = first; c < last; c++) {
        const double per_V = 1.0 / V[c];
        for (int k = 0; k < 3; k++)
            grad_p[3 * c + k] = grad_p[3 * c + k] * per_V + G[k];
    }
}

void gradient_update(struct fluid *fl)
{
    PARALLEL_RANGES(fl->mesh->n_internal, 4, inner_pressures, fl);
    boundary_pressures(fl);
    PARALLEL_RANGES(fl->mesh->n_cells, 12, gradient_rows, fl);
}
