/* SPDX-License-Identifier: GPL-3.0-or-later */
/* fast_state.c -- the visit of the lists and chunks, and the contact histories
 * as a list.  Chapter "Nothing is lost". */
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "dem/fast/fast.h"
#include "dem/surfaces/surfaces.h"

/* Makes a loaded list by adding its pairs anew. */
static void chunk_state_add_partners(struct chunk *c, struct neighbour_list *v,
                                     int n, const int *partner)
{
    if (v == &c->pairs && n > 0) {
        memcpy(chunk_room_for_pairs(c, n), partner,
               (size_t)n * sizeof *partner);
        c->pairs.n += n;
    } else {
        for (int q = 0; q < n; q++)
            chunk_add_wall(c, partner[q]);
    }
}

enum { WALLS = 6 };

/* Partners are below `most`. */
static void partners_state(struct chunk *c, struct neighbour_list *v, int most,
                           struct state *s)
{
    const long owners = c->end - c->begin + 1L;
    int n = v->n;

    state_count(s, "count", &n, INT_MAX);
    int *const partner = s->loading ? alloc_ints(n) : v->partner;
    state_indices(s, "partner", partner, n, 0, most - 1);
    state_indices(s, "start", v->start, owners, 0, n);
    state_demand(s, state_rises(v->start, owners, 0, n),
                 "lists that do not follow each other");
    if (!s->loading) return;
    if (!s->failed) chunk_state_add_partners(c, v, n, partner);
    free(partner);
}

/* 1 if each contact is that of its place in the list, so that its loads have
 * theirs. */
static int are_listed(const struct chunk *c)
{
    const struct chunk_contacts *const k = &c->contacts;

    for (int q = 0; q < k->n_pairs + k->n_walls; q++) {
        const struct neighbour_list *const v =
            q < k->n_pairs ? &c->pairs : &c->walls;
        const int at = k->list_index[q], a = k->owner[q] - c->begin;
        if (at < v->start[a] || at >= v->start[a + 1] ||
            v->partner[at] != k->partner[q])
            return 0;
    }
    return 1;
}

static void chunk_state_contacts(struct chunk *c, int n_spheres,
                                 struct state *s)
{
    static const char *const xi[] = {"xi_x", "xi_y", "xi_z"};
    static const char *const roll[] = {"roll_x", "roll_y", "roll_z"};
    struct chunk_contacts *const k = &c->contacts;

    state_begin(s, "contacts");
    state_count(s, "pairs", &k->n_pairs, c->pairs.n);
    state_count(s, "walls", &k->n_walls, c->walls.n);
    const long n = k->n_pairs + k->n_walls;
    if (s->loading) chunk_reserve_contacts(c, (int)n, 0);
    state_indices(s, "owner", k->owner, n, c->begin, c->end - 1);
    state_indices(s, "partner", k->partner, n, 0,
                  n_spheres > WALLS ? n_spheres - 1 : WALLS - 1);
    state_wholes(s, "list_index", "-", k->list_index, n, 1);
    if (s->loading && !s->failed)
        state_demand(s, are_listed(c), "a contact that is not in its list");
    for (int a = 0; a < 3; a++) {
        state_reals(s, xi[a], "m", k->xi[a], n, 1);
        state_reals(s, roll[a], "rad", k->roll_angle[a], n, 1);
    }
    state_end(s);
}

/* Of its own particles: nobody asks for those on others after a step. */
static void loads_state(struct chunk *c, struct state *s)
{
    const size_t size = sizeof *c->load;
    const long n = c->end - c->begin;

    state_reals_of(s, "load", "N", c->load->F, size, n, 3);
    state_reals_of(s, "load_turning", "N", c->load->turn, size, n, 3);
}

/* 1 if its blocks are those of its contacts. */
static int blocks_fit(const struct chunk *c, int n)
{
    const size_t size = sizeof *c->blocks, count = (size_t)c->n_blocks;
    struct chunk_block *const own = alloc_zeroed(count, size);

    chunk_split(c, n, own);
    const int fit = count == 0 || memcmp(own, c->blocks, count * size) == 0;
    free(own);
    return fit;
}

