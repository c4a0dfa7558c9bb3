/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/strip.h"

#include <string.h>

#include "particles/strip_gap.h"

void strip_note(struct strip_deep *d, double overlap, int id, int other,
                const double x[3])
{
    if (!(overlap > d->overlap)) return;
    d->overlap = overlap;
    d->id = id;
    d->other = other;
    memcpy(d->at, x, sizeof d->at);
}

/* As the contact loop has it: a wall stands for a sphere of the same size. */
static void note_pair(struct strip *s, const struct bodies *b, int q)
{
    const int i = s->contacts.owner[q], j = s->contacts.partner[q];
    const double sum = b->place[i][3] + b->place[j][3];

    strip_note(&s->deep, -strip_pair_gap(b, i, j) / sum, b->id[i], b->id[j],
               b->place[i]);
}

static void note_wall(struct strip *s, const struct bodies *b, int q)
{
    const int i = s->contacts.owner[q], wall = s->contacts.partner[q];

    strip_note(&s->deep, -0.5 * strip_wall_gap(b, i, wall) / b->place[i][3],
               b->id[i], -1 - wall, b->place[i]);
}

void strip_look_deep(struct strip *s, const struct bodies *b,
                     const struct block *from, const struct block *to)
{
    for (int q = from->pairs; q < to->pairs; q++)
        note_pair(s, b, q);
    for (int q = from->walls; q < to->walls; q++)
        note_wall(s, b, q);
    if (s->deepest > s->deep.overlap) s->deep.overlap = s->deepest;
}
