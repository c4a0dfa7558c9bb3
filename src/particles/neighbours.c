/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/neighbours.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "particles/contact_loop.h"

struct neighbours *neighbours_create(const struct particles *ps,
                                     const double low[3], const double high[3],
                                     const int periodic[3], double skin,
                                     double d_max)
{
    struct neighbours *const nb = alloc_zeroed(1, sizeof *nb);

    nb->skin = skin;
    pair_list_init(&nb->pairs);
    pair_list_init(&nb->walls);
    pair_list_init(&nb->old);
    /* A settled bed has 5 to 6 pairs a particle at a skin of 0.3 d; with this
     * room the lists hardly ever grow during a run. */
    pair_list_reserve(&nb->pairs, 8 * ps->capacity);
    pair_list_reserve(&nb->walls, 2 * ps->capacity);
    pair_list_reserve(&nb->old, 10 * ps->capacity);
    for (int a = 0; a < 3; a++) {
        nb->periodic[a] = periodic[a];
        nb->pairs.period[a] = periodic[a] ? high[a] - low[a] : 0.0;
        nb->walls.low[a] = low[a];
        nb->walls.high[a] = high[a];
    }
    nb->bins = bins_create(low, high, periodic, d_max + skin, ps->capacity);
    nb->row = alloc_ints(ps->capacity + 1);
    nb->place = alloc_ints(ps->capacity);
    nb->x0 = alloc_doubles(ps->capacity);
    nb->y0 = alloc_doubles(ps->capacity);
    nb->z0 = alloc_doubles(ps->capacity);
    return nb;
}

void neighbours_free(struct neighbours *nb)
{
    if (nb == NULL) return;
    pair_list_release(&nb->pairs);
    pair_list_release(&nb->walls);
    pair_list_release(&nb->old);
    bins_free(nb->bins);
    free(nb->row);
    free(nb->place);
    free(nb->x0);
    free(nb->y0);
    free(nb->z0);
    free(nb);
}

/* --- what touching pairs remember ---------------------------------------- */

static void keep(struct pair_list *old, const struct pair_list *l, int e)
{
    const int k = old->n++;

    old->i[k] = l->i[e];
    old->j[k] = l->j[e];
    memcpy(&old->s[3 * k], &l->s[3 * e], 3 * sizeof *l->s);
}

/* Touching pairs first, then touching walls, from old->start[1] on. */
static void keep_touching(struct neighbours *nb)
{
    struct pair_list *const old = &nb->old;

    pair_list_reserve(old, nb->pairs.n + nb->walls.n);
    old->n = 0;
    for (int e = 0; e < nb->pairs.n; e++)
        if (nb->pairs.touching[e]) keep(old, &nb->pairs, e);
    old->start[1] = old->n;
    for (int e = 0; e < nb->walls.n; e++)
        if (nb->walls.touching[e]) keep(old, &nb->walls, e);
}

/* Puts the springs of old contact k on pair e; turned round if the two
 * particles have changed places. */
static void give_back(const struct pair_list *old, int k, struct pair_list *l,
                      int e, double sign)
{
    for (int a = 0; a < 3; a++)
        l->s[3 * e + a] = sign * old->s[3 * k + a];
    l->touching[e] = 1;
}

static void restore_pairs(struct neighbours *nb)
{
    const struct pair_list *const old = &nb->old;

    for (int k = 0; k < old->start[1]; k++) {
        const int a = nb->place[old->i[k]], b = nb->place[old->j[k]];
        const int i = a < b ? a : b, j = a < b ? b : a;
        for (int e = nb->row[i]; e < nb->row[i + 1]; e++)
            if (nb->pairs.j[e] == j)
                give_back(old, k, &nb->pairs, e, a < b ? 1.0 : -1.0);
    }
}

/* Walls are listed by particle: the old contact is looked for from its first
 * entry on, found through row, which now belongs to the walls. */
static void restore_walls(struct neighbours *nb)
{
    const struct pair_list *const old = &nb->old;
    struct pair_list *const l = &nb->walls;

    for (int k = old->start[1]; k < old->n; k++) {
        const int i = nb->place[old->i[k]];
        for (int e = nb->row[i]; e < nb->row[i + 1]; e++)
            if (l->j[e] == old->j[k]) give_back(old, k, l, e, 1.0);
    }
}

/* --- new lists ------------------------------------------------------------ */

static void wrap(struct neighbours *nb, struct particles *ps)
{
    double *const x[3] = {ps->x, ps->y, ps->z};

    for (int a = 0; a < 3; a++) {
        const double low = nb->walls.low[a], L = nb->pairs.period[a];
        for (int i = 0; i < ps->n && nb->periodic[a]; i++)
            x[a][i] -= L * floor((x[a][i] - low) / L);
    }
}

static void sort(struct neighbours *nb, struct particles *ps)
{
    bins_sort(nb->bins, ps);
    for (int i = 0; i < ps->n; i++)
        nb->place[nb->bins->order[i]] = i;
    particles_permute(ps, nb->bins->order);
}

/* The pairs of particle i with later ones; writes j where there is room for
 * it (j != NULL) and returns how many. */
