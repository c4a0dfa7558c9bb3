/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mesh/measures.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "base/vector.h"

double mesh_box_faces(const struct box_spec *spec)
{
    const int *const n = spec->cells;
    const double cells = (double)n[0] * n[1] * n[2];
    double faces = 0.0;

    for (int k = 0; k < 3; k++)
        faces += cells / n[k] * (n[k] + 1.0);
    return faces;
}

/* The slabs of direction k [m]. */
static void slabs_of_box(const struct box *b, int k, double *widest,
                         double *narrowest)
{
    const double *const e = b->edge[k];

    *widest = 0.0;
    *narrowest = INFINITY;
    for (int i = 0; i < b->n[k]; i++) {
        *widest = fmax(*widest, e[i + 1] - e[i]);
        *narrowest = fmin(*narrowest, e[i + 1] - e[i]);
    }
}

/* The smallest cell of a box is where the narrowest slabs of the three
 * directions cross, the largest where the widest do. */
static void box_volumes(const struct box *b, double *min, double *max,
                        double *mean)
{
    *min = *max = *mean = 1.0;
    for (int k = 0; k < 3; k++) {
        double narrow, wide;
        slabs_of_box(b, k, &wide, &narrow);
        *min *= narrow;
        *max *= wide;
        *mean *= (b->edge[k][b->n[k]] - b->edge[k][0]) / b->n[k];
    }
}

void mesh_volumes(const struct mesh *m, double *min, double *max, double *mean)
{
    if (m->face_centre == NULL) {
        box_volumes(&m->box, min, max, mean);
        return;
    }
    *min = INFINITY;
    *max = *mean = 0.0;
    for (int c = 0; c < m->n_cells; c++) {
        *min = fmin(*min, m->V[c]);
        *max = fmax(*max, m->V[c]);
        *mean += m->V[c] / m->n_cells;
    }
}

/* The largest contribution of direction k to the rate of a cell of a box
 * [1/m^2]. */
static double rate_along(const struct box *b, int k)
{
    const double *const e = b->edge[k];
    const int n = b->n[k], periodic = b->periodic[k] && n > 1;
    double fastest = 0.0;

    for (int i = 0; i < n; i++) {
        const int before = i > 0 ? i - 1 : n - 1, after = i < n - 1 ? i + 1 : 0;
        const double h = e[i + 1] - e[i];
        const double below = 0.5 * (h + e[before + 1] - e[before]);
        const double above = 0.5 * (h + e[after + 1] - e[after]);
        double sum = 0.0;
        if (i > 0 || periodic) sum += 1.0 / (h * below);
        if (i < n - 1 || periodic) sum += 1.0 / (h * above);
        fastest = fmax(fastest, sum);
    }
    return fastest;
}

/* In a box the contributions of the directions are independent of each other,
 * so the largest rate is the sum of the largest. */
double mesh_diffusion_rate(const struct mesh *m)
{
    double fastest = 0.0;

    if (m->face_centre == NULL)
        return rate_along(&m->box, 0) + rate_along(&m->box, 1) +
               rate_along(&m->box, 2);
    for (int c = 0; c < m->n_cells; c++) {
        double sum = 0.0;
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
            const int f = m->cell_face[a];
            const double *const S = mesh_S(m, f);
            if (f < m->n_internal)
                sum += vector_dot(S, S) / vector_dot(S, mesh_d(m, f));
        }
        fastest = fmax(fastest, sum / m->V[c]);
    }
    return fastest;
}

double mesh_openness(const struct mesh *m)
{
    double worst = 0.0;

    for (int c = 0; c < m->n_cells; c++) {
        double sum[3] = {0.0, 0.0, 0.0}, surface = 0.0;
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
            const double *const S = mesh_S(m, m->cell_face[a]);
            for (int k = 0; k < 3; k++)
                sum[k] += m->out[a] * S[k];
            surface += vector_length(S);
        }
        const double open = fabs(sum[0]) + fabs(sum[1]) + fabs(sum[2]);
        if (surface > 0.0) worst = fmax(worst, open / surface);
    }
    return worst;
}

/* The corners of a face of a box, which is a rectangle. */
static int box_corners(const struct mesh *m, int f, int max, double (*x)[3])
{
    const int *const n = m->box.n, c = m->owner[f];
    const int at[3] = {c % n[0], c / n[0] % n[1], c / n[0] / n[1]};
    const double *const S = mesh_S(m, f);
    int k = 0;

    while (S[k] == 0.0)
        k++;
    const int a = (k + 1) % 3, b = (k + 2) % 3, upper = S[k] > 0.0;
    for (int i = 0; i < 4 && i < max; i++) {
        const int corner = upper ? i : 3 - i;
        x[i][k] = m->box.edge[k][at[k] + upper];
        x[i][a] = m->box.edge[a][at[a] + (corner == 1 || corner == 2)];
        x[i][b] = m->box.edge[b][at[b] + (corner >= 2)];
    }
    return 4;
}

int mesh_face_corners(const struct mesh *m, int f, int max, double (*x)[3])
{
    const struct mesh_shape *const s = m->shape;

    if (s == NULL) return box_corners(m, f, max, x);
    const int p = s->boundary[f - m->n_internal];
    const int n = s->start[p + 1] - s->start[p];
    for (int i = 0; i < n && i < max; i++)
        memcpy(x[i], &s->point[3 * s->corner[s->start[p] + i]], sizeof x[i]);
    return n;
}

void mesh_face_middle(const struct mesh *m, int f, double x[3])
{
    const int c = m->owner[f];

    for (int k = 0; k < 3; k++)
        x[k] = m->face_centre != NULL ? m->face_centre[3 * f + k]
                                      : m->centre[3 * c + k] + mesh_d(m, f)[k];
}

/* The link leads from the owner's centre to the neighbour's and crosses the
 * plane of the face at the fraction 1 - w of its length. */
static double skewness(const struct mesh *m, int f)
{
    const double *const d = mesh_d(m, f);
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
        const double *const d = mesh_d(m, f);
        const double own = m->out[a] > 0 ? 1.0 - m->w[f] : m->w[f];
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
        const double *const S = mesh_S(m, f), *const d = mesh_d(m, f);
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

/* A direction with a single cell has no links. */
double mesh_widest_link(const struct mesh *m)
{
    double most = 0.0, widest, narrowest;

    for (int f = 0; f < m->n_internal && m->box.n[0] == 0; f++)
        most = fmax(most, vector_length(mesh_d(m, f)));
    for (int k = 0; k < 3 && m->box.n[0] > 0; k++) {
        slabs_of_box(&m->box, k, &widest, &narrowest);
        if (m->box.n[k] > 1) most = fmax(most, widest);
    }
    return most;
}

/* The widest slab of one direction and the narrowest of another cross in a
 * cell. */
static double longest_in_box(const struct box *b)
{
    double widest[3], narrowest[3], most = 1.0;

    for (int k = 0; k < 3; k++)
        slabs_of_box(b, k, &widest[k], &narrowest[k]);
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < 3; j++)
            if (j != k && b->n[j] > 1 && b->n[k] > 1)
                most = fmax(most, widest[k] / narrowest[j]);
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
            const double *const d = mesh_d(m, m->cell_face[a]);
            if (m->cell_face[a] >= m->n_internal) continue;
            least = fmin(least, vector_length(d));
            length = fmax(length, vector_length(d));
        }
        update_max(length / least, c, &most, cell);
    }
    return most;
}
