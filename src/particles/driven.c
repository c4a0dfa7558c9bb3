/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/driven.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "particles/response.h"

/* [-] of its 1/m that a driven particle keeps: none would make two of them
 * that touch move by 0/0. */
static const double share = 1e-12;

struct drive *driven_create(const struct driven *list, int n)
{
    struct drive *const d = alloc_zeroed(1, sizeof *d);

    d->list = list;
    d->n = n;
    d->index = alloc_ints(n);
    d->on = alloc_ints(n);
    return d;
}

void driven_free(struct drive *d)
{
    if (d == NULL) return;
    free(d->index);
    free(d->on);
    free(d);
}

void driven_index(struct drive *d, const struct particles *ps)
{
    for (int k = 0; k < d->n; k++) {
        d->index[k] = -1;
        for (int i = 0; i < ps->n && d->index[k] < 0; i++)
            if (ps->id[i] == d->list[k].id) d->index[k] = i;
    }
}

/* Without 1/m, and deaf to what else would move it. Its drag -k v stays what
 * the fluid feels of it: k is as it was, but does not change v. */
static void weigh(struct bodies *b, const struct particles *ps, int i)
{
    b->motion[i][7] = share / ps->m[i];
    memset(b->push[i], 0, sizeof b->push[i]);
    if (b->response == NULL) return;
    const double per_mass = share / (ps->m[i] + ps->added_mass[i]);
    b->response[i][0] = ps->resistance[i] * per_mass;
    b->response[i][1] = b->response[i][2] = 1.0;
    b->response[i][3] = per_mass;
}

/* As bodies_fetch makes it. The loads of this moment are those of a particle
 * without 1/m: its dashpots, made for so large a mass, would throw one that
 * has a mass again. They go with the motion that ends. */
static void release(struct bodies *b, const struct particles *ps, int i,
                    double load[8])
{
    if (load != NULL) memset(load, 0, 8 * sizeof *load);
    const double per_mass = 1.0 / ps->m[i];

    b->motion[i][7] = per_mass;
    b->push[i][0] = ps->ex[i] * per_mass;
    b->push[i][1] = ps->ey[i] * per_mass;
    b->push[i][2] = ps->ez[i] * per_mass;
    if (b->response != NULL) response_fetch(b, ps, i, i + 1);
}

static void steer_one(const struct motion *m, struct bodies *b, int i, double t,
                      double dt)
{
    const struct pose now = motion_pose(m, t);
    double *const v = b->motion[i], *const x = b->place[i];

    if (dt > 0.0) {
        const struct pose next = motion_pose(m, t + dt);
        double start[3], to[3];
        motion_origin(&now, x, start);
        motion_place(&next, start, to);
        for (int k = 0; k < 3; k++)
            v[k] = (to[k] - x[k]) / dt;
    } else {
        motion_velocity(&now, x, v);
    }
    for (int k = 0; k < 3; k++)
        v[4 + k] = x[3] * now.spin[k];
}

static int mine(const struct drive *d, int k, int begin, int end)
{
    return d->index[k] >= begin && d->index[k] < end;
}

void driven_steer(struct drive *d, struct bodies *b, const struct particles *ps,
                  int begin, int end, double (*load)[8], double t, double dt)
{
    for (int k = 0; k < d->n; k++) {
        const struct motion *const m = &d->list[k].motion;
        const int i = d->index[k], on = motion_is_on(m, t);

        if (!mine(d, k, begin, end)) continue;
        if (on) {
            weigh(b, ps, i);
            steer_one(m, b, i, t, dt);
        } else if (d->on[k]) {
            release(b, ps, i, load != NULL ? load[i - begin] : NULL);
        }
        d->on[k] = on;
    }
}

void driven_weigh(const struct drive *d, struct bodies *b,
                  const struct particles *ps, int begin, int end)
{
    for (int k = 0; k < d->n; k++)
        if (mine(d, k, begin, end) && d->on[k]) weigh(b, ps, d->index[k]);
}

void driven_release(const struct drive *d, struct bodies *b,
                    const struct particles *ps, int begin, int end)
{
    for (int k = 0; k < d->n; k++)
        if (mine(d, k, begin, end) && d->on[k])
            release(b, ps, d->index[k], NULL);
}
