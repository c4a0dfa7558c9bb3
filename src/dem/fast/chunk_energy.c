/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/fast/chunk.h"

#include <stddef.h>

double chunk_power(const struct chunk *s, const struct bodies *b)
{
    double sum = 0.0;

    for (int q = 0; q < s->window; q++) {
        const double *const v = b->velocity[(s->begin + q) % b->n];
        for (int k = 0; k < 3; k++)
            sum += s->load[q][k] * v[k];
    }
    return sum;
}

/* The acceleration is the force over the mass including the added mass
 * (implicit_drag.h); v is the velocity of the last drift, so the sum is exactly
 * force times displacement. An implicit drag dissipates k v^2. */
void chunk_add_work(struct chunk *s, const struct bodies *b, int begin, int end,
                    double dt)
{
    double power = 0.0;

    for (int i = begin; i < end; i++) {
        const double *const v = b->velocity[i], *const a = b->acceleration[i];
        const double *const held =
            b->implicit_drag != NULL ? b->implicit_drag[i] : NULL;
        const double v2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        const double drag = held != NULL ? held[0] * v2 : 0.0;
        power += (a[0] * v[0] + a[1] * v[1] + a[2] * v[2] - drag) /
                 (held != NULL ? held[3] : v[7]);
    }
    s->energy.work += power * dt;
}

void chunk_begin_budget(struct chunk_energy *e)
{
    e->stored = e->tangential;
    e->normal = e->tangential = e->found = 0.0;
}

void chunk_end_budget(struct chunk_energy *e)
{
    if (!e->skip_release) e->released += e->stored - e->found;
}
