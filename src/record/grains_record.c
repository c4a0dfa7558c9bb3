/* SPDX-License-Identifier: GPL-3.0-or-later */
/* grains_record.c -- what the history has of bodies among particles. */
#include <stddef.h>

#include "record/recorder_part.h"
#include "coupling/effects.h"
#include "resolved/among/among_effect.h"
#include "resolved/among/among_grains.h"

static struct solid_bodies *among(const struct simulation *sim)
{
    return effects_memory(sim, &among_effect);
}

/* Of the particles on the bodies, mean of the last step. */
static double grains_record_push(const struct simulation *sim, int k)
{
    const struct solid_bodies *const b = among(sim);
    double sum = 0.0;

    for (int i = 0; i < b->ps->n; i++)
        sum += b->among->pushed[i][k];
    return sum;
}

static double push_x(const struct simulation *sim)
{
    return grains_record_push(sim, 0);
}

static double push_y(const struct simulation *sim)
{
    return grains_record_push(sim, 1);
}

static double push_z(const struct simulation *sim)
{
    return grains_record_push(sim, 2);
}

/* Cells whose solids found no open cell (mirrors.h). */
static double stuck(const struct simulation *sim)
{
    const struct mirrors *const m = among(sim)->among->mirrors;
    return m != NULL ? mirrors_stuck(m) : 0.0;
}

static const struct history_column columns[] = {
    {"force_of_grains_x [N]", push_x, 0},
    {"force_of_grains_y [N]", push_y, 0},
    {"force_of_grains_z [N]", push_z, 0},
    {"closed_cells_with_solids [-]", stuck, 0},
    {NULL, NULL, 0}};

/* NULL without such bodies: then there are no columns. */
static void *grains_record_create(const struct recorder_view *v, int *failed)
{
    (void)failed;
    return among(v->sim);
}

/* It has nothing of its own. */
static void grains_record_release(void *bodies)
{
    (void)bodies;
}

const struct recorder_part grains_record = {.create = grains_record_create,
                                            .free = grains_record_release,
                                            .columns = columns};
