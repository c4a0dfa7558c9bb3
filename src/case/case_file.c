/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/checks/checks.h"
#include "case/case_file.h"

#include "case/case_mesh.h"
#include "case/schema.h"
#include "coupling/processes.h"
#include "case/resolved/case_bodies.h"
#include "case/particles/case_surfaces.h"
#include "case/models.h"

#include <assert.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* A row: path, type, unit, allowed, default, meaning, source, needs. NULL as
 * the default means that the key must be given. */
const struct key case_file_keys[] = {
    {"title", KEY_TEXT, "", "", "", "what the case shows, in one line", "", "",
     KEY_AT(settings, title), .mark = KEY_MAY_CHANGE | KEY_AFTER_BED,
     .divided = KEY_DIVIDED},
    {"cites", KEY_TEXT, "", "", "", "the paper, table or figure it follows", "",
     "", KEY_AT(settings, cites), .mark = KEY_MAY_CHANGE | KEY_AFTER_BED,
     .divided = KEY_DIVIDED},
    KEY_END};

void case_file_tables(const struct key *tables[CASE_FILE_TABLES])
{
    int n = 0;

    tables[n++] = case_file_keys;
    tables[n++] = mesh_keys;
    tables[n++] = fluid_keys;
    tables[n++] = particles_keys;
    tables[n++] = averaging_keys;
    tables[n++] = coupling_keys;
    tables[n++] = effects_keys;
    tables[n++] = output_keys;
    tables[n++] = processes_check_keys;
    tables[n++] = bodies_setup_keys;
    n += models_tables(&tables[n], CASE_FILE_TABLES - 1 - n);
    assert(n < CASE_FILE_TABLES);
    tables[n] = NULL;
}

int case_file_is_seed(const char *path)
{
    const size_t n = strlen(path), m = strlen(CASE_FILE_SEED);

    return n > m && strcmp(path + n - m, CASE_FILE_SEED) == 0;
}

/* Of one group, or of those of a list. */
static void add_seed(const struct settings *s, const char *path, int more,
                     struct texts *set)
{
    char *const group = strndup(path, strlen(path) - strlen(CASE_FILE_SEED));
    const int there = settings_has(s, group);

    if (there && settings_is_list(s, group))
        for (int i = 0; i < settings_length(s, group); i++)
            texts_add(set, "%s.%d" CASE_FILE_SEED "=%d", group, i,
                      settings_item_int(s, group, i, &CASE_FILE_SEED[1]) +
                          more);
    else if (there)
        texts_add(set, "%s=%d", path, settings_int(s, path) + more);
    free(group);
}

void case_file_add_seeds(const struct settings *s, int more, struct texts *set)
{
    const struct key *tables[CASE_FILE_TABLES];

    case_file_tables(tables);
    SCHEMA_EACH (key, tables)
        if (case_file_is_seed(key->path)) add_seed(s, key->path, more, set);
}

struct settings *case_file_read(const char *file, int n_overrides,
                                const char *const *overrides, int *code)
{
    const struct key *tables[CASE_FILE_TABLES];
    struct settings *s;

    case_file_tables(tables);
    s = settings_create(file, n_overrides, overrides, tables, code);
    if (s == NULL) return NULL;
    *code = case_mesh_check_keys(s);
    if (*code == 0) *code = case_memory_check(s, 0.0);
    if (*code == 0) *code = case_mesh_read(s);
    if (*code == 0) *code = case_mesh_check_cells(s);
    if (*code == 0) case_bodies_keep(s);
    if (*code == 0) *code = validate_case(s);
    if (*code == 0) *code = case_surfaces_read(s);
    if (*code == 0) *code = case_scales_auto_step(s); /* with their centres */
    if (*code == 0) return s;
    settings_free(s);
    return NULL;
}
