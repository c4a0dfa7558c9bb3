/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/resume/resume.h"

#include <libconfig.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "base/alloc.h"
#include "base/file.h"
#include "base/number.h"
#include "base/text.h"
#include "case/case_file.h"
#include "case/schema.h"
#include "case/source.h"
#include "mesh/poly/poly.h"

enum { PATH = 512 };

/* --- values --------------------------------------------------------------- */

/* A real number keeps its point, or libconfig would read a whole one. */
static void put_real(FILE *out, double x)
{
    char text[NUMBER_LENGTH];

    fputs(number_text(x, text), out);
    if (strpbrk(text, ".en") == NULL) fputs(".0", out);
}

/* A value on one line, as a case would write it. */
static void put_value(FILE *out, const config_setting_t *s)
{
    const int type = config_setting_type(s);
    const char *const ends = type == CONFIG_TYPE_ARRAY ? "[]" : "()";

    if (type == CONFIG_TYPE_STRING)
        text_put(out, config_setting_get_string(s), TEXT_CASE);
    else if (type == CONFIG_TYPE_BOOL)
        fputs(config_setting_get_bool(s) ? "true" : "false", out);
    else if (type == CONFIG_TYPE_FLOAT)
        put_real(out, config_setting_get_float(s));
    else if (type == CONFIG_TYPE_INT)
        fprintf(out, "%d", config_setting_get_int(s));
    else if (type == CONFIG_TYPE_INT64)
        fprintf(out, "%lldL", config_setting_get_int64(s));
    else {
        fputc(ends[0], out);
        for (int i = 0; i < config_setting_length(s); i++) {
            fputs(i > 0 ? ", " : "", out);
            put_value(out, source_element(s, i));
        }
        fputc(ends[1], out);
    }
}

/* A list of groups, of which each is written by itself. */
static int has_groups(const config_setting_t *s)
{
    return config_setting_is_group(s) ||
           (config_setting_is_list(s) && config_setting_length(s) > 0 &&
            config_setting_is_group(config_setting_get_elem(s, 0)));
}

/* --- files that are named ------------------------------------------------- */

static int is_file(const struct key *row)
{
    return row != NULL && row->type == KEY_FILE;
}

/* Calls each(of, file) for a file that a key names: for the folder of a mesh
 * for each of its files, packed or not, in a fixed order. */
static void each_file(const struct settings *s, const struct key *row,
                      const char *name,
                      void (*each)(void *of, const struct input *file),
                      void *of)
{
    static const char *const parts[] = {"points", "faces", "owner", "neighbour",
                                        "boundary"};
    char dir[SETTINGS_PATH], folder[POLY_FOLDER], path[POLY_FOLDER + 16];

    if (!(row->mark & KEY_FOLDER)) {
        each(of, settings_input(s, name));
        return;
    }
    settings_beside(s, name, dir, sizeof dir);
    poly_folder(dir, folder);
    for (int i = 0; i < 10; i++) {
        snprintf(path, sizeof path, "%s/%s%s", folder, parts[i / 2],
                 i % 2 ? ".gz" : "");
        const struct input *const in = input_kept(settings_files(s), path);
        if (in->text != NULL) each(of, in);
    }
}

static void add_to_checksum(void *of, const struct input *in)
{
    unsigned long *const sum = of;

    if (in->text != NULL)
        *sum = crc32_z(*sum, (unsigned char *)in->text, in->length);
}

static void put_contents(FILE *out, const struct settings *s, const char *path,
                         const struct key *row, const char *name)
{
    unsigned long sum = 0;

    if (row->mark & KEY_MADE_BY_RUN) return;
    each_file(s, row, name, add_to_checksum, &sum);
    fprintf(out, "%s = crc32 %08lx\n", path, sum);
}

/* --- lines ---------------------------------------------------------------- */

static void case_text_put_lines(FILE *out, const struct settings *s,
                                const config_setting_t *at, const char *path)
{
    for (int i = 0; i < config_setting_length(at); i++) {
        const config_setting_t *const one = source_element(at, i);
        const char *const name = config_setting_name(one);
        char below[PATH], number[16];

        snprintf(number, sizeof number, "%d", i);
        snprintf(below, sizeof below, "%s%s%s", path,
                 path[0] != '\0' ? "." : "", name != NULL ? name : number);
        const struct key *const row = settings_row(s, below);
        if (has_groups(one)) {
            case_text_put_lines(out, s, one, below);
        } else if (is_file(row)) {
            put_contents(out, s, below, row, config_setting_get_string(one));
        } else {
            fprintf(out, "%s = ", below);
            put_value(out, one);
            fputc('\n', out);
        }
    }
}

