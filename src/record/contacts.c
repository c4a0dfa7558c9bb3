/* SPDX-License-Identifier: GPL-3.0-or-later */
/* contacts.c -- the contacts as lines between centres, for ParaView:
 * DIR/contacts.pvd. */
#include "record/recorder_part.h"

#include <stdlib.h>

#include "base/alloc.h"
#include "record/contact_list.h"
#include "record/field_output.h"
#include "output/series.h"
#include "output/polygons/vtk_polygons.h"

struct contacts {
    struct folder *folder; /* borrowed */
    struct series *series;
    struct vtk_file *writer;
    struct contact_list *found;
};

static int contacts_add_fields(void *part, double t)
{
    struct contacts *const own = part;
    const struct contact_list *const c = own->found;

    contact_list_find(own->found);
    const struct vtk_polygons lines = {2 * c->n, c->n, c->x, c->corner, c->end};
    const struct vtk_array arrays[] = {
        {.name = "force", .components = 1, .values = c->force, .single = 1},
        {.name = "overlap", .components = 1, .values = c->depth, .single = 1},
        {.name = "ids", .components = 2, .ints = c->ids}};
    const char *const path = series_next(own->series);
    return folder_list(own->folder, path) != 0 ||
           vtk_write_lines(own->writer, path, &lines, t, 3, arrays) != 0 ||
           series_add(own->series, t) != 0;
}

static void contacts_release(void *part)
{
    struct contacts *const c = part;

    series_free(c->series);
    vtk_file_free(c->writer);
    contact_list_free(c->found);
    free(c);
}

static void *contacts_create(const struct recorder_view *v, int *failed)
{
    if (v->sim->dem == NULL || !v->settings->output.contacts) return NULL;
    struct contacts *const c = alloc_zeroed(1, sizeof *c);

    c->folder = v->folder;
    c->writer = vtk_file_create();
    c->found = contact_list_create(v->sim);
    c->series = field_output_series(v->folder, "contacts", "vtp");
    if (c->series != NULL) return c;
    *failed = 1;
    contacts_release(c);
    return NULL;
}

static void contacts_visit(void *part, struct state *s)
{
    series_state(((struct contacts *)part)->series, s);
}

static const struct key keys[] = {
    {"output.contacts", KEY_BOOL, "", "", "false",
     "contacts.pvd: a line for each contact of particles with each other, "
     "the box and surfaces, with its elastic force, at the times of the "
     "pictures",
     "", "particles", .at = KEY_AT(output_options, contacts)},
    KEY_END};

const struct recorder_part contacts_part = {
    .keys = keys,
    .create = contacts_create,
    .free = contacts_release,
    .fields = contacts_add_fields,
    .state = contacts_visit,
};
