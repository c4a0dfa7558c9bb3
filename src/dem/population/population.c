/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/population/population.h"

#include <stdlib.h>

#include "base/alloc.h"

static int is_removed(const struct population *l,
                      const struct population_sink *sink,
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

static void population_add_momentum(double sum[3], const struct particles *ps,
                                    int i)
{
    sum[0] += ps->m[i] * ps->vx[i];
    sum[1] += ps->m[i] * ps->vy[i];
    sum[2] += ps->m[i] * ps->vz[i];
}

static void count_removed(struct population_totals *a,
                          const struct particles *ps, int i)
{
    a->removed++;
    a->mass_out += ps->m[i];
    population_add_momentum(a->momentum_out, ps, i);
}

static void count_inserted(struct population_totals *a,
                           const struct particles *ps, int i)
{
    a->inserted++;
    a->mass_in += ps->m[i];
    population_add_momentum(a->momentum_in, ps, i);
}

int population_mark(struct population *l, const struct particles *ps, double dt)
{
    int n = 0;

    if (l->n_sinks == 0) return 0;
    if (l->capacity < ps->n) {
        free(l->is_removed);
        l->capacity = ps->capacity;
        l->is_removed = alloc_ints(l->capacity);
    }
    for (int i = 0; i < ps->n; i++) {
        l->is_removed[i] = 0;
        for (int s = 0; s < l->n_sinks && !l->is_removed[i]; s++)
            l->is_removed[i] = is_removed(l, &l->sinks[s], ps, i, dt);
        if (l->is_removed[i]) count_removed(&l->totals, ps, i);
        n += l->is_removed[i];
    }
    return n;
}

void population_remove(struct population *l, struct dem *dem)
{
    dem_remove(dem, l->is_removed);
}

int population_insert(struct population *l, struct particles *ps,
                      struct dem *dem, double t)
{
    const int before = ps->n;

    l->totals.waiting = 0;
    for (int s = 0; s < l->n_sources; s++) {
        struct insertion *const in = &l->sources[s];
        insertion_step(in, ps, &l->box, t);
        l->totals.waiting += insertion_count_due(in, t) - in->n_inserted;
    }
    for (int i = before; i < ps->n; i++)
        count_inserted(&l->totals, ps, i);
    if (ps->n > before) dem_changed(dem);
    return before;
}

static void source_state(struct insertion *in, struct state *s)
{
    state_long(s, "n_inserted", "-", &in->n_inserted);
    state_long(s, "n_attempts", "-", &in->n_attempts);
}

void population_state(struct population *l, struct state *s)
{
    struct population_totals *const a = &l->totals;

    state_begin(s, "population");
    state_long(s, "inserted", "-", &a->inserted);
    state_long(s, "removed", "-", &a->removed);
    state_long(s, "waiting", "-", &a->waiting);
    state_real(s, "mass_in", "kg", &a->mass_in);
    state_real(s, "mass_out", "kg", &a->mass_out);
    state_reals(s, "momentum_in", "N s", a->momentum_in, 3, 1);
    state_reals(s, "momentum_out", "N s", a->momentum_out, 3, 1);
    for (int k = 0; k < l->n_sources; k++) {
        state_begin_number(s, "source", k);
        source_state(&l->sources[k], s);
        state_end(s);
    }
    state_end(s);
}

void population_free(struct population *l)
{
    if (l == NULL) return;
    free(l->sources);
    free(l->sinks);
    free(l->is_removed);
    free(l);
}

struct population *population_create(const struct box_domain *box,
                                     int n_sources, int n_sinks)
{
    struct population *const l = alloc_zeroed(1, sizeof *l);

    l->box = *box;
    l->n_sources = n_sources;
    l->n_sinks = n_sinks;
    l->sources = alloc_zeroed((size_t)n_sources, sizeof *l->sources);
    l->sinks = alloc_zeroed((size_t)n_sinks, sizeof *l->sinks);
    return l;
}
