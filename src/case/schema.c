/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/schema.h"

#include "case/models.h"
#include "fluid/boundary.h"
#include "base/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *const schema_patches[] = {
    "left",  "right", "bottom",     "top",        "back",
    "front", "sides", "bottom_top", "front_back", NULL};

enum { SCHEMA_WORDS = 1024 }; /* bytes of all names of a kind, at most */

static int schema_is_patch(const char *name, size_t length)
{
    for (int i = 0; schema_patches[i] != NULL; i++)
        if (strlen(schema_patches[i]) == length &&
            strncmp(schema_patches[i], name, length) == 0)
            return 1;
    return 0;
}

/* 1 if the path is the row's, with any side of the box for <patch>. */
static int matches(const char *row, const char *path)
{
    size_t n = 0;

    while (row[n] != '\0' && row[n] == path[n] && row[n] != KEY_ANY_PATCH[0])
        n++;
    if (row[n] != KEY_ANY_PATCH[0]) return row[n] == path[n];
    return key_matches(row, path) &&
           schema_is_patch(path + n, strcspn(path + n, "."));
}

const struct key *schema_find(const struct key *const *tables, const char *path)
{
    SCHEMA_EACH (k, tables)
        if (matches(k->path, path)) return k;
    return NULL;
}

const char *schema_member(const struct key *key, const char *group)
{
    const char *const dot = strrchr(key->path, '.');
    char parent[SCHEMA_TEXT];

    if (dot == NULL) return group[0] == '\0' ? key->path : NULL;
    snprintf(parent, sizeof parent, "%.*s", (int)(dot - key->path), key->path);
    return matches(parent, group) ? dot + 1 : NULL;
}

int schema_is_within(const struct key *key, const char *path)
{
    char part[SCHEMA_TEXT];

    for (size_t n = 0; n < strlen(key->path); n++) {
        n += strcspn(key->path + n, ".");
        snprintf(part, sizeof part, "%.*s", (int)n, key->path);
        if (matches(part, path)) return 1;
    }
    return 0;
}

/* The conditions and words of a row; where it has none, the names of the models
 * that it chooses between. */
static const char *allowed(const struct key *key, char text[SCHEMA_WORDS])
{
    if (key->allowed[0] != '\0') return key->allowed;
    models_words(key, text, SCHEMA_WORDS);
    return text;
}

int schema_is_required(const struct key *key)
{
    return key->fallback == NULL ||
           strcmp(key->fallback, KEY_MODEL_REQUIRED) == 0;
}

int schema_has_default(const struct key *key)
{
    return !schema_is_required(key) && key->fallback[0] != '\0';
}

/* Copies the next word or condition of a row and returns what follows it, or
 * NULL when there is none left. */
static const char *next_allowed(const char *rest, char one[SCHEMA_TEXT])
{
    size_t length;

    rest += strspn(rest, " |,");
    length = strcspn(rest, "|,");
    while (length > 0 && rest[length - 1] == ' ')
        length--;
    snprintf(one, SCHEMA_TEXT, "%.*s", (int)length, rest);
    return length == 0 ? NULL : rest + length;
}

void schema_default(const struct key *key, char text[SCHEMA_TEXT])
{
    char all[SCHEMA_WORDS];

    if (strcmp(key->fallback, KEY_FIRST) == 0)
        next_allowed(allowed(key, all), text);
    else
        snprintf(text, SCHEMA_TEXT, "%s", key->fallback);
}

static int is_condition(const char *one)
{
    return one[0] == '<' || one[0] == '>';
}

static int schema_holds(const char *condition, double value)
{
    const int with_equal = condition[1] == '=';
    const double bound = strtod(condition + 1 + with_equal, NULL);

    if (with_equal && value == bound) return 1;
    return condition[0] == '>' ? value > bound : value < bound;
}

int schema_allow_number(const struct key *key, double value)
{
    char one[SCHEMA_TEXT], all[SCHEMA_WORDS];
    const char *rest = allowed(key, all);

    while ((rest = next_allowed(rest, one)) != NULL)
        if (is_condition(one) && !schema_holds(one, value)) return 0;
    return 1;
}

int schema_allow_word(const struct key *key, const char *word)
{
    char one[SCHEMA_TEXT], all[SCHEMA_WORDS];
    const char *rest = allowed(key, all);

    while ((rest = next_allowed(rest, one)) != NULL)
        if (!is_condition(one) && strcmp(one, word) == 0) return 1;
    return 0;
}

int schema_nearest_word(const struct key *key, const char *word,
                        char nearest[SCHEMA_TEXT])
{
    char one[SCHEMA_TEXT], all[SCHEMA_WORDS];
    const char *rest = allowed(key, all);
    struct nearest n;

    nearest_init(&n, word);
    while ((rest = next_allowed(rest, one)) != NULL)
        if (!is_condition(one)) nearest_offer(&n, one);
    if (nearest_best(&n) == NULL) return 0;
    snprintf(nearest, SCHEMA_TEXT, "%s", nearest_best(&n));
    return 1;
}

