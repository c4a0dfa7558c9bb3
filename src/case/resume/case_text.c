/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/resume/case_text.h"

#include <libconfig.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "base/alloc.h"
#include "base/file.h"
#include "base/number.h"
#include "base/text.h"
#include "case/case_file.h"
#include "case/case_steps.h"
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
            put_value(out, config_setting_get_elem(s, (unsigned)i));
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

void case_text_each_file(const struct settings *s, const struct key *row,
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
    case_text_each_file(s, row, name, add_to_checksum, &sum);
    fprintf(out, "%s = crc32 %08lx\n", path, sum);
}

/* --- lines ---------------------------------------------------------------- */

static void case_text_put_lines(FILE *out, const struct settings *s,
                                const config_setting_t *at, const char *path)
{
    for (int i = 0; i < config_setting_length(at); i++) {
        const config_setting_t *const one =
            config_setting_get_elem(at, (unsigned)i);
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

/* --- as a case ------------------------------------------------------------ */

struct writer {
    const struct settings *settings;
    FILE *out;
    char *(*file_name)(void *of, const struct key *row, const char *name);
    void *of;
};

static void put_members(const struct writer *w, const config_setting_t *at,
                        const char *path, int depth);

static void put_group(const struct writer *w, const config_setting_t *s,
                      const char *path, int depth)
{
    fputs("{\n", w->out);
    put_members(w, s, path, depth + 1);
    fprintf(w->out, "%*s}", 4 * depth, "");
}

static void put_setting(const struct writer *w, const config_setting_t *s,
                        const char *path, int depth)
{
    const struct key *const row = settings_row(w->settings, path);

    if (config_setting_is_group(s)) {
        put_group(w, s, path, depth);
    } else if (has_groups(s)) {
        fputc('(', w->out);
        for (int i = 0; i < config_setting_length(s); i++) {
            fputs(i > 0 ? ", " : "", w->out);
            put_group(w, config_setting_get_elem(s, (unsigned)i), path, depth);
        }
        fputc(')', w->out);
    } else if (is_file(row)) {
        char *const name =
            w->file_name(w->of, row, config_setting_get_string(s));
        text_put(w->out, name, TEXT_CASE);
        free(name);
    } else {
        put_value(w->out, s);
    }
}

static void put_members(const struct writer *w, const config_setting_t *at,
                        const char *path, int depth)
{
    for (int i = 0; i < config_setting_length(at); i++) {
        const config_setting_t *const one =
            config_setting_get_elem(at, (unsigned)i);
        const char *const name = config_setting_name(one);
        char below[PATH];

        if (source_is_default(one)) continue;
        snprintf(below, sizeof below, "%s%s%s", path,
                 path[0] != '\0' ? "." : "", name);
        fprintf(w->out, "%*s%s = ", 4 * depth, "", name);
        put_setting(w, one, below, depth);
        fputs(";\n", w->out);
    }
}

void case_text_write(const struct settings *s, FILE *out,
                     char *(*file_name)(void *of, const struct key *row,
                                        const char *name),
                     void *of)
{
    const struct writer w = {s, out, file_name, of};

    put_members(&w, settings_root(s), "", 0);
}
