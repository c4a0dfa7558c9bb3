/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/snapshot.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "coupling/processes.h"
#include "coupling/transfer.h"

static void create_particles(struct snapshot *s, int capacity)
{
    for (int k = 0; k < 3; k++) {
        s->x[k] = alloc_doubles(capacity);
        s->v[k] = alloc_doubles(capacity);
        s->w[k] = alloc_doubles(capacity);
    }
    s->d = alloc_doubles(capacity);
    s->speed = alloc_doubles(capacity);
    s->id = alloc_ints(capacity);
    s->capacity = capacity;
}

struct snapshot *snapshot_create(const struct simulation *sim)
{
    struct snapshot *const s = alloc_zeroed(1, sizeof *s);
    const int n = sim->mesh->n_cells;

    if (sim->particles != NULL) create_particles(s, sim->particles->capacity);
    if (sim->particles != NULL && sim->particles->material != NULL)
        s->material = alloc_ints(sim->particles->capacity);
    if (sim->fluid == NULL) return s;
    s->eps = alloc_doubles(n);
    s->u = alloc_doubles(3 * n);
    s->p = alloc_doubles(n);
    if (sim->fluid->options.coupled) {
        s->eps_s = alloc_doubles(n);
        s->u_s = alloc_doubles(3 * n);
    }
    return s;
}

void snapshot_free(struct snapshot *s)
{
    if (s == NULL) return;
    for (int k = 0; k < 3; k++) {
        free(s->x[k]);
        free(s->v[k]);
        free(s->w[k]);
    }
    free(s->d);
    free(s->speed);
    free(s->id);
    free(s->material);
    free(s->order);
    for (int i = 0; i < s->n_more; i++)
        free(s->value[i]);
    free(s->eps);
    free(s->eps_s);
    free(s->u);
    free(s->p);
    free(s->u_s);
    free(s);
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
    s->value[s->n_more++] = alloc_doubles(field->components * s->capacity);
}

static void particles_of_state(struct snapshot *s, struct state *state)
{
    static const char *const name[9] = {"x",  "y",  "z",  "vx", "vy",
                                        "vz", "wx", "wy", "wz"};
    static const char *const unit[3] = {"m", "m/s", "rad/s"};
    double *const *const group[3] = {s->x, s->v, s->w};

    state_count(state, "count", &s->n, s->capacity);
    for (int a = 0; a < 9; a++)
        state_reals(state, name[a], unit[a / 3], group[a / 3][a % 3], s->n, 1);
    state_reals(state, "d", "m", s->d, s->n, 1);
    state_reals(state, "speed", "m/s", s->speed, s->n, 1);
    state_wholes(state, "id", "-", s->id, s->n, 1);
    state_wholes(state, "material", "-", s->material, s->n, 1);
    for (int i = 0; i < s->n_more; i++)
        state_reals(state, s->more[i]->name, s->more[i]->unit, s->value[i],
                    s->n, s->more[i]->components);
}

void snapshot_state(struct snapshot *s, const struct mesh *mesh,
                    struct state *state)
{
    const int n = mesh->n_cells;

    state_begin(state, "snapshot");
    state_real(state, "t", "s", &s->t);
    state_reals(state, "eps", "-", s->eps, n, 1);
    state_reals(state, "eps_s", "-", s->eps_s, n, 1);
    state_reals(state, "u", "m/s", s->u, n, 3);
    state_reals(state, "p", "Pa", s->p, n, 1);
    state_reals(state, "u_s", "m/s", s->u_s, n, 3);
    particles_of_state(s, state);
    state_end(state);
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
    if (s->arrange != NULL) s->arrange(s);
}
