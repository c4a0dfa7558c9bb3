/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/population/insertion.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/csv.h"
#include "base/file.h"
#include "base/number.h"
#include "base/text.h"

static const char atoms[] = "ITEM: ATOMS";

/* The line is "9240 atoms", as in the head of a data file; fills their number.
 */
static int counts_atoms(const char *line, long *n)
{
    char word[8];
    long count;

    if (sscanf(line, "%ld %7s", &count, word) != 2 ||
        strcmp(word, "atoms") != 0)
        return 0;
    *n = count;
    return 1;
}

/* The line in `text` that begins with this word, or NULL. */
static char *grain_table_line_of(char *text, const char *word)
{
    const size_t n = strlen(word);

    for (char *at = text; at != NULL; at = strchr(at, '\n')) {
        at += *at == '\n';
        at += strspn(at, " \t");
        if (strncmp(at, word, n) == 0 && !isalpha((unsigned char)at[n]))
            return at;
    }
    return NULL;
}

/* A data file counts its atoms before their section; what its first line says
 * is of no interest. */
static int is_data(char *text, long *n)
{
    const char *const end = grain_table_line_of(text, "Atoms");

    for (const char *at = text; at != NULL && at < end; at = strchr(at, '\n')) {
        at += *at == '\n';
        if (counts_atoms(at, n)) return 1;
    }
    return 0;
}

/* Takes the blanks before each line of a data file, and the remarks but for
 * that on the style of the atoms. */
static void tidy(char *text)
{
    char *to = text;

    for (const char *at = text; *at != '\0'; at += *at == '\n') {
        at += strspn(at, " \t\r");
        const size_t n = strcspn(at, strncmp(at, "Atoms", 5) ? "#\n" : "\n");
        memmove(to, at, n);
        to += n;
        at += strcspn(at, "\n");
        if (*at == '\n') *to++ = '\n';
    }
    *to = '\0';
}

static int words_of_line(const char *at)
{
    int n = 0;

    for (; *at != '\0' && *at != '\n'; n++) {
        at += strcspn(at, " \t\r\n");
        at += strspn(at, " \t\r");
    }
    return n;
}

/* The section "Atoms" of a data file as a table with names; its style is
 * sphere: the row has 7 numbers, or 10 with those of the periods. NULL after
 * filling `wrong`. */
static char *atoms_of(char *text, char wrong[CSV_WRONG])
{
    static const char *const names = "id type diameter density x y z",
                             *const periods = " ix iy iz";
    char style[32] = "", *rows = grain_table_line_of(text, "Atoms"),
         *end = rows;

    sscanf(rows, "Atoms # %31s", style);
    rows = strchr(rows, '\n');
    while (rows != NULL && isspace((unsigned char)*rows))
        rows++;
    const int n = rows == NULL ? 0 : words_of_line(rows);
    if (n < 7 || (style[0] != '\0' && strcmp(style, "sphere") != 0)) {
        snprintf(wrong, CSV_WRONG,
                 "expected atoms of the style sphere (id type diameter density "
                 "x y z), found %s%s",
                 style[0] != '\0' ? "the style " : "fewer numbers in a row",
                 style);
        return NULL;
    }
    for (end = rows; *end != '\0' && !isalpha((unsigned char)*end);)
        end += strcspn(end, "\n") + (strchr(end, '\n') != NULL);
    *end = '\0';
    char *const table = alloc_zeroed(strlen(rows) + 64, 1);
    sprintf(table, "%s%s\n%s", names, n == 10 ? periods : "", rows);
    return table;
}

/* Of a dump the names and rows of its last snapshot, and how many it counts;
 * else the text itself. */
static char *table_of(char *text, long *n)
{
    static const char count[] = "ITEM: NUMBER OF ATOMS";
    char *found = NULL, *end;

    for (char *at = text; (at = strstr(at, atoms)) != NULL; at += sizeof atoms)
        found = at;
    if (found == NULL) return text;
    for (const char *at = text; (at = strstr(at, count)) != NULL && at < found;)
        *n = strtol(at += sizeof count - 1, NULL, 10);
    found += sizeof atoms - 1;
    if ((end = strstr(found, "ITEM:")) != NULL) *end = '\0';
    return found;
}

/* The columns of x, y, z, or of a dump xu, yu, zu, which go on across periods;
 * that of the size, and what makes it a diameter. Non-zero if one is missing.
 */
