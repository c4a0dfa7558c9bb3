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

static void book_out(struct life_account *a, const struct particles *ps, int i)
{
    a->went++;
    a->mass_out += ps->m[i];
    a->momentum[0] += ps->m[i] * ps->vx[i];
    a->momentum[1] += ps->m[i] * ps->vy[i];
    a->momentum[2] += ps->m[i] * ps->vz[i];
}

/* Who goes, by index; returns how many. */
static int mark(struct life *l, const struct particles *ps, int *gone,
                double dt)
{
    int n = 0;

    for (int i = 0; i < ps->n; i++) {
        for (int s = 0; s < l->n_sinks && !gone[i]; s++)
            gone[i] = goes(l, &l->sinks[s], ps, i, dt);
        if (gone[i]) book_out(&l->account, ps, i);
        n += gone[i];
    }
    return n;
}

static void take_out(struct life *l, struct particles *ps, struct dem *dem,
                     double dt)
{
    int *const gone = alloc_ints(ps->n);

    if (mark(l, ps, gone, dt) > 0) dem_remove(dem, gone);
    free(gone);
}

static void put_in(struct life *l, struct particles *ps, struct dem *dem,
                   double t)
{
    const int before = ps->n;

    l->account.waiting = 0;
    for (int s = 0; s < l->n_sources; s++) {
        struct insertion *const in = &l->sources[s];
        insertion_step(in, ps, &l->box, t);
        l->account.waiting += insertion_due(in, t) - in->done;
    }
    for (int i = before; i < ps->n; i++)
        l->account.mass_in += ps->m[i];
    l->account.came += ps->n - before;
    if (ps->n > before) dem_changed(dem);
}

int life_step(struct life *l, struct particles *ps, struct dem *dem, double t,
              double dt)
{
    if (l->n_sinks > 0) take_out(l, ps, dem, dt);
    const int before = ps->n;
    put_in(l, ps, dem, t);
    return before;
}

void life_save(const struct life *l, const struct particles *ps, FILE *f)
{
    const struct life_account *const a = &l->account;

    fprintf(f, "life %d %d %ld %ld %a %a %a %a %a\n", ps->next_id, l->n_sources,
            a->came, a->went, a->mass_in, a->mass_out, a->momentum[0],
            a->momentum[1], a->momentum[2]);
    for (int s = 0; s < l->n_sources; s++)
        fprintf(f, "source %ld %ld\n", l->sources[s].done, l->sources[s].tried);
}

int life_load(struct life *l, struct particles *ps, FILE *f)
{
    struct life_account *const a = &l->account;
    int n = -1;

    if (fscanf(f, " life %d %d %ld %ld %la %la %la %la %la", &ps->next_id, &n,
               &a->came, &a->went, &a->mass_in, &a->mass_out, &a->momentum[0],
               &a->momentum[1], &a->momentum[2]) != 9 ||
        n != l->n_sources)
        return 1;
    for (int s = 0; s < n; s++)
        if (fscanf(f, " source %ld %ld", &l->sources[s].done,
                   &l->sources[s].tried) != 2)
            return 1;
    return 0;
}