static void schema_append(char text[SCHEMA_TEXT], const char *more)
{
    strncat(text, more, SCHEMA_TEXT - 1 - strlen(text));
}

/* The words or the conditions of a row, one after the other. */
static void schema_gather(const struct key *key, int conditions,
                          const char *between, char text[SCHEMA_TEXT])
{
    char one[SCHEMA_TEXT], all[SCHEMA_WORDS];
    const char *rest = allowed(key, all);

    text[0] = '\0';
    while ((rest = next_allowed(rest, one)) != NULL)
        if (is_condition(one) == conditions) {
            if (text[0] != '\0') schema_append(text, between);
            schema_append(text, one);
        }
}

/* The keys by which a side chooses its boundary condition. */
static void append_conditions(char text[SCHEMA_TEXT])
{
    const char *between = "";

    for (int i = 0; boundary_conditions[i] != NULL; i++) {
        const struct key *const first = boundary_conditions[i]->keys[0];
        if (first == NULL) continue;
        schema_append(text, between);
        schema_append(text, strrchr(first->path, '.') + 1);
        between = ", ";
    }
}

void schema_expected(const struct key *key, char text[SCHEMA_TEXT])
{
    static const char *const phrases[] = {
        [KEY_GROUP] = "a group { ... }",
        [KEY_LIST] = "a list of groups ( { ... }, ... )",
        [KEY_REAL] = "a number",
        [KEY_INT] = "a whole number",
        [KEY_BOOL] = "true or false",
        [KEY_NAME] = "",
        [KEY_TEXT] = "a text in quotes",
        [KEY_FILE] = "the name of a file in quotes",
        [KEY_VECTOR] = "three numbers [x, y, z], each",
        [KEY_COUNTS] = "three whole numbers [x, y, z], each",
        [KEY_FLAGS] = "three of true or false [x, y, z]",
        [KEY_SERIES] =
            "a number or ((time, number), ...) with time rising, each number",
        [KEY_CURVE] = "((x, number), ...) with x rising, each number",
        [KEY_PATCH] = "{ KEY = ...; } with one of "};
    char conditions[SCHEMA_TEXT], words[SCHEMA_TEXT];

    schema_gather(key, 1, ", ", conditions);
    schema_gather(key, 0, " or ", words);
    snprintf(text, SCHEMA_TEXT, "%s", phrases[key->type]);
    if (key->type == KEY_PATCH) append_conditions(text);
    if (conditions[0] != '\0') schema_append(text, " ");
    schema_append(text, conditions);
    if (key->unit[0] != '\0') schema_append(text, " [");
    schema_append(text, key->unit);
    if (key->unit[0] != '\0') schema_append(text, "]");
    if (text[0] != '\0' && words[0] != '\0') schema_append(text, " or ");
    schema_append(text, words);
}

/* Replaces the last name of a path. */
static void schema_beside(const char *path, const char *name,
                          char text[SCHEMA_TEXT])
{
    const char *const dot = strrchr(path, '.');
    const int length = dot == NULL ? 0 : (int)(dot + 1 - path);

    snprintf(text, SCHEMA_TEXT, "%.*s%s", length, path, name);
}

static void offer_row(struct nearest *n, const char *name)
{
    if (strcmp(name, KEY_ANY_PATCH) != 0)
        nearest_offer(n, name);
    else
        for (int i = 0; schema_patches[i] != NULL; i++)
            nearest_offer(n, schema_patches[i]);
}

/* A row as a case would write its path, with one of the sides in the place of
 * <patch>. */
static void as_written(const struct key *key, char text[SCHEMA_TEXT])
{
    const char *const at = strstr(key->path, KEY_ANY_PATCH);
    const int before = at == NULL ? 0 : (int)(at - key->path);

    if (at == NULL)
        snprintf(text, SCHEMA_TEXT, "%s", key->path);
    else
        snprintf(text, SCHEMA_TEXT, "%.*s%s%s", before, key->path, "bottom",
                 at + strlen(KEY_ANY_PATCH));
}

/* The first row of that name, in whatever group. */
static const struct key *row_named(const struct key *const *tables,
                                   const char *name)
{
    SCHEMA_EACH (k, tables) {
        const char *const last = strrchr(k->path, '.');
        if (strcmp(last == NULL ? k->path : last + 1, name) == 0) return k;
    }
    return NULL;
}

const struct key *schema_nearest(const struct key *const *tables,
                                 const char *path, char nearest[SCHEMA_TEXT])
{
    const char *const dot = strrchr(path, '.');
    const char *const name = dot == NULL ? path : dot + 1;
    char group[SCHEMA_TEXT] = "";
    struct nearest n;

    if (dot != NULL)
        snprintf(group, sizeof group, "%.*s", (int)(dot - path), path);
    nearest_init(&n, name);
    SCHEMA_EACH (k, tables)
        if (schema_member(k, group) != NULL)
            offer_row(&n, schema_member(k, group));
    if (nearest_best(&n) != NULL) {
        schema_beside(path, nearest_best(&n), nearest);
        return schema_find(tables, nearest);
    }
    const struct key *const row = row_named(tables, name);
    if (row != NULL) as_written(row, nearest);
    return row;
}
