/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/report/list.h"

#include "case/models.h"
#include "case/nearest.h"
#include "case/schema.h"
#include "case/case_file.h"

#include <stdio.h>
#include <string.h>

void list_kinds(void)
{
    struct model m;

    for (const struct kind *k = models_kinds; k->name != NULL; k++) {
        printf("%-14s %s, chosen by %s:\n%-14s", k->name, k->what, k->key, "");
        for (int i = 0; k->model(i, &m); i++)
            printf(" %s", m.name);
        putchar('\n');
    }
    printf("%-14s every key of a case file\n", "keys");
}

/* "[SX15 Table 1]", or nothing where there is no source. */
static void print_source(const char *source)
{
    if (source[0] != '\0') printf("  [%s]", source);
    putchar('\n');
}

static void print_key(const struct key *key, const char *indent)
{
    char expected[SCHEMA_TEXT];

    schema_expected(key, expected);
    printf("%s%s = %s", indent, key->path, expected);
    if (schema_is_required(key))
        printf("; required");
    else if (schema_has_default(key))
        printf("; default %s", key->fallback);
    if (key->needs[0] != '\0') printf("; needs %s", key->needs);
    printf("\n%s    %s", indent, key->what);
    print_source(key->source);
}

static void print_keys_of(const struct model *m)
{
    for (int t = 0; t < KEY_TABLES && m->keys[t] != NULL; t++)
        for (const struct key *k = m->keys[t]; k->path != NULL; k++)
            print_key(k, "        ");
}

static void print_all_keys(void)
{
    const struct key *tables[CASE_FILE_TABLES], *key;

    case_file_tables(tables);
    for (int i = 0; (key = schema_at(tables, i)) != NULL; i++)
        print_key(key, "");
}

static int unknown_kind(const char *name)
{
    struct nearest n;

    nearest_init(&n, name);
    for (const struct kind *k = models_kinds; k->name != NULL; k++)
        nearest_offer(&n, k->name);
    nearest_offer(&n, "keys");
    if (nearest_best(&n) != NULL)
        fprintf(stderr, "winnow: no kind of model %s; did you mean %s?\n", name,
                nearest_best(&n));
    else
        fprintf(stderr,
                "winnow: no kind of model %s; winnow list names them all\n",
                name);
    return 2;
}

int list_models(const char *name)
{
    const struct kind *const kind = models_kind(name);
    struct model m;

    if (strcmp(name, "keys") == 0) {
        print_all_keys();
        return 0;
    }
    if (kind == NULL) return unknown_kind(name);
    printf("%s, chosen by %s\n", kind->what, kind->key);
    for (int i = 0; kind->model(i, &m); i++) {
        printf("    %s: %s", m.name, m.what);
        print_source(m.equations);
        print_keys_of(&m);
    }
    return 0;
}
