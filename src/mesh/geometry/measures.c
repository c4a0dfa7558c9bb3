/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mesh/geometry/measures.h"

#include <math.h>
#include <stddef.h>

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

/* The smallest cell of a box is where the narrowest slabs of the three
 * directions cross, the largest where the widest do. */
static void box_volumes(const struct box *b, double *min, double *max,
                        double *mean)
{
    *min = *max = *mean = 1.0;
    for (int k = 0; k < 3; k++) {
        const double *const e = b->edge[k];
        double narrow = INFINITY, wide = 0.0;
        for (int i = 0; i < b->n[k]; i++) {
            narrow = fmin(narrow, e[i + 1] - e[i]);
            wide = fmax(wide, e[i + 1] - e[i]);
        }
        *min *= narrow;
        *max *= wide;
        *mean *= (e[b->n[k]] - e[0]) / b->n[k];
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
 * [1/m^2].
 */
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
            const double *const S = &m->S[3 * f];
            if (f < m->n_internal)
                sum += vector_dot(S, S) / vector_dot(S, &m->d[3 * f]);
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
            const double *const S = &m->S[3 * m->cell_face[a]];
            for (int k = 0; k < 3; k++)
                sum[k] += m->out[a] * S[k];
            surface += vector_length(S);
        }
        const double open = fabs(sum[0]) + fabs(sum[1]) + fabs(sum[2]);
        if (surface > 0.0) worst = fmax(worst, open / surface);
    }
    return worst;
}
