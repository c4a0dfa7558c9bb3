/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/means/mean.h"

#include "base/alloc.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

struct mean *mean_create(int n)
{
    struct mean *const m = alloc_zeroed(1, sizeof *m);

    m->n = n;
    m->weight = alloc_doubles(3 * n);
    m->value = m->weight + n;
    m->square = m->value + n;
    for (int i = 0; i < n; i++)
        m->value[i] = NAN;
    return m;
}

void mean_free(struct mean *m)
{
    if (m == NULL) return;
    free(m->weight);
    free(m);
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
