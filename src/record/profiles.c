/* SPDX-License-Identifier: GPL-3.0-or-later */
/* profiles.c -- what a case asks for of the fields: time averages on lines, the
 * files of DIR/profiles/, and values at points, the columns of DIR/probes.csv.
 */
#include "record/recorder_part.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "output/means/means.h"
#include "output/table.h"

/* The field that a case calls `name`. Mean velocities of the particles are
 * weighted by the solids fraction. */
static struct profile_field field_named(const struct snapshot *s,
                                        const char *name)
{
    const struct profile_field fields[] = {
        {"eps_f", "-", s->eps, 1, 0, NULL},
        {"eps_s", "-", s->eps_s, 1, 0, NULL},
        {"p", "Pa", s->p, 1, 0, NULL},
        {"u_x", "m/s", s->u, 3, 0, NULL},
        {"u_y", "m/s", s->u, 3, 1, NULL},
        {"u_z", "m/s", s->u, 3, 2, NULL},
        {"us_x", "m/s", s->u_s, 3, 0, s->eps_s},
        {"us_y", "m/s", s->u_s, 3, 1, s->eps_s},
        {"us_z", "m/s", s->u_s, 3, 2, s->eps_s}};
    int i = 0;

    while (strcmp(fields[i].name, name) != 0)
        i++;
    return fields[i];
}

/* --- lines ---------------------------------------------------------------- */

struct line {
    struct profile *profile;
    char name[PROFILES_NAME]; /* of its file */
    int upright; /* [-] 1: along gravity, so that no mirror leaves it alone */
    const struct output_profile *of;
    struct profile_field field;
};

struct profiles {
    const struct snapshot *snapshot;
    struct folder *folder;
    double dt; /* [s] between two samples */
    int n;
    struct line *line;
};

struct profile_line profiles_line(const struct output_profile *p)
{
    struct profile_line l = {
        .along = p->along[0] - 'x', .across = -1, .from = p->from};

    for (int k = 0; k < 3; k++)
        if (k != l.along && p->has_place[k]) {
            l.across = k;
            l.at = p->place[k];
        }
    return l;
}

/* By field, direction if it is not x, and place, in millimetres. */
static void short_name(const struct output_profile *p, char name[PROFILES_NAME])
{
    static const char *const along[3] = {"", "_along_y", "_along_z"};
    const struct profile_line l = profiles_line(p);

    snprintf(name, PROFILES_NAME, "%s%s_%c%gmm", p->field, along[l.along],
             "xyz"[l.across], 1e3 * l.at);
}

void profiles_name(const struct output_options *o, int i,
                   char name[PROFILES_NAME])
{
    const struct output_profile *const p = o->profiles.item;
    char other[PROFILES_NAME];
    int k = 0;

    short_name(&p[i], name);
    for (; k < i; k++) {
        short_name(&p[k], other);
        if (strcmp(name, other) == 0) break;
    }
    const size_t n = strlen(name);
    if (k < i) snprintf(name + n, PROFILES_NAME - n, "_from%gs", p[i].from);
}

static void profiles_release(void *part)
{
    struct profiles *const l = part;

    for (int i = 0; i < l->n; i++)
        profile_free(l->line[i].profile);
    owner_free(l);
}

static void *profiles_create(const struct recorder_view *v, int *failed)
{
    const struct output_options *const o = v->of->output;

    (void)failed;
    if (o->profiles.n == 0) return NULL;
    struct profiles *const l = owner_create(sizeof *l);
    l->snapshot = v->whole;
    l->folder = v->folder;
    l->dt = (double)v->of->row_every * v->sim->dt;
    l->n = o->profiles.n;
    l->line = owner_zeroed(l, (size_t)l->n, sizeof *l->line);
    for (int i = 0; i < l->n; i++) {
        const struct profile_line where = profiles_line(&o->profiles.item[i]);
        const struct profile_field field =
            field_named(v->whole, o->profiles.item[i].field);
        l->line[i].of = &o->profiles.item[i];
        l->line[i].field = field;
        l->line[i].upright = v->sim->gravity[where.along] != 0.0;
        l->line[i].profile = profile_create(v->drawn->mesh, &where, &field);
        profiles_name(o, i, l->line[i].name);
    }
    return l;
}

/* Takes a sample of the snapshot. */
static int profiles_add(void *part)
{
    struct profiles *const l = part;

    for (int i = 0; i < l->n; i++)
        profile_add(l->line[i].profile, l->snapshot->t, l->dt);
    return 0;
}

