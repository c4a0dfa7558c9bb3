/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/population/grain_table.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/csv.h"
#include "base/input.h"
#include "base/number.h"

static const char atoms[] = "ITEM: ATOMS";

/* The first sign that is neither a blank nor of a remark, or 0. */
int grain_table_is(const char *path)
{
    FILE *const f = input_wrong(path) == NULL ? fopen(path, "r") : NULL;
    int c = 0, remark = 0;

    if (f == NULL) return 0;
    while ((c = fgetc(f)) != EOF && (remark || isspace(c) || c == '#'))
        remark = c == '#' || (remark && c != '\n');
    fclose(f);
    return isalpha(c) || c == '"';
}

/* Of a dump the names and rows of its last snapshot; else the text itself. */
static char *table_of(char *text)
{
    char *found = NULL, *end;

    for (char *at = text; (at = strstr(at, atoms)) != NULL; at += sizeof atoms)
        found = at;
    if (found == NULL) return text;
    found += sizeof atoms - 1;
    if ((end = strstr(found, "ITEM:")) != NULL) *end = '\0';
    return found;
}

/* The columns of x, y, z and the size, and what makes the size a diameter;
 * non-zero if one is missing. */
static int find_columns(const struct csv *t, int column[4], double *factor)
{
    static const char *const sizes[] = {"d", "diameter", "radius"};
    static const char *const axes[] = {"x", "y", "z"};

    for (int k = 0; k < 3; k++)
        column[k] = csv_column(t, axes[k]);
    column[3] = -1;
    for (int k = 0; k < 3 && column[3] < 0; k++) {
        column[3] = csv_column(t, sizes[k]);
        *factor = k == 2 ? 2.0 : 1.0;
    }
    return column[0] < 0 || column[1] < 0 || column[2] < 0 || column[3] < 0;
}

static struct insertion_sphere *spheres_of(const struct csv *t,
                                           char wrong[CSV_WRONG])
{
    struct insertion_sphere *const list =
        alloc_zeroed((size_t)t->n_rows, sizeof *list);
    char names[100];
    double factor;
    int column[4];

    if (find_columns(t, column, &factor) != 0) {
        csv_names(t, names, sizeof names);
        snprintf(wrong, CSV_WRONG,
                 "expected columns x, y, z and d, diameter or radius [m]; its "
                 "columns are: %s",
                 names);
        free(list);
        return NULL;
    }
    for (int i = 0; i < t->n_rows; i++) {
        const double *const row = &t->value[(long)i * t->n_columns];
        int good = 1;
        for (int k = 0; k < 3; k++) {
            list[i].x[k] = row[column[k]];
            good &= number_is_coordinate(list[i].x[k]);
        }
        list[i].d = factor * row[column[3]];
        if (good && number_is_length(list[i].d)) continue;
        snprintf(wrong, CSV_WRONG, "row %d is no sphere", i + 1);
        free(list);
        return NULL;
    }
    return list;
}

struct insertion_sphere *grain_table_read(const char *path, long *n)
{
    const char *why = "";
    char wrong[CSV_WRONG];
    size_t length;
    struct insertion_sphere *list = NULL;
    struct csv t;
    char *const text = input_text(path, &length, &why);

    *n = 0;
    snprintf(wrong, sizeof wrong, "%s", why);
    if (text != NULL && csv_parse(&t, table_of(text), wrong) == 0) {
        list = spheres_of(&t, wrong);
        *n = list != NULL ? t.n_rows : 0;
        csv_release(&t);
    }
    free(text);
    if (list == NULL) fprintf(stderr, "winnow: %s: %s\n", path, wrong);
    return list;
}
