/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/results.h"

#include "base/alloc.h"
#include "base/tables/input.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char blanks[] = " \t\r";

/* The names of a head line, which lasts for `length` bytes. */
static void results_take_names(struct results_table *t, const char *line,
                               size_t length)
{
    const char *const end = line + length - (line[length - 1] == '\r');

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

/* One row of numbers, nan where a field is empty; 0 if the line is not one. */
static int take_row(struct results_table *t, const char *line)
{
    double *const row = t->value + t->n_columns * t->n_rows;

    for (int i = 0; i < t->n_columns; i++) {
        const char *const ends = i + 1 < t->n_columns ? "," : "\n";
        char *end;

        line += strspn(line, blanks);
        row[i] = NAN;
        if (*line != '\0' && strchr(",\n", *line) == NULL) {
            row[i] = strtod(line, &end);
            if (end == line) return 0;
            line = end + strspn(end, blanks);
        }
        if (*line != *ends && !(*line == '\0' && *ends == '\n')) return 0;
        line++;
    }
    t->n_rows++;
    return 1;
}

static int count_lines(const char *text)
{
    int n = 1; /* the last may have no end */

    for (; (text = strchr(text, '\n')) != NULL; text++)
        n++;
    return n;
}

/* Takes the head and the rows of a text; the number of the first line that is
 * none of them, or 0. */
static int take_lines(struct results_table *t, const char *text)
{
    const int lines = count_lines(text);

    for (int line = 1; line <= lines; line++) {
        const size_t length = strcspn(text, "\n");
        const char c = text[strspn(text, blanks)];

        if (c != '#' && c != '\n' && c != '\0' && t->name == NULL) {
            results_take_names(t, text, length);
            t->value = alloc_doubles(t->n_columns * lines);
        } else if (c != '#' && c != '\n' && c != '\0' && !take_row(t, text))
            return line;
        text += length + 1;
    }
    return 0;
}

struct results_table *results_table_read(const char *path, int *wrong)
{
    const char *why;
    size_t length;
    char *const text = input_text(path, &length, &why);
    struct results_table *const t = alloc_zeroed(1, sizeof *t);
    char *const last = text != NULL ? strrchr(text, '\n') : NULL;

    if (last != NULL && wrong == NULL) last[1] = '\0';
    const int line = text != NULL ? take_lines(t, text) : 0;
    if (wrong != NULL) *wrong = text == NULL ? -1 : line;
    free(text);
    if (line == 0 && t->n_rows > 0) return t;
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
