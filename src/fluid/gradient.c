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
#include "fluid/systems.h"

#include <stddef.h>

#include "base/vector.h"
#include "fluid/deferred.h"
#include "fluid/face_jump.h"
#include "fluid/piso.h"
#include "linear/faces.h"

/* The gradient of p along S that balances the drag in cell c at face f, times
 * the area, is drag_explicit_part - drag_implicit_part phi: [N/m] and [kg/(m^3
 * s)]. */
static inline double drag_explicit_part(const struct fluid *fl, int c, int f)
{
    return vector_dot(&fl->F[3 * c], mesh_S(fl->mesh, f)) / piso_gamma(fl, c);
}

static inline double drag_implicit_part(const struct fluid *fl, int c)
{
    return fl->K[c] / (fl->eps[c] * piso_gamma(fl, c));
}

/* p_f minus the linear mean: offset - (pressure per flux) phi. */
FACE_KERNEL face_offset(int f, int o, int n, const void *with)
{
    const struct fluid *const fl = with;
    const struct face_jump *const jump = fl->jump;
    const double w = fl->mesh->w[f];
    const double reach =
        w * (1.0 - w) / fl->geometry->face_coefficient[f]; /* [1/m] */

    jump->pressure_offset[f] =
        reach * (drag_explicit_part(fl, o, f) - drag_explicit_part(fl, n, f)) +
        face_jump_above_owner(fl, f, o) - (1.0 - w) * jump->pressure_jump[f];
    jump->pressure_per_flux[f] =
        reach * (drag_implicit_part(fl, o) - drag_implicit_part(fl, n));
}

void gradient_begin(struct fluid *fl)
{
    if (fl->options.coupled) FOR_EACH_FACE(fl->faces, 8, face_offset, fl);
}

FACE_KERNEL linear_pressure(int f, int o, int n, const void *with)
{
    const struct fluid *const fl = with;
    const double w = fl->mesh->w[f];

    fl->p_face[f] = w * fl->p[o] + (1.0 - w) * fl->p[n];
}

FACE_KERNEL offset_pressure(int f, int o, int n, const void *with)
{
    const struct fluid *const fl = with;
    const struct face_jump *const jump = fl->jump;

    linear_pressure(f, o, n, with);
    fl->p_face[f] +=
        jump->pressure_offset[f] - jump->pressure_per_flux[f] * fl->phi[f];
}

static void inner_pressures(struct fluid *fl)
{
    if (fl->options.coupled)
        FOR_EACH_FACE(fl->faces, 4, offset_pressure, fl);
    else
        FOR_EACH_FACE(fl->faces, 4, linear_pressure, fl);
    if (fl->jump->smooth_force != NULL) face_jump_add_gamma_pressures(fl);
}

static void boundary_pressures(struct fluid *fl)
{
    FOR_EACH_BOUNDARY_FACE (fl, b, j, f) {
        const int o = fl->mesh->owner[f];
        fl->p_face[f] = b->kind == BOUNDARY_OUTLET ? b->pressure : fl->p[o];
        if (fl->options.coupled && b->kind != BOUNDARY_OUTLET)
            fl->p_face[f] += (drag_explicit_part(fl, o, f) -
                              drag_implicit_part(fl, o) * fl->phi[f]) /
                             fl->geometry->face_coefficient[f];
    }
}

/* Sets the gradient of cells first .. last - 1. */
static void gradient_rows(int first, int last, struct fluid *fl)
{
    const double *const V = fl->mesh->V, *const G = fl->mean_gradient;
    double *restrict grad_p = fl->grad_p;

    faces_sum_vectors(fl->faces, first, last, fl->faces->n, fl->p_face, -1.0,
                      fl->p_face, grad_p);
    for (int c = first; c < last; c++) {
        const double per_V = 1.0 / V[c];
        for (int k = 0; k < 3; k++)
            grad_p[3 * c + k] = grad_p[3 * c + k] * per_V + G[k];
    }
}

/* The same of a block where nothing else needs the pressures of the inner
 * faces: they are computed for both cells, and not stored. */
