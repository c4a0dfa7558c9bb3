/* SPDX-License-Identifier: GPL-3.0-or-later */
/* quality.c -- how far a mesh is from one of boxes; and which cell holds a
 * point where there is no box to tell. */
#include "mesh/mesh.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stddef.h>

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The link leaves the owner's centre for the neighbour's and crosses the plane
 * of the face after a share 1 - w of it. */
static double skewness(const struct mesh *m, int f)
{
    const double *const d = &m->d[3 * f];
    const double *const from = &m->centre[3 * m->owner[f]];
    double off[3];

    for (int k = 0; k < 3; k++)
        off[k] = m->middle[3 * f + k] - from[k] - (1.0 - m->w[f]) * d[k];
    return sqrt(dot(off, off) / dot(d, d));
}

struct mesh_quality mesh_quality(const struct mesh *m)
{
    struct mesh_quality q = {mesh_openness(m), 0.0, 0.0, INFINITY, 0.0};

    for (int c = 0; c < m->n_cells; c++) {
        q.V_least = fmin(q.V_least, m->V[c]);
        q.V_most = fmax(q.V_most, m->V[c]);
    }
    for (int f = 0; f < m->n_internal; f++) {
        const double *const S = &m->S[3 * f], *const d = &m->d[3 * f];
        const double cosine = dot(S, d) / sqrt(dot(S, S) * dot(d, d));
        q.non_orthogonal =
            fmax(q.non_orthogonal, acos(fmin(1.0, cosine)) * 180.0 / M_PI);
        if (m->middle != NULL) q.skewness = fmax(q.skewness, skewness(m, f));
    }
    return q;
}

/* How far the point is beyond face a of the cell's list [m]. */
static double beyond(const struct mesh *m, int a, const double point[3])
{
    const int f = m->cell_face[a];
    const double *const S = &m->S[3 * f], *const x = &m->middle[3 * f];
    const double r[3] = {point[0] - x[0], point[1] - x[1], point[2] - x[2]};

    return m->out[a] * dot(r, S) / sqrt(dot(S, S));
}

/* The face of cell c that the point is farthest beyond, or -1. */
static int way_out(const struct mesh *m, int c, const double point[3])
{
    double most = 1e-12 * cbrt(m->V[c]);
    int way = -1;

    for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++)
        if (beyond(m, a, point) > most) {
            most = beyond(m, a, point);
            way = a;
        }
    return way;
}

int mesh_cell_from(const struct mesh *m, int begin, double x, double y,
                   double z)
{
    const double point[3] = {x, y, z};
    int c = begin;

    if (m->middle == NULL) return mesh_cell_at(m, x, y, z);
    for (int steps = 0; steps < m->n_cells; steps++) {
        const int way = way_out(m, c, point);
        if (way < 0) return c;
        const int f = m->cell_face[way];
        if (f >= m->n_internal) break;
        c = m->out[way] > 0.0 ? m->neighbour[f] : m->owner[f];
    }
    for (c = 0; c < m->n_cells; c++)
        if (way_out(m, c, point) < 0) return c;
    return -1;
}
