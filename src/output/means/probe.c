/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/means/probe.h"

#include <stddef.h>

#include "base/vector.h"

double probe_middle(const struct box *b, int k, int i)
{
    return 0.5 * (b->edge[k][i] + b->edge[k][i + 1]);
}

int probe_row(const struct box *b, int k, double x, double *upper)
{
    int i = 0;

    while (i < b->n[k] - 1 && probe_middle(b, k, i + 1) <= x)
        i++;
    *upper = 0.0;
    if (i < b->n[k] - 1 && x > probe_middle(b, k, i))
        *upper = (x - probe_middle(b, k, i)) /
                 (probe_middle(b, k, i + 1) - probe_middle(b, k, i));
    return i;
}

static struct probe in_box(const struct mesh *m, const double x[3])
{
    const struct box *const b = &m->box;
    const int stride[3] = {1, b->n[0], b->n[0] * b->n[1]};
    struct probe p = {.n = 8, .weighted = 8};
    double upper[3];
    int first = 0;

    for (int k = 0; k < 3; k++)
        first += stride[k] * probe_row(b, k, x[k], &upper[k]);
    for (int corner = 0; corner < 8; corner++) {
        p.cell[corner] = first;
        p.share[corner] = 1.0;
        for (int k = 0; k < 3; k++) {
            const int high = corner >> k & 1;
            p.share[corner] *= high ? upper[k] : 1.0 - upper[k];
            /* without a row above, that weight is 0 */
            if (high && upper[k] > 0.0) p.cell[corner] += stride[k];
        }
    }
    return p;
}

/* The neighbours of cell c and the links to them, at most as many as a probe
 * can hold besides the cell itself. */
static int links_of(const struct mesh *m, int c, int *cell, double (*link)[3])
{
    int n = 0;

    for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
        const int f = m->cell_face[a], owns = m->out[a] > 0.0;
        if (f >= m->n_internal || n == PROBE_CELLS - 1) break;
        cell[n] = owns ? m->neighbour[f] : m->owner[f];
        for (int k = 0; k < 3; k++)
            link[n][k] = m->out[a] * m->d[3 * f + k];
        n++;
    }
    return n;
}

/* The least-squares gradient g satisfies A g = sum of d (f_n - f_c) / d^2. With
 * y from A y = o, where o leads from the centre to the point, the weight of
 * neighbour n is therefore y . d / d^2, and that of the cell is 1 minus the sum
 * of these. */
static struct probe in_mesh(const struct mesh *m, const double x[3])
{
    struct probe p = {.n = 0};
    double link[PROBE_CELLS - 1][3], A[6] = {0.0}, o[3], y[3];
    const int c = mesh_cell_and_offset(m, x, o);

    if (c < 0) return p;
    const int n = links_of(m, c, &p.cell[1], link);
    for (int i = 0; i < n; i++) {
        const double *const d = link[i], w = 1.0 / vector_dot(d, d);
        const double dd[6] = {d[0] * d[0], d[0] * d[1], d[0] * d[2],
                              d[1] * d[1], d[1] * d[2], d[2] * d[2]};
        for (int j = 0; j < 6; j++)
            A[j] += w * dd[j];
    }
    vector_solve(A, o, y);
    p.n = n + 1;
    p.weighted = 1;
    p.cell[0] = c;
    p.share[0] = 1.0;
    for (int i = 0; i < n; i++) {
        p.share[1 + i] = vector_dot(y, link[i]) / vector_dot(link[i], link[i]);
        p.share[0] -= p.share[1 + i];
    }
    return p;
}

struct probe probe_at(const struct mesh *m, const double x[3])
{
    return m->face_centre == NULL ? in_box(m, x) : in_mesh(m, x);
}

double probe_amount(const struct probe *p, const double *values, int components,
                    int component, const double *weight, double *whole)
{
    const int n = weight != NULL ? p->weighted : p->n;
    double amount = 0.0;

    for (int i = 0; i < n; i++) {
        const int c = p->cell[i];
        const double share = n == 1 ? 1.0 : p->share[i];
        const double w = share * (weight != NULL ? weight[c] : 1.0);
        amount += w * values[components * c + component];
        *whole += w;
    }
    return amount;
}

double probe_value(const struct probe *p, const double *values, int components,
                   int component, const double *weight)
{
    double whole = 0.0;
    const double amount =
        probe_amount(p, values, components, component, weight, &whole);

    return whole > 0.0 ? amount / whole : 0.0;
}