static void linear_block(int first, int last, const struct fluid *fl)
{
    const struct faces *const faces = fl->faces;
    double sum[3][PARALLEL_RANGES_BLOCK] = {{0.0}};
    struct face_piece p = {0};

    while (faces_next_of_cells(faces->pieces, first, last, &p)) {
        const int leaves = p.out > 0.0;
        const double *restrict w = fl->mesh->w + p.face;
        const double *restrict area = faces->area + p.face;
        const double *restrict own = fl->p + (leaves ? p.cell : p.other);
        const double *restrict next = fl->p + (leaves ? p.other : p.cell);
        double *restrict to = sum[p.axis] + (p.cell - first);

        for (int j = 0; j < p.n && p.face < faces->n_inner; j++)
            to[j] += p.out * (w[j] * own[j] + (1.0 - w[j]) * next[j]) * area[j];
        for (int j = 0; j < p.n && p.face >= faces->n_inner; j++)
            to[j] += fl->p_face[p.face + j] * area[j];
    }
    for (int c = first; c < last; c++) {
        const double per_V = 1.0 / fl->mesh->V[c];
        for (int k = 0; k < 3; k++)
            fl->grad_p[3 * c + k] =
                sum[k][c - first] * per_V + fl->mean_gradient[k];
    }
}

static void linear_rows(int first, int last, const struct fluid *fl)
{
    for (int end; first < last; first = end) {
        end = last - first < PARALLEL_RANGES_BLOCK
                  ? last
                  : first + PARALLEL_RANGES_BLOCK;
        linear_block(first, end, fl);
    }
}

void gradient_of_faces(struct fluid *fl)
{
    PARALLEL_BLOCKS(fl->mesh->n_cells, 12, gradient_rows, fl);
}

/* Computes the pressures of the faces [Pa] and the gradient of each cell
 * [Pa/m]. */
void gradient_update(struct fluid *fl)
{
    const int alone = piso_alone(fl) && faces_aligned(fl->faces);

    if (!alone) inner_pressures(fl);
    boundary_pressures(fl);
    if (alone)
        PARALLEL_RANGES(fl->mesh->n_cells, 12, linear_rows, fl);
    else if (fl->deferred != NULL)
        deferred_set_gradient(fl->deferred, fl);
    else
        gradient_of_faces(fl);
}

/* The mean pressure gradient of a flow through a periodic box.
 *
 * The pressure p itself is periodic; in addition the pressure has a mean
 * gradient G, either given or chosen so that the mean superficial velocity is
 * the prescribed one. The flux through a face is linear in G, -m_f G . S, and
 * so is its mean over the box,
 *
 *   (1/V) sum phi d,
 *
 * so G is the difference of the prescribed and the present mean over the change
 * of the mean per unit of G. */

int gradient_mean_exists(const struct fluid_options *o)
{
    for (int k = 0; k < 3; k++)
        if (o->mean_gradient[k] != 0.0 || o->keeps_flow[k]) return 1;
    return 0;
}

/* The G in direction k with which the predicted fluxes and the present p give
 * the prescribed mean flow. */
static double required_gradient(const struct fluid *fl, int k)
{
    const struct mesh *const m = fl->mesh;
    const struct pressure_system *const pressure = fl->pressure;
    double flow = 0.0, loss = 0.0, V = 0.0;

    for (int c = 0; c < m->n_cells; c++)
        V += m->V[c];
    for (int f = 0; f < m->n_internal; f++) {
        const double dp = fl->p[m->neighbour[f]] - fl->p[m->owner[f]];
        flow += (fl->phi[f] - pressure->conductance[f] * dp) * mesh_d(m, f)[k];
        loss += pressure->m_face[f] * mesh_S(m, f)[k] * mesh_d(m, f)[k];
    }
    if (loss == 0.0) return 0.0; /* one cell across: no periodic flow */
    return (flow - V * fl->options.mean_flow[k]) / loss;
}

/* Adds to the fluxes what the mean pressure gradient [Pa/m] of a periodic box
 * drives. */
void gradient_add_mean(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    double *const G = fl->mean_gradient;

    for (int k = 0; k < 3; k++)
        if (fl->options.keeps_flow[k]) G[k] = required_gradient(fl, k);
    for (int f = 0; f < m->n_internal; f++)
        fl->phi[f] -= fl->pressure->m_face[f] * vector_dot(G, mesh_S(m, f));
}
