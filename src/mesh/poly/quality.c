/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mesh/poly/quality.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stddef.h>

#include "base/vector.h"
#include "mesh/geometry/measures.h"

/* The link leads from the owner's centre to the neighbour's and crosses the
 * plane of the face at the fraction 1 - w of its length. */
static double skewness(const struct mesh *m, int f)
{
    const double *const d = &m->d[3 * f];
    double off[3];

    mesh_off_middle(m, f, off);
    return sqrt(vector_dot(off, off) / vector_dot(d, d));
}

/* The largest distance of a cell's centre from the middle of a face over the
 * smallest [-]. */
static double aspect(const struct mesh *m, int c)
{
    double least = INFINITY, most = 0.0;

    for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
        const int f = m->cell_face[a];
        const double *const d = &m->d[3 * f];
        const double own = m->out[a] > 0.0 ? 1.0 - m->w[f] : m->w[f];
        const double way = own * vector_length(d);
        least = fmin(least, way);
        most = fmax(most, way);
    }
    return most > 0.0 ? most / least : 1.0;
}

static void update_max(double value, int cell, double *worst, int *where)
{
    if (!(value > *worst)) return;
    *worst = value;
    *where = cell;
}

static void quality_measure_cells(const struct mesh *m, struct mesh_quality *q)
{
    q->V_min = INFINITY;
    for (int c = 0; c < m->n_cells; c++) {
        update_max(aspect(m, c), c, &q->aspect, &q->n_flat);
        if (m->V[c] < q->V_min) q->n_small = c;
        q->V_min = fmin(q->V_min, m->V[c]);
        q->V_max = fmax(q->V_max, m->V[c]);
    }
}

struct mesh_quality mesh_quality(const struct mesh *m)
{
    struct mesh_quality q = {.openness = mesh_openness(m), .growth = 1.0};

    quality_measure_cells(m, &q);
    for (int f = 0; f < m->n_internal; f++) {
        const double *const S = &m->S[3 * f], *const d = &m->d[3 * f];
        const int c = m->owner[f];
        const double cosine =
            vector_dot(S, d) / sqrt(vector_dot(S, S) * vector_dot(d, d));
        const double ratio = m->V[c] / m->V[m->neighbour[f]];
        update_max(acos(fmin(1.0, cosine)) * 180.0 / M_PI, c, &q.non_orthogonal,
                   &q.n_non_orthogonal);
        if (m->face_centre != NULL)
            update_max(skewness(m, f), c, &q.skewness, &q.n_skewed);
        q.growth = fmax(q.growth, fmax(ratio, 1.0 / ratio));
    }
    return q;
}

/* The widest slab of one direction and the narrowest of another cross in a
 * cell. A direction with a single cell has no links. */
static double longest_in_box(const struct box *b)
{
    double widest[3], narrowest[3], most = 1.0;

    for (int k = 0; k < 3; k++) {
        const double *const e = b->edge[k];
        widest[k] = 0.0;
        narrowest[k] = INFINITY;
        for (int i = 0; i < b->n[k] && b->n[k] > 1; i++) {
            widest[k] = fmax(widest[k], e[i + 1] - e[i]);
            narrowest[k] = fmin(narrowest[k], e[i + 1] - e[i]);
        }
    }
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < 3; j++)
            if (j != k) most = fmax(most, widest[k] / narrowest[j]);
    return most;
}

double mesh_longest_cell(const struct mesh *m, int *cell)
{
    double most = 1.0;

    *cell = -1;
    if (m->face_centre == NULL) return longest_in_box(&m->box);
    for (int c = 0; c < m->n_cells && m->skewed != 2; c++) {
        double least = INFINITY, length = 0.0;
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
            const double *const d = &m->d[3 * m->cell_face[a]];
            if (m->cell_face[a] >= m->n_internal) continue;
            least = fmin(least, vector_length(d));
            length = fmax(length, vector_length(d));
        }
        update_max(length / least, c, &most, cell);
    }
    return most;
}