static int list_particle(const struct neighbours *nb,
                         const struct particles *ps, int i, int n_around,
                         const int *around, int *j)
{
    const double *const L = nb->pairs.period;
    int count = 0;

    for (int k = 0; k < n_around; k++) {
        const int first = nb->bins->start[around[k]];
        const int last = nb->bins->start[around[k] + 1];
        for (int p = first > i ? first : i + 1; p < last; p++) {
            const double dx = contact_image(ps->x[i] - ps->x[p], L[0]);
            const double dy = contact_image(ps->y[i] - ps->y[p], L[1]);
            const double dz = contact_image(ps->z[i] - ps->z[p], L[2]);
            const double reach = 0.5 * (ps->d[i] + ps->d[p]) + nb->skin;
            if (dx * dx + dy * dy + dz * dz >= reach * reach) continue;
            if (j != NULL) j[count] = p;
            count++;
        }
    }
    return count;
}

/* One sweep over the bins: counts into row[i + 1], or fills from row[i] on. */
static void sweep(struct neighbours *nb, const struct particles *ps, int fill)
{
#pragma omp parallel for schedule(static)
    for (int c = 0; c < nb->bins->total; c++) {
        int around[27];
        const int first = nb->bins->start[c], last = nb->bins->start[c + 1];
        const int n = first < last ? bins_around(nb->bins, c, around) : 0;
        for (int i = first; i < last; i++) {
            if (!fill) {
                nb->row[i + 1] = list_particle(nb, ps, i, n, around, NULL);
                continue;
            }
            list_particle(nb, ps, i, n, around, &nb->pairs.j[nb->row[i]]);
            for (int e = nb->row[i]; e < nb->row[i + 1]; e++)
                nb->pairs.i[e] = i;
        }
    }
}

static void clear_history(struct pair_list *l)
{
    memset(l->s, 0, 3 * (size_t)l->n * sizeof *l->s);
    memset(l->touching, 0, (size_t)l->n);
}

static void add_up(int *row, int n)
{
    row[0] = 0;
    for (int i = 0; i < n; i++)
        row[i + 1] += row[i];
}

/* As many strips as possible up to `most` such that every j is at most in the
 * strip after that of i. */
static void cut_strips(struct neighbours *nb, int n)
{
    struct pair_list *const l = &nb->pairs;
    int strips = n < 64 * MOST_STRIPS ? 1 : MOST_STRIPS;

    for (int fits = 0; !fits; strips /= 2) {
        l->n_strips = strips;
        for (int s = 0; s <= strips; s++)
            l->particle_start[s] = (int)((long)n * s / strips);
        fits = 1;
        for (int s = 0; s + 2 <= strips && fits; s++)
            for (int e = nb->row[l->particle_start[s]];
                 e < nb->row[l->particle_start[s + 1]]; e++)
                if (l->j[e] >= l->particle_start[s + 2]) fits = 0;
    }
    for (int s = 0; s <= l->n_strips; s++)
        l->start[s] = nb->row[l->particle_start[s]];
}

static void list_pairs(struct neighbours *nb, const struct particles *ps)
{
    sweep(nb, ps, 0);
    add_up(nb->row, ps->n);
    pair_list_reserve(&nb->pairs, nb->row[ps->n]);
    nb->pairs.n = nb->row[ps->n];
    sweep(nb, ps, 1);
    clear_history(&nb->pairs);
    cut_strips(nb, ps->n);
}

static int list_walls_of(const struct neighbours *nb,
                         const struct particles *ps, int i, int *out)
{
    const double x[3] = {ps->x[i], ps->y[i], ps->z[i]};
    const double reach = 0.5 * ps->d[i] + nb->skin;
    int n = 0;

    for (int a = 0; a < 3; a++) {
        if (nb->periodic[a]) continue;
        if (x[a] - nb->walls.low[a] < reach) out[n++] = 2 * a;
        if (nb->walls.high[a] - x[a] < reach) out[n++] = 2 * a + 1;
    }
    return n;
}

/* Walls use row as pairs do, after these are done with it. */
static void list_walls(struct neighbours *nb, const struct particles *ps)
{
    struct pair_list *const l = &nb->walls;
    int near_walls[6];

    for (int i = 0; i < ps->n; i++)
        nb->row[i + 1] = list_walls_of(nb, ps, i, near_walls);
    add_up(nb->row, ps->n);
    pair_list_reserve(l, nb->row[ps->n]);
    l->n = nb->row[ps->n];
    for (int i = 0; i < ps->n; i++) {
        list_walls_of(nb, ps, i, &l->j[nb->row[i]]);
        for (int e = nb->row[i]; e < nb->row[i + 1]; e++)
            l->i[e] = i;
    }
    clear_history(l);
    l->n_strips = nb->pairs.n_strips;
    for (int s = 0; s <= l->n_strips; s++) {
        l->particle_start[s] = nb->pairs.particle_start[s];
        l->start[s] = nb->row[l->particle_start[s]];
    }
}

void neighbours_rebuild(struct neighbours *nb, struct particles *ps)
{
    const size_t size = (size_t)ps->n * sizeof(double);

    keep_touching(nb);
    wrap(nb, ps);
    sort(nb, ps);
    list_pairs(nb, ps);
    restore_pairs(nb);
    list_walls(nb, ps);
    restore_walls(nb);
    memcpy(nb->x0, ps->x, size);
    memcpy(nb->y0, ps->y, size);
    memcpy(nb->z0, ps->z, size);
}

double neighbours_moved(const struct neighbours *nb, const struct particles *ps)
{
    double most = 0.0;

    for (int i = 0; i < ps->n; i++) {
        const double dx = ps->x[i] - nb->x0[i], dy = ps->y[i] - nb->y0[i],
                     dz = ps->z[i] - nb->z0[i];
        most = fmax(most, dx * dx + dy * dy + dz * dz);
    }
    return sqrt(most);
}
