/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/population/population.h"

#include <math.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "dem/population/insertion.h"

static int is_removed(const struct population *l,
                      const struct population_sink *sink,
                      const struct particles *ps, int i, double dt)
{
    const int of = ps->clumps != NULL ? ps->clumps->of[ps->id[i]] : -1;
    const double own[3] = {ps->x[i], ps->y[i], ps->z[i]};
    const double *const x =
        of < 0 || sink->side >= 0 ? own : ps->clumps->item[of].x;
    const double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
    const int k = sink->side / 2, upper = sink->side % 2;

    if (sink->side >= 0) {
        const double gap =
            box_domain_gap(&l->box, sink->side, x) - 0.5 * ps->d[i];
        const double nearer = (upper ? v[k] : -v[k]) * dt;
        return gap - (nearer > 0.0 ? nearer : 0.0) <= 0.0;
    }
    for (int a = 0; a < 3; a++)
        if (x[a] < sink->lo[a] || x[a] > sink->hi[a]) return 0;
    return 1;
}

/* Adds particle i to the number, the mass and the momentum of those that came,
 * or went. */
static void population_count(const struct particles *ps, int i, long *n,
                             double *mass, double momentum[3])
{
    const double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};

    ++*n;
    *mass += ps->m[i];
    vector_along(momentum, ps->m[i], v, momentum);
}

int population_mark(struct population *l, const struct particles *ps, double dt)
{
    struct population_totals *const a = &l->totals;
    int n = 0;

    if (l->n_sinks == 0) return 0;
    if (l->is_removed == NULL) l->is_removed = owner_ints(l, ps->capacity);
    for (int i = 0; i < ps->n; i++) {
        l->is_removed[i] = 0;
        for (int s = 0; s < l->n_sinks && !l->is_removed[i]; s++)
            l->is_removed[i] = is_removed(l, &l->sinks[s], ps, i, dt);
    }
    if (ps->clumps != NULL) clumps_mark(ps, l->is_removed);
    for (int i = 0; i < ps->n; i++) {
        if (!l->is_removed[i]) continue;
        population_count(ps, i, &a->removed, &a->mass_out, a->momentum_out);
        n++;
    }
    return n;
}

int population_insert(struct population *l, struct particles *ps,
                      struct dem *dem, double t)
{
    struct population_totals *const a = &l->totals;
    const int before = ps->n;

    a->waiting = 0;
    for (int s = 0; s < l->n_sources; s++) {
        struct insertion *const in = &l->sources[s];
        insertion_step(in, ps, &l->box, t);
        a->waiting += insertion_count_due(in, t) - in->n_inserted;
    }
    for (int i = before; i < ps->n; i++)
        population_count(ps, i, &a->inserted, &a->mass_in, a->momentum_in);
    if (ps->n > before) dem_changed(dem);
    return before;
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
        state_long(s, "n_inserted", "-", &l->sources[k].n_inserted);
        state_long(s, "n_attempts", "-", &l->sources[k].n_attempts);
        state_end(s);
    }
    state_end(s);
}

struct population *population_create(const struct box_domain *box,
                                     int n_sources, int n_sinks)
{
    struct population *const l = owner_create(sizeof *l);

    l->box = *box;
    l->n_sources = n_sources;
    l->n_sinks = n_sinks;
    l->sources = owner_zeroed(l, (size_t)n_sources, sizeof *l->sources);
    l->sinks = owner_zeroed(l, (size_t)n_sinks, sizeof *l->sinks);
    return l;
}

/* --- overlaps ------------------------------------------------------------- */

/* [-] Each round moves pairs apart by a little more than their overlap;
 * otherwise rounding and neighbours would leave some overlaps for ever. */
static const double push = 1.02;

/* x_i - x_j, nearest image, and its length. */
static double overlaps_apart(const struct particles *ps,
                             const struct box_domain *box, int i, int j,
                             double d[3])
{
    const double *const x[3] = {ps->x, ps->y, ps->z};

    for (int k = 0; k < 3; k++)
        d[k] = box_domain_nearest(box, k, x[k][i] - x[k][j]);
    return vector_length(d);
}

/* A sphere's coordinate along the direction that all are sorted by. */
struct placed {
    double x; /* [m] */
    int i;
};

