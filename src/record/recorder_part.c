/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "record/recorder_part.h"

#include <assert.h>
#include <stddef.h>

#include "coupling/processes.h"

const struct recorder_part *const recorder_parts[] = {&second_half_part,
                                                      &profiles_part,
                                                      &probes_part,
                                                      &effect_shares_part,
                                                      &contacts_part,
                                                      &forces_part,
                                                      &walls_part,
                                                      &particle_fields_part,
                                                      &bodies_record,
                                                      &grains_record,
                                                      &outlines_record,
                                                      &exit_record,
                                                      &case_statistics_output,
                                                      &surface_table_part,
                                                      &surface_fields_part,
                                                      &pictures_part,
                                                      NULL};

int recorder_part_create(struct recorder_part_list *l,
                         const struct recorder_view *v)
{
    int failed = 0, n = 0;

    /* First: it sums over the processes what the other parts write. */
    if (processes_engine != NULL) {
        l->part[n] = processes_engine->summary;
        l->state[n++] = processes_engine->summary->create(v, &failed);
    }
    for (int i = 0; recorder_parts[i] != NULL && !failed; i++) {
        assert(n < RECORDER_PART_MAX);
        l->state[n] = recorder_parts[i]->create(v, &failed);
        if (l->state[n] != NULL) l->part[n++] = recorder_parts[i];
    }
    return failed;
}
