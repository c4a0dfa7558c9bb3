/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/life.h"

#include <stdlib.h>

#include "base/alloc.h"

struct life *life_create(const struct domain *box, int n_sources, int n_sinks)
{
    struct life *const l = alloc_zeroed(1, sizeof *l);

    l->box = *box;
    l->n_sources = n_sources;
    l->n_sinks = n_sinks;
    l->sources = alloc_zeroed((size_t)n_sources, sizeof *l->sources);
    l->sinks = alloc_zeroed((size_t)n_sinks, sizeof *l->sinks);
    return l;
}

void life_free(struct life *l)
{
    if (l == NULL) return;
    for (int i = 0; i < l->n_sources; i++) {
        sizes_free(l->sources[i].own_sizes);
        free(l->sources[i].own_list);
    }
    free(l->sources);
    free(l->sinks);
    free(l->gone);
    free(l);
}

static int goes(const struct life *l, const struct life_sink *sink,
                const struct particles *ps, int i, double dt)
{
    const double x[3] = {ps->x[i], ps->y[i], ps->z[i]};
    const double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
    const int k = sink->side / 2, upper = sink->side % 2;

    if (sink->side >= 0) {
        const double gap = (upper ? l->box.hi[k] - x[k] : x[k] - l->box.lo[k]) -
                           0.5 * ps->d[i];
        const double nearer = (upper ? v[k] : -v[k]) * dt;
        return gap - (nearer > 0.0 ? nearer : 0.0) <= 0.0;
    }
    for (int a = 0; a < 3; a++)
        if (x[a] < sink->lo[a] || x[a] > sink->hi[a]) return 0;
    return 1;
}

static void add_momentum(double sum[3], const struct particles *ps, int i)
{
    sum[0] += ps->m[i] * ps->vx[i];
    sum[1] += ps->m[i] * ps->vy[i];
    sum[2] += ps->m[i] * ps->vz[i];
}

static void count_out(struct life_account *a, const struct particles *ps, int i)
{
    a->went++;
    a->mass_out += ps->m[i];
    add_momentum(a->momentum_out, ps, i);
}

static void count_in(struct life_account *a, const struct particles *ps, int i)
{
    a->came++;
    a->mass_in += ps->m[i];
    add_momentum(a->momentum_in, ps, i);
}

int life_mark(struct life *l, const struct particles *ps, double dt)
{
    int n = 0;

    if (l->n_sinks == 0) return 0;
    if (l->room < ps->n) {
        free(l->gone);
        l->room = ps->capacity;
        l->gone = alloc_ints(l->room);
    }
    for (int i = 0; i < ps->n; i++) {
        l->gone[i] = 0;
        for (int s = 0; s < l->n_sinks && !l->gone[i]; s++)
            l->gone[i] = goes(l, &l->sinks[s], ps, i, dt);
        if (l->gone[i]) count_out(&l->account, ps, i);
        n += l->gone[i];
    }
    return n;
}

void life_remove(struct life *l, struct dem *dem)
{
    dem_remove(dem, l->gone);
}

int life_insert(struct life *l, struct particles *ps, struct dem *dem, double t)
{
    const int before = ps->n;

    l->account.waiting = 0;
    for (int s = 0; s < l->n_sources; s++) {
        struct insertion *const in = &l->sources[s];
        insertion_step(in, ps, &l->box, t);
        l->account.waiting += insertion_due(in, t) - in->done;
    }
    for (int i = before; i < ps->n; i++)
        count_in(&l->account, ps, i);
    if (ps->n > before) dem_changed(dem);
    return before;
}

void life_save(const struct life *l, const struct particles *ps, FILE *f)
{
    const struct life_account *const a = &l->account;

    fprintf(f, "life %d %d %ld %ld %a %a\n", ps->next_id, l->n_sources, a->came,
            a->went, a->mass_in, a->mass_out);
    for (int k = 0; k < 3; k++)
        fprintf(f, "momentum %a %a\n", a->momentum_in[k], a->momentum_out[k]);
    for (int s = 0; s < l->n_sources; s++)
        fprintf(f, "source %ld %ld\n", l->sources[s].done, l->sources[s].tried);
}

int life_load(struct life *l, struct particles *ps, FILE *f)
{
    struct life_account *const a = &l->account;
    int n = -1;

    if (fscanf(f, " life %d %d %ld %ld %la %la", &ps->next_id, &n, &a->came,
               &a->went, &a->mass_in, &a->mass_out) != 6 ||
        n != l->n_sources)
        return 1;
    for (int k = 0; k < 3; k++)
        if (fscanf(f, " momentum %la %la", &a->momentum_in[k],
                   &a->momentum_out[k]) != 2)
            return 1;
    for (int s = 0; s < n; s++)
        if (fscanf(f, " source %ld %ld", &l->sources[s].done,
                   &l->sources[s].tried) != 2)
            return 1;
    return 0;
}
