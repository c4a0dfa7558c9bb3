/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/fast/chunk.h"

#include <string.h>

#include "dem/fast/chunk_gap.h"

void chunk_record_overlap(struct chunk_deep *d, double overlap, int id,
                          int other, const double x[3])
{
    if (!(overlap > d->overlap)) return;
    d->overlap = overlap;
    d->id = id;
    d->other = other;
    memcpy(d->at, x, sizeof d->at);
}

/* As in the contact loop, a wall counts as a sphere of the same radius. */
static void note_pair(struct chunk *s, const struct bodies *b, int q)
{
    const int i = s->contacts.owner[q], j = s->contacts.partner[q];
    const double sum = b->position_radius[i][3] + b->position_radius[j][3];

    chunk_record_overlap(&s->deep, -chunk_pair_gap(b, i, j) / sum, b->id[i],
                         b->id[j], b->position_radius[i]);
}

static void note_wall(struct chunk *s, const struct bodies *b, int q)
{
    const int i = s->contacts.owner[q], wall = s->contacts.partner[q];

    chunk_record_overlap(
        &s->deep, -0.5 * chunk_wall_gap(b, i, wall) / b->position_radius[i][3],
        b->id[i], -1 - wall, b->position_radius[i]);
}

void chunk_check_overlaps(struct chunk *s, const struct bodies *b,
                          const struct chunk_block *from,
                          const struct chunk_block *to)
{
    for (int q = from->pairs; q < to->pairs; q++)
        note_pair(s, b, q);
    for (int q = from->walls; q < to->walls; q++)
        note_wall(s, b, q);
    if (s->max_overlap > s->deep.overlap) s->deep.overlap = s->max_overlap;
}
