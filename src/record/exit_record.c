/* SPDX-License-Identifier: GPL-3.0-or-later */
/* exit_record.c -- how many bodies have left, in history.csv. */
#include <stddef.h>

#include "record/recorder_part.h"
#include "record/bodies_record.h"
#include "resolved/body_exit.h"

static double left(const struct simulation *sim)
{
    return bodies_record_of(sim)->exit->n_gone;
}

static const struct history_column columns[] = {{"bodies_left [-]", left, 0},
                                                {NULL, NULL, 0}};

/* NULL where none can leave: then there is no column. */
static void *exit_record_create(const struct recorder_view *v, int *failed)
{
    const struct solid_bodies *const b = bodies_record_of(v->sim);
    (void)failed;
    return b != NULL ? b->exit : NULL;
}

/* It has nothing of its own. */
static void exit_record_release(void *exits)
{
    (void)exits;
}

const struct recorder_part exit_record = {.create = exit_record_create,
                                          .free = exit_record_release,
                                          .columns = columns};
