/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/recorder_part.h"

#include <assert.h>
#include <stddef.h>

int recorder_part_create(struct recorder_part_list *l, const struct settings *s,
                         const struct simulation *sim, struct folder *folder)
{
    for (int i = 0; recorder_parts[i] != NULL; i++) {
        assert(i < RECORDER_PART_MOST);
        if (!settings_has(s, recorder_parts[i]->group)) continue;
        l->memory[i] = recorder_parts[i]->create(s, sim, folder);
        if (l->memory[i] == NULL) return 1;
    }
    return 0;
}

int recorder_part_add(const struct recorder_part_list *l)
{
    for (int i = 0; recorder_parts[i] != NULL; i++)
        if (l->memory[i] != NULL && recorder_parts[i]->add(l->memory[i]) != 0)
            return 1;
    return 0;
}

int recorder_part_finish(const struct recorder_part_list *l)
{
    for (int i = 0; recorder_parts[i] != NULL; i++)
        if (l->memory[i] != NULL &&
            recorder_parts[i]->finish(l->memory[i]) != 0)
            return 1;
    return 0;
}

void recorder_part_free(struct recorder_part_list *l)
{
    for (int i = 0; recorder_parts[i] != NULL; i++)
        if (l->memory[i] != NULL) recorder_parts[i]->free(l->memory[i]);
}
