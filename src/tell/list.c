/* SPDX-License-Identifier: GPL-3.0-or-later */
/* list.c -- `winnow list`: what there is to choose from; and `winnow new`: a
 * shipped case to begin with. */
#include "tell/check.h"

#include <ctype.h>
#include <errno.h>
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "case/case_file.h"
#include "case/checks/checks.h"
#include "case/command.h"
#include "case/models.h"
#include "base/text.h"
#include "case/schema.h"
#include "coupling/effect.h"
#include "coupling/effects.h"
#include "record/history.h"
#include "record/recorder_part.h"

void list_kinds(void)
{
    struct model m;

    for (const struct kind *const *k = models_kinds; *k != NULL; k++) {
        printf("%-14s %s, chosen by %s:\n%-14s", (*k)->name, (*k)->what,
               (*k)->key, "");
        for (int i = 0; (*k)->model(i, &m); i++)
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
    char nearest[SCHEMA_TEXT] = "";

    if (schema_nearest(tables, name, nearest) != NULL)
        fprintf(stderr,
                "winnow: no part of a case is called %s; did you mean %s?\n",
                name, nearest);
    else
        fprintf(stderr,
                "winnow: no part of a case is called %s; winnow list keys "
                "names all keys\n",
                name);
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

    nearest_init(&n, name);
    for (const struct kind *const *k = models_kinds; *k != NULL; k++)
        nearest_offer(&n, (*k)->name);
    nearest_offer(&n, "keys");
    nearest_offer(&n, "columns");
    nearest_offer(&n, "cases");
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

    if (strcmp(name, "keys") == 0) return list_keys(NULL);
    if (strcmp(name, "columns") == 0) return list_columns();
    if (kind == NULL) return unknown_kind(name);
    printf("%s, chosen by %s\n", kind->what, kind->key);
    for (int i = 0; kind->model(i, &m); i++)
        list_model(&m);
    return 0;
}

/* The case to begin with if no other one is named. */
#define FIRST "small-bed"
static const char look_at[] = "What to look at: ";

enum { PATH_TEXT = 4096, CASE_TEXT = 1 << 16, LINE_TEXT = 200 };

/* The cases that are installed with the program, or lie beside its build, or
 * here. Non-zero if there are none. */
static int shipped_find(glob_t *found)
{
    static const char *const folders[] = {"/../share/winnow/cases", "/../cases",
                                          "./cases"};
    char program[PATH_TEXT] = "", path[2 * PATH_TEXT];

    if (readlink("/proc/self/exe", program, sizeof program - 1) < 0)
        program[0] = '\0';
    if (strrchr(program, '/') != NULL) *strrchr(program, '/') = '\0';
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++) {
        const int here = folders[i][0] == '.';

        snprintf(path, sizeof path, "%s%s/*.cfg", here ? "" : program,
                 folders[i]);
        if (glob(path, 0, NULL, found) == 0) return 0;
    }
    return 1;
}

static int none(void)
{
    fprintf(stderr, "winnow: no cases in ../share/winnow/cases or ../cases "
                    "beside the program, nor in ./cases\n");
    return 4;
}

/* "small-bed" of "there/small-bed.cfg". */
static void shipped_name_of(const char *path, char name[LINE_TEXT])
{
    const char *const slash = strrchr(path, '/');

    snprintf(name, LINE_TEXT, "%s", slash != NULL ? slash + 1 : path);
    if (strrchr(name, '.') != NULL) *strrchr(name, '.') = '\0';
}

/* The text of a file, a string; -1 after a message. */
static int shipped_read_text(const char *path, char text[CASE_TEXT])
{
    FILE *const f = fopen(path, "r");
    size_t n = 0;

    if (f != NULL) n = fread(text, 1, CASE_TEXT - 1, f);
    text[n] = '\0';
    if (f == NULL || ferror(f) || !feof(f)) {
        fprintf(stderr, "winnow: %s: cannot read: %s\n", path,
                errno != 0 ? strerror(errno) : "too long");
        n = 0;
    }
    if (f != NULL) fclose(f);
    return n > 0 ? 0 : -1;
}

/* What the comment at the head says to look at, to the end of a clause. */
static void purpose(const char *text, char line[LINE_TEXT])
{
    const char *c = strstr(text, look_at);
    size_t n = 0;

    if (c != NULL) c += strlen(look_at);
    for (; c != NULL && *c != '\0' && n + 1 < LINE_TEXT; c++) {
        if (strchr(".;", *c) != NULL && isspace((unsigned char)c[1]) &&
            !isdigit((unsigned char)c[2])) /* "Fig. 3" */
            break;
        if (*c == '\n' && strncmp(c, "\n# ", 3) != 0) break;
        line[n++] = iscntrl((unsigned char)*c) ? ' ' : *c;
        if (*c == '\n') c += 2;
    }
    line[n] = '\0';
}

