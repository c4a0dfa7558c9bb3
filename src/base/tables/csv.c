/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/tables/csv.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/tables/input.h"

static int is_gap(char c)
{
    return c == ',' || c == ';' || c == ' ' || c == '\t' || c == '\r';
}

static const char *skip_gap(const char *at)
{
    while (is_gap(*at))
        at++;
    return at;
}

/* The name at `at`, which ends before a unit or a remark in brackets; returns
 * what follows them. */
static const char *read_name(const char *at, char name[CSV_NAME])
{
    int n = 0;

    for (; *at != '\0' && *at != '[' && *at != '(' && !is_gap(*at); at++)
        if (*at != '"' && n < CSV_NAME - 1) name[n++] = *at;
    name[n] = '\0';
    while (*at == ' ' || *at == '[' || *at == '(') {
        if (*at != ' ') at += strcspn(at, *at == '[' ? "]" : ")");
        at += *at != '\0';
    }
    return at + (*at == '"');
}

static int read_names(struct csv *t, const char *line, char wrong[CSV_WRONG])
{
    for (const char *at = skip_gap(line); *at != '\0'; at = skip_gap(at)) {
        if (t->n_columns == CSV_COLUMNS) {
            snprintf(wrong, CSV_WRONG, "it has more than %d columns",
                     CSV_COLUMNS);
            return 1;
        }
        at = read_name(at, t->name[t->n_columns++]);
    }
    return 0;
}

static int read_row(struct csv *t, const char *line, int number,
                    char wrong[CSV_WRONG])
{
    const char *at = skip_gap(line);

    for (int k = 0; k < t->n_columns; k++) {
        char *end;
        const double x = strtod(at, &end);
        if (end == at || !isfinite(x)) {
            snprintf(wrong, CSV_WRONG,
                     "line %d: expected %d numbers, found \"%.20s\" as number "
                     "%d",
                     number, t->n_columns, at, k + 1);
            return 1;
        }
        t->value[(long)t->n_rows * t->n_columns + k] = x;
        at = skip_gap(end);
    }
    t->n_rows++;
    if (*at == '\0') return 0;
    snprintf(wrong, CSV_WRONG, "line %d: more than %d numbers", number,
             t->n_columns);
    return 1;
}

/* Ends the line at `at`; returns the next one, or NULL. */
static char *cut(char *at)
{
    char *const end = strchr(at, '\n');

    if (end == NULL) return NULL;
    *end = '\0';
    return end + 1;
}

static int read_lines(struct csv *t, char *text, char wrong[CSV_WRONG])
{
    int number = 0, failed = 0;

    for (char *at = text, *next; at != NULL && !failed; at = next) {
        next = cut(at);
        number++;
        if (*skip_gap(at) == '\0' || *at == '#') continue;
        failed = t->n_columns == 0 ? read_names(t, at, wrong)
                                   : read_row(t, at, number, wrong);
    }
    if (failed || t->n_rows > 0) return failed;
    snprintf(wrong, CSV_WRONG, "it has no row of numbers");
    return 1;
}

/* No more numbers than half the bytes of the text. */
int csv_parse(struct csv *t, char *text, char wrong[CSV_WRONG])
{
    *t = (struct csv){.n_columns = 0};
    if (strncmp(text, CSV_UTF_8, sizeof CSV_UTF_8 - 1) == 0)
        text += sizeof CSV_UTF_8 - 1;
    t->value =
        alloc_zeroed(strlen(text) / 2 + CSV_COLUMNS + 1, sizeof *t->value);
    const int failed = read_lines(t, text, wrong);
    if (failed) csv_release(t);
    return failed;
}

int csv_read(struct csv *t, const char *path, char wrong[CSV_WRONG])
{
    const char *why = "";
    size_t length;
    char *const text = input_text(path, &length, &why);

    *t = (struct csv){.n_columns = 0};
    if (text == NULL) {
        snprintf(wrong, CSV_WRONG, "%s", why);
        return 1;
    }
    const int failed = csv_parse(t, text, wrong);
    free(text);
    return failed;
}

void csv_release(struct csv *t)
{
    free(t->value);
    t->value = NULL;
}

int csv_column(const struct csv *t, const char *name)
{
    for (int k = 0; k < t->n_columns; k++)
        if (strcmp(t->name[k], name) == 0) return k;
    return -1;
}

void csv_names(const struct csv *t, char *text, int room)
{
    int used = 0;

    text[0] = '\0';
    for (int k = 0; k < t->n_columns && used < room; k++)
        used += snprintf(text + used, (size_t)(room - used), "%s%s",
                         k > 0 ? " " : "", t->name[k]);
}
