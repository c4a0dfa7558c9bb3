/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/population/overlaps.h"

#include <math.h>
#include <stdlib.h>

#include "base/alloc.h"

/* [-] Each round moves pairs apart by a little more than their overlap;
 * otherwise rounding and neighbours would leave some overlaps for ever. */
static const double push = 1.02;

/* x_i - x_j, nearest image, and its length. */
static double overlaps_apart(const struct particles *ps,
                             const struct box_domain *box, int i, int j,
                             double d[3])
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

/* A sphere's coordinate along the direction that all are sorted by. */
struct placed {
    double x; /* [m] */
    int i;
};

static int by_x(const void *a, const void *b)
{
    const struct placed *const p = a, *const q = b;
    return (p->x > q->x) - (p->x < q->x);
}

static double overlaps_widest(const struct particles *ps)
{
    double d = 0.0;

    for (int i = 0; i < ps->n; i++)
        d = fmax(d, ps->d[i]);
    return d;
}

/* The direction in which the spheres spread the farthest. */
static int longest(const struct particles *ps)
{
    const double *const x[3] = {ps->x, ps->y, ps->z};
    double most = -1.0;
    int along = 0;

    for (int k = 0; k < 3; k++) {
        double lo = HUGE_VAL, hi = -HUGE_VAL;
        for (int i = 0; i < ps->n; i++) {
            lo = fmin(lo, x[k][i]);
            hi = fmax(hi, x[k][i]);
        }
        if (hi - lo > most) {
            most = hi - lo;
            along = k;
        }
    }
    return along;
}

/* The deeper one; of two that are equal the first by i, then by j. */
static void keep_deeper(struct overlap *found, const struct particles *ps,
                        const struct box_domain *box, int a, int b)
{
    const int i = a > b ? a : b, j = a > b ? b : a;
    double d[3];
    const double mean = 0.5 * (ps->d[i] + ps->d[j]);
    const double depth = 1.0 - overlaps_apart(ps, box, i, j, d) / mean;

    if (depth > found->depth ||
        (depth > 0.0 && depth == found->depth &&
         (i < found->j || (i == found->j && j < found->i))))
        *found = (struct overlap){j, i, depth};
}

/* In the order of one coordinate only those in reach have to be looked at; in a
 * period the first follow the last. */
struct overlap overlaps_deepest(const struct particles *ps,
                                const struct box_domain *box)
{
    struct placed *const list = alloc_zeroed((size_t)ps->n, sizeof *list);
    const int k = longest(ps);
    const double *const x = k == 0 ? ps->x : k == 1 ? ps->y : ps->z;
    const double reach = overlaps_widest(ps) * (1.0 + 1e-9), L = box->length[k];
    struct overlap found = {0, -1, 0.0};

    for (int i = 0; i < ps->n; i++)
        list[i] = (struct placed){box_domain_inside(box, k, x[i]), i};
    qsort(list, (size_t)ps->n, sizeof *list, by_x);
    for (int p = 0; p < ps->n; p++)
        for (int next = p + 1; next < p + ps->n; next++) {
            const int wrapped = next >= ps->n, q = next - wrapped * ps->n;
            if (wrapped && L == 0.0) break;
            if (list[q].x + (wrapped ? L : 0.0) - list[p].x > reach) break;
            keep_deeper(&found, ps, box, list[p].i, list[q].i);
        }
    free(list);
    return found;
}

/* Two centres at the same position are moved apart along x. */
static void move_apart(struct particles *ps, const struct box_domain *box,
                       int i, int j)
{
    double *const x[3] = {ps->x, ps->y, ps->z};
    double d[3];
    const double r = overlaps_apart(ps, box, i, j, d),
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
                move_apart(ps, box, i, j);
        for (int i = 0; i < ps->n; i++)
            keep_inside(ps, box, i);
    }
    return -1;
}
