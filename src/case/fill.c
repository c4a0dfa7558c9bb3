/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/settings.h"

#include <assert.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "case/models.h"
#include "case/schema.h"
#include "case/source.h"

/* The struct that the keys of a group fill, and the int that says that the case
 * names it; REQUIRED: every case does. A group within another one, with a
 * struct of its own, stands before it. */
#define REQUIRED SIZE_MAX
static const struct {
    const char *name;
    size_t at, has;
} groups[] = {
    {"mesh", offsetof(struct settings, mesh), REQUIRED},
    {"fluid", offsetof(struct settings, fluid),
     offsetof(struct settings, has.fluid)},
    {"particles", offsetof(struct settings, particles),
     offsetof(struct settings, has.particles)},
    {"averaging", offsetof(struct settings, averaging),
     offsetof(struct settings, has.averaging)},
    {"exchange", offsetof(struct settings, exchange),
     offsetof(struct settings, has.exchange)},
    {"effects", offsetof(struct settings, effects),
     offsetof(struct settings, has.effects)},
    {"bodies", offsetof(struct settings, bodies),
     offsetof(struct settings, has.bodies)},
    {"output", offsetof(struct settings, output), REQUIRED},
};
enum { GROUPS = sizeof groups / sizeof groups[0] };

/* What stands behind the name of a group in a path that begins with it: "" for
 * the group itself; NULL for another path. */
static const char *fill_within(const char *path, const char *group)
{
    const size_t n = strlen(group);

    if (strncmp(path, group, n) != 0) return NULL;
    return path[n] == '.' ? &path[n + 1] : path[n] == '\0' ? &path[n] : NULL;
}

/* --- one value ------------------------------------------------------------ */

static const void *model_named(const void *models, const char *name)
{
    const char *const *const *m = models; /* a name is the first member */

    while (*m != NULL && strcmp(**m, name) != 0)
        m++;
    return *m;
}

static void store_text(const struct key *key, const char *text, void *member)
{
    if (key->models != NULL)
        *(const void **)member = model_named(key->models, text);
    else if (key->choices != NULL)
        *(int *)member = models_value(key->choices, text);
    else
        *(const char **)member = text;
}

static void store_series(const config_setting_t *from,
                         struct key_series *points)
{
    const int is_list = config_setting_is_list(from);

    points->n = is_list ? config_setting_length(from) : 1;
    points->at = alloc_doubles(2 * points->n);
    points->value = points->at + points->n;
    if (!is_list) points->value[0] = source_number(from);
    for (int i = 0; i < points->n && is_list; i++) {
        const config_setting_t *const one = source_element(from, i);
        points->at[i] = source_number(config_setting_get_elem(one, 0));
        points->value[i] = source_number(config_setting_get_elem(one, 1));
    }
}

/* A word in the place of a whole number is 0. */
static void fill_store(const struct key *key, const config_setting_t *from,
                       void *member)
{
    double *const real = member;
    int *const whole = member;

    if (key->type == KEY_REAL) *real = source_number(from);
    if (key->type == KEY_INT) *whole = config_setting_get_int(from);
    if (key->type == KEY_BOOL) *whole = config_setting_get_bool(from);
    for (int k = 0; k < 3; k++) {
        if (key->type == KEY_VECTOR)
            real[k] = source_number(source_element(from, k));
        if (key->type == KEY_COUNTS)
            whole[k] = config_setting_get_int_elem(from, k);
        if (key->type == KEY_FLAGS)
            whole[k] = config_setting_get_bool_elem(from, k);
    }
    if (key->type == KEY_SERIES || key->type == KEY_CURVE)
        store_series(from, member);
    if (key->type == KEY_NAME || key->type == KEY_TEXT || key->type == KEY_FILE)
        store_text(key, config_setting_get_string(from), member);
}

static const config_setting_t *fill_setting(const struct settings *s,
                                            const char *path)
{
    return config_lookup(settings_root(s)->config, path);
}

static void store_at(const struct settings *s, const struct key *key,
                     const char *path, void *base)
{
    const config_setting_t *const from = fill_setting(s, path);
    char *const of = base;

    if (key->at > 0 && key->size == 0 && from != NULL)
        fill_store(key, from, of + key->at - 1);
    if (key->given > 0)
        *(int *)(of + key->given - 1) =
            from != NULL && !source_is_default(from);
}

/* --- lists ---------------------------------------------------------------- */

/* The row of the list, or of the sides, to whose groups the key belongs, or
 * NULL. */
static const struct key *fill_list_of(const struct key *const *tables,
                                      const struct key *key)
{
    SCHEMA_EACH (k, tables)
        if ((k->size > 0 || k->type == KEY_PATCH) && k != key &&
            fill_within(key->path, k->path) != NULL)
            return k;
    return NULL;
}

static void store_in_list(const struct settings *s, const struct key *key,
                          const struct key *of, const struct key_list *list)
{
    const char *const name = fill_within(key->path, of->path);
    char path[SETTINGS_ITEM_SIZE];

    for (int i = 0; i < list->n; i++)
        store_at(s, key, settings_item(path, of->path, i, name),
                 (char *)list->item + (size_t)i * of->size);
}

/* --- sides ---------------------------------------------------------------- */

