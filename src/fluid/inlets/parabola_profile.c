/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/inlets/parabola_profile.h"

#include "base/alloc.h"
#include "fluid/inlet_profile.h"

double parabola_profile_mean(double a, double b)
{
    const double square = a * a + a * b + b * b; /* (b^3 - a^3) / (b - a) */

    return 3.0 * (a + b) - 2.0 * square; /* mean of 6 s (1 - s) */
}

/* Creates a profile that is a parabola in each direction between walls, with
 * the mean 1. */
static int parabola(const struct boundary_request *r, struct boundary *b,
                    char wrong[BOUNDARY_TEXT])
{
    const struct mesh *const m = r->mesh;
    const struct patch *const p = r->patch;
    double *const profile = alloc_doubles(p->n);

    (void)wrong;
    for (int j = 0; j < p->n; j++) {
        const int *const n = m->box.n, c = m->owner[p->first + j];
        const int at[3] = {c % n[0], c / n[0] % n[1], c / n[0] / n[1]};
        profile[j] = 1.0;
        for (int k = 0; k < 3; k++) {
            const double *const x = m->box.edge[k];
            if (m->S[3 * (p->first + j) + k] == 0.0 && r->between_walls[k])
                profile[j] *= parabola_profile_mean(x[at[k]] / x[n[k]],
                                                    x[at[k] + 1] / x[n[k]]);
        }
    }
    b->profile = b->memory = profile;
    return 0;
}

const struct inlet_profile parabola_profile = {
    .name = "parabola",
    .what = "zero at the walls beside the inlet of a plain box, its mean 1",
    .equations = "",
    .function = "parabola_profile_mean",
    .create = parabola,
};
