/* SPDX-License-Identifier: GPL-3.0-or-later */
/* explain.c -- `winnow explain`: which equations a case switches on, and what
 * is known of an equation, a key, a model or a function. */
#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "case/case_file.h"
#include "case/particles/case_materials.h"
#include "case/checks/checks.h"
#include "case/command.h"
#include "base/text.h"
#include "tell/check.h"
#include "case/schema.h"

/* --- an equation: its function, tests, paragraph and `eval` key ---------- */

static const char *const documents[] = {"SX15", "XS11", "LS", "EW18", NULL};

static int is_document(const char *word)
{
    for (int i = 0; documents[i] != NULL; i++)
        if (strcmp(word, documents[i]) == 0) return 1;
    return 0;
}

static int equation_index_is_key(const char *word)
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
        const char *const behind = r[1].kind == EQUATION_INDEX_AS ? "; as "
                                   : r[1].kind == EQUATION_INDEX_STATUS ? "; "
                                                                        : "";
        printf("%-18s %s%s%s\n", r->key, r->name, behind,
               behind[0] != '\0' ? r[1].name : "");
    }
    return 0;
}

/* Where a function stands, and the equations that it computes; how many. */
static int equation_index_explain_function(const char *name)
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
    return found;
}

/* What is no equation of the documents may be one of eval: a drag law. */
static int equation_index_explain(const char *key)
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

/* --- a case, a key, a model, a function, a command ----------------------- */

/* What a case computes as soon as it names a group. */
struct part {
    const char *group, *what, *source, *function;
};

/* Stands for the key in the groups of several materials. */
static const char rolling[] = "particles.grains.rolling_friction";

static const struct part parts[] = {
    {"mesh", "the coupled step", "XS11 Algorithm 3.1", "coupling_step"},
    {"fluid", "momentum of the fluid, averaged locally", "XS11 2.8",
     "momentum_assemble"},
    {"fluid", "pressure, from continuity (PISO)", "XS11 2.7",
     "pressure_correct"},
    {"particles", "motion of each particle", "LS 4.1-4.3", "dem_run"},
    {"particles.surfaces", "contacts with walls besides the box", "LS 4.1-4.3",
     "surfaces_add_loads"},
    {"particles.prescribed", "particles that move as prescribed", "LS Fig. 4.3",
     "prescribed_particles_set_velocities"},
    {"averaging", "solids fraction and velocity of the cells", "SX15 4-9",
     "transfer_average"},
    {"exchange", "drag on each particle", "XS11 2.6, 2.10",
     "transfer_begin_substep"},
    {"exchange", "sub-steps and the mean velocity over them", "XS11 3.18-3.20",
     "move_with_drag"},
    {"particles.materials", "properties of each pair of materials",
     "LS 4.9, 4.10", "materials_pair"},
    {rolling, "rolling friction", "Ai11", "rolling_moment"},
    {NULL, NULL, NULL, NULL}};

static int is_named(const struct settings *s, const struct part *p)
{
    return p->group == rolling ? case_materials_resist_rolling(s)
                               : settings_has(s, p->group);
}

static void print_line(const char *source, const char *function,
                       const char *kind, const char *what)
{
    printf("  %-26s %-32s %s%s%s\n", source, function, kind,
           kind[0] != '\0' ? ": " : "", what);
}

static void print_parts(const struct settings *s, int named)
{
    for (const struct part *p = parts; p->group != NULL; p++)
        if (!is_named(s, p) == !named)
            print_line(p->source, p->function, "", p->what);
}

static void print_on(const struct settings *s)
{
    struct model m;

    puts("On");
    print_parts(s, 1);
    for (const struct kind *k = models_kinds; k->name != NULL; k++)
        for (int i = 0; models_at(k, i, &m); i++)
            if (model_choice_is_on(s, k, &m)) {
                char name[128];
                snprintf(name, sizeof name, "%s %s", k->name, m.name);
                print_line(m.equations, m.function, name, m.what);
            }
}

static void print_off(const struct settings *s)
{
    struct model m;

    puts("Off: nothing is allocated and nothing called");
    print_parts(s, 0);
    for (const struct kind *k = models_kinds; k->name != NULL; k++) {
        int n = 0;

        for (int i = 0; models_at(k, i, &m); i++)
            if (!model_choice_is_on(s, k, &m)) {
                if (n++ == 0) printf("  %s:", k->name);
                printf(" %s", m.name);
            }
        if (n > 0) putchar('\n');
    }
}

