/* SPDX-License-Identifier: GPL-3.0-or-later */
/* particle_fields.c -- what a case may have written of each particle besides
 * place, velocity, spin and size. */
#include "record/snapshot_order.h"
#include "record/recorder_part.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "record/contact_list.h"
#include "case/nearest.h"

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

static const struct snapshot_field fields[] = {
    {"mass", "kg", 1, take_mass},
    {"material", "-", 1, take_material},
    {"fluid_force", "N", 3, take_fluid_force},
    {"contact_force", "N", 3, take_contact_force},
    {"contact_number", "-", 1, take_contact_number}};
enum { FIELDS = sizeof fields / sizeof *fields, WORD = 64 };

static const char key[] = "output.particles";

static int particle_fields_number_of(const char *word)
{
    for (int i = 0; i < FIELDS; i++)
        if (strcmp(fields[i].name, word) == 0) return i;
    return -1;
}

static int particle_fields_unknown(const struct settings *s, const char *word)
{
    struct nearest n;

    nearest_init(&n, word);
    for (int i = 0; i < FIELDS; i++)
        nearest_offer(&n, fields[i].name);
    const char *const best = nearest_best(&n);
    return settings_wrong(s, key,
                          "there is no %s; expected mass, material, "
                          "fluid_force, contact_force or contact_number%s%s",
                          word, best != NULL ? "; nearest: " : "",
                          best != NULL ? best : "");
}

static int particle_fields_check(const struct settings *s)
{
    char word[WORD];
    int used, found[FIELDS] = {0};

    for (const char *text = s->output.particles;
         text != NULL && sscanf(text, " %63[^ ]%n", word, &used) == 1;
         text += used) {
        const int i = particle_fields_number_of(word);
        if (i < 0) return particle_fields_unknown(s, word);
        if (found[i]++)
            return settings_wrong(s, key, "%s is named twice", word);
        if (fields[i].take == take_fluid_force && !s->has.exchange)
            return settings_wrong(s, key,
                                  "fluid_force needs the group exchange: no "
                                  "fluid acts on the particles");
    }
    return 0;
}

/* --- as a part of the recorder -------------------------------------------- */

struct chosen {
    int field[FIELDS];             /* [-] numbers of them */
    int n, sorted;                 /* [-] */
    struct contact_list *contacts; /* NULL unless they are counted */
};

static void *particle_fields_create(const struct recorder_view *v, int *failed)
{
    const struct output_options *const o = &v->settings->output;
    const char *text = o->particles != NULL ? o->particles : "";
    struct chosen c = {.sorted = o->sorted};
    char word[WORD];
    int used;
    (void)failed;
    for (; sscanf(text, " %63[^ ]%n", word, &used) == 1; text += used) {
        const int i = particle_fields_number_of(word);
        const int known =
            fields[i].take == take_material && v->sim->particles != NULL &&
            v->sim->particles->material != NULL; /* is written anyway */
        if (!known) c.field[c.n++] = i;
    }
    if (v->sim->dem == NULL || (c.n == 0 && !c.sorted)) return NULL;
    for (int i = 0; i < c.n; i++)
        if (fields[c.field[i]].take == take_contact_number)
            c.contacts = contact_list_create(v->sim);
    struct chosen *const made = alloc_zeroed(1, sizeof *made);
    *made = c;
    for (int i = 0; i < c.n; i++)
        snapshot_add(v->snapshot, &fields[c.field[i]], c.contacts);
    if (c.sorted) snapshot_order_by_id(v->snapshot);
    return made;
}

static void particle_fields_release(void *part)
{
    struct chosen *const c = part;

    if (c == NULL) return;
    contact_list_free(c->contacts);
    free(c);
}

static const struct key keys[] = {
    {"output.particles", KEY_TEXT, "", "", KEY_OPTIONAL,
     "further arrays of particles.pvd, separated by blanks: mass material "
     "fluid_force contact_force contact_number",
     "", "particles", .at = KEY_AT(output_options, particles)},
    {"output.sorted", KEY_BOOL, "", "", "false",
     "particles.pvd has the particles in the order of their ids", "",
     "particles", .at = KEY_AT(output_options, sorted)},
    KEY_END};

const struct recorder_part particle_fields_part = {
    .keys = keys,
    .check = particle_fields_check,
    .create = particle_fields_create,
    .free = particle_fields_release,
};
