/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/means/means.h"

#include "base/alloc.h"

#include <assert.h>
#include <math.h>
#include <string.h>

struct mean *mean_create(int n)
{
    struct mean *const m = owner_create(sizeof *m);

    m->n = n;
    m->weight = owner_doubles(m, 3 * n);
    m->value = m->weight + n;
    m->square = m->value + n;
    for (int i = 0; i < n; i++)
        m->value[i] = NAN;
    return m;
}

void mean_add(struct mean *m, double dt, const double *x, const double *w)
{
    for (int i = 0; i < m->n; i++) {
        const double wi = w ? dt * w[i] : dt;

        assert(wi >= 0.0);
        if (wi == 0.0) continue;
        const double before = m->weight[i] > 0.0 ? m->value[i] : x[i];
        m->weight[i] += wi;
        m->value[i] = before + wi / m->weight[i] * (x[i] - before);
        m->square[i] += wi * (x[i] - before) * (x[i] - m->value[i]);
    }
}

double mean_spread(const struct mean *m, int i)
{
    return sqrt(m->square[i] / m->weight[i]); /* 0 / 0: nan */
}

void mean_state(struct mean *m, struct state *s)
{
    state_reals(s, "weight", "of the weights", m->weight, m->n, 1);
    state_reals(s, "value", "of the values", m->value, m->n, 1);
    state_reals(s, "square", "weight value^2", m->square, m->n, 1);
}

/* --- blocks --------------------------------------------------------------- */

enum { MOST_BLOCKS = 32, LEAST_BLOCKS = 8 };

/* Block k of number i is at [k * n + i]; the block after the last full one is
 * being filled. */
struct mean_blocks {
    int n;
    int full;       /* [-] blocks that are full */
    long length;    /* [-] samples in each */
    long filled;    /* [-] samples in the one that is being filled */
    double *weight; /* [unit of w] sum of w */
    double *amount; /* [unit of w x] sum of w x */
};

struct mean_blocks *mean_blocks_create(int n)
{
    struct mean_blocks *const b = owner_create(sizeof *b);

    b->n = n;
    b->length = 1;
    b->weight = owner_doubles(b, MOST_BLOCKS * n);
    b->amount = owner_doubles(b, MOST_BLOCKS * n);
    return b;
}

/* Neighbours are joined to one block, and the second half of the array is free.
 */
static void mean_blocks_join(struct mean_blocks *b, double *sum)
{
    const int n = b->n, half = MOST_BLOCKS / 2;

    for (int k = 0; k < half; k++)
        for (int i = 0; i < n; i++)
            sum[k * n + i] = sum[2 * k * n + i] + sum[(2 * k + 1) * n + i];
    memset(&sum[half * n], 0, (size_t)(half * n) * sizeof *sum);
}

void mean_blocks_add(struct mean_blocks *b, const double *x, const double *w)
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
    mean_blocks_join(b, b->weight);
    mean_blocks_join(b, b->amount);
    b->full = MOST_BLOCKS / 2;
    b->length *= 2;
}

/* (12.6), `joined` blocks taken as one; what does not fill one is left out. */
static double error_of(const struct mean_blocks *b, int i, int joined)
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

double mean_blocks_error(const struct mean_blocks *b, int i)
{
    double largest = NAN;

    for (int joined = 1; b->full / joined >= LEAST_BLOCKS; joined *= 2)
        largest = fmax(largest, error_of(b, i, joined)); /* not the nan */
    return largest;
}

void mean_blocks_state(struct mean_blocks *b, struct state *s)
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
