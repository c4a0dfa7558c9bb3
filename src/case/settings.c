/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/settings.h"

#include "base/alloc.h"
#include "case/particles/case_clumps.h"
#include "case/particles/case_population.h"
#include "case/case_mesh.h"
#include "case/schema.h"
#include "case/source.h"
#include "case/resolved/case_bodies.h"
#include "case/particles/case_surfaces.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct settings_text {
    config_t tree;
    const struct key **tables; /* a copy of the list, the tables borrowed */
    size_t n_tables;
    struct key **patches; /* the tables that are freed here, at their places in
                             the list; NULL without a mesh from files */
    struct inputs *files; /* that the case names */
};

void settings_beside(const struct settings *s, const char *file, char *path,
                     size_t size)
{
    const char *const at = s->file, *const end = strrchr(at, '/');
    const int folder = file[0] == '/' || end == NULL ? 0 : (int)(end + 1 - at);

    snprintf(path, size, "%.*s%s", folder, at, file);
}

struct inputs **settings_files(const struct settings *s)
{
    return &s->text->files;
}

const struct input *settings_input(const struct settings *s, const char *file)
{
    char path[SETTINGS_PATH];

    settings_beside(s, file, path, sizeof path);
    struct input *const in = input_kept(&s->text->files, path);
    free(in->asked);
    in->asked = source_place_of(config_root_setting(&s->text->tree), "", file);
    return in;
}

struct settings *settings_create(const char *file, int n_overrides,
                                 const char *const *overrides,
                                 const struct key *const *tables, int *code)
{
    struct settings *const s = alloc_zeroed(1, sizeof *s);

    s->text = alloc_zeroed(1, sizeof *s->text);
    while (tables[s->text->n_tables] != NULL)
        s->text->n_tables++;
    s->text->tables =
        alloc_zeroed(s->text->n_tables + 1, sizeof *s->text->tables);
    memcpy(s->text->tables, tables,
           s->text->n_tables * sizeof *s->text->tables);
    s->file = strdup(file);
    *code = source_read(&s->text->tree, &s->text->files, s->file);
    for (int i = 0; i < n_overrides && *code == 0; i++)
        *code = source_override(&s->text->tree, overrides[i]);
    if (*code == 0) *code = schema_check_texts(&s->text->tree);
    if (*code == 0)
        *code = case_mesh_patches(s, &s->text->tree, s->text->tables,
                                  &s->text->patches);
    if (*code == 0) *code = schema_check_check(&s->text->tree, s->text->tables);
    if (*code == 0) {
        schema_check_fill(&s->text->tree, s->text->tables);
        s->title = s->cites = "";
        fill_settings(s, s->text->tables);
        *code = case_clumps_make(s);
        if (*code == 0) *code = case_parcels_make(s);
        if (*code == 0) return s;
    }
    settings_free(s);
    return NULL;
}

void settings_free(struct settings *s)
{
    if (s == NULL) return;
    case_population_release(s);
    case_clumps_release(s);
    case_surfaces_release(s);
    case_bodies_release(s);
    fill_release(s, s->text->tables);
    config_destroy(&s->text->tree);
    free(s->text->tables);
    for (size_t i = 0; i < s->text->n_tables && s->text->patches != NULL; i++)
        free(s->text->patches[i]);
    free(s->text->patches);
    free((char *)s->file);
    input_forget(&s->text->files);
    mesh_free(s->poly);
    free(s->text);
    free(s);
}

const struct config_setting_t *settings_root(const struct settings *s)
{
    return config_root_setting(&s->text->tree);
}

/* A text is read of keys for a word, for any text, and for a file. */
static int type_fits(const struct key *key, enum key_type type)
{
    return key != NULL &&
           (key->type == type || (type == KEY_NAME && (key->type == KEY_TEXT ||
                                                       key->type == KEY_FILE)));
}

/* The groups of a list have the rows of its name. */
const struct key *settings_row(const struct settings *s, const char *path)
{
    char row[SCHEMA_TEXT] = "";
    size_t used = 0;

    for (const char *at = path; *at != '\0';) {
        const size_t n = strcspn(at, ".");
        if (strspn(at, "[0123456789]") < n && used + n + 1 < sizeof row)
            used += (size_t)sprintf(row + used, "%s%.*s", used > 0 ? "." : "",
                                    (int)n, at);
        at += n + (at[n] == '.');
    }
    return schema_find(s->text->tables, row);
}

