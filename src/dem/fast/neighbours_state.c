/* SPDX-License-Identifier: GPL-3.0-or-later */
/* neighbours_state.c -- the visit of the lists.  Chapter "Nothing is lost". */
#include "dem/fast/neighbours.h"

#include <limits.h>

static void prescribed_state(struct prescribed_particles *d, struct state *s)
{
    if (d == NULL) return;
    state_begin(s, "prescribed");
    state_wholes(s, "is_on", "-", d->is_on, d->n, 1);
    state_end(s);
}

/* The sort and its cells are made anew at each rebuild; the rows of the bodies
 * are loaded at the beginning of each run. */
void neighbours_state(struct neighbours *nb, struct state *s)
{
    struct bodies *const b = nb->bodies;

    state_begin(s, "neighbours");
    state_real(s, "skin", "m", &nb->skin);
    state_real(s, "margin", "m", &nb->margin);
    state_real(s, "margin_used", "m", &nb->margin_used);
    state_whole(s, "stale", "-", &nb->stale);
    state_whole(s, "history_given", "-", &nb->history_given);
    state_long(s, "rebuilds", "-", &nb->rebuilds);
    state_count(s, "listed", &b->n, nb->ps->capacity);
    if (b->n > 0)
        state_reals(s, "position_at_rebuild", "m", b->position_at_rebuild[0],
                    b->n, 3);
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