static int by_x(const void *a, const void *b)
{
    const struct placed *const p = a, *const q = b;
    return (p->x > q->x) - (p->x < q->x);
}

/* The direction in which the spheres spread the farthest. */
static int longest(const struct particles *ps)
{
    const double *const x[3] = {ps->x, ps->y, ps->z};
    double most = -1.0;
    int along = 0;

    for (int k = 0; k < 3; k++) {
        double lo = HUGE_VAL, hi = -HUGE_VAL;
        for (int i = 0; i < ps->n; i++) {
            lo = fmin(lo, x[k][i]);
            hi = fmax(hi, x[k][i]);
        }
        if (hi - lo > most) {
            most = hi - lo;
            along = k;
        }
    }
    return along;
}

/* The deeper one; of two that are equal the first by i, then by j. */
static void keep_deeper(struct overlap *found, const struct particles *ps,
                        const struct box_domain *box, int a, int b)
{
    const int i = a > b ? a : b, j = a > b ? b : a;
    double d[3];
    const double mean = 0.5 * (ps->d[i] + ps->d[j]);
    if (ps->clumps != NULL && clumps_are_one(ps, i, j)) return;
    const double depth = 1.0 - overlaps_apart(ps, box, i, j, d) / mean;

    if (depth > found->depth ||
        (depth > 0.0 && depth == found->depth &&
         (i < found->j || (i == found->j && j < found->i))))
        *found = (struct overlap){j, i, depth};
}

/* In the order of one coordinate only those in reach have to be looked at; in a
 * period the first follow the last. */
struct overlap overlaps_deepest(const struct particles *ps,
                                const struct box_domain *box)
{
    struct placed *const list = alloc_zeroed((size_t)ps->n, sizeof *list);
    const int k = longest(ps);
    const double *const x = k == 0 ? ps->x : k == 1 ? ps->y : ps->z;
    const double reach = particles_widest(ps) * (1.0 + 1e-9),
                 L = box->length[k];
    struct overlap found = {0, -1, 0.0};

    for (int i = 0; i < ps->n; i++)
        list[i] = (struct placed){box_domain_inside(box, k, x[i]), i};
    qsort(list, (size_t)ps->n, sizeof *list, by_x);
    for (int p = 0; p < ps->n; p++)
        for (int next = p + 1; next < p + ps->n; next++) {
            const int wrapped = next >= ps->n, q = next - wrapped * ps->n;
            if (wrapped && L == 0.0) break;
            if (list[q].x + (wrapped ? L : 0.0) - list[p].x > reach) break;
            keep_deeper(&found, ps, box, list[p].i, list[q].i);
        }
    free(list);
    return found;
}

/* Two centres at the same position are moved apart along x. */
static void move_apart(struct particles *ps, const struct box_domain *box,
                       int i, int j)
{
    double *const x[3] = {ps->x, ps->y, ps->z};
    double d[3];
    const double r = overlaps_apart(ps, box, i, j, d),
                 mean = 0.5 * (ps->d[i] + ps->d[j]);

    if (r >= mean) return;
    for (int k = 0; k < 3; k++) {
        const double n = r > 0.0 ? d[k] / r : k == 0;
        x[k][i] += 0.5 * push * (mean - r) * n;
        x[k][j] -= 0.5 * push * (mean - r) * n;
    }
}

static void keep_inside(struct particles *ps, const struct box_domain *box,
                        int i)
{
    double *const x[3] = {ps->x, ps->y, ps->z};
    const double R = 0.5 * ps->d[i];

    for (int k = 0; k < 3; k++) {
        if (box->periodic[k]) continue;
        x[k][i] = fmin(fmax(x[k][i], box->lo[k] + R), box->hi[k] - R);
    }
}

int overlaps_relax(struct particles *ps, const struct box_domain *box, int most)
{
    for (int round = 0; round <= most; round++) {
        if (overlaps_deepest(ps, box).depth <= OVERLAPS_MAX) return round;
        for (int i = 0; i < ps->n; i++)
            for (int j = 0; j < i; j++)
                move_apart(ps, box, i, j);
        for (int i = 0; i < ps->n; i++)
            keep_inside(ps, box, i);
    }
    return -1;
}