static int case_text_by_text(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

/* The lines in alphabetical order, because a case may give its keys in any. */
static char *sorted(char *text)
{
    size_t n = 0, at = 0;
    const size_t length = strlen(text);
    char *const result = alloc_zeroed(length + 1, 1);

    for (size_t i = 0; i < length; i++)
        n += text[i] == '\n';
    char **const line = alloc_zeroed(n, sizeof *line);
    n = 0;
    for (char *next = strtok(text, "\n"); next; next = strtok(NULL, "\n"))
        line[n++] = next;
    qsort(line, n, sizeof *line, case_text_by_text);
    for (size_t i = 0; i < n; i++)
        at += (size_t)sprintf(result + at, "%s\n", line[i]);
    free(line);
    free(text);
    return result;
}

char *case_text_lines(const struct settings *s)
{
    char *text = NULL;
    size_t length = 0;
    FILE *const out = open_memstream(&text, &length);

    case_text_put_lines(out, s, settings_root(s), "");
    fputs(CASE_TEXT_STEP " = ", out);
    put_real(out, case_steps_length(s));
    fputc('\n', out);
    fclose(out);
    return sorted(text);
}

/* --- comparison ----------------------------------------------------------- */

int case_text_is(const char *line, enum key_mark mark)
{
    const struct key *tables[CASE_FILE_TABLES];

    case_file_tables(tables);
    SCHEMA_EACH (row, tables) {
        const size_t n = strlen(row->path);
        if (row->mark & mark && strncmp(line, row->path, n) == 0 &&
            strchr(" .", line[n]) != NULL)
            return 1;
    }
    return 0;
}

static size_t line_length(const char *line)
{
    return strcspn(line, "\n");
}

/* The line of the same key, or NULL. */
static const char *case_text_line_of(const char *lines, const char *key,
                                     size_t length)
{
    for (; *lines != '\0'; lines += line_length(lines) + 1)
        if (strncmp(lines, key, length) == 0 &&
            strncmp(lines + length, " = ", 3) == 0)
            return lines;
    return NULL;
}

char *case_text_value(const char *lines, const char *key)
{
    const char *const line = case_text_line_of(lines, key, strlen(key));

    if (line == NULL) return NULL;
    return strndup(line + strlen(key) + 3, line_length(line) - strlen(key) - 3);
}

/* The first line of `a` that is not in `b`. */
static const char *first_missing(const char *a, const char *b)
{
    for (; *a != '\0'; a += line_length(a) + 1) {
        const size_t key = strcspn(a, " ");
        const char *const other = case_text_line_of(b, a, key);
        const size_t n = line_length(a) + 1;

        if ((other == NULL || strncmp(a, other, n) != 0) &&
            !case_text_is(a, KEY_MAY_CHANGE))
            return a;
    }
    return NULL;
}

int case_text_differs(const char *was, const char *is, const char *path)
{
    const char *line = first_missing(is, was);

    if (line == NULL) line = first_missing(was, is);
    if (line == NULL || path == NULL) return line != NULL;
    const int n = (int)strcspn(line, " ");
    const char *const a = case_text_line_of(was, line, (size_t)n);
    const char *const b = case_text_line_of(is, line, (size_t)n);

    fprintf(stderr,
            "winnow: %.*s is %.*s in this case, and %.*s in that of %s; to "
            "resume a run only the title, output.end, every, history and "
            "checkpoint may change\n",
            n, line, b != NULL ? (int)line_length(b) - n - 3 : 7,
            b != NULL ? b + n + 3 : "not set",
            a != NULL ? (int)line_length(a) - n - 3 : 7,
            a != NULL ? a + n + 3 : "not set", path);
    return 1;
}

/* --- in the folder of its run: reading ------------------------------------ */

/* A file that the case names. */
struct named_file {
    const struct input *in; /* borrowed from the settings */
    char *name;             /* "case/NAME", in the folder of the run */
};

struct case_copy {
    const struct settings *settings;
    char *case_text; /* of case.cfg */
    FILE *out;       /* while that is written */
    int n, capacity;
    struct named_file *file;
};

static int has_name(const struct case_copy *c, const char *name)
{
    for (int i = 0; i < c->n; i++)
        if (strcmp(c->file[i].name, name) == 0) return 1;
    return 0;
}

/* Two files of one name from two folders: the second gets a number. */
static char *unused_name(const struct case_copy *c, const char *path)
{
    const char *const slash = strrchr(path, '/');
    const char *const last = slash != NULL ? slash + 1 : path;
    char *const name = alloc_zeroed(strlen(last) + 24, 1);

    sprintf(name, "case/%s", last);
    for (int k = 2; has_name(c, name); k++)
        sprintf(name, "case/%d-%s", k, last);
    return name;
}

static void add_file(void *of, const struct input *in)
{
    struct case_copy *const c = of;

    for (int i = 0; i < c->n; i++)
        if (c->file[i].in == in) return;
    c->file = alloc_room(c->file, c->n, &c->capacity, sizeof *c->file);
    char *const name = unused_name(c, in->path);
    c->file[c->n++] = (struct named_file){in, name};
}

/* The name of a file in case.cfg. */
static char *named(struct case_copy *c, const struct key *row, const char *name)
{
    int i = 0;

    each_file(c->settings, row, name, add_file, c);
    if (row->mark & KEY_FOLDER) return strdup("case");
    while (c->file[i].in != settings_input(c->settings, name))
        i++;
    return strdup(c->file[i].name);
}

/* --- as a case: no defaults ----------------------------------------------- */

static void put_members(struct case_copy *c, const config_setting_t *at,
                        const char *path, int depth);

static void put_group(struct case_copy *c, const config_setting_t *s,
                      const char *path, int depth)
{
    fputs("{\n", c->out);
    put_members(c, s, path, depth + 1);
    fprintf(c->out, "%*s}", 4 * depth, "");
}

static void put_setting(struct case_copy *c, const config_setting_t *s,
                        const char *path, int depth)
{
    const struct key *const row = settings_row(c->settings, path);

    if (config_setting_is_group(s)) {
        put_group(c, s, path, depth);
    } else if (has_groups(s)) {
        fputc('(', c->out);
        for (int i = 0; i < config_setting_length(s); i++) {
            fputs(i > 0 ? ", " : "", c->out);
            put_group(c, source_element(s, i), path, depth);
        }
        fputc(')', c->out);
    } else if (is_file(row)) {
        char *const name = named(c, row, config_setting_get_string(s));
        text_put(c->out, name, TEXT_CASE);
        free(name);
    } else {
        put_value(c->out, s);
    }
}

static void put_members(struct case_copy *c, const config_setting_t *at,
                        const char *path, int depth)
{
    for (int i = 0; i < config_setting_length(at); i++) {
        const config_setting_t *const one = source_element(at, i);
        const char *const name = config_setting_name(one);
        char below[SOURCE_TEXT];

        if (source_is_default(one)) continue;
        source_path(below, path, one);
        fprintf(c->out, "%*s%s = ", 4 * depth, "", name);
        put_setting(c, one, below, depth);
        fputs(";\n", c->out);
    }
}

struct case_copy *case_text_copy(const struct settings *s,
                                 const struct run_options *o)
{
    struct case_copy *const c = alloc_zeroed(1, sizeof *c);
    size_t length;
    c->out = open_memstream(&c->case_text, &length);

    c->settings = s;
    fprintf(c->out,
            "# The case of this run, by winnow " VERSION_TEXT
            ", from %s.\n# `winnow run case.cfg` repeats it.",
            s->file);
    for (int i = 0; i < o->n_overrides; i++)
        fprintf(c->out, "%s -s %s", i == 0 ? " It was run with" : "",
                o->overrides[i]);
    fputs("\n\n", c->out);
    put_members(c, settings_root(s), "", 0);
    fclose(c->out);
    return c;
}

void case_text_free_copy(struct case_copy *c)
{
    if (c == NULL) return;
    for (int i = 0; i < c->n; i++)
        free(c->file[i].name);
    free(c->file);
    free(c->case_text);
    free(c);
}

/* --- and writing ---------------------------------------------------------- */

static int write_text(struct folder *folder, const char *name, const char *text,
                      size_t length)
{
    char *const path = folder_file(folder, name);
    const int failed = path == NULL || file_write(path, text, length) != 0;

    free(path);
    return failed;
}

/* The file of a bed that the run itself has written is not copied. The case
 * goes first, for it tells which files in its folder are of the run. */
int case_text_write_copy(struct case_copy *c, struct folder *folder)
{
    int failed = write_text(folder, "case.cfg", c->case_text,
                            strlen(c->case_text)) != 0 ||
                 (c->n > 0 && folder_make(folder, "case") != 0);

    for (int i = 0; i < c->n && !failed; i++) {
        const struct input *const in =
            input_kept(settings_files(c->settings), c->file[i].in->path);
        if (in->text != NULL)
            failed = write_text(folder, c->file[i].name, in->text, in->length);
    }
    return failed;
}

/* The case without the remark above it. */
static const char *body(const char *text)
{
    const char *const blank = strstr(text, "\n\n");
    return blank != NULL ? blank : text;
}

/* 1 if the file is there, and says the same if there is a text. */
static int is_there(const char *path, const char *text)
{
    const char *why;
    size_t length;
    char *const old = input_text(path, &length, &why);
    const int same =
        old != NULL && (text == NULL || strcmp(body(old), body(text)) == 0);

    free(old);
    return same;
}

int case_text_restore_copy(struct case_copy *c, const char *dir)
{
    char *const of_case = file_join(dir, "case.cfg");
    int failed = 0;

    for (int i = 0; i < c->n && !failed; i++) {
        char *const path = file_join(dir, c->file[i].name);
        const struct input *const in = c->file[i].in;
        if (in->text != NULL && !is_there(path, NULL))
            failed = file_write(path, in->text, in->length);
        free(path);
    }
    if (!failed && !is_there(of_case, c->case_text))
        failed = file_write(of_case, c->case_text, strlen(c->case_text));
    free(of_case);
    return failed;
}
