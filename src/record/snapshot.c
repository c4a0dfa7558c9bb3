/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "record/snapshot.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "coupling/processes.h"
#include "coupling/transfer.h"

/* The arrays of real numbers: those of the fluid and of the solids, a row for
 * each cell, and those with a row for each particle. */
enum { OF_FLUID = 3, OF_CELLS = OF_FLUID + 2, ARRAYS = OF_CELLS + 11 };
struct array {
    double **at;
    const char *name, *unit;
    int width; /* [-] numbers a cell or particle */
};

static void snapshot_list_arrays(struct snapshot *s, struct array list[ARRAYS])
{
    const struct array all[ARRAYS] = {
        {&s->eps, "eps", "-", 1},     {&s->u, "u", "m/s", 3},
        {&s->p, "p", "Pa", 1},        {&s->eps_s, "eps_s", "-", 1},
        {&s->u_s, "u_s", "m/s", 3},   {&s->x[0], "x", "m", 1},
        {&s->x[1], "y", "m", 1},      {&s->x[2], "z", "m", 1},
        {&s->v[0], "vx", "m/s", 1},   {&s->v[1], "vy", "m/s", 1},
        {&s->v[2], "vz", "m/s", 1},   {&s->w[0], "wx", "rad/s", 1},
        {&s->w[1], "wy", "rad/s", 1}, {&s->w[2], "wz", "rad/s", 1},
        {&s->d, "d", "m", 1},         {&s->speed, "speed", "m/s", 1}};

    memcpy(list, all, sizeof all);
}

static void snapshot_allocate(struct snapshot *s, int first, int last, int n)
{
    struct array list[ARRAYS];

    snapshot_list_arrays(s, list);
    for (int a = first; a < last; a++)
        *list[a].at = owner_doubles(s, list[a].width * n);
}

struct snapshot *snapshot_create(const struct simulation *sim)
{
    struct snapshot *const s = owner_create(sizeof *s);
    const struct particles *const ps = sim->particles;

    if (ps != NULL) {
        s->capacity = ps->capacity;
        s->id = owner_ints(s, s->capacity);
        snapshot_allocate(s, OF_CELLS, ARRAYS, s->capacity);
        if (ps->material != NULL) s->material = owner_ints(s, s->capacity);
    }
    if (sim->fluid != NULL)
        snapshot_allocate(s, 0,
                          sim->fluid->options.coupled ? OF_CELLS : OF_FLUID,
                          sim->mesh->n_cells);
    return s;
}

static void take_fluid(struct snapshot *s, const struct fluid *fl)
{
    const int n = fl->mesh->n_cells;

    memcpy(s->eps, fl->eps, (size_t)n * sizeof *s->eps);
    memcpy(s->u, fl->u, 3 * (size_t)n * sizeof *s->u);
    memcpy(s->p, fl->p, (size_t)n * sizeof *s->p);
    for (int c = 0; c < n && s->eps_s != NULL; c++) {
        s->eps_s[c] = 1.0 - fl->eps[c];
        for (int k = 0; k < 3; k++)
            s->u_s[3 * c + k] =
                s->eps_s[c] > 0.0 ? fl->eps_us[3 * c + k] / s->eps_s[c] : 0.0;
    }
}

static void take_particles(struct snapshot *s, const struct particles *ps)
{
    const double *const from[9] = {ps->x,  ps->y,  ps->z,  ps->vx, ps->vy,
                                   ps->vz, ps->wx, ps->wy, ps->wz};
    double *const to[9] = {s->x[0], s->x[1], s->x[2], s->v[0], s->v[1],
                           s->v[2], s->w[0], s->w[1], s->w[2]};
    const size_t size = (size_t)ps->n * sizeof(double);

    s->n = ps->n;
    for (int a = 0; a < 9; a++)
        memcpy(to[a], from[a], size);
    memcpy(s->d, ps->d, size);
    memcpy(s->id, ps->id, (size_t)ps->n * sizeof *s->id);
    if (s->material != NULL)
        memcpy(s->material, ps->material, (size_t)ps->n * sizeof *s->material);
    for (int i = 0; i < ps->n; i++)
        s->speed[i] = sqrt(ps->vx[i] * ps->vx[i] + ps->vy[i] * ps->vy[i] +
                           ps->vz[i] * ps->vz[i]);
}

void snapshot_add(struct snapshot *s, const struct snapshot_field *field,
                  void *memory)
{
    assert(s->n_more < SNAPSHOT_FIELDS);
    s->more[s->n_more] = field;
    s->memory[s->n_more] = memory;
    s->value[s->n_more++] = owner_doubles(s, field->components * s->capacity);
}

void snapshot_state(struct snapshot *s, const struct mesh *mesh,
                    struct state *state)
{
    struct array list[ARRAYS];

    snapshot_list_arrays(s, list);
    state_begin(state, "snapshot");
    state_real(state, "t", "s", &s->t);
    state_count(state, "count", &s->n, s->capacity);
    for (int a = 0; a < ARRAYS; a++)
        state_reals(state, list[a].name, list[a].unit, *list[a].at,
                    a < OF_CELLS ? mesh->n_cells : s->n, list[a].width);
    state_wholes(state, "id", "-", s->id, s->n, 1);
    state_wholes(state, "material", "-", s->material, s->n, 1);
    for (int i = 0; i < s->n_more; i++)
        state_reals(state, s->more[i]->name, s->more[i]->unit, s->value[i],
                    s->n, s->more[i]->components);
    state_end(state);
}

/* --- in the order of the ids ---------------------------------------------- */

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
static void snapshot_sort(struct snapshot *s)
{
    struct array list[ARRAYS];
    double *const room = alloc_doubles(3 * s->n);

    for (int i = 0; i < s->n; i++) {
        s->order[2 * i] = s->id[i];
        s->order[2 * i + 1] = i;
    }
    qsort(s->order, (size_t)s->n, 2 * sizeof *s->order, compare_ids);
    snapshot_list_arrays(s, list);
    for (int a = OF_CELLS; a < ARRAYS; a++)
        put_in_order(s, 1, *list[a].at, room);
    for (int a = 0; a < s->n_more; a++)
        put_in_order(s, s->more[a]->components, s->value[a], room);
    free(room);
    if (s->material != NULL) put_materials_in_order(s);
    for (int i = 0; i < s->n; i++)
        s->id[i] = s->order[2 * i];
}

void snapshot_order_by_id(struct snapshot *s)
{
    s->order = owner_ints(s, 2 * s->capacity);
}

void snapshot_take(struct snapshot *s, const struct simulation *sim)
{
    processes_join(sim, PROCESSES_SNAPSHOT);
    s->t = sim->t;
    if (s->u_s != NULL) transfer_solids_velocity(sim);
    if (sim->fluid != NULL) take_fluid(s, sim->fluid);
    if (sim->particles == NULL) return;
    take_particles(s, sim->particles);
    for (int i = 0; i < s->n_more; i++)
        s->more[i]->take(s->memory[i], sim, s->value[i]);
    if (s->order != NULL) snapshot_sort(s);
}
