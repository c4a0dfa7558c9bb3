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

static void linear_pressures(int first, int last, struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const double *restrict w = m->w, *restrict p = fl->p;
    double *restrict p_face = fl->p_face;

    for (int f = first; f < last; f++)
        p_face[f] = w[f] * p[m->owner[f]] + (1.0 - w[f]) * p[m->neighbour[f]];
}

static void inner_pressures(int first, int last, struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;

    linear_pressures(first, last, fl);
    if (!fl->options.coupled) return;
    for (int f = first; f < last; f++) {
        const int o = m->owner[f], n = m->neighbour[f];
        const double w = m->w[f];
        const double area = face_area(m, f);
        fl->p_face[f] +=
            w * (1.0 - w) * face_length(m, f, area) *
            (drag_slope(fl, o, f, area) - drag_slope(fl, n, f, area));
        fl->p_face[f] +=
            jump_above_owner(fl, f) - (1.0 - w) * jump_pressure(fl, f);
    }
    for (int f = first; f < last && fl->piso->rest; f++)
        fl->p_face[f] += jump_rest_at_face(fl, f);
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

static void gradient_rows(int first, int last, struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const double *restrict p_face = fl->p_face, *restrict S = m->S;
    double *restrict grad_p = fl->grad_p;

    for (int c = first; c < last; c++) {
        double x = 0.0, y = 0.0, z = 0.0;
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
            const int f = m->cell_face[a];
            const double p = m->out[a] * p_face[f];
            x += p * S[3 * f];
            y += p * S[3 * f + 1];
            z += p * S[3 * f + 2];
        }
        grad_p[3 * c] = x / m->V[c] + fl->mean_gradient[0];
        grad_p[3 * c + 1] = y / m->V[c] + fl->mean_gradient[1];
        grad_p[3 * c + 2] = z / m->V[c] + fl->mean_gradient[2];
    }
}

void gradient_update(struct fluid *fl)
{
    STRIPS_RUN(fl->mesh->n_internal, 4, inner_pressures, fl);
    boundary_pressures(fl);
    STRIPS_RUN(fl->mesh->n_cells, 12, gradient_rows, fl);
}
