/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/report/equation_index.h"

#include "case/report/equations.h"
#include "case/nearest.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

static const char *const documents[] = {"SX15", "XS11", "LS", "EW18", NULL};

static int is_document(const char *word)
{
    for (int i = 0; documents[i] != NULL; i++)
        if (strcmp(word, documents[i]) == 0) return 1;
    return 0;
}

int equation_index_is_key(const char *word)
{
    const char *const dot = strrchr(word, '.');

    if (is_document(word)) return 1;
    if (dot != NULL && strcmp(dot, ".cfg") == 0) return 0;
    return strpbrk(word, ": ") != NULL && strchr(word, '/') == NULL;
}

/* 1 if the letters are the same, whatever their case, and a colon for a blank.
 */
static int equation_index_same(char a, char b)
{
    return (a == ':' ? ' ' : tolower((unsigned char)a)) ==
           tolower((unsigned char)b);
}

/* What is left of a key behind the wanted one; NULL if it begins otherwise. */
static const char *left_of(const char *wanted, const char *key)
{
    for (; *wanted != '\0'; wanted++, key++)
        if (!equation_index_same(*wanted, *key)) return NULL;
    return key;
}

/* 1 if the key is the wanted one, or a part of it: 5a, if 5 is wanted. */
static int equation_index_is_wanted(const char *wanted, const char *key)
{
    const char *const left = left_of(wanted, key);

    if (left == NULL || left[0] == '\0') return left != NULL;
    return left > key && isdigit((unsigned char)left[-1]) &&
           islower((unsigned char)left[0]) && left[1] == '\0';
}

static int is_of(const struct equation_index_row *r, const char *key)
{
    return r->key != NULL && strcmp(r->key, key) == 0;
}

/* All rows of one kind, the first behind its heading. */
static void print_kind(const struct equation_index_row *r,
                       enum equation_index_kind kind, const char *heading)
{
    const char *const key = r->key;
    int n = 0;

    for (; is_of(r, key); r++)
        if (r->kind == kind)
            printf("  %-13s %-34s %s\n", n++ == 0 ? heading : "", r->file,
                   r->name);
    if (n == 0) printf("  %-13s nothing yet\n", heading);
}

static void print_eval_of(const struct equation *e)
{
    printf("  %-13s winnow eval %s, with %s\n", "evaluated by", e->key,
           e->inputs);
}

static void print_eval(const char *key)
{
    struct equation e;

    for (int i = 0; equations_at(i, &e); i++)
        if (equation_index_is_wanted(e.key, key)) print_eval_of(&e);
}

static void print_formula(const char *key, int indent)
{
    struct equation e;

    for (int i = 0; equations_at(i, &e); i++)
        if (equation_index_is_wanted(e.key, key))
            printf("%*s%s\n", indent, "", e.formula);
}

static const struct equation_index_row *equation_index_row_of(const char *key)
{
    const struct equation_index_row *r = equation_index_rows;

    while (r->key != NULL && !is_of(r, key))
        r++;
    return r;
}

static void print_equation(const struct equation_index_row *r)
{
    printf("%s: %s\n", r->key, r->name);
    if (is_of(r + 1, r->key) && r[1].kind == EQUATION_INDEX_AS) {
        r = equation_index_row_of(r[1].name);
        printf("  %-13s %s: %s\n", "the same as", r->key, r->name);
    }
    print_formula(r->key, 2);
    if (is_of(r + 1, r->key) && r[1].kind == EQUATION_INDEX_STATUS)
        printf("  %s\n", r[1].name);
    print_kind(r, EQUATION_INDEX_FUNCTION, "computed by");
    print_kind(r, EQUATION_INDEX_TEST, "tested by");
    print_kind(r, EQUATION_INDEX_SECTION, "explained in");
    print_eval(r->key);
}

static int equation_index_unknown(const char *key)
{
    struct nearest n;

    nearest_init(&n, key);
    for (const struct equation_index_row *r = equation_index_rows;
         r->key != NULL; r++)
        if (r->kind == EQUATION_INDEX_SAYS) nearest_offer(&n, r->key);
    fprintf(stderr, "winnow: no equation %s; ", key);
    if (nearest_best(&n) != NULL)
        fprintf(stderr, "did you mean \"%s\"?\n", nearest_best(&n));
    else
        fputs("a key is a document (SX15, XS11, LS, EW18) and a number, "
              "XS11:2.13; chapters/equations.md has all\n",
              stderr);
    return 2;
}

/* A line for each equation of a document. */
static int list_document(const char *document)
{
    for (const struct equation_index_row *r = equation_index_rows;
         r->key != NULL; r++) {
        const char *const left = left_of(document, r->key);

        if (r->kind != EQUATION_INDEX_SAYS || left == NULL || left[0] != ' ')
            continue;
        printf("%-18s %s%s%s\n", r->key, r->name,
               r[1].kind == EQUATION_INDEX_AS       ? "; as "
               : r[1].kind == EQUATION_INDEX_STATUS ? "; "
                                                    : "",
               r[1].kind == EQUATION_INDEX_AS ||
                       r[1].kind == EQUATION_INDEX_STATUS
                   ? r[1].name
                   : "");
    }
    return 0;
}

int equation_index_has_function(const char *name)
{
    for (const struct equation_index_row *r = equation_index_rows;
         r->key != NULL; r++)
        if (r->kind == EQUATION_INDEX_FUNCTION && strcmp(r->name, name) == 0)
            return 1;
    return 0;
}

void equation_index_offer_functions(struct nearest *n)
{
    for (const struct equation_index_row *r = equation_index_rows;
         r->key != NULL; r++)
        if (r->kind == EQUATION_INDEX_FUNCTION) nearest_offer(n, r->name);
}

/* Where a function stands, and the equations that it computes. */
void equation_index_explain_function(const char *name)
{
    const char *file = "";
    int found = 0;

    for (const struct equation_index_row *r = equation_index_rows;
         r->key != NULL; r++) {
        if (r->kind != EQUATION_INDEX_FUNCTION || strcmp(r->name, name) != 0)
            continue;
        if (strcmp(r->file, file) != 0) printf("%s, %s\n", name, r->file);
        file = r->file;
        printf("  %-13s %s: %s\n", found++ == 0 ? "computes" : "", r->key,
               equation_index_row_of(r->key)->name);
        print_formula(r->key, 18);
    }
}

/* What is no equation of the documents may be one of eval: a drag law. */
int equation_index_explain(const char *key)
{
    struct equation e;
    int found = 0;

    if (is_document(key)) return list_document(key);
    for (const struct equation_index_row *r = equation_index_rows;
         r->key != NULL; r++)
        if (r->kind == EQUATION_INDEX_SAYS &&
            equation_index_is_wanted(key, r->key)) {
            if (found++ > 0) putchar('\n');
            print_equation(r);
        }
    if (found == 0 && equations_named(key, &e)) {
        printf("%s: %s\n  %s\n", e.key, e.what, e.formula);
        print_eval_of(&e);
        return 0;
    }
    return found > 0 ? 0 : equation_index_unknown(key);
}