/* Visits the lists and the arrays whose sizes follow from them. */
static void lists_state(struct chunk *c, int n, struct state *s)
{
    const size_t size = sizeof *c->blocks;

    if (s->loading) chunk_clear_lists(c);
    state_begin(s, "pairs");
    partners_state(c, &c->pairs, n, s);
    state_end(s);
    state_begin(s, "walls");
    partners_state(c, &c->walls, WALLS, s);
    state_end(s);
    if (s->loading && !s->failed) chunk_finish_lists(c, n);
    chunk_state_contacts(c, n, s);
    state_wholes_of(s, "block_end", "-", &c->blocks->end, size, c->n_blocks, 1);
    state_wholes_of(s, "block_pairs", "-", &c->blocks->pairs, size, c->n_blocks,
                    1);
    state_wholes_of(s, "block_walls", "-", &c->blocks->walls, size, c->n_blocks,
                    1);
    state_wholes_of(s, "block_loads", "-", &c->blocks->n_loads, size,
                    c->n_blocks, 1);
    state_demand(s, s->failed || !s->loading || blocks_fit(c, n),
                 "blocks that are not those of its contacts");
    if (c->n_history > 0) return; /* they are where the loads are */
    if (c->window > 0) loads_state(c, s);
    if (c->window > 0 && c->has_budget)
        state_reals(s, "part", "N", c->part[0]->F, c->window, 8 * ENERGY_PARTS);
}

static void chunk_state_histories(struct chunk *c, int n_spheres,
                                  struct state *s)
{
    int n = c->n_history;

    state_begin(s, "histories");
    state_count(s, "count", &n, INT_MAX);
    if (s->loading && !s->failed) chunk_reserve_history(c, n);
    struct contact_history *const all = chunk_history(c);
    state_indices_of(s, "owner", &all->owner, sizeof *all, n, 0, n_spheres - 1);
    state_indices_of(s, "partner", &all->partner, sizeof *all, n, -WALLS,
                     n_spheres - 1);
    state_reals_of(s, "xi", "m", all->xi, sizeof *all, n, 3);
    state_reals(s, "roll_angle", "rad", (double *)c->roll_history, n, 3);
    state_end(s);
}

void chunk_energy_state(struct chunk_energy *e, struct state *s)
{
    double *const all[] = {&e->normal,    &e->tangential, &e->stored,
                           &e->damped_n,  &e->damped_t,   &e->slid,
                           &e->released,  &e->rolled,     &e->work,
                           &e->attracted, &e->prescribed};

    state_several(s, "energy", "J", all, sizeof all / sizeof *all);
    state_whole(s, "skip_release", "-", &e->skip_release);
}

static void chunk_state(struct chunk *c, int n, int capacity, struct state *s)
{
    int listed = c->contacts.capacity > 0;

    state_whole(s, "listed", "-", &listed);
    chunk_state_histories(c, capacity, s);
    if (listed) lists_state(c, n, s);
    state_real(s, "deep_overlap", "-", &c->deep.depth);
    state_whole(s, "deep_id", "-", &c->deep.id);
    state_whole(s, "deep_other", "-", &c->deep.other);
    state_reals(s, "deep_at", "m", c->deep.at, 3, 1);
    state_reals(s, "max_speed", "m/s", c->max_speed, 4, 1);
    chunk_energy_state(&c->energy, s);
}

static void prescribed_state(struct prescribed_particles *d, struct state *s)
{
    if (d == NULL) return;
    state_begin(s, "prescribed");
    state_wholes(s, "is_on", "-", d->is_on, d->n, 1);
    state_end(s);
}

/* The sort and its cells are made anew at each rebuild; the rows are loaded at
 * the beginning of each run. */
