/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/fast/heun.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "dem/integrator.h"

const struct integrator heun_integrator = {
    .name = "heun",
    .what = "second order, also with damping; the energy drifts upward",
    .equations = "LS section 4.2",
    .function = "heun_correct",
    .predicts = 1,
};

struct heun *heun_create(int capacity)
{
    struct heun *const h = alloc_zeroed(1, sizeof *h);
    const size_t n = (size_t)capacity;

    h->position_radius = alloc_zeroed(n, sizeof *h->position_radius);
    h->velocity = alloc_zeroed(n, sizeof *h->velocity);
    h->load = alloc_zeroed(n, sizeof *h->load);
    return h;
}

void heun_free(struct heun *h)
{
    if (h == NULL) return;
    free(h->position_radius);
    free(h->velocity);
    free(h->load);
    free(h->part);
    free(h);
}

void heun_save_start(struct heun *h, const struct chunk *s,
                     const struct bodies *b)
{
    const size_t n = (size_t)(s->end - s->begin);

    if (n == 0) return;
    memcpy(h->position_radius[s->begin], b->position_radius[s->begin],
           n * sizeof *h->position_radius);
    memcpy(h->velocity[s->begin], b->velocity[s->begin],
           n * sizeof *h->velocity);
    memcpy(h->load[s->begin], s->load[0], n * sizeof *h->load);
    if (h->part != NULL)
        memcpy(h->part[s->begin], s->part[0], n * sizeof *h->part);
}

/* Rate of number k of the row `velocity`: of v, and of R omega (bodies.c). */
static double heun_rate(const double load[8], const double acceleration[4],
                        double per_mass, int k)
{
    return k < 3 ? load[k] * per_mass + acceleration[k]
                 : -2.5 * load[k] * per_mass;
}

static const int moving[6] = {0, 1, 2, 4, 5, 6};

void heun_predict(const struct heun *h, const struct chunk *s, struct bodies *b,
                  double dt)
{
    for (int i = s->begin; i < s->end; i++) {
        double *const x = b->position_radius[i], *const v = b->velocity[i];

        for (int k = 0; k < 3; k++)
            x[k] += v[k] * dt;
        for (int a = 0; a < 6; a++)
            v[moving[a]] +=
                heun_rate(h->load[i], b->acceleration[i], v[7], moving[a]) * dt;
    }
}

void heun_correct(const struct heun *h, struct chunk *s, struct bodies *b,
                  double dt)
{
    memset(s->max_speed, 0, sizeof s->max_speed);
    for (int i = s->begin; i < s->end; i++) {
        const double *const at_start = h->velocity[i];
        double *const x = b->position_radius[i], *const v = b->velocity[i];

        for (int k = 0; k < 3; k++) {
            const double ahead = v[k];
            x[k] = h->position_radius[i][k] + 0.5 * dt * (at_start[k] + ahead);
            s->max_speed[k] = fmax(s->max_speed[k], fabs(ahead));
        }
        for (int a = 0; a < 6; a++) {
            const int k = moving[a];
            v[k] = at_start[k] +
                   0.5 * dt *
                       (heun_rate(h->load[i], b->acceleration[i], v[7], k) +
                        heun_rate(s->load[i - s->begin], b->acceleration[i],
                                  v[7], k));
        }
        for (int k = 0; k < 3; k++)
            s->max_speed[k] = fmax(s->max_speed[k], fabs(v[k]));
    }
}