static int grain_table_find_columns(const struct csv *t, int column[4],
                                    double *factor)
{
    static const char *const sizes[] = {"d", "diameter", "radius", "r"};
    static const char *const axes[] = {"x", "y", "z", "xu", "yu", "zu"};

    for (int k = 0; k < 3; k++) {
        column[k] = csv_column(t, axes[k]);
        if (column[k] < 0) column[k] = csv_column(t, axes[3 + k]);
    }
    column[3] = -1;
    for (int k = 0; k < 4 && column[3] < 0; k++) {
        column[3] = csv_column(t, sizes[k]);
        *factor = k < 2 ? 1.0 : 2.0;
    }
    return column[0] < 0 || column[1] < 0 || column[2] < 0 || column[3] < 0;
}

static struct insertion_sphere *spheres_of(const struct csv *t,
                                           char wrong[CSV_WRONG])
{
    char names[100];
    double factor;
    int column[4];

    if (grain_table_find_columns(t, column, &factor) != 0) {
        csv_names(t, names, sizeof names);
        snprintf(wrong, CSV_WRONG,
                 "expected columns x, y, z and d, diameter or radius [m]; its "
                 "columns are: %s",
                 names);
        return NULL;
    }
    for (int k = 0; k < 4; k++)
        if (csv_check_unit(t, column[k], "m", wrong) != 0) return NULL;
    struct insertion_sphere *const list =
        alloc_zeroed((size_t)t->n_rows, sizeof *list);
    for (int i = 0; i < t->n_rows; i++) {
        const double *const row = &t->value[(long)i * t->n_columns];
        int good = 1;
        for (int k = 0; k < 3; k++) {
            list[i].x[k] = row[column[k]];
            good &= number_is_coordinate(list[i].x[k]);
        }
        list[i].d = factor * row[column[3]];
        if (good && number_is_length(list[i].d)) continue;
        snprintf(wrong, CSV_WRONG,
                 "row %d is not a sphere: expected a place within 1e12 m and "
                 "a diameter of 1e-12 to 1e12 m",
                 i + 1);
        free(list);
        return NULL;
    }
    return list;
}

/* Dumps and data files may name the units of their numbers. */
static int grain_table_is_foreign(const char *text, char wrong[CSV_WRONG])
{
    static const char *const heads[] = {"ITEM: UNITS", "units = "};
    char unit[32] = "si";

    for (int i = 0; i < 2; i++) {
        const char *const at = strstr(text, heads[i]);
        if (at != NULL) sscanf(at + strlen(heads[i]), " %31[a-z]", unit);
    }
    if (strcmp(unit, "si") == 0) return 0;
    snprintf(wrong, CSV_WRONG, "its units are %s; expected si", unit);
    return 1;
}

/* The rows of a text, as many as it counts. */
static struct insertion_sphere *grain_table_rows(char **text, long *n,
                                                 char wrong[CSV_WRONG])
{
    long counted = -1;
    struct insertion_sphere *list = NULL;
    struct csv t;

    if (grain_table_is_foreign(*text, wrong)) return NULL;
    if (is_data(*text, &counted)) {
        tidy(*text);
        char *const table = atoms_of(*text, wrong);
        free(*text);
        *text = table;
    }
    if (*text == NULL ||
        csv_parse(&t, table_of(*text, &counted), "x y z d", wrong) != 0)
        return NULL;
    if (counted < 0 || counted == t.n_rows)
        list = spheres_of(&t, wrong);
    else
        snprintf(wrong, CSV_WRONG, "it counts %ld atoms, but has %d", counted,
                 t.n_rows);
    *n = list != NULL ? t.n_rows : 0;
    csv_release(&t);
    return list;
}

struct insertion_sphere *grain_table_parse(const struct input *in, long *n)
{
    char wrong[CSV_WRONG];
    char *text = in->text != NULL ? strdup(in->text) : NULL; /* is changed */

    *n = 0;
    snprintf(wrong, sizeof wrong, "%s", in->why != NULL ? in->why : "");
    struct insertion_sphere *const list =
        text != NULL ? grain_table_rows(&text, n, wrong) : NULL;
    free(text);
    if (list == NULL) input_refuse(in, 0, "%s", wrong);
    return list;
}
