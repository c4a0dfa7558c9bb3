/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/profiles.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "output/profile.h"
#include "case/field_names.h"

static const char list[] = "output.profiles";

struct line {
    struct profile *profile;
    char name[PROFILES_NAME]; /* of its file */
};

struct profiles {
    const struct snapshot *snapshot;
    int n;
    struct line *line;
};

/* What the file of a profile is called but for its ending: by field and height,
 * in millimetres. */
static void short_name(const struct settings *s, int i,
                       char name[PROFILES_NAME])
{
    snprintf(name, PROFILES_NAME, "%s_y%gmm",
             settings_item_text(s, list, i, "field"),
             1e3 * settings_item_real(s, list, i, "height"));
}

void profiles_name(const struct settings *s, int i, char name[PROFILES_NAME])
{
    char other[PROFILES_NAME];
    int again = 0;

    short_name(s, i, name);
    for (int j = 0; j < i && !again; j++) {
        short_name(s, j, other);
        again = strcmp(name, other) == 0;
    }
    if (again)
        snprintf(name + strlen(name), PROFILES_NAME - strlen(name), "_from%gs",
                 settings_item_real(s, list, i, "from"));
}

static int create_line(const struct settings *s, const struct simulation *sim,
                       const struct snapshot *snapshot, int i,
                       struct line *line)
{
    const struct profile_line where = {
        .along = 0,
        .up = 1,
        .height = settings_item_real(s, list, i, "height"),
        .from = settings_item_real(s, list, i, "from")};
    const struct profile_field field =
        field_names_find(snapshot, settings_item_text(s, list, i, "field"));

    if (field.values == NULL)
        return settings_wrong(s, list, "the case has no field %s", field.name);
    line->profile = profile_create(sim->mesh, &where, 1, &field);
    profiles_name(s, i, line->name);
    return line->profile == NULL;
}

struct profiles *profiles_create(const struct settings *s,
                                 const struct simulation *sim,
                                 const struct snapshot *snapshot)
{
    struct profiles *const l = alloc_zeroed(1, sizeof *l);

    l->snapshot = snapshot;
    l->n = settings_length(s, "output.profiles");
    l->line = alloc_zeroed((size_t)l->n, sizeof *l->line);
    for (int i = 0; i < l->n; i++)
        if (create_line(s, sim, snapshot, i, &l->line[i]) != 0) {
            profiles_free(l);
            return NULL;
        }
    return l;
}

void profiles_free(struct profiles *l)
{
    if (l == NULL) return;
    for (int i = 0; i < l->n; i++)
        profile_free(l->line[i].profile);
    free(l->line);
    free(l);
}

void profiles_add(struct profiles *l, double dt)
{
    for (int i = 0; i < l->n; i++)
        profile_add(l->line[i].profile, l->snapshot->t, dt);
}

void profiles_summary(const struct profiles *l, struct summary *to)
{
    if (l->n == 0) return;
    summary_begin(to, "profiles");
    for (int i = 0; i < l->n; i++) {
        const struct profile *const p = l->line[i].profile;
        summary_begin(to, l->line[i].name);
        summary_number(to, "mirror_error", profile_mirror_error(p, 0));
        summary_number(to, "block_error", profile_block_error(p, 0));
        summary_end(to);
    }
    summary_end(to);
}

void profiles_state(struct profiles *l, struct state *s)
{
    state_begin(s, "profiles");
    for (int i = 0; i < l->n; i++) {
        state_begin(s, l->line[i].name);
        profile_state(l->line[i].profile, s);
        state_end(s);
    }
    state_end(s);
}

static int write_line(const struct line *l, struct folder *folder)
{
    char name[sizeof l->name + sizeof "profiles/.csv"];

    snprintf(name, sizeof name, "profiles/%s.csv", l->name);
    char *const path = folder_file(folder, name);
    const int failed = path == NULL || profile_write(l->profile, path) != 0;
    free(path);
    return failed;
}

int profiles_write(const struct profiles *l, struct folder *folder)
{
    if (l->n == 0) return 0;
    int failed = folder_make(folder, "profiles");

    for (int i = 0; i < l->n && !failed; i++)
        failed = write_line(&l->line[i], folder);
    return failed;
}
