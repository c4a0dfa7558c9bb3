/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/fast/drag_rows.h"

#include <math.h>

#include "dem/implicit_drag.h"

void drag_rows_load(struct bodies *b, const struct particles *ps, int begin,
                    int end)
{
    for (int i = begin; i < end; i++) {
        const double per_mass = 1.0 / (ps->m[i] + ps->added_mass[i]);
        double *const row = b->implicit_drag[i], *const a = b->acceleration[i];

        row[0] = ps->drag_coefficient[i] * per_mass;
        row[1] = implicit_drag_gain(row[0] * b->step);
        row[2] = implicit_drag_gain(0.5 * row[0] * b->step);
        row[3] = per_mass;
        a[0] = ps->ex[i] * per_mass;
        a[1] = ps->ey[i] * per_mass;
        a[2] = ps->ez[i] * per_mass;
    }
}

void drag_rows_advance(struct bodies *b, int begin, int end, double (*load)[8],
                       double kick, double drift, double fastest[4])
{
    const int half = kick < b->step;
    double top[3] = {fastest[0], fastest[1], fastest[2]};

    for (int i = begin; i < end; i++) {
        const double *const row = b->implicit_drag[i], *const a =
                                                           b->acceleration[i];
        const double *const f = load[i - begin];
        double *const x = b->position_radius[i], *const v = b->velocity[i];
        const double gain = row[half ? 2 : 1], mass = 1.0 / row[3];

        for (int k = 0; k < 3; k++) {
            const double given = row[3] * f[k] + a[k]; /* [m/s^2] */
            const double taken = gain * (given - row[0] * v[k]);
            v[k] += kick * taken;
            b->drag_impulse[3 * i + k] += mass * kick * (taken - given);
            v[4 + k] -= 2.5 * kick * v[7] * f[4 + k]; /* as bodies_advance */
            x[k] += drift * v[k];
            top[k] = fmax(top[k], fabs(v[k]));
        }
    }
    for (int k = 0; k < 3; k++)
        fastest[k] = top[k];
}
