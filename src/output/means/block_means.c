/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/means/block_means.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"

enum { MOST_BLOCKS = 32, LEAST_BLOCKS = 8 };

/* Block k of number i is at [k * n + i]; the block after the last full one is
 * being filled. */
struct block_means {
    int n;
    int full;       /* [-] blocks that are full */
    long length;    /* [-] samples in each */
    long filled;    /* [-] samples in the one that is being filled */
    double *weight; /* [unit of w] sum of w */
    double *amount; /* [unit of w x] sum of w x */
};

struct block_means *block_means_create(int n)
{
    struct block_means *const b = alloc_zeroed(1, sizeof *b);

    b->n = n;
    b->length = 1;
    b->weight = alloc_doubles(MOST_BLOCKS * n);
    b->amount = alloc_doubles(MOST_BLOCKS * n);
    return b;
}

void block_means_free(struct block_means *b)
{
    if (b == NULL) return;
    free(b->weight);
    free(b->amount);
    free(b);
}

/* Neighbours are joined to one block, and the second half of the array is free.
 */
static void block_means_join(struct block_means *b, double *sum)
{
    const int n = b->n, half = MOST_BLOCKS / 2;

    for (int k = 0; k < half; k++)
        for (int i = 0; i < n; i++)
            sum[k * n + i] = sum[2 * k * n + i] + sum[(2 * k + 1) * n + i];
    memset(&sum[half * n], 0, (size_t)(half * n) * sizeof *sum);
}

void block_means_add(struct block_means *b, const double *x, const double *w)
{
    const int at = b->full * b->n;

    for (int i = 0; i < b->n; i++) {
        if (w[i] == 0.0) continue;
        b->weight[at + i] += w[i];
        b->amount[at + i] += w[i] * x[i];
    }
    if (++b->filled < b->length) return;
    b->filled = 0;
    if (++b->full < MOST_BLOCKS) return;
    block_means_join(b, b->weight);
    block_means_join(b, b->amount);
    b->full = MOST_BLOCKS / 2;
    b->length *= 2;
}

/* (12.6), `joined` blocks taken as one; what does not fill one is left out. */
static double error_of(const struct block_means *b, int i, int joined)
{
    const int m = b->full / joined;
    double W = 0.0, A = 0.0, sum = 0.0;

    for (int k = 0; k < m * joined; k++) {
        W += b->weight[k * b->n + i];
        A += b->amount[k * b->n + i];
    }
    for (int k = 0; k < m; k++) {
        double w = 0.0, a = 0.0;
        for (int j = k * joined; j < (k + 1) * joined; j++) {
            w += b->weight[j * b->n + i];
            a += b->amount[j * b->n + i];
        }
        sum += (a - w * A / W) * (a - w * A / W); /* 0 / 0: nan */
    }
    return sqrt(m / (m - 1.0) * sum) / W;
}

double block_means_error(const struct block_means *b, int i)
{
    double largest = NAN;

    for (int joined = 1; b->full / joined >= LEAST_BLOCKS; joined *= 2)
        largest = fmax(largest, error_of(b, i, joined)); /* not the nan */
    return largest;
}

void block_means_state(struct block_means *b, struct state *s)
{
    state_begin(s, "blocks");
    state_count(s, "full", &b->full, MOST_BLOCKS - 1);
    state_long(s, "length", "-", &b->length);
    state_long(s, "filled", "-", &b->filled);
    state_demand(s, b->length > 0 && b->filled >= 0 && b->filled < b->length,
                 "a block that is longer than it is");
    state_reals(s, "weight", "of the weights", b->weight, MOST_BLOCKS, b->n);
    state_reals(s, "amount", "weight value", b->amount, MOST_BLOCKS, b->n);
    state_end(s);
}
