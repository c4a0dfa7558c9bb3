/* SPDX-License-Identifier: GPL-3.0-or-later */
/* engine_summary.c -- what differs from one machine stands in the summary. */
#include "distributed/ranks/engine_internal.h"

#include <stdio.h>
#include <stdlib.h>

/* Lists the files of the three slots. */
static void *engine_summary_create(const struct recorder_view *v, int *failed)
{
    char name[64];
    ((struct engine *)v->sim->processes)->folder = v->folder;
    for (int i = 0; i < 6; i++) {
        snprintf(name, sizeof name, "checkpoint.%s.%d",
                 i % 2 ? "cells" : "grains", i / 2);
        char *const path = folder_file(v->folder, name);
        *failed |= path == NULL;
        free(path);
    }
    return *failed ? NULL : v->sim->processes;
}

static void engine_summary_summarize(const void *of, struct summary *f)
{
    struct engine *const e = *(struct engine *const *)&of;
    const struct partition *const p = &e->part->p;
    char name[32];
    long moved;

    engine_give(COUNT, 0, "");
    double *const all = engine_count(e, &moved);
    summary_begin(f, "engine");
    summary_text(f, "particles", "LAMMPS");
    summary_text(f, "linear_systems", "PETSc");
    summary_text(f, "same_results",
                 "to rounding for any number of ranks and after a resume, not "
                 "to the bit");
    summary_count(f, "ranks", p->size);
    summary_count(f, "ranks_x", p->P[0]);
    summary_count(f, "ranks_y", p->P[1]);
    summary_count(f, "ranks_z", p->P[2]);
    summary_count(f, "layers", p->layers);
    summary_count(f, "particles_on_another_rank", moved);
    for (int r = 0; r < p->size; r++) {
        snprintf(name, sizeof name, "rank_%d", r);
        summary_begin(f, name);
        summary_count(f, "particles", (long)all[3 * r]);
        summary_count(f, "cells", (long)all[3 * r + 1]);
        summary_number(f, "peak_memory", all[3 * r + 2]);
        summary_end(f);
    }
    summary_end(f);
    free(all);
}

const struct recorder_part engine_summary = {
    .create = engine_summary_create, .summarize = engine_summary_summarize};