static void shipped_print_case(const char *path, const struct settings *s,
                               const char *text)
{
    const struct case_scales k = case_scales_of(s);
    char name[LINE_TEXT], line[LINE_TEXT];

    shipped_name_of(path, name);
    purpose(text, line);
    printf("%-22s %6d cells %6d particles  %s%s%s\n", name, k.cells,
           k.particles, s->title, line[0] != '\0' ? ". Look at: " : "", line);
}

static int shipped_list(void)
{
    char text[CASE_TEXT];
    glob_t found;
    int code = 0;

    if (shipped_find(&found) != 0) return none();
    for (size_t i = 0; i < found.gl_pathc && code == 0; i++) {
        const char *const path = found.gl_pathv[i];
        struct settings *const s = case_file_read(path, 0, NULL, &code);

        if (s != NULL && shipped_read_text(path, text) == 0)
            shipped_print_case(path, s, text);
        settings_free(s);
    }
    globfree(&found);
    return code;
}

/* The path of the shipped case of that name. The exit code. */
static int find_named(const char *name, char path[PATH_TEXT])
{
    char other[LINE_TEXT];
    struct nearest n;
    glob_t found;

    if (shipped_find(&found) != 0) return none();
    nearest_init(&n, name);
    path[0] = '\0';
    for (size_t i = 0; i < found.gl_pathc; i++) {
        shipped_name_of(found.gl_pathv[i], other);
        nearest_offer(&n, other);
        if (strcmp(name, other) == 0)
            snprintf(path, PATH_TEXT, "%s", found.gl_pathv[i]);
    }
    globfree(&found);
    if (path[0] != '\0') return 0;
    fprintf(stderr, "winnow: no case %s; ", name);
    if (nearest_best(&n) != NULL)
        fprintf(stderr, "did you mean %s?\n", nearest_best(&n));
    else
        fprintf(stderr, "winnow list cases names them all\n");
    return 2;
}

/* 1 if the case names, in quotes and not in a comment, a file beside it; its
 * name is then `other`. */
static int names_a_file(const char *path, const char *text,
                        char other[LINE_TEXT])
{
    const char *const slash = strrchr(path, '/');
    char beside[PATH_TEXT + LINE_TEXT];

    for (const char *c = text; *c != '\0'; c++) {
        if (*c == '#') c += strcspn(c, "\n") - 1;
        if (*c != '"') continue;
        const int n = (int)strcspn(++c, "\"\n");

        snprintf(other, LINE_TEXT, "%.*s", n, c);
        snprintf(beside, sizeof beside, "%.*s/%s", (int)(slash - path), path,
                 other);
        if (n > 0 && access(beside, F_OK) == 0) return 1;
        c += n;
    }
    return 0;
}

/* Writes a file that must not be there. The exit code. */
static int write_new(const char *path, const char *text)
{
    FILE *const f = fopen(path, "wx");
    int wrong = f == NULL;

    if (f != NULL) wrong = fputs(text, f) < 0;
    if (f != NULL && fclose(f) != 0) wrong = 1;
    if (!wrong) return 0;
    fprintf(stderr, "winnow: %s: cannot make it: %s\n", path, strerror(errno));
    return 4;
}

static int shipped_act(const struct command_line *l)
{
    const char *const name = l->words[0];
    const char *const from = l->n_words > 1 ? l->words[1] : FIRST;
    const char *const end = strrchr(name, '.');
    char text[CASE_TEXT], path[PATH_TEXT], other[LINE_TEXT], to[PATH_TEXT];
    int code = find_named(from, path);

    if (code != 0) return code;
    if (shipped_read_text(path, text) != 0) return 4;
    if (names_a_file(path, text, other)) {
        fprintf(stderr, "winnow: %s needs %s beside it: copy both from %.*s\n",
                from, other, (int)(strrchr(path, '/') - path), path);
        return 2;
    }
    snprintf(to, sizeof to, "%s%s", name,
             end != NULL && strcmp(end, ".cfg") == 0 ? "" : ".cfg");
    if ((code = write_new(to, text)) != 0) return code;
    printf("%s: as %s\n  winnow check %s\n  winnow run %s\n", to, from, to, to);
    return 0;
}

const struct command list_new_command = {
    "new",
    "NAME [FROM]",
    "NAME.cfg, a case to begin with: a small bed, or a copy of FROM, one of "
    "`winnow list cases`",
    "",
    1,
    2,
    shipped_act};

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
        return shipped_list();
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
