/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/population/overlaps.h"

#include <math.h>

/* Each round moves pairs apart by a little more than their overlap, or rounding
 * and neighbours would leave some for ever. */
static const double push = 1.02;

/* x_i - x_j, nearest image, and its length. */
static double apart(const struct particles *ps, const struct box_domain *box,
                    int i, int j, double d[3])
{
    const double *const x[3] = {ps->x, ps->y, ps->z};
    double r2 = 0.0;

    for (int k = 0; k < 3; k++) {
        const double dx = x[k][i] - x[k][j];
        d[k] = dx - box->length[k] * rint(dx * box->inverse[k]);
        r2 += d[k] * d[k];
    }
    return sqrt(r2);
}

struct overlap overlaps_deepest(const struct particles *ps,
                                const struct box_domain *box)
{
    struct overlap found = {0, -1, 0.0};

    for (int i = 0; i < ps->n; i++)
        for (int j = 0; j < i; j++) {
            const double mean = 0.5 * (ps->d[i] + ps->d[j]);
            double d[3];
            const double depth = 1.0 - apart(ps, box, i, j, d) / mean;
            if (depth > found.depth) found = (struct overlap){j, i, depth};
        }
    return found;
}

/* Two centres in one place have no line; they part along x. */
static void part(struct particles *ps, const struct box_domain *box, int i,
                 int j)
{
    double *const x[3] = {ps->x, ps->y, ps->z};
    double d[3];
    const double r = apart(ps, box, i, j, d),
                 mean = 0.5 * (ps->d[i] + ps->d[j]);

    if (r >= mean) return;
    for (int k = 0; k < 3; k++) {
        const double n = r > 0.0 ? d[k] / r : k == 0;
        x[k][i] += 0.5 * push * (mean - r) * n;
        x[k][j] -= 0.5 * push * (mean - r) * n;
    }
}

static void keep_inside(struct particles *ps, const struct box_domain *box,
                        int i)
{
    double *const x[3] = {ps->x, ps->y, ps->z};
    const double R = 0.5 * ps->d[i];

    for (int k = 0; k < 3; k++) {
        if (box->periodic[k]) continue;
        x[k][i] = fmin(fmax(x[k][i], box->lo[k] + R), box->hi[k] - R);
    }
}

int overlaps_relax(struct particles *ps, const struct box_domain *box, int most)
{
    for (int round = 0; round <= most; round++) {
        if (overlaps_deepest(ps, box).depth <= OVERLAPS_MAX) return round;
        for (int i = 0; i < ps->n; i++)
            for (int j = 0; j < i; j++)
                part(ps, box, i, j);
        for (int i = 0; i < ps->n; i++)
            keep_inside(ps, box, i);
    }
    return -1;
}
