/* SPDX-License-Identifier: GPL-3.0-or-later */
/* gradient.c -- the pressure gradient of the cells, by Gauss.
 *
 * grad p = (1/V) sum p_f S. Where drag jumps from cell to cell, so does the
 * slope of p: the slope on each side of a face differs from that on the other
 * by the difference of the drag forces there, both taken at the velocity that
 * the flux through the face has in that cell. p_f is where the two meet. With
 * equal forces it is the linear mean. A step of p by inertia adds to it.
 */
#include "fluid/piso.h"

#include <math.h>

/* Slope of p that would balance the drag in cell c at face f, along S. */
static double drag_slope(const struct fluid *fl, int c, int f, double area)
{
    const double *const S = &fl->mesh->S[3 * f], *const F = &fl->F[3 * c];
    const double along = (F[0] * S[0] + F[1] * S[1] + F[2] * S[2]) / area;
    const double u = fl->phi[f] / (fl->eps[c] * area);
    return (along - fl->K[c] * u) / piso_gamma(fl, c);
}

static double face_area(const struct mesh *m, int f)
{
    const double *const S = &m->S[3 * f];
    return sqrt(S[0] * S[0] + S[1] * S[1] + S[2] * S[2]);
}

/* Length of the link along the normal [m]. */
static double face_length(const struct mesh *m, int f, double area)
{
    const double *const S = &m->S[3 * f], *const d = &m->d[3 * f];
    return (S[0] * d[0] + S[1] * d[1] + S[2] * d[2]) / area;
}

static void inner_pressures(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;

    for (int f = 0; f < m->n_internal; f++) {
        const int o = m->owner[f], n = m->neighbour[f];
        const double w = m->w[f];
        fl->p_face[f] = w * fl->p[o] + (1.0 - w) * fl->p[n];
        if (!fl->options.coupled) continue;
        const double area = face_area(m, f);
        fl->p_face[f] +=
            w * (1.0 - w) * face_length(m, f, area) *
            (drag_slope(fl, o, f, area) - drag_slope(fl, n, f, area));
        fl->p_face[f] +=
            jump_above_owner(fl, f) - (1.0 - w) * jump_pressure(fl, f);
    }
}

static void boundary_pressures(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;

    for (int i = 0; i < m->n_patches; i++) {
        const struct boundary *const b = &fl->options.boundaries[i];
        const struct patch *const p = &m->patches[i];
        for (int f = p->first; f < p->first + p->n; f++) {
            fl->p_face[f] = fl->p[m->owner[f]];
            if (b->kind == BOUNDARY_OUTLET)
                fl->p_face[f] = b->pressure;
            else if (fl->options.coupled) {
                const double area = face_area(m, f);
                fl->p_face[f] += face_length(m, f, area) *
                                 drag_slope(fl, m->owner[f], f, area);
            }
        }
    }
}

void gradient_update(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;

    inner_pressures(fl);
    boundary_pressures(fl);
    for (int c = 0; c < m->n_cells; c++) {
        double sum[3] = {0.0, 0.0, 0.0};
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
            const int f = m->cell_face[a];
            const double p = m->owner[f] == c ? fl->p_face[f] : -fl->p_face[f];
            for (int k = 0; k < 3; k++)
                sum[k] += p * m->S[3 * f + k];
        }
        for (int k = 0; k < 3; k++)
            fl->grad_p[3 * c + k] = sum[k] / m->V[c] + fl->mean_gradient[k];
    }
}
