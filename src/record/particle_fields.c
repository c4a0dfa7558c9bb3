/* SPDX-License-Identifier: GPL-3.0-or-later */
/* particle_fields.c -- what a case may have written of each particle besides
 * place, velocity, spin and size. */
#include "record/recorder_part.h"

#include <stdio.h>
#include <string.h>

#include "record/contact_list.h"

static void take_mass(void *memory, const struct simulation *sim, double *to)
{
    (void)memory;
    memcpy(to, sim->particles->m, (size_t)sim->particles->n * sizeof *to);
}

static void take_material(void *memory, const struct simulation *sim,
                          double *to)
{
    const struct particles *const ps = sim->particles;

    (void)memory;
    for (int i = 0; i < ps->n; i++)
        to[i] = ps->material != NULL ? ps->material[i] : 0;
}

/* The external force of the last sub-step less the weight, with the present
 * velocity in the implicit part of the drag. */
static void take_fluid_force(void *memory, const struct simulation *sim,
                             double *to)
{
    const struct particles *const ps = sim->particles;
    const double *const e[3] = {ps->ex, ps->ey, ps->ez};
    const double *const v[3] = {ps->vx, ps->vy, ps->vz};

    (void)memory;
    for (int i = 0; i < ps->n; i++) {
        const double k_d =
            ps->drag_coefficient != NULL ? ps->drag_coefficient[i] : 0.0;
        for (int k = 0; k < 3; k++)
            to[3 * i + k] =
                sim->steps == 0
                    ? 0.0
                    : e[k][i] - ps->m[i] * sim->gravity[k] - k_d * v[k][i];
    }
}

static void take_contact_force(void *memory, const struct simulation *sim,
                               double *to)
{
    const struct particles *const ps = sim->particles;

    (void)memory;
    for (int i = 0; i < ps->n; i++) {
        to[3 * i] = ps->cfx[i];
        to[3 * i + 1] = ps->cfy[i];
        to[3 * i + 2] = ps->cfz[i];
    }
}

static void take_contact_number(void *memory, const struct simulation *sim,
                                double *to)
{
    struct contact_list *const c = memory;

    contact_list_find(c);
    memset(to, 0, (size_t)sim->particles->n * sizeof *to);
    for (int i = 0; i < 2 * c->n; i++)
        if (c->index[i] >= 0) to[c->index[i]] += 1.0;
}

const struct snapshot_field snapshot_fields[] = {
    {"mass", "kg", 1, take_mass},
    {"material", "-", 1, take_material},
    {"fluid_force", "N", 3, take_fluid_force},
    {"contact_force", "N", 3, take_contact_force},
    {"contact_number", "-", 1, take_contact_number},
    {NULL, NULL, 0, NULL}};

/* Adds what the case names to the snapshot; the list of contacts is all that is
 * left to be freed. */
static void *particle_fields_create(const struct recorder_view *v, int *failed)
{
    const struct output_options *const o = v->of->output;
    const char *text = o->particles != NULL ? o->particles : "";
    struct contact_list *contacts = NULL;
    char word[SNAPSHOT_WORD];
    int used;

    (void)failed;
    if (v->sim->dem == NULL) return NULL;
    if (o->sorted) snapshot_order_by_id(v->snapshot);
    for (; sscanf(text, " %63[^ ]%n", word, &used) == 1; text += used) {
        const struct snapshot_field *f = snapshot_fields;
        while (strcmp(f->name, word) != 0)
            f++;
        if (f->take == take_material && v->sim->particles->material != NULL)
            continue; /* is written anyway */
        if (f->take == take_contact_number)
            contacts = contact_list_create(v->sim);
        snapshot_add(v->snapshot, f, contacts);
    }
    return contacts;
}

static void particle_fields_release(void *contacts)
{
    contact_list_free(contacts);
}

const struct recorder_part recorder_particle_fields = {
    .create = particle_fields_create,
    .free = particle_fields_release,
};
