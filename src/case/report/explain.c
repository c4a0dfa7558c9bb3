/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/report/explain.h"

#include "case/case_file.h"
#include "case/case_materials.h"
#include "case/checks/materials_check.h"
#include "case/command.h"
#include "case/checks/model_choice.h"
#include "case/nearest.h"
#include "case/report/equation_index.h"
#include "case/report/list.h"
#include "case/schema.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

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
    return p->group == rolling ? materials_check_rolling(s)
                               : settings_has(s, p->group);
}

static void print_line(const char *source, const char *function,
                       const char *kind, const char *what)
{
    printf("  %-26s %-32s %s%s%s\n", source, function, kind,
           kind[0] != '\0' ? ": " : "", what);
}

static void print_on(const struct settings *s)
{
    struct model m;

    puts("On");
    for (const struct part *p = parts; p->group != NULL; p++)
        if (is_named(s, p)) print_line(p->source, p->function, "", p->what);
    for (const struct kind *const *k = models_kinds; *k != NULL; k++)
        for (int i = 0; (*k)->model(i, &m); i++)
            if (model_choice_is_on(s, *k, &m)) {
                char name[128];
                snprintf(name, sizeof name, "%s %s", (*k)->name, m.name);
                print_line(m.equations, m.function, name, m.what);
            }
}

static void print_off(const struct settings *s)
{
    struct model m;

    puts("Off: nothing is allocated and nothing called");
    for (const struct part *p = parts; p->group != NULL; p++)
        if (!is_named(s, p)) print_line(p->source, p->function, "", p->what);
    for (const struct kind *const *k = models_kinds; *k != NULL; k++) {
        int n = 0;

        for (int i = 0; (*k)->model(i, &m); i++)
            if (!model_choice_is_on(s, *k, &m)) {
                if (n++ == 0) printf("  %s:", (*k)->name);
                printf(" %s", m.name);
            }
        if (n > 0) putchar('\n');
    }
}

int explain_case(const struct settings *s)
{
    printf("%s\n", s->title);
    print_on(s);
    print_off(s);
    return 0;
}

/* The rows of a key of a case, and the models between which it chooses. */
static int explain_case_key(const char *key)
{
    const int code = list_keys(key);

    for (const struct kind *const *k = models_kinds; *k != NULL; k++)
        if (strcmp((*k)->key, key) == 0) list_models((*k)->name);
    return code;
}

static int is_case_key(const char *word)
{
    const struct key *tables[CASE_FILE_TABLES];

    case_file_tables(tables);
    return schema_find(tables, word) != NULL;
}

/* The models of that name, or that this function computes; how many. */
static int explain_models(const char *word)
{
    struct model m;
    int n = 0;

    for (const struct kind *const *k = models_kinds; *k != NULL; k++)
        for (int i = 0; (*k)->model(i, &m); i++) {
            if (strcmp(m.name, word) != 0 && strcmp(m.function, word) != 0)
                continue;
            printf("%s %s: chosen by %s, computed by %s\n", (*k)->name, m.name,
                   (*k)->key, m.function);
            list_model(&m);
            n++;
        }
    return n;
}

static const char accepted[] =
    "CASE [-s path.to.key=value]... | KEY | MODEL | FUNCTION | COMMAND";

static const struct command *explain_command_named(const char *word)
{
    for (const struct command *const *c = commands; *c != NULL; c++)
        if (strcmp((*c)->name, word) == 0) return *c;
    return NULL;
}

/* Offers the words that explain knows: the paths of keys, or only the last
 * names of these; commands, functions and models. */
static void offer_paths(struct nearest *n, const struct key *const *tables)
{
    struct model m;

    for (const struct command *const *c = commands; *c != NULL; c++)
        nearest_offer(n, (*c)->name);
    for (const struct kind *const *k = models_kinds; *k != NULL; k++)
        for (int i = 0; (*k)->model(i, &m); i++) {
            nearest_offer(n, m.name);
            nearest_offer(n, m.function);
        }
    equation_index_offer_functions(n);
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
    char path[SCHEMA_TEXT];
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
    fprintf(
        stderr,
        "winnow: %s is no case file, key, model, function or command%s%s%s\n"
        "winnow explain %s\n",
        word, best != NULL ? "; did you mean " : "", best != NULL ? best : "",
        best != NULL ? "?" : "", accepted);
    return 2;
}

/* A word that names no file. */
static int explain_word(const char *word)
{
    const struct command *const command = explain_command_named(word);

    if (is_case_key(word)) return explain_case_key(word);
    if (models_kind(word) != NULL) return list_models(word);
    const int n = explain_models(word);
    if (equation_index_has_function(word))
        equation_index_explain_function(word);
    else if (n == 0 && command != NULL)
        printf("winnow %s %s\n  %s\n", word, command->arguments, command->what);
    else if (n == 0)
        return explain_unknown(word);
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

    struct settings *const s = command_settings(l, &code);

    if (s != NULL) code = explain_case(s);
    settings_free(s);
    return code;
}

const struct command command_explain = {
    "explain",
    accepted,
    "the equations that a case switches on, and what it leaves off; or where "
    "the equation of a key is computed, tested and explained; or what a key of "
    "a case, or a model, means; or what a function computes, or a command does",
    "s",
    1,
    1,
    explain_act};
