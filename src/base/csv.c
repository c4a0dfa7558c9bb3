/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/csv.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/alloc.h"
#include "base/file.h"

static int csv_is_gap(char c)
{
    return c == ',' || c == ';' || c == ' ' || c == '\t' || c == '\r';
}

static const char *skip_gap(const char *at)
{
    while (csv_is_gap(*at))
        at++;
    return at;
}

/* The name at `at`, and what stands in the first brackets after it; returns
 * what follows them. */
static const char *read_name(const char *at, char name[CSV_NAME],
                             char unit[CSV_NAME])
{
    int n = 0;

    for (; *at != '\0' && *at != '[' && *at != '(' && !csv_is_gap(*at); at++)
        if (*at != '"' && n < CSV_NAME - 1) name[n++] = *at;
    name[n] = unit[0] = '\0';
    while (*at == ' ' || *at == '[' || *at == '(') {
        if (*at != ' ') {
            const int length = (int)strcspn(at, *at == '[' ? "]" : ")");
            if (unit[0] == '\0')
                snprintf(unit, CSV_NAME, "%.*s", length - 1, at + 1);
            at += length;
        }
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
        at = read_name(at, t->name[t->n_columns], t->unit[t->n_columns]);
        t->n_columns++;
    }
    return 0;
}

/* How many of the words of a row or a remark begin with the axes and sizes of
 * spheres. */
static int known_names(const struct csv *t, int n)
{
    static const char *const known[] = {"x", "y",        "z",     "d",
                                        "r", "diameter", "radius"};
    int found = 0;

    for (int k = 0; k < n && k < t->n_columns; k++)
        for (size_t i = 0; i < sizeof known / sizeof *known; i++)
            found += strcasecmp(t->name[k], known[i]) == 0;
    return found;
}

/* Takes the names of a row of n numbers from the remark before it, if it states
 * them: "# x y z radius", or YADE's "#format x_y_z_r". */
static void believe(struct csv *t, const char *remark, int n)
{
    char text[CSV_WRONG], none[CSV_WRONG];
    struct csv said = {.n_columns = 0};

    remark += strspn(remark, "# \t");
    const int is_format = strncmp(remark, "format ", 7) == 0;
    snprintf(text, sizeof text, "%s", remark + (is_format ? 7 : 0));
    for (char *at = text; is_format && *at != '\0'; at++)
        if (*at == '_') *at = ' ';
    const int is_prose = read_names(&said, text, none) != 0 ||
                         known_names(&said, n) < (said.n_columns == n ? 1 : 3);
    if (is_prose || said.n_columns < n) return;
    said.n_columns = n;
    said.value = t->value;
    *t = said;
}

/* The unit of a length in a remark that is not SI, as in "lengths in mm", or
 * NULL; "beads of 2 mm" is none. */
static const char *foreign_unit(char *remark)
{
    static const char *const units[] = {"mm",          "cm",          "um",
                                        "\xc2\xb5m",   "\xce\xbcm",   "nm",
                                        "millimetres", "millimeters", "inches"};
    int after_number = 0;

    for (char *word = strtok(remark, " \t\r,;:.()[]=\"#/-"); word != NULL;
         word = strtok(NULL, " \t\r,;:.()[]=\"#/-")) {
        for (size_t i = 0; i < sizeof units / sizeof *units; i++)
            if (!after_number && strcmp(word, units[i]) == 0) return units[i];
        after_number = isdigit((unsigned char)word[0]);
    }
    return NULL;
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
static char *csv_cut(char *at)
{
    char *const end = strchr(at, '\n');

    if (end == NULL) return NULL;
    *end = '\0';
    return end + 1;
}

static int csv_words_of(const char *line)
{
    int n = 0;

    for (line = skip_gap(line); *line != '\0'; line = skip_gap(line), n++)
        while (*line != '\0' && !csv_is_gap(*line))
            line++;
    return n;
}

/* A list of numbers alone has the names of the remark before it, or else
 * `names`. Non-zero if the line is its first row. */
static int is_first_row(struct csv *t, const char *line, const char *remark,
                        const char *names)
{
    char none[CSV_WRONG];
    const char c = *skip_gap(line);

    if (names == NULL || isalpha((unsigned char)c) || c == '"') return 0;
    if (remark != NULL) believe(t, remark, csv_words_of(line));
    return t->n_columns > 0 || read_names(t, names, none) == 0;
}

static int read_lines(struct csv *t, char *text, const char *names,
                      char wrong[CSV_WRONG])
{
    char *remark = NULL;
    int number = 0, failed = 0;

    for (char *at = text, *next; at != NULL && !failed; at = next) {
        char copy[CSV_WRONG];
        next = csv_cut(at);
        number++;
        if (*skip_gap(at) == '\0') continue;
        if (*skip_gap(at) != '#') {
            failed = t->n_columns == 0 && !is_first_row(t, at, remark, names)
                         ? read_names(t, at, wrong)
                         : read_row(t, at, number, wrong);
            continue;
        }
        if (t->n_rows > 0) continue;
        if (csv_words_of(at) > 1) remark = at;
        snprintf(copy, sizeof copy, "%s", at);
        const char *const unit = foreign_unit(copy);
        failed = unit != NULL;
        if (failed)
            snprintf(wrong, CSV_WRONG,
                     "line %d speaks of %s; expected lengths in m", number,
                     unit);
    }
    if (failed || t->n_rows > 0) return failed;
    snprintf(wrong, CSV_WRONG, "it has no row of numbers");
    return 1;
}

/* No more numbers than half the bytes of the text. */
int csv_parse(struct csv *t, char *text, const char *names,
              char wrong[CSV_WRONG])
{
    *t = (struct csv){.n_columns = 0};
    if (strncmp(text, CSV_UTF_8, sizeof CSV_UTF_8 - 1) == 0)
        text += sizeof CSV_UTF_8 - 1;
    t->value =
        alloc_zeroed(strlen(text) / 2 + CSV_COLUMNS + 1, sizeof *t->value);
    const int failed = read_lines(t, text, names, wrong);
    if (failed) csv_release(t);
    return failed;
}

int csv_read(struct csv *t, const struct input *in, char wrong[CSV_WRONG])
{
    *t = (struct csv){.n_columns = 0};
    if (in->text == NULL) {
        snprintf(wrong, CSV_WRONG, "%s", in->why);
        return 1;
    }
    char *const text = strdup(in->text);
    const int failed = csv_parse(t, text, NULL, wrong);
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

int csv_check_unit(const struct csv *t, int column, const char *unit,
                   char wrong[CSV_WRONG])
{
    if (t->unit[column][0] == '\0' || strcmp(t->unit[column], unit) == 0)
        return 0;
    snprintf(wrong, CSV_WRONG, "its column %s is in [%s]; expected [%s]",
             t->name[column], t->unit[column], unit);
    return 1;
}

void csv_names(const struct csv *t, char *text, int room)
{
    int used = 0;

    text[0] = '\0';
    for (int k = 0; k < t->n_columns && used < room; k++)
        used += snprintf(text + used, (size_t)(room - used), "%s%s",
                         k > 0 ? " " : "", t->name[k]);
}
