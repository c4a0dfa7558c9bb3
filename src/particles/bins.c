/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/bins.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"

static int fitting(double length, double reach, int most)
{
    const double n = floor(length / reach);
    return n < 1.0 ? 1 : n > most ? most : (int)n;
}

/* Strides: 1 along the shortest side, largest along the longest. */
static void number_bins(struct bins *b, const double length[3])
{
    int axis[3] = {0, 1, 2};

    for (int a = 0; a < 2; a++)
        for (int c = a + 1; c < 3; c++)
            if (length[axis[c]] < length[axis[a]]) {
                const int swap = axis[a];
                axis[a] = axis[c];
                axis[c] = swap;
            }
    b->total = 1;
    for (int a = 0; a < 3; a++) {
        b->stride[axis[a]] = b->total;
        b->total *= b->n[axis[a]];
    }
}

struct bins *bins_create(const double low[3], const double high[3],
                         const int periodic[3], double reach, int capacity)
{
    struct bins *const b = alloc_zeroed(1, sizeof *b);
    /* With small particles in a large box, bins grow: 8 a particle suffice. */
    const int most = 2 + (int)(2.0 * cbrt(1.0 + capacity));
    double length[3];

    for (int a = 0; a < 3; a++) {
        length[a] = high[a] - low[a];
        b->low[a] = low[a];
        b->periodic[a] = periodic[a];
        b->n[a] = fitting(length[a], reach, 8 * most);
    }
    while ((double)b->n[0] * b->n[1] * b->n[2] > 8.0 * capacity + 64.0)
        for (int a = 0; a < 3; a++)
            if (b->n[a] > 1) b->n[a] = (b->n[a] + 1) / 2;
    for (int a = 0; a < 3; a++)
        b->per[a] = b->n[a] / length[a];
    number_bins(b, length);
    b->start = alloc_ints(b->total + 1);
    b->bin = alloc_ints(capacity);
    b->order = alloc_ints(capacity);
    return b;
}

void bins_free(struct bins *b)
{
    if (b == NULL) return;
    free(b->start);
    free(b->bin);
    free(b->order);
    free(b);
}

/* A centre slightly outside belongs to the bin at the edge. */
static int bin_along(const struct bins *b, int a, double x)
{
    const int i = (int)floor((x - b->low[a]) * b->per[a]);
    return i < 0 ? 0 : i > b->n[a] - 1 ? b->n[a] - 1 : i;
}

void bins_sort(struct bins *b, const struct particles *ps)
{
    memset(b->start, 0, (size_t)(b->total + 1) * sizeof *b->start);
    for (int i = 0; i < ps->n; i++) {
        b->bin[i] = bin_along(b, 0, ps->x[i]) * b->stride[0] +
                    bin_along(b, 1, ps->y[i]) * b->stride[1] +
                    bin_along(b, 2, ps->z[i]) * b->stride[2];
        b->start[b->bin[i] + 1]++;
    }
    for (int c = 0; c < b->total; c++)
        b->start[c + 1] += b->start[c];
    for (int i = 0; i < ps->n; i++) /* start moves on by one bin ... */
        b->order[b->start[b->bin[i]]++] = i;
    for (int c = b->total; c > 0; c--) /* ... and back */
        b->start[c] = b->start[c - 1];
    b->start[0] = 0;
}

/* The neighbours of place i among n along one direction, each once. */
static int near(int i, int n, int periodic, int out[3])
{
    int count = 0;

    for (int k = i - 1; k <= i + 1; k++) {
        if (k < 0 || k >= n) {
            if (!periodic || n < 3) continue;
            out[count++] = k < 0 ? n - 1 : 0;
        } else
            out[count++] = k;
    }
    return count;
}

int bins_around(const struct bins *b, int c, int around[27])
{
    int at[3][3], n[3], count = 0;

    for (int a = 0; a < 3; a++)
        n[a] = near(c / b->stride[a] % b->n[a], b->n[a], b->periodic[a], at[a]);
    for (int i = 0; i < n[0]; i++)
        for (int j = 0; j < n[1]; j++)
            for (int k = 0; k < n[2]; k++)
                around[count++] = at[0][i] * b->stride[0] +
                                  at[1][j] * b->stride[1] +
                                  at[2][k] * b->stride[2];
    return count;
}
