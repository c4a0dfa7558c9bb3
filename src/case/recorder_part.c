/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/recorder_part.h"

#include <assert.h>
#include <stddef.h>

int recorder_part_create(struct recorder_part_list *l,
                         const struct recorder_view *v)
{
    int failed = 0;

    for (int i = 0; recorder_parts[i] != NULL && !failed; i++) {
        assert(l->n < RECORDER_PART_MOST);
        l->part[l->n] = recorder_parts[i];
        l->state[l->n] = recorder_parts[i]->create(v, &failed);
        l->n += l->state[l->n] != NULL;
    }
    return failed;
}

void recorder_part_free(struct recorder_part_list *l)
{
    for (int i = 0; i < l->n; i++)
        l->part[i]->free(l->state[i]);
}

int recorder_part_columns(const struct recorder_part_list *l,
                          const struct history_column **column, int room)
{
    int n = 0;

    for (int i = 0; i < l->n; i++)
        for (const struct history_column *c = l->part[i]->columns;
             c != NULL && c->name != NULL && n < room; c++)
            column[n++] = c;
    return n;
}

void recorder_part_summarize(const struct recorder_part_list *l,
                             struct summary *f)
{
    for (int i = 0; i < l->n; i++)
        if (l->part[i]->summarize != NULL)
            l->part[i]->summarize(l->state[i], f);
}

void recorder_part_print(const struct recorder_part_list *l)
{
    for (int i = 0; i < l->n; i++)
        if (l->part[i]->print != NULL) l->part[i]->print(l->state[i]);
}

/* Calls one function of all parts that have it, up to the first that fails. */
#define EACH_PART(function, ...)                                               \
    int failed = 0;                                                            \
    for (int i = 0; i < l->n && !failed; i++)                                  \
        if (l->part[i]->function != NULL)                                      \
            failed = l->part[i]->function(__VA_ARGS__);                        \
    return failed

int recorder_part_row(const struct recorder_part_list *l)
{
    EACH_PART(row, l->state[i]);
}

int recorder_part_last_row(const struct recorder_part_list *l)
{
    EACH_PART(last_row, l->state[i]);
}

int recorder_part_fields(const struct recorder_part_list *l, double t)
{
    EACH_PART(fields, l->state[i], t);
}

int recorder_part_finish(const struct recorder_part_list *l)
{
    EACH_PART(finish, l->state[i]);
}

void recorder_part_state(const struct recorder_part_list *l, struct state *s)
{
    for (int i = 0; i < l->n; i++)
        if (l->part[i]->state != NULL) l->part[i]->state(l->state[i], s);
}
