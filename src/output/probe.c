/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/probe.h"

#include <stddef.h>

static double middle(const struct box *b, int k, int i)
{
    return 0.5 * (b->edge[k][i] + b->edge[k][i + 1]);
}

/* The row of centres below x in direction k, or the first; *upper is what the
 * row above it counts. */
static int row_below(const struct box *b, int k, double x, double *upper)
{
    int i = 0;

    while (i < b->n[k] - 1 && middle(b, k, i + 1) <= x)
        i++;
    *upper = 0.0;
    if (i < b->n[k] - 1 && x > middle(b, k, i))
        *upper =
            (x - middle(b, k, i)) / (middle(b, k, i + 1) - middle(b, k, i));
    return i;
}

struct probe probe_at(const struct mesh *m, const double x[3])
{
    const struct box *const b = &m->box;
    const int stride[3] = {1, b->n[0], b->n[0] * b->n[1]};
    struct probe p = {{0}, {0}};
    double upper[3];
    int first = 0;

    for (int k = 0; k < 3; k++)
        first += stride[k] * row_below(b, k, x[k], &upper[k]);
    for (int corner = 0; corner < 8; corner++) {
        p.cell[corner] = first;
        p.share[corner] = 1.0;
        for (int k = 0; k < 3; k++) {
            const int high = corner >> k & 1;
            p.share[corner] *= high ? upper[k] : 1.0 - upper[k];
            /* without a row above, that share is 0 */
            if (high && upper[k] > 0.0) p.cell[corner] += stride[k];
        }
    }
    return p;
}

double probe_value(const struct probe *p, const double *values, int components,
                   int component, const double *weight)
{
    double amount = 0.0, whole = 0.0;

    for (int i = 0; i < 8; i++) {
        const int c = p->cell[i];
        const double w = p->share[i] * (weight != NULL ? weight[c] : 1.0);
        amount += w * values[components * c + component];
        whole += w;
    }
    return whole > 0.0 ? amount / whole : 0.0;
}
