/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/strip.h"

#include <stddef.h>

double strip_power(const struct strip *s, const struct bodies *b)
{
    double sum = 0.0;

    for (int q = 0; q < s->window; q++) {
        const double *const v = b->motion[(s->begin + q) % b->n];
        for (int k = 0; k < 3; k++)
            sum += s->load[q][k] * v[k];
    }
    return sum;
}

/* push is a force over the mass, added mass and all (response.h); v is what the
 * particles have just moved by, so that the sum is the force times the way,
 * exactly. A fluid that holds them back takes k v^2. */
void strip_work(struct strip *s, const struct bodies *b, int begin, int end,
                double dt)
{
    double power = 0.0;

    for (int i = begin; i < end; i++) {
        const double *const v = b->motion[i], *const a = b->push[i];
        const double *const held = b->response != NULL ? b->response[i] : NULL;
        const double v2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        const double drag = held != NULL ? held[0] * v2 : 0.0;
        power += (a[0] * v[0] + a[1] * v[1] + a[2] * v[2] - drag) /
                 (held != NULL ? held[3] : v[7]);
    }
    s->energy.work += power * dt;
}

void strip_open_budget(struct strip_energy *e)
{
    e->stored = e->tangential;
    e->normal = e->tangential = e->found = 0.0;
}

void strip_close_budget(struct strip_energy *e)
{
    if (!e->looks) e->released += e->stored - e->found;
}