static void neighbours_state(struct neighbours *nb, struct state *s)
{
    struct rows *const b = nb->rows;

    state_begin(s, "neighbours");
    state_real(s, "skin", "m", &nb->skin);
    state_real(s, "margin", "m", &nb->margin);
    state_real(s, "margin_used", "m", &nb->margin_used);
    state_whole(s, "stale", "-", &nb->stale);
    state_whole(s, "history_given", "-", &nb->history_given);
    state_long(s, "rebuilds", "-", &nb->rebuilds);
    state_count(s, "listed", &b->n, nb->ps->capacity);
    if (b->n > 0)
        state_reals(s, "position_at_rebuild", "m", *b->listed, b->n, 3);
    if (b->n > 0)
        state_reals(s, "position_and_reach", "m", b->chosen->x, b->n, 4);
    for (int k = 0; k < nb->n_chunks; k++) {
        if (s->loading) chunk_set_range(&nb->chunks[k], k, nb->n_chunks, b->n);
        state_begin_number(s, "chunk", k);
        chunk_state(&nb->chunks[k], b->n, nb->ps->capacity, s);
        state_end(s);
    }
    if (nb->surfaces != NULL)
        surfaces_state(nb->surfaces, nb->chunks, nb->ps->capacity, s);
    prescribed_state(nb->prescribed, s);
    state_end(s);
}

void fast_state(struct dem *dem, struct state *s)
{
    state_real(s, "min_margin", "m", &fast_of(dem)->min_margin);
    if (dem->options.integrator->adapts)
        state_real(s, "next_step", "s", &fast_of(dem)->adaptive.next);
    neighbours_state(fast_of(dem)->neighbours, s);
}

/* Writes the histories of a chunk, those `given` for the next run or those of
 * its contacts, unless `to` is NULL; their number. */
static int histories_of(const struct chunk *c, int given, const int *id,
                        struct dem_history *to)
{
    const struct chunk_contacts *const all = &c->contacts;
    struct contact_history k;
    double roll[3] = {0.0, 0.0, 0.0};
    int n = 0;

    for (int q = 0; q < (given ? c->n_history : all->n_pairs + all->n_walls);
         q++) {
        if (given) {
            k = chunk_history(c)[q];
            if (c->has_rolling) memcpy(roll, c->roll_history[q], sizeof roll);
        } else if (!chunk_contact_history(c, q, &k, roll)) {
            continue;
        }
        if (to != NULL) {
            to[n] = (struct dem_history){.id = id[k.owner]};
            to[n].other = k.partner < 0 ? k.partner : id[k.partner];
            memcpy(to[n].xi, k.xi, sizeof k.xi);
            memcpy(to[n].roll_angle, roll, sizeof roll);
        }
        n++;
    }
    return n;
}

struct dem_history *fast_histories(struct dem *dem, int *n)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;
    const int given = nb->history_given;
    const struct particles *const ps = given ? NULL : nb->ps;
    struct dem_history *list;
    int own = 0;

    for (int s = 0; s < nb->n_chunks; s++)
        own += histories_of(&nb->chunks[s], given, nb->ps->id, NULL);
    *n = own + surface_history_list(nb->surfaces, ps, NULL);
    list = alloc_zeroed((size_t)*n, sizeof *list);
    for (int s = 0, at = 0; s < nb->n_chunks; s++)
        at += histories_of(&nb->chunks[s], given, nb->ps->id, list + at);
    surface_history_list(nb->surfaces, ps, list + own);
    return list;
}

void fast_restore_histories(struct dem *dem, const struct dem_history *list,
                            int n, const int *index)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;
    const long own = n - surface_history_restore(nb->surfaces, list, n);

    nb->stale = nb->history_given = 1;
    for (int s = 0; s < nb->n_chunks; s++) {
        struct chunk *const c = &nb->chunks[s];
        chunk_reserve_history(
            c, (int)(own * (s + 1) / nb->n_chunks - own * s / nb->n_chunks));
        for (int q = 0; q < c->n_history; q++, list++) {
            struct contact_history *const k = &chunk_history(c)[q];
            k->owner = index[list->id];
            k->partner = list->other < 0 ? list->other : index[list->other];
            memcpy(k->xi, list->xi, sizeof k->xi);
            if (c->has_rolling)
                memcpy(c->roll_history[q], list->roll_angle,
                       sizeof list->roll_angle);
        }
    }
}