/* The condition of a side: a word, or the group with the first of its keys. */
static const struct boundary_condition *side_condition(const struct settings *s,
                                                       const char *side)
{
    const struct boundary_condition *const *c = boundary_conditions;
    const char *const word = settings_text(s, side);
    char path[SCHEMA_TEXT];

    for (; *c != NULL; c++) {
        const struct key *const first = (*c)->keys[0];
        if (word != NULL && strcmp(word, (*c)->name) == 0) break;
        if (word != NULL || first == NULL) continue;
        snprintf(path, sizeof path, "%s%s", side, strrchr(first->path, '.'));
        if (settings_has(s, path)) break;
    }
    return *c;
}

static void create_sides(struct settings *s)
{
    const char *key;
    int n = 0;

    while (settings_any_side(s, n) != NULL)
        n++;
    s->sides.item = alloc_zeroed((size_t)n, sizeof *s->sides.item);
    for (int i = 0; (key = settings_any_side(s, i)) != NULL; i++)
        if (settings_has(s, key))
            s->sides.item[s->sides.n++] = (struct boundary_options){
                .key = key, .condition = side_condition(s, key)};
}

static void store_in_sides(struct settings *s, const struct key *key,
                           const struct key *of)
{
    char path[SCHEMA_TEXT];

    for (int i = 0; i < s->sides.n; i++) {
        struct boundary_options *const o = &s->sides.item[i];
        if (!key_matches(of->path, o->key)) continue;
        snprintf(path, sizeof path, "%s%s", o->key, strrchr(key->path, '.'));
        store_at(s, key, path, o);
    }
}

/* --- all ------------------------------------------------------------------ */

/* The struct that the key, or the list that it belongs to, has its place in. */
static char *fill_base_of(struct settings *s, const struct key *key)
{
    for (int g = 0; g < GROUPS; g++)
        if (fill_within(key->path, groups[g].name) != NULL)
            return (char *)s + groups[g].at;
    return (char *)s;
}

/* A study has other groups than a case. */
void fill_settings(struct settings *s, const struct key *const *tables)
{
    for (int g = 0; g < GROUPS; g++)
        if (groups[g].has != REQUIRED)
            *(int *)((char *)s + groups[g].has) =
                schema_find(tables, groups[g].name) != NULL &&
                settings_has(s, groups[g].name);
    if (schema_find(tables, "fluid") != NULL) create_sides(s);
    SCHEMA_EACH (k, tables)
        if (k->size > 0) {
            struct key_list *const list =
                (struct key_list *)(fill_base_of(s, k) + k->at - 1);
            list->n = settings_length(s, k->path);
            if (list->n > 0)
                list->item = alloc_zeroed((size_t)list->n, k->size);
        }
    SCHEMA_EACH (k, tables) {
        const struct key *const list =
            k->at == 0 && k->given == 0 ? NULL : fill_list_of(tables, k);

        if (k->at == 0 && k->given == 0) continue;
        if (list == NULL)
            store_at(s, k, k->path, fill_base_of(s, k));
        else if (list->type == KEY_PATCH)
            store_in_sides(s, k, list);
        else
            store_in_list(
                s, k, list,
                (struct key_list *)(fill_base_of(s, list) + list->at - 1));
    }
}

const char *fill_path(const struct settings *s, const struct key *const *tables,
                      const void *member)
{
    SCHEMA_EACH (k, tables) {
        const char *const base = fill_base_of((struct settings *)s, k);
        if (((k->at > 0 && base + k->at - 1 == member) ||
             (k->given > 0 && base + k->given - 1 == member)) &&
            fill_list_of(tables, k) == NULL)
            return k->path;
    }
    assert(0); /* a member that no key fills */
    return "";
}

void fill_release(struct settings *s, const struct key *const *tables)
{
    for (int i = 0; i < s->sides.n; i++) {
        free(s->sides.item[i].inlet.at);
        free(s->sides.item[i].table.at);
    }
    free(s->sides.item);
    for (int i = 0; i < s->particles.sizes.n; i++)
        free(s->particles.sizes.item[i].points.at);
    SCHEMA_EACH (k, tables)
        if (k->size > 0)
            free(((struct key_list *)(fill_base_of(s, k) + k->at - 1))->item);
}

/* --- numbers in the order of a table -------------------------------------- */

/* One of a number, three of a vector, none of a group. */
static int numbers_of(const struct settings *s, const struct key *key,
                      double v[3])
{
    const config_setting_t *const from = fill_setting(s, key->path);
    int whole;

    if (key->type == KEY_GROUP) return 0;
    assert(from != NULL);
    if (key->type == KEY_INT || key->type == KEY_BOOL ||
        key->type == KEY_NAME) { /* that of its choices */
        fill_store(key, from, &whole);
        v[0] = whole;
    } else
        fill_store(key, from, v);
    return key->type == KEY_VECTOR ? 3 : 1;
}

int fill_numbers(const struct settings *s, const struct key *keys,
                 double *numbers, int max)
{
    int n = 0;

    for (const struct key *key = keys; key->path != NULL; key++) {
        double v[3];
        const int given = numbers_of(s, key, v);

        for (int k = 0; k < given; k++, n++)
            if (n < max) numbers[n] = v[k];
    }
    return n;
}

int fill_effect_numbers(const struct settings *s, const struct effect *e,
                        double numbers[EFFECT_NUMBERS])
{
    for (int k = 0; k < EFFECT_NUMBERS; k++)
        numbers[k] = 0.0;
    if (!settings_has(s, e->keys[0]->path)) return 0;
    fill_numbers(s, e->keys[0], numbers, EFFECT_NUMBERS);
    return 1;
}
