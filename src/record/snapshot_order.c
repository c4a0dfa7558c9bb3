/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "record/snapshot_order.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"

static int compare_ids(const void *a, const void *b)
{
    const int *const i = a, *const j = b;

    return (*i > *j) - (*i < *j);
}

/* Numbers, so many a particle, in the order of the ids; `to` is as long. */
static void put_in_order(const struct snapshot *s, int width, double *values,
                         double *to)
{
    memcpy(to, values, (size_t)(width * s->n) * sizeof *to);
    for (int i = 0; i < s->n; i++)
        for (int k = 0; k < width; k++)
            values[width * i + k] = to[width * s->order[2 * i + 1] + k];
}

static void put_materials_in_order(struct snapshot *s)
{
    int *const room = alloc_ints(s->n);

    for (int i = 0; i < s->n; i++)
        room[i] = s->material[s->order[2 * i + 1]];
    memcpy(s->material, room, (size_t)s->n * sizeof *room);
    free(room);
}

/* order: pairs of id and place. */
static void snapshot_order_sort(struct snapshot *s)
{
    double *const group[] = {s->x[0], s->x[1], s->x[2], s->v[0],
                             s->v[1], s->v[2], s->w[0], s->w[1],
                             s->w[2], s->d,    s->speed};
    double *const room = alloc_doubles(3 * s->n);

    for (int i = 0; i < s->n; i++) {
        s->order[2 * i] = s->id[i];
        s->order[2 * i + 1] = i;
    }
    qsort(s->order, (size_t)s->n, 2 * sizeof *s->order, compare_ids);
    for (size_t a = 0; a < sizeof group / sizeof *group; a++)
        put_in_order(s, 1, group[a], room);
    for (int a = 0; a < s->n_more; a++)
        put_in_order(s, s->more[a]->components, s->value[a], room);
    free(room);
    if (s->material != NULL) put_materials_in_order(s);
    for (int i = 0; i < s->n; i++)
        s->id[i] = s->order[2 * i];
}

void snapshot_order_by_id(struct snapshot *s)
{
    s->order = alloc_ints(2 * s->capacity);
    s->arrange = snapshot_order_sort;
}
