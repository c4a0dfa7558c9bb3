/* SPDX-License-Identifier: GPL-3.0-or-later */
/* probes.c -- the sensors that a case puts into the box: a column of probes.csv
 * for each, a row with each of history.csv. */
#include "record/recorder_part.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "output/means/probe.h"
#include "output/table.h"
#include "case/case_mesh.h"
#include "record/field_names.h"

enum { NAME = 96 };
static const char list[] = "output.probes";

struct sensor {
    struct profile_field field;
    struct probe at;
    char name[NAME];
};

struct probes {
    const struct snapshot *snapshot;
    int n;
    struct sensor *sensor;
    struct table *table;
    double *row;
};

static int probes_check(const struct settings *s)
{
    const struct output_probe *const p = s->output.probes.item;
    const int n = s->output.probes.n;
    int code = 0;

    for (int i = 0; i < n && code == 0; i++)
        code = field_names_check(s, list, p[i].field);
    for (int i = 0; i < n && code == 0; i++) {
        const double *const x = p[i].position;
        if (!case_mesh_holds(s, x))
            code = settings_wrong(
                s, list, "the point [%g, %g, %g] m is outside the %s", x[0],
                x[1], x[2], settings_mesh(s) == NULL ? "box" : "mesh");
    }
    return code;
}

static int create_sensor(const struct recorder_view *v, int i,
                         struct sensor *sensor)
{
    const struct settings *const s = v->settings;
    const struct output_probe *const p = &s->output.probes.item[i];
    const double *const x = p->position;

    sensor->field = field_names_find(v->whole, p->field);
    if (sensor->field.values == NULL)
        return settings_wrong(s, list, "the case has no field %s",
                              sensor->field.name);
    sensor->at = probe_at(v->drawn->mesh, x);
    snprintf(sensor->name, NAME, "%s(%g %g %g) [%s]", sensor->field.name, x[0],
             x[1], x[2], sensor->field.unit);
    return 0;
}

static struct table *probes_create_table(const struct probes *p,
                                         struct folder *folder)
{
    const char **const names = alloc_zeroed((size_t)p->n + 1, sizeof *names);

    names[0] = "time [s]";
    for (int i = 0; i < p->n; i++)
        names[1 + i] = p->sensor[i].name;
    struct table *const t = folder_table(folder, "probes.csv", p->n + 1, names);
    free(names);
    return t;
}

static void probes_release(void *part)
{
    struct probes *const p = part;

    table_free(p->table);
    free(p->sensor);
    free(p->row);
    free(p);
}

static void *probes_create(const struct recorder_view *v, int *failed)
{
    const int n = v->settings->output.probes.n;

    if (n == 0) return NULL;
    struct probes *const p = alloc_zeroed(1, sizeof *p);
    p->snapshot = v->whole;
    p->n = n;
    p->sensor = alloc_zeroed((size_t)n, sizeof *p->sensor);
    p->row = alloc_doubles(n + 1);
    for (int i = 0; i < n && !*failed; i++)
        *failed = create_sensor(v, i, &p->sensor[i]) != 0;
    if (!*failed)
        *failed = (p->table = probes_create_table(p, v->folder)) == NULL;
    if (!*failed) return p;
    probes_release(p);
    return NULL;
}

static void probes_visit(void *part, struct state *s)
{
    struct probes *const p = part;

    state_begin(s, "probes");
    table_state(p->table, s);
    state_end(s);
}

static int probes_add_row(void *part)
{
    struct probes *const p = part;

    p->row[0] = p->snapshot->t;
    for (int i = 0; i < p->n; i++) {
        const struct profile_field *const f = &p->sensor[i].field;
        p->row[1 + i] = probe_value(&p->sensor[i].at, f->values, f->components,
                                    f->component, f->weight);
    }
    return table_add(p->table, p->row);
}

static const struct key keys[] = {
    {"output.probes", KEY_LIST, "", "", "",
     "fields at points, each { field, position }, a row of probes.csv with "
     "each of history.csv",
     "XS11 Fig. 3", "", .at = KEY_AT(output_options, probes),
     .size = sizeof(struct output_probe)},
    {"output.probes.field", KEY_NAME, "", FIELD_NAMES, NULL, "as for profiles",
     "", "", .at = KEY_AT(output_probe, field)},
    {"output.probes.position", KEY_VECTOR, "m", "", NULL,
     "the point, inside the box", "", "", .at = KEY_AT(output_probe, position)},
    KEY_END};

const struct recorder_part probes_part = {.keys = keys,
                                          .check = probes_check,
                                          .create = probes_create,
                                          .free = probes_release,
                                          .row = probes_add_row,
                                          .last_row = probes_add_row,
                                          .state = probes_visit};
