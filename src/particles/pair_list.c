/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/pair_list.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"

void pair_list_init(struct pair_list *l)
{
    memset(l, 0, sizeof *l);
    l->n_strips = 1;
    pair_list_reserve(l, 16);
}

void pair_list_release(struct pair_list *l)
{
    free(l->i);
    free(l->j);
    free(l->s);
    free(l->touching);
}

void pair_list_reserve(struct pair_list *l, int n)
{
    if (n <= l->capacity) return;
    pair_list_release(l);
    l->capacity = n + n / 2;
    l->i = alloc_ints(l->capacity);
    l->j = alloc_ints(l->capacity);
    l->s = alloc_doubles(3 * l->capacity);
    l->touching = alloc_zeroed((size_t)l->capacity, 1);
}