static void explain_case(const struct settings *s)
{
    printf("%s\n", s->title);
    print_on(s);
    print_off(s);
}

/* The rows of a key of a case, and the models between which it chooses. */
static int explain_case_key(const char *key)
{
    const int code = list_keys(key);

    for (const struct kind *k = models_kinds; k->name != NULL; k++)
        if (strcmp(k->key, key) == 0) list_models(k->name);
    return code;
}

/* The models of that name, or that this function computes; how many. */
static int explain_models(const char *word)
{
    struct model m;
    int n = 0;

    for (const struct kind *k = models_kinds; k->name != NULL; k++)
        for (int i = 0; models_at(k, i, &m); i++) {
            if (strcmp(m.name, word) != 0 && strcmp(m.function, word) != 0)
                continue;
            printf("%s %s: chosen by %s, computed by %s\n", k->name, m.name,
                   k->key, m.function);
            list_model(&m);
            n++;
        }
    return n;
}

static const char accepted[] =
    "CASE [-s path.to.key=value]... | KEY | MODEL | FUNCTION | COMMAND";

/* Offers the words that explain knows: the paths of keys, or only the last
 * names of these; commands, functions and models. */
static void offer_paths(struct nearest *n, const struct key *const *tables)
{
    struct model m;

    for (const struct command *const *c = commands; *c != NULL; c++)
        nearest_offer(n, (*c)->name);
    for (const struct kind *k = models_kinds; k->name != NULL; k++)
        for (int i = 0; models_at(k, i, &m); i++) {
            nearest_offer(n, m.name);
            nearest_offer(n, m.function);
        }
    for (const struct equation_index_row *r = equation_index_rows;
         r->key != NULL; r++)
        if (r->kind == EQUATION_INDEX_FUNCTION) nearest_offer(n, r->name);
    SCHEMA_EACH (key, tables)
        nearest_offer(n, key->path);
}

static void offer_last_names(struct nearest *n, const struct key *const *tables)
{
    SCHEMA_EACH (key, tables)
        if (strrchr(key->path, '.') != NULL)
            nearest_offer(n, strrchr(key->path, '.') + 1);
}

/* Says what explain accepts, with the known word that is nearest to this one.
 */
static int explain_unknown(const char *word)
{
    const struct key *tables[CASE_FILE_TABLES];
    char path[SCHEMA_TEXT], hint[NEAREST_HINT];
    struct nearest n;

    case_file_tables(tables);
    nearest_init(&n, word);
    offer_paths(&n, tables);
    const char *best = nearest_best(&n);
    if (best == NULL) {
        offer_last_names(&n, tables);
        best = nearest_best(&n);
        if (best != NULL && schema_nearest(tables, best, path) != NULL)
            best = path;
    }
    fprintf(stderr,
            "winnow: %s is no case file, key, model, function or command%s\n"
            "winnow explain %s\n",
            word, nearest_hint(best, "", hint), accepted);
    return 2;
}

/* A word that names no file. */
static int explain_word(const char *word)
{
    const struct command *const command = command_named(word);
    const struct key *tables[CASE_FILE_TABLES];

    case_file_tables(tables);
    if (schema_find(tables, word) != NULL) return explain_case_key(word);
    if (models_kind(word) != NULL) return list_models(word);
    const int n = explain_models(word);
    if (equation_index_explain_function(word) + n > 0) return 0;
    if (command == NULL) return explain_unknown(word);
    printf("winnow %s %s\n  %s\n", word, command->arguments, command->what);
    return 0;
}

/* 1 if the word is meant as the name of a file, which need not be there. */
static int explain_is_file_name(const char *word)
{
    const char *const dot = strrchr(word, '.');
    struct stat file;

    return strchr(word, '/') != NULL || (dot != NULL && !strcmp(dot, ".cfg")) ||
           (stat(word, &file) == 0 && S_ISREG(file.st_mode));
}

static int explain_act(const struct command_line *l)
{
    const char *const word = l->words[0];
    int code;

    if (equation_index_is_key(word)) return equation_index_explain(word);
    if (!explain_is_file_name(word)) return explain_word(word);
    struct settings *const s =
        case_file_read(word, l->n_overrides, l->overrides, &code);
    if (s != NULL) explain_case(s);
    settings_free(s);
    return code;
}

const struct command explain_command = {
    "explain",
    accepted,
    "the equations that a case switches on, and what it leaves off; or where "
    "the equation of a key is computed, tested and explained; or what a key of "
    "a case, or a model, means; or what a function computes, or a command does",
    "s",
    1,
    1,
    explain_act};