/* How far each can be trusted: its mirror error and its error by blocks
 * (output/means/means.h). */
static void profiles_summarize(const void *part, struct summary *to)
{
    const struct profiles *const l = part;

    summary_begin(to, "profiles");
    for (int i = 0; i < l->n; i++) {
        const struct profile *const p = l->line[i].profile;
        summary_begin(to, l->line[i].name);
        if (!l->line[i].upright)
            summary_number(to, "mirror_error", profile_mirror_error(p));
        summary_number(to, "block_error", profile_block_error(p));
        summary_end(to);
    }
    summary_end(to);
}

static void profiles_visit(void *part, struct state *s)
{
    struct profiles *const l = part;

    state_begin(s, "profiles");
    for (int i = 0; i < l->n; i++) {
        state_begin(s, l->line[i].name);
        profile_state(l->line[i].profile, s);
        state_end(s);
    }
    state_end(s);
}

static int write_measured(const struct line *l, const char *path)
{
    const struct key_series *const points = &l->of->measured;
    double(*const row)[2] = alloc_zeroed((size_t)points->n, sizeof *row);
    struct table_head head = {0};

    table_head_add(&head, "%s [m]", l->of->along);
    table_head_add(&head, "%s_mean [%s]", l->field.name, l->field.unit);
    for (int i = 0; i < points->n; i++) {
        row[i][0] = points->at[i];
        row[i][1] = points->value[i];
    }
    const int failed = table_write(path, head.n, (const char *const *)head.name,
                                   points->n, row[0]);
    table_head_clear(&head);
    free(row);
    return failed;
}

static int write_line(const struct line *l, struct folder *folder)
{
    char name[sizeof l->name + sizeof "profiles/_measured.csv"];
    int failed = 0;

    for (int k = 0; k < 1 + (l->of->measured.n > 0) && !failed; k++) {
        snprintf(name, sizeof name, "profiles/%s%s.csv", l->name,
                 k == 0 ? "" : "_measured");
        char *const path = folder_file(folder, name);
        failed = path == NULL || (k == 0 ? profile_write(l->profile, path)
                                         : write_measured(l, path)) != 0;
        free(path);
    }
    return failed;
}

static int profiles_finish(void *part)
{
    const struct profiles *const l = part;
    int failed = folder_make(l->folder, "profiles");

    for (int i = 0; i < l->n && !failed; i++)
        failed = write_line(&l->line[i], l->folder);
    return failed;
}

const struct recorder_part recorder_profiles = {.create = profiles_create,
                                                .free = profiles_release,
                                                .row = profiles_add,
                                                .finish = profiles_finish,
                                                .summarize = profiles_summarize,
                                                .state = profiles_visit};

/* --- points --------------------------------------------------------------- */

struct sensor {
    struct profile_field field;
    struct probe at;
};

struct probes {
    const struct snapshot *snapshot;
    int n;
    struct sensor *sensor;
    struct table *table;
    double *row;
};

static void probes_release(void *part)
{
    struct probes *const p = part;

    table_free(p->table);
    owner_free(p);
}

static void *probes_create(const struct recorder_view *v, int *failed)
{
    const struct output_probe *const o = v->of->output->probes.item;
    const int n = v->of->output->probes.n;
    struct table_head head = {0};

    if (n == 0) return NULL;
    struct probes *const p = owner_create(sizeof *p);
    p->snapshot = v->whole;
    p->n = n;
    p->sensor = owner_zeroed(p, (size_t)n, sizeof *p->sensor);
    p->row = owner_doubles(p, n + 1);
    table_head_add(&head, "time [s]");
    for (int i = 0; i < n; i++) {
        const double *const x = o[i].position;
        const struct profile_field f = field_named(v->whole, o[i].field);
        p->sensor[i] = (struct sensor){f, probe_at(v->drawn->mesh, x)};
        table_head_add(&head, "%s(%g %g %g) [%s]", f.name, x[0], x[1], x[2],
                       f.unit);
    }
    p->table = folder_table(v->folder, "probes.csv", &head);
    *failed = p->table == NULL;
    return p;
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

const struct recorder_part recorder_probes = {.create = probes_create,
                                              .free = probes_release,
                                              .row = probes_add_row,
                                              .last_row = probes_add_row,
                                              .state = probes_visit};
