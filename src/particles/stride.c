/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/stride.h"

#include <string.h>

#include "particles/response.h"

static void advance(const struct neighbours *nb, struct strip *own, int begin,
                    int end, const struct stride *by)
{
    double(*const load)[8] = own->load + (begin - own->begin);

    if (nb->drive != NULL && by->driven)
        driven_steer(nb->drive, nb->bodies, nb->ps, begin, end, load, by->t,
                     by->drift);
    if (nb->bodies->response == NULL)
        bodies_advance(nb->bodies, begin, end, load, by->kick, by->drift,
                       own->so_far);
    else
        response_advance(nb->bodies, begin, end, load, by->kick, by->drift,
                         own->so_far);
    if (by->budget) strip_work(own, nb->bodies, begin, end, by->drift);
}

/* Of the first particles of strip s, how many bear loads from strips that this
 * thread has not done before it. A strip lays loads on later ones; in a
 * periodic direction the first come after the last, in a lone strip, too.
 * What is not contacts comes after the blocks. */
static int reached(const struct neighbours *nb, int s, const struct stride *by)
{
    const int *const around = nb->bodies->box.periodic;
    const int n = nb->bodies->n, first = neighbours_work(nb).first;
    int most = 0;

    if (nb->surfaces != NULL || by->n_attractions > 0) return n;
    if (nb->count == 1 && (around[0] || around[1] || around[2])) return n;
    for (int t = 0; t < nb->count; t++) {
        const int done = first <= t && t <= s;
        const int m =
            done ? 0 : strip_reached(&nb->strips[s], &nb->strips[t], n);
        most = m > most ? m : most;
    }
    return most;
}

/* The loads of the contacts that end with this block. */
static void load_block(const struct neighbours *nb, struct strip *own, int k,
                       const struct stride *by)
{
    const struct block begin = {own->begin, 0, own->contacts.n_pairs, 0};
    const struct block *const to = &own->blocks[k];
    const struct block *const from = k > 0 ? to - 1 : &begin;

    memset(own->load + from->reach, 0,
           (size_t)(to->reach - from->reach) * sizeof *own->load);
    by->sweep(own, nb->bodies, by->constants, by->dt, from->pairs, to->pairs);
    by->sweep(own, nb->bodies, by->constants, by->dt, from->walls, to->walls);
    if (own->deepest > own->deep.overlap)
        strip_look_deep(own, nb->bodies, from, to);
}

/* Attractions; a budget books their power. Nobody has moved yet. */
static void attract(const struct bodies *b, struct strip *own,
                    const struct stride *by)
{
    const int books = by->budget && by->n_attractions > 0;
    const double before = books ? strip_power(own, b) : 0.0;

    for (int k = 0; k < by->n_attractions; k++)
        by->attractions[k].law->sweep(own, b, &by->attractions[k]);
    if (books) own->energy.attracted += by->dt * (strip_power(own, b) - before);
}

/* What surfaces and attractions lay on a strip. */
static void load_others(struct neighbours *nb, int s, const struct stride *by)
{
    struct strip *const own = &nb->strips[s];

    if (nb->surfaces != NULL)
        surfaces_push(nb->surfaces, s, own, nb->bodies, by->sweep,
                      by->constants, by->dt);
    attract(nb->bodies, own, by);
}

/* Loads, then motion, block by block. Waiting are those on which others may
 * still lay loads, or whose places these still need. */
static void take_strip(struct neighbours *nb, int s, const struct stride *by,
                       int waiting)
{
    struct strip *const own = &nb->strips[s];
    const int late = own->begin + reached(nb, s, by);

    for (int k = 0, begin = own->begin; k < own->n_blocks; k++) {
        const int end = own->blocks[k].end;
        if (!waiting) load_block(nb, own, k, by);
        if ((begin < late) == waiting) {
            strip_fold(nb->strips, nb->count, s, nb->bodies->n, begin, end);
            advance(nb, own, begin, end, by);
        }
        begin = end;
    }
    if (!waiting) load_others(nb, s, by);
}

/* What it found is shown to all when all are done with what was found before.
 */
static void show_fastest(struct strip *own)
{
    memcpy(own->fastest, own->so_far, sizeof own->fastest);
    memset(own->so_far, 0, sizeof own->so_far);
}

void stride_take(struct neighbours *nb, const struct stride *by)
{
    const struct neighbours_share mine = neighbours_work(nb);

    for (int s = mine.first; s < mine.last; s++) {
        if (by->budget) strip_open_budget(&nb->strips[s].energy);
        take_strip(nb, s, by, 0);
        if (by->budget) strip_close_budget(&nb->strips[s].energy);
    }
    neighbours_meet(nb);
    for (int s = mine.first; s < mine.last; s++) {
        take_strip(nb, s, by, 1);
        show_fastest(&nb->strips[s]);
    }
    neighbours_meet(nb);
}

void stride_move(struct neighbours *nb, const struct stride *by)
{
    const struct neighbours_share mine = neighbours_share(nb);

    for (int s = mine.first; s < mine.last; s++) {
        struct strip *const own = &nb->strips[s];
        advance(nb, own, own->begin, own->end, by);
        show_fastest(own);
    }
    neighbours_meet(nb);
}
