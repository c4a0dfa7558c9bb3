/* SPDX-License-Identifier: GPL-3.0-or-later */
/* quality.c -- how far a mesh is from one of boxes. */
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

/* Between a cell's centre and the middles of its faces: most over least. */
static double aspect(const struct mesh *m, int c)
{
    double least = INFINITY, most = 0.0;

    for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
        const int f = m->cell_face[a];
        const double *const d = &m->d[3 * f];
        const double own = m->out[a] > 0.0 ? 1.0 - m->w[f] : m->w[f];
        const double way = own * sqrt(dot(d, d));
        least = fmin(least, way);
        most = fmax(most, way);
    }
    return most > 0.0 ? most / least : 1.0;
}

static void note(double value, int cell, double *worst, int *where)
{
    if (!(value > *worst)) return;
    *worst = value;
    *where = cell;
}

/* Of a box the products of the narrowest and of the widest slabs. */
static void box_volumes(const struct box *b, double *least, double *most,
                        double *mean)
{
    *least = *most = *mean = 1.0;
    for (int k = 0; k < 3; k++) {
        const double *const e = b->edge[k];
        double narrow = INFINITY, wide = 0.0;
        for (int i = 0; i < b->n[k]; i++) {
            narrow = fmin(narrow, e[i + 1] - e[i]);
            wide = fmax(wide, e[i + 1] - e[i]);
        }
        *least *= narrow;
        *most *= wide;
        *mean *= (e[b->n[k]] - e[0]) / b->n[k];
    }
}

void mesh_volumes(const struct mesh *m, double *least, double *most,
                  double *mean)
{
    if (m->middle == NULL) {
        box_volumes(&m->box, least, most, mean);
        return;
    }
    *least = INFINITY;
    *most = *mean = 0.0;
    for (int c = 0; c < m->n_cells; c++) {
        *least = fmin(*least, m->V[c]);
        *most = fmax(*most, m->V[c]);
        *mean += m->V[c] / m->n_cells;
    }
}

/* The share of direction k in the rate of a box, where it is largest. */
static double rate_along(const struct box *b, int k)
{
    const double *const e = b->edge[k];
    const int n = b->n[k], round = b->periodic[k] && n > 1;
    double fastest = 0.0;

    for (int i = 0; i < n; i++) {
        const int before = i > 0 ? i - 1 : n - 1, after = i < n - 1 ? i + 1 : 0;
        const double h = e[i + 1] - e[i];
        const double below = 0.5 * (h + e[before + 1] - e[before]);
        const double above = 0.5 * (h + e[after + 1] - e[after]);
        double sum = 0.0;
        if (i > 0 || round) sum += 1.0 / (h * below);
        if (i < n - 1 || round) sum += 1.0 / (h * above);
        fastest = fmax(fastest, sum);
    }
    return fastest;
}

/* In a box the directions are independent of each other. */
double mesh_diffusion_rate(const struct mesh *m)
{
    double fastest = 0.0;

    if (m->middle == NULL)
        return rate_along(&m->box, 0) + rate_along(&m->box, 1) +
               rate_along(&m->box, 2);
    for (int c = 0; c < m->n_cells; c++) {
        double sum = 0.0;
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
            const int f = m->cell_face[a];
            const double *const S = &m->S[3 * f];
            if (f < m->n_internal) sum += dot(S, S) / dot(S, &m->d[3 * f]);
        }
        fastest = fmax(fastest, sum / m->V[c]);
    }
    return fastest;
}

static void look_at_cells(const struct mesh *m, struct mesh_quality *q)
{
    q->V_least = INFINITY;
    for (int c = 0; c < m->n_cells; c++) {
        note(aspect(m, c), c, &q->aspect, &q->flat);
        if (m->V[c] < q->V_least) q->small = c;
        q->V_least = fmin(q->V_least, m->V[c]);
        q->V_most = fmax(q->V_most, m->V[c]);
    }
}

struct mesh_quality mesh_quality(const struct mesh *m)
{
    struct mesh_quality q = {.openness = mesh_openness(m), .growth = 1.0};

    look_at_cells(m, &q);
    for (int f = 0; f < m->n_internal; f++) {
        const double *const S = &m->S[3 * f], *const d = &m->d[3 * f];
        const int c = m->owner[f];
        const double cosine = dot(S, d) / sqrt(dot(S, S) * dot(d, d));
        const double ratio = m->V[c] / m->V[m->neighbour[f]];
        note(acos(fmin(1.0, cosine)) * 180.0 / M_PI, c, &q.non_orthogonal,
             &q.crooked);
        if (m->middle != NULL) note(skewness(m, f), c, &q.skewness, &q.skewed);
        q.growth = fmax(q.growth, fmax(ratio, 1.0 / ratio));
    }
    return q;
}
