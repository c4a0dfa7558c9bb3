/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/results.h"

#include "base/alloc.h"
#include "base/file.h"
#include "base/input.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- tables --------------------------------------------------------------- */

/* The names of a head line, which lasts for `length` bytes. */
static void take_names(struct results_table *t, const char *line, size_t length)
{
    const char *const end = line + length;

    t->n_columns = 1;
    for (const char *p = line; p < end; p++)
        t->n_columns += *p == ',';
    t->name = alloc_zeroed((size_t)t->n_columns, sizeof *t->name);
    for (int i = 0; i < t->n_columns; i++) {
        const char *const comma = memchr(line, ',', (size_t)(end - line));
        const char *const stop = comma != NULL ? comma : end;
        t->name[i] = strndup(line, (size_t)(stop - line));
        line = stop + 1;
    }
}

/* One row of numbers; 0 if the line is not one. */
static int take_row(struct results_table *t, const char *line)
{
    double *const row = t->value + t->n_columns * t->n_rows;

    for (int i = 0; i < t->n_columns; i++) {
        char *end;
        row[i] = strtod(line, &end);
        if (end == line || *end != (i + 1 < t->n_columns ? ',' : '\n'))
            return 0;
        line = end + 1;
    }
    t->n_rows++;
    return 1;
}

static int count_lines(const char *text)
{
    int n = 0;

    for (; (text = strchr(text, '\n')) != NULL; text++)
        n++;
    return n;
}

struct results_table *results_table_read(const char *path)
{
    const char *why;
    size_t length;
    char *const text = input_text(path, &length, &why);
    struct results_table *const t = alloc_zeroed(1, sizeof *t);
    int wrong = text == NULL;

    for (const char *line = text, *end;
         !wrong && (end = strchr(line, '\n')) != NULL; line = end + 1) {
        if (*line == '#' || *line == '\n') continue;
        if (t->name != NULL) {
            wrong = !take_row(t, line);
            continue;
        }
        take_names(t, line, (size_t)(end - line));
        t->value = alloc_doubles(t->n_columns * count_lines(text));
    }
    free(text);
    if (!wrong && t->n_rows > 0) return t;
    results_table_free(t);
    return NULL;
}

void results_table_free(struct results_table *t)
{
    if (t == NULL) return;
    for (int i = 0; i < t->n_columns; i++)
        free(t->name[i]);
    free(t->name);
    free(t->value);
    free(t);
}

int results_column(const struct results_table *t, const char *name)
{
    const size_t n = strlen(name);

    for (int i = 0; i < t->n_columns; i++)
        if (strncmp(t->name[i], name, n) == 0 &&
            strchr(" (", t->name[i][n]) != NULL)
            return i;
    return -1;
}

/* --- the summary ---------------------------------------------------------- */

/* The value of a key within braces, whose entries are lines `"key": value`
 * (summary.h); `text` stands behind the opening brace. NULL if there is none.
 */
static const char *entry(const char *text, const char *key, size_t length)
{
    int depth = 0;

    for (; *text != '\0' && depth >= 0; text++) {
        if (*text == '}') depth--;
        if (*text == '{') depth++;
        if (*text != '"') continue;
        const char *const word = text + 1;
        for (text++; *text != '\0' && *text != '"'; text++)
            if (*text == '\\' && text[1] != '\0') text++;
        if (*text == '\0') return NULL;
        if (depth == 0 && text[1] == ':' && (size_t)(text - word) == length &&
            memcmp(word, key, length) == 0)
            return text + 2 + strspn(text + 2, " ");
    }
    return NULL;
}

/* The place of a value in the text of a summary. */
static const char *value_of(const char *text, const char *path)
{
    const char *at = strchr(text, '{');

    while (at != NULL && *at == '{') {
        const size_t length = strcspn(path, ".");

        at = entry(at + 1, path, length);
        if (path[length] == '\0') return at;
        path += length + 1;
    }
    return NULL;
}

/* The value of a path in the summary of a folder as a new string, up to the end
 * of the file; NULL if it is not there. */
static char *in_summary(const char *folder, const char *path)
{
    char *const file = file_join(folder, "summary.json");
    const char *why;
    size_t length;
    char *const text = input_text(file, &length, &why);
    const char *const at = text != NULL ? value_of(text, path) : NULL;
    char *const found = at != NULL ? strdup(at) : NULL;

    free(text);
    free(file);
    return found;
}

double results_number(const char *folder, const char *path)
{
    char *const text = in_summary(folder, path), *end = text;
    const double value = text != NULL ? strtod(text, &end) : NAN;
    const int found = end != text;

    free(text);
    return found ? value : NAN;
}

/* The text up to the closing quote; what stood behind a backslash as it is, and
 * a character that is given by its number, \u000a, as that. */
static char *unquoted(const char *at)
{
    char *const text = alloc_zeroed(strlen(at) + 1, 1);

    for (size_t n = 0; *at != '\0' && *at != '"'; at++) {
        const int escaped = *at == '\\' && at[1] != '\0';
        char number[5] = "";

        at += escaped;
        if (escaped && *at == 'u' && strlen(at) > 4) {
            memcpy(number, at + 1, 4);
            at += 4;
            text[n++] = (char)strtol(number, NULL, 16);
        } else
            text[n++] = *at;
    }
    return text;
}

char *results_text(const char *folder, const char *path)
{
    char *const text = in_summary(folder, path);
    char *const found =
        text != NULL && *text == '"' ? unquoted(text + 1) : NULL;

    free(text);
    return found;
}