const char *settings_item(char path[SETTINGS_ITEM_SIZE], const char *list,
                          int i, const char *key)
{
    snprintf(path, SETTINGS_ITEM_SIZE, "%s.[%d].%s", list, i, key);
    return path;
}

/* The setting of a path whose row must have the type. A setting that is not
 * there is an error of the caller, which has to call settings_has first. */
static const config_setting_t *
settings_find(const struct settings *s, const char *path, enum key_type type)
{
    const config_setting_t *const found = config_lookup(&s->text->tree, path);

    assert(type_fits(settings_row(s, path), type) && found != NULL);
    (void)type;
    return found;
}

int settings_has(const struct settings *s, const char *path)
{
    const config_setting_t *const found = config_lookup(&s->text->tree, path);

    assert(settings_row(s, path) != NULL);
    return found != NULL && !source_is_default(found);
}

int settings_is_set(const struct settings *s, const char *path)
{
    return config_lookup(&s->text->tree, path) != NULL;
}

double settings_real(const struct settings *s, const char *path)
{
    return source_number(settings_find(s, path, KEY_REAL));
}

int settings_int(const struct settings *s, const char *path)
{
    return config_setting_get_int(
        settings_find(s, path, KEY_INT)); /* of a word: 0 */
}

const char *settings_text(const struct settings *s, const char *path)
{
    const struct key *const key = settings_row(s, path);
    const config_setting_t *const found = config_lookup(&s->text->tree, path);

    assert(type_fits(key, KEY_NAME) || key->type == KEY_PATCH);
    assert(found != NULL || key->type == KEY_TEXT);
    return found != NULL ? config_setting_get_string(found) : "";
}

int settings_is_list(const struct settings *s, const char *path)
{
    const struct key *const key = schema_find(s->text->tables, path);
    return key != NULL && key->type == KEY_LIST;
}

int settings_length(const struct settings *s, const char *list)
{
    const config_setting_t *const found = config_lookup(&s->text->tree, list);

    assert(schema_find(s->text->tables, list) != NULL);
    return found != NULL ? config_setting_length(found) : 0;
}

/* The path of the i-th patch of the mesh from files, or NULL. */
static const char *patch_path(const struct settings *s, int i)
{
    SCHEMA_EACH (k, s->text->tables)
        if (k->type == KEY_PATCH && i-- == 0) return k->path;
    return NULL;
}

/* The sides of the box: the key of each, and that of it and the opposite one.
 */
static const char *const sides[][3] = {
    {"left", "fluid.left", "fluid.sides"},
    {"bottom", "fluid.bottom", "fluid.bottom_top"},
    {"back", "fluid.back", "fluid.front_back"},
    {"right", "fluid.right", "fluid.sides"},
    {"top", "fluid.top", "fluid.bottom_top"},
    {"front", "fluid.front", "fluid.front_back"}};

const char *settings_any_side(const struct settings *s, int i)
{
    if (s->text->patches != NULL) return patch_path(s, i);
    return i < 6 ? sides[i][1] : i < 9 ? sides[i - 6][2] : NULL;
}

static int is_side(const char *key, const char *patch)
{
    for (int i = 0; i < 6; i++)
        if (strcmp(sides[i][0], patch) == 0)
            return strcmp(sides[i][1], key) == 0 ||
                   strcmp(sides[i][2], key) == 0;
    return 0;
}

const struct boundary_options *settings_side(const struct settings *s,
                                             const char *patch)
{
    for (int i = 0; i < s->sides.n; i++) {
        const char *const key = s->sides.item[i].key;
        if (s->text->patches != NULL ? strcmp(strrchr(key, '.') + 1, patch) == 0
                                     : is_side(key, patch))
            return &s->sides.item[i];
    }
    return NULL;
}

const char *settings_key(const struct settings *s, const void *member)
{
    return fill_path(s, s->text->tables, member);
}

void settings_where(const struct settings *s, const char *path, char *where,
                    size_t size)
{
    const config_setting_t *const found = config_lookup(&s->text->tree, path);
    char place[SOURCE_TEXT];

    source_place(found != NULL ? found : config_root_setting(&s->text->tree),
                 place);
    snprintf(where, size, "%s: %s: ", place, path);
}

int settings_wrong(const struct settings *s, const char *path,
                   const char *format, ...)
{
    const config_setting_t *const found = config_lookup(&s->text->tree, path);
    char message[SOURCE_TEXT];
    va_list values;

    va_start(values, format);
    vsnprintf(message, sizeof message, format, values);
    va_end(values);
    return source_wrong(found != NULL ? found
                                      : config_root_setting(&s->text->tree),
                        "%s: %s", path, message);
}
