/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/recorder_part.h"

#include <assert.h>
#include <stddef.h>

int recorder_part_create(struct recorder_part_list *l,
                         const struct recorder_view *v)
{
    int failed = 0, n = 0;

    for (int i = 0; recorder_parts[i] != NULL && !failed; i++) {
        assert(n < RECORDER_PART_MAX);
        l->state[n] = recorder_parts[i]->create(v, &failed);
        if (l->state[n] != NULL) l->part[n++] = recorder_parts[i];
    }
    return failed;
}
