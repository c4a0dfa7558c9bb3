/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/probes.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "output/probe.h"
#include "output/table.h"
#include "case/field_names.h"

enum { NAME = 96 };
static const char *const list = "output.probes";

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

static int create_sensor(const struct settings *s, const struct simulation *sim,
                         const struct snapshot *snapshot, int i,
                         struct sensor *sensor)
{
    double x[3];

    settings_item_vector(s, list, i, "position", x);
    sensor->field =
        field_names_find(snapshot, settings_item_text(s, list, i, "field"));
    if (sensor->field.values == NULL)
        return settings_wrong(s, list, "the case has no field %s",
                              sensor->field.name);
    sensor->at = probe_at(sim->mesh, x);
    snprintf(sensor->name, NAME, "%s(%g %g %g) [%s]", sensor->field.name, x[0],
             x[1], x[2], sensor->field.unit);
    return 0;
}

static struct table *create_table(const struct probes *p, struct folder *folder)
{
    const char **const names = alloc_zeroed((size_t)p->n + 1, sizeof *names);

    names[0] = "time [s]";
    for (int i = 0; i < p->n; i++)
        names[1 + i] = p->sensor[i].name;
    struct table *const t = folder_table(folder, "probes.csv", p->n + 1, names);
    free(names);
    return t;
}

struct probes *probes_create(const struct settings *s,
                             const struct simulation *sim,
                             const struct snapshot *snapshot,
                             struct folder *folder)
{
    struct probes *const p = alloc_zeroed(1, sizeof *p);
    int wrong = 0;

    p->snapshot = snapshot;
    p->n = settings_length(s, list);
    p->sensor = alloc_zeroed((size_t)p->n, sizeof *p->sensor);
    p->row = alloc_doubles(p->n + 1);
    for (int i = 0; i < p->n && !wrong; i++)
        wrong = create_sensor(s, sim, snapshot, i, &p->sensor[i]);
    if (!wrong && p->n > 0)
        wrong = (p->table = create_table(p, folder)) == NULL;
    if (!wrong) return p;
    probes_free(p);
    return NULL;
}

void probes_free(struct probes *p)
{
    if (p == NULL) return;
    table_free(p->table);
    free(p->sensor);
    free(p->row);
    free(p);
}

void probes_state(struct probes *p, struct state *s)
{
    if (p->table == NULL) return;
    state_begin(s, "probes");
    table_state(p->table, s);
    state_end(s);
}

int probes_add(struct probes *p)
{
    if (p->n == 0) return 0;
    p->row[0] = p->snapshot->t;
    for (int i = 0; i < p->n; i++) {
        const struct profile_field *const f = &p->sensor[i].field;
        p->row[1 + i] = probe_value(&p->sensor[i].at, f->values, f->components,
                                    f->component, f->weight);
    }
    return table_add(p->table, p->row);
}
