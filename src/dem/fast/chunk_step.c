/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/fast/chunk_step.h"

#include <string.h>

#include "dem/fast/attraction_loop.h"
#include "dem/fast/drag_rows.h"

/* Sets the velocities of prescribed particles; their work on others and the
 * energy that they gain come from outside. */
static void chunk_step_set_prescribed(const struct neighbours *nb,
                                      struct chunk *own, int begin, int end,
                                      double (*load)[8],
                                      const struct step_parameters *by)
{
    if (nb->prescribed == NULL || !by->prescribed) return;
    own->energy.prescribed += prescribed_particles_set_velocities(
        nb->prescribed, nb->bodies, nb->ps, begin, end, load, by->t, by->drift,
        by->kick);
}

static void chunk_step_advance(const struct neighbours *nb, struct chunk *own,
                               int begin, int end,
                               const struct step_parameters *by)
{
    double(*const load)[8] = own->load + (begin - own->begin);
    struct bodies *const b = nb->bodies;

    if (by->budget && end > begin)
        memcpy(b->before[begin], b->velocity[begin],
               (size_t)(end - begin) * sizeof *b->before);
    chunk_step_set_prescribed(nb, own, begin, end, load, by);
    if (nb->bodies->implicit_drag == NULL)
        bodies_advance(nb->bodies, begin, end, load, by->kick, by->drift,
                       own->max_speed_now);
    else
        drag_rows_advance(nb->bodies, begin, end, load, by->kick, by->drift,
                          own->max_speed_now);
}

/* What the budget counts after all particles of the chunk have moved, in an
 * order that does not depend on the threads. */
static void chunk_step_count(const struct neighbours *nb, int s,
                             const struct step_parameters *by)
{
    struct chunk *const own = &nb->chunks[s];
    const struct chunk_kick kick = {
        by->kick, by->from, 1.0, nb->bodies->before, nb->bodies->velocity,
        own->part};

    if (!by->budget) return;
    chunk_count_kick(own, nb->bodies, &kick);
    if (nb->surfaces != NULL)
        surface_contacts_count(&nb->surfaces->chunk[s],
                               (1.0 - by->from) * by->kick);
}

/* Number of particles at the beginning of chunk s that receive loads from
 * chunks that this thread has not computed yet. A chunk adds loads to later
 * ones; in a periodic direction the first chunk follows the last one, also if
 * there is only one. Forces other than contacts are computed after the blocks.
 */
static int n_shared(const struct neighbours *nb, int s,
                    const struct step_parameters *by)
{
    const int *const around = nb->bodies->box.periodic;
    const int n = nb->bodies->n, first = neighbours_balanced_range(nb).first;
    int most = 0;

    if (nb->surfaces != NULL || by->n_attractions > 0) return n;
    if (nb->n_chunks == 1 && (around[0] || around[1] || around[2])) return n;
    for (int t = 0; t < nb->n_chunks; t++) {
        const int done = first <= t && t <= s;
        const int m =
            done ? 0 : chunk_shared_loads(&nb->chunks[s], &nb->chunks[t], n);
        most = m > most ? m : most;
    }
    return most;
}

/* The loads of the contacts that end with this block. */
static void load_block(const struct neighbours *nb, struct chunk *own, int k,
                       const struct step_parameters *by)
{
    const struct chunk_block begin = {own->begin, 0, own->contacts.n_pairs, 0};
    const struct chunk_block *const to = &own->blocks[k];
    const struct chunk_block *const from = k > 0 ? to - 1 : &begin;

    memset(own->load + from->n_loads, 0,
           (size_t)(to->n_loads - from->n_loads) * sizeof *own->load);
    if (by->budget)
        memset(own->part + from->n_loads, 0,
               (size_t)(to->n_loads - from->n_loads) * sizeof *own->part);
    by->sweep(own, nb->bodies, by->constants, by->dt, from->pairs, to->pairs);
    by->sweep(own, nb->bodies, by->constants, by->dt, from->walls, to->walls);
    if (own->max_overlap > own->deep.overlap)
        chunk_check_overlaps(own, nb->bodies, from, to);
}

/* Adds sign times the loads to the part of the attractions. */
static void add_to_attractions(struct chunk *own, double sign)
{
    for (int q = 0; q < own->window; q++)
        for (int k = 0; k < 3; k++)
            own->part[q][ENERGY_ATTRACTIONS][k] += sign * own->load[q][k];
}

static void chunk_step_add_attractions(const struct bodies *b,
                                       struct chunk *own,
                                       const struct step_parameters *by)
{
    const int counted = by->budget && by->n_attractions > 0;

    if (counted) add_to_attractions(own, -1.0);
    for (int k = 0; k < by->n_attractions; k++)
        attraction_loop_add(own, b, &by->attractions[k]);
    if (counted) add_to_attractions(own, 1.0);
}

/* Adds the loads of surfaces and attractions on a chunk. */
static void load_others(struct neighbours *nb, int s,
                        const struct step_parameters *by)
{
    struct chunk *const own = &nb->chunks[s];

    if (nb->surfaces != NULL)
        surfaces_add_loads(nb->surfaces, s, own, nb->bodies, by->sweep,
                           by->constants, by->dt);
    chunk_step_add_attractions(nb->bodies, own, by);
}

/* Computes loads, then motion, block by block. Blocks wait if other chunks may
 * still add loads to them or still need their positions. */
static void load_and_move_chunk(struct neighbours *nb, int s,
                                const struct step_parameters *by, int waiting)
{
    struct chunk *const own = &nb->chunks[s];
    const int late = own->begin + n_shared(nb, s, by);

    for (int k = 0, begin = own->begin; k < own->n_blocks; k++) {
        const int end = own->blocks[k].end;
        if (!waiting) load_block(nb, own, k, by);
        if ((begin < late) == waiting) {
            chunk_add_loads(nb->chunks, nb->n_chunks, s, nb->bodies->n, begin,
                            end);
            chunk_step_advance(nb, own, begin, end, by);
        }
        begin = end;
    }
    if (!waiting) load_others(nb, s, by);
}

/* Publishes the largest speeds of the chunk after all threads have read the
 * previous ones.
 */
static void publish_max_speed(struct chunk *own)
{
    memcpy(own->max_speed, own->max_speed_now, sizeof own->max_speed);
    memset(own->max_speed_now, 0, sizeof own->max_speed_now);
}

void chunk_step_load_and_move(struct neighbours *nb,
                              const struct step_parameters *by)
{
    const struct chunk_range mine = neighbours_balanced_range(nb);

    for (int s = mine.first; s < mine.last; s++) {
        if (by->budget) chunk_begin_budget(&nb->chunks[s].energy);
        load_and_move_chunk(nb, s, by, 0);
        if (by->budget) chunk_end_budget(&nb->chunks[s].energy);
    }
    neighbours_barrier(nb);
    for (int s = mine.first; s < mine.last; s++) {
        load_and_move_chunk(nb, s, by, 1);
        chunk_step_count(nb, s, by);
        publish_max_speed(&nb->chunks[s]);
    }
    neighbours_barrier(nb);
}

void chunk_step_move(struct neighbours *nb, const struct step_parameters *by)
{
    const struct chunk_range mine = neighbours_static_range(nb);

    for (int s = mine.first; s < mine.last; s++) {
        struct chunk *const own = &nb->chunks[s];
        chunk_step_advance(nb, own, own->begin, own->end, by);
        chunk_step_count(nb, s, by);
        publish_max_speed(own);
    }
    neighbours_barrier(nb);
}
