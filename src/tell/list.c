/* SPDX-License-Identifier: GPL-3.0-or-later */
/* list.c -- `winnow list`: what there is to choose from. */
#include "tell/check.h"

#include <stdio.h>
#include <string.h>

#include "case/case_file.h"
#include "case/command.h"
#include "case/models.h"
#include "base/text.h"
#include "case/schema.h"
#include "coupling/effects.h"
#include "record/history.h"
#include "record/recorder_part.h"

void list_kinds(void)
{
    struct model m;

    for (const struct kind *k = models_kinds; k->name != NULL; k++) {
        printf("%-14s %s, chosen by %s:\n%-14s", k->name, k->what, k->key, "");
        for (int i = 0; models_at(k, i, &m); i++)
            printf(" %s", m.name);
        putchar('\n');
    }
    printf("%-14s every key of a case file\n", "keys");
    printf("%-14s the columns of history.csv\n", "columns");
    printf("%-14s the cases that come with the program\n", "cases");
}

/* "[SX15 Table 1]", or nothing where there is no source. */
static void print_source(const char *source)
{
    if (source[0] != '\0') printf("  [%s]", source);
    putchar('\n');
}

/* "; needs fluid averaging; not with effects.x" of "fluid averaging !effects.x"
 */
static void print_needs(const char *needs)
{
    const char *const without = strchr(needs, '!');
    const int length =
        without != NULL ? (int)(without - needs) : (int)strlen(needs);

    if (length > 0)
        printf("; needs %.*s", without != NULL ? length - 1 : length, needs);
    if (without != NULL) printf("; not with %s", without + 1);
}

static void print_key(const struct key *key, const char *indent)
{
    char expected[SCHEMA_TEXT], value[SCHEMA_TEXT];

    schema_expected(key, expected);
    printf("%s%s = %s", indent, key->path, expected);
    if (schema_is_required(key))
        printf("; required");
    else if (schema_has_default(key)) {
        schema_default(key, value);
        printf("; default %s", value);
    }
    print_needs(key->needs);
    printf("\n%s    %s", indent, key->what);
    print_source(key->source);
}

void list_model(const struct model *m)
{
    printf("    %s: %s", m->name, m->what);
    print_source(m->equations);
    for (int t = 0; t < KEY_TABLES && m->keys[t] != NULL; t++)
        for (const struct key *k = m->keys[t]; k->path != NULL; k++)
            print_key(k, "        ");
}

/* The rows of a group, of the groups in it and of their models, or of one key.
 */
static int print_part(const struct key *const *tables, const char *part)
{
    int n = 0;

    SCHEMA_EACH (key, tables)
        if (schema_is_within(key, part)) {
            print_key(key, "");
            n++;
        }
    return n;
}

static int unknown_part(const struct key *const *tables, const char *name)
{
    char nearest[SCHEMA_TEXT] = "", hint[NEAREST_HINT];
    const int found = schema_nearest(tables, name, nearest) != NULL;

    fprintf(stderr, "winnow: no part of a case is called %s%s\n", name,
            nearest_hint(found ? nearest : NULL,
                         "; winnow list keys names all keys", hint));
    return 2;
}

int list_keys(const char *part)
{
    const struct key *tables[CASE_FILE_TABLES];

    case_file_tables(tables);
    if (part != NULL)
        return print_part(tables, part) > 0 ? 0 : unknown_part(tables, part);
    SCHEMA_EACH (key, tables)
        if (schema_member(key, "") != NULL) print_part(tables, key->path);
    return 0;
}

/* What a case must have for a column, in the order of the bits of needs. */
static const char *const column_needs[] = {"fluid",
                                           "particles",
                                           "exchange",
                                           "a mean flow",
                                           "fluid.cfl",
                                           "insertion or removal",
                                           "effects.energy_budget",
                                           "particles.parcel",
                                           "particles.parcel or clumps"};

static void print_column(const struct history_column *c, const char *of)
{
    const char *also = of;

    printf("%s", c->name);
    for (int i = 0; c->needs >> i > 0; i++)
        if (c->needs >> i & 1) also = column_needs[i];
    printf("%s%s\n    %s\n", also[0] != '\0' ? "; needs " : "", also, c->what);
}

/* The columns of history.csv, in its order. */
static int list_columns(void)
{
    for (const struct history_column *c = history_columns; c->name; c++)
        print_column(c, "");
    for (int i = 0; recorder_parts[i] != NULL; i++)
        for (const struct history_column *c = recorder_parts[i]->columns;
             c != NULL && c->name != NULL; c++)
            print_column(c, "bodies");
    for (int i = 0; effects[i] != NULL; i++)
        for (int k = 0; effects[i]->columns && effects[i]->columns->names[k];
             k++)
            printf("%s; needs effects.%s\n    of: %s\n",
                   effects[i]->columns->names[k], effects[i]->name,
                   effects[i]->keys[0]->what);
    return 0;
}

static int unknown_kind(const char *name)
{
    struct nearest n;
    char hint[NEAREST_HINT];

    nearest_init(&n, name);
    for (const struct kind *k = models_kinds; k->name != NULL; k++)
        nearest_offer(&n, k->name);
    nearest_offer(&n, "keys");
    nearest_offer(&n, "columns");
    nearest_offer(&n, "cases");
    fprintf(
        stderr, "winnow: no kind of model %s%s\n", name,
        nearest_hint(nearest_best(&n), "; winnow list names them all", hint));
    return 2;
}

int list_models(const char *name)
{
    const struct kind *const kind = models_kind(name);
    struct model m;

    if (strcmp(name, "keys") == 0) return list_keys(NULL);
    if (strcmp(name, "columns") == 0) return list_columns();
    if (kind == NULL) return unknown_kind(name);
    printf("%s, chosen by %s\n", kind->what, kind->key);
    for (int i = 0; models_at(kind, i, &m); i++)
        list_model(&m);
    return 0;
}

static int list_wrong_word(const char *word)
{
    fprintf(stderr,
            "winnow: %s: one argument too many\n"
            "winnow list [KIND] | keys [PART] | columns | cases\n",
            word);
    return 2;
}

static int list_act(const struct command_line *l)
{
    if (l->n_words > 1 && strcmp(l->words[0], "keys") == 0)
        return list_keys(l->words[1]);
    if (l->n_words > 1) return list_wrong_word(l->words[1]);
    if (l->n_words > 0 && strcmp(l->words[0], "cases") == 0)
        return list_cases();
    if (l->n_words > 0) return list_models(l->words[0]);
    list_kinds();
    return 0;
}

const struct command list_command = {
    "list",
    "[KIND] | keys [PART] | columns | cases",
    "the models of a kind with their keys; or the keys of a part of a case; or "
    "the columns of history.csv with their units; or the cases that come with "
    "the program",
    "",
    0,
    2,
    list_act};
