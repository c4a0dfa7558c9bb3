/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/report/explain.h"

#include "case/case_file.h"
#include "case/case_materials.h"
#include "case/checks/materials_check.h"
#include "case/command.h"
#include "case/checks/model_choice.h"
#include "case/report/equation_index.h"
#include "case/report/list.h"
#include "case/schema.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

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
    for (const struct kind *const *k = kinds; *k != NULL; k++)
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
    for (const struct kind *const *k = kinds; *k != NULL; k++) {
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
    printf("%s\n", settings_text(s, "title"));
    print_on(s);
    print_off(s);
    return 0;
}

/* The rows of a key of a case, and the models between which it chooses. */
static int explain_case_key(const char *key)
{
    const int code = list_keys(key);

    for (const struct kind *const *k = kinds; *k != NULL; k++)
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

    for (const struct kind *const *k = kinds; *k != NULL; k++)
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

/* A word is the key of an equation, a key of a case, a model, a function, or
 * else the file of a case. */
static int act(const struct command_line *l)
{
    const char *const word = l->words[0];
    int code;

    if (equation_index_is_key(word)) return equation_index_explain(word);
    if (access(word, F_OK) != 0) {
        if (is_case_key(word)) return explain_case_key(word);
        const int n = explain_models(word);
        if (n > 0 && !equation_index_has_function(word)) return 0;
        if (equation_index_is_function(word))
            return equation_index_explain_function(word);
    }

    struct settings *const s = command_settings(l, &code);

    if (s != NULL) code = explain_case(s);
    settings_free(s);
    return code;
}

const struct command command_explain = {
    "explain",
    "CASE [-s path.to.key=value]... | KEY | MODEL | FUNCTION",
    "the equations that a case switches on, and what it leaves off; or where "
    "the equation of a key is computed, tested and explained; or what a key of "
    "a case, or a model, means; or what a function computes",
    "s",
    1,
    1,
    act};
